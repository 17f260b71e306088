/* elliptic_jacobi.c - Jacobi's sn, cn, dn in long double, complete integrals in pairs.
   SPDX-License-Identifier: GPL-3.0-or-later

   Descending Landen transformation by the arithmetic-geometric mean, started from k' so that
   1 - m is never formed (Bulirsch, Numer. Math. 7, 1965). The way back is done on cn/sn, which
   stays positive on (0, K): no arcsine, no difference. Beyond K/2 the reflection K - u gives cn and
   dn their relative accuracy where they are small. */
#include "elliptic.h"

/* The mean of any two long doubles: 15 steps for the exponent, 6 for the digits. */
enum { LANDEN = 32 };

static void forward(ph_wide u, ph_wide kc, ph_wide *sn, ph_wide *cn, ph_wide *dn) {
  /* below 2^-33 the next terms of the series, u^2/6 and smaller, are below half an ulp; the cosines
     keep theirs */
  if (u < 0x1p-33L) {
    *sn = u, *cn = 1 - u * u / 2, *dn = 1 - (1 - kc) * (1 + kc) * u * u / 2;
    return;
  }
  ph_wide mean[LANDEN], root[LANDEN], a = 1, b = kc;
  int n = 0;
  for (;; n++) {
    mean[n] = a, root[n] = b;
    if (n == LANDEN - 1 || fabsl(a - b) <= 0x1p-40L * a)
      break;
    b = sqrtl(a * b);
    a = (mean[n] + root[n]) / 2;
  }
  /* c = a_n cs(u a_n; k_n), from the circle at the bottom upward; d = dn there */
  const ph_wide angle = u * (mean[n] + root[n]) / 2;
  ph_wide cs = cosl(angle) / sinl(angle), c = cs * (mean[n] + root[n]) / 2, d = 1;
  for (; n >= 0; n--) {
    const ph_wide square = cs * c;
    c *= d;
    d = (root[n] + square) / (mean[n] + square);
    cs = c / mean[n];
  }
  *sn = 1 / sqrtl(1 + c * c);
  *cn = c * *sn;
  *dn = d;
}

void elliptic_sncndn(pair arg, pair K, ph_wide kc, ph_wide *sn, ph_wide *cn, ph_wide *dn) {
  const ph_wide u = pair_value(arg), size = fabsl(u);
  if (kc == 0) {
    *sn = tanhl(u);
    *cn = *dn = 1 / coshl(u);
    return;
  }
  if (size <= K.hi / 2) {
    forward(size, kc, sn, cn, dn);
  } else {
    /* DLMF 22.4: sn(K - v) = cn v/dn v, cn(K - v) = k' sn v/dn v, dn(K - v) = k'/dn v */
    ph_wide s, c, d;
    const ph_wide left = pair_value(pair_subtract(K, u < 0 ? pair_negative(arg) : arg));
    forward(fabsl(left), kc, &s, &c, &d);
    *sn = c / d;
    *cn = copysignl(kc * s / d, left);
    *dn = kc / d;
  }
  *sn = copysignl(*sn, u);
}

/* ---- complete integrals ---- */

/* Convergence is quadratic: when the upper halves of the means agree, the value formed from them is
   right to the last bit of a pair. p need not converge: at equal means the last line is exact for
   every p. All terms are positive. */
pair elliptic_cel(pair kc, pair p, pair a, pair b) {
  pair root = pair_sqrt(p), mean = pair_of(1), e = kc, k = kc;
  b = pair_divide(b, root);
  for (int n = 0; n < LANDEN; n++) {
    const pair f = a, g = pair_divide(e, root), last = mean;
    a = pair_add(a, pair_divide(b, root));
    b = pair_times(pair_add(b, pair_multiply(f, g)), 2);
    root = pair_add(g, root);
    mean = pair_add(k, mean);
    if (fabsl(last.hi - k.hi) <= 0x1p-64L * last.hi)
      break;
    k = pair_times(pair_sqrt(e), 2);
    e = pair_multiply(k, mean);
  }
  const pair above = pair_add(b, pair_multiply(a, mean));
  const pair below = pair_times(pair_multiply(mean, pair_add(mean, root)), 2);
  return pair_divide(pair_multiply(pair_pi(), above), below);
}

/* pi / (2 M(1, k')) */
pair elliptic_k(pair kc) {
  pair a = pair_of(1), b = kc;
  for (int n = 0; n < LANDEN && fabsl(a.hi - b.hi) > 0x1p-64L * a.hi; n++) {
    const pair g = pair_sqrt(pair_multiply(a, b));
    a = pair_times(pair_add(a, b), 0.5L);
    b = g;
  }
  return pair_divide(pair_pi(), pair_add(a, b)); /* one more mean */
}
