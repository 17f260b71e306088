/* costs.c - firmware that does each operation and each function of the C library on the same 16
   pairs of operands, for costs.lua to count. REAL: double or float, and F its suffix.
   SPDX-License-Identifier: GPL-3.0-or-later

   The operands are those of mechanics: both signs, a few decades about 1, nothing special. Angles
   within a turn, for functions that are defined on a part of the line their values there. The first
   line is the loop that copies one operand. */
#include "marks.h"
#include <math.h>

#define N           16
#define JOIN_(a, b) a##b
#define JOIN(a, b)  JOIN_(a, b)
#define FN(name)    JOIN(name, F)

static volatile REAL given[2][N] = {
    {0.7853981633974483, -3.1, 12.25, -0.031415926, 5.4321, 0.0021, -250.75, 1.0625, -0.333333333,
     7.77, 99.9, -1.618033988, 0.5, -17.3, 0.0625001, 2.718281828},
    {1.2, 0.037, -4.4, 0.00931, -6.283185307, 31.5, 0.9, -0.125, 1000.3, -2.2360679, 0.141421356,
     0.0999, -3.3333333, 8.25, 55.5, -0.70710678}};
REAL a[N], b[N], angle[N], positive[N], part[N], out[N];
int number[N];
long long large[N];

#define LOOP(what)                                                                                 \
  begin();                                                                                         \
  for (int i = 0; i < N; i++)                                                                      \
    what;                                                                                          \
  end();                                                                                           \
  __asm__ volatile("" ::: "memory")
#define UNARY(name, from) LOOP(out[i] = FN(name)(from[i]))

int main(void) {
  for (int i = 0; i < N; i++) {
    a[i] = given[0][i];
    b[i] = given[1][i];
    angle[i] = (REAL)0.37 * (REAL)(i - 7) + (REAL)0.011;
    positive[i] = (a[i] < 0 ? -a[i] : a[i]);
    part[i] = (REAL)0.121 * (REAL)(i - 8) + (REAL)0.0171; /* within (-1, 1) */
    number[i] = 37 * i - 200;
    large[i] = 1234567890123LL * (i + 1);
  }
  __asm__ volatile("" ::: "memory");
  LOOP(out[i] = a[i]);
  LOOP(out[i] = a[i] + b[i]);
  LOOP(out[i] = a[i] * b[i]);
  LOOP(out[i] = a[i] / b[i]);
  UNARY(sqrt, positive);
  LOOP(number[i] += a[i] < b[i]);
  LOOP(out[i] = (REAL)number[i]);
  LOOP(number[i] = (int)a[i]);
  LOOP(out[i] = (REAL)large[i]);
  LOOP(large[i] = (large[i] * 12345678901LL + 77) >> 3);
  LOOP(out[i] = FN(fma)(a[i], b[i], angle[i]));
  UNARY(sin, angle);
  UNARY(cos, angle);
  UNARY(exp, angle);
  UNARY(log, positive);
  UNARY(sinh, angle);
  UNARY(cosh, angle);
  UNARY(floor, a);
  LOOP(out[i] = FN(frexp)(a[i], &number[i]));
  LOOP(out[i] = FN(ldexp)(a[i], i - 5));
  UNARY(tan, angle);
  UNARY(tanh, angle);
  UNARY(asin, part);
  UNARY(acos, part);
  UNARY(atan, a);
  LOOP(out[i] = FN(atan2)(a[i], b[i]));
  LOOP(out[i] = FN(pow)(positive[i], angle[i]));
  LOOP(out[i] = FN(fmod)(positive[i], (REAL)1.25));
  LOOP(out[i] = FN(hypot)(a[i], b[i]));
  UNARY(cbrt, a);
  UNARY(ceil, a);
  return FINISH(0);
}
