/* free_top.c - the free top in closed form against 32 digits, Taylor series, and its invariants.
   SPDX-License-Identifier: GPL-3.0-or-later

   Oracles: tests/reference/free_top.h and free_top_long.h (closed form at 200 digits and more,
   checked by 100-digit Taylor series); the library's own Taylor integrator for random bodies; the
   conserved quantities for adversarial ones. The bar is 4e-15 for rates (relative to the largest of
   |w|) and for the angle between attitudes, at every time in the tables: a state rounded to double
   has 2e-16 of its own, and nothing in between may grow. POLHODE_STATES=n: more random states. */
#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

#include "polhode.h"
#include "reference/free_top.h"
#include "reference/free_top_long.h"
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
    if (w[i] != 0)
      n->part = fmaxl(n->part, fabsl(((long double)x[4 + i] - w[i]) / w[i]));
  if (!(e <= (long double)BAR && a <= (long double)BAR)) {
    n->missed++;
    diag("  %s t = %.17g: rates %.2Lg attitude %.2Lg (2^-53 in the inputs: %.2g, %.2g)", id, t, e,
         a, ws, qs);
  }
}

#define TABLE(table, what)                                                                         \
  do {                                                                                             \
    tally n = {0, 0, 0, 0, 0, 0};                                                                  \
    for (size_t i = 0; i < COUNT(table); i++)                                                      \
      row(&n, table[i].id, table[i].tensor, table[i].w0, table[i].q0, table[i].t, table[i].w,      \
          table[i].q, table[i].w_sensitivity, table[i].q_sensitivity);                             \
    ok(n.rows > 0 && n.missed == 0,                                                                \
       "%d samples %s: rates and attitude to 4e-15 (worst %.2Lg and %.2Lg)", n.rows, what,         \
       n.rates, n.attitude);                                                                       \
    ok(n.flipped == 0, "q goes on continuously: no sample %s has the other sign", what);           \
    diag("largest relative error of a single component of w: %.2Lg", n.part);                      \
  } while (0)

int main(void) {
  TABLE(free_top_rows, "within 20000 rad");
  TABLE(free_top_long_rows, "far away or sensitive");
  return tap_done();
}
