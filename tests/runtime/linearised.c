/* linearised.c - the linearised free top: where it is exact, the order of its error, hard cases.
   SPDX-License-Identifier: GPL-3.0-or-later

   The oracle is the library's exact solver, which is itself held to 32 digits in free_top.c. That
   the error is of second order is seen by making the disturbance ten times smaller: it must fall a
   hundredfold, within a factor that the next order explains. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "polhode.h"
#include "tap.h"

static const double Q0[4] = {0.5, -0.5, 0.1, 0.7};

static int make(ph_top *top, double a, double b, double c) {
  const double tensor[6] = {a, b, c, 0, 0, 0};
  return ph_top_init_tensor(top, 1, NULL, tensor);
}

/* The angle between two attitudes. */
static double angle(const double a[4], const double b[4]) {
  double minus = 0, plus = 0;
  for (int i = 0; i < 4; i++) {
    minus += (a[i] - b[i]) * (a[i] - b[i]);
    plus += (a[i] + b[i]) * (a[i] + b[i]);
  }
  return 4 * asin(fmin(1, sqrt(fmin(minus, plus)) / 2));
}

/* Both solutions at t; what they differ by: rates relative to |w0|, attitude as an angle. */
static int both(const ph_top *top, const double w[3], double t, double *rates, double *attitude) {
  double x0[7] = {Q0[0], Q0[1], Q0[2], Q0[3], w[0], w[1], w[2]}, x[7], y[7];
  ph_free_top f;
  int status = ph_top_linearised(top, x0, t, x);
  if (!status)
    status = ph_free_top_solve(&f, top, x0);
  if (!status)
    status = ph_free_top_at(&f, t, y);
  if (status)
    return status;
  const double size = hypot(hypot(w[0], w[1]), w[2]);
  *rates = 0;
  for (int i = 4; i < 7; i++)
    *rates = fmax(*rates, fabs(x[i] - y[i]) / (size > 0 ? size : 1));
  *attitude = angle(x, y);
  return PH_OK;
}

static void order(void) {
  static const double body[][3] = {{1, 4, 4.5},   {2, 2.1, 2.2}, {3, 4, 7},
                                   {1, 20, 20.5}, {1, 1, 1.9},   {0.01, 1, 1.005}};
  for (int n = 0; n < 6; n++)
    for (int k = 0; k < 3; k++)
      for (int sign = -1; sign < 2; sign += 2) {
        ph_top top;
        if (!ok(make(&top, body[n][0], body[n][1], body[n][2]) == PH_OK, "body %d", n))
          continue;
        /* the sum over a few times, so that no passage through zero is met */
        double rates[2] = {0, 0}, attitude[2] = {0, 0};
        int status = PH_OK;
        for (int small = 0; small < 2; small++)
          for (int s = 1; s < 8; s++) {
            const double e = small ? 1e-5 : 1e-4;
            double w[3], r, q;
            w[k] = sign;
            w[(k + 1) % 3] = 0.6 * e;
            w[(k + 2) % 3] = -0.8 * e;
            status |= both(&top, w, 0.4 * s, &r, &q);
            rates[small] += r, attitude[small] += q;
          }
        /* 7 times a few roundings of 1 are left of the smaller one: 1e-14 */
        ok(status == PH_OK && rates[1] <= rates[0] / 80 + 1e-14,
           "body %d, axis %d, sign %d: rates are wrong by e^2: %.3g, then %.3g", n, k, sign,
           rates[0], rates[1]);
        ok(status == PH_OK && attitude[1] <= attitude[0] / 80 + 1e-14,
           "body %d, axis %d, sign %d: attitude is wrong by e^2: %.3g, then %.3g", n, k, sign,
           attitude[0], attitude[1]);
      }
}

/* Where the linearised motion is the motion; phases of t rad in doubles. */
static void exact(void) {
  static const struct {
    const char *what;
    double I[3], w[3];
  } row[] = {
      {"a symmetric top about its axis", {2, 2, 3}, {0.3, -0.5, 2}},
      {"the same, along x, spin against the axis", {3, 2, 2}, {-2, 0.3, -0.5}},
      {"a long one, spin against the axis", {2, 2, 0.5}, {0.3, -0.5, -2}},
      {"a sphere", {2, 2, 2}, {0.3, -0.5, 2}},
      {"a rod about its line", {2, 2, 0}, {0.3, -0.5, 2}},
      {"a pure spin, stable", {1, 2, 2.5}, {0, 0, -2}},
      {"a pure spin, unstable", {1, 2, 2.5}, {0, 2, 0}},
      {"rest", {1, 2, 2.5}, {0, 0, 0}},
  };
  for (int n = 0; n < 8; n++) {
    ph_top top;
    static const double times[] = {0, 0.7, -33, 1e4, 1e9};
    int status = make(&top, row[n].I[0], row[n].I[1], row[n].I[2]);
    for (int s = 0; s < 5; s++) {
      double rates = HUGE_VAL, attitude = HUGE_VAL;
      status |= both(&top, row[n].w, times[s], &rates, &attitude);
      /* a phase of 2 t with the roundings of long double; the double state itself */
      const double bar = 8 * DBL_EPSILON + 16 * (double)LDBL_EPSILON * fabs(times[s]);
      ok(status == PH_OK && rates <= bar, "%s: rates at %g, %.3g", row[n].what, times[s], rates);
      ok(status == PH_OK && attitude <= 4 * bar, "%s: attitude at %g, %.3g", row[n].what, times[s],
         attitude);
    }
  }
}

/* A body that is nearly a symmetric top is nearly exact, at any amplitude: what is left out is in
   proportion to Ii - Ij, here d of the moments.  A rate that is wrong by a fraction d/2 of (w_i
   w_j) t turns the body by that times t; 8 leaves room for the quotients of moments, up to 4. */
static void nearly_symmetric(void) {
  static const double body[][3] = {{2, 2, 3}, {2, 2, 0.5}};
  for (int n = 0; n < 2; n++)
    for (double d = 1e-9; d < 1e-3; d *= 1000)
      for (double t = 1; t < 30; t *= 5) {
        const double w[3] = {0.6, 0.7, 1};
        double rates = HUGE_VAL, attitude = HUGE_VAL;
        ph_top top;
        const int status = make(&top, body[n][0] * (1 + d), body[n][1], body[n][2]) ||
                           both(&top, w, t, &rates, &attitude);
        ok(!status && attitude <= 8 * d * (t + t * t),
           "body %d: moments apart by %g, %g s: attitude is wrong by %.3g", n, d, t, attitude);
      }
}

/* The attitude keeps the direction of L, whatever the body and the amplitude. */
static void direction(void) {
  static const double body[][3] = {{1, 4, 4.5}, {3, 4, 7},       {1, 1, 1.9},
                                   {0, 2, 2},   {1e-12, 1, 1.0}, {2, 2.1, 2.2}};
  static const double spin[][3] = {{1, 0.9, 0.2}, {0.1, -1, 0.7}, {0.8, 0.3, 1}};
  for (int n = 0; n < 6; n++)
    for (int k = 0; k < 3; k++)
      for (double t = -2; t < 3; t += 0.7) {
        ph_top top;
        double x[7], L[3], L0[3];
        memcpy(x, Q0, sizeof Q0);
        memcpy(x + 4, spin[k], sizeof spin[k]);
        int status = make(&top, body[n][0], body[n][1], body[n][2]) ||
                     ph_top_momentum(&top, x, L0) || ph_top_linearised(&top, x, t, x) ||
                     ph_top_momentum(&top, x, L);
        const double size = hypot(hypot(L[0], L[1]), L[2]),
                     size0 = hypot(hypot(L0[0], L0[1]), L0[2]);
        double off = 0;
        for (int i = 0; i < 3; i++)
          off = fmax(off, fabs(L[i] / size - L0[i] / size0));
        /* x is rounded to doubles, and turned twice */
        ok(!status && off <= 32 * DBL_EPSILON,
           "body %d, spin %d: L keeps its direction, %g s: %.3g", n, k, t, off);
      }
}

/* Units change nothing: moments by a power of two, time by another. */
static void scales(void) {
  static const int exponent[] = {-100, 100};
  static const double body[][3] = {{1, 4, 4.5}, {1, 1, 1.9}, {0, 1, 1}, {2, 2, 2}};
  static const double spin[][3] = {{1, 0.1, 0.2}, {0.1, 1, 0.2}, {0.1, 0.2, -1}};
  for (int n = 0; n < 4; n++)
    for (int k = 0; k < 3; k++)
      for (int s = 0; s < 2; s++)
        for (int r = 0; r < 2; r++) {
          ph_top one, top;
          const double size = ldexp(1, exponent[s]), rate = ldexp(1, exponent[r]);
          double x0[7], x[7], y[7];
          memcpy(x0, Q0, sizeof Q0);
          memcpy(x0 + 4, spin[k], sizeof spin[k]);
          int status = make(&one, body[n][0], body[n][1], body[n][2]) ||
                       make(&top, size * body[n][0], size * body[n][1], size * body[n][2]) ||
                       ph_top_linearised(&one, x0, 1.25, x);
          for (int i = 4; i < 7; i++)
            x0[i] *= rate;
          status = status || ph_top_linearised(&top, x0, 1.25 / rate, y);
          int same = 1;
          for (int i = 0; i < 7; i++)
            same = same && fabs(y[i] / (i < 4 ? 1 : rate) - x[i]) <= 8 * DBL_EPSILON;
          ok(!status && same, "body %d, spin %d: units of 2^%d and 2^%d", n, k, exponent[s],
             exponent[r]);
        }
}

static void refusals(void) {
  ph_top top;
  double x0[7] = {1, 0, 0, 0, 1, 2, 3}, x[7] = {9, 9, 9, 9, 9, 9, 9};
  ok(make(&top, 1, 2, 2.5) == PH_OK, "a body");
  ok(ph_top_linearised(&top, x0, NAN, x) == PH_EFINITE, "a time that is no number");
  x0[0] = 0;
  ok(ph_top_linearised(&top, x0, 1, x) == PH_EQUATERNION, "no attitude");
  x0[0] = 1, x0[5] = HUGE_VAL;
  ok(ph_top_linearised(&top, x0, 1, x) == PH_EFINITE, "an infinite rate");
  x0[5] = 20;
  ok(ph_top_linearised(&top, x0, 1e9, x) == PH_ERANGE, "an unstable spin leaves the range");
  ok(x[0] == 9 && x[6] == 9, "a refusal leaves the output");
  ph_top_control(&top);
  ok(ph_top_linearised(&top, x0, 1, x) == PH_EMETHOD, "an effect is on");
}

int main(void) {
  order();
  exact();
  nearly_symmetric();
  direction();
  scales();
  refusals();
  return tap_done();
}
