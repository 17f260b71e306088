/* turn.c - attitudes near a reference: products, small turns, and their logarithm.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "fit.h"

#include <math.h>

void fit_product(const double a[4], const double b[4], double out[4]) {
  out[0] = a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3];
  out[1] = a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2];
  out[2] = a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1];
  out[3] = a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0];
}

void fit_refer(struct fit_problem *f, int log, const double q[4]) {
  const double length =
      hypot(hypot(q[0], q[1]), hypot(q[2], q[3])); /* a logged one has few digits */
  for (int i = 0; i < 4; i++)
    f->reference[4 * log + i] = q[i] / length;
  f->referred++;
}

void fit_turned(const double reference[4], const double a[3], double q[4], double dq[3][4]) {
  const double n2 = a[0] * a[0] + a[1] * a[1] + a[2] * a[2], n = sqrt(n2);
  /* c = cos(n/2), k = sin(n/2)/n and (dk/dn)/n; series below 1e-3, whose next term is below
     1e-20 */
  const int small = n < 1e-3;
  const double c = cos(n / 2);
  const double k = small ? 0.5 - n2 / 48 + n2 * n2 / 3840 : sin(n / 2) / n;
  const double dk = small ? -1.0 / 24 + n2 / 960 - n2 * n2 / 107520 : (c / 2 - k) / n2;
  const double e[4] = {c, k * a[0], k * a[1], k * a[2]};
  fit_product(reference, e, q);
  for (int i = 0; dq != NULL && i < 3; i++) {
    double d[4] = {-k * a[i] / 2, 0, 0, 0};
    for (int j = 0; j < 3; j++)
      d[j + 1] = dk * a[i] * a[j] + (i == j ? k : 0);
    fit_product(reference, d, dq[i]);
  }
}

/* r = 2 atan2(|v|, s) v/|v| of e = (s, v), and dr for each of the directions de. */
void fit_logarithm(const double e[4], double r[3], double *factor, double slope[2]) {
  const double s = e[0], n2 = e[1] * e[1] + e[2] * e[2] + e[3] * e[3], n = sqrt(n2);
  const double u = n / s;
  const int small = u < 1e-3 && s > 0;
  /* r = a v; da = slope[0] (v dv) + slope[1] ds */
  const double a = small ? 2 / s * (1 - u * u / 3 + u * u * u * u / 5) : 2 * atan2(n, s) / n;
  *factor = a;
  for (int i = 0; i < 3; i++)
    r[i] = a * e[i + 1];
  slope[0] = small ? (-4.0 / 3 + 8.0 / 5 * u * u) / (s * s * s) : (2 * s / (n2 + s * s) - a) / n2;
  slope[1] = -2 / (n2 + s * s);
}
