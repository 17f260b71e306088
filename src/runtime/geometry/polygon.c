/* polygon.c - moments of an area with holes, of the plate and of the solid it sweeps.
   SPDX-License-Identifier: GPL-3.0-or-later

   By Green's theorem an area is the sum of the triangles from a fixed point to its edges, each with
   the sign of its turn. Over the triangle O P Q a homogeneous polynomial f of degree d has the
   integral P x Q / (d + 2) times the mean of f along the edge P Q. Signed terms cancel for thin
   walls and slender areas, so sums are pairs, and coordinates are exact differences to a point of
   the data. */
#include "geometry.h"

/* Integrals over the area: of u^i v^j with coordinates from the first point, or for a solid of
   revolution with the weight u, where u counts from the axis. */
enum { ONE, U, V, UU, VV, UV, SUMS };

static pair mul(pair a, pair b) {
  return pair_multiply(a, b);
}

static pair add(pair a, pair b) {
  return pair_add(a, b);
}

/* Means along the edge from (a, c) to (b, d), times a whole number so that they are sums: of 1, u,
   v, u^2, v^2, uv. */
static void plain(pair a, pair b, pair c, pair d, pair out[SUMS]) {
  const pair s = add(a, b), t = add(c, d);
  out[ONE] = pair_of(1);
  out[U] = s; /* 2 */
  out[V] = t;
  out[UU] = add(add(mul(a, a), mul(a, b)), mul(b, b)); /* 3 */
  out[VV] = add(add(mul(c, c), mul(c, d)), mul(d, d));
  out[UV] = add(add(mul(a, c), mul(b, d)), mul(s, t)); /* 6 */
}

/* of u, uv, uv^2, u^3; entry U is not used. */
static void weighted(pair a, pair b, pair c, pair d, pair out[SUMS]) {
  pair p[SUMS];
  plain(a, b, c, d, p);
  out[ONE] = p[U];                                /* 2 */
  out[U] = out[UV] = pair_of(0);                  /* by symmetry */
  out[V] = p[UV];                                 /* 6 */
  out[UU] = mul(add(mul(a, a), mul(b, b)), p[U]); /* 4 */
  out[VV] = add(mul(p[U], mul(p[V], p[V])),       /* 12 */
                pair_times(add(mul(a, mul(c, c)), mul(b, mul(d, d))), 2));
}

static void integrate(outlines o, int revolve, const double from[2], pair total[SUMS]) {
  /* (d + 2) times the whole number above */
  static const ph_wide plate[SUMS] = {2, 6, 6, 12, 12, 24}, ring[SUMS] = {6, 1, 24, 20, 60, 1};
  const double *v = o.point;
  for (int i = 0; i < SUMS; i++)
    total[i] = pair_of(0);
  for (int k = 0; k < o.n; v += 2 * o.count[k++]) {
    pair sum[SUMS] = {{0, 0}}, turn = {0, 0}, mean[SUMS];
    for (int i = 0; i < o.count[k]; i++) {
      const double *p = v + 2 * i, *q = v + 2 * ((i + 1) % o.count[k]);
      const pair a = pair_difference(p[0], from[0]), b = pair_difference(q[0], from[0]);
      const pair c = pair_difference(p[1], from[1]), d = pair_difference(q[1], from[1]);
      const pair cross = pair_cross(a, d, b, c);
      turn = add(turn, cross);
      (revolve ? weighted : plain)(a, b, c, d, mean);
      for (int j = 0; j < SUMS; j++)
        sum[j] = add(sum[j], mul(cross, mean[j]));
    }
    const int keep = (turn.hi > 0) == (k == 0); /* holes are negative */
    for (int j = 0; j < SUMS; j++)
      total[j] = keep ? add(total[j], sum[j]) : pair_subtract(total[j], sum[j]);
  }
  for (int j = 0; j < SUMS; j++)
    total[j] = pair_divide(total[j], pair_of(revolve ? ring[j] : plate[j]));
}

/* <uv> - <u><v> */
static ph_wide central(const pair t[SUMS], int uv, int u, int v) {
  const pair product = pair_divide(mul(t[u], t[v]), t[ONE]);
  return pair_value(pair_divide(pair_subtract(t[uv], product), t[ONE]));
}

void geometry_polygon(outlines o, geometry *g) {
  pair t[SUMS];
  g->at[0] = o.point[0], g->at[1] = o.point[1];
  integrate(o, 0, o.point, t);
  g->centroid[0] = pair_value(pair_divide(t[U], t[ONE]));
  g->centroid[1] = pair_value(pair_divide(t[V], t[ONE]));
  geometry_diagonal(g, pair_value(t[ONE]), central(t, UU, U, U), central(t, VV, V, V), 0);
  g->second[XY] = central(t, UV, U, V);
}

int geometry_revolve(outlines o, geometry *g) {
  pair t[SUMS];
  for (int i = 0; i < o.count[0]; i++)
    if (o.point[2 * i] < 0)
      return PH_EBOUND;
  g->at[2] = o.point[1];
  integrate(o, 1, (const double[]){0, o.point[1]}, t);
  const ph_wide x = pair_value(pair_divide(t[UU], t[ONE])) / 2;
  g->centroid[2] = pair_value(pair_divide(t[V], t[ONE]));
  return geometry_diagonal(g, 2 * PI * pair_value(t[ONE]), x, x, central(t, VV, V, V));
}
