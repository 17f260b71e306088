/* time.c - how long something takes, on a machine that does other things too.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * - A sample is the processor time of this process: what others do on the same processor is not in
 *   it.  That clock is a system call of some 0.2 us, so a sample does the work as often as makes it
 *   LEAST_SAMPLE long at least; where the kernel counts in coarser ticks, the steady clock is used.
 * - Before the first sample the work is done for WARM_UP: caches, branches, the clock rate.
 * - All samples of one measurement are taken on the processor where it begins.
 * - Of several samples the median is what is reported; the least is what the code can do.
 */
#define _GNU_SOURCE /* sched_setaffinity */
#include "bench.h"

#include <math.h>
#include <sched.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#define LEAST_SAMPLE   100e-6 /* s; 500 times what it costs to look at the clock */
#define WARM_UP        1e-3   /* s */
#define MOST_AT_A_TIME 1000000000L

static double seconds(clockid_t clock) {
  struct timespec t;
  clock_gettime(clock, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

double bench_now(void) {
  return seconds(CLOCK_MONOTONIC);
}

/* Does the processor's clock move on within a microsecond or so? */
static clockid_t sample_clock(void) {
  static clockid_t clock;
  static int known;
  if (!known) {
    double finest = HUGE_VAL;
    for (int i = 0; i < 100; i++) {
      const double a = seconds(CLOCK_PROCESS_CPUTIME_ID), b = seconds(CLOCK_PROCESS_CPUTIME_ID);
      if (b > a && b - a < finest)
        finest = b - a;
    }
    clock = finest < LEAST_SAMPLE / 50 ? CLOCK_PROCESS_CPUTIME_ID : CLOCK_MONOTONIC;
    known = 1;
  }
  return clock;
}

/* ---- one processor ---- */

#if defined __linux__
typedef cpu_set_t processors;

/* Stay where we are; 0 if that cannot be. */
static int pin(processors *old) {
  cpu_set_t one;
  const int here = sched_getcpu();
  if (here < 0 || here >= CPU_SETSIZE || sched_getaffinity(0, sizeof *old, old) != 0)
    return 0;
  CPU_ZERO(&one);
  CPU_SET((size_t)here, &one);
  return sched_setaffinity(0, sizeof one, &one) == 0;
}

static void unpin(const processors *old) {
  sched_setaffinity(0, sizeof *old, old);
}

static int available(void) {
  processors p;
  return sched_getaffinity(0, sizeof p, &p) == 0 ? CPU_COUNT(&p) : 0;
}
#else
typedef int processors;

static int pin(processors *old) {
  *old = 0;
  return 0;
}

static void unpin(const processors *old) {
  (void)old;
}

static int available(void) {
  return 0;
}
#endif

/* processors() -> how many this process may use */
int host_processors(lua_State *L) {
  long n = available();
  if (n < 1)
    n = sysconf(_SC_NPROCESSORS_ONLN);
  lua_pushinteger(L, n < 1 ? 1 : n);
  return 1;
}

/* ---- samples ---- */

static int ascending(const void *a, const void *b) {
  const double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

static void summarise(double sample[], long n, struct bench_result *r) {
  qsort(sample, (size_t)n, sizeof sample[0], ascending);
  r->least = sample[0];
  r->most = sample[n - 1];
  r->median = (sample[(n - 1) / 2] + sample[n / 2]) / 2;
  r->repeats = n;
}

static int take(bench_work *work, void *what, long n, clockid_t clock, double *spent) {
  const double start = seconds(clock);
  const int status = work(what, n);
  *spent = seconds(clock) - start;
  return interrupt_pending() ? BENCH_INTERRUPTED : status;
}

/* How often per sample; the last try is a sample already. */
static int calibrate(bench_work *work, void *what, clockid_t clock, double end, long *n,
                     double *spent) {
  const double warm = bench_now() + WARM_UP;
  for (*n = 1;;) {
    const int status = take(work, what, *n, clock, spent);
    if (status != 0)
      return status;
    const double now = bench_now();
    const int enough = *spent >= LEAST_SAMPLE || *n >= MOST_AT_A_TIME;
    if ((enough && now >= warm) || now >= end)
      return 0;
    if (!enough) /* 1.5: room for a sample that was slower than most */
      *n = (long)fmin((double)*n * fmin(fmax(1.5 * LEAST_SAMPLE / fmax(*spent, 1e-9), 2), 1000),
                      MOST_AT_A_TIME);
  }
}

int bench_measure(bench_work *work, void *what, long repeats, double limit,
                  struct bench_result *r) {
  double sample[BENCH_MAX_REPEATS], spent;
  processors old;
  const clockid_t clock = sample_clock();
  const double end = bench_now() + limit;
  const int pinned = pin(&old);
  long n, taken = 0;
  int status = calibrate(work, what, clock, end, &n, &spent);
  if (status == 0 && bench_now() >= end)
    sample[taken++] = spent / (double)n;
  while (status == 0 && taken < repeats && (taken == 0 || bench_now() < end)) {
    status = take(work, what, n, clock, &spent);
    sample[taken++] = spent / (double)n;
  }
  if (pinned)
    unpin(&old);
  if (status == 0)
    summarise(sample, taken, r);
  return status;
}

void bench_push(lua_State *L, const struct bench_result *r, double part) {
  lua_createtable(L, 0, 6);
  fields_set_number(L, "median", r->median / part);
  fields_set_number(L, "least", r->least / part);
  fields_set_number(L, "most", r->most / part);
  fields_set_count(L, "repeats", r->repeats);
}

/* A sixteenth of the limit: then there is time for several samples of what comes out. */
int bench_part(bench_march *march, void *what, long whole, double limit, long *some) {
  double n = fmin(256, (double)whole);
  for (;;) {
    const double start = bench_now();
    const int status = march(what, (long)n);
    if (status != 0 || interrupt_pending())
      return status != 0 ? status : BENCH_INTERRUPTED;
    const double room = limit / 16 / fmax(bench_now() - start, 1e-9);
    *some = (long)n;
    if (*some == whole || room < 2)
      return 0;
    n = fmin(n * fmin(room, 1000), (double)whole);
  }
}

/* ---- requests ---- */

void bench_read(lua_State *L, const struct plugin *p, struct bench_request *r) {
  luaL_checktype(L, 2, LUA_TTABLE);
  fields_get(L, 2, "x0", p->code->nx, r->x0, NULL);
  lua_getfield(L, 2, "u");
  fields_optional(L, -1, p->code->nu, r->u);
  lua_pop(L, 1);
  r->to = fields_positive(L, 2, "to", 0);
  r->repeats = (long)fmax(1, fmin(fields_positive(L, 2, "repeats", 9), BENCH_MAX_REPEATS));
  r->limit = fields_positive(L, 2, "limit", 1);
}

long bench_steps(lua_State *L, double span, double h) {
  const double n = plugin_steps(span, h);
  if (!(n <= 1e15))
    luaL_error(L, "step: more than 1e15 steps");
  return (long)n;
}

/* ---- the machine itself ---- */

/* One chain of multiplications and additions, each waiting for the one before: what it takes
   depends on the clock rate and on who else is there, on nothing of ours.  x stays near 1. */
static int chain(void *what, long n) {
  double *x = what, y = *x;
  for (long i = 0; i < n * 1000; i++)
    y = y * 0.999999 + 1e-6;
  *x = y;
  return 0;
}

/* baseline() -> {ns =, least =, most =, spread =}. ns: median for one link of the chain; spread: by
   how much three samples of four stay above the least at most, relative to it.  On a quiet machine
   that is a percent or two. */
int host_baseline(lua_State *L) {
  enum { SAMPLES = 20 };
  double each[SAMPLES], x = 1;
  struct bench_result r;
  for (int i = 0; i < SAMPLES; i++) {
    if (bench_measure(chain, &x, 1, 0.1, &r) == BENCH_INTERRUPTED)
      interrupt_check(L);
    each[i] = r.median * 1e6; /* a thousand links */
  }
  summarise(each, SAMPLES, &r);
  bench_push(L, &r, 1);
  fields_set_number(L, "ns", r.median);
  fields_set_number(L, "spread", each[SAMPLES * 3 / 4] / r.least - 1);
  return 1;
}
