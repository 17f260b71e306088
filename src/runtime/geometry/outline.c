/* outline.c - is this the boundary of an area?
   SPDX-License-Identifier: GPL-3.0-or-later

   An outline is a simple polygon: at least three points, no two edges meet except neighbours in
   their common point. Holes lie within outline 0, and apart from each other. On which side of a
   line a point is, is the sign of a determinant in pairs: for doubles whose sizes are within 2^8
   of each other that is exact. All pairs of edges are compared. */
#include "geometry.h"

/* Twice the signed area of p q r. */
static ph_wide turn(const double *p, const double *q, const double *r) {
  return pair_value(pair_cross(pair_difference(q[0], p[0]), pair_difference(r[1], p[1]),
                               pair_difference(r[0], p[0]), pair_difference(q[1], p[1])));
}

static int sign(ph_wide x) {
  return (x > 0) - (x < 0);
}

/* Is r, on the line through p and q, between them? */
static int within(const double *p, const double *q, const double *r) {
  return fmin(p[0], q[0]) <= r[0] && r[0] <= fmax(p[0], q[0]) && fmin(p[1], q[1]) <= r[1] &&
         r[1] <= fmax(p[1], q[1]);
}

/* Have the closed segments p q and r s a point in common? */
static int meet(const double *p, const double *q, const double *r, const double *s) {
  const int a = sign(turn(p, q, r)), b = sign(turn(p, q, s));
  const int c = sign(turn(r, s, p)), d = sign(turn(r, s, q));
  if (a * b < 0 && c * d < 0)
    return 1;
  return (a == 0 && within(p, q, r)) || (b == 0 && within(p, q, s)) ||
         (c == 0 && within(r, s, p)) || (d == 0 && within(r, s, q));
}

/* Neighbours p q and q r: do they share more than q? */
static int folds(const double *p, const double *q, const double *r) {
  return turn(p, q, r) == 0 && (within(p, q, r) || within(q, r, p));
}

static int simple(int n, const double *v) {
  ph_wide area = 0;
  for (int i = 0; i < n; i++) {
    const double *p = v + 2 * i, *q = v + 2 * ((i + 1) % n);
    area += fabsl(turn(v, p, q));
  }
  if (!(area > 0)) /* all on one line */
    return PH_EFLAT;
  for (int i = 0; i < n; i++) {
    const double *p = v + 2 * i, *q = v + 2 * ((i + 1) % n);
    if (folds(p, q, v + 2 * ((i + 2) % n)))
      return PH_ECROSS;
    for (int j = i + 2; j < n; j++)
      if ((j + 1) % n != i && meet(p, q, v + 2 * j, v + 2 * ((j + 1) % n)))
        return PH_ECROSS;
  }
  return PH_OK;
}

/* Is p inside? It is not on the outline. Edges that a ray to the right crosses, counted. */
static int inside(int n, const double *v, const double *p) {
  int odd = 0;
  for (int i = 0; i < n; i++) {
    const double *a = v + 2 * i, *b = v + 2 * ((i + 1) % n);
    if ((a[1] > p[1]) != (b[1] > p[1]))
      odd ^= (turn(a, b, p) > 0) == (b[1] > a[1]);
  }
  return odd;
}

static int touch(int n, const double *v, int m, const double *w) {
  for (int i = 0; i < n; i++)
    for (int j = 0; j < m; j++)
      if (meet(v + 2 * i, v + 2 * ((i + 1) % n), w + 2 * j, w + 2 * ((j + 1) % m)))
        return 1;
  return 0;
}

int outlines_check(outlines o) {
  if (o.n < 1)
    return PH_ECOUNT;
  for (int k = 0; k < o.n; k++)
    if (o.count[k] < 3)
      return PH_ECOUNT;
  const double *v = o.point;
  for (int k = 0; k < o.n; v += 2 * o.count[k++]) {
    if (!wide_finite(2 * o.count[k], v))
      return PH_EFINITE;
    const int status = simple(o.count[k], v);
    if (status)
      return status;
    const double *w = o.point; /* the outlines before this one */
    for (int j = 0; j < k; w += 2 * o.count[j++])
      if (touch(o.count[k], v, o.count[j], w) || inside(o.count[j], w, v) != (j == 0) ||
          (j > 0 && inside(o.count[k], v, w)))
        return PH_EHOLE;
  }
  return PH_OK;
}
