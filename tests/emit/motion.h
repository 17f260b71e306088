/* motion.h - how an emitted closed form with theta functions is measured: by lagrange.c and
   gyrostat.c, which say what a body is. SPDX-License-Identifier: GPL-3.0-or-later

     measure rows           "row ID TIME dw dq norm" against the table
     measure random STATES  "random STATES refused nan start norm T M many rates ticks": the worst
     measure float STATES   "float STATES refused dw dq": the float code against the double one at
                            inputs that both hold

   Errors of rates are over the pace. The emitted code is two compiled scenes, top (double) and
   small (float). */
#include "forced_top.h"
#include "small.h"
#include "top.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- what the including file defines: a body is at most four numbers ---- */

enum { BODY = 4 };

static void parameters(const double body[BODY], double p[TOP_NP]);
/* the n-th random body and state; tame: one that float bears */
static void draw(double body[BODY], double x[7], long n, int tame);
/* a rate that the motion from x0 hardly exceeds, above 0 */
static double pace(const double body[BODY], const double x0[7]);
/* the integrals of the motion: the energy, and three components of momentum */
static void integrals(const double body[BODY], const double x[7], long double value[4]);
/* the sizes of energy and momentum, for a pace */
static void sizes(const double body[BODY], double scale, double size[2]);
static double period(const top_orbit *o);
/* how many paces the float code is followed, of either sign */
static double float_span(void);

/* ---- random numbers ---- */

static uint64_t seed = 88172645463325252u;
static double uniform(void) { /* in (0, 1): xorshift64, Marsaglia 2003 */
  seed ^= seed << 13;
  seed ^= seed >> 7;
  seed ^= seed << 17;
  return ((double)(seed >> 11) + 0.5) * 0x1p-53;
}
static double spread(double decades) {
  return pow(10, decades * (2 * uniform() - 1));
}
static double bell(void) {
  return uniform() + uniform() + uniform() - 1.5;
}

/* ---- errors ---- */

static double larger(double a, double b) {
  return b <= a ? a : b;
} /* a NaN stays */

static double norm_error(const double *q) {
  long double s = 0;
  for (int i = 0; i < 4; i++)
    s += (long double)q[i] * q[i];
  return (double)fabsl(sqrtl(s) - 1);
}

static int prepare(top_orbit *o, top_model *m, const double body[BODY], const double x0[7]) {
  double p[TOP_NP];
  parameters(body, p);
  return top_init(m, p) != 0 || top_solve(o, m, x0) != 0;
}

/* A row of the table: rates of the state x over the largest, its attitude as an angle, in the
   table's axes q. */
static void print_row(const char *id, double t, const double x[7], const double q[4],
                      const long double want_w[3], const long double want_q[4]) {
  long double most = 0, dw = 0, plus = 0, minus = 0;
  for (int i = 0; i < 3; i++) {
    most = fmaxl(most, fabsl(want_w[i]));
    if (!(fabsl(x[4 + i] - want_w[i]) <= dw))
      dw = fabsl(x[4 + i] - want_w[i]);
  }
  for (int i = 0; i < 4; i++) {
    plus += (q[i] - want_q[i]) * (q[i] - want_q[i]);
    minus += (q[i] + want_q[i]) * (q[i] + want_q[i]);
  }
  printf("row %s %g %.3Le %.3Le %.3e\n", id, t, dw / most, 2 * sqrtl(minus < plus ? minus : plus),
         norm_error(x));
}

/* The rest of a line for the oracle: rates, attitude, time, a period if one is given, and what was
   found. */
static void print_motion(const double x0[7], double t, const double *one_period,
                         const double x[7]) {
  for (int i = 0; i < 7; i++)
    printf(" %a", i < 3 ? x0[4 + i] : x0[i - 3]);
  printf(" %a", t);
  if (one_period)
    printf(" %a", *one_period);
  for (int i = 0; i < 7; i++)
    printf(" %a", i < 3 ? x[4 + i] : x[i - 3]);
  printf("\n");
}

static void random_states(long count) {
  double start = 0, norm = 0, energy = 0, momentum = 0, many = 0, rates = 0, ticks = 0;
  long refused = 0, wrong = 0;
  for (long n = 0; n < count; n++) {
    double b[BODY], x0[7], x[7], z[7], t[12], table[84], w[3], q[4], d[2] = {0, 0}, f[7];
    double length = 0, size[2];
    long double start_integrals[4], now[4];
    top_model m;
    top_orbit o;
    draw(b, x0, n, 0);
    if (prepare(&o, &m, b, x0)) {
      refused++;
      continue;
    }
    for (int i = 0; i < 4; i++)
      length += x0[i] * x0[i];
    length = sqrt(length);
    const double scale = pace(b, x0);
    sizes(b, scale, size);
    top_at(&o, 0, x);
    for (int i = 0; i < 4; i++) {
      d[0] += (x[i] - x0[i] / length) * (x[i] - x0[i] / length);
      d[1] += (x[i] + x0[i] / length) * (x[i] + x0[i] / length);
    }
    start = larger(start, sqrt(d[0] < d[1] ? d[0] : d[1]));
    for (int i = 4; i < 7; i++)
      start = larger(start, fabs(x[i] - x0[i]) / scale);
    integrals(b, x0, start_integrals);
    const double once = period(&o);
    for (int k = 0; k < 4; k++)
      t[k] = k < 3          ? (uniform() - 0.5) * 100 * spread(3) / scale
             : once < 1e300 ? once * floor(uniform() * 1e6)
                            : 0;
    for (int k = 4; k < 12; k++)
      t[k] = t[k - 4];
    top_at_many(&o, 12, t, table); /* a block of eight and four more */
    for (int k = 0; k < 4; k++) {
      top_at(&o, t[k], x);
      top_at_rates(&o, t[k], w);
      top_at_attitude(&o, t[k], q);
      for (int i = 0; i < 7; i++) {
        wrong += !(x[i] - x[i] == 0);
        many = larger(many, fabs(table[i * 12 + k] - x[i]) / (i < 4 ? 1 : scale));
        many = larger(many, fabs(table[i * 12 + k + 8] - x[i]) / (i < 4 ? 1 : scale));
        many = larger(many, fabs((i < 4 ? q[i] : w[i - 4]) - x[i]) / (i < 4 ? 1 : scale));
      }
      /* the same time by ticks, there and back, as long as pairs have digits left */
      for (int sign = -1; sign < 2 && fabs(t[k]) * scale < 0x1p40; sign += 2) {
        wrong += top_set_tick(&o, sign * ldexp(t[k], -20)) != 0;
        top_at_tick(&o, sign * ((int64_t)1 << 20), z);
        for (int i = 0; i < 7; i++)
          ticks = larger(ticks, fabs(z[i] - x[i]) / (i < 4 ? 1 : scale));
      }
      norm = larger(norm, norm_error(x));
      integrals(b, x, now);
      energy = larger(energy, (double)(fabsl(now[0] - start_integrals[0]) / size[0]));
      for (int i = 1; i < 4; i++)
        momentum = larger(momentum, (double)(fabsl(now[i] - start_integrals[i]) / size[1]));
      /* the equations of motion: a central difference, exact to h^2 and to rounding/h */
      if (fabs(t[k]) * scale < 1e4) {
        const double h = 0x1p-16 / scale;
        double before[7], after[7];
        top_at(&o, t[k] + h, after);
        top_at(&o, t[k] - h, before);
        top_rhs(&m, 0, x, NULL, f);
        const double span = (t[k] + h) - (t[k] - h);
        for (int i = 0; i < 7; i++)
          rates = larger(rates, fabs((after[i] - before[i]) / span - f[i]) /
                                    (i < 4 ? scale : scale * scale));
      }
    }
  }
  printf("random %ld %ld %ld %.3e %.3e %.3e %.3e %.3e %.3e %.3e\n", count, refused, wrong, start,
         norm, energy, momentum, many, rates, ticks);
}

static void floats(long count) {
  double dw = 0, dq = 0;
  long refused = 0;
  for (long n = 0; n < count; n++) {
    double b[BODY], x0[7], x[7], p[TOP_NP], plus = 0, minus = 0, e = 0;
    float ps[SMALL_NP], s0[7], s[7];
    top_model m;
    top_orbit o;
    small_model ms;
    small_orbit os;
    draw(b, x0, n, 1);
    for (int i = 0; i < 7; i++) {
      s0[i] = (float)x0[i];
      x0[i] = s0[i];
    }
    for (int i = 0; i < BODY; i++)
      b[i] = (float)b[i];
    parameters(b, p);
    for (int i = 0; i < SMALL_NP; i++)
      ps[i] = (float)p[i];
    if (prepare(&o, &m, b, x0) || small_init(&ms, ps) != 0 || small_solve(&os, &ms, s0) != 0) {
      refused++;
      continue;
    }
    const double scale = pace(b, x0);
    const float t = (float)(float_span() / scale);
    top_at(&o, t, x);
    small_at(&os, t, s);
    for (int i = 0; i < 4; i++) {
      plus += (x[i] - (double)s[i]) * (x[i] - (double)s[i]);
      minus += (x[i] + (double)s[i]) * (x[i] + (double)s[i]);
    }
    for (int i = 4; i < 7; i++)
      e = larger(e, fabs(x[i] - (double)s[i]) / scale);
    dw = larger(dw, e);
    dq = larger(dq, sqrt(plus < minus ? plus : minus));
  }
  printf("float %ld %ld %.3e %.3e\n", count, refused, dw, dq);
}
