/* step.c - what one RK4 step of the free asymmetric top costs: emitted, hand-written, GSL; and one
 * evaluation of the symmetric top's closed form. SPDX-License-Identifier: GPL-3.0-or-later
 *
 * All in one run, in turn, so that a change of the machine's speed meets all of them; medians of
 * REPEATS rounds. The results are compared too: a fast wrong step is worth nothing.
 */
#include "clock.h"
#include "brick_centroid.h"
#include "hand.h"
#include "symmetric_top.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { REPEATS = 21, STEPS = 200000, STATES = 7 };

static const double h = 1e-4; /* s; 20 s in all at 6 rad/s */

static brick_centroid_model brick;
static symmetric_top_orbit orbit;
static double moments[3], quotients[3];
static gsl_odeiv2_step *gsl_step;
static gsl_odeiv2_system gsl_system;
static volatile double sink;

static int gsl_rhs(double t, const double x[], double dx[], void *model) {
  brick_centroid_rhs(model, t, x, NULL, dx);
  return GSL_SUCCESS;
}

static void run_emitted(double x[]) {
  for (int i = 0; i < STEPS; i++)
    brick_centroid_step(&brick, 0, x, NULL, h);
}

static void run_moments(double x[]) {
  for (int i = 0; i < STEPS; i++)
    hand_rk4_moments(moments, x, h);
}

static void run_quotients(double x[]) {
  for (int i = 0; i < STEPS; i++)
    hand_rk4_quotients(quotients, x, h);
}

static void run_gsl(double x[]) {
  double error[STATES];
  for (int i = 0; i < STEPS; i++)
    gsl_odeiv2_step_apply(gsl_step, h * i, h, x, error, NULL, NULL, &gsl_system);
}

static void run_closed(double x[]) {
  double sum = 0;
  for (int i = 0; i < STEPS; i++) {
    symmetric_top_at(&orbit, h * i, x);
    sum += x[0];
  }
  sink = sum;
}

static const struct {
  const char *name;
  void (*run)(double x[]);
} rows[] = {
    {"emitted RK4 step", run_emitted},
    {"hand-written RK4, moments in the right-hand side", run_moments},
    {"hand-written RK4, quotients formed outside", run_quotients},
    {"GSL odeiv2 rk4, emitted right-hand side", run_gsl},
    {"emitted closed form of the symmetric top, any t", run_closed},
};
enum { ROWS = sizeof rows / sizeof rows[0] };

int main(void) {
  static double time[ROWS][REPEATS];
  double end[ROWS][STATES], x0[STATES], I[6], middle[ROWS];
  symmetric_top_model top;
  double top0[STATES];

  if (brick_centroid_init(&brick, NULL) != 0 || symmetric_top_init(&top, NULL) != 0)
    return 1;
  brick_centroid_initial(&brick, x0);
  brick_centroid_inertia(&brick, I);
  for (int i = 0; i < 3; i++) {
    moments[i] = I[i];
    quotients[i] = (I[(i + 1) % 3] - I[(i + 2) % 3]) / I[i];
  }
  symmetric_top_initial(&top, top0);
  if (symmetric_top_solve(&orbit, &top, top0) != 0)
    return 1;
  gsl_system = (gsl_odeiv2_system){gsl_rhs, NULL, STATES, &brick};
  gsl_step = gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk4, STATES);
  if (gsl_step == NULL)
    return 1;
  for (int k = -1; k < REPEATS; k++) { /* round -1 warms up */
    for (int r = 0; r < ROWS; r++) {
      memcpy(end[r], x0, sizeof x0);
      const double start = now();
      rows[r].run(end[r]);
      if (k >= 0)
        time[r][k] = (now() - start) / STEPS * 1e9;
    }
  }
  printf("one step of (q, w), free asymmetric top, h = %g s, %d steps, median of %d rounds\n", h,
         (int)STEPS, (int)REPEATS);
  printf("  %-52s %8s %8s %8s %8s\n", "", "ns", "fastest", "slowest", "ratio");
  for (int r = 0; r < ROWS; r++) {
    qsort(time[r], REPEATS, sizeof time[r][0], ascending);
    middle[r] = time[r][REPEATS / 2];
    printf("  %-52s %8.1f %8.1f %8.1f %8.2f\n", rows[r].name, middle[r], time[r][0],
           time[r][REPEATS - 1], middle[r] / middle[0]);
  }
  double worst = 0;
  for (int r = 1; r < 4; r++)
    for (int i = 0; i < STATES; i++)
      worst = fmax(worst, fabs(end[r][i] - end[0][i]));
  printf("  largest difference between the four end states after %g s: %.2g\n", h * STEPS, worst);
  gsl_odeiv2_step_free(gsl_step);
  return 0;
}
