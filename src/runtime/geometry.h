/* geometry.h - measure, centroid and second moments of the canonical shapes.
   SPDX-License-Identifier: GPL-3.0-or-later

   Private to the library: shape.c turns these into bodies. A shape is described by its volume, area
   or length, its centroid, and the second moments of unit mass about that centroid, in the frame
   that polhode.h gives it. Sizes p[] come in the order of the public function, already checked. */
#ifndef GEOMETRY_H
#define GEOMETRY_H

#include "wide.h"

typedef struct geometry {
  ph_wide measure, centroid[3], second[6];
} geometry;

/* Fills *g, which comes in as zeros; PH_OK or PH_EORDER, PH_ELENGTH. */
typedef int geometry_fill(const ph_wide p[], geometry *g);

geometry_fill geometry_box, geometry_ellipsoid, geometry_sphere, geometry_elliptic_cylinder,
    geometry_cylinder, geometry_tube, geometry_cone, geometry_frustum, geometry_capsule,
    geometry_hemisphere, geometry_torus, geometry_hollow_sphere, geometry_disc, geometry_annulus,
    geometry_ellipse, geometry_rectangle, geometry_rod, geometry_between, geometry_hoop;

#endif
