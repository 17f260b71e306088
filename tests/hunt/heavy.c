/* heavy.c - the hunt's target: the emitted closed form of the heavy symmetric top.
   SPDX-License-Identifier: GPL-3.0-or-later

   SINGLE: the code is float. The fast oracle is the library's Taylor series in long double, over
   short times, since what a motion near its separatrix multiplies it multiplies too; the slow one
   is the series with MPFR (tests/oracle/heavy_top.c). Errors in units u = 2^-53 or 2^-24: rates
   over the pace, which is the largest of |w| at both ends and sqrt(m g l/A); attitude as an angle
   (rad); |q| - 1. */
#include "lagrange.h"
#include "polhode.h"
#include "search.h"

#define main heavy_top_main
#include "../oracle/heavy_top.c"
#undef main

#include <math.h>

typedef lagrange_real real_type;

#ifdef SINGLE
enum { DIGITS = 24, GRADED = 20, SLOW = 20, SCALE = 12 };
#define PACES 24
#define BITS  96
#else
enum { DIGITS = 53, GRADED = 40, SLOW = 40, SCALE = 40 };
#define PACES 8
#define BITS  144
#endif
#define ARM 0x1p-30 /* the scene's length, below 1e-9: m l^2 = 2^-60 is part of no moment */

enum { A, C, G, W, Q = W + 3, T = Q + 4, GENES };
enum { RATES, ATTITUDE, NORM, ERRORS };

static const hunt_gene genes[] = {
    {"A", HUNT_POSITIVE, 0}, {"C", HUNT_POSITIVE, 0}, {"mgl", HUNT_SIGNED, 1},
    {"wx", HUNT_SIGNED, 2},  {"wy", HUNT_SIGNED, 2},  {"wz", HUNT_SIGNED, 2},
    {"qw", HUNT_SIGNED, 3},  {"qx", HUNT_SIGNED, 3},  {"qy", HUNT_SIGNED, 3},
    {"qz", HUNT_SIGNED, 3},  {"t", HUNT_SIGNED, 4},
};

/* The requirement of tests/emit/lagrange.t: 4e-15 and 4e-6; |q| - 1 as in free.c. */
static const hunt_error errors[] = {{"rates", 36, 0}, {"attitude", 36, 0}, {"norm", 5, 0}};

static double pace_of(const double *g) {
  double most = sqrt(fabs(g[G]) / g[A]);
  for (int i = 0; i < 3; i++)
    most = fmax(most, fabs(g[W + i]));
  return most;
}

static void draw(hunt_random *r, double *g) {
  const int single = DIGITS == 24;
  const double size = hunt_size(r, -SCALE / 2, SCALE / 2),
               rate = hunt_size(r, -SCALE / 4, SCALE / 4);
  const double small = hunt_chance(r, 0.5) ? hunt_size(r, -SLOW, 0) : 1;
  g[A] = size * hunt_mantissa(r, single);
  g[C] = g[A] * (hunt_chance(r, 0.2) ? hunt_near_one(r, single) : 2 * hunt_uniform(r));
  if (hunt_chance(r, 0.1))
    g[C] *= hunt_size(r, -GRADED / 2, 0);
  g[G] = g[A] * rate * rate * hunt_sign(r) * hunt_mantissa(r, single) * hunt_size(r, -3, 3);
  if (hunt_chance(r, 0.1))
    g[G] *= hunt_size(r, -SLOW, 0);
  for (int i = 0; i < 7; i++)
    g[W + i] = hunt_chance(r, 0.15) ? 0
                                    : (i < 3 ? rate : 1) * hunt_sign(r) * hunt_mantissa(r, single) *
                                          hunt_size(r, i < 3 ? -2 : -1, i < 3 ? 2 : 0);
  switch (hunt_below(r, 5)) {
  case 0: /* upright or hanging, about the critical spin */
    g[Q] = 1, g[Q + 1] = small * hunt_sign(r), g[Q + 2] *= small, g[W] *= small, g[W + 1] *= small;
    if (hunt_chance(r, 0.5))
      g[W + 2] = sqrt(4 * fabs(g[G]) * g[A]) / g[C] * hunt_near_one(r, single);
    if (hunt_chance(r, 0.3))
      g[Q + 1] = g[Q], g[Q] = 0;
    break;
  case 1: /* a pendulum, and almost */
    g[W + 2] *= hunt_chance(r, 0.5) ? 0 : small;
    if (hunt_chance(r, 0.5)) /* from below, just to the top */
      g[Q] = g[Q + 2] = g[Q + 3] = g[W + 1] = 0, g[Q + 1] = 1,
      g[W] = sqrt(4 * fabs(g[G]) / g[A]) * hunt_near_one(r, single);
    break;
  case 2: { /* steady precession, and almost */
    const double angle = 3 * hunt_uniform(r), c = cos(angle), p = rate * hunt_size(r, -2, 2);
    g[Q] = cos(angle / 2), g[Q + 1] = sin(angle / 2), g[Q + 2] = g[Q + 3] = 0;
    g[W] *= hunt_chance(r, 0.5) ? 0 : small;
    g[W + 1] = p * sin(angle);
    g[W + 2] = (g[G] / p + g[A] * p * c) / g[C] * hunt_near_one(r, single);
    break;
  }
  default:
    break;
  }
  g[T] = hunt_sign(r) * hunt_mantissa(r, single) * PACES / 2 * hunt_size(r, -4, 0) / pace_of(g);
}

/* ---- one state ---- */

static lagrange_model model;
static lagrange_orbit orbit;
static ph_top top;
static double unit, start[7];

static int between(double value, double low, double high) {
  return value >= low && value <= high;
}

/* A scene's parameter cannot be m g l itself: it is g times the arm, a power of two. */
static int prepare(const double *g) {
  real_type p[LAGRANGE_NP] = {0}, x0[7];
  const double scale = exp2(SCALE), slow = exp2(-SLOW - 4), pace = pace_of(g);
  double most = 0;
  if (!between(g[A], 1 / scale, scale) || !between(pace, 1 / scale, scale) ||
      !between(g[C], g[A] * exp2(-GRADED), 2 * g[A]))
    return 0;
  for (int i = 0; i < 7; i++) {
    start[i] = i < 4 ? g[Q + i] : g[W + i - 4];
    x0[i] = (real_type)start[i];
    const double least = (i < 4 ? 1 : pace) * slow;
    if (start[i] != 0 && fabs(start[i]) < least)
      return 0;
    most = i < 4 ? fmax(most, fabs(start[i])) : most;
  }
  if (!between(most, 0x1p-4, 0x1p4) || (g[G] != 0 && fabs(g[G]) < g[A] * pace * pace * slow))
    return 0;
  p[LAGRANGE_A] = (real_type)g[A];
  p[LAGRANGE_C] = (real_type)g[C];
  p[LAGRANGE_G] = (real_type)(fabs(g[G]) / ARM);
  p[LAGRANGE_L] = (real_type)(g[G] < 0 ? -ARM : ARM);
  if (lagrange_init(&model, p) != 0 || lagrange_solve(&orbit, &model, x0) != 0)
    return 0;
  const double tensor[6] = {g[A], g[A], g[C], 0, 0, 0}, arm[3] = {0, 0, g[G] < 0 ? -ARM : ARM};
  const double down[3] = {0, 0, -1};
  return ph_top_init_tensor(&top, 1, arm, tensor) == 0 &&
         (g[G] == 0 || ph_top_gravity(&top, fabs(g[G]) / ARM, down) == 0);
}

static void evaluate(const double *g, double have[7]) {
  real_type y[7];
  lagrange_at(&orbit, (real_type)g[T], y);
  for (int i = 0; i < 7; i++)
    have[i] = (double)y[i];
}

static double norm_error(const double *q) {
  long double n = 0;
  for (int i = 0; i < 4; i++)
    n += (long double)q[i] * q[i];
  return (double)fabsl(sqrtl(n) - 1);
}

static int measure(const double *g, double *error) {
  const ph_options options = ph_options_default();
  double have[7], v[7], dw = 0, plus = 0, minus = 0, pace = pace_of(g);
  ph_run *run;
  if (!(fabs(g[T]) * pace < PACES) || ph_run_new(&run, &top, &options, 0, start) != 0)
    return 0;
  const int status = ph_run_to(run, g[T], NULL, v);
  ph_run_free(run);
  if (status)
    return 0;
  evaluate(g, have);
  for (int i = 0; i < 4; i++) {
    plus += (have[i] - v[i]) * (have[i] - v[i]);
    minus += (have[i] + v[i]) * (have[i] + v[i]);
  }
  for (int i = 4; i < 7; i++) {
    const double e = fabs(have[i] - v[i]);
    dw = e <= dw ? dw : e;
    pace = fmax(pace, fabs(v[i]));
  }
  error[RATES] = dw / pace / unit;
  error[ATTITUDE] = 2 * sqrt(minus < plus ? minus : plus) / unit;
  error[NORM] = norm_error(have) / unit;
  return 1;
}

static int judge(const double *g, double *error) {
  double in[14] = {g[A], g[A], g[C], 0, 0, g[G]}, have[7], pace = pace_of(g), dw = 0, plus = 0,
         minus = 0;
  if (!prepare(g) || !(fabs(g[T]) * pace < 100))
    return 0;
  for (int i = 0; i < 8; i++)
    in[6 + i] = g[W + i];
  begin(in);
  advance();
  evaluate(g, have);
  for (int i = 0; i < 7; i++) {
    mpfr_t *v = x[i < 3 ? i : i + 3];
    const double got = have[i < 3 ? i + 4 : i - 3];
    mpfr_d_sub(sum, got, v[0], MPFR_RNDN);
    const double e = fabs(mpfr_get_d(sum, MPFR_RNDN));
    mpfr_add_d(sum, v[0], got, MPFR_RNDN);
    const double f = mpfr_get_d(sum, MPFR_RNDN);
    if (i < 3)
      dw = e <= dw ? dw : e, pace = fmax(pace, fabs(mpfr_get_d(v[0], MPFR_RNDN)));
    else
      plus += e * e, minus += f * f;
  }
  error[RATES] = dw / pace / unit;
  error[ATTITUDE] = 2 * sqrt(minus < plus ? minus : plus) / unit;
  error[NORM] = norm_error(have) / unit;
  return 1;
}

int main(int argc, char **argv) {
  static const hunt_target target = {
      "heavy_top", DIGITS == 24, GENES, 1, genes, ERRORS, errors, 4, draw, prepare, measure, judge};
  unit = ldexp(1, -DIGITS);
  bits = BITS;
  order = (int)(bits / 4 + 16);
  for (int i = 0; i < STATES; i++)
    for (int n = 0; n <= order; n++)
      mpfr_init2(x[i][n], bits);
  for (int i = 0; i < 3; i++)
    mpfr_inits2(bits, I[i], load[i], (mpfr_ptr)0);
  mpfr_inits2(bits, sum, term, h, left, largest, power, (mpfr_ptr)0);
  return hunt_main(&target, argc, argv);
}
