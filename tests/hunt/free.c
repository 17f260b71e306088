/* free.c - the hunt's target: the emitted closed form of the free top.
   SPDX-License-Identifier: GPL-3.0-or-later

   FULL: a tensor of six entries; SYMMETRIC: the elementary form of moments A, A, C; else three
   moments; SINGLE: the code is float. The fast oracle is the library before its last rounding, the
   slow one the textbook's formulas with MPFR. Errors in units u = 2^-53 or 2^-24: rates over the
   largest rate, attitude as an angle (rad), |q| - 1; "library" and "library_rates" are those of
   ph_free_top_at, in 2^-53. The time is t by NAME_at, or n h by NAME_at_tick, h of 24 bits and n
   below 2^29, so that n h is a double. DEFECT: something planted, which the search must find
   (worst.t). */
#include "free_top/free_top.h"
#include "search.h"

#define main free_top_main
#include "../oracle/free_top.c"
#undef main

#include <math.h>

#if defined SYMMETRIC
#include "symmetric.h"
#define SCENE(name) symmetric_##name
enum { BODY = 2 };
#define TARGET "symmetric_top"
#elif defined FULL
#include "tensor.h"
#define SCENE(name) tensor_##name
enum { BODY = 6 };
#define TARGET      "free_tensor"
#else
#include "errormap.h"
#define SCENE(name) errormap_##name
enum { BODY = 3 };
#define TARGET      "free_top"
#endif
typedef SCENE(real) real_type;

#ifdef SINGLE
/* The oracle loses twice the bits of SLOW and those of GRADED. Phases are pairs of 48 bits: beyond
 * 2^20 turns a unit is reached (docs/errormap.md). */
enum { DIGITS = 24, GRADED = 25, SLOW = 100, SCALE = 15, TURNS = 17, BITS = 448 };
#else
enum { DIGITS = 53, GRADED = 80, SLOW = 200, SCALE = 80, TURNS = 40, BITS = 640 };
#endif

enum { W = BODY, Q = BODY + 3, H = BODY + 7, T, N, TICK, GENES };
enum { RATES, ATTITUDE, NORM, LIBRARY_RATES, LIBRARY, ERRORS };

static const hunt_gene genes[] = {
#if defined SYMMETRIC
    {"A", HUNT_POSITIVE, 0}, {"C", HUNT_POSITIVE, 0},
#elif defined FULL
    {"xx", HUNT_POSITIVE, 0}, {"yy", HUNT_POSITIVE, 0}, {"zz", HUNT_POSITIVE, 0},
    {"xy", HUNT_SIGNED, 0},   {"xz", HUNT_SIGNED, 0},   {"yz", HUNT_SIGNED, 0},
#else
    {"A", HUNT_POSITIVE, 0}, {"B", HUNT_POSITIVE, 0},  {"C", HUNT_POSITIVE, 0},
#endif
    {"wx", HUNT_SIGNED, 1},  {"wy", HUNT_SIGNED, 1},   {"wz", HUNT_SIGNED, 1},
    {"qw", HUNT_SIGNED, 2},  {"qx", HUNT_SIGNED, 2},   {"qy", HUNT_SIGNED, 2},
    {"qz", HUNT_SIGNED, 2},  {"h", HUNT_POSITIVE, 3},  {"t", HUNT_SIGNED, 3},
    {"n", HUNT_WHOLE, 4},    {"tick", HUNT_CHOICE, 5},
};

/* 36 and 67 units: the requirement (docs/errormap.md), 4e-15 and 4e-6; |q| - 1 likewise 4e-16 is
   3.6 units: of q from one Newton step, the last rounding and that of the step.
   The library promises 1e-15 of both, 9 units. */
static const hunt_error errors[] = {
    {"rates", 36, 0},        {"attitude", 36, 0}, {"norm", 5, 0},
    {"library_rates", 9, 1}, {"library", 9, 1},
};

/* ---- drawing ---- */

static void draw_moments(hunt_random *r, double m[3]) {
  const int single = DIGITS == 24;
  const double size = hunt_size(r, -SCALE, SCALE) * hunt_mantissa(r, single);
  double a = hunt_mantissa(r, single), b = a * hunt_size(r, 0, 1), c;
  switch (hunt_below(r, 6)) {
  case 0: /* A near B */
    b = a * hunt_near_one(r, single);
    break;
  case 1: /* a needle */
    a *= hunt_size(r, -GRADED, 0);
    break;
  default:
    break;
  }
  switch (hunt_below(r, 5)) {
  case 0: /* C near B */
    c = b * hunt_near_one(r, single);
    break;
  case 1: /* a plate */
    c = a + b;
    break;
  case 2:
    c = (a + b) * hunt_near_one(r, single);
    break;
  default:
    c = b + a * hunt_uniform(r);
  }
  const double list[3] = {a, b, c};
  const int turn = (int)hunt_below(r, 3), swap = (int)hunt_below(r, 2);
  for (int i = 0; i < 3; i++)
    m[((swap ? 2 - i : i) + turn) % 3] = size * list[i];
}

/* On the separatrix but for a factor near 1: I1 (I2 - I1) w1^2 = I3 (I3 - I2) w3^2. */
static void draw_separatrix(hunt_random *r, const double m[3], double w[3]) {
  int o[3] = {0, 1, 2};
  for (int i = 0; i < 3; i++)
    for (int j = i + 1; j < 3; j++)
      if (m[o[j]] < m[o[i]]) {
        const int k = o[i];
        o[i] = o[j], o[j] = k;
      }
  const double up = m[o[1]] / m[o[2]], down = m[o[0]] / m[o[2]];
  if (up < 1 && down < up)
    w[o[2]] = w[o[0]] * sqrt(down * (up - down) / (1 - up)) * hunt_near_one(r, DIGITS == 24);
}

static void draw(hunt_random *r, double *g) {
  const int single = DIGITS == 24;
  double most = 0, m[3];
  draw_moments(r, m);
#ifdef SYMMETRIC
  memcpy(g, m, 2 * sizeof *m);
  if (hunt_chance(r, 0.2))
    g[1] = g[0] * hunt_near_one(r, single);
  else if (hunt_chance(r, 0.2))
    g[1] = 2 * g[0];
#else
  memcpy(g, m, sizeof m);
#endif
  const double rate = hunt_size(r, -SCALE, SCALE);
  for (int i = 0; i < 3; i++) {
    double w = hunt_sign(r) * hunt_mantissa(r, single);
    if (hunt_chance(r, 0.1))
      w = 0;
    else if (hunt_chance(r, 0.3))
      w *= hunt_size(r, hunt_chance(r, 0.3) ? -SLOW : -20, 0);
    g[W + i] = rate * w;
  }
  if (hunt_chance(r, 0.2))
    draw_separatrix(r, m, g + W);
  for (int i = 0; i < 3; i++)
    most = fmax(most, fabs(g[W + i]));
  for (int i = 0; i < 4; i++)
    g[Q + i] = hunt_chance(r, 0.1) ? 0
                                   : hunt_sign(r) * hunt_mantissa(r, single) *
                                         (hunt_chance(r, 0.2) ? hunt_size(r, -30, 0) : 1);
#ifdef FULL
  if (hunt_chance(r, 0.9))
    for (int i = 0; i < 3; i++)
      g[3 + i] = sqrt(g[i] * g[(i + 1) % 3]) * hunt_sign(r) * hunt_size(r, -30, -1);
#endif
  g[T] = hunt_sign(r) * hunt_size(r, -4, TURNS) * hunt_mantissa(r, single) / (most > 0 ? most : 1);
  g[N] = hunt_sign(r) * floor(hunt_size(r, 0, DIGITS == 24 ? 20 : 29));
  g[H] = fabs(g[T]) / fabs(g[N]);
  g[TICK] = (double)hunt_below(r, 2);
}

/* ---- one state ---- */

static SCENE(model) model;
static SCENE(orbit) orbit;
static ph_top top;
static ph_free_top exact;
static double unit;

static int within(const double *v, int n, double scale, double slow) {
  double most = 0;
  for (int i = 0; i < n; i++)
    most = fmax(most, fabs(v[i]));
  if (!(most >= exp2(-scale) && most <= exp2(scale)))
    return 0;
  for (int i = 0; i < n; i++)
    if (v[i] != 0 && fabs(v[i]) < most * exp2(-slow))
      return 0;
  return 1;
}

/* Principal moments that a body can have, but for their rounding: with a tiny A the others may
   differ by a unit of their last place, which is many A, and no body is like that. */
static int possible(const long double m[3]) {
  return m[0] > 0 && m[2] - m[1] <= 2 * m[0];
}

static void tensor_of(const double *g, double I[6]) {
  memset(I, 0, 6 * sizeof *I);
#ifdef SYMMETRIC
  I[0] = I[1] = g[0], I[2] = g[1];
#else
  memcpy(I, g, BODY * sizeof *I);
#endif
}

static double short_h(const double *g) { /* 24 bits */
  int e;
  const double m = frexp(g[H], &e);
  return ldexp(floor(ldexp(m, 24)), e - 24);
}

static int prepare(const double *g) {
  real_type p[BODY], x0[7];
  double w[3], tensor[6], start[7];
  for (int i = 0; i < 3; i++)
    w[i] = g[W + i];
  if (!within(g, BODY < 3 ? BODY : 3, SCALE + 4, GRADED + 2) ||
      !within(w, 3, SCALE + 4, SLOW + 2) || !within(g + Q, 4, 4, 40))
    return 0;
  for (int i = 0; i < BODY; i++)
    p[i] = (real_type)g[i];
  tensor_of(g, tensor);
  for (int i = 0; i < 7; i++)
    start[i] = i < 4 ? g[Q + i] : g[W + i - 4], x0[i] = (real_type)start[i];
  const double h = short_h(g);
  if (SCENE(init)(&model, p) != 0 || ph_top_init_tensor(&top, 1, NULL, tensor) != 0)
    return 0;
#ifdef FULL /* a moment lost in rounding is not what the search is for */
  if (!(top.wide_moment[0] > top.wide_moment[2] * 0x1p-40L))
    return 0;
#endif
  if (!possible(top.wide_moment))
    return 0;
  if (SCENE(solve)(&orbit, &model, x0) != 0 || ph_free_top_solve(&exact, &top, start) != 0)
    return 0;
  return h > 0 && SCENE(set_tick)(&orbit, (real_type)h) == 0;
}

/* Principal moments of a turned tensor are pairs, right to 2^-100 (float: 2^-44) of the largest:
   relative to the least, to a small difference and to the distance from the separatrix, digits are
   gone before the motion begins, and each turn multiplies what is left. Diagonal tensors have exact
   moments. */
static double turned_digits(void) {
#ifdef FULL
  const ph_wide *m = top.wide_moment, most = m[2];
  double lost = (double)(most / m[0]);
  for (int i = 0; i < 2; i++)
    if (m[i + 1] - m[i] > most * 0x1p-60L)
      lost = fmax(lost, (double)(most / (m[i + 1] - m[i])));
  if (exact.kind == PH_FREE_SEPARATRIX)
    return HUGE_VAL;
  return exact.kind == PH_FREE_PERIODIC ? lost / exact.mc : lost;
#else
  return 1;
#endif
}

/* The time as a sum of two doubles. */
static pair when(const double *g) {
  return g[TICK] != 0 ? pair_product(short_h(g), g[N]) : pair_of(g[T]);
}

/* Not too many turns, which only the search bounds: a state of found.lua may have more. */
static int soon(const double *g, pair t) {
  const double rate = fmax(fabs(exact.precession), 4 / exact.period);
  const double turns = 1 + fabs((double)t.hi) * rate / 6.283;
  return fabs(g[N]) < 0x1p29 && turns * turned_digits() < exp2(TURNS) &&
         (DIGITS == 53 || fabs(g[T]) < 0x1p100);
}

static void evaluate(const double *g, double x[7]) {
  real_type y[7];
  if (g[TICK] != 0)
    SCENE(at_tick)(&orbit, (int64_t)g[N], y);
  else
    SCENE(at)(&orbit, (real_type)g[T], y);
  for (int i = 0; i < 7; i++)
    x[i] = (double)y[i];
}

#include "defect.h"

static double norm_error(const double *q) {
  long double n = 0;
  for (int i = 0; i < 4; i++)
    n += (long double)q[i] * q[i];
  return (double)fabsl(sqrtl(n) - 1);
}

static int measure(const double *g, double *error) {
  const pair t = when(g);
  ph_wide v[7], most = 0, dw = 0, plus = 0, minus = 0;
  double x[7];
  if (!soon(g, t))
    return 0;
  free_top_at_wide(&exact, t, v);
  evaluate(g, x);
  planted(g, x);
  for (int i = 0; i < 4; i++) {
    plus += (x[i] - v[i]) * (x[i] - v[i]);
    minus += (x[i] + v[i]) * (x[i] + v[i]);
  }
  for (int i = 4; i < 7; i++) {
    const ph_wide e = fabsl(x[i] - v[i]);
    most = fmaxl(most, fabsl(v[i]));
    dw = e <= dw ? dw : e;
  }
  error[RATES] = (double)(dw / most) / unit;
  error[ATTITUDE] = 2 * (double)sqrtl(minus < plus ? minus : plus) / unit;
  error[NORM] = norm_error(x) / unit;
  return 1;
}

/* *rates, *attitude of x against the oracle's v; the sign of q does not count. */
static void against(num v[7], const double x[7], double u, double *rates, double *attitude) {
  num most = real(0), dw = real(0), plus = real(0), minus = real(0);
  for (int i = 0; i < 7; i++) {
    num have = real(x[i < 3 ? i + 4 : i - 3]), e = size(sub(have, v[i]));
    if (i < 3) {
      most = larger(size(v[i]), most), dw = larger(e, dw);
    } else {
      plus = add(plus, square(e)), minus = add(minus, square(add(have, v[i])));
    }
  }
  num least = mpfr_cmp(minus, plus) < 0 ? minus : plus;
  *rates = mpfr_get_d(over(dw, most), MPFR_RNDN) / u;
  *attitude = 2 * mpfr_get_d(root(least), MPFR_RNDN) / u;
}

static int judge(const double *g, double *error) {
  const pair t = when(g);
  num v[7];
  double in[14] = {0}, x[7];
  if (!prepare(g))
    return 0;
  tensor_of(g, in);
  for (int i = 0; i < 7; i++)
    in[6 + i] = g[W + i];
  in[13] = (double)t.hi;
  used = 0;
  solve(in, v);
  evaluate(g, x);
  planted(g, x);
  against(v, x, unit, &error[RATES], &error[ATTITUDE]);
  error[NORM] = norm_error(x) / unit;
  if (free_top_at(&exact, t, x) != 0)
    return 0;
  against(v, x, 0x1p-53, &error[LIBRARY_RATES], &error[LIBRARY]);
  return 1;
}

int main(int argc, char **argv) {
  static const hunt_target target = {TARGET, DIGITS == 24, GENES,   3,       genes, ERRORS, errors,
                                     8,      draw,         prepare, measure, judge};
  unit = ldexp(1, -DIGITS);
  bits = BITS;
  pool = malloc(POOL * sizeof *pool);
  return pool ? hunt_main(&target, argc, argv) : 2;
}
