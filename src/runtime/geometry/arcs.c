/* arcs.c - sectors, arcs, helix, catenary.
   SPDX-License-Identifier: GPL-3.0-or-later

   Everything circular is integrated over the angle s from its bisector, where sin^2 s and
   1 - cos s = 2 sin^2(s/2) are small with s, by Gauss's rule: positive terms, so a needle of an
   angle 1e-15 is as good as the full circle. */
#include "geometry.h"

/* For integrands cos^2 s, s sin s on [0, pi] the rest of the rule is below (pi)^40/40!/2^40 < 1e-37
   times a constant; for cosh^3 on panels of length 1 it is smaller still. */
enum { NODES = 20 };

/* Means over |s| <= half of cos s, its variance, sin^2 s, s sin s. */
typedef struct arc {
  ph_wide cosine, spread, sine2, lever;
} arc;

static arc arc_means(ph_wide half) {
  ph_wide node[NODES], weight[NODES], short_of[NODES], mean = 0;
  arc a = {0};
  geometry_gauss(NODES, node, weight);
  for (int k = 0; k < NODES; k++) {
    const ph_wide s = half * node[k];
    short_of[k] = 2 * square(sinl(s / 2));
    mean += weight[k] * short_of[k];
    a.sine2 += weight[k] * square(sinl(s));
    a.lever += weight[k] * s * sinl(s);
  }
  for (int k = 0; k < NODES; k++)
    a.spread += weight[k] * square(short_of[k] - mean);
  a.cosine = 1 - mean;
  return a;
}

/* Matter between the rays s = +-half, turned by the angle whose cosine and sine are c and s: along
   each ray the mean distance is m1, the mean square m2 + m1^2. */
static void fan(geometry *g, arc a, ph_wide m1, ph_wide m2, ph_wide c, ph_wide s) {
  const ph_wide along = m2 * square(a.cosine) + (m2 + square(m1)) * a.spread;
  const ph_wide across = (m2 + square(m1)) * a.sine2;
  g->centroid[0] = m1 * a.cosine * c, g->centroid[1] = m1 * a.cosine * s;
  g->second[XX] = c * c * along + s * s * across;
  g->second[YY] = s * s * along + c * c * across;
  g->second[XY] = c * s * (along - across);
}

/* Sector of a disc: the distance has the mean 2/3 r and the mean square r^2/2. */
static void disc_sector(geometry *g, ph_wide r, ph_wide half, ph_wide c, ph_wide s) {
  g->measure = r * r * half;
  fan(g, arc_means(half), 2 * r / 3, r * r / 18, c, s);
}

/* The full angle: the double nearest to 2 pi lies below it. */
static int too_wide(ph_wide angle) {
  return angle > 2 * PI;
}

int geometry_plate_sector(const ph_wide p[], geometry *g) {
  if (too_wide(p[1]))
    return PH_EBOUND;
  disc_sector(g, p[0], p[1] / 2, cosl(p[1] / 2), sinl(p[1] / 2));
  return PH_OK;
}

int geometry_arc(const ph_wide p[], geometry *g) {
  if (too_wide(p[1]))
    return PH_EBOUND;
  g->measure = p[0] * p[1];
  fan(g, arc_means(p[1] / 2), p[0], 0, cosl(p[1] / 2), sinl(p[1] / 2));
  return PH_OK;
}

static void thicken(geometry *g, ph_wide h) {
  g->measure *= h;
  g->second[ZZ] = square(h) / 12;
}

int geometry_half_cylinder(const ph_wide p[], geometry *g) {
  disc_sector(g, p[0], PI / 2, 1, 0);
  thicken(g, p[1]);
  return PH_OK;
}

int geometry_quarter_cylinder(const ph_wide p[], geometry *g) {
  disc_sector(g, p[0], PI / 4, sqrtl(0.5L), sqrtl(0.5L));
  thicken(g, p[1]);
  return PH_OK;
}

/* Spherical sector: along a ray the mean distance is 3/4 r, the mean square 3/5 r^2, and by
   Archimedes the rays' heights n are uniform in 1 - h/r <= n <= 1. */
int geometry_sector(const ph_wide p[], geometry *g) {
  const ph_wide r = p[0], h = p[1], mean = r - h / 2;
  if (h > 2 * r)
    return PH_EBOUND;
  g->centroid[2] = 3 * mean / 4;
  const ph_wide x = 3 * (r * h - h * h / 3) / 10;
  return geometry_diagonal(g, 2 * PI / 3 * r * r * h, x, x,
                           3 * square(mean) / 80 + 3 * square(h) / 60);
}

/* Whole turns and what is left of one: whole turns have the moments of a circle, their height is
   uniform, and <(t - mean) sin t> = -1. So neither few nor many turns cancel, and no large angle is
   reduced. */
int geometry_helix(const ph_wide p[], geometry *g) {
  const ph_wide r = p[0], pitch = p[1], rest = fmodl(p[2], 1), whole = p[2] - rest;
  const ph_wide turn = hypotl(2 * PI * r, pitch), lever = r * pitch / (2 * PI);
  const ph_wide c = cosl(PI * rest), s = sinl(PI * rest);
  geometry part[2] = {0};
  geometry_diagonal(&part[0], whole * turn, r * r / 2, r * r / 2, square(whole * pitch) / 12);
  part[0].centroid[2] = pitch * whole / 2;
  part[0].second[YZ] = -lever;
  const arc a = arc_means(PI * rest);
  part[1].measure = rest * turn;
  fan(&part[1], a, r, 0, c, s);
  part[1].centroid[2] = pitch * (whole + rest / 2);
  part[1].second[ZZ] = square(rest * pitch) / 12;
  part[1].second[XZ] = -s * lever * a.lever;
  part[1].second[YZ] = c * lever * a.lever;
  geometry_mix(2, part, g);
  return PH_OK;
}

/* Half the curve in panels not longer than a, seen from the vertex (0, a, 0), where the height is
   2 a sinh^2(x/2a); x has mean zero by symmetry, so x^2 is a second moment of each point. */
int geometry_catenary(const ph_wide p[], geometry *g) {
  const ph_wide a = p[0], half = p[1] / 2, steps = fmaxl(1, ceill(half / a));
  ph_wide node[NODES], weight[NODES];
  if (steps > 1460) /* e^1460 a/4 exceeds every double, whatever a is: the centroid's height */
    return PH_ERANGE;
  geometry_gauss(NODES, node, weight);
  geometry part[NODES + 1] = {0};
  for (int i = 0; i < (int)steps; i++) {
    for (int k = 0; k < NODES; k++) {
      const ph_wide x = half * ((i + node[k]) / steps);
      geometry_diagonal(&part[k], 2 * weight[k] * half / steps * coshl(x / a), x * x, 0, 0);
      part[k].centroid[1] = 2 * a * square(sinhl(x / (2 * a)));
    }
    geometry_mix(NODES + 1, part, &part[NODES]); /* what came before is the last part */
  }
  *g = part[NODES];
  g->at[1] = (double)a; /* it was a double */
  return PH_OK;
}
