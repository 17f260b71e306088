/* clock.h - what the benchmarks time with.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef BENCH_CLOCK_H
#define BENCH_CLOCK_H

#include <time.h>

/* Seconds from a clock that only goes forward. */
static inline double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Doubles in ascending order, for qsort. */
static inline int ascending(const void *a, const void *b) {
  const double *x1 = a, *x2 = b;
  return (*x1 > *x2) - (*x1 < *x2);
}

#endif
