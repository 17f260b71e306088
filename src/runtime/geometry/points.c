/* points.c - triangle, tetrahedron, parallelepiped, polyline: shapes given by points.
   SPDX-License-Identifier: GPL-3.0-or-later

   Everything is taken relative to the first point. Second moments are sums of squares; only the
   measure is a determinant, and that is formed in pairs, so that a sliver keeps its volume. */
#include <string.h>

#include "geometry.h"

/* u x v of differences of doubles. */
static void cross(const pair u[3], const pair v[3], pair out[3]) {
  for (int i = 0; i < 3; i++) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    out[i] = pair_cross(u[j], v[k], u[k], v[j]);
  }
}

/* |u x v|, or |(u x v).w|. */
static ph_wide span(int n, pair u[][3]) {
  pair c[3], volume = {0, 0};
  ph_wide area[3];
  cross(u[0], u[1], c);
  for (int i = 0; i < 3; i++) {
    area[i] = pair_value(c[i]);
    if (n == 3)
      volume = pair_add(volume, pair_multiply(c[i], u[2][i]));
  }
  return n == 3 ? fabsl(pair_value(volume)) : wide_norm(area);
}

ph_wide geometry_determinant(const double m[9]) {
  pair row[3][3];
  for (int i = 0; i < 9; i++)
    row[i / 3][i % 3] = pair_of((ph_wide)m[i]);
  return span(3, row);
}

/* The mean over a simplex of (r - c)(r - c)^T is the sum of that over its n + 1 vertices, divided
   by (n + 1)(n + 2). */
int geometry_simplex(int n, const double vertex[], geometry *g) {
  pair edge[3][3];
  ph_wide r[4][3] = {{0}};
  memcpy(g->at, vertex, sizeof g->at);
  for (int k = 1; k <= n; k++)
    for (int i = 0; i < 3; i++) {
      edge[k - 1][i] = pair_difference(vertex[3 * k + i], vertex[i]);
      r[k][i] = pair_value(edge[k - 1][i]);
      g->centroid[i] += r[k][i] / (n + 1);
    }
  for (int k = 0; k <= n; k++) {
    for (int i = 0; i < 3; i++)
      r[k][i] -= g->centroid[i];
    wide_add_outer(g->second, 1 / (ph_wide)((n + 1) * (n + 2)), r[k]);
  }
  g->measure = span(n, edge) / (n == 3 ? 6 : 2);
  return g->measure > 0 ? PH_OK : PH_EFLAT;
}

int geometry_parallelepiped(const double edge[9], geometry *g) {
  for (int k = 0; k < 3; k++) {
    ph_wide half[3];
    for (int i = 0; i < 3; i++) {
      half[i] = (ph_wide)edge[3 * k + i] / 2;
      g->centroid[i] += half[i];
    }
    wide_add_outer(g->second, 1 / 3.0L, half);
  }
  g->measure = fabsl(geometry_determinant(edge));
  return g->measure > 0 ? PH_OK : PH_EFLAT;
}

/* The k-th rod of a polyline: half of it, and its middle relative to the first point. */
static ph_wide rod(int n, const double point[], int k, ph_wide half[3], ph_wide middle[3]) {
  const double *from = point + 3 * k, *to = point + 3 * ((k + 1) % n);
  for (int i = 0; i < 3; i++) {
    half[i] = pair_value(pair_difference(to[i], from[i])) / 2;
    middle[i] = pair_value(pair_difference(from[i], point[i])) + half[i];
  }
  return 2 * wide_norm(half);
}

/* Rods from point to point. Points may coincide, but not all. */
int geometry_polyline(int n, const double point[], int closed, geometry *g) {
  const int rods = closed ? n : n - 1;
  ph_wide half[3], middle[3];
  memcpy(g->at, point, sizeof g->at);
  for (int k = 0; k < rods; k++) {
    const ph_wide length = rod(n, point, k, half, middle);
    g->measure += length;
    for (int i = 0; i < 3; i++)
      g->centroid[i] += length * middle[i];
  }
  if (!(g->measure > 0))
    return PH_ELENGTH;
  for (int i = 0; i < 3; i++)
    g->centroid[i] /= g->measure;
  for (int k = 0; k < rods; k++) {
    const ph_wide share = rod(n, point, k, half, middle) / g->measure;
    for (int i = 0; i < 3; i++)
      middle[i] -= g->centroid[i];
    wide_add_outer(g->second, share / 3, half);
    wide_add_outer(g->second, share, middle);
  }
  return PH_OK;
}
