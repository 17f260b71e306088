/* libm.c - the hunt's target: the emitted code's own mathematical functions.
   SPDX-License-Identifier: GPL-3.0-or-later

     libm --sweep STRIDE     float only: every STRIDE-th of all 2^32 arguments of each function of
                             one argument, against the C library's double; 1 is all of them

   Errors are in units of the last place of the result, in the subnormal range of the smallest
   number. Where both are no number, or both infinite, there is none. The fast oracle is the C
   library in the next longer type, the slow one MPFR. */
#include "search.h"

#include <math.h>
#include <mpfr.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifdef SINGLE
typedef float own_real;
typedef double wide;
enum { DIGITS = 24, LEAST = -149, HIGH = 127 };
#define WIDE(f) f
#else
typedef double own_real;
typedef long double wide;
enum { DIGITS = 53, LEAST = -1074, HIGH = 1023 };
#define WIDE(f) f##l
#endif
#include "own.h"

enum { SIN, COS, TAN, ASIN, ACOS, ATAN, EXP, LOG, SINH, COSH, TANH, CBRT, ATAN2, POW, ERRORS };

#define ONE(f)                                                                                     \
  { #f, own_##f, WIDE(f), mpfr_##f }
static const struct {
  const char *name;
  own_real (*own)(own_real);
  wide (*near)(wide);
  int (*far)(mpfr_t, const mpfr_t, mpfr_rnd_t);
} unary[] = {ONE(sin), ONE(cos), ONE(tan),  ONE(asin), ONE(acos), ONE(atan),
             ONE(exp), ONE(log), ONE(sinh), ONE(cosh), ONE(tanh), ONE(cbrt)};
enum { UNARY = sizeof unary / sizeof unary[0] };

static const hunt_gene genes[] = {{"x", HUNT_SIGNED, 0}, {"y", HUNT_SIGNED, 0}};

/* docs/emitted.md: 1.5 is the promise. */
static const hunt_error errors[] = {
    {"sin", 1.5, 0},  {"cos", 1.5, 0},  {"tan", 1.5, 0},   {"asin", 1.5, 0}, {"acos", 1.5, 0},
    {"atan", 1.5, 0}, {"exp", 1.5, 0},  {"log", 1.5, 0},   {"sinh", 1.5, 0}, {"cosh", 1.5, 0},
    {"tanh", 1.5, 0}, {"cbrt", 1.5, 0}, {"atan2", 1.5, 0}, {"pow", 1.5, 0}};

static double argument(hunt_random *r) {
  const int single = DIGITS == 24;
  const double x = hunt_sign(r) * hunt_mantissa(r, single);
  switch (hunt_below(r, 5)) {
  case 0:
    return x * hunt_size(r, LEAST, HIGH);
  case 1:
    return hunt_sign(r) * hunt_near_one(r, single);
  case 2: /* next to a multiple of pi/2 */
    return hunt_sign(r) * floor(hunt_size(r, 0, DIGITS - 2)) * 1.5707963267948966 *
           hunt_near_one(r, single);
  default:
    return x * hunt_size(r, -12, 10);
  }
}

static void draw(hunt_random *r, double *g) {
  g[0] = argument(r);
  g[1] = argument(r);
  if (hunt_chance(r, 0.3)) /* x^y is a number */
    g[0] = fabs(g[0]), g[1] = hunt_sign(r) * hunt_uniform(r) * HIGH / fabs(log2(g[0]) + 1e-3);
}

static int prepare(const double *g) {
  return isfinite(g[0]) && isfinite(g[1]) && fabs(g[0]) < ldexp(1, HIGH) &&
         fabs(g[1]) < ldexp(1, HIGH);
}

/* have against want, which has more digits */
static double ulps(own_real have, wide want) {
  const own_real rounded = (own_real)want;
  int e;
  if (isnan(want) || isnan(have))
    return isnan(want) && isnan(have) ? 0 : HUGE_VAL;
  if (isinf(rounded) || isinf(have) || want == 0)
    return have == rounded ? 0 : HUGE_VAL;
  frexp((double)rounded, &e);
  e = e - DIGITS > LEAST ? e - DIGITS : LEAST;
  return (double)WIDE(ldexp)(WIDE(fabs)((wide)have - want), -e);
}

static int measure(const double *g, double *error) {
  const own_real x = (own_real)g[0], y = (own_real)g[1];
  for (int i = 0; i < UNARY; i++)
    error[i] = ulps(unary[i].own(x), unary[i].near((wide)x));
  error[ATAN2] = ulps(own_atan2(x, y), WIDE(atan2)((wide)x, (wide)y));
  error[POW] = ulps(own_pow(x, y), WIDE(pow)((wide)x, (wide)y));
  return 1;
}

static mpfr_t X, Y, Z, D;

static double judged(own_real have) {
  const double want = mpfr_get_d(Z, MPFR_RNDN);
  const own_real rounded = (own_real)want;
  int e;
  if (isnan(want) || isnan(have) || isinf(rounded) || isinf(have) || want == 0)
    return ulps(have, (wide)want);
  frexp((double)rounded, &e);
  e = e - DIGITS > LEAST ? e - DIGITS : LEAST;
  mpfr_set_d(D, (double)have, MPFR_RNDN);
  mpfr_sub(D, D, Z, MPFR_RNDN);
  return ldexp(fabs(mpfr_get_d(D, MPFR_RNDN)), -e);
}

static int judge(const double *g, double *error) {
  const own_real x = (own_real)g[0], y = (own_real)g[1];
  mpfr_set_d(X, g[0], MPFR_RNDN);
  mpfr_set_d(Y, g[1], MPFR_RNDN);
  for (int i = 0; i < UNARY; i++) {
    unary[i].far(Z, X, MPFR_RNDN);
    error[i] = judged(unary[i].own(x));
  }
  mpfr_atan2(Z, X, Y, MPFR_RNDN);
  error[ATAN2] = judged(own_atan2(x, y));
  mpfr_pow(Z, X, Y, MPFR_RNDN);
  error[POW] = judged(own_pow(x, y));
  return 1;
}

#ifdef SINGLE
static void sweep(uint64_t stride) {
  for (int i = 0; i < UNARY; i++) {
    double worst = 0;
    float at = 0;
    for (uint64_t u = 0; u < (uint64_t)1 << 32; u += stride) {
      const uint32_t bits = (uint32_t)u;
      float x;
      memcpy(&x, &bits, sizeof x);
      const double e = ulps(unary[i].own(x), unary[i].near((double)x));
      if (!(e <= worst))
        worst = e, at = x;
    }
    printf("sweep %s %llu %.4f %a\n", unary[i].name, (unsigned long long)stride, worst, (double)at);
    fflush(stdout);
  }
}
#endif

int main(int argc, char **argv) {
  static const hunt_target target = {"libm", DIGITS == 24, 2,       1,       genes, ERRORS, errors,
                                     1,      draw,         prepare, measure, judge};
#ifdef SINGLE
  if (argc == 3 && strcmp(argv[1], "--sweep") == 0) {
    sweep(strtoull(argv[2], NULL, 10));
    return 0;
  }
#endif
  mpfr_init2(X, 53);
  mpfr_init2(Y, 53);
  mpfr_init2(Z, 180);
  mpfr_init2(D, 180);
  return hunt_main(&target, argc, argv);
}
