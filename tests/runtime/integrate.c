/* integrate.c - runs of every method against motions that are known to many digits.
   SPDX-License-Identifier: GPL-3.0-or-later

   Oracles: the symmetric top's closed form, written here in MPFR (the library has its own, which is
   checked too); orders of convergence by halving the step; conserved quantities; motions at extreme
   scales that are known exactly. The bar: over 1000 revolutions of a symmetric top attitude and
   rates to 5e-13. Reference tables are in known.c. */
#include <float.h>
#include <math.h>
#include <mpfr.h>
#include <string.h>

#include "polhode.h"
#include "tap.h"

#define COUNT(table) (sizeof(table) / sizeof(table)[0])

static const double PI = 3.141592653589793;

static double distance(int n, const double a[], const double b[]) {
  double d = 0;
  for (int i = 0; i < n; i++)
    d = fmax(d, fabs(a[i] - b[i]));
  return d;
}

/* ---- the closed form in MPFR: w turned about axis 3, attitude = turn about L, q0, turn about axis
 * 3 ---- */

enum { BITS = 160 };

static void mp_turn(mpfr_t q[4], mpfr_t angle, mpfr_t axis[3]) {
  mpfr_t half, s;
  mpfr_inits2(BITS, half, s, (mpfr_ptr)0);
  mpfr_div_ui(half, angle, 2, MPFR_RNDN);
  mpfr_sin_cos(s, q[0], half, MPFR_RNDN);
  for (int i = 0; i < 3; i++)
    mpfr_mul(q[1 + i], s, axis[i], MPFR_RNDN);
  mpfr_clears(half, s, (mpfr_ptr)0);
}

static void mp_multiply(mpfr_t a[4], mpfr_t b[4], mpfr_t out[4]) {
  static const int index[4][4] = {{0, 1, 2, 3}, {1, 0, 3, 2}, {2, 3, 0, 1}, {3, 2, 1, 0}};
  static const int minus[4][4] = {{0, 1, 1, 1}, {0, 0, 0, 1}, {0, 1, 0, 0}, {0, 0, 1, 0}};
  mpfr_t t;
  mpfr_init2(t, BITS);
  for (int i = 0; i < 4; i++) {
    mpfr_set_zero(out[i], 1);
    for (int k = 0; k < 4; k++) {
      mpfr_mul(t, a[k], b[index[i][k]], MPFR_RNDN);
      (minus[i][k] ? mpfr_sub : mpfr_add)(out[i], out[i], t, MPFR_RNDN);
    }
  }
  mpfr_clear(t);
}

/* I = (A, A, C), q0 = 1: L is in the body's axes at t = 0. */
static void symmetric_oracle(double A, double C, const double w0[3], double t, double x[7]) {
  mpfr_t v[24], *L = v, *e3 = v + 3, *outer = v + 6, *inner = v + 10, *q = v + 14, *s = v + 18;
  for (int i = 0; i < 24; i++)
    mpfr_init2(v[i], BITS);
  for (int i = 0; i < 3; i++) {
    mpfr_set_d(L[i], w0[i], MPFR_RNDN);
    mpfr_mul_d(L[i], L[i], i < 2 ? A : C, MPFR_RNDN);
    mpfr_set_ui(e3[i], i == 2, MPFR_RNDN);
  }
  mpfr_hypot(s[0], L[0], L[1], MPFR_RNDN);
  mpfr_hypot(s[0], s[0], L[2], MPFR_RNDN);
  for (int i = 0; i < 3; i++)
    mpfr_div(L[i], L[i], s[0], MPFR_RNDN);
  mpfr_mul_d(s[0], s[0], t, MPFR_RNDN);
  mpfr_div_d(s[0], s[0], A, MPFR_RNDN);
  mp_turn(outer, s[0], L);
  mpfr_set_d(s[1], C, MPFR_RNDN); /* Omega t = (C - A)/A w3 t */
  mpfr_sub_d(s[1], s[1], A, MPFR_RNDN);
  mpfr_div_d(s[1], s[1], A, MPFR_RNDN);
  mpfr_mul_d(s[1], s[1], w0[2], MPFR_RNDN);
  mpfr_mul_d(s[1], s[1], t, MPFR_RNDN);
  mpfr_neg(s[2], s[1], MPFR_RNDN);
  mp_turn(inner, s[2], e3);
  mp_multiply(outer, inner, q);
  for (int i = 0; i < 4; i++)
    x[i] = mpfr_get_d(q[i], MPFR_RNDN);
  mpfr_sin_cos(s[3], s[4], s[1], MPFR_RNDN);
  for (int i = 0; i < 2; i++) { /* (cos w1 - sin w2, sin w1 + cos w2) */
    mpfr_mul_d(s[2], s[4 - i], w0[0], MPFR_RNDN);
    mpfr_mul_d(s[5], s[3 + i], w0[1], MPFR_RNDN);
    (i ? mpfr_add : mpfr_sub)(s[2], s[2], s[5], MPFR_RNDN);
    x[4 + i] = mpfr_get_d(s[2], MPFR_RNDN);
  }
  x[6] = w0[2];
  for (int i = 0; i < 24; i++)
    mpfr_clear(v[i]);
  mpfr_free_cache();
}

static void thousand_revolutions(void) {
  static const struct {
    const char *name;
    ph_options options;
    double bar;
  } method[] = {
      {"Taylor, adaptive, 1e-19",
       {.method = PH_TAYLOR, .tolerance = 1e-19, .max_steps = 1000000},
       5e-15},
      {"Taylor, adaptive, default",
       {.method = PH_TAYLOR, .tolerance = 1e-18, .max_steps = 1000000},
       5e-15},
      /* GSL has the coefficients of rk8pd as doubles: its conditions of order hold to some 1e-16,
         and over 4160 rad the error levels off near 1e-12 (measured: 4e-13 at a quarter of this
         step) */
      {"rk8pd, adaptive, 1e-16",
       {.method = PH_RK8PD, .tolerance = 1e-16, .max_steps = 1000000},
       5e-12},
      {"rk8pd, fixed step", {.method = PH_RK8PD, .step = 0.03125, .max_steps = 1000000}, 2e-12},
  };
  const double A = 1, C = 1.5, w0[3] = {0.6, -0.4, 0.9};
  const double L = sqrt(0.36 + 0.16 + 1.35 * 1.35),
               T = 2 * PI * A / L * 1000; /* 1000 turns of the axis about L */
  ph_top top;
  double want[7], closed[7];
  const double x0[7] = {1, 0, 0, 0, w0[0], w0[1], w0[2]};
  symmetric_oracle(A, C, w0, T, want);
  int s = ph_top_init_tensor(&top, 1, NULL, (const double[]){A, A, C, 0, 0, 0}) ||
          ph_symmetric_at(A, C, x0, T, closed);
  ok(s == 0, "a symmetric top is set up for 1000 revolutions");
  near_all(7, closed, want, 1e-15,
           "the library's closed form has attitude and rates of the 160-bit one");
  for (size_t k = 0; k < COUNT(method); k++) {
    ph_run *run = NULL;
    double x[7] = {0};
    s = ph_run_new(&run, &top, &method[k].options, 0, x0) || ph_run_to(run, T, NULL, x);
    ok(s == 0 && ph_run_time(run) == T, "%s: runs over 1000 revolutions", method[k].name);
    near_all(7, x, want, method[k].bar, "%s: attitude and rates", method[k].name);
    near(x[0] * x[0] + x[1] * x[1] + x[2] * x[2] + x[3] * x[3], 1, 4 * DBL_EPSILON, "%s: |q| = 1",
         method[k].name);
    diag("%s: error %.2g in %ld steps", method[k].name, distance(7, x, want), ph_run_steps(run));
    ph_run_free(run);
  }
}

/* ---- order, conservation, times ---- */

static int heavy_top(ph_top *top) {
  const double down[3] = {0, 0, -1}, com[3] = {0.01, -0.02, 0.3},
               I[6] = {1, 1.2, 0.6, 0.05, -0.02, 0.03};
  return ph_top_init_tensor(top, 1.5, com, I) || ph_top_gravity(top, 9.80665, down);
}

static const double HEAVY[7] = {0.9, 0.3, -0.2, 0.1, 0.5, -1, 6};

static int run_for(const ph_top *top, ph_options options, double t, double x[7]) {
  ph_run *run = NULL;
  const int s = ph_run_new(&run, top, &options, 0, HEAVY) || ph_run_to(run, t, NULL, x);
  ph_run_free(run);
  return s;
}

static void orders(void) {
  static const struct {
    const char *name;
    ph_options options;
    int order;
  } method[] = {
      {"rk4", {.method = PH_RK4, .step = 0x1p-7, .max_steps = 10000}, 4},
      {"rk4 without projection",
       {.method = PH_RK4, .step = 0x1p-7, .free_norm = 1, .max_steps = 10000},
       4},
      {"GSL rk4", {.method = PH_RK4_GSL, .step = 0x1p-6, .max_steps = 10000}, 4},
      {"GSL rkf45", {.method = PH_RKF45, .step = 0x1p-6, .max_steps = 10000}, 5},
      {"GSL rk8pd", {.method = PH_RK8PD, .step = 0x1p-4, .max_steps = 10000}, 8},
      {"Taylor of order 6",
       {.method = PH_TAYLOR, .order = 6, .step = 0x1p-5, .max_steps = 10000},
       6},
      {"Taylor of order 12",
       {.method = PH_TAYLOR, .order = 12, .step = 0x1p-3, .max_steps = 10000},
       12},
  };
  ph_top top;
  double exact[7];
  ok(heavy_top(&top) == 0 && run_for(&top, ph_options_default(), 2, exact) == 0,
     "an asymmetric heavy top runs for 2 s");
  for (size_t k = 0; k < COUNT(method); k++) {
    ph_options options = method[k].options;
    double error[2] = {0, 0};
    for (int n = 0; n < 2; n++) {
      double x[7] = {0};
      const int s = run_for(&top, options, 2, x);
      error[n] = s ? HUGE_VAL : distance(7, x, exact);
      options.step /= 2;
    }
    /* the leading term of the error carries; the next one, a factor h of the motion's rate smaller,
     * bends it by a sixteenth */
    const double order = log2(error[0] / error[1]);
    near(order, method[k].order, method[k].order / 16.0,
         "%s: halving h divides the error by 2^%d (%.2g -> %.2g)", method[k].name, method[k].order,
         error[0], error[1]);
  }
}

static void tolerances(void) {
  ph_top top;
  double exact[7];
  heavy_top(&top);
  run_for(&top, ph_options_default(), 20, exact);
  static const struct {
    const char *name;
    ph_method method;
  } method[] = {{"GSL rk4", PH_RK4_GSL},
                {"GSL rkf45", PH_RKF45},
                {"GSL rk8pd", PH_RK8PD},
                {"Taylor", PH_TAYLOR}};
  for (size_t k = 0; k < COUNT(method); k++)
    for (int digits = 6; digits <= 12; digits += 3) {
      const double tolerance = pow(10, -digits);
      double x[7] = {0};
      const int s = run_for(
          &top,
          (ph_options){.method = method[k].method, .tolerance = tolerance, .max_steps = 10000000},
          20, x);
      /* errors of some hundred to ten thousand steps add up, and this top magnifies them about
       * tenfold in 20 s */
      near_all(7, x, exact, s ? 0 : 3000 * tolerance, "%s at 1e-%d stays near (error %.2g)",
               method[k].name, digits, distance(7, x, exact));
    }
}

static void conservation(void) {
  ph_top top;
  double x[7], E0, E, L0[3], L[3], unit[7];
  ph_options options = ph_options_default();
  heavy_top(&top);
  ph_run *run = NULL;
  int s = ph_run_new(&run, &top, &options, 0, HEAVY);
  memcpy(unit, HEAVY, sizeof unit);
  ph_quat_normalize(HEAVY, unit);
  ph_top_energy(&top, unit, &E0);
  ph_top_momentum(&top, unit, L0);
  double worst_E = 0, worst_L = 0;
  for (int k = 1; k <= 100; k++) {
    s = s || ph_run_to(run, k, NULL, x) || ph_top_energy(&top, x, &E) ||
        ph_top_momentum(&top, x, L);
    worst_E = fmax(worst_E, fabs(E - E0) / fabs(E0));
    worst_L = fmax(worst_L, fabs(L[2] - L0[2]) / fabs(L0[2]));
  }
  ph_run_free(run);
  ok(s == 0, "a heavy top runs for 100 s");
  near(worst_E, 0, 8 * DBL_EPSILON,
       "its energy stays, to the rounding of the states it is read from");
  near(worst_L, 0, 8 * DBL_EPSILON, "and so does the vertical angular momentum");

  ph_top_without(&top, PH_GRAVITY);
  s = ph_run_new(&run, &top, &options, 0, HEAVY) || ph_run_to(run, 200, NULL, x) ||
      ph_top_energy(&top, x, &E) || ph_top_momentum(&top, x, L);
  ph_top_energy(&top, unit, &E0);
  ph_run_free(run);
  ok(s == 0, "the free top runs for 200 s");
  near(E, E0, 8 * DBL_EPSILON * E0, "it keeps T");
  near_all(3, L, L0, 8 * DBL_EPSILON * 4, "and L, all three components");
  /* decay L' = -rate L: T falls by exp(-2 rate t), L keeps its direction */
  s = ph_top_decay(&top, 0.125) || ph_run_new(&run, &top, &options, 0, HEAVY) ||
      ph_run_to(run, 8, NULL, x) || ph_top_energy(&top, x, &E) || ph_top_momentum(&top, x, L);
  ph_run_free(run);
  ok(s == 0, "a top with isotropic decay runs for 1/rate");
  near(E, E0 * exp(-2), 16 * DBL_EPSILON * E0, "T has fallen by e^2");
  for (int i = 0; i < 3; i++)
    L0[i] *= exp(-1);
  near_all(3, L, L0, 16 * DBL_EPSILON, "L by e, in its direction");
}

static void times(void) {
  ph_top top;
  double x[7], there[7], step[7];
  heavy_top(&top);
  ph_options options = ph_options_default();
  ph_run *run = NULL;
  int s = ph_run_new(&run, &top, &options, 0, HEAVY) || ph_run_to(run, 3.7, NULL, there) ||
          ph_run_to(run, 0, NULL, x);
  double unit[7];
  memcpy(unit, HEAVY, sizeof unit);
  ph_quat_normalize(HEAVY, unit);
  ok(s == 0, "there and back");
  near_all(7, x, unit, 64 * DBL_EPSILON, "time runs backward to the initial state");
  s = ph_run_to(run, 0, NULL, step);
  ok(s == 0 && memcmp(x, step, sizeof x) == 0, "a run to where it is changes nothing");
  ph_run_free(run);
  /* asking on the way changes no more than rounding */
  s = ph_run_new(&run, &top, &options, 0, HEAVY);
  for (int k = 1; k <= 37; k++)
    s = s || ph_run_to(run, k * 0.1, NULL, x);
  ph_run_free(run);
  ok(s == 0, "the same way in 37 pieces");
  near_all(7, x, there, 64 * DBL_EPSILON, "ends at the same state");
  /* 0.9/0.3 is 3.00000000000000018 for the two doubles, and still three steps */
  options = (ph_options){.method = PH_RK4, .step = 0.3, .max_steps = 100};
  s = ph_run_new(&run, &top, &options, 0, HEAVY) || ph_run_to(run, 0.9, NULL, x);
  ok(s == 0 && ph_run_steps(run) == 3 && ph_run_evaluations(run) == 12,
     "0.9 s in steps of 0.3 s is three steps of four stages");
  s = ph_run_to(run, 1.05, NULL, x);
  ok(s == 0 && ph_run_steps(run) == 4, "a rest of half a step is one step");
  ph_run_free(run);
  /* control: a constant torque as input and as effect is the same motion */
  ph_top with = top;
  const double u[3] = {0.1, -0.2, 0.3};
  options = ph_options_default();
  ph_top_torque_body(&with, u);
  ph_top_control(&top);
  s = ph_run_new(&run, &top, &options, 0, HEAVY) || ph_run_to(run, 2, u, x);
  ph_run_free(run);
  s = s || ph_run_new(&run, &with, &options, 0, HEAVY) || ph_run_to(run, 2, NULL, there);
  ph_run_free(run);
  ok(s == 0 && memcmp(x, there, sizeof x) == 0, "control u is the torque u");
}

static void extremes(void) {
  double x[7];
  ph_top top;
  ph_run *run = NULL;
  const ph_options taylor = ph_options_default(),
                   rk = {.method = PH_RK8PD, .tolerance = 1e-13, .max_steps = 1000000};
  const ph_options *const both[2] = {&taylor, &rk};
  for (int k = 0; k < 2; k++) {
    /* one turn at 1e30 and 1e-30 rad/s about a principal axis: q(period) = -1 */
    for (int sign = -1; sign <= 1; sign += 2) {
      const double w = sign > 0 ? 1e30 : 1e-30, x0[7] = {1, 0, 0, 0, 0, 0, w};
      int s = ph_top_init_tensor(&top, 1, NULL, (const double[]){1e30, 2e30, 2.5e30, 0, 0, 0}) ||
              ph_run_new(&run, &top, both[k], 0, x0) || ph_run_to(run, 2 * PI / w, NULL, x);
      ph_run_free(run);
      ok(s == 0, "method %d: a turn at %g rad/s", k, w);
      near_all(4, x, ((const double[]){-1, 0, 0, 0}), k ? 1e-11 : 4e-16,
               "method %d: %g rad/s: half a double turn", k, w);
    }
    const double still[7] = {0.6, 0, 0.8, 0, 0, 0, 0};
    int s = ph_run_new(&run, &top, both[k], 0, still) || ph_run_to(run, 1e300, NULL, x);
    ok(s == 0 && ph_run_steps(run) == 1, "method %d: what rests is taken to t = 1e300 in one step",
       k);
    near_all(7, x, still, DBL_EPSILON, "method %d: and rests", k);
    ph_run_free(run);
    /* a rod's free motion: w turns about the rod as the torque equation says, |w across| is kept */
    ph_body b;
    const double x0[7] = {1, 0, 0, 0, 0.3, -0.2, 5};
    s = ph_rod_straight(&b, ph_amount_mass(1), 1) || ph_top_init(&top, &b, NULL) ||
        ph_run_new(&run, &top, both[k], 0, x0) || ph_run_to(run, 100, NULL, x);
    ph_run_free(run);
    ok(s == 0, "method %d: a rod runs", k);
    near(hypot(x[4], x[5]), hypot(0.3, -0.2), 1e-10, "method %d: its rate across is kept", k);
    near(x[6], 5, 0, "method %d: its rate along itself too", k);
  }
}

int main(void) {
  thousand_revolutions();
  orders();
  tolerances();
  conservation();
  times();
  extremes();
  return tap_done();
}
