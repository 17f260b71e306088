/* sweep_exact.c -- sums of doubles without rounding, so that their order does not matter.
 * template: templates/sweep/sweep_exact.c.  SPDX-License-Identifier: MIT-0
 *
 * A sum is a whole number of units of 2^-1074, in words of 32 bits that may carry more for a while: U. Kulisch, W. L.
 * Miranker, Computer Arithmetic in Theory and Practice (1981).  Adding a double adds its 53 bits to three words. */
#include "sweep.h"

#include <math.h>
#include <string.h>

enum { SETTLE = 1 << 29 }; /* additions of 2^32 that a word of 64 bits holds beside a settled one, and more */

/* Carries: every word but the last into 0 .. 2^32 - 1, which makes the words those of one number alone. */
void sweep_sum_settle(sweep_sum *s)
{
  int64_t carry = 0;
  int i;

  for (i = 0; i < SWEEP_WORDS - 1; i++) {
    const int64_t whole = s->word[i] + carry, low = (int64_t)((uint64_t)whole & 0xFFFFFFFFU);

    carry = (whole - low)/4294967296; /* exact */
    s->word[i] = low;
  }
  s->word[SWEEP_WORDS - 1] += carry;
  s->pending = 0;
}

void sweep_sum_add(sweep_sum *s, double x)
{
  uint64_t u, fraction;
  int exponent, place, shift;
  int64_t part[3];

  memcpy(&u, &x, sizeof u);
  exponent = (int)(u >> 52 & 0x7FF);
  fraction = u & 0xFFFFFFFFFFFFFU;
  if (exponent > 0) fraction |= (uint64_t)1 << 52, exponent--;
  place = exponent/32; /* x = fraction 2^exponent units */
  shift = exponent%32;
  part[0] = (int64_t)((fraction & 0xFFFFFFFFU) << shift & 0xFFFFFFFFU);
  part[1] = (int64_t)((fraction << shift) >> 32 & 0xFFFFFFFFU);
  part[2] = shift > 0 ? (int64_t)(fraction >> (64 - shift)) : 0;
  if (u >> 63) {
    s->word[place] -= part[0];
    s->word[place + 1] -= part[1];
    s->word[place + 2] -= part[2];
  } else {
    s->word[place] += part[0];
    s->word[place + 1] += part[1];
    s->word[place + 2] += part[2];
  }
  if (++s->pending >= SETTLE) sweep_sum_settle(s);
}

/* x y = p + e without error: T. J. Dekker, Numer. Math. 18 (1971) 224-242, with Veltkamp's halves. */
void sweep_sum_product(sweep_sum *s, double x, double y)
{
  const double split = 134217729.0, p = x*y;
  const double cx = split*x, cy = split*y;
  const double xh = cx - (cx - x), yh = cy - (cy - y), xl = x - xh, yl = y - yh;

  sweep_sum_add(s, p);
  sweep_sum_add(s, ((xh*yh - p) + xh*yl + xl*yh) + xl*yl);
}

void sweep_sum_merge(sweep_sum *s, const sweep_sum *more)
{
  int i;

  sweep_sum_settle(s);
  for (i = 0; i < SWEEP_WORDS; i++) s->word[i] += more->word[i];
  sweep_sum_settle(s);
}

/* A sum becomes its size, words of 0 .. 2^32 - 1; was it negative? */
static int sized(sweep_sum *s)
{
  int i;

  sweep_sum_settle(s);
  if (s->word[SWEEP_WORDS - 1] >= 0) return 0;
  for (i = 0; i < SWEEP_WORDS; i++) s->word[i] = -s->word[i];
  sweep_sum_settle(s);
  return 1;
}

/* Word by word: each is a double. */
void sweep_sum_times(sweep_sum *s, double f, const sweep_sum *given)
{
  sweep_sum more = *given;
  const double way = sized(&more) ? -f : f;
  int i;

  for (i = 0; i < SWEEP_WORDS; i++) {
    if (more.word[i] != 0) sweep_sum_product(s, way, ldexp((double)more.word[i], 32*i - 1074));
  }
}

double sweep_sum_value(const sweep_sum *given)
{
  sweep_sum s = *given;
  uint64_t top, rest = 0;
  int i, last, negative, bit, k;

  negative = sized(&s);
  for (last = SWEEP_WORDS - 1; last >= 0 && s.word[last] == 0; last--) continue;
  if (last < 0) return 0.0;
  /* 64 bits from the first that is set, and whether anything follows */
  for (bit = 31; !(s.word[last] >> bit & 1); bit--) continue;
  top = (uint64_t)s.word[last] << (63 - bit);
  if (last > 0) top |= bit < 31 ? (uint64_t)s.word[last - 1] << (31 - bit) : (uint64_t)s.word[last - 1];
  if (last > 1 && bit < 31) {
    top |= (uint64_t)s.word[last - 2] >> (bit + 1);
    rest = (uint64_t)s.word[last - 2] & (((uint64_t)1 << (bit + 1)) - 1);
  } else if (last > 1) {
    rest = (uint64_t)s.word[last - 2];
  }
  for (i = last - 3; i >= 0; i--) rest |= (uint64_t)s.word[i];
  k = 32*last + bit; /* the first bit is worth 2^k units */
  if (k > 52) { /* to 53 bits, to even: what lies below the smallest double is none of the sum's */
    const uint64_t tail = top & 0x7FFU, half = 0x400U;

    top >>= 11;
    if (tail > half || (tail == half && (rest != 0 || (top & 1)))) top++;
    k -= 52;
  } else {
    top >>= 63 - k;
    k = 0;
  }
  return ldexp(negative ? -(double)top : (double)top, k - 1074); /* at most 2^53 2^k: exact, or beyond all doubles */
}
