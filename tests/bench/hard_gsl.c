/* hard_gsl.c - GSL's integrators on the hard cases.
   SPDX-License-Identifier: GPL-3.0-or-later */
#include "hard_peers.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#include <math.h>
#include <string.h>

/* By differences, for the implicit ones, as a user would who has none. */
static int jacobian(double t, const double x[], double *J, double dt[], void *run) {
  const struct motion *m = ((struct peer_run *)run)->m;
  const double w = fmax(fabs(m->w[0]), fmax(fabs(m->w[1]), fabs(m->w[2])));
  double y[NX], a[NX], b[NX];
  if (hard_rates(t, x, a, run) != 0)
    return GSL_EBADFUNC;
  memcpy(y, x, sizeof y);
  memset(dt, 0, sizeof y);
  for (int j = 0; j < NX; j++) {
    const double e = 1e-8 * fmax(fabs(x[j]), j < 4 || !(w > 0) ? 1 : w);
    y[j] = x[j] + e;
    if (hard_rates(t, y, b, run) != 0)
      return GSL_EBADFUNC;
    for (int i = 0; i < NX; i++)
      J[i * NX + j] = (b[i] - a[i]) / e;
    y[j] = x[j];
  }
  return GSL_SUCCESS;
}

static int rates(double t, const double x[], double dx[], void *run) {
  return hard_rates(t, x, dx, run) != 0 ? GSL_EBADFUNC : GSL_SUCCESS;
}

static int go(const struct peer *self, struct peer_run *r, double x[NX]) {
  const gsl_odeiv2_step_type *type = *(const gsl_odeiv2_step_type *const *)self->kind;
  gsl_odeiv2_system system = {rates, jacobian, NX, r};
  double scale[NX] = {1, 1, 1, 1, 0, 0, 0}, dx[NX], w = 0, speed = 0, t = 0;
  gsl_set_error_handler_off();
  hard_rates(0, x, dx, r);
  for (int i = 4; i < NX; i++)
    w = fmax(w, fabs(x[i]));
  for (int i = 0; i < NX; i++)
    speed = fmax(speed, fabs(dx[i]) / (i < 4 ? 1 : w > 0 ? w : 1));
  for (int i = 4; i < NX; i++)
    scale[i] = w > 0 ? w : 1;
  const double h = speed > 0 ? fmin(1e-3 / speed, r->m->t) : r->m->t / 1000;
  gsl_odeiv2_driver *d =
      gsl_odeiv2_driver_alloc_scaled_new(&system, type, h, 1e-12, 1e-12, 1, 0, scale);
  if (d == NULL)
    return 1;
  const int status = gsl_odeiv2_driver_apply(d, &t, r->m->t, x);
  gsl_odeiv2_driver_free(d);
  return r->calls > BUDGET ? 2 : status != GSL_SUCCESS;
}

const struct peer hard_gsl[] = {{"GSL rk4", go, &gsl_odeiv2_step_rk4},
                                {"GSL rkf45", go, &gsl_odeiv2_step_rkf45},
                                {"GSL rk8pd", go, &gsl_odeiv2_step_rk8pd},
                                {"GSL rk4imp", go, &gsl_odeiv2_step_rk4imp},
                                {"GSL msadams", go, &gsl_odeiv2_step_msadams},
                                {"GSL msbdf", go, &gsl_odeiv2_step_msbdf},
                                {NULL, NULL, NULL}};
