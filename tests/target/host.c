/* host.c - what an emitted scene's functions and the C library take on the machine at hand.
   SPDX-License-Identifier: GPL-3.0-or-later

   Prints nanoseconds a call, the least of many short runs: first a chain of dependent additions of
   integers, one cycle each, then rk4, semi, midpoint, taylor, split4, solve, at, at_tick, then sin,
   cos, exp, log, sinh, cosh, floor, frexp, ldexp. Compiled and run by hand, with the emitted source
   beside it; SCENE, SCENE_H: as in steps.c. */
#define _POSIX_C_SOURCE 199309L
#include SCENE_H
#include <math.h>
#include <stdio.h>
#include <time.h>

#define JOIN_(a, b) a##_##b
#define JOIN(a, b)  JOIN_(a, b)
#define FN(name)    JOIN(SCENE, name)
typedef FN(real) real;

static volatile real when = (real)1.2345, step = (real)0.001;
static FN(model) model;
static FN(orbit) orbit;
static real start[32], x[32];

static double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* the least time of a call of `what` with the number i, of 300 runs of n calls */
#define TIME(n, what)                                                                              \
  do {                                                                                             \
    double least = 1;                                                                              \
    for (int run = 0; run < 300; run++) {                                                          \
      for (int i = 0; i < 32; i++)                                                                 \
        x[i] = start[i];                                                                           \
      const double from = now();                                                                   \
      for (int i = 0; i < (n); i++)                                                                \
        what;                                                                                      \
      const double took = (now() - from) / (n);                                                    \
      least = took < least ? took : least;                                                         \
    }                                                                                              \
    printf("%.4f\n", 1e9 * least);                                                                 \
  } while (0)

int main(void) {
  FN(init)(&model, (void *)0);
  FN(initial)(&model, start);
  const real t = when, h = step;
  volatile real one = 1;
  real kept = 0;
  unsigned long n = 0;
  int e;
  TIME(1000, __asm__ volatile("add $1, %0" : "+r"(n)));
  TIME(100, FN(step)(&model, t, x, (void *)0, h));
  TIME(100, FN(semi_step)(&model, t, x, (void *)0, h));
  TIME(50, FN(midpoint_step)(&model, t, x, (void *)0, h));
  TIME(20, FN(taylor_step)(&model, t, x, (void *)0, h));
  TIME(20, FN(split4_step)(&model, t, x, (void *)0, h));
  TIME(2, FN(solve)(&orbit, &model, start));
  FN(set_tick)(&orbit, (real)0.01);
  TIME(100, FN(at)(&orbit, t + (real)i, x));
  TIME(100, FN(at_tick)(&orbit, 1000 * i, x));
#define EACH(what)                                                                                 \
  TIME(100, kept += (what));                                                                       \
  one = kept
  const double d = 1.37;
  EACH((real)(sizeof(real) == 4 ? sinf((float)i * 0.06F - 3.0F) : sin(i * 0.06 - 3.0)));
  EACH((real)(sizeof(real) == 4 ? cosf((float)i * 0.06F - 3.0F) : cos(i * 0.06 - 3.0)));
  EACH((real)(sizeof(real) == 4 ? expf((float)i * 0.06F - 3.0F) : exp(i * 0.06 - 3.0)));
  EACH((real)(sizeof(real) == 4 ? logf((float)i * 0.06F + 0.1F) : log(i * 0.06 + 0.1)));
  EACH((real)(sizeof(real) == 4 ? sinhf((float)i * 0.06F - 3.0F) : sinh(i * 0.06 - 3.0)));
  EACH((real)(sizeof(real) == 4 ? coshf((float)i * 0.06F - 3.0F) : cosh(i * 0.06 - 3.0)));
  EACH((real)(sizeof(real) == 4 ? floorf((float)i * 0.06F - 3.0F) : floor(i * 0.06 - 3.0)));
  EACH((real)(sizeof(real) == 4 ? frexpf((float)i * 0.06F - 3.0F, &e) : frexp(i * 0.06 - 3.0, &e)));
  EACH((real)(sizeof(real) == 4 ? ldexpf(1.37F, i - 50) : ldexp(d, i - 50)));
  return 0;
}
