/* top.c - what the closed form of the free top costs: every function of it, and the state of the
 * tumbling box after 100 s against integrators that reach it as accurately.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * tumbling_box is compiled as its Makefile does, tumbling_host is the same scene for this machine.
 * Rows run in turn, so that a change of the machine's speed meets all of them; medians of REPEATS
 * rounds. Integrators are given the settings that are best with hindsight: the cheapest whose
 * largest error at ENDS times in the last tenth is below BOUND.
 */
#include "clock.h"
#include "hand.h"
#include "polhode_exact.h"
#include "tumbling_box.h"
#include "tumbling_host.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { REPEATS = 21, TIMES = 4032, BATCH = 504, STATES = 7, ENDS = 40 };

static const double BOUND = 1e-11, HORIZON = 100;

static tumbling_box_model box;
static tumbling_box_orbit circular, hyperbolic;
static tumbling_host_orbit host_circular, host_hyperbolic;
static double quotients[3], x0[STATES], times[TIMES], out[STATES * BATCH];
static volatile double sink;

/* ---- one evaluation ---- */

static void run_hand(void) {
  double x[STATES];
  memcpy(x, x0, sizeof x);
  for (int i = 0; i < TIMES; i++)
    hand_rk4_quotients(quotients, x, 1e-4);
  sink = x[0];
}

/* A loop over all times with one call; it must not be left out. */
#define RUN(NAME, CALL)                                                                            \
  static void NAME(void) {                                                                         \
    double x[STATES] = {0}, sum = 0;                                                               \
    for (int i = 0; i < TIMES; i++) {                                                              \
      CALL;                                                                                        \
      sum += x[0];                                                                                 \
    }                                                                                              \
    sink = sum;                                                                                    \
  }
#define MANY(NAME, CALL)                                                                           \
  static void NAME(void) {                                                                         \
    for (int i = 0; i < TIMES; i += BATCH) {                                                       \
      CALL;                                                                                        \
      sink = out[0];                                                                               \
    }                                                                                              \
  }
RUN(circular_at, tumbling_box_at(&circular, times[i], x))
RUN(circular_rates, tumbling_box_at_rates(&circular, times[i], x))
RUN(circular_attitude, tumbling_box_at_attitude(&circular, times[i], x))
RUN(circular_tick, tumbling_box_at_tick(&circular, i, x))
MANY(circular_many, tumbling_box_at_many(&circular, BATCH, times + i, out))
RUN(hyperbolic_at, tumbling_box_at(&hyperbolic, times[i], x))
RUN(hyperbolic_rates, tumbling_box_at_rates(&hyperbolic, times[i], x))
RUN(hyperbolic_attitude, tumbling_box_at_attitude(&hyperbolic, times[i], x))
RUN(hyperbolic_tick, tumbling_box_at_tick(&hyperbolic, i, x))
MANY(hyperbolic_many, tumbling_box_at_many(&hyperbolic, BATCH, times + i, out))
RUN(host_circular_at, tumbling_host_at(&host_circular, times[i], x))
MANY(host_circular_many, tumbling_host_at_many(&host_circular, BATCH, times + i, out))
RUN(host_hyperbolic_at, tumbling_host_at(&host_hyperbolic, times[i], x))
MANY(host_hyperbolic_many, tumbling_host_at_many(&host_hyperbolic, BATCH, times + i, out))

static void run_solve(void) {
  tumbling_box_orbit o;
  for (int i = 0; i < TIMES; i++) {
    tumbling_box_solve(&o, &box, x0);
    sink = o.rate[0];
  }
}

static void run_whole(void) {
  tumbling_box_orbit o;
  double x[STATES];
  for (int i = 0; i < TIMES; i++) {
    tumbling_box_solve(&o, &box, x0);
    tumbling_box_at(&o, HORIZON, x);
    sink = x[0];
  }
}

enum { HAND = 0, WHOLE = 16 };
static const struct {
  const char *name;
  void (*run)(void);
} rows[] = {
    {"hand-written RK4 step, quotients formed outside", run_hand},
    {"at, circular functions", circular_at},
    {"at, hyperbolic functions", hyperbolic_at},
    {"at_rates, circular", circular_rates},
    {"at_rates, hyperbolic", hyperbolic_rates},
    {"at_attitude, circular", circular_attitude},
    {"at_attitude, hyperbolic", hyperbolic_attitude},
    {"at_tick, circular", circular_tick},
    {"at_tick, hyperbolic", hyperbolic_tick},
    {"at_many, circular, a state", circular_many},
    {"at_many, hyperbolic, a state", hyperbolic_many},
    {"at, circular, for this machine", host_circular_at},
    {"at, hyperbolic, for this machine", host_hyperbolic_at},
    {"at_many, circular, for this machine, a state", host_circular_many},
    {"at_many, hyperbolic, for this machine, a state", host_hyperbolic_many},
    {"solve", run_solve},
    {"solve and at", run_whole},
};
enum { ROWS = sizeof rows / sizeof rows[0] };

/* Median times of all rows, ns. */
static void measure(double middle[ROWS]) {
  static double time[ROWS][REPEATS];
  for (int k = -1; k < REPEATS; k++) { /* round -1 warms up */
    for (int r = 0; r < ROWS; r++) {
      const double start = now();
      rows[r].run();
      if (k >= 0)
        time[r][k] = (now() - start) / TIMES * 1e9;
    }
  }
  printf("the free asymmetric top, tumbling_box, %d times, median of %d rounds\n", (int)TIMES,
         (int)REPEATS);
  printf("  %-52s %8s %8s %8s %8s\n", "", "ns", "fastest", "slowest", "ratio");
  for (int r = 0; r < ROWS; r++) {
    qsort(time[r], REPEATS, sizeof time[r][0], ascending);
    middle[r] = time[r][REPEATS / 2];
    printf("  %-52s %8.1f %8.1f %8.1f %8.2f\n", rows[r].name, middle[r], time[r][0],
           time[r][REPEATS - 1], middle[r] / middle[HAND]);
  }
}

/* ---- the state after 100 s ---- */

static double truth[ENDS][STATES];

static double end_time(int k) {
  return HORIZON * (0.9 + 0.1 * (k + 1) / ENDS);
}

/* The larger of |difference of q|, either sign, and |difference of w| over |w|. */
static double error_of(const double x[], const double y[]) {
  double plus = 0, minus = 0, rates = 0, size = 0;
  for (int i = 0; i < 4; i++) {
    plus += (x[i] + y[i]) * (x[i] + y[i]);
    minus += (x[i] - y[i]) * (x[i] - y[i]);
  }
  for (int i = 4; i < STATES; i++) {
    rates += (x[i] - y[i]) * (x[i] - y[i]);
    size += y[i] * y[i];
  }
  return sqrt(fmax(fmin(plus, minus), rates / size));
}

static int gsl_rhs(double t, const double x[], double dx[], void *model) {
  tumbling_box_rhs(model, t, x, NULL, dx);
  return GSL_SUCCESS;
}

typedef enum { RK4_STEPS, GSL_STEPS, GSL_TOLERANCE } method;
static const char *const method_name[] = {"emitted RK4", "GSL rk8pd, fixed steps",
                                          "GSL rk8pd, adaptive"};

/* From 0 to t[0], t[1], ..: all in one run, settings = steps in the horizon or a tolerance. */
static void integrate(method m, double setting, const double t[], int count, double x[][STATES]) {
  const gsl_odeiv2_system system = {gsl_rhs, NULL, STATES, &box};
  gsl_odeiv2_driver *driver = NULL;
  double y[STATES], from = 0;
  int step = 0;
  if (m != RK4_STEPS)
    driver = gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, 1e-3,
                                           m == GSL_TOLERANCE ? setting : 1,
                                           m == GSL_TOLERANCE ? setting : 1);
  memcpy(y, x0, sizeof y);
  for (int k = 0; k < count; k++) {
    const int until = m == GSL_TOLERANCE ? 0 : (int)lround(setting * t[k] / HORIZON);
    const double h = m == GSL_TOLERANCE ? 0 : HORIZON / setting;
    if (m == RK4_STEPS)
      for (; step < until; step++)
        tumbling_box_step(&box, 0, y, NULL, h);
    if (m == GSL_STEPS && until > step)
      gsl_odeiv2_driver_apply_fixed_step(driver, &from, h, (unsigned long)(until - step), y);
    if (m == GSL_TOLERANCE)
      gsl_odeiv2_driver_apply(driver, &from, t[k], y);
    step = until;
    memcpy(x[k], y, sizeof y);
  }
  if (driver != NULL)
    gsl_odeiv2_driver_free(driver);
}

static double worst_error(method m, double setting) {
  static double x[ENDS][STATES];
  double t[ENDS], worst = 0;
  for (int k = 0; k < ENDS; k++)
    t[k] = end_time(k);
  integrate(m, setting, t, ENDS, x);
  for (int k = 0; k < ENDS; k++)
    worst = fmax(worst, error_of(x[k], truth[k]));
  return worst;
}

/* One integration to the horizon, s: the fastest of some. */
static double cost(method m, double setting) {
  double best = HUGE_VAL, x[1][STATES];
  for (int k = 0; k < 7; k++) {
    const double start = now();
    integrate(m, setting, &HORIZON, 1, x);
    best = fmin(best, now() - start);
    sink = x[0][0];
  }
  return best;
}

/* Looks for the cheapest setting; the time, s, or infinity if none is accurate enough. */
static double cheapest(method m) {
  double setting = 0, least = HUGE_VAL, found = 0, error = HUGE_VAL, best = HUGE_VAL;
  for (int k = 0; k < (m == GSL_TOLERANCE ? 30 : 36); k++) {
    /* steps are multiples of 400, so that every end time is one of theirs */
    setting = m == GSL_TOLERANCE ? pow(10, -8 - 0.25 * k)
                                 : 400 * floor((m == RK4_STEPS ? 100 : 5) * pow(2, 0.25 * k));
    const double e = worst_error(m, setting);
    best = fmin(best, e);
    if (e > BOUND)
      continue;
    const double s = cost(m, setting);
    if (s < least) {
      least = s;
      found = setting;
      error = e;
    }
    if (m != GSL_TOLERANCE)
      break; /* more steps cost more */
  }
  if (least < HUGE_VAL)
    printf("  %-52s %8.0f   error %.1e, %s %.3g\n", method_name[m], least * 1e6, error,
           m == GSL_TOLERANCE ? "tolerance" : "steps", found);
  else
    printf("  %-52s %8s   best error %.1e\n", method_name[m], "-", best);
  return least;
}

int main(void) {
  double middle[ROWS], I[6], w0[STATES], least = HUGE_VAL, worst = 0;
  tumbling_box_orbit tumble;
  tumbling_host_model host;
  ph_free_top exact;
  ph_top top;
  if (tumbling_box_init(&box, NULL) != 0 || tumbling_host_init(&host, NULL) != 0)
    return 1;
  tumbling_box_initial(&box, x0);
  tumbling_box_inertia(&box, I);
  for (int i = 0; i < 3; i++)
    quotients[i] = (I[(i + 1) % 3] - I[(i + 2) % 3]) / I[i];
  for (int i = 0; i < TIMES; i++)
    times[i] = HORIZON * (i + 0.5) / TIMES;
  memcpy(w0, x0, sizeof w0);
  w0[4] = 3, w0[5] = 2, w0[6] = 6;
  int bad =
      tumbling_box_solve(&circular, &box, w0) || tumbling_host_solve(&host_circular, &host, w0);
  w0[4] = 0.1, w0[5] = 7, w0[6] = 0.1;
  bad = bad || tumbling_box_solve(&hyperbolic, &box, w0) ||
        tumbling_host_solve(&host_hyperbolic, &host, w0) ||
        tumbling_box_set_tick(&circular, 0.025) || tumbling_box_set_tick(&hyperbolic, 0.025) ||
        tumbling_box_solve(&tumble, &box, x0) || ph_top_init_tensor(&top, 1, NULL, I) ||
        ph_free_top_solve(&exact, &top, x0);
  if (bad || circular.hyperbolic || !hyperbolic.hyperbolic)
    return 1;
  measure(middle);
  for (int k = 0; k < ENDS; k++) {
    double x[STATES];
    if (ph_free_top_at(&exact, end_time(k), truth[k]) != 0)
      return 1;
    tumbling_box_at(&tumble, end_time(k), x);
    worst = fmax(worst, error_of(x, truth[k]));
  }
  printf("the state after %g s; errors: largest at %d times in the last tenth\n", HORIZON,
         (int)ENDS);
  printf("  %-52s %8s\n", "", "us");
  printf("  %-52s %8.2f   error %.1e\n", "closed form: solve and at", middle[WHOLE] * 1e-3, worst);
  for (method m = RK4_STEPS; m <= GSL_TOLERANCE; m++)
    least = fmin(least, cheapest(m));
  printf("  closed form against the cheapest of these to %g: %.0f times\n", BOUND,
         least * 1e9 / middle[WHOLE]);
  return 0;
}
