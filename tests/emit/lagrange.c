/* lagrange.c - measures the emitted closed form of the heavy symmetric top: part of lagrange.t,
   which judges; see motion.h. SPDX-License-Identifier: GPL-3.0-or-later

     measure cases, long    lines for tests/oracle/heavy_top -e, each after its name, |q| - 1 and 1

   The scenes have moments A, A, C about the fixed point, the centre of mass at l on the axis; a
   body is A, C, m g l. The pace is the largest of |w| at t = 0 and sqrt(m g l/A). */
#include "motion.h"

#define ARM 0x1p-100 /* the scene's length: so small that it never spoils A */

static void parameters(const double body[4], double p[TOP_NP]) {
  p[TOP_A] = body[0];
  p[TOP_C] = body[1];
  p[TOP_G] = fabs(body[2]) / ARM;
  p[TOP_L] = body[2] < 0 ? -ARM : ARM;
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
    const double body[4] = {cases[k].A, cases[k].C, cases[k].mgl, 0};
    if (prepare(&o, &m, body, x0)) {
      printf("%s, refused\n", cases[k].name);
      continue;
    }
    const double once = period(&o);
    double tilt[2];
    top_nutation_range(&o, tilt);
    /* the oracle finds the period from gamma_z, which must change, and must not be 1 to all digits
     * for most of it */
    if (longer && !(once > 0 && once < 1e300 && tilt[1] - tilt[0] > 1e-3 && tilt[0] < 3 &&
                    (tilt[0] > 1e-50 || tilt[0] <= 0)))
      continue;
    for (int n = 0; n < (longer ? 1 : 3); n++) {
      const double t = longer   ? 1.2345678e6 * once
                       : n == 0 ? cases[k].t
                       : n == 1 ? cases[k].t / 7
                                : -cases[k].t / 3;
      top_at(&o, t, x);
      printf("%s: t = %g; %.3e 1; %a %a %a 0 0 %a", cases[k].name, t, norm_error(x), cases[k].A,
             cases[k].A, cases[k].C, cases[k].mgl);
      print_motion(x0, t, longer ? &once : NULL, x);
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
    long double want_w[3];
    top_model m;
    top_orbit o;
    product(forced_top_rows[k].x0 + 3, turn, x0);
    for (int i = 0; i < 3; i++)
      x0[4 + i] = forced_top_rows[k].x0[own[i]];
    const double body[4] = {I[own[0]], I[axis], r[axis], 0};
    if (prepare(&o, &m, body, x0)) {
      printf("row %s refused\n", forced_top_rows[k].id);
      continue;
    }
    top_at(&o, forced_top_rows[k].t, x);
    product(x, back, q);
    for (int i = 0; i < 3; i++)
      want_w[i] = forced_top_rows[k].x[own[i]];
    print_row(forced_top_rows[k].id, forced_top_rows[k].t, x, q, want_w, forced_top_rows[k].x + 3);
  }
}

/* ---- random and hard states ---- */

/* A, C, mgl and x0 of one of sixteen kinds */
static void draw(double body[4], double x[7], long n, int tame) {
  (void)n;
  const double small = uniform() < 0.2 ? 0 : spread(10) * 1e-10;
  double A = spread(1), C = A * 2 * uniform(), g = spread(1);
  for (int i = 0; i < 4; i++)
    x[i] = bell();
  for (int i = 4; i < 7; i++)
    x[i] = 2 * bell();
  switch ((int)(uniform() * (tame ? 11 : 16))) {
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
  case 8: /* whole numbers, which may be on a separatrix */
    if (tame)
      break;
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
  body[0] = A, body[1] = C, body[2] = g, body[3] = 0;
}

/* energy without the spin's, and the component of L along the vertical */
static void integrals(const double body[4], const double x[7], long double value[4]) {
  const long double w = x[0], a = x[1], b = x[2], c = x[3], n = w * w + a * a + b * b + c * c;
  const long double up[3] = {2 * (a * c - w * b) / n, 2 * (b * c + w * a) / n,
                             (w * w + c * c - a * a - b * b) / n};
  value[0] = body[0] * ((long double)x[4] * x[4] + (long double)x[5] * x[5]) / 2 + body[2] * up[2];
  value[1] = body[0] * (up[0] * x[4] + up[1] * x[5]) + body[1] * up[2] * x[6];
  value[2] = value[3] = 0;
}

static double pace(const double body[4], const double x0[7]) {
  double scale = sqrt(fabs(body[2]) / body[0]);
  for (int i = 4; i < 7; i++)
    scale = larger(scale, fabs(x0[i]));
  return scale > 0 ? scale : 1;
}

static void sizes(const double body[4], double scale, double size[2]) {
  size[0] = body[0] * scale * scale;
  size[1] = (body[0] + body[1]) * scale;
}

static double period(const top_orbit *o) {
  return top_nutation_period(o);
}

static double float_span(void) {
  return (uniform() - 0.5) * 100 * spread(2);
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
