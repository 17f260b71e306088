/* plane.c - bodies that roll and slide on a plane: the library against tables of 32 digits.
   SPDX-License-Identifier: GPL-3.0-or-later

   The tables were computed by another way than the library's, by the equations of plane.md with
   the reaction eliminated, in 192 bits (reference/README.md). The library solves for the contact
   force. Tolerances: half an ulp of the result, 2e-15 for the steps that a motion of some hundred
   rounds takes in 64 bits, and what the inputs' own rounding moves. */
#include <math.h>
#include <string.h>

#include "polhode.h"
#include "reference/plane.h"
#include "tap.h"

static double distance(int n, const double a[], const long double b[]) {
  double d = 0;
  for (int i = 0; i < n; i++)
    d = fmax(d, (double)fabsl((long double)a[i] - b[i]));
  return d;
}

static double size(const long double v[3]) {
  return (double)sqrtl(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

static void row(size_t r) {
  const double zero[3] = {0, 0, 0};
  const ph_options options = ph_options_default();
  const double t = plane_rows[r].t, damping = plane_rows[r].damping;
  double x0[11], x[11] = {0};
  ph_top top;
  ph_run *run = NULL;
  ph_contact c = {0};
  memcpy(x0, plane_rows[r].q, sizeof(double[4]));
  memcpy(x0 + 4, plane_rows[r].w, sizeof(double[3]));
  int status = ph_top_init_tensor(&top, plane_rows[r].mass, zero, plane_rows[r].inertia);
  if (!status)
    status = ph_top_plane(&top, &plane_rows[r].plane);
  if (!status && damping > 0)
    status = ph_top_damping(&top, (const double[9]){damping, 0, 0, 0, damping, 0, 0, 0, damping});
  /* coordinates along e1 and e2 of what is given in inertial axes */
  const double *n = plane_rows[r].plane.normal;
  const double l = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]), k = hypot(n[1], n[2]) / l;
  const double e1[3] = {k, -n[0] * n[1] / (l * l * k), -n[0] * n[2] / (l * l * k)};
  const double e2[3] = {0, n[2] / (l * k), -n[1] / (l * k)};
  const double *com = plane_rows[r].com, *v = plane_rows[r].v;
  for (int i = 0; i < 4; i++) {
    const double *e = i % 2 ? e2 : e1, *from = i < 2 ? com : v;
    x0[7 + i] = e[0] * from[0] + e[1] * from[1] + e[2] * from[2];
  }
  if (!status)
    status = ph_run_new(&run, &top, &options, 0, x0);
  if (!status)
    status = ph_run_to(run, t, NULL, x);
  if (!status)
    status = ph_top_contact(&top, t, x, NULL, &c);
  ph_run_free(run);
  const char *id = plane_rows[r].id;
  if (!ok(status == PH_OK, "%s: runs to %g s (%s)", id, t, ph_status_phrase(status)))
    return;
  const double sign = x[0] * (double)plane_rows[r].at_q[0] + x[1] * (double)plane_rows[r].at_q[1] +
                      x[2] * (double)plane_rows[r].at_q[2] + x[3] * (double)plane_rows[r].at_q[3];
  for (int i = 0; i < 4 && sign < 0; i++)
    x[i] = -x[i];
  const double w = size(plane_rows[r].at_w), N = (double)fabsl(plane_rows[r].N);
  near(distance(4, x, plane_rows[r].at_q), 0, 2e-15 + 20 * plane_rows[r].q_sensitivity,
       "%s: attitude after %g s", id, t);
  near(distance(3, x + 4, plane_rows[r].at_w), 0, w * (2e-15 + 20 * plane_rows[r].w_sensitivity),
       "%s: rates", id);
  near(distance(3, c.com, plane_rows[r].at_com), 0, 2e-15 + 20 * plane_rows[r].com_sensitivity,
       "%s: centre of mass", id);
  near(distance(3, c.velocity, plane_rows[r].at_v), 0, 4e-15 + 20 * plane_rows[r].v_sensitivity,
       "%s: its velocity", id);
  near(c.reaction, (double)plane_rows[r].N, N * (4e-15 + 20 * plane_rows[r].N_sensitivity),
       "%s: the reaction", id);
}

int main(void) {
  for (size_t r = 0; r < sizeof plane_rows / sizeof plane_rows[0]; r++)
    row(r);
  return tap_done();
}
