/* taylor.c - what accuracy costs in time: emitted steppers and GSL's on the two scenes with peers'
 * numbers. SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Error: the largest at ENDS times spread over the last tenth of the horizon, of the attitude and
 * of w over |w|, against the library: its exact free top, its Taylor series in long double at
 * 1e-18. Time: from the start to the horizon, processor time, the least of REPEATS. Every method
 * gets the setting that is best with hindsight. GSL calls the emitted right-hand side.
 * "for this machine" is the vector text (NAME_VECTOR) with the machine's own instructions.
 */
#include "box12.h"
#include "box12_host.h"
#include "box16.h"
#include "box16_host.h"
#include "box20.h"
#include "box20_host.h"
#include "box24.h"
#include "box24_host.h"
#include "polhode.h"
#include "top12.h"
#include "top12_host.h"
#include "top16.h"
#include "top16_host.h"
#include "top20.h"
#include "top20_host.h"
#include "top24.h"
#include "top24_host.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

enum { ENDS = 40, STATES = 7, REPEATS = 9, LEVELS = 4, MOST_STEPS = 4000000 };

static const double level[LEVELS] = {1e-3, 1e-6, 1e-9, 1e-11};

typedef void runner(const double x0[], const double ends[], int count, double setting,
                    double out[][STATES]);

#define TAYLOR(NAME)                                                                               \
  static NAME##_model NAME##_it;                                                                   \
  static void NAME##_series(const double x0[], const double ends[], int count, double setting,     \
                            double out[][STATES]) {                                                \
    for (int k = 0; k < count; k++) {                                                              \
      memcpy(out[k], x0, sizeof out[k]);                                                           \
      if (NAME##_taylor_run(&NAME##_it, 0, out[k], NULL, ends[k], setting, MOST_STEPS) < 0)        \
        out[k][0] = HUGE_VAL;                                                                      \
    }                                                                                              \
  }
TAYLOR(box12)
TAYLOR(box16)
TAYLOR(box20)
TAYLOR(box24)
TAYLOR(box12_host)
TAYLOR(box16_host)
TAYLOR(box20_host)
TAYLOR(box24_host)
TAYLOR(top12)
TAYLOR(top16)
TAYLOR(top20)
TAYLOR(top24)
TAYLOR(top12_host)
TAYLOR(top16_host)
TAYLOR(top20_host)
TAYLOR(top24_host)

/* setting: steps in the last end time; the way from one end time to the next is cut into whole
 * steps no longer than those */
#define FIXED(LAST, STEP)                                                                          \
  const double longest = LAST / setting;                                                           \
  double x[STATES], t = 0;                                                                         \
  memcpy(x, x0, sizeof x);                                                                         \
  for (int k = 0; k < count; k++) {                                                                \
    const double steps = ceil((ends[k] - t) / longest * (1 - 1e-12)), h = (ends[k] - t) / steps;   \
    for (long left = (long)steps; left > 0; left--)                                                \
      STEP;                                                                                        \
    t = ends[k];                                                                                   \
    memcpy(out[k], x, sizeof x);                                                                   \
  }
#define FIXED_STEP(NAME, METHOD)                                                                   \
  static void NAME##_##METHOD##_fixed(const double x0[], const double ends[], int count,           \
                                      double setting, double out[][STATES]) {                      \
    FIXED(ends[count - 1], NAME##_##METHOD##_step(&NAME##_it, 0, x, NULL, h))                      \
  }
#define ALL_FIXED(NAME)                                                                            \
  FIXED_STEP(NAME, rk4)                                                                            \
  FIXED_STEP(NAME, split4)                                                                         \
  FIXED_STEP(NAME, split6)
#define ALL_ORDERS(NAME)                                                                           \
  FIXED_STEP(NAME##12, taylor)                                                                     \
  FIXED_STEP(NAME##16, taylor)                                                                     \
  FIXED_STEP(NAME##20, taylor)                                                                     \
  FIXED_STEP(NAME##24, taylor)                                                                     \
  FIXED_STEP(NAME##12_host, taylor)                                                                \
  FIXED_STEP(NAME##16_host, taylor)                                                                \
  FIXED_STEP(NAME##20_host, taylor)                                                                \
  FIXED_STEP(NAME##24_host, taylor)
ALL_FIXED(box20)
ALL_FIXED(top20)
ALL_FIXED(box20_host)
ALL_FIXED(top20_host)
ALL_ORDERS(box)
ALL_ORDERS(top)

#define EMITTED(NAME)                                                                              \
  static void NAME##_pair(const double x0[], const double ends[], int count, double setting,       \
                          double out[][STATES]) {                                                  \
    double x[STATES], t = 0;                                                                       \
    memcpy(x, x0, sizeof x);                                                                       \
    for (int k = 0; k < count; k++) {                                                              \
      if (NAME##_adaptive_run(&NAME##_it, t, x, NULL, ends[k], setting, MOST_STEPS) < 0)           \
        x[0] = HUGE_VAL;                                                                           \
      t = ends[k];                                                                                 \
      memcpy(out[k], x, sizeof x);                                                                 \
    }                                                                                              \
  }                                                                                                \
  static int NAME##_gsl(double t, const double x[], double dx[], void *none) {                     \
    (void)none;                                                                                    \
    NAME##_rhs(&NAME##_it, t, x, NULL, dx);                                                        \
    return GSL_SUCCESS;                                                                            \
  }
EMITTED(box20)
EMITTED(top20)

typedef int gsl_rates(double t, const double x[], double dx[], void *none);
static gsl_rates *rates; /* of the scene that is measured */

static void gsl(const gsl_odeiv2_step_type *type, int fixed, const double x0[], const double ends[],
                int count, double setting, double out[][STATES]) {
  const gsl_odeiv2_system system = {rates, NULL, STATES, NULL};
  const double tolerance = fixed ? 1 : setting, longest = ends[count - 1] / setting;
  gsl_odeiv2_driver *driver =
      gsl_odeiv2_driver_alloc_y_new(&system, type, 1e-4, tolerance, tolerance);
  double x[STATES], t = 0;
  memcpy(x, x0, sizeof x);
  for (int k = 0; k < count; k++) {
    const double steps = fixed ? ceil((ends[k] - t) / longest * (1 - 1e-12)) : 1;
    const int status = fixed ? gsl_odeiv2_driver_apply_fixed_step(driver, &t, (ends[k] - t) / steps,
                                                                  (unsigned long)steps, x)
                             : gsl_odeiv2_driver_apply(driver, &t, ends[k], x);
    if (status != GSL_SUCCESS)
      x[0] = HUGE_VAL;
    t = ends[k];
    memcpy(out[k], x, sizeof x);
  }
  gsl_odeiv2_driver_free(driver);
}
#define GSL(NAME, TYPE, IS_FIXED)                                                                  \
  static void NAME(const double x0[], const double ends[], int count, double setting,              \
                   double out[][STATES]) {                                                         \
    gsl(TYPE, IS_FIXED, x0, ends, count, setting, out);                                            \
  }
GSL(gsl_rk4, gsl_odeiv2_step_rk4, 1)
GSL(gsl_rkf45, gsl_odeiv2_step_rkf45, 0)
GSL(gsl_rk8pd, gsl_odeiv2_step_rk8pd, 0)
GSL(gsl_rk8pd_fixed, gsl_odeiv2_step_rk8pd, 1)
GSL(gsl_msadams, gsl_odeiv2_step_msadams, 0)

typedef struct row {
  const char *name;
  runner *run;
  enum { PORTABLE, HOST, PEER } kind;
  int fixed; /* a number of steps, not a tolerance */
} row;

#define ROWS(S)                                                                                    \
  {                                                                                                \
    {"emitted Taylor, at most order 12", S##12_series, PORTABLE, 0},                               \
        {"emitted Taylor, at most order 16", S##16_series, PORTABLE, 0},                           \
        {"emitted Taylor, at most order 20", S##20_series, PORTABLE, 0},                           \
        {"emitted Taylor, at most order 24", S##24_series, PORTABLE, 0},                           \
        {"order 12, for this machine", S##12_host_series, HOST, 0},                                \
        {"order 16, for this machine", S##16_host_series, HOST, 0},                                \
        {"order 20, for this machine", S##20_host_series, HOST, 0},                                \
        {"order 24, for this machine", S##24_host_series, HOST, 0},                                \
        {"emitted Taylor, order 12, fixed steps", S##12_taylor_fixed, PORTABLE, 1},                \
        {"emitted Taylor, order 16, fixed steps", S##16_taylor_fixed, PORTABLE, 1},                \
        {"emitted Taylor, order 20, fixed steps", S##20_taylor_fixed, PORTABLE, 1},                \
        {"emitted Taylor, order 24, fixed steps", S##24_taylor_fixed, PORTABLE, 1},                \
        {"order 12, fixed steps, for this machine", S##12_host_taylor_fixed, HOST, 1},             \
        {"order 16, fixed steps, for this machine", S##16_host_taylor_fixed, HOST, 1},             \
        {"order 20, fixed steps, for this machine", S##20_host_taylor_fixed, HOST, 1},             \
        {"order 24, fixed steps, for this machine", S##24_host_taylor_fixed, HOST, 1},             \
        {"emitted adaptive", S##20_pair, PORTABLE, 0},                                             \
        {"emitted RK4", S##20_rk4_fixed, PORTABLE, 1},                                             \
        {"RK4, for this machine", S##20_host_rk4_fixed, HOST, 1},                                  \
        {"emitted split4", S##20_split4_fixed, PORTABLE, 1},                                       \
        {"split4, for this machine", S##20_host_split4_fixed, HOST, 1},                            \
        {"emitted split6", S##20_split6_fixed, PORTABLE, 1},                                       \
        {"split6, for this machine", S##20_host_split6_fixed, HOST, 1},                            \
        {"GSL rk4, fixed steps", gsl_rk4, PEER, 1}, {"GSL rkf45", gsl_rkf45, PEER, 0},             \
        {"GSL rk8pd", gsl_rk8pd, PEER, 0}, {"GSL rk8pd, fixed steps", gsl_rk8pd_fixed, PEER, 1}, { \
      "GSL msadams", gsl_msadams, PEER, 0                                                          \
    }                                                                                              \
  }
static const row box_rows[] = ROWS(box), top_rows[] = ROWS(top);
enum { COUNT = sizeof box_rows / sizeof box_rows[0] };

static double truth[ENDS][STATES], ends[ENDS];

static double error_of(const double x[], const double y[]) {
  double plus = 0, minus = 0, w = 0, size = 0;
  for (int i = 0; i < STATES; i++) {
    const double less = (x[i] - y[i]) * (x[i] - y[i]), more = (x[i] + y[i]) * (x[i] + y[i]);
    if (i < 4) {
      minus += less;
      plus += more;
    } else {
      w += less;
      size += y[i] * y[i];
    }
  }
  const double e = sqrt(fmax(fmin(plus, minus), w / size));
  return e < HUGE_VAL ? e : HUGE_VAL; /* also what is no number */
}

static double worst_error(const row *r, const double x0[], double setting) {
  static double out[ENDS][STATES];
  double worst = 0;
  r->run(x0, ends, ENDS, setting, out);
  for (int k = 0; k < ENDS; k++)
    worst = fmax(worst, error_of(out[k], truth[k]));
  return worst;
}

static double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static double cost(const row *r, const double x0[], double setting) {
  double best = HUGE_VAL, out[1][STATES];
  for (int k = 0; k < REPEATS; k++) {
    const double start = now();
    r->run(x0, &ends[ENDS - 1], 1, setting, out);
    best = fmin(best, now() - start);
  }
  return best;
}

/* radians: of the horizon; no fixed step is below a thousandth of one */
static void measure(const char *title, const row rows[], const double x0[], double radians) {
  double least[3][LEVELS];
  for (int k = 0; k < 3; k++)
    for (int l = 0; l < LEVELS; l++)
      least[k][l] = HUGE_VAL;
  printf("%s\n  %-40s", title, "us to the horizon at error <=");
  for (int l = 0; l < LEVELS; l++)
    printf(" %9.0e", level[l]);
  printf("   best error\n");
  for (int r = 0; r < COUNT; r++) {
    double best[LEVELS], finest = HUGE_VAL;
    for (int l = 0; l < LEVELS; l++)
      best[l] = HUGE_VAL;
    for (int k = 0; k < (rows[r].fixed ? 160 : 64); k++) {
      const double setting =
          rows[r].fixed ? ceil(radians / 8 * pow(2, k / 12.0)) : pow(10, -1 - 0.25 * k);
      if (rows[r].fixed && setting > 1000 * radians)
        break;
      const double e = worst_error(&rows[r], x0, setting);
      finest = fmin(finest, e);
      if (!(e <= level[0]))
        continue;
      const double s = cost(&rows[r], x0, setting);
      for (int l = 0; l < LEVELS && e <= level[l]; l++)
        best[l] = fmin(best[l], s);
      if (e <= level[LEVELS - 1])
        break; /* what is finer costs more */
    }
    printf("  %-40s", rows[r].name);
    for (int l = 0; l < LEVELS; l++) {
      least[rows[r].kind][l] = fmin(least[rows[r].kind][l], best[l]);
      if (best[l] < HUGE_VAL)
        printf(" %9.1f", best[l] * 1e6);
      else
        printf(" %9s", "-");
    }
    printf("   %.1e\n", finest);
  }
  for (int k = PORTABLE; k <= HOST; k++) {
    printf("  %-40s",
           k == PORTABLE ? "best of GSL over best emitted, portable" : "  for this machine");
    for (int l = 0; l < LEVELS; l++)
      printf(" %9.1f", least[PEER][l] / least[k][l]);
    printf("\n");
  }
}

/* The truth at the ends from the library; non-zero if it failed. */
static int library(const double tensor[6], double height, const double x0[], double horizon) {
  const double com[3] = {0, 0, height}, down[3] = {0, 0, -1};
  ph_options options = ph_options_default();
  ph_free_top exact;
  ph_top top;
  ph_run *run = NULL;
  int bad = ph_top_init_tensor(&top, 0.4, com, tensor);
  for (int k = 0; k < ENDS; k++)
    ends[k] = horizon * (0.9 + 0.1 * (k + 1) / ENDS);
  if (height > 0) {
    bad = bad || ph_top_gravity(&top, 9.81, down) || ph_run_new(&run, &top, &options, 0, x0);
    for (int k = 0; !bad && k < ENDS; k++)
      bad = ph_run_to(run, ends[k], NULL, truth[k]);
    ph_run_free(run);
  } else {
    bad = bad || ph_free_top_solve(&exact, &top, x0);
    for (int k = 0; !bad && k < ENDS; k++)
      bad = ph_free_top_at(&exact, ends[k], truth[k]);
  }
  return bad;
}

#define INIT(S)                                                                                    \
  (S##12_init(&S##12_it, NULL) || S##16_init(&S##16_it, NULL) || S##20_init(&S##20_it, NULL) ||    \
   S##24_init(&S##24_it, NULL) || S##12_host_init(&S##12_host_it, NULL) ||                         \
   S##16_host_init(&S##16_host_it, NULL) || S##20_host_init(&S##20_host_it, NULL) ||               \
   S##24_host_init(&S##24_host_it, NULL))

int main(void) {
  double x0[STATES], tensor[6];
  gsl_set_error_handler_off();
  if (INIT(box) || INIT(top))
    return 1;
  box20_initial(&box20_it, x0);
  box20_inertia(&box20_it, tensor);
  if (library(tensor, 0, x0, 100))
    return 1;
  rates = box20_gsl;
  measure("tumbling_box, 100 s", box_rows, x0, 700);
  top20_initial(&top20_it, x0);
  top20_inertia(&top20_it, tensor);
  if (library(tensor, 0.03, x0, 20))
    return 1;
  rates = top20_gsl;
  measure("nodding_top, 20 s", top_rows, x0, 1200);
  return 0;
}
