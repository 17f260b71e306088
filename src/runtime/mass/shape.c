/* shape.c - bodies from shapes: the catalogue, and one public function for each entry.
   SPDX-License-Identifier: GPL-3.0-or-later

   A shape is a row of the catalogue: its name in scenes, its arguments, and the function that knows
   its geometry. shape_make checks the numbers and multiplies by the mass; so every shape refuses
   the same things in the same order: not finite, mass, lengths, order of radii, range. Shapes of
   any number of points are in shape_points.c. */
#include <string.h>

#include "shape.h"

enum { MAX_ARGUMENTS = 6 };

typedef struct shape {
  const char *name, *arguments;
  int count;
  unsigned free; /* bit i: argument i may have any sign */
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
  ELLIPTIC_CONE,
  FRUSTUM,
  CAPSULE,
  HEMISPHERE,
  CAP,
  ZONE,
  SECTOR,
  HALF_CYLINDER,
  QUARTER_CYLINDER,
  HOOF,
  TORUS,
  HOLLOW_SPHERE,
  PARABOLOID,
  PYRAMID,
  WEDGE,
  BICYLINDER,
  REGULAR,
  SHELL_SPHERE,
  SHELL_HEMISPHERE,
  SHELL_ZONE,
  SHELL_ELLIPSOID,
  SHELL_CYLINDER,
  SHELL_CONE,
  SHELL_TORUS,
  SHELL_BOX,
  DISC,
  ANNULUS,
  ELLIPSE,
  RECTANGLE,
  PLATE_SECTOR,
  ROD,
  BETWEEN,
  HOOP,
  ARC,
  HELIX,
  CATENARY,
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
    [ELLIPTIC_CONE] = {"solid.elliptic_cone", "a b h", 3, 0, geometry_elliptic_cone},
    [FRUSTUM] = {"solid.frustum", "r_base r_top h", 3, 0, geometry_frustum},
    [CAPSULE] = {"solid.capsule", "r h", 2, 0, geometry_capsule},
    [HEMISPHERE] = {"solid.hemisphere", "r", 1, 0, geometry_hemisphere},
    [CAP] = {"solid.cap", "r h", 2, 0, geometry_cap},
    [ZONE] = {"solid.zone", "r z1 z2", 3, 06, geometry_zone},
    [SECTOR] = {"solid.sector", "r h", 2, 0, geometry_sector},
    [HALF_CYLINDER] = {"solid.half_cylinder", "r h", 2, 0, geometry_half_cylinder},
    [QUARTER_CYLINDER] = {"solid.quarter_cylinder", "r h", 2, 0, geometry_quarter_cylinder},
    [HOOF] = {"solid.hoof", "r h", 2, 0, geometry_hoof},
    [TORUS] = {"solid.torus", "R r", 2, 0, geometry_torus},
    [HOLLOW_SPHERE] = {"solid.hollow_sphere", "r_in r_out", 2, 0, geometry_hollow_sphere},
    [PARABOLOID] = {"solid.paraboloid", "r h", 2, 0, geometry_paraboloid},
    [PYRAMID] = {"solid.pyramid", "x y h", 3, 0, geometry_pyramid},
    [WEDGE] = {"solid.wedge", "x y z", 3, 0, geometry_wedge},
    [BICYLINDER] = {"solid.bicylinder", "r", 1, 0, geometry_bicylinder},
    [REGULAR] = {"solid.regular", "faces edge", 2, 0, geometry_regular},
    [SHELL_SPHERE] = {"shell.sphere", "r", 1, 0, geometry_shell_sphere},
    [SHELL_HEMISPHERE] = {"shell.hemisphere", "r", 1, 0, geometry_shell_hemisphere},
    [SHELL_ZONE] = {"shell.zone", "r z1 z2", 3, 06, geometry_shell_zone},
    [SHELL_ELLIPSOID] = {"shell.ellipsoid", "a b c", 3, 0, geometry_shell_ellipsoid},
    [SHELL_CYLINDER] = {"shell.cylinder", "r h ends", 3, 04, geometry_shell_cylinder},
    [SHELL_CONE] = {"shell.cone", "r h", 2, 0, geometry_shell_cone},
    [SHELL_TORUS] = {"shell.torus", "R r", 2, 0, geometry_shell_torus},
    [SHELL_BOX] = {"shell.box", "x y z", 3, 0, geometry_shell_box},
    [DISC] = {"plate.disc", "r", 1, 0, geometry_disc},
    [ANNULUS] = {"plate.annulus", "r_in r_out", 2, 0, geometry_annulus},
    [ELLIPSE] = {"plate.ellipse", "a b", 2, 0, geometry_ellipse},
    [RECTANGLE] = {"plate.rectangle", "x y", 2, 0, geometry_rectangle},
    [PLATE_SECTOR] = {"plate.sector", "r angle", 2, 0, geometry_plate_sector},
    [ROD] = {"rod.straight", "length", 1, 0, geometry_rod},
    [BETWEEN] = {"rod.between", "x1 y1 z1 x2 y2 z2", 6, 077, geometry_between},
    [HOOP] = {"wire.hoop", "r", 1, 0, geometry_hoop},
    [ARC] = {"wire.arc", "r angle", 2, 0, geometry_arc},
    [HELIX] = {"wire.helix", "r pitch turns", 3, 02, geometry_helix},
    [CATENARY] = {"wire.catenary", "a span", 2, 0, geometry_catenary},
};

static int shape_make(ph_body *b, const shape *s, ph_amount a, const double arg[]) {
  int status = shape_amount(s->count, arg, a);
  for (int i = 0; i < s->count && !status; i++)
    if (!(arg[i] > 0) && !(s->free >> i & 1))
      status = PH_ELENGTH;
  if (status)
    return status;
  ph_wide p[MAX_ARGUMENTS];
  geometry g = {0};
  wide_load(s->count, arg, p);
  status = s->fill(p, &g);
  return status ? status : shape_store(b, a, &g);
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

int ph_solid_elliptic_cone(ph_body *b, ph_amount a, double ax, double by, double h) {
  MAKE(ELLIPTIC_CONE, ax, by, h);
}

int ph_solid_cap(ph_body *b, ph_amount a, double r, double h) {
  MAKE(CAP, r, h);
}

int ph_solid_zone(ph_body *b, ph_amount a, double r, double z1, double z2) {
  MAKE(ZONE, r, z1, z2);
}

int ph_solid_sector(ph_body *b, ph_amount a, double r, double h) {
  MAKE(SECTOR, r, h);
}

int ph_solid_half_cylinder(ph_body *b, ph_amount a, double r, double h) {
  MAKE(HALF_CYLINDER, r, h);
}

int ph_solid_quarter_cylinder(ph_body *b, ph_amount a, double r, double h) {
  MAKE(QUARTER_CYLINDER, r, h);
}

int ph_solid_hoof(ph_body *b, ph_amount a, double r, double h) {
  MAKE(HOOF, r, h);
}

int ph_solid_paraboloid(ph_body *b, ph_amount a, double r, double h) {
  MAKE(PARABOLOID, r, h);
}

int ph_solid_pyramid(ph_body *b, ph_amount a, double x, double y, double h) {
  MAKE(PYRAMID, x, y, h);
}

int ph_solid_wedge(ph_body *b, ph_amount a, double x, double y, double z) {
  MAKE(WEDGE, x, y, z);
}

int ph_solid_bicylinder(ph_body *b, ph_amount a, double r) {
  MAKE(BICYLINDER, r);
}

int ph_solid_regular(ph_body *b, ph_amount a, int faces, double edge) {
  MAKE(REGULAR, faces, edge);
}

int ph_shell_sphere(ph_body *b, ph_amount a, double r) {
  MAKE(SHELL_SPHERE, r);
}

int ph_shell_hemisphere(ph_body *b, ph_amount a, double r) {
  MAKE(SHELL_HEMISPHERE, r);
}

int ph_shell_zone(ph_body *b, ph_amount a, double r, double z1, double z2) {
  MAKE(SHELL_ZONE, r, z1, z2);
}

int ph_shell_ellipsoid(ph_body *b, ph_amount a, double ax, double by, double cz) {
  MAKE(SHELL_ELLIPSOID, ax, by, cz);
}

int ph_shell_cylinder(ph_body *b, ph_amount a, double r, double h, int ends) {
  MAKE(SHELL_CYLINDER, r, h, ends != 0);
}

int ph_shell_cone(ph_body *b, ph_amount a, double r, double h) {
  MAKE(SHELL_CONE, r, h);
}

int ph_shell_torus(ph_body *b, ph_amount a, double R, double r) {
  MAKE(SHELL_TORUS, R, r);
}

int ph_shell_box(ph_body *b, ph_amount a, double x, double y, double z) {
  MAKE(SHELL_BOX, x, y, z);
}

int ph_plate_sector(ph_body *b, ph_amount a, double r, double angle) {
  MAKE(PLATE_SECTOR, r, angle);
}

int ph_wire_arc(ph_body *b, ph_amount a, double r, double angle) {
  MAKE(ARC, r, angle);
}

int ph_wire_helix(ph_body *b, ph_amount a, double r, double pitch, double turns) {
  MAKE(HELIX, r, pitch, turns);
}

int ph_wire_catenary(ph_body *b, ph_amount a, double scale, double span) {
  MAKE(CATENARY, scale, span);
}
