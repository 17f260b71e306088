/* known.c - runs at the tightest setting against tables of free and forced tops, and NASA's check
   case 2. SPDX-License-Identifier: GPL-3.0-or-later

   The tables have 32 digits (reference/README.md). What a solver with a 64-bit mantissa can reach
   depends on the motion: tolerances are half an ulp of the result and a small part of the
   sensitivity, which the table states or which is measured here by moving the input. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "polhode.h"
#include "reference/forced_top.h"
#include "reference/free_top.h"
#include "reference/nesc_case2.h"
#include "tap.h"

#define COUNT(table) (sizeof(table) / sizeof(table)[0])

static const double PI = 3.141592653589793;

static double distance(int n, const double a[], const double b[]) {
  double d = 0;
  for (int i = 0; i < n; i++)
    d = fmax(d, fabs(a[i] - b[i]));
  return d;
}

static void free_tops(void) {
  double worst = 0, worst_sensitive = 0;
  for (size_t r = 0; r < FREE_TOP_NEAR; r++) {
    const char *id = free_top_rows[r].id;
    const ph_options options = ph_options_default();
    double x0[7], x[7] = {0};
    ph_top top;
    ph_run *run = NULL;
    memcpy(x0, free_top_rows[r].q0, sizeof(double[4]));
    memcpy(x0 + 4, free_top_rows[r].w0, sizeof(double[3]));
    const double t = free_top_rows[r].t;
    const int s = ph_top_init_tensor(&top, 1, NULL, free_top_rows[r].tensor) ||
                  ph_run_new(&run, &top, &options, 0, x0) || ph_run_to(run, t, NULL, x);
    const long double *w = free_top_rows[r].w;
    const long double size = sqrtl(w[0] * w[0] + w[1] * w[1] + w[2] * w[2]);
    /* The result is rounded to double (1.1e-16). Inside, up to 20000 steps round by 2^-64,
       magnified as the inputs' rounding by 2^-53 is: a twentieth of that sensitivity. Close to the
       separatrix the distance from it is itself kept only to some 2^-62, and once round the loop
       that decides when the next loop starts. */
    const int looped = free_top_rows[r].period > 0 && fabs(t) > free_top_rows[r].period / 4;
    const double loop = looped ? 0x1p-60 / fabs(free_top_rows[r].separation) : 0;
    if (loop > 1e-3) {
      skip("64 bits do not decide the side of the separatrix", "%s: rates and attitude after %g s",
           id, t);
      ph_run_free(run);
      continue;
    }
    const double w_tol = 4e-16 + 0.05 * free_top_rows[r].w_sensitivity + loop;
    const double q_tol = 4e-16 + 0.05 * free_top_rows[r].q_sensitivity + loop;
    const int good =
        near_all_wide(3, x + 4, w, w_tol * (double)size, "%s: rates after %g s", id, t) &&
        near_all_wide(4, x, free_top_rows[r].q, q_tol, "%s: attitude after %g s, sign included", id,
                      t);
    if (!good)
      diag("status %s", ph_status_phrase(s));
    for (int i = 0; i < 4; i++) {
      const double e = (double)fabsl((long double)x[i] - free_top_rows[r].q[i]);
      worst = fmax(worst, e);
      if (loop < 1e-16)
        worst_sensitive = fmax(worst_sensitive, (e - 2e-16) / free_top_rows[r].q_sensitivity);
    }
    ph_run_free(run);
  }
  diag("free tops: worst attitude error %.2g, beyond rounding %.2g of the sensitivity to an ulp of "
       "the input",
       worst, worst_sensitive);
}

static int forced_setup(size_t r, ph_top *top) {
  const double *m = forced_top_rows[r].moment, *p = forced_top_rows[r].load;
  const double I[6] = {m[0], m[1], m[2], 0, 0, 0}, C[9] = {p[0], 0, 0, 0, p[1], 0, 0, 0, p[2]};
  const double down[3] = {0, 0, -1}, g = fmax(p[0], fmax(p[1], p[2])), arm = 0x1p-4;
  double com[3];
  switch (forced_top_rows[r].model) {
  case FORCED_HEAVY: /* only m g r counts: 1 kg at 1/16 m, so that the tensor can be a body's, with
                        16 times the weight */
    for (int i = 0; i < 3; i++)
      com[i] = p[i] / g * arm;
    return ph_top_init_tensor(top, 1, com, I) || ph_top_gravity(top, g / arm, down);
  case FORCED_DAMPING:
    return ph_top_init_tensor(top, 1, NULL, I) || ph_top_damping(top, C);
  case FORCED_BODY:
    return ph_top_init_tensor(top, 1, NULL, I) || ph_top_torque_body(top, p);
  case FORCED_ROTOR:
    return ph_top_init_tensor(top, 1, NULL, I) || ph_top_rotor(top, p);
  default:
    return ph_top_init_tensor(top, 1, NULL, I) || ph_top_torque_inertial(top, p);
  }
}

static void forced_tops(void) {
  double worst = 0;
  for (size_t r = 0; r < COUNT(forced_top_rows); r++) {
    const char *id = forced_top_rows[r].id;
    const ph_options options = ph_options_default();
    const double *given = forced_top_rows[r].x0; /* w, then q */
    const double x0[7] = {given[3], given[4], given[5], given[6], given[0], given[1], given[2]};
    const long double *want = forced_top_rows[r].x;
    const long double w_size = sqrtl(want[0] * want[0] + want[1] * want[1] + want[2] * want[2]);
    double x[7] = {0}, moved[7] = {0}, x1[7];
    ph_top top;
    ph_run *run = NULL, *other = NULL;
    const double t = forced_top_rows[r].t;
    /* Sensitivity is measured: the change when the initial rates move by 2^-40, brought down to
     * 2^-64 per radian. */
    memcpy(x1, x0, sizeof x1);
    for (int i = 4; i < 7; i++)
      x1[i] += 0x1p-40 * (fabs(x0[i]) + 0x1p-4);
    const int s = forced_setup(r, &top) || ph_run_new(&run, &top, &options, 0, x0) ||
                  ph_run_to(run, t, NULL, x) || ph_run_new(&other, &top, &options, 0, x1) ||
                  ph_run_to(other, t, NULL, moved);
    const double tolerance = 4e-16 + 0x1p-18 * distance(7, x, moved);
    const int good = near_all_wide(4, x, want + 3, tolerance, "%s: attitude after %g s", id, t) &&
                     near_all_wide(3, x + 4, want, tolerance * fmax(1, (double)w_size),
                                   "%s: rates after %g s", id, t);
    if (!good)
      diag("status %s", ph_status_phrase(s));
    for (int i = 0; i < 4; i++)
      worst = fmax(worst, (double)fabsl((long double)x[i] - want[3 + i]));
    ph_run_free(run);
    ph_run_free(other);
  }
  diag("forced tops: worst attitude error %.2g", worst);
}

/* ---- NASA check case 2 ---- */

/* The brick falls without drag from rest over the equator at 30000 ft, so it drifts east of where
   it was let go: local north-east-down turns about north (x) by the polar angle of the fall, not
   quite by the Earth's turning. WGS 84 with J2; planar by symmetry. The fall takes 4.4 km of 6387,
   so steps of 0.5 s of the classical method leave 1e-15. */
static double polar_angle(double t) {
  const double mu = 3.986004418e14, J2 = 1.08262982e-3, a = 6378137, earth = 7.292115e-5,
               r0 = a + 30000 * 0.3048;
  double y[3] = {r0, 0, 0}, k[3] = {0}, mean[3], stage[3]; /* r, r', angle; r^2 angle' is kept */
  const int n = (int)(2 * t);
  for (int step = 0; step < n; step++) {
    memset(mean, 0, sizeof mean);
    for (int s = 0; s < 4; s++) {
      for (int i = 0; i < 3; i++)
        stage[i] = y[i] + (s == 0 ? 0 : s == 3 ? 0.5 : 0.25) * k[i];
      const double r = stage[0], turn = earth * (r0 / r) * (r0 / r);
      k[0] = stage[1], k[2] = turn;
      k[1] = r * turn * turn - mu / (r * r) * (1 + 1.5 * J2 * (a / r) * (a / r));
      for (int i = 0; i < 3; i++)
        mean[i] += (s == 0 || s == 3 ? 1 : 2) * k[i] / 12;
    }
    for (int i = 0; i < 3; i++)
      y[i] += mean[i];
  }
  return y[2];
}

static void nasa_brick(void) {
  /* slug ft2; only ratios count. Rates with respect to inertial space. */
  const double I[6] = {0.001894220, 0.006211019, 0.007194665, 0, 0, 0}, degree = PI / 180;
  const ph_options options = ph_options_default();
  const double x0[7] = {1, 0, 0, 0, 10 * degree, 20 * degree, 30 * degree};
  ph_top top;
  ph_run *run = NULL;
  double worst_rate = 0, worst_angle = 0, x[7];
  int s = ph_top_init_tensor(&top, 0.155404754, NULL, I) || ph_run_new(&run, &top, &options, 0, x0);
  for (size_t r = 0; r < COUNT(nesc_rows); r++) {
    double local[4], relative[4], ypr[3];
    s = s || ph_run_to(run, nesc_rows[r].t, NULL, x);
    ph_quat_from_axis((const double[]){1, 0, 0}, -polar_angle(nesc_rows[r].t),
                      local); /* inertial -> NED */
    ph_quat_multiply(local, x, relative);
    s = s || ph_quat_to_ypr(relative, ypr);
    for (int i = 0; i < 3 && !s; i++) {
      worst_rate = fmax(worst_rate, fabs(x[4 + i] / degree - nesc_rows[r].rate[i]));
      worst_angle =
          fmax(worst_angle, fabs(remainder(ypr[i] / degree - nesc_rows[r].angle[i], 360)));
    }
  }
  ph_run_free(run);
  ok(s == 0, "the NASA brick turns for 30 s");
  /* simulator 04's own distance from the exact solution is 4e-10 deg/s and 6e-9 deg */
  near(worst_rate, 0, 5e-10, "NASA check case 2: body rates, deg/s");
  near(worst_angle, 0, 1e-8, "NASA check case 2: yaw, pitch, roll, deg");
  diag("NASA check case 2: rates within %.2g deg/s, angles within %.2g deg", worst_rate,
       worst_angle);
}

int main(void) {
  free_tops();
  forced_tops();
  nasa_brick();
  return tap_done();
}
