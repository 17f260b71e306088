/* lagrange.c - measures the emitted closed form of the heavy symmetric top: part of lagrange.t,
   which judges. SPDX-License-Identifier: GPL-3.0-or-later

     measure cases          lines for tests/oracle/heavy_top -e, each after its name and |q| - 1, to
   stdout measure rows           "row ID TIME dw dq norm" against the table measure random STATES
   "random STATES refused nan start norm E L many rates": worst of random and hard states measure
   float STATES   "float STATES dw dq": the float code against the double one at inputs that both
   hold

   Errors of rates are over the largest rate of the motion. The emitted code is two compiled scenes,
   top (double) and small (float): moments A, A, C about the fixed point, the centre of mass at l on
   the axis. */
#include "forced_top.h"
#include "small.h"
#include "top.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define ARM 0x1p-100 /* the scene's length: so small that it never spoils A */

static double larger(double a, double b) {
  return b <= a ? a : b;
} /* a NaN stays */

static int prepare(top_orbit *o, top_model *m, double A, double C, double mgl, const double x0[7]) {
  double p[TOP_NP];
  p[TOP_A] = A;
  p[TOP_C] = C;
  p[TOP_G] = fabs(mgl) / ARM;
  p[TOP_L] = mgl < 0 ? -ARM : ARM;
  return top_init(m, p) != 0 || top_solve(o, m, x0) != 0;
}

static double norm_error(const double *q) {
  long double s = 0;
  for (int i = 0; i < 4; i++)
    s += (long double)q[i] * q[i];
  return (double)fabsl(sqrtl(s) - 1);
}

/* ---- hard motions ---- */

static const struct {
  const char *name;
  double A, C, mgl, q[4], w[3], t; /* and t/7, -t/3 */
} cases[] = {
    {"waves", 1, 0.5, 2, {0.9, 0.3, 0.1, -0.2}, {1, 0.5, 5}, 10},
    {"loops", 1, 0.5, 2, {0.9, 0.4, 0.1, 0}, {-2, 1, 9}, 10},
    {"cusps", 1, 0.5, 2, {0.8, 0.6, 0, 0}, {0, 0, 8}, 20},
    {"from rest", 1, 0.5, 2, {0.8, 0.6, 0, 0}, {0, 0, 0}, 20},
    {"tiny spin", 1, 0.5, 2, {0.8, 0.6, 0, 0}, {0, 0, 1e-9}, 20},
    {"steady precession", 1, 0.5, 2, {0.8, 0.6, 0, 0}, {0, 0.96, 4.56}, 20},
    {"almost steady", 1, 0.5, 2, {0.8, 0.6, 0, 0}, {1e-9, 0.96, 4.56}, 20},
    {"slow precession", 1, 0.5, 0x1p-20, {0.8, 0.6, 0, 0}, {0, 0, 8}, 20},
    {"sleeping, fast", 1, 0.5, 2, {1, 0, 0, 0}, {0, 0, 20}, 5},
    {"almost sleeping, fast", 1, 0.5, 2, {1, 1e-9, 0, 0}, {0, 1e-9, 20}, 5},
    {"hardly asleep", 1, 0.5, 2, {1, 1e-100, 0, 0}, {0, 1e-100, 20}, 5},
    {"sleeping, slow", 1, 0.5, 2, {1, 0, 0, 0}, {0, 0, 2}, 20},
    {"waking", 1, 0.5, 2, {1, 1e-3, 0, 0}, {0, 0, 2}, 20},
    {"waking from 1e-8", 1, 0.5, 2, {1, 0, 0, 1}, {1e-8, 0, 2}, 30},
    {"waking from 1e-20", 1, 0.5, 2, {1, 1e-20, 0, 0}, {0, 0, 2}, 40},
    {"waking from 1e-200", 1, 0.5, 2, {1, 1e-200, 0, 1}, {3e-200, 0, 2}, 400},
    {"critical", 1, 0.5, 1, {1, 0, 0, 0}, {0, 0, 4}, 20},
    {"almost critical", 1, 0.5, 1, {1, 1e-3, 1e-4, 0}, {1e-3, -2e-3, 4}, 60},
    {"critical, locked", 1, 0.5, 1, {1, 1e-2, 0, 0}, {0, 1e-2, 4}, 60},
    {"critical, tilted", 1, 0.5, 1, {1, 1e-5, 0, 0}, {0, 0, 4}, 60},
    {"above critical", 1, 0.5, 1, {1, 1e-4, 0, 0}, {0, 1e-4, 4.0001}, 60},
    {"below critical", 1, 0.5, 1, {1, 1e-4, 0, 0}, {0, 1e-4, 3.9999}, 60},
    {"hanging", 1, 0.5, 2, {0, 1, 0, 0}, {0, 0, 5}, 20},
    {"almost hanging", 1, 0.5, 2, {1e-7, 1, 0, 0}, {0, 1e-7, 5}, 20},
    {"hanging, hardly moved", 1, 0.5, 2, {1e-120, 1, 0, 0}, {0, 1e-120, 5}, 20},
    {"spherical pendulum", 1, 0.5, 2, {0.3, 0.9, 0.2, 0.1}, {1, 0.5, 0}, 20},
    {"conical pendulum", 1, 0.5, 1, {0.6, 0.8, 0, 0}, {0, 2, 0}, 20},
    {"plane pendulum", 1, 0.5, 2, {0.6, 0.8, 0, 0}, {0.5, 0, 0}, 20},
    {"plane pendulum, rotating", 1, 0.5, 2, {0.6, 0.8, 0, 0}, {5, 0, 0}, 10},
    {"separatrix", 1, 0.5, 1, {0, 1, 0, 0}, {2, 0, 0}, 15},
    {"separatrix, for long", 1, 0.5, 1, {0, 1, 0, 0}, {2, 0, 0}, 60},
    {"just over", 1, 0.5, 1, {0, 1, 0, 0}, {2 + 0x1p-50, 0, 0}, 60},
    {"just below", 1, 0.5, 1, {0, 1, 0, 0}, {2 - 0x1p-50, 0, 0}, 60},
    {"just beside", 1, 0.5, 1, {0, 1, 0, 0}, {2, 0, 1e-12}, 60},
    {"pendulum from rest near the top", 1, 0.5, 1, {1, 1e-12, 0, 0}, {0, 0, 0}, 80},
    {"spinning, from rest near the top", 1, 0.5, 1, {1, 1e-12, 1e-13, 0}, {0, 0, 1}, 80},
    {"through the top", 1, 0.5, 2, {1, 0, 0, 0}, {1, 0, 3}, 20},
    {"past the top", 1, 0.5, 2, {1, 1e-10, 0, 0}, {1, 0, 3}, 20},
    {"through the bottom", 1, 0.5, 2, {0, 0.8, 0.6, 0}, {1, 0, 3}, 20},
    {"past the bottom", 1, 0.5, 2, {0, 0.8, 0.6, 1e-10}, {1, 0, 3}, 20},
    {"no weight", 1, 0.5, 0, {0.9, 0.3, 0.1, -0.2}, {1, 0.5, 5}, 10},
    {"no weight, no spin", 1, 0.5, 0, {0.9, 0.3, 0.1, -0.2}, {1, 0.5, 0}, 10},
    {"no weight, spin only", 1, 0.5, 0, {0.9, 0.3, 0.1, -0.2}, {0, 0, 5}, 10},
    {"hardly any weight", 1, 0.5, 1e-20, {0.9, 0.3, 0.1, -0.2}, {1, 0.5, 5}, 10},
    {"weight below", 1, 0.5, -2, {0.9, 0.3, 0.1, -0.2}, {1, 0.5, 5}, 10},
    {"weight below, asleep", 1, 0.5, -2, {1, 0, 0, 0}, {0, 0, 2}, 10},
    {"disc", 1, 2, 1, {0.9, 0.3, 0.1, -0.2}, {1, 0.5, 3}, 10},
    {"thin", 1, 1e-6, 1, {0.9, 0.3, 0.1, -0.2}, {1, 0.5, 300}, 5},
    {"rod", 1, 0, 1, {0.9, 0.3, 0.1, -0.2}, {1, 0.5, 3}, 10},
    {"sphere", 1, 1, 1, {0.9, 0.3, 0.1, -0.2}, {1, 0.5, 3}, 10},
    {"huge", 1e30, 0.5e30, 2e30, {0.9, 0.3, 0.1, -0.2}, {1, 0.5, 5}, 10},
    {"tiny", 1e-30, 0.5e-30, 2e-30, {0.9, 0.3, 0.1, -0.2}, {1, 0.5, 5}, 10},
    {"fast", 1, 0.5, 2e28, {0.9, 0.3, 0.1, -0.2}, {1e14, 0.5e14, 5e14}, 1e-13},
    {"slow", 1, 0.5, 2e-30, {0.9, 0.3, 0.1, -0.2}, {1e-15, 0.5e-15, 5e-15}, 1e16},
};

static void print_cases(int longer) {
  for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
    double x0[7], x[7];
    top_model m;
    top_orbit o;
    memcpy(x0, cases[k].q, sizeof cases[k].q);
    memcpy(x0 + 4, cases[k].w, sizeof cases[k].w);
    if (prepare(&o, &m, cases[k].A, cases[k].C, cases[k].mgl, x0)) {
      printf("%s, refused\n", cases[k].name);
      continue;
    }
    double period = top_nutation_period(&o), tilt[2];
    top_nutation_range(&o, tilt);
    /* the oracle finds the period from gamma_z, which must change, and must not be 1 to all digits
     * for most of it */
    if (longer && !(period > 0 && period < 1e300 && tilt[1] - tilt[0] > 1e-3 && tilt[0] < 3 &&
                    (tilt[0] > 1e-50 || tilt[0] <= 0)))
      continue;
    for (int n = 0; n < (longer ? 1 : 3); n++) {
      const double t = longer   ? 1.2345678e6 * period
                       : n == 0 ? cases[k].t
                       : n == 1 ? cases[k].t / 7
                                : -cases[k].t / 3;
      top_at(&o, t, x);
      printf("%s: t = %g; %.3e; %a %a %a 0 0 %a", cases[k].name, t, norm_error(x), cases[k].A,
             cases[k].A, cases[k].C, cases[k].mgl);
      for (int i = 0; i < 7; i++)
        printf(" %a", i < 3 ? x0[4 + i] : x0[i - 3]);
      printf(" %a", t);
      if (longer)
        printf(" %a", period);
      for (int i = 0; i < 7; i++)
        printf(" %a", i < 3 ? x[4 + i] : x[i - 3]);
      printf("\n");
    }
  }
}

/* ---- the table: rows whose body is symmetric about a coordinate axis ---- */

static void product(const double a[4], const double b[4], double out[4]) {
  out[0] = a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3];
  out[1] = a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2];
  out[2] = a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1];
  out[3] = a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0];
}

static void rows(void) {
  for (size_t k = 0; k < sizeof forced_top_rows / sizeof forced_top_rows[0]; k++) {
    const double *I = forced_top_rows[k].moment, *r = forced_top_rows[k].load;
    int axis = -1;
    for (int i = 0; i < 3; i++)
      if (forced_top_rows[k].model == FORCED_HEAVY && I[(i + 1) % 3] == I[(i + 2) % 3] &&
          r[(i + 1) % 3] == 0 && r[(i + 2) % 3] == 0)
        axis = i;
    if (axis < 0)
      continue;
    /* the axes are renamed in a circle: a third of a turn, which is exact but for halves */
    const double turn[4] = {axis == 2 ? 1 : 0.5,
                            axis == 2   ? 0
                            : axis == 0 ? 0.5
                                        : -0.5,
                            axis == 2   ? 0
                            : axis == 0 ? 0.5
                                        : -0.5,
                            axis == 2   ? 0
                            : axis == 0 ? 0.5
                                        : -0.5};
    const double back[4] = {turn[0], -turn[1], -turn[2], -turn[3]};
    const int own[3] = {(axis + 1) % 3, (axis + 2) % 3, axis};
    double x0[7], x[7], q[4];
    long double dw = 0, most = 0, plus = 0, minus = 0;
    top_model m;
    top_orbit o;
    product(forced_top_rows[k].x0 + 3, turn, x0);
    for (int i = 0; i < 3; i++)
      x0[4 + i] = forced_top_rows[k].x0[own[i]];
    if (prepare(&o, &m, I[own[0]], I[axis], r[axis], x0)) {
      printf("row %s refused\n", forced_top_rows[k].id);
      continue;
    }
    top_at(&o, forced_top_rows[k].t, x);
    product(x, back, q);
    for (int i = 0; i < 3; i++) {
      const long double want = forced_top_rows[k].x[own[i]];
      most = fmaxl(most, fabsl(want));
      if (!(fabsl(x[4 + i] - want) <= dw))
        dw = fabsl(x[4 + i] - want);
    }
    for (int i = 0; i < 4; i++) {
      const long double want = forced_top_rows[k].x[3 + i];
      plus += (q[i] - want) * (q[i] - want);
      minus += (q[i] + want) * (q[i] + want);
    }
    printf("row %s %g %.3Le %.3Le %.3e\n", forced_top_rows[k].id, forced_top_rows[k].t, dw / most,
           2 * sqrtl(minus < plus ? minus : plus), norm_error(x));
  }
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

/* A, C, mgl and x0 of one of sixteen kinds */
static void draw(double body[3], double x[7], int wild) {
  const double small = uniform() < 0.2 ? 0 : spread(10) * 1e-10;
  double A = spread(1), C = A * 2 * uniform(), g = spread(1);
  for (int i = 0; i < 4; i++)
    x[i] = bell();
  for (int i = 4; i < 7; i++)
    x[i] = 2 * bell();
  switch ((int)(uniform() * (wild ? 16 : 11))) {
  case 1: /* cusps */
    x[4] = x[5] = 0;
    break;
  case 2: /* no spin */
    x[6] = 0;
    break;
  case 3: /* in a plane */
    x[2] = x[3] = x[5] = x[6] = 0;
    break;
  case 4:
    g = 0;
    break;
  case 5:
    g = -g;
    break;
  case 6: /* a rod */
    C = 0;
    break;
  case 7: { /* steady precession, and almost */
    const double c = bell() / 1.6, rate = spread(1), s = sqrt((1 - c) / 2),
                 half = sqrt((1 + c) / 2);
    A = g = 1, C = 0.5;
    x[0] = half, x[1] = s, x[2] = x[3] = 0;
    x[4] = small * bell(), x[5] = rate * 2 * s * half * (1 + small * bell());
    x[6] = (rate * c + 1 / rate) / C;
    break;
  }
  case 8: /* whole numbers */
    for (int i = 0; i < 7; i++)
      x[i] = floor(3 * bell());
    A = 1, C = uniform() < 0.5 ? 1 : 0.5, g = floor(3 * bell());
    break;
  case 9: /* through the top */
    x[0] = 1, x[1] = x[2] = x[3] = 0;
    break;
  case 10: /* hanging */
    x[0] = small * bell(), x[3] = small * bell(), x[4] = small * bell(), x[5] = small * bell();
    break;
  case 11: /* about the critical spin */
    x[0] = 1, x[1] = small, x[2] = small * bell(), x[4] = small * bell(), x[5] = small * bell();
    C += 1e-3 * A;
    x[6] = sqrt(4 * g * A) / C * (1 + small * bell());
    break;
  case 12: /* upright */
    x[0] = 1, x[1] = small, x[2] = small * bell(), x[4] = small * bell(), x[5] = small * bell();
    x[6] = spread(2);
    break;
  case 13: /* the pendulum near its separatrix */
    A = g = 1, C = 0.5;
    x[0] = x[2] = x[3] = 0, x[1] = 1;
    x[4] = 2 * (1 + small * bell()), x[5] = 0, x[6] = small * bell();
    break;
  case 14: { /* units */
    const double mass = spread(30), time = spread(15);
    A *= mass, C *= mass, g *= mass * time * time;
    for (int i = 4; i < 7; i++)
      x[i] *= time;
    break;
  }
  case 15: /* graded */
    for (int i = 4; i < 7; i++)
      x[i] *= spread(8);
    g *= spread(8);
    break;
  default:
    break;
  }
  if (x[0] == 0 && x[1] == 0 && x[2] == 0 && x[3] == 0)
    x[0] = 1;
  body[0] = A, body[1] = C, body[2] = g;
}

/* energy without the spin's, and the component of L along the vertical */
static void invariants(const double body[3], const double x[7], long double *E, long double *L) {
  const long double w = x[0], a = x[1], b = x[2], c = x[3], n = w * w + a * a + b * b + c * c;
  const long double up[3] = {2 * (a * c - w * b) / n, 2 * (b * c + w * a) / n,
                             (w * w + c * c - a * a - b * b) / n};
  *E = body[0] * ((long double)x[4] * x[4] + (long double)x[5] * x[5]) / 2 + body[2] * up[2];
  *L = body[0] * (up[0] * x[4] + up[1] * x[5]) + body[1] * up[2] * x[6];
}

static void random_states(long count) {
  double start = 0, norm = 0, energy = 0, momentum = 0, many = 0, rates = 0, ticks = 0;
  long refused = 0, wrong = 0;
  for (long n = 0; n < count; n++) {
    double body[3], x0[7], x[7], z[7], t[12], table[84], w[3], q[4], d[2] = {0, 0}, length = 0,
                                                                     f[7];
    long double E0, L0, E, L;
    top_model m;
    top_orbit o;
    draw(body, x0, 1);
    if (prepare(&o, &m, body[0], body[1], body[2], x0)) {
      refused++;
      continue;
    }
    for (int i = 0; i < 4; i++)
      length += x0[i] * x0[i];
    length = sqrt(length);
    double scale = sqrt(fabs(body[2]) / body[0]);
    for (int i = 4; i < 7; i++)
      scale = larger(scale, fabs(x0[i]));
    scale = scale > 0 ? scale : 1;
    top_at(&o, 0, x);
    for (int i = 0; i < 4; i++) {
      d[0] += (x[i] - x0[i] / length) * (x[i] - x0[i] / length);
      d[1] += (x[i] + x0[i] / length) * (x[i] + x0[i] / length);
    }
    start = larger(start, sqrt(d[0] < d[1] ? d[0] : d[1]));
    for (int i = 4; i < 7; i++)
      start = larger(start, fabs(x[i] - x0[i]) / scale);
    invariants(body, x0, &E0, &L0);
    const double period = top_nutation_period(&o);
    for (int k = 0; k < 4; k++)
      t[k] = k < 3            ? (uniform() - 0.5) * 100 * spread(3) / scale
             : period < 1e300 ? period * floor(uniform() * 1e6)
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
      invariants(body, x, &E, &L);
      energy = larger(energy, (double)(fabsl(E - E0) / (body[0] * scale * scale)));
      momentum = larger(momentum, (double)(fabsl(L - L0) / ((body[0] + body[1]) * scale)));
      /* the equations of motion: a central difference, exact to h^2 and to rounding/h */
      if (fabs(t[k]) * scale < 1e4) {
        const double h = 0x1p-16 / scale;
        double a[7], b[7];
        top_at(&o, t[k] + h, a);
        top_at(&o, t[k] - h, b);
        top_rhs(&m, 0, x, NULL, f);
        const double span = (t[k] + h) - (t[k] - h);
        for (int i = 0; i < 7; i++)
          rates =
              larger(rates, fabs((a[i] - b[i]) / span - f[i]) / (i < 4 ? scale : scale * scale));
      }
    }
  }
  printf("random %ld %ld %ld %.3e %.3e %.3e %.3e %.3e %.3e %.3e\n", count, refused, wrong, start,
         norm, energy, momentum, many, rates, ticks);
}

static void floats(long count) {
  double dw = 0, dq = 0;
  for (long n = 0; n < count; n++) {
    double body[3], x0[7], x[7], plus = 0, minus = 0, e = 0;
    float p[SMALL_NP], s0[7], s[7];
    top_model m;
    top_orbit o;
    small_model ms;
    small_orbit os;
    draw(body, x0, 0);
    for (int i = 0; i < 7; i++) {
      s0[i] = (float)x0[i];
      x0[i] = s0[i];
    }
    for (int i = 0; i < 3; i++)
      body[i] = (float)body[i];
    p[SMALL_A] = (float)body[0];
    p[SMALL_C] = (float)body[1];
    p[SMALL_G] = (float)(fabs(body[2]) / ARM);
    p[SMALL_L] = (float)(body[2] < 0 ? -ARM : ARM);
    if (prepare(&o, &m, body[0], body[1], body[2], x0) || small_init(&ms, p) != 0 ||
        small_solve(&os, &ms, s0) != 0) {
      printf("float refused\n");
      continue;
    }
    double scale = sqrt(fabs(body[2]) / body[0]);
    for (int i = 4; i < 7; i++)
      scale = larger(scale, fabs(x0[i]));
    const float t = (float)((uniform() - 0.5) * 100 * spread(2) / (scale > 0 ? scale : 1));
    top_at(&o, t, x);
    small_at(&os, t, s);
    for (int i = 0; i < 4; i++) {
      plus += (x[i] - (double)s[i]) * (x[i] - (double)s[i]);
      minus += (x[i] + (double)s[i]) * (x[i] + (double)s[i]);
    }
    for (int i = 4; i < 7; i++)
      e = larger(e, fabs(x[i] - (double)s[i]) / (scale > 0 ? scale : 1));
    dw = larger(dw, e);
    dq = larger(dq, sqrt(plus < minus ? plus : minus));
  }
  printf("float %ld %.3e %.3e\n", count, dw, dq);
}

int main(int argc, char **argv) {
  const long count = argc > 2 ? atol(argv[2]) : 1000;
  if (argc > 1 && strcmp(argv[1], "cases") == 0)
    print_cases(0);
  else if (argc > 1 && strcmp(argv[1], "long") == 0)
    print_cases(1);
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
