/* symmetric.c - measures the emitted closed form of the free symmetric top and of the sphere: part
   of symmetric.t, which judges.
   SPDX-License-Identifier: GPL-3.0-or-later

   AXIS is 0, 1, 2 for the symmetry axis, 3 for the sphere: only bodies of that kind are taken, the
   emitted code being two compiled scenes, top (double) and small (float), whose parameters are the
   moment across and, but for the sphere, that about the axis. Prints "row ID TIME dw dq norm",
   "tick ..", "float ..": error of the rates over the largest rate, of the attitude as an angle,
   |q| - 1; "same ID TIME d 0 0": rates alone, attitude alone, many times at once and ticks back
   against the state at a time; "period ID TIME d 0 0": periods, rate and number against their
   definitions; "random STATES refused start norm L T". */
#include "free_top.h"
#include "small.h"
#include "top.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

static double larger(double a, double b) {
  return b <= a ? a : b;
} /* a NaN stays */

static long double length(const double *x, int n) {
  long double s = 0;
  for (int i = 0; i < n; i++)
    s += (long double)x[i] * x[i];
  return sqrtl(s);
}

static double norm_error(const double x[7]) {
  return (double)fabsl(length(x, 4) - 1);
}

/* The parameters of a tensor of this kind once its axes are relabelled, i becoming i + shift, which
   is a rotation of both frames; 0 if it is of another. */
static int take(const double I[6], int shift, double p[2]) {
  const int k = (AXIS + 3 - shift) % 3, i = (k + 1) % 3, j = (k + 2) % 3;
  p[0] = I[i];
  p[1] = I[k];
  return I[i] == I[j] && (I[k] == I[i]) == (AXIS == 3) && I[3] == 0 && I[4] == 0 && I[5] == 0;
}

/* Errors of x against rates w and attitude q. */
static void print_errors(const char *what, const char *id, double t, const double x[7],
                         const long double w[3], const long double q[4]) {
  long double most = 0, dw = 0, plus = 0, minus = 0;
  for (int i = 0; i < 3; i++) {
    most = fmaxl(most, fabsl(w[i]));
    if (!(fabsl(x[4 + i] - w[i]) <= dw))
      dw = fabsl(x[4 + i] - w[i]);
  }
  for (int i = 0; i < 4; i++) {
    plus += (x[i] - q[i]) * (x[i] - q[i]);
    minus += (x[i] + q[i]) * (x[i] + q[i]);
  }
  printf("%s %s %a %.3Le %.3Le %.3e\n", what, id, t, most > 0 ? dw / most : dw,
         2 * sqrtl(minus < plus ? minus : plus), norm_error(x));
}

/* The largest difference of two states, rates over their length. */
static double apart(const double a[7], const double b[7]) {
  const double w = (double)length(b + 4, 3);
  double d = 0;
  for (int i = 0; i < 7; i++)
    d = larger(d, fabs(a[i] - b[i]) / (i < 4 || w == 0 ? 1 : w));
  return d;
}

/* Periods, rate and rotation number against L = I w at the start. */
static void periods(const char *id, double t, const double p[2], const double x0[7],
                    const top_orbit *o) {
  const long double pi = 3.14159265358979323846264338327950288L;
  const int k = AXIS % 3, i = (k + 1) % 3, j = (k + 2) % 3;
  const long double I1 = p[0], I3 = AXIS == 3 ? p[0] : p[1], w3 = x0[4 + k];
  const long double across =
      sqrtl((long double)x0[4 + i] * x0[4 + i] + (long double)x0[4 + j] * x0[4 + j]);
  const long double L = hypotl(I1 * across, I3 * w3) / I1, Omega = fabsl((I3 - I1) / I1 * w3);
  const int constant = !(across > 0) || !(Omega > 0);
  const long double rate = constant ? length(x0 + 4, 3) : L,
                    want[4] = {constant ? 0 : 2 * pi / Omega, rate,
                               rate > 0 ? 2 * pi / rate : INFINITY, constant ? 0 : L / Omega};
  const double got[4] = {top_polhode_period(o), top_precession_rate(o), top_precession_period(o),
                         top_rotation_number(o)};
  double d = top_next_flip(o, t) == INFINITY ? 0 : 1;
  for (int n = 0; n < 4; n++)
    if ((long double)got[n] != want[n])
      d = larger(d, (double)fabsl(got[n] / want[n] - 1));
  printf("period %s %a %.3e 0 0\n", id, t, d);
}

static void rows(int shift) {
  for (size_t k = 0; k < sizeof free_top_rows / sizeof free_top_rows[0]; k++) {
    const char *id = free_top_rows[k].id;
    const double t = free_top_rows[k].t;
    double p[2], x0[7], x[7], y[7], z[7], d = 0;
    float ps[2], s0[7], s[7];
    top_model m;
    top_orbit o;
    small_model ms;
    small_orbit os;
    long double w[3], q[4];
    long double want_w[3], want_q[4];
    if (!take(free_top_rows[k].tensor, shift, p))
      continue;
    x0[0] = free_top_rows[k].q0[0];
    want_q[0] = free_top_rows[k].q[0];
    for (int i = 0; i < 3; i++) {
      const int to = (i + shift) % 3;
      x0[1 + to] = free_top_rows[k].q0[1 + i];
      x0[4 + to] = free_top_rows[k].w0[i];
      want_q[1 + to] = free_top_rows[k].q[1 + i];
      want_w[to] = free_top_rows[k].w[i];
    }
    if (top_init(&m, p) != 0 || top_solve(&o, &m, x0) != 0) {
      printf("row %s refused\n", id);
      continue;
    }
    top_at(&o, t, x);
    print_errors("row", id, t, x, want_w, want_q);
    periods(id, t, p, x0, &o);

    /* the same time by ticks, 2^k of them forth and back */
    const int power = (int)(k % 62);
    const int64_t count = (int64_t)1 << power;
    if (top_set_tick(&o, ldexp(t, -power)) != 0)
      printf("row %s refused tick\n", id);
    top_at_tick(&o, count, z);
    print_errors("tick", id, t, z, want_w, want_q);
    top_at_tick(&o, 0, z);
    top_at(&o, 0, y);
    d = larger(d, apart(z, y));
    top_at_tick(&o, -count, z);
    top_at(&o, -t, y);
    d = larger(d, apart(z, y));
    top_at_attitude(&o, t, z);
    top_at_rates(&o, t, z + 4);
    d = larger(d, apart(z, x));
    for (int n = 1; n < 40; n += 19) { /* the last of n times; the others must not matter */
      double times[40], many[7 * 40 + 1] = {0};
      for (int i = 0; i < n; i++)
        times[i] = i < n - 1 ? i * 0.1 : t;
      many[7 * n] = 5;
      top_at_many(&o, n, times, many);
      for (int i = 0; i < 7; i++)
        z[i] = many[i * n + n - 1];
      d = larger(d, many[7 * n] == 5 ? apart(z, x) : 1);
      top_at(&o, times[n / 2], y);
      for (int i = 0; i < 7; i++)
        z[i] = many[i * n + n / 2];
      d = larger(d, apart(z, y));
    }
    printf("same %s %a %.3e 0 0\n", id, t, d);

    /* rounded to float: another motion, which the double code has just been shown to follow; 2^-47
     * of a turn for each turn */
    int held = 1;
    for (int i = 0; i < 2; i++) {
      ps[i] = (float)p[i];
      p[i] = ps[i];
      held = held && p[i] > 1e-30;
    }
    for (int i = 0; i < 7; i++) {
      s0[i] = (float)x0[i];
      x0[i] = s0[i];
    }
    if (!held || fabs(t) * (double)length(x0 + 4, 3) > 1e6 || length(x0 + 4, 3) < 1e-18L)
      continue;
    if (small_init(&ms, ps) != 0 || small_solve(&os, &ms, s0) != 0 || top_init(&m, p) != 0 ||
        top_solve(&o, &m, x0) != 0) {
      printf("float %s refused\n", id);
      continue;
    }
    for (int ticks = 0; ticks < 2; ticks++) {
      const float time = (float)t;
      small_at(&os, time, s);
      if (ticks && small_set_tick(&os, ldexpf(time, -20)) == 0)
        small_at_tick(&os, (int64_t)1 << 20, s);
      top_at(&o, time, y);
      for (int i = 0; i < 7; i++) {
        x[i] = s[i];
        if (i < 4)
          q[i] = y[i];
        else
          w[i - 4] = y[i];
      }
      print_errors("float", id, t, x, w, q);
    }
  }
}

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

/* L in inertial axes, and 2T */
static long double invariants(const double p[2], const double x[7], long double L[3]) {
  const long double v[3] = {x[1], x[2], x[3]};
  long double M[3], c[3], T = 0;
  for (int i = 0; i < 3; i++) {
    M[i] = (i == AXIS ? p[1] : p[0]) * (long double)x[4 + i];
    T += M[i] * x[4 + i];
  }
  for (int i = 0; i < 3; i++)
    c[i] = 2 * (v[(i + 1) % 3] * M[(i + 2) % 3] - v[(i + 2) % 3] * M[(i + 1) % 3]);
  for (int i = 0; i < 3; i++)
    L[i] = M[i] + x[0] * c[i] + v[(i + 1) % 3] * c[(i + 2) % 3] - v[(i + 2) % 3] * c[(i + 1) % 3];
  return T;
}

/* A body, I3 <= 2 I1: near the sphere, a lamina, a needle, any; and its rates, some of them zero.
 */
static void draw(double p[2], double x[7]) {
  const int kind = (int)(uniform() * 6);
  const double rate = spread(30);
  p[0] = spread(30);
  p[1] = p[0] * (kind == 0   ? 1 + 0x1p-52 * (int)(uniform() * 5 - 2)
                 : kind == 1 ? 2
                 : kind == 2 ? spread(12) * 1e-12
                             : 2 * uniform());
  for (int i = 0; i < 3; i++) {
    const double r = uniform();
    x[i] = 2 * uniform() - 1;
    x[4 + i] = r < 0.15 ? 0 : rate * (r < 0.4 ? spread(12) : 1) * (2 * uniform() - 1);
  }
  x[3] = 2 * uniform() - 1;
}

static void random_states(long count) {
  double start = 0, norm = 0, momentum = 0, energy = 0;
  long refused = 0;
  for (long n = 0; n < count; n++) {
    double p[2], x0[7], x[7], w = 0;
    top_model m;
    top_orbit o;
    long double L0[3], L[3];
    draw(p, x0);
    if (top_init(&m, p) != 0 || top_solve(&o, &m, x0) != 0) {
      refused++;
      continue;
    }
    const long double q = length(x0, 4);
    for (int i = 4; i < 7; i++)
      w = fmax(w, fabs(x0[i]));
    top_at(&o, 0, x);
    for (int i = 0; i < 7; i++)
      start = larger(
          start, (double)(i < 4 ? fabsl(x[i] - x0[i] / q) : fabsl(x[i] - x0[i]) / (w > 0 ? w : 1)));
    for (int i = 0; i < 4; i++)
      x0[i] = x[i];
    const long double T0 = invariants(p, x0, L0),
                      G = sqrtl(L0[0] * L0[0] + L0[1] * L0[1] + L0[2] * L0[2]);
    for (int k = 0; k < 3; k++) {
      top_at(&o, w > 0 ? (2 * uniform() - 1) * spread(6) / w : spread(6), x);
      norm = larger(norm, norm_error(x));
      const long double T = invariants(p, x, L);
      for (int i = 0; i < 3; i++)
        momentum = larger(momentum, G > 0 ? (double)(fabsl(L[i] - L0[i]) / G) : 0);
      energy = larger(energy, T0 > 0 ? (double)(fabsl(T - T0) / T0) : 0);
    }
  }
  printf("random %ld %ld %.3e %.3e %.3e %.3e\n", count, refused, start, norm, momentum, energy);
}

int main(int argc, char **argv) {
  for (int shift = 0; shift < 3; shift++)
    rows(shift);
  random_states(argc > 1 ? atol(argv[1]) : 20000);
  return 0;
}
