/* side.c - float and double of one scene in one program; NAME_normalise of both, with long double
   as the judge. SPDX-License-Identifier: GPL-3.0-or-later

   Prints words and numbers: how far the two are apart after 100 steps, each energy's change, then
   for each type the worst error of |q| and of a component in epsilons over random quaternions of
   all sizes, and what was wrong with those that are to be refused. */
#include "wide.h"
#include "small.h"

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

static uint64_t seed = 88172645463325252u; /* Marsaglia's xorshift */
static double uniform(void) {
  seed ^= seed << 13;
  seed ^= seed >> 7;
  seed ^= seed << 17;
  return (double)(seed >> 11) * 0x1p-53;
}

static void together(void) {
  wide_model d;
  small_model f;
  double x[WIDE_NX], worst = 0;
  float y[SMALL_NX];
  if (wide_init(&d, 0) != 0 || small_init(&f, 0) != 0)
    return;
  wide_initial(&d, x);
  small_initial(&f, y);
  const double E = wide_energy(&d, x);
  const float e = small_energy(&f, y);
  for (int i = 0; i < 100; i++) {
    wide_step(&d, 0, x, 0, 0.001);
    small_step(&f, 0, y, 0, 0.001F);
  }
  for (int i = 0; i < WIDE_NX; i++)
    worst = fmax(worst, fabs(x[i] - (double)y[i]));
  printf("apart %.3g\nenergy %.3g %.3g\n", worst, fabs(wide_energy(&d, x) / E - 1),
         fabs((double)(small_energy(&f, y) / e) - 1));
}

#define JUDGE(NAME, REAL, NX, QW, EPSILON, EXPONENTS)                                              \
  static void judge_##NAME(void) {                                                                 \
    long double norm = 0, part = 0;                                                                \
    const REAL special[] = {0, (REAL)INFINITY, (REAL)-INFINITY, (REAL)NAN};                        \
    int wrong = 0;                                                                                 \
    for (int n = 0; n < 200000; n++) {                                                             \
      REAL x[NX] = {0};                                                                            \
      long double q[4], s = 0, got = 0;                                                            \
      const int spread = n % 4 == 0 ? EXPONENTS : n % 4 == 1 ? 8 : 0;                              \
      const int middle = n % 3 == 0 ? 0 : (int)((uniform() - 0.5) * 2 * (EXPONENTS - spread));     \
      for (int i = 0; i < 4; i++) {                                                                \
        const int e = middle + (int)((uniform() - 0.5) * 2 * spread);                              \
        x[QW + i] = (REAL)ldexp(2 * uniform() - 1, e);                                             \
        q[i] = x[QW + i];                                                                          \
        s += q[i] * q[i];                                                                          \
      }                                                                                            \
      wrong += NAME##_normalise(x) != 0;                                                           \
      for (int i = 0; i < 4; i++) {                                                                \
        const long double want = q[i] / sqrtl(s), is = x[QW + i];                                  \
        got += is * is;                                                                            \
        if (fabsl(want) > EPSILON * EPSILON)                                                       \
          part = fmaxl(part, fabsl(is / want - 1));                                                \
      }                                                                                            \
      norm = fmaxl(norm, fabsl(sqrtl(got) - 1));                                                   \
    }                                                                                              \
    for (int n = 0; n < 16; n++) {                                                                 \
      REAL x[NX], y[NX];                                                                           \
      for (int i = 0; i < NX; i++)                                                                 \
        x[i] = n < 4 ? 0 : 1;                                                                      \
      x[QW + n % 4] = special[n / 4];                                                              \
      memcpy(y, x, sizeof x);                                                                      \
      wrong += NAME##_normalise(x) != 1 || memcmp(x, y, sizeof x) != 0;                            \
    }                                                                                              \
    printf(#NAME " %.3Lf %.3Lf %d\n", norm / EPSILON, part / EPSILON, wrong);                      \
  }
/* exponents: no square of what is asked leaves long double's range */
JUDGE(wide, double, WIDE_NX, WIDE_QW, DBL_EPSILON, 1020)
JUDGE(small, float, SMALL_NX, SMALL_QW, FLT_EPSILON, 120)

int main(void) {
  together();
  judge_wide();
  judge_small();
  return 0;
}
