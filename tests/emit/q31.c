/* q31.c - runs an emitted fixed-point step on the host, for tests/emit/q31.t.
   SPDX-License-Identifier: GPL-3.0-or-later

   run N qw .. wz [ux uy uz]: N steps from a real state; prints the real state and all bits.
   hash N: N steps, each from words at random, a tenth of them anything; prints a hash of all words
   and bits.
   free N: N motions of 400 steps from states within the range at random; prints all bits.
   driven: u beyond its limit along x until the first bit of the state; prints when, which, and
   whether the rate has stayed at its limit for 100 steps more. */
#include "b_q31.h"
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
