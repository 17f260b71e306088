/* step.c - one step by classical Runge-Kutta or by a method of GSL.
   SPDX-License-Identifier: GPL-3.0-or-later

   GSL works in double. Were it given the state, each step would round it, and a thousand
   revolutions would collect up to 1e-11 (8e-12 was measured for rk8pd in 131369 steps, and 1e-12
   this way). So it is given the INCREMENT z of the step, z(0) = 0, z' = f(x0 + z) with x0 in long
   double: z is rounded relative to itself, and x0 + z is added in long double. That is compensated
   summation without a second variable. Time is given in units of the step, z' = h f on [0, 1], so
   that h too keeps its long double. gsl_odeiv2_step_apply never calls GSL's error handler (only its
   allocation would, when memory is out). */
#include <gsl/gsl_errno.h>

#include "acts/acts.h"
#include "motion/move.h"
#include "step.h"

int step_rk4(stepper *s, const ph_wide x[], ph_wide h, ph_wide out[]) {
  /* time of the stage as a part of h, and its weight in the mean */
  static const int part[4] = {0, 1, 1, 2}, weight[4] = {1, 2, 2, 1};
  ph_wide k[PH_STATES] = {0}, mean[PH_STATES] = {0}, y[PH_STATES];
  const int n = ph_top_states(s->top);
  for (int stage = 0; stage < 4; stage++) {
    for (int i = 0; i < n; i++)
      y[i] = x[i] + part[stage] * h / 2 * k[i];
    const int status = motion_rates(s->top, &s->loads, s->t + part[stage] * h / 2, y, k);
    s->evaluations++;
    if (status)
      return status;
    for (int i = 0; i < n; i++)
      mean[i] += weight[stage] * k[i] / 6;
  }
  for (int i = 0; i < n; i++)
    out[i] = x[i] + h * mean[i];
  return PH_OK;
}

/* GSL's right-hand side: z' = h f(base + z). */
static int increment_rates(double t, const double z[], double dz[], void *params) {
  stepper *s = params;
  ph_wide y[PH_STATES], dy[PH_STATES];
  const int n = ph_top_states(s->top);
  for (int i = 0; i < n; i++)
    y[i] = s->base[i] + (ph_wide)z[i];
  s->evaluations++;
  s->status = motion_rates(s->top, &s->loads, s->t + (ph_wide)t * s->h, y, dy);
  if (s->status)
    return GSL_EBADFUNC;
  for (int i = 0; i < n; i++)
    dz[i] = (double)(s->h * dy[i]);
  return GSL_SUCCESS;
}

int step_gsl(stepper *s, const ph_wide x[], ph_wide h, ph_wide out[], ph_wide *error) {
  const int n = ph_top_states(s->top);
  gsl_odeiv2_system system = {increment_rates, NULL, (size_t)n, s};
  double z[PH_STATES] = {0}, bound[PH_STATES];
  ph_wide wide_bound[PH_STATES];
  for (int i = 0; i < n; i++)
    s->base[i] = x[i];
  s->h = h;
  s->status = PH_OK;
  if (gsl_odeiv2_step_apply(s->gsl, 0, 1, z, bound, NULL, NULL, &system) != GSL_SUCCESS)
    return s->status ? s->status : PH_ERANGE;
  for (int i = 0; i < n; i++)
    out[i] = x[i] + (ph_wide)z[i];
  wide_load(n, bound, wide_bound);
  step_scale scale;
  ph_wide change[PH_STATES];
  wide_load(n, z, change);
  const int status = step_scale_at(s, x, &scale);
  if (status)
    return status;
  *error = step_relative(s->top, &scale, x, change, h, wide_bound);
  return wide_fits(n, out) && wide_fits(n, wide_bound) ? PH_OK : PH_ERANGE;
}

int step_rate(stepper *s, const ph_wide x[], ph_wide *rate) {
  ph_wide dx[PH_STATES];
  const int status = motion_rates(s->top, &s->loads, s->t, x, dx);
  s->evaluations++;
  if (!status)
    *rate = move_rate(s->top, s->t, x) + fmaxl(step_size(3, x + 4), sqrtl(step_size(3, dx + 4)));
  return status;
}
