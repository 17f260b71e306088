/* long.c - many steps of an emitted stepper: part of midpoint.t and semi.t, which judge.
   SPDX-License-Identifier: GPL-3.0-or-later

   Arguments: step, number of steps. STEP is the stepper, HEAVY the torque M g r of a weight on the
   body's z (gravity along -z of space), or 0. What is conserved is formed here, with long doubles,
   from the tensor. Prints:
     L      largest |L - L0|/|L0| in inertial axes        Lz     the same of the third component
     first, second   least and largest (E - E0)/|E0| of each half of the run
     norm   largest ||q| - 1|
     back   |x - x0|, largest component over |w|, after as many steps back
     rate   largest |w - w0|                                finite 1 if all numbers were */
#include "top.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static void invariants(const long double I[6], const top_real x[], long double L[3],
                       long double *E) {
  const long double w[3] = {x[TOP_WX], x[TOP_WY], x[TOP_WZ]};
  const long double n =
      1 / sqrtl((long double)x[TOP_QW] * x[TOP_QW] + (long double)x[TOP_QX] * x[TOP_QX] +
                (long double)x[TOP_QY] * x[TOP_QY] + (long double)x[TOP_QZ] * x[TOP_QZ]);
  const long double a = n * x[TOP_QW], b = n * x[TOP_QX], c = n * x[TOP_QY], d = n * x[TOP_QZ];
  const long double l[3] = {I[0] * w[0] + I[3] * w[1] + I[4] * w[2],
                            I[3] * w[0] + I[1] * w[1] + I[5] * w[2],
                            I[4] * w[0] + I[5] * w[1] + I[2] * w[2]};
  const long double k[3] = {l[0] + ROTOR_X, l[1], l[2] + ROTOR_Z};
  L[0] = (1 - 2 * (c * c + d * d)) * k[0] + 2 * (b * c - a * d) * k[1] + 2 * (b * d + a * c) * k[2];
  L[1] = 2 * (b * c + a * d) * k[0] + (1 - 2 * (b * b + d * d)) * k[1] + 2 * (c * d - a * b) * k[2];
  L[2] = 2 * (b * d - a * c) * k[0] + 2 * (c * d + a * b) * k[1] + (1 - 2 * (b * b + c * c)) * k[2];
  *E = (l[0] * w[0] + l[1] * w[1] + l[2] * w[2]) / 2 + HEAVY * (1 - 2 * (b * b + c * c));
}

static long double larger(long double a, long double b) {
  return b <= a ? a : b;
} /* a NaN stays */

int main(int argc, char **argv) {
  top_real x[7], x0[7];
  top_model m;
  const top_real h = (top_real)atof(argv[1]);
  const long steps = argc > 2 ? atol(argv[2]) : 0;
  long double I[6], L0[3], L[3], E0, E, size, worst = 0, worst_z = 0, low[2] = {0, 0},
                                              high[2] = {0, 0}, norm = 0;
  long double back = 0, rate = 0, wide = 0;
  top_real tensor[6];
  int finite = 1;

  if (top_init(&m, 0) != 0)
    return 1;
  top_inertia(&m, tensor);
  for (int i = 0; i < 6; i++)
    I[i] = tensor[i];
  top_initial(&m, x);
  for (int i = 0; i < 7; i++)
    x0[i] = x[i];
  invariants(I, x, L0, &E0);
  size = sqrtl(L0[0] * L0[0] + L0[1] * L0[1] + L0[2] * L0[2]);
  for (int i = 0; i < 3; i++)
    wide = larger(wide, fabsl((long double)x0[TOP_WX + i]));
  for (long k = 0; k < steps; k++) {
    const int half = k >= steps / 2;

    STEP(&m, (top_real)k * h, x, 0, h);
    invariants(I, x, L, &E);
    for (int i = 0; i < 3; i++)
      worst = larger(worst, fabsl(L[i] - L0[i]) / (size > 0 ? size : 1));
    worst_z = larger(worst_z, fabsl(L[2] - L0[2]) / (size > 0 ? size : 1));
    E = (E - E0) / (E0 != 0 ? fabsl(E0) : 1);
    if (!(E >= low[half]))
      low[half] = E;
    if (!(E <= high[half]))
      high[half] = E;
    norm = larger(norm, fabsl(sqrtl((long double)x[0] * x[0] + (long double)x[1] * x[1] +
                                    (long double)x[2] * x[2] + (long double)x[3] * x[3]) -
                              1));
    for (int i = 0; i < 3; i++)
      rate = larger(rate, fabsl((long double)x[TOP_WX + i] - x0[TOP_WX + i]));
    for (int i = 0; i < 7; i++)
      finite = finite && x[i] - x[i] == 0;
  }
  for (long k = steps; k > 0; k--)
    STEP(&m, (top_real)k * h, x, 0, -h);
  for (int i = 0; i < 7; i++)
    back = larger(back, fabsl((long double)x[i] - x0[i]) / (i >= TOP_WX && wide > 0 ? wide : 1));
  printf("L=%.3Le Lz=%.3Le first=%.3Le:%.3Le second=%.3Le:%.3Le norm=%.3Le back=%.3Le rate=%.3Le "
         "finite=%d\n",
         worst, worst_z, low[0], high[0], low[1], high[1], norm, back, rate, finite);
  return 0;
}
