/* gyrostat.c - measures the emitted closed form of the asymmetric gyrostat: part of gyrostat.t,
   which judges. SPDX-License-Identifier: GPL-3.0-or-later

     measure cases STATES   lines for tests/oracle/heavy_top -r -e, each after its name, |q| - 1 and
   what the pace is over the rates: hard motions and random states measure rows           "row ID
   TIME dw dq norm" against the table measure random STATES  "random STATES refused nan start norm T
   M many rates ticks": the worst measure float STATES   "float STATES dw dq": the float code
   against the double one at inputs that both hold, kinds without exponential growth

   Errors of rates are over the largest rate of the motion, M/I with I the smallest moment where
   that is larger. The emitted code is two compiled scenes, dual (double) and small (float), of any
   moments and a rotor along z. */
#include "dual.h"
#include "forced_top.h"
#include "small.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static double larger(double a, double b) {
  return b <= a ? a : b;
} /* a NaN stays */

/* b: moments and momentum */
static int prepare(dual_orbit *o, dual_model *m, const double b[4], const double x0[7]) {
  double p[DUAL_NP];
  p[DUAL_A] = b[0];
  p[DUAL_B] = b[1];
  p[DUAL_C] = b[2];
  p[DUAL_H] = b[3];
  return dual_init(m, p) != 0 || dual_solve(o, m, x0) != 0;
}

static double norm_error(const double *q) {
  long double s = 0;
  for (int i = 0; i < 4; i++)
    s += (long double)q[i] * q[i];
  return (double)fabsl(sqrtl(s) - 1);
}

/* ---- random and hard states ---- */

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

enum { KINDS = 17 };

/* moments, momentum and x0 of one kind */
static void draw(double b[4], double x[7], int kind) {
  const double small = uniform() < 0.2 ? 0 : spread(8) * 1e-8;
  const double e[3] = {uniform() + 0.05, uniform() + 0.05, uniform() + 0.05};
  b[0] = e[1] + e[2], b[1] = e[0] + e[2], b[2] = e[0] + e[1], b[3] = bell() * spread(0.5);
  for (int i = 0; i < 4; i++)
    x[i] = bell();
  for (int i = 4; i < 7; i++)
    x[i] = 2 * bell();
  switch (kind) {
  case 1: /* the free top */
    b[3] = 0;
    break;
  case 2: /* a symmetric one */
    b[1] = b[0];
    break;
  case 3: /* almost one */
    b[1] = b[0] * (1 + small * bell());
    break;
  case 4: /* a fast rotor, a platform that hardly turns */
    b[3] = 10 * spread(1);
    for (int i = 4; i < 7; i++)
      x[i] *= small + 1e-3;
    break;
  case 5: /* whole numbers */
    for (int i = 0; i < 7; i++)
      x[i] = floor(3 * bell());
    b[0] = 2 + floor(2 * uniform()), b[1] = 2 + floor(2 * uniform()),
    b[2] = 2 + floor(3 * uniform());
    b[3] = floor(4 * bell());
    break;
  case 6: /* about the rotor's axis */
    x[4] = small * bell(), x[5] = small * bell();
    break;
  case 7: /* permanent rotations, and almost, about axes between 1 and 3: w3 = h/(I1 - I3), w1 any
           */
    x[5] = small * bell();
    x[6] = b[3] / (b[0] - b[2]) * (1 + small * bell());
    break;
  case 8: /* between 2 and 3 */
    x[4] = small * bell();
    x[6] = b[3] / (b[1] - b[2]) * (1 + small * bell());
    break;
  case 9: /* hardly any momentum */
    x[4] = small * bell(), x[5] = small * bell();
    x[6] = -b[3] / b[2] * (1 + small * bell());
    break;
  case 10: /* at a turn: in a coordinate plane */
    x[4 + (uniform() < 0.5)] = small * bell();
    break;
  case 11: /* moments almost equal to that of the rotor's axis */
    b[uniform() < 0.5] = b[2] * (1 + small * bell());
    break;
  case 12: /* a sphere, almost */
    b[0] = b[2] * (1 + small * bell()), b[1] = b[2] * (1 + small * bell());
    break;
  case 13: /* two bands of equal width, almost: the saddle on axis 3, h small */
    b[0] = 1, b[1] = 3, b[2] = 2, b[3] = small * bell();
    x[4] = small * bell(), x[5] = small * bell();
    break;
  case 14: { /* units */
    const double mass = spread(30), time = spread(15);
    for (int i = 0; i < 3; i++) {
      b[i] *= mass;
      x[4 + i] *= time;
    }
    b[3] *= mass * time;
    break;
  }
  case 15: /* graded */
    for (int i = 4; i < 7; i++)
      x[i] *= spread(8);
    b[3] *= spread(8);
    break;
  case 16: /* none at all: h + I3 w3 = 0 exactly, or no rates */
    b[2] = 2, b[0] = 1.5 + uniform(), b[1] = 1.5 + uniform();
    x[4] = x[5] = 0, x[6] = floor(8 * bell()), b[3] = uniform() < 0.7 ? -2 * x[6] : 0;
    break;
  default:
    break;
  }
  if (x[0] == 0 && x[1] == 0 && x[2] == 0 && x[3] == 0)
    x[0] = 1;
}

/* the largest of |w| and |M|/I */
static double pace(const double b[4], const double x[7]) {
  const double M = hypot(hypot(b[0] * x[4], b[1] * x[5]), b[2] * x[6] + b[3]);
  const double w = hypot(hypot(x[4], x[5]), x[6]), I = fmin(fmin(b[0], b[1]), b[2]);
  const double p = larger(w, M / I);
  return p > 0 ? p : 1;
}

static void print_cases(long count) {
  for (long n = 0; n < count; n++) {
    double b[4], x0[7], x[7];
    dual_model m;
    dual_orbit o;
    const int kind = (int)(n % KINDS);
    draw(b, x0, kind);
    if (prepare(&o, &m, b, x0))
      continue;
    const double t = (uniform() - 0.3) * 60 / pace(b, x0);
    dual_at(&o, t, x);
    const double most =
        larger(larger(fabs(x[4]), fabs(x[5])), fabs(x[6])); /* what the oracle divides by */
    printf("kind %d, %d, q = %g; %.3e %.3e; %a %a %a 0 0 %a", kind, o.hyperbolic, o.nome,
           norm_error(x), most > 0 ? pace(b, x0) / most : 1, b[0], b[1], b[2], b[3]);
    for (int i = 0; i < 7; i++)
      printf(" %a", i < 3 ? x0[4 + i] : x0[i - 3]);
    printf(" %a", t);
    for (int i = 0; i < 7; i++)
      printf(" %a", i < 3 ? x[4 + i] : x[i - 3]);
    printf("\n");
  }
}

static void rows(void) {
  for (size_t k = 0; k < sizeof forced_top_rows / sizeof forced_top_rows[0]; k++) {
    double b[4], x0[7], x[7];
    long double most = 0, dw = 0, plus = 0, minus = 0;
    dual_model m;
    dual_orbit o;
    if (forced_top_rows[k].model != FORCED_ROTOR)
      continue;
    for (int i = 0; i < 3; i++)
      b[i] = forced_top_rows[k].moment[i];
    b[3] = forced_top_rows[k].load[2];
    for (int i = 0; i < 7; i++)
      x0[i] = forced_top_rows[k].x0[i < 4 ? 3 + i : i - 4];
    if (prepare(&o, &m, b, x0)) {
      printf("row %s refused\n", forced_top_rows[k].id);
      continue;
    }
    dual_at(&o, forced_top_rows[k].t, x);
    for (int i = 0; i < 3; i++) {
      const long double want = forced_top_rows[k].x[i];
      most = fmaxl(most, fabsl(want));
      if (!(fabsl(x[4 + i] - want) <= dw))
        dw = fabsl(x[4 + i] - want);
    }
    for (int i = 0; i < 4; i++) {
      const long double want = forced_top_rows[k].x[3 + i];
      plus += (x[i] - want) * (x[i] - want);
      minus += (x[i] + want) * (x[i] + want);
    }
    printf("row %s %g %.3Le %.3Le %.3e\n", forced_top_rows[k].id, forced_top_rows[k].t, dw / most,
           2 * sqrtl(minus < plus ? minus : plus), norm_error(x));
  }
}

/* w.I w and M in inertial axes */
static void invariants(const double b[4], const double x[7], long double *T, long double M[3]) {
  const long double w = x[0], i = x[1], j = x[2], k = x[3], n = w * w + i * i + j * j + k * k;
  const long double L[3] = {(long double)b[0] * x[4], (long double)b[1] * x[5],
                            (long double)b[2] * x[6] + b[3]};
  *T = (long double)b[0] * x[4] * x[4] + (long double)b[1] * x[5] * x[5] +
       (long double)b[2] * x[6] * x[6];
  M[0] = ((w * w + i * i - j * j - k * k) * L[0] + 2 * (i * j - w * k) * L[1] +
          2 * (i * k + w * j) * L[2]) /
         n;
  M[1] = (2 * (i * j + w * k) * L[0] + (w * w - i * i + j * j - k * k) * L[1] +
          2 * (j * k - w * i) * L[2]) /
         n;
  M[2] = (2 * (i * k - w * j) * L[0] + 2 * (j * k + w * i) * L[1] +
          (w * w - i * i - j * j + k * k) * L[2]) /
         n;
}

static void random_states(long count) {
  double start = 0, norm = 0, energy = 0, momentum = 0, many = 0, rates = 0, ticks = 0;
  long refused = 0, wrong = 0;
  for (long n = 0; n < count; n++) {
    double b[4], x0[7], x[7], z[7], t[12], table[84], w[3], q[4], d[2] = {0, 0}, length = 0, f[7];
    long double T0, M0[3], T, M[3];
    dual_model m;
    dual_orbit o;
    draw(b, x0, (int)(n % KINDS));
    if (prepare(&o, &m, b, x0)) {
      refused++;
      continue;
    }
    for (int i = 0; i < 4; i++)
      length += x0[i] * x0[i];
    length = sqrt(length);
    const double scale = pace(b, x0), I = larger(larger(b[0], b[1]), b[2]);
    dual_at(&o, 0, x);
    for (int i = 0; i < 4; i++) {
      d[0] += (x[i] - x0[i] / length) * (x[i] - x0[i] / length);
      d[1] += (x[i] + x0[i] / length) * (x[i] + x0[i] / length);
    }
    start = larger(start, sqrt(d[0] < d[1] ? d[0] : d[1]));
    for (int i = 4; i < 7; i++)
      start = larger(start, fabs(x[i] - x0[i]) / scale);
    invariants(b, x0, &T0, M0);
    const double period = dual_polhode_period(&o);
    for (int k = 0; k < 4; k++)
      t[k] = k < 3            ? (uniform() - 0.5) * 100 * spread(3) / scale
             : period < 1e300 ? period * floor(uniform() * 1e6)
                              : 0;
    for (int k = 4; k < 12; k++)
      t[k] = t[k - 4];
    dual_at_many(&o, 12, t, table); /* a block of eight and four more */
    for (int k = 0; k < 4; k++) {
      dual_at(&o, t[k], x);
      dual_at_rates(&o, t[k], w);
      dual_at_attitude(&o, t[k], q);
      for (int i = 0; i < 7; i++) {
        wrong += !(x[i] - x[i] == 0);
        many = larger(many, fabs(table[i * 12 + k] - x[i]) / (i < 4 ? 1 : scale));
        many = larger(many, fabs(table[i * 12 + k + 8] - x[i]) / (i < 4 ? 1 : scale));
        many = larger(many, fabs((i < 4 ? q[i] : w[i - 4]) - x[i]) / (i < 4 ? 1 : scale));
      }
      /* the same time by ticks, there and back, as long as pairs have digits left */
      for (int sign = -1; sign < 2 && fabs(t[k]) * scale < 0x1p40; sign += 2) {
        wrong += dual_set_tick(&o, sign * ldexp(t[k], -20)) != 0;
        dual_at_tick(&o, sign * ((int64_t)1 << 20), z);
        for (int i = 0; i < 7; i++)
          ticks = larger(ticks, fabs(z[i] - x[i]) / (i < 4 ? 1 : scale));
      }
      norm = larger(norm, norm_error(x));
      invariants(b, x, &T, M);
      energy = larger(energy, (double)(fabsl(T - T0) / (I * scale * scale)));
      for (int i = 0; i < 3; i++)
        momentum = larger(momentum, (double)(fabsl(M[i] - M0[i]) / (I * scale)));
      /* the equations of motion: a central difference, exact to h^2 and to rounding/h */
      if (fabs(t[k]) * scale < 1e4) {
        const double h = 0x1p-16 / scale;
        double before[7], after[7];
        dual_at(&o, t[k] + h, after);
        dual_at(&o, t[k] - h, before);
        dual_rhs(&m, 0, x, NULL, f);
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
  for (long n = 0; n < count; n++) {
    double b[4], x0[7], x[7], plus = 0, minus = 0, e = 0;
    float p[SMALL_NP], s0[7], s[7];
    dual_model m;
    dual_orbit o;
    small_model ms;
    small_orbit os;
    draw(b, x0, (int)(n % 6)); /* well conditioned ones */
    for (int i = 0; i < 7; i++) {
      s0[i] = (float)x0[i];
      x0[i] = s0[i];
    }
    for (int i = 0; i < 4; i++)
      b[i] = (float)b[i];
    p[SMALL_A] = (float)b[0];
    p[SMALL_B] = (float)b[1];
    p[SMALL_C] = (float)b[2];
    p[SMALL_H] = (float)b[3];
    if (prepare(&o, &m, b, x0) || small_init(&ms, p) != 0 || small_solve(&os, &ms, s0) != 0)
      continue;
    const double scale = pace(b, x0);
    const float t = (float)((uniform() - 0.5) * 20 / scale);
    dual_at(&o, t, x);
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
  printf("float %ld %.3e %.3e\n", count, dw, dq);
}

int main(int argc, char **argv) {
  const long count = argc > 2 ? atol(argv[2]) : 1000;
  if (argc > 1 && strcmp(argv[1], "cases") == 0)
    print_cases(count);
  else if (argc > 1 && strcmp(argv[1], "rows") == 0)
    rows();
  else if (argc > 1 && strcmp(argv[1], "random") == 0)
    random_states(count);
  else if (argc > 1 && strcmp(argv[1], "float") == 0)
    floats(count);
  else
    return 2;
  return 0;
}
