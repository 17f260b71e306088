/* gyrostat.c - measures the emitted closed form of the asymmetric gyrostat: part of gyrostat.t,
   which judges; see motion.h. SPDX-License-Identifier: GPL-3.0-or-later

     measure cases STATES   lines for tests/oracle/heavy_top -r -e, each after its name, |q| - 1 and
                            what the pace is over the rates: hard motions and random states

   The scenes have any moments and a rotor along z; b: moments and momentum. The pace is the largest
   of |w| and M/I with I the smallest moment. The float code sees kinds without exponential growth.
   */
#include "motion.h"

static void parameters(const double b[4], double p[TOP_NP]) {
  p[TOP_A] = b[0];
  p[TOP_B] = b[1];
  p[TOP_C] = b[2];
  p[TOP_H] = b[3];
}

/* ---- random and hard states ---- */

enum { KINDS = 17 };

/* moments, momentum and x0 of one kind; the first six are well conditioned */
static void draw(double b[4], double x[7], long n, int tame) {
  const double small = uniform() < 0.2 ? 0 : spread(8) * 1e-8;
  const double e[3] = {uniform() + 0.05, uniform() + 0.05, uniform() + 0.05};
  b[0] = e[1] + e[2], b[1] = e[0] + e[2], b[2] = e[0] + e[1], b[3] = bell() * spread(0.5);
  for (int i = 0; i < 4; i++)
    x[i] = bell();
  for (int i = 4; i < 7; i++)
    x[i] = 2 * bell();
  switch ((int)(n % (tame ? 6 : KINDS))) {
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

/* w.I w and M in inertial axes */
static void integrals(const double b[4], const double x[7], long double value[4]) {
  long double *M = value + 1;
  const long double w = x[0], i = x[1], j = x[2], k = x[3], n = w * w + i * i + j * j + k * k;
  const long double L[3] = {(long double)b[0] * x[4], (long double)b[1] * x[5],
                            (long double)b[2] * x[6] + b[3]};
  value[0] = (long double)b[0] * x[4] * x[4] + (long double)b[1] * x[5] * x[5] +
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

static void sizes(const double b[4], double scale, double size[2]) {
  const double I = larger(larger(b[0], b[1]), b[2]);
  size[0] = I * scale * scale;
  size[1] = I * scale;
}

static double period(const top_orbit *o) {
  return top_polhode_period(o);
}

static double float_span(void) {
  return (uniform() - 0.5) * 20;
}

static void print_cases(long count) {
  for (long n = 0; n < count; n++) {
    double b[4], x0[7], x[7];
    top_model m;
    top_orbit o;
    const int kind = (int)(n % KINDS);
    draw(b, x0, n, 0);
    if (prepare(&o, &m, b, x0))
      continue;
    const double t = (uniform() - 0.3) * 60 / pace(b, x0);
    top_at(&o, t, x);
    const double most =
        larger(larger(fabs(x[4]), fabs(x[5])), fabs(x[6])); /* what the oracle divides by */
    printf("kind %d, %d, q = %g; %.3e %.3e; %a %a %a 0 0 %a", kind, o.hyperbolic, o.nome,
           norm_error(x), most > 0 ? pace(b, x0) / most : 1, b[0], b[1], b[2], b[3]);
    print_motion(x0, t, NULL, x);
  }
}

static void rows(void) {
  for (size_t k = 0; k < sizeof forced_top_rows / sizeof forced_top_rows[0]; k++) {
    double b[4], x0[7], x[7];
    top_model m;
    top_orbit o;
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
    top_at(&o, forced_top_rows[k].t, x);
    print_row(forced_top_rows[k].id, forced_top_rows[k].t, x, x, forced_top_rows[k].x,
              forced_top_rows[k].x + 3);
  }
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
