/* q31.c - runs an emitted fixed-point step on the host, for tests/emit/q31.t.
   SPDX-License-Identifier: GPL-3.0-or-later

   run N qw .. wz [ux uy uz]: N steps from a real state; prints the real state and all bits.
   hash N: N steps, each from words at random, a tenth of them anything; prints a hash of all words
   and bits.
   free N: N motions of 400 steps from states within the range at random; prints all bits.
   remainders I E K LIMIT: from_real and to_real of component I, unit 2^-E, remainders of 2^-K of
   it: at both limits and between, every remainder and what lies between two; prints how many
   values, how many words or remainders that a step would not leave or read otherwise, how many that
   are not the nearest.
   driven: u beyond its limit along x until the first bit of the state; prints when, which, and
   whether the rate has stayed at its limit for 100 steps more. */
#include "b_q31.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static uint32_t seed = 12345u;

static uint32_t draw(void) {
  seed = seed * 1664525u + 1013904223u;
  return seed >> 8;
}

/* from -1 to 1 */
static double uniform(void) {
  return (double)draw() / 8388608.0 - 1.0;
}

static int32_t any_word(void) {
  const uint32_t bits = draw() << 16 ^ draw();
  return bits > 0x7fffffffu ? -(int32_t)(0xffffffffu - bits) - 1 : (int32_t)bits;
}

static void hash(long n) {
  uint32_t sum = 2166136261u;
  for (long k = 0; k < n; k++) {
    int32_t x[B_Q31_NX] = {0}, u[3];
    double real[7];
    for (int i = 0; i < 7; i++)
      real[i] = uniform() * (i < 4 ? 1 : RANGE);
    unsigned bits = b_q31_from_real(real, x);
    if (k % 10 == 0)
      for (int i = 0; i < 7; i++)
        x[i] = any_word();
    for (int i = 0; i < 3; i++)
      u[i] = any_word();
    bits = bits * 2048u + b_q31_step(x, u);
    for (int i = 0; i < B_Q31_NX; i++)
      sum = (sum ^ (uint32_t)x[i]) * 16777619u;
    sum = (sum ^ bits) * 16777619u;
  }
  printf("%08lx\n", (unsigned long)sum);
}

static void remainders(int i, int e, int k, double limit) {
  const double one = ldexp(1.0, k), unit = ldexp(1.0, -e);
  const double words[] = {-limit, -1000.0, -1.0, 0.0, 1.0, 1000.0, limit};
  unsigned long n = 0, wrong = 0, far = 0;
  for (int j = 0; j < 7; j++)
    for (long r = -(1L << k) / 2 - 1; r <= (1L << k) / 2 + 1; r++)
      for (int part = -2; part <= 2; part++) {
        const double v = words[j] + ((double)r + 0.25 * part) / one;
        int32_t x[B_Q31_NX];
        double real[7] = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, back[7];
        if (v < -limit || v > limit)
          continue;
        real[i] = v * unit;
        real[i == 0] += sqrt(1.0 - (i < 4 ? real[i] * real[i] : 0.0)); /* |q| = 1 */
        n++;
        wrong += b_q31_from_real(real, x) != 0;
        wrong +=
            x[7 + i] < -(1L << k) / 2 || (k > 0 ? x[7 + i] > (1L << k) / 2 - 1 : x[7 + i] != 0);
        wrong += fabs((double)x[i]) > limit;
        b_q31_to_real(x, back);
        /* the nearest, but for |q|: some 2^-52 of 2^30 units */
        far += fabs(back[i] / unit - v) > 0.5 / one + (i < 4 ? 1e-6 : 0.0);
      }
  printf("%lu %lu %lu\n", n, wrong, far);
}

static void free_motions(long n) {
  unsigned bits = 0;
  for (long k = 0; k < n; k++) {
    int32_t x[B_Q31_NX];
    double real[7];
    for (int i = 0; i < 7; i++)
      real[i] = uniform() * (i < 4 ? 1 : RANGE);
    bits |= b_q31_from_real(real, x);
    for (int i = 0; i < 400; i++)
      bits |= b_q31_step(x, NULL);
  }
  printf("%u\n", bits);
}

static void driven(void) {
  const int32_t u[3] = {2147483647, 0, 0};
  int32_t x[B_Q31_NX], at = 0;
  unsigned bits = 0, held = 1;
  long n = 0;
  b_q31_initial(x);
  while (!(bits & 127u) && n++ < 1000000)
    bits = b_q31_step(x, u);
  at = x[B_Q31_WX];
  for (int i = 0; i < 100; i++)
    held &= (b_q31_step(x, u) & bits) == bits && x[B_Q31_WX] == at;
  printf("%ld %u %u\n", n, bits, held);
}

int main(int argc, char **argv) {
  const long n = argc > 2 ? strtol(argv[2], NULL, 10) : 0;
  if (strcmp(argv[1], "hash") == 0)
    hash(n);
  else if (strcmp(argv[1], "free") == 0)
    free_motions(n);
  else if (strcmp(argv[1], "remainders") == 0)
    remainders((int)n, atoi(argv[3]), atoi(argv[4]), strtod(argv[5], NULL));
  else if (strcmp(argv[1], "driven") == 0)
    driven();
  else {
    double real[7], torque[3] = {0, 0, 0};
    int32_t x[B_Q31_NX], u[3] = {0, 0, 0};
    for (int i = 0; i < 7; i++)
      real[i] = strtod(argv[3 + i], NULL);
    unsigned bits = b_q31_from_real(real, x);
#ifdef B_Q31_INPUT
    for (int i = 0; i < 3 && argc > 10; i++)
      torque[i] = strtod(argv[10 + i], NULL);
    bits |= b_q31_input_from_real(torque, u);
#else
    (void)torque;
#endif
    for (long i = 0; i < n; i++)
      bits |= b_q31_step(x, u);
    b_q31_to_real(x, real);
    for (int i = 0; i < 7; i++)
      printf("%.17g ", real[i]);
    printf("%u\n", bits);
  }
  return 0;
}
