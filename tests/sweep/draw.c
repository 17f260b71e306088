/* draw.c - the random numbers, points and exact sums of a sweep's program; prints TAP; see draw.t.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Oracles: the published test vectors of Random123 (tests/kat_vectors of its distribution) and of
 * Joe and Kuo's Sobol' numbers, MPFR for the normal distribution, GMP's rationals for sums. */
#include <gmp.h>
#include <math.h>
#include <mpfr.h>
#include <stdlib.h>
#include <string.h>

#include "tap.h"

#include "sweep.h"

/* what sweep_stats.c and others call */
void sweep_say(const char *format, ...) {
  (void)format;
}

static void philox(void) {
  static const uint32_t vectors[3][10] = {
      {0, 0, 0, 0, 0, 0, 0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8},
      {0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff, 0x408f276d,
       0x41c83b0e, 0xa20bc7c6, 0x6d5451fd},
      {0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344, 0xa4093822, 0x299f31d0, 0xd16cfe09,
       0x94fdcceb, 0x5001e420, 0x24126ea1}};
  int good = 1;
  for (int i = 0; i < 3; i++) {
    uint32_t out[4];
    sweep_philox(vectors[i], vectors[i] + 4, out);
    good = good && memcmp(out, vectors[i] + 6, sizeof out) == 0;
  }
  ok(good, "Philox4x32-10 gives the three published vectors");
  /* the number that sweep_uniform makes of seed 1, member 2^32 + 7, draw 3, purpose 1 */
  const uint32_t counter[4] = {7, 1, 3, 1}, key[2] = {1, 0};
  uint32_t out[4];
  sweep_philox(counter, key, out);
  const uint64_t u = (uint64_t)out[1] << 32 | out[0];
  ok(sweep_uniform(1, (UINT64_C(1) << 32) + 7, 3, 1) == ldexp((double)(u >> 12) + 0.5, -52),
     "a uniform number is the middle of its 2^-52, counted by member, draw and purpose");
}

/* |z - true z|/|z| in units of 2^-53: the residue Phi(z) - u over the density, with 200 bits.
 * Phi(z) = erfc(-z/sqrt 2)/2, on the side where it is small. */
static double normal_error(double u) {
  const double z = sweep_normal(u);
  mpfr_t x, phi, density, size;
  mpfr_inits2(200, x, phi, density, size, (mpfr_ptr)0);
  const int upper = u > 0.5;
  mpfr_set_d(x, upper ? z : -z, MPFR_RNDN);
  mpfr_sqrt_ui(size, 2, MPFR_RNDN);
  mpfr_div(phi, x, size, MPFR_RNDN);
  mpfr_erfc(phi, phi, MPFR_RNDN);
  mpfr_div_ui(phi, phi, 2, MPFR_RNDN); /* the tail's weight */
  mpfr_sub_d(phi, phi, upper ? 1.0 - u : u, MPFR_RNDN);
  mpfr_sqr(density, x, MPFR_RNDN);
  mpfr_div_si(density, density, -2, MPFR_RNDN);
  mpfr_exp(density, density, MPFR_RNDN);
  mpfr_const_pi(size, MPFR_RNDN);
  mpfr_mul_ui(size, size, 2, MPFR_RNDN);
  mpfr_sqrt(size, size, MPFR_RNDN);
  mpfr_div(density, density, size, MPFR_RNDN);
  mpfr_div(phi, phi, density, MPFR_RNDN);
  const double error = fabs(mpfr_get_d(phi, MPFR_RNDN));
  mpfr_clears(x, phi, density, size, (mpfr_ptr)0);
  return error / fabs(z) * 9007199254740992.0;
}

/* Each polynomial has positive terms a_i r^i, and term i is rounded 2 i + 1 times at most: over r
 * up to 0.18, where the mean of i weighted by the terms is 2.9 in both, that is less than 7
 * roundings each.  The quotient, the last product, what r was rounded to and Wichura's own 1e-16
 * make 2 more: 16. */
#define NORMAL_LIMIT 16.0

static void normal(int count) {
  double worst = 0, at = 0;
  for (int i = 0; i < count; i++) {
    double u = sweep_uniform(5, (uint64_t)i, 0, 1);
    if (i % 4 == 1)
      u = ldexp(u, -(i / 4 % 50)); /* the lower tail */
    if (i % 4 == 3)
      u = 1.0 - ldexp(floor(ldexp(u, 52 - i / 4 % 45)) + 0.5, -52); /* and the upper */
    if (!(u > 0 && u < 1) || u == 0.5)
      continue;
    const double e = normal_error(u);
    if (e > worst) {
      worst = e;
      at = u;
    }
  }
  diag("the worst error is %.2f roundings, at u = %.17g", worst, at);
  ok(worst <= NORMAL_LIMIT, "normal deviates are the inverse of the distribution to %g roundings",
     NORMAL_LIMIT);
  const double least = ldexp(0.5, -52), most = 1.0 - least;
  ok(sweep_normal(least) == -sweep_normal(most) && normal_error(least) <= NORMAL_LIMIT &&
         isfinite(sweep_normal(least)) && sweep_normal(0.5) == 0,
     "the first and the last uniform number give finite deviates, opposite; the middle gives 0");
  int ascending = 1;
  for (double u = 0.07; u < 0.08; u = nextafter(u + 1e-6, 1)) /* over the border at 0.075 */
    ascending = ascending && sweep_normal(u) < sweep_normal(u + 1e-6);
  ok(ascending, "deviates ascend over the border of two approximations");
}

static void sobol(void) {
  static const uint32_t fifth[7] = {0xa0000000, 0x20000000, 0xe0000000, 0xa0000000,
                                    0xa0000000, 0xe0000000, 0x20000000};
  static const uint32_t thousandth[7] = {0x17c00000, 0x29400000, 0x73400000, 0xe8c00000,
                                         0xfe400000, 0x29c00000, 0x04400000};
  int good = 1, even = 1;
  for (int d = 0; d < 7; d++)
    good = good && sweep_sobol(5, d) == fifth[d] && sweep_sobol(1000, d) == thousandth[d];
  ok(good, "points 5 and 1000 of Sobol's sequence are Joe and Kuo's in seven dimensions");
  for (int d = 0; d < SWEEP_SOBOL_MOST; d++) { /* each dimension is a (0, 1)-sequence */
    char seen[4096] = {0};
    for (uint64_t i = 0; i < 4096; i++)
      seen[sweep_sobol(i, d) >> 20]++;
    for (int i = 0; i < 4096; i++)
      even = even && seen[i] == 1;
  }
  ok(even, "each dimension has one of the first 4096 points in each 4096th");
}

static void permutation(void) {
  static const uint64_t sizes[] = {1, 2, 3, 5, 64, 1000, 4097};
  int good = 1;
  for (int s = 0; s < 7; s++) {
    char *seen = calloc(sizes[s], 1);
    uint64_t fixed = 0;
    for (uint64_t i = 0; i < sizes[s]; i++) {
      const uint64_t to = sweep_permuted(9, 2, i, sizes[s]);
      good = good && to < sizes[s] && !seen[to];
      seen[to < sizes[s] ? to : 0] = 1;
      fixed += to == i;
    }
    good = good && (sizes[s] < 64 || fixed < 12); /* one is expected: 12 has probability 1e-9 */
    free(seen);
  }
  ok(good, "the keyed permutation takes every number to another one, of any count");
}

/* ---- sums ---- */

static double drawn(uint64_t i, uint32_t what, int range) {
  const double u = sweep_uniform(3, i, what, 1) - 0.5;
  const double e = (sweep_uniform(3, i, what, 2) - 0.5) * range;
  return ldexp(u, (int)e);
}

/* The rational rounded to the nearest double. */
static double rounded(const mpq_t q) {
  mpfr_t x;
  mpfr_init2(x, 53);
  mpfr_set_q(x, q, MPFR_RNDN);
  const double r = mpfr_get_d(x, MPFR_RNDN);
  mpfr_clear(x);
  return r;
}

static void sums(int range, const char *name) {
  enum { N = 2000 };
  sweep_sum a = {{0}, 0}, b = {{0}, 0}, parts[3] = {{{0}, 0}};
  mpq_t sum, term, squares;
  mpq_inits(sum, term, squares, (mpq_ptr)0);
  sweep_sum product = {{0}, 0};
  for (int i = 0; i < N; i++) {
    const double x = drawn((uint64_t)i, 0, range), y = drawn((uint64_t)i, 1, range);
    sweep_sum_add(&a, x);
    sweep_sum_add(&parts[i % 3], x);
    sweep_sum_add(&b, drawn((uint64_t)(N - 1 - i), 0, range));
    sweep_sum_product(&product, x, y);
    mpq_set_d(term, x);
    mpq_add(sum, sum, term);
    mpq_t other;
    mpq_init(other);
    mpq_set_d(other, y);
    mpq_mul(term, term, other);
    mpq_add(squares, squares, term);
    mpq_clear(other);
  }
  sweep_sum_merge(&parts[0], &parts[2]);
  sweep_sum_merge(&parts[0], &parts[1]);
  sweep_sum_settle(&a);
  sweep_sum_settle(&b);
  ok(sweep_sum_value(&a) == rounded(sum), "%s: a sum is the exact one, rounded once", name);
  ok(memcmp(a.word, b.word, sizeof a.word) == 0 &&
         memcmp(a.word, parts[0].word, sizeof a.word) == 0,
     "%s: backwards, and in three parts, the words are the same", name);
  ok(sweep_sum_value(&product) == rounded(squares), "%s: so is a sum of products", name);
  mpq_clears(sum, term, squares, (mpq_ptr)0);
}

static void ends(void) {
  sweep_sum s = {{0}, 0};
  ok(sweep_sum_value(&s) == 0, "an empty sum is 0");
  sweep_sum_add(&s, 5e-324);
  ok(sweep_sum_value(&s) == 5e-324, "the smallest number is kept");
  sweep_sum_add(&s, 1.7976931348623157e308);
  sweep_sum_add(&s, -1.7976931348623157e308);
  sweep_sum_add(&s, -1e-323);
  ok(sweep_sum_value(&s) == -5e-324, "beside the largest, which goes again");
  sweep_sum tie = {{0}, 0};
  sweep_sum_add(&tie, 9007199254740992.0);
  sweep_sum_add(&tie, 1.0);
  ok(sweep_sum_value(&tie) == 9007199254740992.0, "a tie goes to the even number");
  sweep_sum_add(&tie, 5e-324);
  ok(sweep_sum_value(&tie) == 9007199254740994.0, "and anything beyond it does not");
}

int main(int argc, char **argv) {
  philox();
  normal(argc > 1 ? atoi(argv[1]) : 200000);
  sobol();
  permutation();
  sums(40, "numbers of like size");
  sums(900, "numbers of all sizes");
  ends();
  return tap_done();
}
