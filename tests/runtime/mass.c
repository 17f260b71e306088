/* mass.c - bodies from shapes and particles, joined, bored, placed and scaled, against exact
   references. SPDX-License-Identifier: GPL-3.0-or-later

   Every body of the reference set is built, and its mass, centroid, centroidal tensor and tensor
   about one more point are compared. Simplices (tetrahedra,
   triangles) are built from particles: masses 1/20 at the four corners and 4/5 at the centroid
   (1/12 and 3/4 for three) have the second moments of the solid. Not here: refusals (status.c), the
   lecture's rows (lecture.c). */
#include <float.h>
#include <math.h>
#include <string.h>

#include "polhode.h"
#include "reference/inertia.h"
#include "tap.h"

/* The requirement, in ulp of the largest entry: rounding of the entries, and of the placement of
 * parts. */
static const double TOL = 4 * DBL_EPSILON;

static const ph_amount ONE = {0, 1.0}, DENSE = {1, 1.0};

static double largest(int n, const long double v[]) {
  long double size = 0;
  for (int i = 0; i < n; i++)
    size = fmaxl(size, fabsl(v[i]));
  return (double)size;
}

static const struct inertia_row *find(const char *id) {
  for (size_t i = 0; i < sizeof inertia_rows / sizeof inertia_rows[0]; i++)
    if (strcmp(inertia_rows[i].id, id) == 0)
      return &inertia_rows[i];
  return NULL;
}

static int compared[sizeof inertia_rows / sizeof inertia_rows[0]];
static double worst[4]; /* in ulp: mass, centroid, tensor, about the other point */

static void note(int which, int n, const double got[], const long double want[], double size) {
  for (int i = 0; i < n; i++)
    worst[which] =
        fmax(worst[which],
             (double)(fabsl((long double)got[i] - want[i]) / (long double)size) / DBL_EPSILON);
}

static void compare(const char *id, const ph_body *b, int status) {
  const struct inertia_row *r = find(id);
  double about[6], point[3];
  if (!ok(status == PH_OK && r, "%s is made", id))
    return;
  for (int i = 0; i < 3; i++)
    point[i] = (double)r->point[i];
  compared[r - inertia_rows] = 1;
  near(b->mass, r->mass, TOL * (double)r->mass, "%s: mass", id);
  const double size = sqrt(largest(6, r->tensor) / (double)r->mass); /* radius of gyration */
  near_all_wide(3, b->com, r->centroid, TOL * fmax(largest(3, r->centroid), size), "%s: centroid",
                id);
  near_all_wide(6, b->tensor, r->tensor, TOL * largest(6, r->tensor),
                "%s: tensor about the centroid", id);
  const int done = ph_tensor_about(b, point, about);
  ok(done == PH_OK && ph_body_check(b) == PH_OK, "%s can exist", id);
  note(0, 1, &b->mass, &r->mass, (double)r->mass);
  note(1, 3, b->com, r->centroid, fmax(largest(3, r->centroid), size));
  note(2, 6, b->tensor, r->tensor, largest(6, r->tensor));
  note(3, 6, about, r->about, largest(6, r->about));
  near_all_wide(6, about, r->about, TOL * largest(6, r->about), "%s: tensor about another point",
                id);
}

/* Add b shifted by d to *sum. */
static int add_at(ph_body *sum, const ph_body *b, double x, double y, double z) {
  ph_body moved;
  const int status = ph_body_at(&moved, b, (const double[]){x, y, z});
  return status ? status : ph_body_add(sum, sum, &moved);
}

/* A simplex with n corners of total mass m as particles. */
static int simplex(ph_body *b, int n, double m, const double corner[]) {
  double mass[5], r[15];
  const double part = n == 4 ? 1.0 / 20 : 1.0 / 12;
  for (int i = 0; i < 3; i++)
    r[3 * n + i] = 0;
  for (int k = 0; k < n; k++) {
    mass[k] = m * part;
    for (int i = 0; i < 3; i++) {
      r[3 * k + i] = corner[3 * k + i];
      r[3 * n + i] += corner[3 * k + i] / n;
    }
  }
  mass[n] = m * (1 - n * part);
  return ph_body_points(b, n + 1, mass, r);
}

static void single_shapes(void) {
  ph_body b;
  int s = ph_solid_box(&b, ONE, 1.5, 1.5, 1.5);
  compare("cube_1.5", &b, s);
  s = ph_solid_ellipsoid(&b, ONE, 3, 4, 5);
  compare("ellipsoid_3_4_5", &b, s);
  s = ph_solid_hemisphere(&b, ONE, 2);
  compare("hemisphere_2", &b, s);
  s = ph_solid_hollow_sphere(&b, ONE, 1, 2);
  compare("thick_spherical_shell_1_2", &b, s);
  s = ph_solid_torus(&b, ONE, 3, 1);
  compare("torus_3_1", &b, s);
  s = ph_solid_box(&b, ONE, 0x1p27, 1, 0x1p-27);
  compare("plate_extreme_2^-27", &b, s);
  near(b.second[2], 0x1p-54L / 12, DBL_EPSILON * 0x1p-54 / 12,
       "a plate 2^27 x 1 x 2^-27 keeps its smallest second moment to an ulp of itself");
  s = ph_plate_rectangle(&b, ONE, 2, 3);
  compare("rectangle_plate_2_3", &b, s);
  s = ph_plate_disc(&b, ONE, 2);
  compare("disc_2", &b, s);
  s = ph_plate_annulus(&b, ONE, 1, 2);
  compare("annulus_1_2", &b, s);
  s = ph_rod_between(&b, ONE, (const double[]){0, 0, 0}, (const double[]){1, 2, 2});
  compare("rod_oblique", &b, s);
  s = ph_wire_hoop(&b, ONE, 2);
  compare("hoop_2", &b, s);
  s = ph_body_points(&b, 3, (const double[]){16, 1, 1},
                     (const double[]){0, 0, 0, 0.75, 0, 0.578125, -0.75, 0, 0.578125});
  compare("molecule_h2o_geometry", &b, s);
}

static void composites(void) {
  const double half_turn[] = {0, 1, 0, 0}, z_to_y[] = {1, -1, 0, 0}, z_to_x[] = {1, 0, 1, 0};
  ph_body a, b, c;
  ph_solid_box(&a, DENSE, 4, 4, 4);
  ph_solid_sphere(&b, DENSE, 1);
  ph_body_at(&c, &b, (const double[]){0.5, 0.25, -0.5});
  int s = ph_body_subtract(&a, &a, &c);
  compare("cube_with_spherical_void", &a, s);

  ph_solid_cylinder(&a, DENSE, 0.25, 4);
  s = add_at(&a, &b, 0, 0, 3) || add_at(&a, &b, 0, 0, -3);
  compare("dumbbell", &a, s);

  ph_solid_cylinder(&a, DENSE, 0.125, 1);
  ph_solid_cylinder(&b, DENSE, 0.125, 0.5);
  ph_body_turned(&a, &a, z_to_y);
  s = ph_body_turned(&b, &b, z_to_x) || add_at(&a, &b, 0.375, 0, 0);
  compare("t_handle", &a, s);

  ph_solid_cylinder(&a, DENSE, 1.25, 0.25);
  ph_body_at(&a, &a, (const double[]){0, 0, -0.125});
  ph_solid_tube(&b, DENSE, 1, 1.25, 3);
  s = add_at(&a, &b, 0, 0, 1.5);
  compare("cup", &a, s);

  ph_solid_box(&a, ph_amount_density(1), 1, 1, 2);
  ph_body_at(&a, &a, (const double[]){0, 0, 1});
  ph_solid_box(&b, ph_amount_density(8), 1, 1, 2);
  s = add_at(&a, &b, 0, 0, -1);
  compare("two_density_rod", &a, s);

  /* six faces: four of them turned, each a sixth of the mass */
  ph_plate_rectangle(&b, ph_amount_mass(1.0 / 6), 2, 2);
  ph_body_at(&a, &b, (const double[]){0, 0, 1});
  ph_body_turned(&c, &a, half_turn);
  s = ph_body_add(&c, &c, &a);
  ph_body_turned(&a, &b, z_to_x);
  s = s || add_at(&c, &a, 1, 0, 0) || add_at(&c, &a, -1, 0, 0);
  ph_body_turned(&a, &b, z_to_y);
  s = s || add_at(&c, &a, 0, 1, 0) || add_at(&c, &a, 0, -1, 0);
  compare("cube_shell_2", &c, s);

  ph_rod_between(&c, ph_amount_mass(0.2), (const double[]){-1, 1.5, 0},
                 (const double[]){1, 1.5, 0});
  ph_rod_between(&a, ph_amount_mass(0.2), (const double[]){-1, -1.5, 0},
                 (const double[]){1, -1.5, 0});
  s = ph_body_add(&c, &c, &a);
  ph_rod_between(&a, ph_amount_mass(0.3), (const double[]){0, -1.5, 0},
                 (const double[]){0, 1.5, 0});
  s = s || add_at(&c, &a, 1, 0, 0) || add_at(&c, &a, -1, 0, 0);
  compare("rectangle_frame_2_3", &c, s);

  s = 0;
  int edges = 0;
  for (int axis = 0; axis < 3;
       axis++) /* an edge along each axis at the four corners of its square */
    for (int corner = 0; corner < 4; corner++) {
      double from[3], to[3];
      for (int i = 0; i < 3; i++)
        from[i] = to[i] = (i == (axis + 1) % 3 ? corner & 1 : corner >> 1) ? 1 : -1;
      from[axis] = -1, to[axis] = 1;
      s = s || ph_rod_between(&a, ph_amount_mass(1.0 / 12), from, to);
      if (edges++)
        s = s || ph_body_add(&c, &c, &a);
      else
        c = a;
    }
  compare("cube_wireframe_2", &c, s);
}

static void simplices(void) {
  ph_body a, b;
  const double tonon[] = {8.3322,   -11.86875, 0.93355, 0.75523, 5, 16.37072,
                          52.61236, 5,         -5.3858, 2,       5, 3};
  int s = simplex(&a, 4, (double)find("tetrahedron_tonon2004")->mass, tonon);
  compare("tetrahedron_tonon2004", &a, s);
  s = simplex(&a, 4, 1, (const double[]){0, 0, 0, 1, 0, 0, 0, 1, 0, 0.5, 0.5, 0x1p-40});
  compare("sliver_tetrahedron", &a, s);
  const double L = 0x1p30;
  s = simplex(&a, 4, 1, (const double[]){L, L, -L, L + 1, L, -L, L, L + 1, -L, L, L, 1 - L});
  compare("tetrahedron_far_2^30", &a, s);
  s = simplex(&a, 3, 1, (const double[]){0, 0, 0, 3, 0, 0, 1, 2, 2});
  compare("triangle_plate_3d", &a, s);
  const double corner[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  s = 0;
  const double area[4] = {sqrt(0.75), 0.5, 0.5, 0.5}; /* of the face opposite to each corner */
  for (int k = 0; k < 4; k++) {
    double face[9];
    for (int j = 0, n = 0; j < 4; j++)
      if (j != k) {
        memcpy(face + 3 * n, corner + 3 * j, sizeof(double[3]));
        n++;
      }
    s = s || simplex(&b, 3, area[k] / (1.5 + sqrt(0.75)), face);
    if (k == 0)
      a = b;
    else
      s = s || ph_body_add(&a, &a, &b);
  }
  compare("tetra_shell_pyramid", &a, s);
}

/* The rest of the reference set, by shapes of points, outlines and limits. */
static void listed_shapes(void) {
  const double half_turn[] = {0, 1, 0, 0}, phi = 1.6180339887498949, pi = 3.1415926535897931;
  const double tonon[] = {8.3322,   -11.86875, 0.93355, 0.75523, 5, 16.37072,
                          52.61236, 5,         -5.3858, 2,       5, 3};
  ph_body a, b;
  int s = ph_solid_tetrahedron(&a, DENSE, tonon);
  compare("tetrahedron_tonon2004", &a, s);
  s = ph_solid_tetrahedron(&a, ONE, (const double[]){0, 0, 0, 1, 0, 0, 0, 1, 0, 0.5, 0.5, 0x1p-40});
  compare("sliver_tetrahedron", &a, s);
  const double L = 0x1p30;
  s = ph_solid_tetrahedron(&a, ONE,
                           (const double[]){L, L, -L, L + 1, L, -L, L, L + 1, -L, L, L, 1 - L});
  compare("tetrahedron_far_2^30", &a, s);
  s = ph_plate_triangle(&a, ONE, (const double[]){0, 0, 0, 3, 0, 0, 1, 2, 2});
  compare("triangle_plate_3d", &a, s);
  s = ph_shell_box(&a, ONE, 2, 2, 2);
  compare("cube_shell_2", &a, s);
  s = ph_wire_polyline(&a, ONE, 4, (const double[]){-1, -1.5, 0, 1, -1.5, 0, 1, 1.5, 0, -1, 1.5, 0},
                       1);
  compare("rectangle_frame_2_3", &a, s);
  s = ph_solid_regular(&a, ONE, 20, 2);
  compare("regular_icosahedron", &a, s);
  s = ph_solid_regular(&a, ONE, 12, 2 / phi);
  compare("regular_dodecahedron", &a, s);
  s = ph_solid_quarter_cylinder(&a, ONE, 2, 3);
  compare("quarter_cylinder_2_3", &a, s);
  s = ph_wire_helix(&a, ONE, 1, pi, 2);
  compare("helix_2_turns", &a, s);
  s = ph_wire_catenary(&a, ONE, 1, 2);
  compare("catenary_wire", &a, s);
  const double y = sqrt(0.75);
  s = ph_plate_polygon(&a, ONE, 1, (const int[]){6},
                       (const double[]){1, 0, 0.5, y, -0.5, y, -1, 0, -0.5, -y, 0.5, -y});
  compare("hexagon_plate_1", &a, s);
  /* apex at the origin, base above: upside down */
  const double up3[] = {0, 0, 3}, up4[] = {0, 0, 4};
  s = ph_solid_pyramid(&a, ONE, 2, 2, 3) || ph_body_turned(&a, &a, half_turn) ||
      ph_body_at(&a, &a, up3);
  compare("square_pyramid_2_3", &a, s);
  s = ph_shell_cone(&a, ONE, 3, 4) || ph_body_turned(&a, &a, half_turn) || ph_body_at(&a, &a, up4);
  compare("cone_shell_3_4", &a, s);
  /* symmetric about x: turned back by half the angle */
  s = ph_plate_sector(&a, ONE, 2, pi / 3) ||
      ph_body_turned(&a, &a, (const double[]){cos(pi / 12), 0, 0, -sin(pi / 12)});
  compare("circular_sector_2_60deg", &a, s);
  s = ph_solid_zone(&a, DENSE, 5, -4, 4) || ph_solid_cylinder(&b, DENSE, 3, 8) ||
      ph_body_subtract(&a, &a, &b);
  compare("napkin_ring", &a, s);
  /* x^2 + y^2 <= (1 - z^2)^2 has no polynomial limits, but |x|, |y| <= 1 - z^2 has: the mean x^2
     over a square is 1/3 of its half-side squared, over a disc 1/4 of r^2, so sqrt(3/4) of the one
     has the moments of the other */
  const ph_term wall[] = {{-1, {0, 0, 0}}, {1, {0, 0, 2}}},
                top[] = {{1, {0, 0, 0}}, {-1, {0, 0, 2}}};
  const ph_polynomial limits[] = {{1, wall}, {1, top}, {2, wall}, {2, top}, {2, wall}, {2, top}};
  s = ph_region(&a, ONE, (const int[]){2, 0, 1}, limits, NULL) ||
      ph_body_scaled(&a, &a, (const double[]){sqrt(0.75), sqrt(0.75), 1});
  compare("parabolic_spindle", &a, s);
  /* no shape of the library is an eighth of a ball: given its moments, eight of them are the ball
   */
  const struct inertia_row *r = find("sphere_octant_2");
  double com[3], tensor[6];
  for (int i = 0; i < 6; i++)
    tensor[i] = (double)r->tensor[i], com[i % 3] = (double)r->centroid[i % 3];
  s = ph_body_tensor(&b, 1, com, tensor);
  compare("sphere_octant_2", &b, s);
  for (int i = 0; i < 3; i++) {
    ph_body mirrored;
    const double k[3] = {i == 0 ? -1 : 1, i == 1 ? -1 : 1, i == 2 ? -1 : 1};
    s = s || ph_body_scaled(&mirrored, &b, k) || ph_body_add(&b, &b, &mirrored);
  }
  s = s || ph_solid_sphere(&a, ph_amount_mass(8), 2);
  ok(s == 0, "eight octants are joined");
  near_all(3, b.com, a.com, TOL, "eight octants are centred");
  near_all(6, b.tensor, a.tensor, 2 * TOL * a.tensor[0], "eight octants are a ball");
}

/* Every row of the table is built somewhere above. */
static void all_rows(void) {
  for (size_t i = 0; i < sizeof inertia_rows / sizeof inertia_rows[0]; i++)
    ok(compared[i], "%s has been built", inertia_rows[i].id);
  diag(
      "worst errors against the reference set in ulp: mass %.2f, centroid %.2f, tensor %.2f, about "
      "another point %.2f",
      worst[0], worst[1], worst[2], worst[3]);
}

/* Shapes without a row of their own: made in two ways. */
static void two_ways(void) {
  ph_body a, b, c;
  ph_solid_cone(&a, DENSE, 2, 3);
  ph_solid_cone(&b, DENSE, 1, 1.5); /* the tip */
  ph_body_at(&b, &b, (const double[]){0, 0, 1.5});
  int s = ph_body_subtract(&a, &a, &b) || ph_solid_frustum(&c, DENSE, 2, 1, 1.5);
  ok(s == 0, "cone, tip and frustum are made");
  /* the cone is 8 times the tip, and what is taken away about 1/7 of what remains */
  near(a.mass, (long double)c.mass, 2 * TOL * c.mass, "a cone without its tip weighs a frustum");
  near_all(3, a.com, c.com, 2 * TOL, "a cone without its tip has the frustum's centroid");
  near_all(6, a.tensor, c.tensor, 4 * TOL * c.tensor[0],
           "a cone without its tip has the frustum's tensor");

  ph_solid_capsule(&a, DENSE, 0.5, 2);
  ph_solid_cylinder(&b, DENSE, 0.5, 2);
  ph_solid_hemisphere(&c, DENSE, 0.5);
  s = add_at(&b, &c, 0, 0, 1);
  ph_body_turned(&c, &c, (const double[]){0, 1, 0, 0});
  s = s || add_at(&b, &c, 0, 0, -1);
  ok(s == 0, "a capsule is assembled");
  near(a.mass, (long double)b.mass, TOL * b.mass, "capsule = cylinder + two hemispheres: mass");
  near_all(6, a.tensor, b.tensor, TOL * b.tensor[0],
           "capsule = cylinder + two hemispheres: tensor");

  /* Scaling keeps mass: an ellipsoid is a scaled ball, an elliptic cylinder a scaled round one. */
  ph_solid_sphere(&a, ONE, 1);
  s = ph_body_scaled(&a, &a, (const double[]){3, 4, 5}) || ph_solid_ellipsoid(&b, ONE, 3, 4, 5);
  ok(s == 0, "a ball is scaled");
  near_all(6, a.tensor, b.tensor, TOL * b.tensor[0], "a ball scaled by 3, 4, 5 is the ellipsoid");
  ph_solid_cylinder(&a, ONE, 1, 1);
  s = ph_body_scaled(&a, &a, (const double[]){2, 3, 4}) ||
      ph_solid_elliptic_cylinder(&b, ONE, 2, 3, 4);
  ok(s == 0, "a cylinder is scaled");
  near_all(6, a.tensor, b.tensor, TOL * b.tensor[0],
           "a cylinder scaled by 2, 3, 4 is the elliptic one");
  ph_plate_disc(&a, ONE, 1);
  s = ph_body_scaled(&a, &a, (const double[]){2, 3, 1}) || ph_plate_ellipse(&b, ONE, 2, 3);
  ok(s == 0, "a disc is scaled");
  near_all(6, a.tensor, b.tensor, TOL * b.tensor[2], "a disc scaled by 2, 3 is the ellipse");
  /* a mirror in x changes the sign of what is odd in x: com x, and the entries xy and xz */
  s = ph_rod_between(&a, ONE, (const double[]){1, 2, 3}, (const double[]){2, 4, -1}) ||
      ph_body_scaled(&b, &a, (const double[]){-1, 1, 1});
  ok(s == 0 && b.com[0] == -a.com[0] && b.com[1] == a.com[1],
     "a mirrored rod's centre is mirrored");
  const double mirrored[6] = {a.tensor[0],  a.tensor[1],  a.tensor[2],
                              -a.tensor[3], -a.tensor[4], a.tensor[5]};
  near_all(6, b.tensor, mirrored, TOL * a.tensor[2], "a mirror changes the sign of xy and xz");
  s = ph_rod_straight(&a, ONE, 3) ||
      ph_rod_between(&b, ONE, (const double[]){0, 0, -1.5}, (const double[]){0, 0, 1.5});
  ok(s == 0, "two rods are made");
  near_all(6, a.tensor, b.tensor, 0, "rod.straight is rod.between its ends");
  /* tube = cylinder - bore, both by density */
  ph_solid_cylinder(&a, DENSE, 2, 3);
  ph_solid_cylinder(&b, DENSE, 1, 3);
  s = ph_body_subtract(&a, &a, &b) || ph_solid_tube(&c, DENSE, 1, 2, 3);
  ok(s == 0, "a cylinder is bored");
  near_all(6, a.tensor, c.tensor, 2 * TOL * c.tensor[0], "a cylinder with a bore is the tube");
}

static void far_away(void) {
  /* Two pairs of a dumbbell, 2 m apart, 1e9 m from the origin: about their own centre they are what
   * they are. */
  const double far[3] = {1e9, -1e9, 1e9}, third[3] = {1e9 + 1, -1e9, 1e9};
  ph_body a, b, c;
  ph_solid_sphere(&a, ONE, 0.1);
  ph_body_at(&b, &a, far);
  ph_body_at(&c, &a, third);
  int s = ph_body_add(&b, &b, &c);
  ph_body_at(&c, &a, (const double[]){1e9, -1e9, 1e9 + 3});
  s = s || ph_body_add(&b, &b, &c);
  ok(s == 0, "three balls are joined at 1e9 m");
  /* centres (0,0,0), (1,0,0), (0,0,3), each of mass 1 and 2/5 m r^2 = 0.004 kg m2 */
  const long double ball = 0.4L * 3 * 0.1L * 0.1L, third_part = 1.0L / 3;
  near_all_wide(
      6, b.tensor,
      ((const long double[]){ball + 6, ball + 6 + 2 * third_part, ball + 2 * third_part, 0, 1, 0}),
      TOL * 7, "three balls at 1e9 m have the tensor that they have at 0 m");
  near_all_wide(3, b.com, ((const long double[]){1e9L + third_part, -1e9L, 1e9L + 1}),
                1e9 * DBL_EPSILON / 2, "their centre is the nearest double");
  near(b.com_tail[0] + (b.com[0] - 1e9), third_part, TOL, "and the tail holds the rest of it");
  /* back to the origin: what is left is the exact small centre */
  s = ph_body_at(&b, &b, (const double[]){-1e9, 1e9, -1e9});
  ok(s == 0, "they come back");
  near_all_wide(3, b.com, ((const long double[]){third_part, 0, 1}), TOL,
                "moved back, the centre is as near as ever");
  const double m[2] = {1, 3}, r[6] = {1e9, 1e9, 1e9, 1e9 + 4, 1e9, 1e9};
  s = ph_body_points(&b, 2, m, r);
  ok(s == 0, "two particles at 1e9 m are a body");
  near_all_wide(6, b.tensor, ((const long double[]){0, 12, 12, 0, 0, 0}), TOL * 12,
                "two particles at 1e9 m: reduced mass times distance squared");
}

static void tensors_given(void) {
  ph_body b;
  const double I[6] = {1, 1, 1e-12, 0, 0, 0}, com[3] = {1, 2, 3};
  double about[6];
  int s = ph_body_tensor(&b, 2, com, I);
  ok(s == 0, "a tensor with a moment of 1e-12 is a body");
  near_all(6, b.tensor, I, 0, "a given tensor comes back unchanged");
  ph_tensor_about(&b, (const double[]){0, 0, 0}, about);
  s = ph_body_tensor_origin(&b, 2, com, about);
  ok(s == 0, "the same from the tensor about the origin");
  near_all(6, b.tensor, I, TOL * 27,
           "tensor about the origin -> about com, to the rounding of what was given");
  s = ph_body_tensor_origin(&b, 1, com, (const double[]){13, 10, 5, -2, -3, -6});
  ok(s == 0 && b.tensor[0] == 0 && b.tensor[1] == 0 && b.tensor[5] == 0,
     "a point mass's tensor leaves nothing");
  int valid = 0;
  for (int n = 1; n <= 100; n++) { /* tensors whose digits end in rounding, of either sign */
    const double at[3] = {0.1 * n, 0.2, -0.3 * n};
    ph_particles_tensor(1, (const double[]){0.7}, at, about);
    valid += ph_body_tensor_origin(&b, 0.7, at, about) == PH_OK && ph_body_check(&b) == PH_OK;
  }
  ok(valid == 100,
     "100 point masses given by tensors about the origin are bodies, whatever the rounding");
  s = ph_body_tensor(&b, 2, com, I) || ph_body_scaled(&b, &b, (const double[]){3, 3, 3});
  ok(s == 0 && b.tensor[2] == 9 * 1e-12,
     "a similarity scales a moment of 1e-12 beside 1 without loss");
  /* 45 degrees about z swaps half: xx, yy -> mean, xy = (xx - yy)/2 */
  s = ph_body_tensor(&b, 1, (const double[]){1, 0, 0}, (const double[]){1, 2, 2.5, 0, 0, 0});
  const double r = sqrt(0.5), q[4] = {cos(0.39269908169872414), 0, 0, sin(0.39269908169872414)};
  s = s || ph_body_turned(&b, &b, q);
  ok(s == 0, "a tensor is turned");
  near_all_wide(6, b.tensor, ((const long double[]){1.5L, 1.5L, 2.5L, -0.5L, 0, 0}), TOL * 2.5,
                "turned by 45 degrees about z, xy is half the difference");
  near_all(3, b.com, ((const double[]){r, r, 0}), TOL, "and the centre turns along");
}

static void catalogue(void) {
  int n = 0, same = 1;
  ph_body b;
  for (const char *name; (name = ph_shape_name(n)) != NULL; n++) {
    int count = 1;
    for (const char *c = ph_shape_arguments(n); *c; c++)
      count += *c == ' ';
    /* one set of sizes suits most; some need the larger one first, a count, a flag */
    const double arg[6] = {2, 2.5, 3, 1, 1, 1}, falling[3] = {3, 1, 2}, regular[2] = {8, 1},
                 cylinder[3] = {2, 3, 1};
    const double *sizes = strstr(name, "torus") || strstr(name, "zone") ? falling
                          : strcmp(name, "solid.regular") == 0          ? regular
                          : strcmp(name, "shell.cylinder") == 0         ? cylinder
                                                                        : arg;
    const int s = ph_shape_make(&b, name, ONE, sizes, count);
    same =
        ok(s == PH_OK && ph_body_check(&b) == PH_OK && b.mass == 1, "%s can be made", name) && same;
  }
  ok(n == 43 && same,
     "43 shapes are in the catalogue, and each makes a body of mass 1 that can exist");
  ok(ph_shape_name(-1) == NULL && ph_shape_arguments(n) == NULL, "the catalogue ends with NULL");
  ph_shape_make(&b, "solid.tube", DENSE, (const double[]){1, 2, 3}, 3);
  near(b.mass, 9 * 3.14159265358979323846L, TOL * 30, "the volume of a tube 1, 2, 3 is 9 pi");
}

int main(void) {
  single_shapes();
  composites();
  simplices();
  listed_shapes();
  all_rows();
  two_ways();
  far_away();
  tensors_given();
  catalogue();
  return tap_done();
}
