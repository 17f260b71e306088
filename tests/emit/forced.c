/* forced.c - measures one emitted closed form of a motion with effects: part of forced.t, which
   judges. SPDX-License-Identifier: GPL-3.0-or-later

   expected.h (made by forced.t) has START, FULL, and rows of a time and a state, each number as the
   sum of two doubles. Prints "row TIME dw dq norm same": error of the rates over |w|, of the
   attitude as an angle, |q| - 1, and how far rates alone, attitude alone and many times are from
   the state at a time. */
#include "top.h"

#include "expected.h"

#include <math.h>
#include <stdio.h>

static double larger(double a, double b) {
  return b <= a ? a : b;
} /* a NaN stays */

int main(void) {
  top_real start[7];
  top_model m;
  top_orbit o;
  for (int i = 0; i < 7; i++)
    start[i] = (top_real)START[i];
  if (top_init(&m, 0) != 0 || top_solve(&o, &m, start) != 0) {
    printf("refused\n");
    return 1;
  }
  for (unsigned k = 0; k < sizeof expected / sizeof expected[0]; k++) {
    const top_real t = (top_real)expected[k].t;
    top_real x[7] = {0}, w[3];
    long double want[7], size = 0, dw = 0, plus = 0, minus = 0, norm = 0;
    double same = 0;
    for (int i = 0; i < 7; i++)
      want[i] = (long double)expected[k].x[i][0] + expected[k].x[i][1];
    top_at_rates(&o, t, w);
#if FULL
    top_real q[4], many[21], times[3] = {0, t, 1};
    top_at(&o, t, x);
    top_at_attitude(&o, t, q);
    top_at_many(&o, 3, times, many);
    for (int i = 0; i < 4; i++)
      same = larger(same, fabs((double)(x[i] - q[i])));
    for (int i = 0; i < 3; i++)
      same = larger(same, fabs((double)(x[4 + i] - w[i])));
    for (int i = 0; i < 7; i++)
      same = larger(same, fabs((double)(x[i] - many[3 * i + 1])));
    for (int i = 0; i < 4; i++) {
      plus += (x[i] - want[i]) * (x[i] - want[i]);
      minus += (x[i] + want[i]) * (x[i] + want[i]);
      norm += (long double)x[i] * x[i];
    }
#endif
    for (int i = 0; i < 3; i++) {
      size += want[4 + i] * want[4 + i];
      if (!(fabsl(w[i] - want[4 + i]) <= dw))
        dw = fabsl(w[i] - want[4 + i]);
    }
    printf("row %a %.3Le %.3Le %.3Le %.3e\n", expected[k].t, dw / sqrtl(size),
           2 * sqrtl(minus < plus ? minus : plus), FULL ? fabsl(sqrtl(norm) - 1) : 0, same);
  }
  return 0;
}
