/* top.c - measures the emitted closed form of the free top: part of top.t, which judges.
   SPDX-License-Identifier: GPL-3.0-or-later

   Prints "row ID TIME dw dq norm": error of the rates over the largest rate, of the attitude as an
   angle, |q| - 1, for every sample of the table; "float ID TIME dw dq norm": the float code against
   the double one at inputs that both hold; "random STATES refused start norm L T": worst of random
   states that are hard; "many SCENE STATE hyperbolic n differ far": NAME_at_many. The emitted code
   is two compiled scenes, top (double) and small (float), of a tensor whose six entries are
   parameters. */
#include "free_top.h"
#include "small.h"
#include "top.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static double larger(double a, double b) {
  return b <= a ? a : b;
} /* a NaN stays */

static double length(const double *x, int n) {
  long double s = 0;
  for (int i = 0; i < n; i++)
    s += (long double)x[i] * x[i];
  return (double)sqrtl(s);
}

static double norm_error(const double x[7]) {
  long double s = 0;
  for (int i = 0; i < 4; i++)
    s += (long double)x[i] * x[i];
  return (double)fabsl(sqrtl(s) - 1);
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
  printf("%s %s %a %.3Le %.3Le %.3e\n", what, id, t, dw / most,
         2 * sqrtl(minus < plus ? minus : plus), norm_error(x));
}

static void rows(void) {
  for (size_t k = 0; k < sizeof free_top_rows / sizeof free_top_rows[0]; k++) {
    double p[TOP_NP], x0[7], x[7], y[7];
    float ps[SMALL_NP], s0[7], s[7];
    top_model m;
    top_orbit o;
    small_model ms;
    small_orbit os;
    long double w[3], q[4];
    for (int i = 0; i < 6; i++)
      p[i] = free_top_rows[k].tensor[i];
    for (int i = 0; i < 7; i++)
      x0[i] = i < 4 ? free_top_rows[k].q0[i] : free_top_rows[k].w0[i - 4];
    if (top_init(&m, p) != 0 || top_solve(&o, &m, x0) != 0) {
      printf("row %s refused\n", free_top_rows[k].id);
      continue;
    }
    top_at(&o, free_top_rows[k].t, x);
    print_errors("row", free_top_rows[k].id, free_top_rows[k].t, x, free_top_rows[k].w,
                 free_top_rows[k].q);

    /* the same time by ticks, 2^k of them forth and back; rates and attitude alone; the mean rate
     * about L */
    const int64_t count = (int64_t)1 << (k % 40);
    double z[7], far_away = 0;
    if (top_set_tick(&o, ldexp(free_top_rows[k].t, -(int)(k % 40))) != 0)
      printf("row %s refused tick\n", free_top_rows[k].id);
    top_at_tick(&o, count, z);
    print_errors("tick", free_top_rows[k].id, free_top_rows[k].t, z, free_top_rows[k].w,
                 free_top_rows[k].q);
    top_at_tick(&o, 0, z);
    top_at(&o, 0, y);
    for (int i = 0; i < 7; i++)
      far_away = larger(far_away, fabs(z[i] - y[i]) / (i < 4 ? 1 : length(y + 4, 3)));
    top_at_tick(&o, -count, z);
    top_at(&o, -free_top_rows[k].t, y);
    for (int i = 0; i < 7; i++)
      far_away = larger(far_away, fabs(z[i] - y[i]) / (i < 4 ? 1 : length(y + 4, 3)));
    top_at_attitude(&o, free_top_rows[k].t, z);
    top_at_rates(&o, free_top_rows[k].t, z + 4);
    for (int i = 0; i < 7; i++)
      far_away = larger(far_away, fabs(z[i] - x[i]) / (i < 4 ? 1 : length(y + 4, 3)));
    printf("same %s %a %.3e 0 0\n", free_top_rows[k].id, free_top_rows[k].t, far_away);

    /* rounded to float: another motion, which the double code has just been shown to follow */
    float t = (float)free_top_rows[k].t;
    int held = 1;
    for (int i = 0; i < 6; i++) {
      ps[i] = (float)p[i];
      p[i] = ps[i];
      held = held && (free_top_rows[k].tensor[i] == 0 || fabs(p[i]) > 1e-30);
    }
    for (int i = 0; i < 7; i++) {
      s0[i] = (float)x0[i];
      x0[i] = s0[i];
    }
    /* 2^-47 of a turn for each turn */
    if (!held || fabs(t) * length(x0 + 4, 3) > 1e6 || length(x0 + 4, 3) < 1e-18)
      continue;
    if (small_init(&ms, ps) != 0 || small_solve(&os, &ms, s0) != 0 || top_init(&m, p) != 0 ||
        top_solve(&o, &m, x0) != 0) {
      printf("float %s refused\n", free_top_rows[k].id);
      continue;
    }
    small_at(&os, t, s);
    if (small_set_tick(&os, ldexpf(t, -20)) == 0)
      small_at_tick(&os, (int64_t)1 << 20, s);
    top_at(&o, t, y);
    for (int i = 0; i < 7; i++) {
      x[i] = s[i];
      if (i < 4)
        q[i] = y[i];
      else
        w[i - 4] = y[i];
    }
    print_errors("float", free_top_rows[k].id, t, x, w, q);
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
static long double invariants(const double I[6], const double x[7], long double L[3]) {
  const long double w[3] = {x[4], x[5], x[6]}, v[3] = {x[1], x[2], x[3]};
  const long double M[3] = {I[0] * w[0] + I[3] * w[1] + I[4] * w[2],
                            I[3] * w[0] + I[1] * w[1] + I[5] * w[2],
                            I[4] * w[0] + I[5] * w[1] + I[2] * w[2]};
  long double c[3];
  for (int i = 0; i < 3; i++)
    c[i] = 2 * (v[(i + 1) % 3] * M[(i + 2) % 3] - v[(i + 2) % 3] * M[(i + 1) % 3]);
  for (int i = 0; i < 3; i++)
    L[i] = M[i] + x[0] * c[i] + v[(i + 1) % 3] * c[(i + 2) % 3] - v[(i + 2) % 3] * c[(i + 1) % 3];
  return M[0] * w[0] + M[1] * w[1] + M[2] * w[2];
}

/* A body that can be, a <= b <= c <= a + b, and its rates; many are degenerate to the last bit or
 * nearly. */
static void draw(double I[6], double x[7]) {
  const int kind = (int)(uniform() * 10), turn = (int)(uniform() * 3), swap = uniform() < 0.5;
  double m[3] = {1, 1 + uniform(), 0};
  if (kind == 0)
    m[1] = 1 + spread(15) * 1e-15;
  if (kind == 1 || kind == 2)
    m[1] = 1 + 0x1p-52 * (int)(uniform() * 5) * (kind - 1);
  if (kind == 3)
    m[0] = spread(12);
  if (m[0] > m[1]) {
    const double larger_one = m[0];
    m[0] = m[1];
    m[1] = larger_one;
  }
  m[2] = kind == 4   ? m[1]
         : kind == 5 ? m[1] * (1 + 0x1p-52 * (int)(uniform() * 4))
                     : m[1] + uniform() * m[0];
  if (kind == 6)
    m[2] = m[0] + m[1];
  if (m[2] > m[0] + m[1])
    m[2] = m[1];
  const double size = spread(20), rate = spread(20);
  for (int i = 0; i < 3; i++) {
    const double r = uniform();
    I[i] = size * m[((swap ? 3 - i : i) + turn) % 3];
    I[3 + i] = 0;
    x[i] = 2 * uniform() - 1;
    x[4 + i] = r < 0.15 ? 0 : rate * (r < 0.4 ? spread(12) : 1) * (2 * uniform() - 1);
  }
  x[3] = 2 * uniform() - 1;
  if (kind == 8) { /* on the separatrix to some units in the last place: I1 (I2 - I1) w1^2 = I3 (I3
                      - I2) w3^2 */
    int o[3] = {0, 1, 2};
    for (int i = 0; i < 3; i++)
      for (int j = i + 1; j < 3; j++)
        if (I[o[j]] < I[o[i]]) {
          const int k = o[i];
          o[i] = o[j];
          o[j] = k;
        }
    const double a = I[o[0]] / size, b = I[o[1]] / size, c = I[o[2]] / size;
    if (c > b && b > a)
      x[4 + o[2]] = x[4 + o[0]] * sqrt(a * (b - a) / (c * (c - b))) *
                    (1 + 0x1p-52 * (int)(uniform() * 5 - 2));
  }
  if (kind == 9)
    for (int i = 0; i < 3; i++)
      I[3 + i] = size * 0.1 * (2 * uniform() - 1) * m[0];
}

static void random_states(long count) {
  double start = 0, norm = 0, momentum = 0, energy = 0;
  long refused = 0;
  for (long n = 0; n < count; n++) {
    double I[6], x0[7], x[7];
    top_model m;
    top_orbit o;
    long double L0[3], L[3], T0, T, G;
    draw(I, x0);
    if (top_init(&m, I) != 0) /* rounding has broken the triangle inequality */
      continue;
    if (top_solve(&o, &m, x0) != 0) {
      refused++;
      continue;
    }
    const double q = length(x0, 4);
    double w = 0;
    for (int i = 4; i < 7; i++)
      w = fmax(w, fabs(x0[i]));
    top_at(&o, 0, x);
    for (int i = 0; i < 7; i++)
      start = larger(start, i < 4 ? fabs(x[i] - x0[i] / q) : fabs(x[i] - x0[i]) / (w > 0 ? w : 1));
    for (int i = 0; i < 4; i++)
      x0[i] = x[i];
    T0 = invariants(I, x0, L0);
    G = sqrtl(L0[0] * L0[0] + L0[1] * L0[1] + L0[2] * L0[2]);
    for (int k = 0; k < 3; k++) {
      top_at(&o, w > 0 ? (2 * uniform() - 1) * spread(6) / w : spread(6), x);
      norm = larger(norm, norm_error(x));
      T = invariants(I, x, L);
      for (int i = 0; i < 3; i++)
        momentum = larger(momentum, G > 0 ? (double)(fabsl(L[i] - L0[i]) / G) : 0);
      energy = larger(energy, T0 > 0 ? (double)(fabsl(T - T0) / T0) : 0);
    }
  }
  printf("random %ld %ld %.3e %.3e %.3e %.3e\n", count, refused, start, norm, momentum, energy);
}

enum { MOST = 67 };

/* NAME_at_many against NAME_at: elements that differ in any bit, and the largest difference;
 * elements touched that are not its own count as differing. */
#define MANY(NAME, REAL, KIND, ORBIT)                                                              \
  do {                                                                                             \
    REAL t[MOST], x[7 * MOST + 1], y[7];                                                           \
    for (int n = 0; n <= MOST; n++) {                                                              \
      int differ = 0;                                                                              \
      double far_away = 0;                                                                         \
      for (int k = 0; k < n; k++)                                                                  \
        t[k] = (REAL)((2 * uniform() - 1) * pow(10, 4 * uniform()));                               \
      for (int k = 0; k <= 7 * MOST; k++)                                                          \
        x[k] = 77;                                                                                 \
      NAME##_at_many(&ORBIT, n, t, x);                                                             \
      for (int k = 0; k < n; k++) {                                                                \
        NAME##_at(&ORBIT, t[k], y);                                                                \
        for (int i = 0; i < 7; i++) {                                                              \
          differ += memcmp(&y[i], &x[i * n + k], sizeof y[i]) != 0;                                \
          far_away =                                                                               \
              larger(far_away, fabs((double)y[i] - (double)x[i * n + k]) / (i < 4 ? 1 : 3));       \
        }                                                                                          \
      }                                                                                            \
      for (int k = 7 * n; k <= 7 * MOST; k++)                                                      \
        differ += !(x[k] > 76 && x[k] < 78);                                                       \
      printf("many " #NAME " %s %d %d %d %.3e\n", KIND, ORBIT.hyperbolic, n, differ, far_away);    \
    }                                                                                              \
  } while (0)

static void many(void) {
  static const struct {
    const char *name;
    double w[3];
  } states[] = {
      {"circular", {1, 0.5, 2}},   {"other", {3, 0.5, 0.25}}, {"near", {3, 0.5, 1.0009765625}},
      {"separatrix", {3, 0.5, 1}}, {"constant", {0, 0, 2}},   {"rest", {0, 0, 0}},
  };
  for (size_t s = 0; s < sizeof states / sizeof states[0]; s++) {
    const double p[6] = {4, 5, 9, 0, 0, 0};
    const float ps[6] = {4, 5, 9, 0, 0, 0};
    double x0[7] = {0.5, 0.5, 0.5, 0.5};
    float s0[7] = {0.5F, 0.5F, 0.5F, 0.5F};
    top_model m;
    top_orbit o;
    small_model ms;
    small_orbit os;
    for (int i = 0; i < 3; i++) {
      x0[4 + i] = states[s].w[i];
      s0[4 + i] = (float)states[s].w[i];
    }
    if (top_init(&m, p) != 0 || top_solve(&o, &m, x0) != 0 || small_init(&ms, ps) != 0 ||
        small_solve(&os, &ms, s0) != 0) {
      printf("many top %s refused\n", states[s].name);
      continue;
    }
    MANY(top, double, states[s].name, o);
    MANY(small, float, states[s].name, os);
  }
}

int main(int argc, char **argv) {
  rows();
  many();
  random_states(argc > 1 ? atol(argv[1]) : 100000);
  return 0;
}
