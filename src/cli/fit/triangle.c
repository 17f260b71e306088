/* triangle.c - [J z] of a long log as a triangle, block by block (Householder; Golub, Van Loan,
 * Matrix Computations, 4th ed., 5.2: the rows that were there are the triangle on top of the next
 * block).
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "fit.h"

#include <math.h>
#include <string.h>

void triangle_open(struct fit_triangle *a, int n) {
  a->n = n;
  a->filled = 0;
  memset(a->r, 0, (size_t)((n + 1) * (n + 1)) * sizeof a->r[0]);
}

typedef double pair __attribute__((vector_size(2 * sizeof(double)))); /* of gcc and clang */

static pair at(const double x[]) {
  pair a;
  memcpy(&a, x, sizeof a);
  return a;
}

/* Of whole columns of the block, in eight sums, which the processor adds at the same time. */
static double product(const double x[], const double y[]) {
  pair a = {0}, b = {0}, c = {0}, d = {0};
  for (int i = 0; i < FIT_BLOCK; i += 8) {
    a += at(x + i) * at(y + i);
    b += at(x + i + 2) * at(y + i + 2);
    c += at(x + i + 4) * at(y + i + 4);
    d += at(x + i + 6) * at(y + i + 6);
  }
  a = (a + b) + (c + d);
  return a[0] + a[1];
}

/* x - s v of whole columns. */
static void reflected(double x[restrict], const double v[restrict], double s) {
  for (int i = 0; i < FIT_BLOCK; i++)
    x[i] -= s * v[i];
}

/* The block into the triangle, by a reflection for each column j: v = (first, the block's column),
 * zero in the other rows of the triangle, since row j alone of them is not done yet. */
static void take(struct fit_triangle *a) {
  const int w = a->n + 1;
  for (int j = 0; j < w && a->filled < FIT_BLOCK; j++) /* rows that are missing are 0 */
    memset(a->block + j * FIT_BLOCK + a->filled, 0,
           (size_t)(FIT_BLOCK - a->filled) * sizeof a->block[0]);
  for (int j = 0; j < w; j++) {
    double *v = a->block + j * FIT_BLOCK, *top = a->r + j * w;
    const double below = product(v, v);
    if (!(below > 0))
      continue;
    const double norm = sqrt(top[j] * top[j] + below), first = top[j] + copysign(norm, top[j]);
    const double factor = 2 / (first * first + below);
    for (int k = j + 1; k < w; k++) {
      double *x = a->block + k * FIT_BLOCK;
      const double s = factor * (first * top[k] + product(v, x));
      top[k] -= s * first;
      reflected(x, v, s);
    }
    top[j] = -copysign(norm, top[j]);
  }
  a->filled = 0;
}

double *triangle_place(struct fit_triangle *a) {
  return a->block + a->filled;
}

void triangle_next(struct fit_triangle *a) {
  if (++a->filled == FIT_BLOCK)
    take(a);
}

void triangle_row(struct fit_triangle *a, const double row[]) {
  double *to = triangle_place(a);
  for (int j = 0; j <= a->n; j++)
    to[j * FIT_BLOCK] = row[j];
  triangle_next(a);
}

void triangle_close(struct fit_triangle *a) {
  if (a->filled > 0)
    take(a);
}

double triangle_at(const struct fit_triangle *a, int i, int k) {
  return a->r[i * (a->n + 1) + k];
}
