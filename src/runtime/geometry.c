/* geometry.c - measure, centroid and second moments of the canonical shapes.
   SPDX-License-Identifier: GPL-3.0-or-later

   Three ideas give all of them, and none is a handbook formula for a moment of inertia:
   - the mean of x^2 over a unit interval, disc, ball, circle, scaled by the half-axes (an affine
   map);
   - a solid of revolution whose r^2(z) is piecewise a polynomial of degree two or less: three-point
   Gauss integration of 1, z, (z - c)^2, r^2/4 over r^2 dz is exact (integrands of degree <= 5), and
   with positive weights about the centroid nothing cancels;
   - ratios of differences of powers, divided out by hand, so that a thin shell does not cancel.
   Second moments are per unit mass about the centroid; inertia is formed later, by sums. */
#include "geometry.h"

#define PI 3.14159265358979323846264338327950288L

/* Mean of x^2 for half-axis 1: over the interval, the disc, the ball. */
#define MEAN_INTERVAL (1 / (ph_wide)3)
#define MEAN_DISC     (1 / (ph_wide)4)
#define MEAN_BALL     (1 / (ph_wide)5)
#define MEAN_CIRCLE   (1 / (ph_wide)2)

static int diagonal(geometry *g, ph_wide measure, ph_wide x, ph_wide y, ph_wide z) {
  g->measure = measure;
  g->second[XX] = x, g->second[YY] = y, g->second[ZZ] = z;
  return PH_OK;
}

static ph_wide square(ph_wide x) {
  return x * x;
}

/* ---- affine images ---- */

int geometry_box(const ph_wide p[], geometry *g) {
  return diagonal(g, p[0] * p[1] * p[2], square(p[0] / 2) * MEAN_INTERVAL,
                  square(p[1] / 2) * MEAN_INTERVAL, square(p[2] / 2) * MEAN_INTERVAL);
}

int geometry_ellipsoid(const ph_wide p[], geometry *g) {
  return diagonal(g, 4 * PI / 3 * p[0] * p[1] * p[2], square(p[0]) * MEAN_BALL,
                  square(p[1]) * MEAN_BALL, square(p[2]) * MEAN_BALL);
}

int geometry_sphere(const ph_wide p[], geometry *g) {
  return geometry_ellipsoid((const ph_wide[]){p[0], p[0], p[0]}, g);
}

int geometry_elliptic_cylinder(const ph_wide p[], geometry *g) {
  return diagonal(g, PI * p[0] * p[1] * p[2], square(p[0]) * MEAN_DISC, square(p[1]) * MEAN_DISC,
                  square(p[2] / 2) * MEAN_INTERVAL);
}

int geometry_cylinder(const ph_wide p[], geometry *g) {
  return geometry_elliptic_cylinder((const ph_wide[]){p[0], p[0], p[1]}, g);
}

int geometry_ellipse(const ph_wide p[], geometry *g) {
  return diagonal(g, PI * p[0] * p[1], square(p[0]) * MEAN_DISC, square(p[1]) * MEAN_DISC, 0);
}

int geometry_disc(const ph_wide p[], geometry *g) {
  return geometry_ellipse((const ph_wide[]){p[0], p[0]}, g);
}

int geometry_rectangle(const ph_wide p[], geometry *g) {
  return diagonal(g, p[0] * p[1], square(p[0] / 2) * MEAN_INTERVAL,
                  square(p[1] / 2) * MEAN_INTERVAL, 0);
}

int geometry_rod(const ph_wide p[], geometry *g) {
  return diagonal(g, p[0], 0, 0, square(p[0] / 2) * MEAN_INTERVAL);
}

int geometry_hoop(const ph_wide p[], geometry *g) {
  const ph_wide x = square(p[0]) * MEAN_CIRCLE;
  return diagonal(g, 2 * PI * p[0], x, x, 0);
}

int geometry_between(const ph_wide p[], geometry *g) {
  ph_wide half[3];
  for (int i = 0; i < 3; i++) {
    half[i] = (p[3 + i] - p[i]) / 2;
    g->centroid[i] = (p[3 + i] + p[i]) / 2;
  }
  g->measure = 2 * wide_norm(half);
  wide_add_outer(g->second, MEAN_INTERVAL, half);
  return g->measure > 0 ? PH_OK : PH_ELENGTH;
}

/* ---- hollow shapes ---- */

/* Mean of x^2 over an annulus, pi (b^4 - a^4)/4 / (pi (b^2 - a^2)) = (a^2 + b^2)/4, and over a
   circular torus or a ball's shell with their factors divided out. */
int geometry_annulus(const ph_wide p[], geometry *g) {
  if (!(p[0] < p[1]))
    return PH_EORDER;
  const ph_wide x = (square(p[0]) + square(p[1])) * MEAN_DISC;
  return diagonal(g, PI * (p[1] - p[0]) * (p[1] + p[0]), x, x, 0);
}

int geometry_tube(const ph_wide p[], geometry *g) {
  const int status = geometry_annulus(p, g);
  g->measure *= p[2];
  g->second[ZZ] = square(p[2] / 2) * MEAN_INTERVAL;
  return status;
}

int geometry_hollow_sphere(const ph_wide p[], geometry *g) {
  const ph_wide a = p[0], b = p[1];
  if (!(a < b))
    return PH_EORDER;
  /* (b^5 - a^5)/(b^3 - a^3), both divided by b - a */
  const ph_wide cubes = b * b + b * a + a * a;
  const ph_wide fifths =
      b * b * b * b + b * b * b * a + b * b * a * a + b * a * a * a + a * a * a * a;
  const ph_wide x = MEAN_BALL * fifths / cubes;
  return diagonal(g, 4 * PI / 3 * (b - a) * cubes, x, x, x);
}

int geometry_torus(const ph_wide p[], geometry *g) {
  if (p[1] > p[0])
    return PH_EORDER;
  /* A point at distance s = R + c from the axis, c across the tube's disc, is weighted by s
     (Pappus): the mean of s^2 is (R^3 + 3 R <c^2>)/R, and half of it falls on x. */
  const ph_wide c2 = square(p[1]) * MEAN_DISC, x = (square(p[0]) + 3 * c2) / 2;
  return diagonal(g, 2 * PI * p[0] * PI * square(p[1]), x, x, c2);
}

/* ---- solids of revolution ---- */

/* A slab z0 <= z <= z1 of the solid with r^2(z) = c0 + c1 z + c2 z^2. */
typedef struct slab {
  ph_wide z0, z1, c[3];
} slab;

/* integral of pi r^2 (z - about)^power, or of pi r^4 / 4 for power = -1, over the slabs. */
static ph_wide integrate(int n, const slab s[], int power, ph_wide about) {
  const ph_wide node[3] = {-sqrtl(0.6L), 0, sqrtl(0.6L)}, weight[3] = {5, 8, 5};
  ph_wide sum = 0;
  for (int k = 0; k < n; k++)
    for (int i = 0; i < 3; i++) {
      const ph_wide half = (s[k].z1 - s[k].z0) / 2, z = (s[k].z0 + s[k].z1) / 2 + half * node[i];
      const ph_wide r2 = s[k].c[0] + z * (s[k].c[1] + z * s[k].c[2]);
      ph_wide f = PI * r2 * weight[i] * half / 9;
      if (power < 0)
        f *= r2 / 4;
      for (int j = 0; j < power; j++)
        f *= z - about;
      sum += f;
    }
  return sum;
}

static int revolve(int n, const slab s[], geometry *g) {
  const ph_wide volume = integrate(n, s, 0, 0);
  g->centroid[2] = integrate(n, s, 1, 0) / volume;
  const ph_wide x = integrate(n, s, -1, 0) / volume;
  return diagonal(g, volume, x, x, integrate(n, s, 2, g->centroid[2]) / volume);
}

int geometry_frustum(const ph_wide p[], geometry *g) {
  const ph_wide r = p[0], slope = (p[1] - p[0]) / p[2];
  return revolve(1, &(const slab){0, p[2], {r * r, 2 * r * slope, slope * slope}}, g);
}

int geometry_cone(const ph_wide p[], geometry *g) {
  return geometry_frustum((const ph_wide[]){p[0], 0, p[1]}, g);
}

int geometry_hemisphere(const ph_wide p[], geometry *g) {
  return revolve(1, &(const slab){0, p[0], {square(p[0]), 0, -1}}, g);
}

int geometry_capsule(const ph_wide p[], geometry *g) {
  /* balls centred at z = +-h/2: r^2 = R^2 - (z -+ h/2)^2, written in z */
  const ph_wide r = p[0], e = p[1] / 2, c0 = (r - e) * (r + e);
  const slab s[3] = {
      {-e - r, -e, {c0, -2 * e, -1}}, {-e, e, {r * r, 0, 0}}, {e, e + r, {c0, 2 * e, -1}}};
  const int status = revolve(3, s, g);
  g->centroid[2] = 0; /* by symmetry; what is left is rounding */
  return status;
}
