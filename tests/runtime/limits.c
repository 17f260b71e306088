/* limits.c - shapes that are each other: limits, symmetries, the same body by two roads.
   SPDX-License-Identifier: GPL-3.0-or-later

   Pairs that geometry says are equal, made by different files of the library. Each side is within
   half an ulp of a few roundings of the truth (shapes.c); compared with each other they may differ
   by twice the requirement. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "polhode.h"
#include "tap.h"

/* 4 ulp on each side */
static const double TOL = 8 * DBL_EPSILON;

static const ph_amount ONE = {0, 1.0}, DENSE = {1, 1.0};

static double largest(int n, const double v[]) {
  double size = 0;
  for (int i = 0; i < n; i++)
    size = fmax(size, fabs(v[i]));
  return size;
}

static void same(const char *what, int s, const ph_body *a, const ph_body *b) {
  if (!ok(s == PH_OK, "%s: made", what))
    return;
  const double size = largest(6, b->tensor);
  near(a->mass, b->mass, TOL * b->mass, "%s: mass", what);
  near_all(3, a->com, b->com, TOL * fmax(largest(3, b->com), sqrt(size / b->mass)), "%s: centre",
           what);
  near_all(6, a->tensor, b->tensor, TOL * size, "%s: tensor", what);
}

/* what, two calls that make a and b. */
#define SAME(what, first, second)                                                                  \
  do {                                                                                             \
    ph_body a = {0}, b = {0};                                                                      \
    const int s1 = first, s2 = second;                                                             \
    same(what, s1 ? s1 : s2, &a, &b);                                                              \
  } while (0)

static void limits(void) {
  const double r = 0.7, h = 1.3, two_pi = 6.283185307179586;
  SAME("a frustum to a point is a cone", ph_solid_frustum(&a, DENSE, r, 0x1p-1000, h),
       ph_solid_cone(&b, DENSE, r, h));
  SAME("a frustum of equal ends is a cylinder", ph_solid_frustum(&a, DENSE, r, r, h),
       ph_solid_cylinder(&b, DENSE, r, h) || ph_body_at(&b, &b, (const double[]){0, 0, h / 2}));
  SAME("a round elliptic cone is a cone", ph_solid_elliptic_cone(&a, DENSE, r, r, h),
       ph_solid_cone(&b, DENSE, r, h));
  SAME("a cap of height r is a hemisphere", ph_solid_cap(&a, DENSE, r, r),
       ph_solid_hemisphere(&b, DENSE, r));
  SAME("a cap of height 2 r is a ball", ph_solid_cap(&a, DENSE, r, 2 * r),
       ph_solid_sphere(&b, DENSE, r) || ph_body_at(&b, &b, (const double[]){0, 0, r}));
  SAME("a zone from pole to pole is a ball", ph_solid_zone(&a, DENSE, r, -r, r),
       ph_solid_sphere(&b, DENSE, r));
  SAME("a sector of height 2 r is a ball", ph_solid_sector(&a, DENSE, r, 2 * r),
       ph_solid_sphere(&b, DENSE, r));
  SAME("a sector of height r is a hemisphere", ph_solid_sector(&a, DENSE, r, r),
       ph_solid_hemisphere(&b, DENSE, r));
  SAME("a capsule without a cylinder is a ball", ph_solid_capsule(&a, DENSE, r, 0x1p-1000),
       ph_solid_sphere(&b, DENSE, r));
  SAME("a shell zone from pole to pole is a sphere", ph_shell_zone(&a, DENSE, r, -r, r),
       ph_shell_sphere(&b, DENSE, r));
  SAME("a shell zone from the equator is a hemisphere", ph_shell_zone(&a, DENSE, r, 0, r),
       ph_shell_hemisphere(&b, DENSE, r));
  SAME("an ellipsoid's shell of equal axes is a sphere", ph_shell_ellipsoid(&a, DENSE, r, r, r),
       ph_shell_sphere(&b, DENSE, r));
  /* two discs face to face: c/a = 2^-100 adds 2^-200 ln of it */
  SAME("an ellipsoid's shell without height is two discs",
       ph_shell_ellipsoid(&a, DENSE, r, r, 0x1p-100), ph_plate_disc(&b, ph_amount_density(2), r));
  SAME("a closed flat can is two discs", ph_shell_cylinder(&a, DENSE, r, 0x1p-100, 1),
       ph_plate_disc(&b, ph_amount_density(2), r));
  SAME("a flat cone's shell is a disc", ph_shell_cone(&a, DENSE, r, 0x1p-100),
       ph_plate_disc(&b, DENSE, r));
  SAME("a hollow sphere's limit is a shell",
       ph_solid_hollow_sphere(&a, ONE, 1 - 0x1p-53, 1 + 0x1p-52), ph_shell_sphere(&b, ONE, 1));
  SAME("a full sector is a disc", ph_plate_sector(&a, ONE, r, two_pi), ph_plate_disc(&b, ONE, r));
  SAME("a full arc is a hoop", ph_wire_arc(&a, ONE, r, two_pi), ph_wire_hoop(&b, ONE, r));
  SAME("a helix without pitch is a hoop", ph_wire_helix(&a, ONE, r, 0, 1),
       ph_wire_hoop(&b, ONE, r));
  SAME("a helix without radius is a rod", ph_wire_helix(&a, ONE, 0x1p-500, 0.5, 7.25),
       ph_rod_between(&b, ONE, (const double[]){0, 0, 0}, (const double[]){0, 0, 3.625}));
  SAME("a short helix is an arc with a slope of 0", ph_wire_helix(&a, ONE, r, 0, 0.25),
       ph_wire_arc(&b, ONE, r, two_pi / 4));
  SAME("a taut catenary is a rod", ph_wire_catenary(&a, ONE, 1, 0x1p-40),
       ph_rod_between(&b, ONE, (const double[]){-0x1p-41, 1, 0}, (const double[]){0x1p-41, 1, 0}));
  SAME("two half cylinders are one",
       ph_solid_half_cylinder(&a, DENSE, r, h) ||
           ph_body_scaled(&b, &a, (const double[]){-1, 1, 1}) || ph_body_add(&a, &a, &b),
       ph_solid_cylinder(&b, DENSE, r, h));
  SAME("two quarter cylinders are a half",
       ph_solid_quarter_cylinder(&a, DENSE, r, h) ||
           ph_body_scaled(&b, &a, (const double[]){1, -1, 1}) || ph_body_add(&a, &a, &b),
       ph_solid_half_cylinder(&b, DENSE, r, h));
}

#define LIST(...)                                                                                  \
  (const double[]) {                                                                               \
    __VA_ARGS__                                                                                    \
  }

static void two_roads(void) {
  const int three[] = {3}, four[] = {4}, frame[] = {4, 4};
  SAME("a prism is half a box", ph_solid_prism(&a, DENSE, 3, LIST(0, 0, 2, 0, 0, 3), 5),
       ph_solid_wedge(&b, DENSE, 2, 3, 5));
  SAME("an extruded rectangle is a box",
       ph_extrude(&a, DENSE, 1, four, LIST(1, 2, 4, 2, 4, 7, 1, 7), 2),
       ph_solid_box(&b, DENSE, 3, 5, 2) || ph_body_at(&b, &b, LIST(2.5, 4.5, 1)));
  SAME("a polygon of three corners is a triangle",
       ph_plate_polygon(&a, DENSE, 1, three, LIST(1, 2, 0, 7, 4, 3)),
       ph_plate_triangle(&b, DENSE, LIST(1, 2, 0, 4, 3, 0, 0, 7, 0)));
  SAME("a frame is a rectangle without one",
       ph_plate_polygon(&a, DENSE, 2, frame,
                        LIST(-2, -3, 2, -3, 2, 3, -2, 3, -1, -2, -1, 2, 1, 2, 1, -2)),
       ph_plate_rectangle(&b, DENSE, 4, 6) || ph_plate_rectangle(&a, DENSE, 2, 4) ||
           ph_body_subtract(&b, &b, &a) ||
           ph_plate_polygon(&a, DENSE, 2, frame,
                            LIST(-2, -3, 2, -3, 2, 3, -2, 3, -1, -2, -1, 2, 1, 2, 1, -2)));
  SAME("a turned rectangle is a tube",
       ph_revolve(&a, DENSE, 1, four, LIST(1, -2, 2, -2, 2, 2, 1, 2)),
       ph_solid_tube(&b, DENSE, 1, 2, 4));
  SAME("a turned triangle is a cone", ph_revolve(&a, DENSE, 1, three, LIST(0, 3, 2, 0, 0, 0)),
       ph_solid_cone(&b, DENSE, 2, 3));
  SAME("a parallelepiped of right angles is a box",
       ph_solid_parallelepiped(&a, DENSE, LIST(0, 3, 0, 2, 0, 0, 0, 0, -5)),
       ph_solid_box(&b, DENSE, 2, 3, 5) || ph_body_at(&b, &b, LIST(1, 1.5, -2.5)));
  SAME("a sheared box is a parallelepiped",
       ph_solid_box(&a, ONE, 1, 1, 1) || ph_body_at(&a, &a, LIST(0.5, 0.5, 0.5)) ||
           ph_body_affine(&a, &a, LIST(1, 4, 7, 2, 5, 8, 3, 6, 10)),
       ph_solid_parallelepiped(&b, ONE, LIST(1, 2, 3, 4, 5, 6, 7, 8, 10)));
  SAME("a regular tetrahedron by its corners", ph_solid_regular(&a, ONE, 4, sqrt(8)),
       ph_solid_tetrahedron(&b, ONE, LIST(1, 1, 1, 1, -1, -1, -1, 1, -1, -1, -1, 1)));
  SAME("a regular cube is a box", ph_solid_regular(&a, DENSE, 6, 3),
       ph_solid_box(&b, DENSE, 3, 3, 3));
  SAME("an octahedron is two pyramids", ph_solid_regular(&a, DENSE, 8, 2),
       ph_solid_pyramid(&b, DENSE, 2, 2, sqrt(2)) || ph_body_scaled(&a, &b, LIST(1, 1, -1)) ||
           ph_body_add(&b, &b, &a) || ph_solid_regular(&a, DENSE, 8, 2));
  SAME("a polyline of two points is a rod", ph_wire_polyline(&a, ONE, 2, LIST(1, 2, 3, 4, 6, 8), 0),
       ph_rod_between(&b, ONE, LIST(1, 2, 3), LIST(4, 6, 8)));
  SAME("there and back is the rod too", ph_wire_polyline(&a, ONE, 2, LIST(1, 2, 3, 4, 6, 8), 1),
       ph_rod_between(&b, ONE, LIST(1, 2, 3), LIST(4, 6, 8)));
  const double ellipse[9] = {3, 0, 0, 0, 4, 0, 0, 0, 5};
  SAME("an affine ball is an ellipsoid",
       ph_solid_sphere(&a, ONE, 1) || ph_body_affine(&a, &a, ellipse),
       ph_solid_ellipsoid(&b, ONE, 3, 4, 5));
  SAME("of the same density if the ball has the mass of 60, the determinant",
       ph_solid_sphere(&a, ph_amount_density(60), 1) || ph_body_affine(&a, &a, ellipse),
       ph_solid_ellipsoid(&b, ph_amount_density(1), 3, 4, 5));
  SAME("a body comes back from its moments",
       ph_solid_box(&b, ONE, 1, 2, 3) || ph_body_at(&b, &b, LIST(1, 2, 3)) ||
           ph_body_moments(&a, 1, b.com, b.second),
       ph_solid_box(&b, ONE, 1, 2, 3) || ph_body_at(&b, &b, LIST(1, 2, 3)));
  /* a shear that brings a far body near: x - y, with the 0.01 m that only the tail holds */
  ph_body far, near_by;
  int s = ph_solid_box(&far, ONE, 1, 1, 1) || ph_body_at(&far, &far, LIST(1e15 + 3, 1e15, 0)) ||
          ph_body_at(&far, &far, LIST(0.01, 0, 0)) ||
          ph_body_affine(&near_by, &far, LIST(1, -1, 0, 0, 1, 0, 0, 0, 1));
  ok(s == 0, "a far body is sheared");
  near(near_by.com[0], 3.01, TOL * 3, "a shear brings a centre from 1e15 m to 3.01 m without loss");
  /* region in whatever order of integration: the tetrahedron of the coordinate planes */
  const ph_term u[] = {{1, {0, 0, 0}}, {-1, {0, 0, 1}}, {-1, {1, 0, 0}}};
  const ph_polynomial limit[] = {{0, NULL}, {1, u}, {0, NULL}, {2, u}, {0, NULL}, {3, u}};
  SAME("a region of three planes is a tetrahedron",
       ph_region(&a, DENSE, (const int[]){2, 0, 1}, limit, NULL),
       ph_solid_tetrahedron(&b, DENSE, LIST(0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1)));
}

/* What no rounding may touch: zeros by symmetry, and a permutation of axes permutes the result. */
static void symmetry(void) {
  static const char *const centred[] = {"solid.capsule",  "solid.bicylinder", "shell.ellipsoid",
                                        "shell.cylinder", "shell.box",        "shell.torus"};
  const double size[3] = {0.7, 0.3, 1};
  ph_body b, c;
  for (size_t i = 0; i < sizeof centred / sizeof centred[0]; i++)
    for (int n = 1; n <= 3; n++)
      if (ph_shape_make(&b, centred[i], ONE, size, n) == PH_OK)
        ok(b.com[0] == 0 && b.com[1] == 0 && b.com[2] == 0 && b.com_tail[2] == 0 &&
               b.tensor[3] == 0 && b.tensor[4] == 0 && b.tensor[5] == 0,
           "%s is centred exactly", centred[i]);
  int s =
      ph_shell_ellipsoid(&b, DENSE, 0.1, 2.3, 0.7) || ph_shell_ellipsoid(&c, DENSE, 2.3, 0.7, 0.1);
  ok(s == 0 && b.mass == c.mass && b.tensor[0] == c.tensor[2] && b.tensor[1] == c.tensor[0] &&
         b.tensor[2] == c.tensor[1],
     "an ellipsoid's shell with its axes exchanged has its moments exchanged, to the bit");
  s = ph_wire_helix(&b, ONE, 0.3, 0.7, 2.6) || ph_wire_helix(&c, ONE, 0.3, -0.7, 2.6);
  ok(s == 0 && b.com[2] == -c.com[2] && b.tensor[4] == -c.tensor[4] &&
         b.tensor[5] == -c.tensor[5] && b.tensor[0] == c.tensor[0],
     "a left-handed helix is the mirror image of the right-handed one");
}

int main(void) {
  limits();
  two_roads();
  symmetry();
  return tap_done();
}
