/* free_top.c - the free top in closed form against 32 digits, Taylor series, and its invariants.
   SPDX-License-Identifier: GPL-3.0-or-later

   Oracles: tests/reference/free_top.h (closed form at 200 digits and more,
   checked by 100-digit Taylor series); the library's own Taylor integrator for random bodies; the
   conserved quantities for adversarial ones. The bar is 4e-15 for rates (relative to the largest of
   |w|) and for the angle between attitudes, at every time in the tables: a state rounded to double
   has 2e-16 of its own, and nothing in between may grow. POLHODE_STATES=n: more random states. */
#include <float.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "polhode.h"
#include "reference/free_top.h"
#include "tap.h"

#define COUNT(table) (sizeof(table) / sizeof(table)[0])

static const double BAR = 4e-15;

/* Rotation angle between two attitudes: 2 asin of half the distance of the unit quaternions, times
   2; *sign is -1 when they are nearer to opposite signs. */
static long double angle(const double a[4], const long double b[4], int *sign) {
  long double minus = 0, plus = 0;
  for (int i = 0; i < 4; i++) {
    minus += ((long double)a[i] - b[i]) * ((long double)a[i] - b[i]);
    plus += ((long double)a[i] + b[i]) * ((long double)a[i] + b[i]);
  }
  *sign = minus <= plus ? 1 : -1;
  return 4 * asinl(sqrtl(fminl(minus, plus)) / 2);
}

static long double rates_error(const double w[3], const long double want[3]) {
  long double d = 0, size = 0;
  for (int i = 0; i < 3; i++) {
    d += ((long double)w[i] - want[i]) * ((long double)w[i] - want[i]);
    size += want[i] * want[i];
  }
  return size > 0 ? sqrtl(d / size) : sqrtl(d);
}

typedef struct tally {
  long double rates, attitude, part;
  int rows, missed, flipped;
} tally;

static void row(tally *n, const char *id, const double tensor[6], const double w0[3],
                const double q0[4], double t, const long double w[3], const long double q[4],
                double ws, double qs) {
  ph_top top;
  ph_free_top f;
  double x0[7], x[7];
  memcpy(x0, q0, 4 * sizeof *x0);
  memcpy(x0 + 4, w0, 3 * sizeof *x0);
  int sign = 1;
  const int s = ph_top_init_tensor(&top, 1, NULL, tensor) || ph_free_top_solve(&f, &top, x0) ||
                ph_free_top_at(&f, t, x);
  const long double e = s ? HUGE_VALL : rates_error(x + 4, w);
  const long double a = s ? HUGE_VALL : angle(x, q, &sign);
  n->rows++;
  n->rates = fmaxl(n->rates, e);
  n->attitude = fmaxl(n->attitude, a);
  n->flipped += sign < 0;
  for (int i = 0; !s && i < 3; i++)
    if (fabsl(w[i]) > (long double)DBL_MIN)
      n->part = fmaxl(n->part, fabsl(((long double)x[4 + i] - w[i]) / w[i]));
  if (!(e <= (long double)BAR && a <= (long double)BAR)) {
    n->missed++;
    diag("  %s t = %.17g: rates %.2Lg attitude %.2Lg (2^-53 in the inputs: %.2g, %.2g)", id, t, e,
         a, ws, qs);
  }
}

/* The rows from first to before end. */
static void table(size_t first, size_t end, const char *what) {
  tally n = {0, 0, 0, 0, 0, 0};
  for (size_t i = first; i < end; i++)
    row(&n, free_top_rows[i].id, free_top_rows[i].tensor, free_top_rows[i].w0, free_top_rows[i].q0,
        free_top_rows[i].t, free_top_rows[i].w, free_top_rows[i].q, free_top_rows[i].w_sensitivity,
        free_top_rows[i].q_sensitivity);
  ok(n.rows > 0 && n.missed == 0,
     "%d samples %s: rates and attitude to 4e-15 (worst %.2Lg and %.2Lg)", n.rows, what, n.rates,
     n.attitude);
  ok(n.flipped == 0, "q goes on continuously: no sample %s has the other sign", what);
  diag("largest relative error of a single component of w: %.2Lg", n.part);
}

/* ---- random bodies and states ---- */

static uint64_t seed = 0x9e3779b97f4a7c15;

static double uniform(void) { /* xorshift64* (Vigna 2016), in [0, 1) */
  seed ^= seed >> 12, seed ^= seed << 25, seed ^= seed >> 27;
  return (double)(seed * 0x2545f4914f6cdd1d >> 11) * 0x1p-53;
}

static int pick(int n) {
  return (int)(uniform() * n);
}

static double spread(double low, double high) { /* log-uniform */
  return low * pow(high / low, uniform());
}

static double near_to(double a) { /* equal, some ulp off, or off by any small part */
  const int kind = pick(4);
  return kind == 0   ? a
         : kind == 1 ? a * (1 + DBL_EPSILON * (pick(9) - 4))
         : kind == 2 ? a * (1 + spread(1e-16, 1e-2) * (pick(2) ? 1 : -1))
                     : a * spread(1e-3, 1e3);
}

/* Moments from second moments, so that they are a body's: cubes, coins, needles, plates, rods. */
static void adversarial(double I[6], double x0[7], double *t) {
  const double size = pow(10, 60 * uniform() - 30), rate = pow(10, 60 * uniform() - 30);
  double s[3] = {size, near_to(size), 0};
  s[2] = near_to(s[pick(2)]);
  if (pick(20) == 0)
    s[pick(3)] = 0;
  if (pick(20) == 0)
    s[pick(3)] *= spread(1e-40, 1);
  for (int i = 0; i < 3; i++) {
    I[i] = s[(i + 1) % 3] + s[(i + 2) % 3];
    I[3 + i] = 0;
  }
  for (int i = 0; i < 4; i++)
    x0[i] = 2 * uniform() - 1;
  for (int i = 0; i < 3; i++) {
    const int kind = pick(8);
    const double part = kind == 0   ? 0
                        : kind == 1 ? spread(1e-20, 1)
                        : kind == 2 ? spread(1e-160, 1)
                                    : 1;
    x0[4 + i] = rate * part * (2 * uniform() - 1);
  }
  if (pick(3) == 0) { /* near the separatrix, or on it */
    int a = 0, c = 0;
    for (int i = 1; i < 3; i++) {
      a = I[i] < I[a] ? i : a;
      c = I[i] >= I[c] ? i : c;
    }
    const double b = I[0] + I[1] + I[2] - I[a] - I[c];
    if (a != c && I[c] > b)
      x0[4 + c] = x0[4 + a] * sqrt(I[a] / I[c] * fabs(b - I[a]) / (I[c] - b)) *
                  (1 + DBL_EPSILON * (pick(5) - 2));
    if (pick(4) == 0) { /* 4, 5, 9 with 3 w3 = w1 is exactly on it */
      const double exact[3] = {4, 5, 9};
      const int k = pick(3);
      for (int i = 0; i < 3; i++)
        I[(i + k) % 3] = exact[i];
      x0[4 + k] = 3 * x0[4 + (k + 2) % 3];
    }
  }
  double speed = 0;
  for (int i = 0; i < 3; i++)
    speed = fmax(speed, fabs(x0[4 + i]));
  *t = (pick(2) ? 1 : -1) * spread(1e-3, 1e9) / (speed > 0 ? speed : 1);
}

typedef struct invariants {
  long double norm, energy, momentum;
  long refused;
} invariants;

static void inertial(const double I[6], const double state[7], long double *T, long double L[3]) {
  long double x[7], b[3], c[3];
  tap_wide(7, state, x);
  const long double w = x[0], *v = x + 1;
  const long double n = w * w + v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
  *T = 0;
  for (int i = 0; i < 3; i++) {
    b[i] = (long double)I[i] * x[4 + i];
    *T += b[i] * x[4 + i] / 2;
  }
  for (int i = 0; i < 3; i++) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    c[i] = v[j] * b[k] - v[k] * b[j] + w * b[i];
  }
  const long double dot = v[0] * b[0] + v[1] * b[1] + v[2] * b[2];
  for (int i = 0; i < 3; i++) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    L[i] = (w * c[i] + v[j] * c[k] - v[k] * c[j] + v[i] * dot) / n;
  }
}

static void invariant(invariants *worst) {
  double I[6], x0[7], x[7], t;
  adversarial(I, x0, &t);
  ph_top top;
  ph_free_top f;
  if (ph_top_init_tensor(&top, 1, NULL, I) || ph_free_top_solve(&f, &top, x0) ||
      ph_free_top_at(&f, t, x)) {
    worst->refused++;
    return;
  }
  long double T0, T, L0[3], L[3], d = 0, size = 0, q = 0;
  inertial(I, x0, &T0, L0);
  inertial(I, x, &T, L);
  for (int i = 0; i < 3; i++) {
    d += (L[i] - L0[i]) * (L[i] - L0[i]);
    size += L0[i] * L0[i];
  }
  for (int i = 0; i < 4; i++)
    q += (long double)x[i] * (long double)x[i];
  /* written so that a NaN is the worst of all */
  const long double e[3] = {fabsl(sqrtl(q) - 1), T0 > 0 ? fabsl(T / T0 - 1) : fabsl(T),
                            size > 0 ? sqrtl(d / size) : sqrtl(d)};
  long double *to[3] = {&worst->norm, &worst->energy, &worst->momentum};
  for (int i = 0; i < 3; i++)
    if (!(e[i] <= *to[i])) {
      if (e[i] > 1e-15L || isnan(e[i]))
        diag("  %d: %.2Lg at I %.17g %.17g %.17g w %.17g %.17g %.17g q %.17g %.17g %.17g %.17g t "
             "%.17g",
             i, e[i], I[0], I[1], I[2], x0[4], x0[5], x0[6], x0[0], x0[1], x0[2], x0[3], t);
      *to[i] = isnan(e[i]) ? HUGE_VALL : e[i];
    }
}

static void random_states(void) {
  const char *asked = getenv("POLHODE_STATES");
  const long n = asked ? atol(asked) : 100000;
  invariants worst = {0, 0, 0, 0};
  for (long i = 0; i < n; i++)
    invariant(&worst);
  ok(worst.refused == 0, "%ld adversarial bodies and states are all solved (%ld refused)", n,
     worst.refused);
  near((double)worst.norm, 0, 4e-16, "|q| = 1 (worst %.2Lg)", worst.norm);
  /* each w is rounded once (2^-53), twice that in T; L turns with q, whose four roundings are an
     angle of 2 * 2^-53 * 2 at most */
  near((double)worst.energy, 0, 4 * DBL_EPSILON, "T is conserved (worst %.2Lg)", worst.energy);
  near((double)worst.momentum, 0, 4 * DBL_EPSILON, "L is conserved in space (worst %.2Lg)",
       worst.momentum);
}

/* The integrator as oracle: full tensors, 60 rad. It keeps 1e-14 over 1000 revolutions; a motion
   near its separatrix magnifies what it loses in a step (1e-19) some thousandfold. */
static void against_taylor(void) {
  long double rates = 0, attitude = 0;
  int failed = 0, all_signs = 1;
  for (int k = 0; k < 200; k++) {
    double tensor[6], turn[4], x0[7], x[7], y[7];
    const double s[3] = {uniform(), uniform(), uniform() * (k % 5 ? 1 : 1e-6)};
    const double I[6] = {s[1] + s[2], s[2] + s[0], s[0] + s[1], 0, 0, 0};
    for (int i = 0; i < 4; i++)
      turn[i] = 2 * uniform() - 1;
    for (int i = 0; i < 7; i++)
      x0[i] = 2 * uniform() - 1;
    memcpy(tensor, I, sizeof tensor);
    if (k % 2)
      ph_tensor_turn(I, turn, tensor);
    ph_top top;
    ph_free_top f;
    ph_run *run = NULL;
    const ph_options o = {.method = PH_TAYLOR, .tolerance = 1e-19, .max_steps = 1000000};
    const double t = k % 3 ? 60 : -60;
    const int status = ph_top_init_tensor(&top, 1, NULL, tensor) ||
                       ph_free_top_solve(&f, &top, x0) || ph_free_top_at(&f, t, x) ||
                       ph_run_new(&run, &top, &o, 0, x0) || ph_run_to(run, t, NULL, y);
    ph_run_free(run);
    long double wide[7];
    int sign;
    for (int i = 0; i < 7; i++)
      wide[i] = (long double)y[i];
    failed += status != 0;
    attitude = fmaxl(attitude, angle(x, wide, &sign));
    rates = fmaxl(rates, rates_error(x + 4, wide + 4));
    all_signs = all_signs && sign > 0;
  }
  ok(failed == 0, "200 random bodies are solved and integrated");
  near((double)rates, 0, 1e-14, "their rates are the Taylor integrator's after 60 s (worst %.2Lg)",
       rates);
  near((double)attitude, 0, 1e-14, "and their attitudes (worst %.2Lg)", attitude);
  ok(all_signs, "with the sign of q");
}

/* ---- quantities ---- */

static void quantities(void) {
  const double I[6] = {1, 2, 2.5, 0, 0, 0}, x0[7] = {0.5, 0.5, -0.5, 0.5, 0.3, 1, -0.2};
  ph_top top;
  ph_free_top f;
  double x[7], y[7], L[3], q[4], want[4], when = 0;
  int s = ph_top_init_tensor(&top, 1, NULL, I) || ph_free_top_solve(&f, &top, x0) ||
          ph_free_top_at(&f, f.period, x) || ph_top_momentum(&top, x0, L);
  ok(s == 0 && f.kind == PH_FREE_PERIODIC, "an asymmetric top is solved");
  near_all(3, x + 4, x0 + 4, 1e-15, "after a period the rates are what they were");
  s = ph_quat_from_axis(L, f.turn, q);
  ph_quat_multiply(q, x0, want);
  int sign;
  long double wide[4];
  near((double)angle(x, tap_wide(4, want, wide), &sign), 0, 4e-15,
       "and the attitude is turned about L by `turn`");
  near(f.precession, f.turn / f.period, 1e-15 * fabs(f.precession), "precession = turn / period");
  near(f.m + f.mc, 1, DBL_EPSILON, "m and 1 - m");
  s = ph_free_top_flip(&f, 3, &when) || ph_free_top_at(&f, when, x) ||
      ph_free_top_at(&f, (3 + when) / 2, y);
  ok(s == 0 && when > 3 && when <= 3 + f.period / 2 * (1 + DBL_EPSILON),
     "a flip comes within half a period");
  near(x[5], 0, 1e-15, "where the middle component passes through 0");
  ok(ph_free_top_flip(&f, when * (1 + 4 * DBL_EPSILON), &when) == 0 &&
         ph_free_top_at(&f, when, y) == 0 && fabs(y[5]) < 1e-14 && y[6] * x[6] < 0,
     "and the next one comes with the other sign of the rate across");
  /* the symmetric top: Omega = (I3 - I1)/I1 w3, precession L/I1 (Landau and Lifshitz, 33) */
  ph_symmetric sym;
  const double w[3] = {0.6, -0.4, 0.9}, x1[7] = {1, 0, 0, 0, 0.6, -0.4, 0.9};
  s = ph_top_init_tensor(&top, 1, NULL, (const double[]){1, 1, 1.5, 0, 0, 0}) ||
      ph_free_top_solve(&f, &top, x1) || ph_symmetric_top(1, 1.5, w, &sym) ||
      ph_symmetric_at(1, 1.5, x1, 77.5, y) || ph_free_top_at(&f, 77.5, x);
  ok(s == 0 && f.m == 0 && f.mc == 1, "the symmetric top has modulus 0");
  near(f.period, 2 * 3.14159265358979324 / fabs(sym.Omega), 4e-15, "its period is 2 pi / Omega");
  /* a period of the rates turns the horizontal axes by one turn less */
  near(f.precession, sym.precession, 4e-16, "its precession is L / I1");
  near_all(7, x, y, 1e-15, "its states are the textbook's");
  /* a rod that also turns about itself: the symmetric top with I3 = 0 */
  const double x2[7] = {1, 2, 3, 4, 0.5, -0.25, 3};
  ph_body rod;
  s = ph_rod_straight(&rod, ph_amount_mass(12), 1) || ph_top_init(&top, &rod, NULL) ||
      ph_free_top_solve(&f, &top, x2) || ph_free_top_at(&f, 10, x);
  ph_run *run = NULL;
  const ph_options o = ph_options_default();
  s = s || ph_run_new(&run, &top, &o, 0, x2) || ph_run_to(run, 10, NULL, y);
  ph_run_free(run);
  ok(s == 0 && f.kind == PH_FREE_ROD, "a rod is solved");
  near_all(7, x, y, 4e-15, "as the integrator has it");
  /* exactly on the separatrix */
  const double x3[7] = {1, 0, 0, 0, 3, 0.5, 1};
  s = ph_top_init_tensor(&top, 1, NULL, (const double[]){4, 5, 9, 0, 0, 0}) ||
      ph_free_top_solve(&f, &top, x3) || ph_free_top_flip(&f, 0, &when);
  ok(s == 0 && f.kind == PH_FREE_SEPARATRIX && f.mc == 0 && isinf(f.period),
     "4, 5, 9 with w = 3, 1/2, 1 is on the separatrix");
  ok(isinf(when) != (ph_free_top_flip(&f, -1000, &when) == 0 && isinf(when)),
     "where the top flips once in all time");
  /* refusals */
  ph_top_decay(&top, 0.1);
  ok(ph_free_top_solve(&f, &top, x3) == PH_EMETHOD, "a top with an effect is refused");
  ok(ph_free_top_at(&f, (double)NAN, x) == PH_EFINITE, "a time that is no number is refused");
}

/* A run by PH_EXACT. */
static void runs(void) {
  ph_top top;
  ph_free_top f;
  ph_run *run = NULL;
  const double x0[7] = {1, 0, 0, 0, 0.7, -0.3, 0.9};
  double x[7], y[7];
  const ph_options o = {.method = PH_EXACT, .tolerance = 1e-10, .max_steps = 1};
  const int s = ph_top_init_tensor(&top, 1, NULL, (const double[]){1, 2, 2.5, 0, 0, 0}) ||
                ph_free_top_solve(&f, &top, x0) || ph_run_new(&run, &top, &o, 1e6 + 0.25, x0) ||
                ph_run_to(run, 2e6 + 0.25, NULL, x) || ph_free_top_at(&f, 1e6, y);
  ok(s == 0 && memcmp(x, y, sizeof x) == 0 && ph_run_time(run) == 2e6 + 0.25,
     "a run by the exact method is the closed form from its start");
  ph_run_free(run);
}

int main(void) {
  table(0, FREE_TOP_NEAR, "within 20000 rad");
  table(FREE_TOP_NEAR, COUNT(free_top_rows), "far away or sensitive");
  random_states();
  against_taylor();
  quantities();
  runs();
  return tap_done();
}
