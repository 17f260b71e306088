/* triangle.c - [J z] of a long log as a triangle, block by block (Householder; Golub, Van Loan,
 * Matrix Computations, 4th ed., 5.2: the rows that were there are the triangle on top of the next
 * block). SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "fit.h"

#include <math.h>
#include <string.h>

void triangle_open(struct fit_triangle *a, int n) {
  a->n = n;
  a->filled = 0;
  memset(a->r, 0, sizeof a->r);
}

/* In four sums, which the processor adds at the same time. */
static double product(const double x[], const double y[], int n) {
  double s[4] = {0, 0, 0, 0};
  int i = 0;
  for (; i + 4 <= n; i += 4)
    for (int k = 0; k < 4; k++)
      s[k] += x[i + k] * y[i + k];
  for (; i < n; i++)
    s[0] += x[i] * y[i];
  return (s[0] + s[1]) + (s[2] + s[3]);
}

static void take(struct fit_triangle *a) {
  const int w = a->n + 1, rows = a->filled;
  for (int j = 0; j < w; j++) {
    double *v = a->block + j * FIT_BLOCK, *top = a->r + j * w;
    const double below = product(v, v, rows);
    if (!(below > 0))
      continue;
    const double norm = sqrt(top[j] * top[j] + below), first = top[j] + copysign(norm, top[j]);
    const double factor = 2 / (first * first + below);
    for (int k = j + 1; k < w; k++) {
      double *x = a->block + k * FIT_BLOCK;
      const double s = factor * (first * top[k] + product(v, x, rows));
      top[k] -= s * first;
      for (int i = 0; i < rows; i++)
        x[i] -= s * v[i];
    }
    top[j] = -copysign(norm, top[j]);
  }
  a->filled = 0;
}

void triangle_row(struct fit_triangle *a, const double row[]) {
  for (int j = 0; j <= a->n; j++)
    a->block[j * FIT_BLOCK + a->filled] = row[j];
  if (++a->filled == FIT_BLOCK)
    take(a);
}

void triangle_close(struct fit_triangle *a) {
  if (a->filled > 0)
    take(a);
}

double triangle_at(const struct fit_triangle *a, int i, int k) {
  return a->r[i * (a->n + 1) + k];
}
