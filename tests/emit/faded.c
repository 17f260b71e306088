/* faded.c - asks one emitted closed form of a damped motion for states at any times of the type's
   range: part of faded.t, which judges. SPDX-License-Identifier: GPL-3.0-or-later

   scene.h (made by faded.t) has RATE, the moments and SINGLE. Prints how many states there were,
   and of how many something is no number, q is no unit quaternion, |L| is not |L(0)| exp(-rate t),
   and a limit is not reached. */
#include "top.h"

#include "scene.h"

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>

#if SINGLE
enum { DECADES = 8, TIMES = 37 };
#define LARGEST FLT_MAX
#define LEAST   FLT_MIN
#else
enum { DECADES = 30, TIMES = 307 };
#define LARGEST DBL_MAX
#define LEAST   DBL_MIN
#endif

static const double moments[3] = MOMENTS;

/* between -1 and 1: the upper bits of Knuth's MMIX generator */
static double random_part(void) {
  static uint64_t state = 1;
  state = state * 6364136223846793005U + 1442695040888963407U;
  return (double)(int64_t)state / 9223372036854775808.0;
}

static long double momentum(const top_real w[]) {
  long double sum = 0;
  for (int i = 0; i < 3; i++)
    sum += moments[i] * (long double)w[i] * (moments[i] * (long double)w[i]);
  return sqrtl(sum);
}

/* is |L| right? Rates below the least normal number are rounded to multiples of their own. */
static int right(const top_real w[], long double want) {
  const long double least = moments[0] < moments[2] ? moments[0] : moments[2];
  if (isinf(w[0]) || isinf(w[1]) || isinf(w[2]))
    return want * (1 + BAR) >= least * (long double)LARGEST;
  return fabsl(momentum(w) - want) <= BAR * want + 10 * (long double)LEAST * BAR;
}

int main(void) {
  int count = 0, none = 0, length = 0, wrong = 0, infinite = 0, off = 0;
  top_model m;
  if (top_init(&m, 0))
    return 1;
  for (int k = 0; k < 20000; k++) {
    const double size = pow(10, DECADES * random_part()),
                 when = pow(10, k % 2 ? 3 * random_part() : TIMES * fabs(random_part()));
    const top_real t = (top_real)(random_part() < 0 ? -when : when);
    top_real x[7], y[7];
    top_orbit o;
    for (int i = 0; i < 7; i++)
      x[i] = (top_real)((i < 4 ? 1 : size) * random_part());
    if (k % 5 == 0)
      x[4 + k % 3] = 0;
    if (k % 50 == 0)
      x[4] = x[5] = x[6] = 0;
    if (top_solve(&o, &m, x))
      return 1;
    top_at(&o, t, y);
    int nan = 0;
    long double norm = 0;
    for (int i = 0; i < 7; i++)
      nan = nan || isnan(y[i]);
    for (int i = 0; i < 4; i++)
      norm += (long double)y[i] * y[i];
    count++;
    none += nan;
    length += !(fabsl(sqrtl(norm) - 1) <= NORM);
    infinite += isinf(y[4]) || isinf(y[5]) || isinf(y[6]);
    const long double start = momentum(x + 4);
    wrong += !right(y + 4, start > 0 ? start * expl(-(long double)RATE * (long double)t) : 0);
    /* long after all rates have faded */
    top_real early[7], late[7];
    top_at(&o, (top_real)(200 / RATE), early);
    top_at(&o, RATE < 0 ? -LARGEST : LARGEST, late);
    for (int i = 0; i < 7; i++)
      off += i < 4 ? early[i] < late[i] || early[i] > late[i] : !(fabs((double)late[i]) <= 0);
  }
  printf("%d %d %d %d %d %d\n", count, none, length, wrong, infinite > 0, off);
  return 0;
}
