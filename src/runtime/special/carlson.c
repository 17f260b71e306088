/* carlson.c - Carlson's symmetric elliptic integrals in long double.
   SPDX-License-Identifier: GPL-3.0-or-later

   Duplication until the arguments agree to 3e-4, then the Taylor series to degree 5 (DLMF 19.36.1,
   19.36.2): what is left out is below (3e-4)^6 < 2^-70. Each duplication divides the distance by 4
   once the arguments are of one size, and halves the logarithm of a ratio before that; 48 of them
   (the bound of every loop) bring any two long doubles together. All sums are of positive terms, so
   an integral comes out to a few ulp of long double. */
#include "elliptic.h"

enum { LIMIT = 48 };
static const ph_wide NEAR = 3e-4L;

static ph_wide farthest(int n, const ph_wide v[], ph_wide mean) {
  ph_wide d = 0;
  for (int i = 0; i < n; i++)
    d = fmaxl(d, fabsl(v[i] - mean));
  return d;
}

ph_wide carlson_rf(ph_wide x, ph_wide y, ph_wide z) {
  ph_wide v[3] = {x, y, z}, mean = 0;
  for (int n = 0; n < LIMIT; n++) {
    mean = (v[0] + v[1] + v[2]) / 3;
    if (farthest(3, v, mean) <= NEAR * mean)
      break;
    const ph_wide a = sqrtl(v[0]), b = sqrtl(v[1]), c = sqrtl(v[2]), step = a * b + a * c + b * c;
    for (int i = 0; i < 3; i++)
      v[i] = (v[i] + step) / 4;
  }
  const ph_wide X = 1 - v[0] / mean, Y = 1 - v[1] / mean, Z = -X - Y;
  const ph_wide e2 = X * Y - Z * Z, e3 = X * Y * Z;
  return (1 - e2 / 10 + e3 / 14 + e2 * e2 / 24 - 3 * e2 * e3 / 44) / sqrtl(mean);
}

/* Elementary (DLMF 19.2.18, 19.2.19). y - x is taken once, so rounding in it moves the argument of
   an even function, and the value, by as much. */
ph_wide carlson_rc(ph_wide x, ph_wide y) {
  const ph_wide d = fabsl(y - x), r = sqrtl(d);
  if (d == 0)
    return 1 / sqrtl(x);
  if (y > x)
    return atan2l(r, sqrtl(x)) / r;
  return y > x / 2 ? atanhl(r / sqrtl(x)) / r : logl((sqrtl(x) + r) / sqrtl(y)) / r;
}

/* Carlson, Numer. Algorithms 10 (1995), 13. His 1 + e_n, a difference when p is small, is written
   as the quotient 2 sqrt(p) (p + lambda) / d_n that it equals (his algorithm of 1979). */
ph_wide carlson_rj(ph_wide x, ph_wide y, ph_wide z, ph_wide p) {
  ph_wide v[4] = {x, y, z, p}, mean = 0, sum = 0, weight = 1;
  for (int n = 0; n < LIMIT; n++) {
    mean = (v[0] + v[1] + v[2] + 2 * v[3]) / 5;
    if (farthest(4, v, mean) <= NEAR * mean)
      break;
    const ph_wide a = sqrtl(v[0]), b = sqrtl(v[1]), c = sqrtl(v[2]), r = sqrtl(v[3]);
    const ph_wide step = a * b + a * c + b * c, d = (r + a) * (r + b) * (r + c);
    sum += weight / d * carlson_rc(1, 2 * r * (v[3] + step) / d);
    for (int i = 0; i < 4; i++)
      v[i] = (v[i] + step) / 4;
    weight /= 4;
  }
  const ph_wide X = 1 - v[0] / mean, Y = 1 - v[1] / mean, Z = 1 - v[2] / mean;
  const ph_wide P = -(X + Y + Z) / 2, xyz = X * Y * Z;
  const ph_wide e2 = X * Y + X * Z + Y * Z - 3 * P * P, e3 = xyz + 2 * e2 * P + 4 * P * P * P;
  const ph_wide e4 = (2 * xyz + e2 * P + 3 * P * P * P) * P, e5 = xyz * P * P;
  const ph_wide series =
      1 - 3 * e2 / 14 + e3 / 6 + 9 * e2 * e2 / 88 - 3 * e4 / 22 - 9 * e2 * e3 / 52 + 3 * e5 / 26;
  return weight * series / (mean * sqrtl(mean)) + 6 * sum;
}

ph_wide carlson_rd(ph_wide x, ph_wide y, ph_wide z) {
  return carlson_rj(x, y, z, z);
}
