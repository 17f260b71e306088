/* geometry.c - measure, centroid and second moments: affine images, hollow shapes, faces.
   SPDX-License-Identifier: GPL-3.0-or-later

   Two ideas, and none is a handbook formula for a moment of inertia:
   - the mean of x^2 over a unit interval, disc, ball, circle, scaled by the half-axes, which is
     an affine map;
   - ratios of differences of powers, divided out by hand, so that a thin shell does not cancel.
   Second moments are per unit mass about the centroid; inertia is formed later, by sums. Here too
   are the two tools of the other geometry files: parts joined, and Gauss's rule. */
#include "geometry.h"

#include <string.h>

/* Mean of x^2 for half-axis 1: over the interval, the disc, the ball. */
#define MEAN_INTERVAL (1 / (ph_wide)3)
#define MEAN_DISC     (1 / (ph_wide)4)
#define MEAN_BALL     (1 / (ph_wide)5)
#define MEAN_CIRCLE   (1 / (ph_wide)2)

/* ---- tools ---- */

void geometry_mix(int n, const geometry part[], geometry *g) {
  geometry sum = {0};
  memcpy(sum.at, g->at, sizeof sum.at);
  for (int k = 0; k < n; k++) {
    sum.measure += part[k].measure;
    for (int i = 0; i < 3; i++)
      sum.centroid[i] += part[k].measure * part[k].centroid[i];
  }
  for (int i = 0; i < 3; i++)
    sum.centroid[i] /= sum.measure;
  for (int k = 0; k < n; k++) {
    const ph_wide share = part[k].measure / sum.measure;
    ph_wide d[3];
    for (int i = 0; i < 3; i++)
      d[i] = part[k].centroid[i] - sum.centroid[i];
    wide_add_outer(sum.second, share, d);
    for (int i = 0; i < 6; i++)
      sum.second[i] += share * part[k].second[i];
  }
  *g = sum;
}

/* The zeros of P_n by Newton's method from Tricomi's guess, in pairs from the outside in; weights
   1/((1 - x^2) P_n'^2) (Abramowitz and Stegun 25.4.29, halved for [0, 1]). */
void geometry_gauss(int n, ph_wide node[], ph_wide weight[]) {
  for (int i = 0; i < (n + 1) / 2; i++) {
    ph_wide x = 2 * i + 1 == n ? 0 : cosl(PI * (4 * i + 3) / (4 * n + 2)), slope = 0;
    for (int step = 0; step < 8; step++) { /* quadratic from three digits: 4 would do */
      ph_wide p = x, before = 1;
      for (int k = 2; k <= n; k++) {
        const ph_wide next = ((2 * k - 1) * x * p - (k - 1) * before) / k;
        before = p, p = next;
      }
      slope = n * (before - x * p) / (1 - x * x);
      x = 2 * i + 1 == n ? 0 : x - p / slope;
    }
    node[i] = (1 - x) / 2, node[n - 1 - i] = (1 + x) / 2;
    weight[i] = weight[n - 1 - i] = 1 / ((1 - x * x) * slope * slope);
  }
}

/* ---- affine images ---- */

int geometry_box(const ph_wide p[], geometry *g) {
  return geometry_diagonal(g, p[0] * p[1] * p[2], square(p[0] / 2) * MEAN_INTERVAL,
                           square(p[1] / 2) * MEAN_INTERVAL, square(p[2] / 2) * MEAN_INTERVAL);
}

int geometry_ellipsoid(const ph_wide p[], geometry *g) {
  return geometry_diagonal(g, 4 * PI / 3 * p[0] * p[1] * p[2], square(p[0]) * MEAN_BALL,
                           square(p[1]) * MEAN_BALL, square(p[2]) * MEAN_BALL);
}

int geometry_sphere(const ph_wide p[], geometry *g) {
  return geometry_ellipsoid((const ph_wide[]){p[0], p[0], p[0]}, g);
}

int geometry_elliptic_cylinder(const ph_wide p[], geometry *g) {
  return geometry_diagonal(g, PI * p[0] * p[1] * p[2], square(p[0]) * MEAN_DISC,
                           square(p[1]) * MEAN_DISC, square(p[2] / 2) * MEAN_INTERVAL);
}

int geometry_cylinder(const ph_wide p[], geometry *g) {
  return geometry_elliptic_cylinder((const ph_wide[]){p[0], p[0], p[1]}, g);
}

int geometry_ellipse(const ph_wide p[], geometry *g) {
  return geometry_diagonal(g, PI * p[0] * p[1], square(p[0]) * MEAN_DISC, square(p[1]) * MEAN_DISC,
                           0);
}

int geometry_disc(const ph_wide p[], geometry *g) {
  return geometry_ellipse((const ph_wide[]){p[0], p[0]}, g);
}

int geometry_rectangle(const ph_wide p[], geometry *g) {
  return geometry_diagonal(g, p[0] * p[1], square(p[0] / 2) * MEAN_INTERVAL,
                           square(p[1] / 2) * MEAN_INTERVAL, 0);
}

int geometry_rod(const ph_wide p[], geometry *g) {
  return geometry_diagonal(g, p[0], 0, 0, square(p[0] / 2) * MEAN_INTERVAL);
}

int geometry_hoop(const ph_wide p[], geometry *g) {
  const ph_wide x = square(p[0]) * MEAN_CIRCLE;
  return geometry_diagonal(g, 2 * PI * p[0], x, x, 0);
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
  return geometry_diagonal(g, PI * (p[1] - p[0]) * (p[1] + p[0]), x, x, 0);
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
  return geometry_diagonal(g, 4 * PI / 3 * (b - a) * cubes, x, x, x);
}

int geometry_torus(const ph_wide p[], geometry *g) {
  if (p[1] > p[0])
    return PH_EORDER;
  /* A point at distance s = R + c from the axis, c across the tube's disc, is weighted by s
     (Pappus): the mean of s^2 is (R^3 + 3 R <c^2>)/R, and half of it falls on x. */
  const ph_wide c2 = square(p[1]) * MEAN_DISC, x = (square(p[0]) + 3 * c2) / 2;
  return geometry_diagonal(g, 2 * PI * p[0] * PI * square(p[1]), x, x, c2);
}

/* The same weight on a torus's surface: the mean of s^2 is R^2 + 3 <c^2>, <c^2> = r^2/2. */
int geometry_shell_torus(const ph_wide p[], geometry *g) {
  if (p[1] > p[0])
    return PH_EORDER;
  const ph_wide c2 = square(p[1]) * MEAN_CIRCLE, x = (square(p[0]) + 3 * c2) / 2;
  return geometry_diagonal(g, 2 * PI * p[0] * 2 * PI * p[1], x, x, c2);
}

/* ---- bodies of several faces ---- */

int geometry_shell_box(const ph_wide p[], geometry *g) {
  geometry face[6] = {0};
  for (int k = 0; k < 6; k++) { /* the pair across axis i, one after the other */
    const int i = k / 2, j = (i + 1) % 3, l = (i + 2) % 3;
    face[k].measure = p[j] * p[l];
    face[k].centroid[i] = k % 2 ? p[i] / 2 : -p[i] / 2;
    face[k].second[j] = square(p[j] / 2) * MEAN_INTERVAL;
    face[k].second[l] = square(p[l] / 2) * MEAN_INTERVAL;
  }
  geometry_mix(6, face, g);
  return PH_OK;
}

int geometry_shell_cylinder(const ph_wide p[], geometry *g) {
  geometry part[3] = {0};
  const ph_wide x = square(p[0]) * MEAN_CIRCLE;
  if (p[2] != 0 && p[2] != 1)
    return PH_EBOUND;
  geometry_diagonal(&part[0], 2 * PI * p[0] * p[1], x, x, square(p[1] / 2) * MEAN_INTERVAL);
  for (int k = 1; k < 3; k++) {
    geometry_disc(p, &part[k]);
    part[k].centroid[2] = k == 1 ? p[1] / 2 : -p[1] / 2;
  }
  geometry_mix(p[2] != 0 ? 3 : 1, part, g);
  return PH_OK;
}

/* Half a box, cut along a diagonal: the mean over a triangle of (x - x/3)^2 is x^2/18, of the
   product -xy/36. */
int geometry_wedge(const ph_wide p[], geometry *g) {
  g->centroid[0] = p[0] / 3, g->centroid[1] = p[1] / 3, g->centroid[2] = p[2] / 2;
  g->second[XY] = -p[0] * p[1] / 36;
  return geometry_diagonal(g, p[0] * p[1] * p[2] / 2, square(p[0]) / 18, square(p[1]) / 18,
                           square(p[2] / 2) * MEAN_INTERVAL);
}

/* Regular {p, q}: p edges a face, q faces a corner. A face has the apothem t = e/2 cot(pi/p); it is
   seen from the centre at d = t tan(D/2), sin(D/2) = cos(pi/q)/sin(pi/p) (Coxeter, Regular
   Polytopes, 2.44). The mean of s^2 over a face is t^2/2 + e^2/24, over the pyramid on it that of
   r^2 is 3/5 (d^2 + <s^2>), and a third of it falls on each axis. */
int geometry_regular(const ph_wide size[], geometry *g) {
  static const struct {
    int faces, p, q;
  } known[] = {{4, 3, 3}, {6, 4, 3}, {8, 3, 4}, {12, 5, 3}, {20, 3, 5}};
  for (size_t k = 0; k < sizeof known / sizeof known[0]; k++)
    if (size[0] == known[k].faces) {
      const ph_wide e = size[1], side = PI / known[k].p;
      const ph_wide t = e / 2 / tanl(side), lean = cosl(PI / known[k].q) / sinl(side);
      const ph_wide d = t * lean / sqrtl((1 - lean) * (1 + lean));
      const ph_wide x = (d * d + t * t / 2 + e * e / 24) / 5;
      return geometry_diagonal(g, size[0] * known[k].p * t * e / 2 * d / 3, x, x, x);
    }
  return PH_ECOUNT;
}
