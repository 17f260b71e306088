/* slices.c - solids and shells as stacks of slices.
   SPDX-License-Identifier: GPL-3.0-or-later

   A slice at height z is similar to one figure (disc, square, circle) with the size squared q(z), a
   product of two linear factors: a cone's (r + s z)^2, a ball's (r - z)(r + z). Three points of
   Gauss's rule are exact for its moments (degree 5), all weights are positive, and second moments
   are taken about the centroid: nothing cancels. Factors are written in the height t above the
   slab's foot, so that a thin cap or zone keeps its digits. */
#include "geometry.h"

enum { NODES = 3, MANY = 20 };

/* foot <= z <= foot + height, q = (a[0] + a[1] t) (b[0] + b[1] t). */
typedef struct slab {
  ph_wide foot, height, a[2], b[2];
} slab;

/* A slice of size squared q: its measure per height, area q or, for a shell whose measure does not
   follow from q (the sphere's is constant), band; mean x^2 and y^2 are x q and y q. */
typedef struct slice {
  ph_wide area, band, x, y;
} slice;

static const slice DISC = {PI, 0, 0.25L, 0.25L};

static int stack(int n, const slab s[], slice f, geometry *g) {
  ph_wide node[NODES], weight[NODES];
  geometry part[3 * NODES] = {0};
  geometry_gauss(NODES, node, weight);
  for (int k = 0; k < n * NODES; k++) {
    const slab *c = &s[k / NODES];
    const ph_wide t = c->height * node[k % NODES];
    const ph_wide q = (c->a[0] + c->a[1] * t) * (c->b[0] + c->b[1] * t);
    geometry_diagonal(&part[k], weight[k % NODES] * c->height * (f.area * q + f.band), f.x * q,
                      f.y * q, 0);
    part[k].centroid[2] = c->foot + t;
  }
  geometry_mix(n * NODES, part, g);
  return PH_OK;
}

/* ---- straight sides ---- */

int geometry_frustum(const ph_wide p[], geometry *g) {
  const ph_wide r = p[0], slope = (p[1] - p[0]) / p[2];
  return stack(1, &(const slab){0, p[2], {r, slope}, {r, slope}}, DISC, g);
}

int geometry_cone(const ph_wide p[], geometry *g) {
  return geometry_frustum((const ph_wide[]){p[0], 0, p[1]}, g);
}

int geometry_elliptic_cone(const ph_wide p[], geometry *g) {
  const slice ellipse = {PI * p[0] * p[1], 0, square(p[0]) / 4, square(p[1]) / 4};
  return stack(1, &(const slab){0, p[2], {1, -1 / p[2]}, {1, -1 / p[2]}}, ellipse, g);
}

int geometry_pyramid(const ph_wide p[], geometry *g) {
  const slice rectangle = {p[0] * p[1], 0, square(p[0]) / 12, square(p[1]) / 12};
  return stack(1, &(const slab){0, p[2], {1, -1 / p[2]}, {1, -1 / p[2]}}, rectangle, g);
}

/* ---- conic sections ---- */

/* The ball of radius r from z1 to z2. */
static slab zone(ph_wide r, ph_wide z1, ph_wide z2) {
  return (slab){z1, z2 - z1, {r - z1, -1}, {r + z1, 1}};
}

int geometry_hemisphere(const ph_wide p[], geometry *g) {
  return stack(1, &(const slab){0, p[0], {p[0], -1}, {p[0], 1}}, DISC, g);
}

int geometry_capsule(const ph_wide p[], geometry *g) {
  const ph_wide r = p[0], e = p[1] / 2;
  const slab s[3] = {
      {-e - r, r, {0, 1}, {2 * r, -1}}, {-e, p[1], {r, 0}, {r, 0}}, {e, r, {r, -1}, {r, 1}}};
  const int status = stack(3, s, DISC, g);
  g->centroid[2] = 0; /* by symmetry; what is left is rounding */
  return status;
}

int geometry_cap(const ph_wide p[], geometry *g) {
  const ph_wide r = p[0], h = p[1];
  if (h > 2 * r)
    return PH_EBOUND;
  return stack(1, &(const slab){0, h, {h, -1}, {2 * r - h, 1}}, DISC, g);
}

/* -r <= z1 < z2 <= r; the foot z1 goes into `at`. */
static int between(const ph_wide p[], slice f, geometry *g) {
  if (!(-p[0] <= p[1] && p[1] < p[2] && p[2] <= p[0]))
    return PH_EBOUND;
  slab s = zone(p[0], p[1], p[2]);
  s.foot = 0;
  g->at[2] = (double)p[1]; /* it was a double */
  return stack(1, &s, f, g);
}

int geometry_zone(const ph_wide p[], geometry *g) {
  return between(p, DISC, g);
}

int geometry_paraboloid(const ph_wide p[], geometry *g) {
  return stack(1, &(const slab){0, p[1], {0, square(p[0]) / p[1]}, {1, 0}}, DISC, g);
}

/* Square slices of half-side sqrt(r^2 - z^2). */
int geometry_bicylinder(const ph_wide p[], geometry *g) {
  const slab ball = zone(p[0], -p[0], p[0]);
  const int status = stack(1, &ball, (slice){4, 0, 1 / 3.0L, 1 / 3.0L}, g);
  g->centroid[2] = 0; /* by symmetry */
  return status;
}

/* Cut across x = r sin s: rectangles of width 2 r cos s and height h sin s, thickness r cos s ds.
   Twenty nodes: the rest of the rule on trigonometric integrands of degree 5 is below 1e-30. */
int geometry_hoof(const ph_wide p[], geometry *g) {
  ph_wide node[MANY], weight[MANY];
  geometry part[MANY] = {0};
  geometry_gauss(MANY, node, weight);
  for (int k = 0; k < MANY; k++) {
    const ph_wide x = p[0] * sinl(PI / 2 * node[k]), half = p[0] * cosl(PI / 2 * node[k]);
    const ph_wide height = p[1] * sinl(PI / 2 * node[k]);
    geometry_diagonal(&part[k], PI / 2 * weight[k] * half * (2 * half * height), 0,
                      square(half) / 3, square(height) / 12);
    part[k].centroid[0] = x, part[k].centroid[2] = height / 2;
  }
  geometry_mix(MANY, part, g);
  return PH_OK;
}

/* ---- shells ---- */

/* Archimedes: the area of a sphere between two planes is 2 pi r times their distance. */
static slice sphere(ph_wide r) {
  return (slice){0, 2 * PI * r, 0.5L, 0.5L};
}

int geometry_shell_zone(const ph_wide p[], geometry *g) {
  return between(p, sphere(p[0]), g);
}

int geometry_shell_hemisphere(const ph_wide p[], geometry *g) {
  return geometry_shell_zone((const ph_wide[]){p[0], 0, p[0]}, g);
}

/* A ball's surface: a third of r^2 falls on each axis. */
int geometry_shell_sphere(const ph_wide p[], geometry *g) {
  const ph_wide x = square(p[0]) / 3;
  return geometry_diagonal(g, 4 * PI * square(p[0]), x, x, x);
}

/* A circle of radius r (1 - t/h) has the moments of a disc of sqrt 2 times that radius, and the
   band's measure is linear in t: as triangles of height h seen from the apex, the lateral surface
   is the plate with width 2 pi r (1 - t/h) and slant sqrt(r^2 + h^2). */
int geometry_shell_cone(const ph_wide p[], geometry *g) {
  ph_wide node[NODES], weight[NODES];
  geometry part[NODES] = {0};
  geometry_gauss(NODES, node, weight);
  for (int k = 0; k < NODES; k++) {
    const ph_wide r = p[0] * (1 - node[k]);
    geometry_diagonal(&part[k], weight[k] * hypotl(p[0], p[1]) * 2 * PI * r, square(r) / 2,
                      square(r) / 2, 0);
    part[k].centroid[2] = p[1] * node[k];
  }
  geometry_mix(NODES, part, g);
  return PH_OK;
}
