/* shape.c - bodies from shapes: the catalogue, and one public function for each entry.
   SPDX-License-Identifier: GPL-3.0-or-later

   A shape is a row of the catalogue: its name in scenes, its arguments, and the function that knows
   its geometry. shape_make checks the numbers and multiplies by the mass; so every shape refuses
   the same things in the same order: not finite, mass, lengths, order of radii, range. */
#include <string.h>

#include "body.h"
#include "geometry.h"

enum { MAX_ARGUMENTS = 6 };

typedef struct shape {
  const char *name, *arguments;
  int count, points; /* points: the arguments are coordinates, of any sign */
  geometry_fill *fill;
} shape;

enum {
  BOX,
  SPHERE,
  ELLIPSOID,
  CYLINDER,
  ELLIPTIC_CYLINDER,
  TUBE,
  CONE,
  FRUSTUM,
  CAPSULE,
  HEMISPHERE,
  TORUS,
  HOLLOW_SPHERE,
  DISC,
  ANNULUS,
  ELLIPSE,
  RECTANGLE,
  ROD,
  BETWEEN,
  HOOP,
  SHAPES
};

static const shape catalogue[SHAPES] = {
    [BOX] = {"solid.box", "x y z", 3, 0, geometry_box},
    [SPHERE] = {"solid.sphere", "r", 1, 0, geometry_sphere},
    [ELLIPSOID] = {"solid.ellipsoid", "a b c", 3, 0, geometry_ellipsoid},
    [CYLINDER] = {"solid.cylinder", "r h", 2, 0, geometry_cylinder},
    [ELLIPTIC_CYLINDER] = {"solid.elliptic_cylinder", "a b h", 3, 0, geometry_elliptic_cylinder},
    [TUBE] = {"solid.tube", "r_in r_out h", 3, 0, geometry_tube},
    [CONE] = {"solid.cone", "r h", 2, 0, geometry_cone},
    [FRUSTUM] = {"solid.frustum", "r_base r_top h", 3, 0, geometry_frustum},
    [CAPSULE] = {"solid.capsule", "r h", 2, 0, geometry_capsule},
    [HEMISPHERE] = {"solid.hemisphere", "r", 1, 0, geometry_hemisphere},
    [TORUS] = {"solid.torus", "R r", 2, 0, geometry_torus},
    [HOLLOW_SPHERE] = {"solid.hollow_sphere", "r_in r_out", 2, 0, geometry_hollow_sphere},
    [DISC] = {"plate.disc", "r", 1, 0, geometry_disc},
    [ANNULUS] = {"plate.annulus", "r_in r_out", 2, 0, geometry_annulus},
    [ELLIPSE] = {"plate.ellipse", "a b", 2, 0, geometry_ellipse},
    [RECTANGLE] = {"plate.rectangle", "x y", 2, 0, geometry_rectangle},
    [ROD] = {"rod.straight", "length", 1, 0, geometry_rod},
    [BETWEEN] = {"rod.between", "x1 y1 z1 x2 y2 z2", 6, 1, geometry_between},
    [HOOP] = {"wire.hoop", "r", 1, 0, geometry_hoop},
};

static int shape_make(ph_body *b, const shape *s, ph_amount a, const double arg[]) {
  if (!wide_finite(s->count, arg) || !isfinite(a.value))
    return PH_EFINITE;
  if (!(a.value > 0))
    return PH_EMASS;
  for (int i = 0; i < s->count && !s->points; i++)
    if (!(arg[i] > 0))
      return PH_ELENGTH;
  ph_wide p[MAX_ARGUMENTS];
  geometry g = {0};
  wide_load(s->count, arg, p);
  const int status = s->fill(p, &g);
  if (status)
    return status;
  const ph_wide mass = (ph_wide)a.value * (a.by_density ? g.measure : 1);
  const double origin[3] = {0, 0, 0};
  for (int i = 0; i < 6; i++)
    g.second[i] *= mass;
  return body_store(b, mass, origin, g.centroid, g.second, NULL);
}

ph_amount ph_amount_mass(double mass) {
  return (ph_amount){0, mass};
}

ph_amount ph_amount_density(double density) {
  return (ph_amount){1, density};
}

int ph_shape_make(ph_body *b, const char *name, ph_amount a, const double arg[], int count) {
  for (int i = 0; i < SHAPES; i++)
    if (strcmp(name, catalogue[i].name) == 0)
      return count == catalogue[i].count ? shape_make(b, &catalogue[i], a, arg) : PH_ECOUNT;
  return PH_ENAME;
}

const char *ph_shape_name(int i) {
  return i >= 0 && i < SHAPES ? catalogue[i].name : NULL;
}

const char *ph_shape_arguments(int i) {
  return i >= 0 && i < SHAPES ? catalogue[i].arguments : NULL;
}

/* ---- one function for each row: C callers get named arguments and no string to misspell ---- */

#define MAKE(row, ...) return shape_make(b, &catalogue[row], a, (const double[]){__VA_ARGS__})

int ph_solid_box(ph_body *b, ph_amount a, double x, double y, double z) {
  MAKE(BOX, x, y, z);
}

int ph_solid_sphere(ph_body *b, ph_amount a, double r) {
  MAKE(SPHERE, r);
}

int ph_solid_ellipsoid(ph_body *b, ph_amount a, double ax, double by, double cz) {
  MAKE(ELLIPSOID, ax, by, cz);
}

int ph_solid_cylinder(ph_body *b, ph_amount a, double r, double h) {
  MAKE(CYLINDER, r, h);
}

int ph_solid_elliptic_cylinder(ph_body *b, ph_amount a, double ax, double by, double h) {
  MAKE(ELLIPTIC_CYLINDER, ax, by, h);
}

int ph_solid_tube(ph_body *b, ph_amount a, double r_in, double r_out, double h) {
  MAKE(TUBE, r_in, r_out, h);
}

int ph_solid_cone(ph_body *b, ph_amount a, double r, double h) {
  MAKE(CONE, r, h);
}

int ph_solid_frustum(ph_body *b, ph_amount a, double r_base, double r_top, double h) {
  MAKE(FRUSTUM, r_base, r_top, h);
}

int ph_solid_capsule(ph_body *b, ph_amount a, double r, double h) {
  MAKE(CAPSULE, r, h);
}

int ph_solid_hemisphere(ph_body *b, ph_amount a, double r) {
  MAKE(HEMISPHERE, r);
}

int ph_solid_torus(ph_body *b, ph_amount a, double R, double r) {
  MAKE(TORUS, R, r);
}

int ph_solid_hollow_sphere(ph_body *b, ph_amount a, double r_in, double r_out) {
  MAKE(HOLLOW_SPHERE, r_in, r_out);
}

int ph_plate_disc(ph_body *b, ph_amount a, double r) {
  MAKE(DISC, r);
}

int ph_plate_annulus(ph_body *b, ph_amount a, double r_in, double r_out) {
  MAKE(ANNULUS, r_in, r_out);
}

int ph_plate_ellipse(ph_body *b, ph_amount a, double ax, double by) {
  MAKE(ELLIPSE, ax, by);
}

int ph_plate_rectangle(ph_body *b, ph_amount a, double x, double y) {
  MAKE(RECTANGLE, x, y);
}

int ph_rod_straight(ph_body *b, ph_amount a, double length) {
  MAKE(ROD, length);
}

int ph_rod_between(ph_body *b, ph_amount a, const double from[3], const double to[3]) {
  MAKE(BETWEEN, from[0], from[1], from[2], to[0], to[1], to[2]);
}

int ph_wire_hoop(ph_body *b, ph_amount a, double r) {
  MAKE(HOOP, r);
}
