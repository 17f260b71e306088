/* pair.h - sums and products with twice the digits of long double.
   SPDX-License-Identifier: GPL-3.0-or-later

   A number is the unevaluated sum hi + lo with |lo| at most half an ulp of hi. Differences of
   doubles are exact, and a determinant or the area of a polygon keeps some 60 bits after losing
   another 60 to cancellation: slivers, thin walls and far vertices then need no care. The
   error-free sum is Knuth's (TAOCP 2, 4.2.2, theorem B), the product Dekker's (Numer. Math. 18,
   1971) with the halves of Veltkamp. Needs no extended exponent, and no contraction of a*b + c. */
#ifndef PAIR_H
#define PAIR_H

#include "wide.h"

typedef struct pair {
  ph_wide hi, lo;
} pair;

static inline ph_wide pair_value(pair a) {
  return a.hi + a.lo;
}

static inline pair pair_of(ph_wide a) {
  return (pair){a, 0};
}

/* a + b exactly. */
static inline pair pair_sum(ph_wide a, ph_wide b) {
  const ph_wide s = a + b, v = s - a;
  return (pair){s, (a - (s - v)) + (b - v)};
}

/* The same for |a| >= |b|. */
static inline pair pair_tidy(ph_wide a, ph_wide b) {
  const ph_wide s = a + b;
  return (pair){s, b - (s - a)};
}

/* The upper half of the digits. */
static inline ph_wide pair_upper(ph_wide a) {
  const ph_wide c = a * (ph_wide)(1ULL << ((LDBL_MANT_DIG + 1) / 2)) + a;
  return c - (c - a);
}

/* a b exactly. */
static inline pair pair_product(ph_wide a, ph_wide b) {
  const ph_wide p = a * b, ah = pair_upper(a), bh = pair_upper(b), al = a - ah, bl = b - bh;
  return (pair){p, ((ah * bh - p) + ah * bl + al * bh) + al * bl};
}

static inline pair pair_negative(pair a) {
  return (pair){-a.hi, -a.lo};
}

static inline pair pair_add(pair a, pair b) {
  const pair s = pair_sum(a.hi, b.hi), t = pair_sum(a.lo, b.lo);
  const pair u = pair_tidy(s.hi, s.lo + t.hi);
  return pair_tidy(u.hi, u.lo + t.lo);
}

static inline pair pair_subtract(pair a, pair b) {
  return pair_add(a, pair_negative(b));
}

static inline pair pair_multiply(pair a, pair b) {
  const pair p = pair_product(a.hi, b.hi);
  return pair_tidy(p.hi, p.lo + (a.hi * b.lo + a.lo * b.hi));
}

/* a b for a plain number b. */
static inline pair pair_times(pair a, ph_wide b) {
  return pair_multiply(a, pair_of(b));
}

/* Two steps of long division: the second quotient's digits begin where the first one's end. */
static inline pair pair_divide(pair a, pair b) {
  const ph_wide q = a.hi / b.hi;
  const pair rest = pair_subtract(a, pair_times(b, q));
  return pair_tidy(q, pair_value(rest) / b.hi);
}

/* One step of Newton's method from the square root of the upper half. a >= 0. */
static inline pair pair_sqrt(pair a) {
  const ph_wide r = sqrtl(a.hi);
  if (!(r > 0))
    return pair_of(0);
  return pair_tidy(r, pair_value(pair_subtract(a, pair_product(r, r))) / (2 * r));
}

/* pi to 128 bits */
static inline pair pair_pi(void) {
  return (pair){0xc.90fdaa22168c235p-2L, -0xe.ce675d1fc8f8cbbp-68L};
}

/* a = n + rest with |rest| at most a half (and a rounding): the rest, and n in *whole, rounded
   where it has more than 64 bits. */
static inline pair pair_fraction(pair a, ph_wide *whole) {
  pair rest = a;
  *whole = 0;
  for (int i = 0; i < 3; i++) { /* 64 bits at a time */
    const ph_wide n = rintl(rest.hi);
    rest = pair_add(rest, pair_of(-n));
    *whole += n;
  }
  return rest;
}

/* a b - c d */
static inline pair pair_cross(pair a, pair b, pair c, pair d) {
  return pair_subtract(pair_multiply(a, b), pair_multiply(c, d));
}

/* a - b exactly, for doubles. */
static inline pair pair_difference(double a, double b) {
  return pair_sum((ph_wide)a, -(ph_wide)b);
}

#endif
