/* setup.c - states that the emitted closed form of the free top finds: part of setup.t, which
   judges. SPDX-License-Identifier: GPL-3.0-or-later

   Prints lines "KIND scale tensor w0 q0 t w q" in hexadecimal, w and q at t found by the scene top,
   a tensor whose six entries are parameters; scale: how often the error is multiplied, see
   setup.t. KIND "rates": instead of w and q the period and the precession. */
#include "top.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

static uint64_t seed = 88172645463325252u;
static double uniform(void) { /* in (0, 1): xorshift64, Marsaglia 2003 */
  seed ^= seed << 13;
  seed ^= seed >> 7;
  seed ^= seed << 17;
  return ((double)(seed >> 11) + 0.5) * 0x1p-53;
}

static double length(const double w[3]) {
  return sqrt(w[0] * w[0] + w[1] * w[1] + w[2] * w[2]);
}

static void print(const char *kind, double scale, const double I[6], const double x0[7], double t,
                  const double out[], int count) {
  printf("%s %a", kind, scale);
  for (int i = 0; i < 6; i++)
    printf(" %a", I[i]);
  for (int i = 0; i < 7; i++)
    printf(" %a", x0[(i + 4) % 7]);
  printf(" %a", t);
  for (int i = 0; i < count; i++)
    printf(" %a", count == 7 ? out[(i + 4) % 7] : out[i]);
  printf("\n");
}

/* Half of all turns that a phase makes until t, and more. */
static double turns(const double x0[7], double t) {
  return fabs(t) * length(x0 + 4);
}

static int solve(top_orbit *o, const double I[6], const double x0[7]) {
  top_model m;
  if (top_init(&m, I) == 0 && top_solve(o, &m, x0) == 0)
    return 1;
  printf("refused\n");
  return 0;
}

static void at(const char *kind, const double I[6], const double x0[7], double t) {
  top_orbit o;
  double x[7];
  if (!solve(&o, I, x0))
    return;
  top_at(&o, t, x);
  print(kind, turns(x0, t), I, x0, t, x, 7);
}

/* n ticks; n h = t holds exactly */
static void ticks(const double I[6], const double x0[7], int64_t n) {
  const double h = ldexp(uniform(), -30 + (int)(18 * uniform())) / length(x0 + 4);
  top_orbit o;
  double x[7];
  if (!solve(&o, I, x0))
    return;
  if (top_set_tick(&o, h) != 0)
    printf("refused\n");
  top_at_tick(&o, n, x);
  print("tick", turns(x0, h * (double)n), I, x0, h * (double)n, x, 7);
}

static void rates(const double I[6], const double x0[7]) {
  top_orbit o;
  if (!solve(&o, I, x0))
    return;
  const double x[2] = {top_polhode_period(&o), top_precession_rate(&o)};
  print("rates", length(x0 + 4), I, x0, 0, x, 2);
}

/* A body of any proportions, a state of any. */
static void draw(double I[6], double x[7]) {
  double m[3] = {0.05 + uniform(), 0.05 + uniform(), 0};
  const int turn = (int)(uniform() * 3);
  m[2] = fabs(m[0] - m[1]) + uniform() * 0.99 * (m[0] + m[1] - fabs(m[0] - m[1]));
  for (int i = 0; i < 3; i++) {
    I[i] = m[(i + turn) % 3];
    I[3 + i] = 0;
  }
  for (int i = 0; i < 7; i++)
    x[i] = 2 * uniform() - 1;
}

/* k'^2 = 1/34 (1 + off), by a choice of the rate that decides which axis L goes round. */
static void between(const double I[6], double x[7], double off) {
  int o[3] = {0, 1, 2};
  for (int i = 0; i < 3; i++)
    for (int j = i + 1; j < 3; j++)
      if ((I[o[j]] < I[o[i]]) == (x[0] > 0)) {
        const int k = o[i];
        o[i] = o[j];
        o[j] = k;
      }
  const double a = I[o[0]], b = I[o[1]], c = I[o[2]], m = (1 + off) / 34;
  const double d21 = fabs(b - a), d31 = fabs(c - a), d32 = fabs(c - b);
  double *w = x + 4, *w1 = w + o[0], *w2 = w + o[1];
  /* m d32 (b d21 w2^2 + c d31 w3^2) = d31 (c d32 w3^2 - a d21 w1^2) */
  w[o[2]] =
      sqrt((d31 * a * d21 * *w1 * *w1 + m * d32 * b * d21 * *w2 * *w2) / ((1 - m) * c * d32 * d31));
}

/* Moments 8, 14, 21 (times 49) turned by the quaternion 2, 1, 1, 1: entries and, for rates that are
   multiples of 7, rates are integers. The separatrix is 7 w3 = 4 w1; off it by w3 = 4/7 w1 + off.
 */
static void oblique(double I[6], double x[7], double off) {
  static const double R[3][3] = {{3, -2, 6}, {6, 3, -2}, {-2, 6, 3}}, m[3] = {8, 14, 21};
  static const int row[6] = {0, 1, 2, 0, 0, 1}, column[6] = {0, 1, 2, 1, 2, 2};
  const double w1 = 7 * 64, principal[3] = {w1, floor((2 * uniform() - 1) * 100) * 7, w1 * 4 / 7};
  for (int i = 0; i < 6; i++) {
    I[i] = 0;
    for (int k = 0; k < 3; k++)
      I[i] += R[row[i]][k] * R[column[i]][k] * m[k];
  }
  for (int i = 0; i < 3; i++) {
    x[4 + i] = 0;
    for (int k = 0; k < 3; k++)
      x[4 + i] += R[i][k] * principal[k] / 7;
    x[4 + i] += R[i][2] / 7 * off * w1;
  }
}

int main(void) {
  static const double off[] = {0, 1e-15, -1e-15, 1e-12, -1e-12, 1e-8, -1e-8, 1e-3, -1e-3};
  double I[6], x[7];
  for (int n = 0; n < 180; n++) {
    draw(I, x);
    between(I, x, off[n % 9]);
    at("between", I, x, ldexp(uniform(), n % 30) / length(x + 4));
    rates(I, x);
  }
  for (int n = 0; n < 100; n++) {
    draw(I, x);
    ticks(I, x, (n % 2 ? 1 : -1) * ((int64_t)1 << 62));
    draw(I, x);
    between(I, x, n % 2 ? 1e-4 : -1e-4);
    ticks(I, x, (n % 2 ? 1 : -1) * ((int64_t)1 << 62));
    draw(I, x);
    between(I, x, 1e-14 - 1); /* near the separatrix */
    ticks(I, x, (n % 2 ? 1 : -1) * ((int64_t)1 << 62));
    rates(I, x);
    draw(I, x);
    rates(I, x);
  }
  for (int n = 0; n < 150; n++) {
    draw(I, x);
    oblique(I, x, (n % 2 ? 1 : -1) * pow(10, -16 + 5 * uniform()));
    at("oblique", I, x, ldexp(uniform(), 4 + n % 16) / length(x + 4));
  }
  return 0;
}
