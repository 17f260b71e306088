/* step.c - the hunt's target: one step of the classical Runge-Kutta method, and one of the Taylor
   series, of a free body. SPDX-License-Identifier: GPL-3.0-or-later

   SINGLE: the code is float. The exact state is the library's, before its last rounding, and the
   judge's that of tests/oracle/free_top.c. Errors are over what may be: truncation and rounding.

   Truncation by majorants. |I_j - I_k| <= I_i, so with W = max |w_i| every coefficient of a rate's
   series is at most that of y' = y^2, y(0) = W, and of a component of q that of Q' = 3/2 y Q, Q(0)
   = 1. All weights of both methods are positive, so the method's own series is bounded by the
   method on (y, Q); orders that agree fall out. With z = h W <= 1/4 rates are off by W times and q
   by [method(z) - the terms kept] + [1/(1 - z) or (1 - z)^(-3/2), less the terms kept]. Rounding:
   12 units of W and of 1: of the result 1, of |q| = 1 restored from a q that is itself rounded 5,
   of increments of z <= 1/4 some twenty operations. */
#include "free_top/free_top.h"
#include "search.h"
#include "steps.h"

#define main free_top_main
#include "../oracle/free_top.c"
#undef main

#include <math.h>

typedef steps_real real_type;

#ifdef SINGLE
enum { DIGITS = 24, SCALE = 12, FAST = 4 }; /* coefficients grow with |w|^20: docs/methods.md */
#else
enum { DIGITS = 53, SCALE = 40, FAST = 36 };
#endif
#define ROUNDING 12

enum { BODY = 3, W = BODY, Q = W + 3, H = Q + 4, GENES };
enum { RK4_RATES, RK4_ATTITUDE, TAYLOR_RATES, TAYLOR_ATTITUDE, ERRORS };

static const hunt_gene genes[] = {
    {"A", HUNT_POSITIVE, 0}, {"B", HUNT_POSITIVE, 0}, {"C", HUNT_POSITIVE, 0},
    {"wx", HUNT_SIGNED, 1},  {"wy", HUNT_SIGNED, 1},  {"wz", HUNT_SIGNED, 1},
    {"qw", HUNT_SIGNED, 2},  {"qx", HUNT_SIGNED, 2},  {"qy", HUNT_SIGNED, 2},
    {"qz", HUNT_SIGNED, 2},  {"h", HUNT_SIGNED, 3},
};
static const hunt_error errors[] = {
    {"rk4_rates", 1, 0}, {"rk4_attitude", 1, 0}, {"taylor_rates", 1, 0}, {"taylor_attitude", 1, 0}};

static double unit;

static double largest(const double *v, int n) {
  double most = 0;
  for (int i = 0; i < n; i++)
    most = fmax(most, fabs(v[i]));
  return most;
}

static void draw(hunt_random *r, double *g) {
  const int single = DIGITS == 24;
  const double size = hunt_size(r, -SCALE, SCALE), rate = hunt_size(r, -FAST, FAST);
  g[0] = hunt_mantissa(r, single) * (hunt_chance(r, 0.2) ? hunt_size(r, -10, 0) : 1);
  g[1] = hunt_chance(r, 0.3) ? g[0] * hunt_near_one(r, single) : g[0] * hunt_size(r, 0, 2);
  g[2] = hunt_chance(r, 0.3) ? g[0] + g[1] : fmax(g[0], g[1]) + fmin(g[0], g[1]) * hunt_uniform(r);
  for (int i = 0; i < 3; i++) {
    g[i] *= size;
    g[W + i] = hunt_chance(r, 0.1) ? 0 : rate * hunt_sign(r) * hunt_mantissa(r, single);
    if (hunt_chance(r, 0.2))
      g[W + i] *= hunt_size(r, -20, 0);
  }
  for (int i = 0; i < 4; i++)
    g[Q + i] = hunt_chance(r, 0.1) ? 0 : hunt_sign(r) * hunt_uniform(r);
  const double most = largest(g + W, 3);
  g[H] = hunt_sign(r) * hunt_size(r, hunt_chance(r, 0.5) ? -16 : -5, -2) / (most > 0 ? most : 1);
}

static steps_model model;
static ph_top top;
static ph_free_top exact;
static double start[7];

/* q is rounded to length 1 as well as the type can: the steps want a unit quaternion. */
static int prepare(const double *g) {
  real_type p[BODY];
  const double tensor[6] = {g[0], g[1], g[2], 0, 0, 0}, w = largest(g + W, 3), i = largest(g, 3);
  const double n =
      sqrt(g[Q] * g[Q] + g[Q + 1] * g[Q + 1] + g[Q + 2] * g[Q + 2] + g[Q + 3] * g[Q + 3]);
  if (!(w > exp2(-FAST - 1) && w < exp2(FAST + 1) && i > exp2(-SCALE - 8) && i < exp2(SCALE + 8)) ||
      !(n > 0x1p-3 && n < 8) || !(fabs(g[H]) * w <= 0.25) || !(fabs(g[H]) * w > 0x1p-20))
    return 0;
  /* the series are seen from a frame that turns with L/I_y: y is the middle axis */
  if ((g[1] < g[0]) == (g[1] < g[2]) && g[1] != g[0] && g[1] != g[2])
    return 0;
  for (int k = 0; k < BODY; k++) {
    /* the majorant's |I_j - I_k| <= I_i, without what rounding adds to it */
    if (!(g[k] >= i * 0x1p-20) || g[k] > g[(k + 1) % 3] + g[(k + 2) % 3])
      return 0;
    p[k] = (real_type)g[k];
  }
  for (int k = 0; k < 7; k++) {
    start[k] = k < 4 ? (double)(real_type)(g[Q + k] / n) : g[W + k - 4];
    if (start[k] != 0 && fabs(start[k]) < 0x1p-40 * (k < 4 ? 1 : w))
      return 0;
  }
  return steps_init(&model, p) == 0 && ph_top_init_tensor(&top, 1, NULL, tensor) == 0 &&
         ph_free_top_solve(&exact, &top, start) == 0;
}

static void both(const double *g, double x[2][7]) {
  real_type y[2][7];
  for (int n = 0; n < 2; n++)
    for (int i = 0; i < 7; i++)
      y[n][i] = (real_type)start[i];
  steps_step(&model, 0, y[0], NULL, (real_type)g[H]);
  steps_taylor_step(&model, 0, y[1], NULL, (real_type)g[H]);
  for (int n = 0; n < 2; n++)
    for (int i = 0; i < 7; i++)
      x[n][i] = (double)y[n][i];
}

/* Terms up to order n of the majorants at z: 1/(1 - z) and (1 - z)^(-3/2). */
static void kept(long double z, int n, long double sum[2]) {
  long double term[2] = {1, 1};
  sum[0] = sum[1] = 1;
  for (int k = 1; k <= n; k++) {
    term[0] *= z, term[1] *= z * (k + 0.5L) / k;
    sum[0] += term[0], sum[1] += term[1];
  }
}

static void slopes(const long double v[2], long double d[2]) {
  d[0] = v[0] * v[0], d[1] = 1.5L * v[0] * v[1];
}

/* Truncation of rates over W, of a component of q, by either method. */
static void truncation(long double z, double off[2][2]) {
  static const long double at[4] = {0, 0.5L, 0.5L, 1},
                           weight[4] = {1 / 6.0L, 1 / 3.0L, 1 / 3.0L, 1 / 6.0L};
  const long double all[2] = {1 / (1 - z), powl(1 - z, -1.5L)};
  long double sum[2], end[2] = {1, 1}, d[2] = {0, 0};
  for (int s = 0; s < 4; s++) {
    const long double v[2] = {1 + at[s] * z * d[0], 1 + at[s] * z * d[1]};
    slopes(v, d);
    end[0] += z * weight[s] * d[0], end[1] += z * weight[s] * d[1];
  }
  kept(z, 4, sum);
  for (int i = 0; i < 2; i++)
    off[0][i] = (double)((end[i] - sum[i]) + (all[i] - sum[i]));
  kept(z, STEPS_ORDER, sum);
  for (int i = 0; i < 2; i++)
    off[1][i] = (double)(all[i] - sum[i]);
}

/* rates in rad/s, attitude as |q - q'|, which four components make: over what is allowed */
static void allowed(const double *g, const double rates[2], const double attitude[2],
                    double *error) {
  const double w = largest(g + W, 3);
  double off[2][2];
  truncation((long double)fabs(g[H]) * w, off);
  for (int n = 0; n < 2; n++) {
    error[2 * n] = rates[n] / (w * (off[n][0] + ROUNDING * unit));
    error[2 * n + 1] = attitude[n] / (2 * off[n][1] + ROUNDING * unit);
  }
}

static int measure(const double *g, double *error) {
  double x[2][7], rates[2] = {0, 0}, attitude[2] = {0, 0};
  ph_wide v[7];
  both(g, x);
  free_top_at_wide(&exact, pair_of(g[H]), v);
  for (int n = 0; n < 2; n++) {
    ph_wide plus = 0, minus = 0;
    for (int i = 0; i < 4; i++) {
      plus += (x[n][i] - v[i]) * (x[n][i] - v[i]);
      minus += (x[n][i] + v[i]) * (x[n][i] + v[i]);
    }
    attitude[n] = (double)sqrtl(minus < plus ? minus : plus);
    for (int i = 4; i < 7; i++)
      rates[n] = fmax(rates[n], (double)fabsl(x[n][i] - v[i]));
  }
  allowed(g, rates, attitude, error);
  return 1;
}

static int judge(const double *g, double *error) {
  double in[14] = {0}, x[2][7], rates[2] = {0, 0}, attitude[2] = {0, 0};
  num v[7];
  if (!prepare(g))
    return 0;
  both(g, x);
  for (int i = 0; i < 3; i++)
    in[i] = g[i], in[6 + i] = g[W + i];
  for (int i = 0; i < 4; i++)
    in[9 + i] = start[i];
  in[13] = g[H];
  used = 0;
  solve(in, v);
  for (int n = 0; n < 2; n++) {
    num plus = real(0), minus = real(0);
    for (int i = 0; i < 7; i++) {
      num have = real(x[n][i < 3 ? i + 4 : i - 3]), off = sub(have, v[i]);
      if (i < 3)
        rates[n] = fmax(rates[n], fabs(mpfr_get_d(off, MPFR_RNDN)));
      else
        plus = add(plus, square(off)), minus = add(minus, square(add(have, v[i])));
    }
    attitude[n] = sqrt(fmin(mpfr_get_d(plus, MPFR_RNDN), mpfr_get_d(minus, MPFR_RNDN)));
  }
  allowed(g, rates, attitude, error);
  return 1;
}

int main(int argc, char **argv) {
  static const hunt_target target = {"step", DIGITS == 24, GENES,   1,       genes, ERRORS, errors,
                                     1,      draw,         prepare, measure, judge};
  unit = ldexp(1, -DIGITS);
  bits = 400;
  pool = malloc(POOL * sizeof *pool);
  return pool ? hunt_main(&target, argc, argv) : 2;
}
