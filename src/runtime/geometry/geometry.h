/* geometry.h - measure, centroid and second moments of the canonical shapes.
   SPDX-License-Identifier: GPL-3.0-or-later

   Private to the library: mass/shape.c turns these into bodies. A shape is described by its volume,
   area or length, its centroid at + centroid, and the second moments of unit mass about that
   centroid, in the frame that polhode.h gives it. `at` is a point of the data near the shape: what
   is far from the origin is integrated in its own neighbourhood. */
#ifndef GEOMETRY_H
#define GEOMETRY_H

#include "numbers/pair.h"

#define PI 3.14159265358979323846264338327950288L

typedef struct geometry {
  ph_wide measure, centroid[3], second[6];
  double at[3];
} geometry;

/* Fills *g, which comes in as zeros, from sizes in the order of the public function, finite and
   positive where they must be; PH_OK or PH_EORDER, PH_ELENGTH, PH_EBOUND, PH_ECOUNT, PH_ERANGE. */
typedef int geometry_fill(const ph_wide p[], geometry *g);

/* geometry.c: affine images, hollow shapes, faces. */
geometry_fill geometry_box, geometry_ellipsoid, geometry_sphere, geometry_elliptic_cylinder,
    geometry_cylinder, geometry_tube, geometry_torus, geometry_hollow_sphere, geometry_disc,
    geometry_annulus, geometry_ellipse, geometry_rectangle, geometry_rod, geometry_between,
    geometry_hoop, geometry_wedge, geometry_regular, geometry_shell_box, geometry_shell_cylinder,
    geometry_shell_torus;
/* slices.c: solids and shells cut into slices. */
geometry_fill geometry_cone, geometry_elliptic_cone, geometry_frustum, geometry_capsule,
    geometry_hemisphere, geometry_cap, geometry_zone, geometry_hoof, geometry_paraboloid,
    geometry_pyramid, geometry_bicylinder, geometry_shell_sphere, geometry_shell_hemisphere,
    geometry_shell_zone, geometry_shell_cone;
/* arcs.c: sectors and curves. */
geometry_fill geometry_sector, geometry_half_cylinder, geometry_quarter_cylinder,
    geometry_plate_sector, geometry_arc, geometry_helix, geometry_catenary;
/* shell.c */
geometry_fill geometry_shell_ellipsoid;

/* points.c: shapes given by points; PH_EFLAT where they span nothing, PH_ELENGTH.
   n + 1 vertices of a simplex (n = 2: triangle, 3: tetrahedron); three edges from the origin. */
int geometry_simplex(int n, const double vertex[], geometry *g);
int geometry_parallelepiped(const double edge[9], geometry *g);
int geometry_polyline(int n, const double point[], int closed, geometry *g);
/* The determinant of a row-major matrix to the last digit, unless 60 bits of it cancel. */
ph_wide geometry_determinant(const double m[9]);

/* An area in a plane: outline 0, and holes in it; count[i] points each, coordinates in one list. */
typedef struct outlines {
  int n;
  const int *count;
  const double *point;
} outlines;

/* outline.c: PH_OK, PH_ECOUNT, PH_EFINITE, PH_EFLAT, PH_ECROSS, PH_EHOLE. */
int outlines_check(outlines o);
/* polygon.c, of outlines that have passed that: the plate in z = 0; the solid swept about
   z by an area in the half plane x >= 0 (x, z), PH_EBOUND for x < 0. */
void geometry_polygon(outlines o, geometry *g);
int geometry_revolve(outlines o, geometry *g);

/* One body of n parts, each with its measure; *g keeps its `at`, the parts have none. */
void geometry_mix(int n, const geometry part[], geometry *g);

/* Nodes and weights of Gauss and Legendre on [0, 1], ascending, the weights' sum 1; exact for
   polynomials of degree 2n - 1. */
void geometry_gauss(int n, ph_wide node[], ph_wide weight[]);

static inline ph_wide square(ph_wide x) {
  return x * x;
}

static inline int geometry_diagonal(geometry *g, ph_wide measure, ph_wide x, ph_wide y, ph_wide z) {
  g->measure = measure;
  g->second[XX] = x, g->second[YY] = y, g->second[ZZ] = z;
  return PH_OK;
}

#endif
