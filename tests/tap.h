/* tap.h - TAP 13 for the tests that are written in C.
   SPDX-License-Identifier: GPL-3.0-or-later

     int main(void) {
       ok(2 + 2 == 4, "two and two are four");
       near(got, want, TOL, "a sentence of fact");
       return tap_done();                        prints the plan; 1 when anything failed
     }

   Each check prints one line and returns whether it passed. Names are formats and become sentences
   of fact; a failure adds where it is and got/want/difference with all digits. Tolerances are
   absolute: write TOL * size where a relative one is meant, so that the size is visible. A NaN is
   near nothing. Numbers are compared as long double, so that a reference may have more digits than
   the result. */
#ifndef TAP_H
#define TAP_H

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

typedef struct tap_counts {
  int run, failed, planned;
} tap_counts;

static inline tap_counts *tap_state(void) {
  static tap_counts counts;
  return &counts;
}

/* State the number of checks beforehand; without it tap_done prints the plan at the end. */
static inline void tap_plan(int n) {
  tap_state()->planned = n;
  printf("TAP version 13\n1..%d\n", n);
}

static inline void tap_line(int passed, const char *directive, const char *format, va_list args) {
  tap_counts *c = tap_state();
  if (c->run == 0 && c->planned == 0)
    printf("TAP version 13\n");
  c->run++;
  c->failed += !passed;
  printf("%sok %d - ", passed ? "" : "not ", c->run);
  vprintf(format, args);
  printf("%s\n", directive);
  fflush(stdout); /* a later crash must not swallow it */
}

static inline void tap_check(int passed, const char *format, ...) {
  va_list args;
  va_start(args, format);
  tap_line(passed, "", format, args);
  va_end(args);
}

static inline void diag(const char *format, ...) {
  va_list args;
  va_start(args, format);
  printf("# ");
  vprintf(format, args);
  printf("\n");
  va_end(args);
}

static inline void tap_skip(const char *why, const char *format, ...) {
  char directive[200];
  snprintf(directive, sizeof directive, " # SKIP %s", why);
  va_list args;
  va_start(args, format);
  tap_line(1, directive, format, args);
  va_end(args);
}

static inline int tap_where(int passed, const char *file, int line) {
  if (!passed)
    diag("at %s:%d", file, line);
  return passed;
}

/* The worst of n differences against tolerance; the names of components are their indices. */
static inline int tap_compare(int n, const double got[], const long double want[],
                              long double tolerance) {
  int good = 1;
  for (int i = 0; i < n; i++)
    good = good && fabsl((long double)got[i] - want[i]) <= tolerance;
  return good;
}

static inline int tap_explain(int passed, int n, const double got[], const long double want[],
                              long double tolerance) {
  for (int i = 0; !passed && i < n; i++)
    diag("  [%d] got %.17g want %.20Lg difference %.3Lg tolerance %.3Lg", i, got[i], want[i],
         (long double)got[i] - want[i], tolerance);
  return passed;
}

/* n doubles as long doubles, for a want that is an array of doubles. */
static inline const long double *tap_wide(int n, const double from[], long double to[]) {
  for (int i = 0; i < n; i++)
    to[i] = (long double)from[i];
  return to;
}

#define ok(condition, ...)                                                                         \
  tap_where_ok((condition) ? (tap_check(1, __VA_ARGS__), 1) : (tap_check(0, __VA_ARGS__), 0))
#define tap_where_ok(passed) tap_where((passed), __FILE__, __LINE__)

/* One number. */
#define near(got, want, tolerance, ...)                                                            \
  near_all_wide(1, &(const double){got}, &(const long double){(long double)(want)}, tolerance,     \
                __VA_ARGS__)

/* n numbers against n doubles, or against n long doubles. n at most 16. */
#define near_all(n, got, want, tolerance, ...)                                                     \
  near_all_wide(n, got, tap_wide(n, want, (long double[16]){0}), tolerance, __VA_ARGS__)

#define near_all_wide(n, got, want, tolerance, ...)                                                \
  tap_where_ok(tap_explain(tap_compare(n, got, want, (long double)(tolerance))                     \
                               ? (tap_check(1, __VA_ARGS__), 1)                                    \
                               : (tap_check(0, __VA_ARGS__), 0),                                   \
                           n, got, want, (long double)(tolerance)))

/* A check that cannot be made here: counted as passed, with the reason. */
#define skip(why, ...) tap_skip(why, __VA_ARGS__)

static inline int tap_done(void) {
  const tap_counts *c = tap_state();
  if (c->planned == 0)
    printf("1..%d\n", c->run);
  else if (c->planned != c->run)
    diag("planned %d checks, ran %d", c->planned, c->run);
  if (c->failed)
    diag("%d of %d failed", c->failed, c->run);
  return c->failed || (c->planned && c->planned != c->run) ? EXIT_FAILURE : EXIT_SUCCESS;
}

#endif
