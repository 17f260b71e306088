/* status.c - every refusal: which status, and outputs untouched.
   SPDX-License-Identifier: GPL-3.0-or-later

   A table of calls that must fail; each writes into an output that was filled with a pattern, and
   the pattern must be there afterwards. At the end every status of the enumeration must have
   occurred but the one that needs a machine without memory. */
#include <math.h>
#include <string.h>

#include "polhode.h"
#include "tap.h"

/* as doubles: math.h has them as floats */
#define NOT_A_NUMBER ((double)NAN)
#define ENDLESS      ((double)INFINITY)

static int seen[PH_EMEMORY + 1];

static union {
  unsigned char bytes[sizeof(ph_top) + sizeof(ph_body)];
  double number[16];
  ph_body body;
  ph_axes axes;
  ph_top top;
  ph_acceleration acceleration;
  ph_symmetric symmetric;
  ph_stability stability;
  ph_run *run;
} out, pattern;

static void fresh(void) {
  memset(&pattern, 0x5a, sizeof pattern);
  out = pattern;
}

static void refused(int status, int want, const char *what) {
  seen[status]++;
  ok(status == want && memcmp(&out, &pattern, sizeof out) == 0, "%s: %s", what,
     ph_status_phrase(want));
  if (status != want)
    diag("got %s", ph_status_phrase(status));
  fresh();
}

static const ph_amount ONE = {0, 1.0};
static const double ZERO[9] = {0}, E1[3] = {1, 0, 0},
                    BAD[9] = {NOT_A_NUMBER, NOT_A_NUMBER, NOT_A_NUMBER, NOT_A_NUMBER, NOT_A_NUMBER,
                              NOT_A_NUMBER, NOT_A_NUMBER, NOT_A_NUMBER, NOT_A_NUMBER};
static const double ONE4[4] = {1, 0, 0, 0};
static const double HUGE3[3] = {1e200, 1e200, 1e200};

static void bodies(void) {
  ph_body *b = &out.body, box, small, far;
  ph_solid_box(&box, ONE, 1, 1, 1);
  ph_solid_box(&small, ONE, 0.5, 0.5, 0.5);
  ph_body_at(&far, &small, (const double[]){3, 0, 0});
  far.mass = 0.5;
  refused(ph_solid_box(b, ONE, 1, 0, 1), PH_ELENGTH, "a box without height");
  refused(ph_solid_box(b, ONE, 1, -2, 1), PH_ELENGTH, "a box of negative height");
  refused(ph_solid_box(b, ONE, 1, NOT_A_NUMBER, 1), PH_EFINITE, "a box of NaN height");
  refused(ph_solid_box(b, ph_amount_mass(0), 1, 1, 1), PH_EMASS, "a box without mass");
  refused(ph_solid_box(b, ph_amount_density(-1), 1, 1, 1), PH_EMASS, "a box of negative density");
  refused(ph_solid_box(b, ph_amount_mass(ENDLESS), 1, 1, 1), PH_EFINITE, "a box of infinite mass");
  refused(ph_solid_box(b, ONE, 1e200, 1, 1), PH_ERANGE, "a box of 1e200 m: its tensor");
  refused(ph_solid_box(b, ph_amount_density(1e-300), 1e-30, 1, 1), PH_EMASS, "a mass of 1e-330 kg");
  refused(ph_solid_tube(b, ONE, 2, 1, 1), PH_EORDER, "a tube wider inside than outside");
  refused(ph_solid_hollow_sphere(b, ONE, 1, 1), PH_EORDER, "a shell without thickness");
  refused(ph_plate_annulus(b, ONE, 2, 2), PH_EORDER, "a ring without width");
  refused(ph_solid_torus(b, ONE, 1, 2), PH_EORDER, "a torus that runs through itself");
  refused(ph_rod_between(b, ONE, E1, E1), PH_ELENGTH, "a rod from a point to itself");
  refused(ph_shape_make(b, "solid.teapot", ONE, ZERO, 1), PH_ENAME, "a teapot");
  refused(ph_shape_make(b, "solid.box", ONE, ZERO, 2), PH_ECOUNT, "a box with two edges");
  refused(ph_body_points(b, 0, ZERO, ZERO), PH_ECOUNT, "no particles");
  refused(ph_body_points(b, 1, ZERO, ZERO), PH_EMASS, "a particle without mass");
  refused(ph_body_points(b, 1, E1, BAD), PH_EFINITE, "a particle nowhere");
  refused(ph_body_points(b, 2, (const double[]){1, 1}, (const double[]){1e200, 0, 0, -1e200, 0, 0}),
          PH_ERANGE, "particles 1e200 m apart");
  refused(ph_body_tensor(b, 1, ZERO, (const double[]){1, 1, -1e-9, 0, 0, 0}), PH_EPOSITIVE,
          "a negative moment");
  refused(ph_body_tensor(b, 1, ZERO, (const double[]){1, 1, 1, 2, 0, 0}), PH_EPOSITIVE,
          "products larger than moments");
  refused(ph_body_tensor(b, 1, ZERO, (const double[]){1, 1, 2.001, 0, 0, 0}), PH_ETRIANGLE,
          "moments 1, 1, 2.001");
  refused(ph_body_tensor(b, 0, ZERO, (const double[]){1, 1, 1, 0, 0, 0}), PH_EMASS,
          "a tensor without mass");
  refused(ph_body_tensor(b, 1, BAD, (const double[]){1, 1, 1, 0, 0, 0}), PH_EFINITE,
          "a tensor nowhere");
  refused(
      ph_body_tensor_origin(b, 1, (const double[]){2, 0, 0}, (const double[]){1, 1, 1, 0, 0, 0}),
      PH_EPOSITIVE, "a tensor about the origin smaller than M R^2");
  refused(ph_body_at(b, &box, BAD), PH_EFINITE, "moved nowhere");
  far.com[0] = 1.7e308;
  refused(ph_body_at(b, &far, (const double[]){1.7e308, 0, 0}), PH_ERANGE,
          "moved beyond the largest double");
  far.com[0] = 3;
  refused(ph_body_turned(b, &box, ZERO), PH_EQUATERNION, "turned by the quaternion 0");
  refused(ph_body_turned(b, &box, BAD), PH_EFINITE, "turned by NaN");
  refused(ph_body_scaled(b, &box, ZERO), PH_ELENGTH, "scaled to nothing");
  refused(ph_body_scaled(b, &box, BAD), PH_EFINITE, "scaled by NaN");
  refused(ph_body_add(b, &box, &(ph_body){.mass = 1, .com = {1e308, 0, 0}}), PH_ERANGE,
          "joined over 1e308 m");
  refused(ph_body_subtract(b, &box, &box), PH_EHOLE, "a hole as heavy as the body");
  refused(ph_body_subtract(b, &box, &far), PH_EHOLE, "a hole beside the body");
  box.mass = -1;
  refused(ph_body_check(&box), PH_EMASS, "a body whose mass was overwritten");
  box.mass = NOT_A_NUMBER;
  refused(ph_body_check(&box), PH_EFINITE, "a body of NaN mass");
}

/* What shapes of sizes, of points, of outlines and of limits refuse, beyond what a box does. */
static void shapes(void) {
  ph_body *b = &out.body;
  const double pi2 = 6.283185307179587, nan = NOT_A_NUMBER;
  refused(ph_solid_cap(b, ONE, 1, 2.0000000000000004), PH_EBOUND, "a cap higher than its ball");
  refused(ph_solid_sector(b, ONE, 1, 2.5), PH_EBOUND, "a spherical sector beyond the ball");
  refused(ph_solid_zone(b, ONE, 1, 0.5, 0.5), PH_EBOUND, "a zone without height");
  refused(ph_solid_zone(b, ONE, 1, -1.5, 0.5), PH_EBOUND, "a zone below the ball");
  refused(ph_shell_zone(b, ONE, 1, 0, 1.5), PH_EBOUND, "a zone above the sphere");
  refused(ph_plate_sector(b, ONE, 1, pi2), PH_EBOUND, "a sector of more than the full angle");
  refused(ph_wire_arc(b, ONE, 1, pi2), PH_EBOUND, "an arc of more than the full angle");
  refused(ph_wire_arc(b, ONE, 1, 0), PH_ELENGTH, "an arc of no angle");
  refused(ph_wire_helix(b, ONE, 1, 1, -1), PH_ELENGTH, "a helix of -1 turns");
  refused(ph_wire_helix(b, ONE, 1, nan, 1), PH_EFINITE, "a helix of NaN pitch");
  refused(ph_wire_catenary(b, ONE, 1, 1e6), PH_ERANGE, "a catenary as high as e^500000");
  refused(ph_wire_catenary(b, ONE, 1, 2000), PH_ERANGE, "a catenary as high as e^1000");
  refused(ph_solid_regular(b, ONE, 10, 1), PH_ECOUNT, "a regular polyhedron of ten faces");
  refused(ph_shell_torus(b, ONE, 1, 2), PH_EORDER, "a shell that runs through itself");
  refused(ph_shape_make(b, "shell.cylinder", ONE, (const double[]){1, 1, 2}, 3), PH_EBOUND,
          "a cylinder with ends = 2");
  refused(ph_solid_tetrahedron(b, ONE, (const double[]){0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}),
          PH_EFLAT, "a flat tetrahedron");
  refused(ph_solid_parallelepiped(b, ONE, (const double[]){1, 2, 3, 4, 5, 6, 7, 8, 9}), PH_EFLAT,
          "edges in one plane");
  refused(ph_plate_triangle(b, ONE, (const double[]){0, 0, 0, 1, 2, 3, 2, 4, 6}), PH_EFLAT,
          "a triangle on a line");
  refused(ph_plate_triangle(b, ONE, BAD), PH_EFINITE, "a triangle nowhere");
  refused(ph_wire_polyline(b, ONE, 1, E1, 0), PH_ECOUNT, "a polyline of one point");
  refused(ph_wire_polyline(b, ONE, 3, ZERO, 1), PH_ELENGTH, "a polyline that goes nowhere");
  refused(ph_wire_polyline(b, ph_amount_mass(-1), 3, ZERO, 1), PH_EMASS, "a polyline of mass -1");

  const int one[] = {4}, two[] = {4, 3}, three[] = {4, 3, 3}, few[] = {2};
#define PLATE(n, count, ...) ph_plate_polygon(b, ONE, n, count, (const double[]){__VA_ARGS__})
#define SQUARE               0, 0, 4, 0, 4, 4, 0, 4
  refused(PLATE(0, one, 0), PH_ECOUNT, "no outline");
  refused(PLATE(1, few, SQUARE), PH_ECOUNT, "an outline of two points");
  refused(PLATE(1, one, 0, 0, 1, 1, 2, 2, 3, 3), PH_EFLAT, "an outline on a line");
  refused(PLATE(1, one, 0, 0, 1, 0, nan, 1, 0, 1), PH_EFINITE, "an outline through NaN");
  refused(PLATE(1, one, 0, 0, 1, 1, 1, 0, 0, 1), PH_ECROSS, "a bow tie");
  refused(PLATE(1, one, 0, 0, 4, 0, 2, 0, 2, 4), PH_ECROSS, "an outline that turns back");
  refused(PLATE(1, one, 0, 0, 4, 0, 0, 4, 0, 0), PH_ECROSS, "an outline with a point twice");
  refused(PLATE(2, two, SQUARE, 5, 5, 6, 5, 5, 6), PH_EHOLE, "a hole beside the plate");
  refused(PLATE(2, two, SQUARE, 3, 1, 5, 1, 3, 2), PH_EHOLE, "a hole across the edge");
  refused(PLATE(2, two, SQUARE, 4, 1, 2, 1, 2, 2), PH_EHOLE, "a hole that touches the edge");
  refused(PLATE(2, two, 1, 1, 2, 1, 2, 2, 1, 2, 0, 0, 9, 0, 0, 9), PH_EHOLE,
          "a hole around the plate");
  refused(PLATE(3, three, SQUARE, 1, 1, 3, 1, 1, 3, 1.5, 1.5, 2, 1.5, 1.5, 2), PH_EHOLE,
          "a hole in a hole");
  refused(PLATE(3, three, SQUARE, 1.5, 1.5, 2, 1.5, 1.5, 2, 1, 1, 3, 1, 1, 3), PH_EHOLE,
          "a hole around a hole");
  const double square[] = {SQUARE}, left[] = {-1, 0, 1, 0, 1, 1, 0, 1};
  refused(ph_solid_prism(b, ONE, 4, square, 0), PH_ELENGTH, "a prism without height");
  refused(ph_extrude(b, ONE, 1, one, square, nan), PH_EFINITE, "a prism of NaN height");
  refused(ph_revolve(b, ONE, 1, one, left), PH_EBOUND, "a profile across the axis");
  refused(ph_revolve(b, ph_amount_density(0), 1, one, square), PH_EMASS,
          "a turned part of no density");

  const ph_term unit = {1, {0, 0, 0}}, in_x = {1, {1, 0, 0}}, back = {1, {-1, 0, 0}},
                minus = {-1, {0, 0, 0}}, steep = {1, {200, 0, 0}}, none = {nan, {0, 0, 0}};
  const ph_polynomial O = {0, NULL}, l = {1, &unit}, x = {1, &in_x}, neg = {1, &minus};
  const int xyz[] = {0, 1, 2}, yxz[] = {1, 0, 2}, xxz[] = {0, 0, 2};
  const ph_polynomial cube[] = {O, l, O, l, O, l}, wedge[] = {O, l, O, x, O, l},
                      crossed[] = {O, l, l, O, O, l}, powers[] = {O, l, O, {1, &back}, O, l},
                      high[] = {O, l, O, {1, &steep}, O, l}, lost[] = {O, l, O, l, O, {1, &none}};
  refused(ph_region(b, ONE, xxz, cube, NULL), PH_EBOUND, "a region that integrates x twice");
  refused(ph_region(b, ONE, yxz, wedge, NULL), PH_EBOUND,
          "a limit that depends on a later variable");
  refused(ph_region(b, ONE, xyz, crossed, NULL), PH_EBOUND, "limits in the wrong order");
  refused(ph_region(b, ONE, xyz, powers, NULL), PH_EBOUND, "a limit 1/x");
  refused(ph_region(b, ONE, xyz, high, NULL), PH_EBOUND, "a limit x^200");
  refused(ph_region(b, ONE, xyz, lost, NULL), PH_EFINITE, "a limit of NaN");
  refused(ph_region(b, ONE, xyz, cube, &neg), PH_EMASS, "a density of -1");
  refused(ph_region(b, ONE, xyz, cube, &O), PH_EMASS, "a density of 0");

  ph_body box;
  ph_solid_box(&box, ONE, 1, 1, 1);
  refused(ph_body_affine(b, &box, ZERO), PH_EFLAT, "a map to a point");
  refused(ph_body_affine(b, &box, BAD), PH_EFINITE, "a map to NaN");
  const double sigma[] = {1, 1, -1e-9, 0, 0, 0};
  refused(ph_body_moments(b, 1, ZERO, sigma), PH_EPOSITIVE, "a second moment of -1e-9");
  refused(ph_body_moments(b, 0, ZERO, ZERO), PH_EMASS, "moments without mass");
  refused(ph_body_moments(b, 1, BAD, ZERO), PH_EFINITE, "moments nowhere");
}

static void tensors(void) {
  const double I[6] = {1, 1, 1, 0, 0, 0}, huge[6] = {1e300, 1e300, 1e300, 0, 0, 0};
  const double nearly[6] = {1e308, 1e308, 1e308, 1e308, 1e308, 1e308};
  ph_body box;
  ph_solid_box(&box, ONE, 1, 1, 1);
  refused(ph_tensor_about(&box, BAD, out.number), PH_EFINITE, "tensor about nowhere");
  refused(ph_tensor_about(&box, HUGE3, out.number), PH_ERANGE, "tensor about a point at 1e200 m");
  refused(ph_tensor_shift(BAD, 1, E1, E1, out.number), PH_EFINITE, "shift of NaN");
  refused(ph_tensor_shift(I, 1, E1, HUGE3, out.number), PH_ERANGE, "shift by 1e200 m");
  refused(ph_tensor_turn(I, ZERO, out.number), PH_EQUATERNION, "tensor turned by the quaternion 0");
  refused(ph_tensor_turn(BAD, ONE4, out.number), PH_EFINITE, "NaN turned");
  refused(ph_tensor_momentum(I, BAD, out.number), PH_EFINITE, "momentum of NaN");
  refused(ph_tensor_momentum(huge, HUGE3, out.number), PH_ERANGE, "momentum of 1e500");
  refused(ph_tensor_energy(BAD, E1, out.number), PH_EFINITE, "energy of NaN");
  refused(ph_tensor_energy(I, HUGE3, out.number), PH_ERANGE, "energy of 1e400");
  refused(ph_tensor_check(BAD), PH_EFINITE, "check of NaN");
  refused(ph_tensor_check((const double[]){-1, -1, -1, 0, 0, 0}), PH_EPOSITIVE, "check of -1");
  refused(ph_tensor_check((const double[]){1, 1, 3, 0, 0, 0}), PH_ETRIANGLE, "check of 1, 1, 3");
  ok(ph_tensor_check(ZERO) == PH_OK, "the tensor 0 of a particle is allowed");
  refused(ph_principal(BAD, &out.axes), PH_EFINITE, "axes of NaN");
  refused(ph_principal(nearly, &out.axes), PH_ERANGE, "a principal moment of 3e308");
  refused(ph_particles_tensor(0, E1, E1, out.number), PH_ECOUNT, "tensor of no particle");
  refused(ph_particles_tensor(1, E1, HUGE3, out.number), PH_ERANGE,
          "tensor of a particle at 1e200 m");
  refused(ph_particles_energy(1, ZERO, E1, E1, out.number), PH_EMASS,
          "energy of a particle without mass");
  refused(ph_particles_energy(1, E1, E1, BAD, out.number), PH_EFINITE, "energy at NaN rad/s");
  refused(ph_particles_energy(-1, E1, E1, E1, out.number), PH_ECOUNT, "energy of -1 particles");
  refused(ph_particles_momentum(1, E1, E1, BAD, out.number), PH_EFINITE, "momentum at NaN rad/s");
  refused(ph_particles_momentum(1, E1, HUGE3, E1, out.number), PH_ERANGE,
          "momentum of a particle at 1e200 m");
}

static void rotations(void) {
  ph_acceleration *a = &out.acceleration;
  refused(ph_quat_normalize(ZERO, out.number), PH_EQUATERNION, "0 normalised");
  refused(ph_quat_normalize(BAD, out.number), PH_EFINITE, "NaN normalised");
  refused(ph_quat_rotate(ZERO, E1, out.number), PH_EQUATERNION, "turned by 0");
  refused(ph_quat_rotate(ONE4, BAD, out.number), PH_EFINITE, "NaN turned");
  refused(ph_quat_unrotate(BAD, E1, out.number), PH_EFINITE, "turned back by NaN");
  refused(ph_quat_from_axis(ZERO, 1, out.number), PH_EDIRECTION, "a turn about no axis");
  refused(ph_quat_from_axis(E1, NOT_A_NUMBER, out.number), PH_EFINITE, "a turn by NaN");
  refused(ph_quat_to_matrix(ZERO, out.number), PH_EQUATERNION, "the matrix of 0");
  refused(ph_quat_from_matrix(ZERO, out.number), PH_EMATRIX, "the quaternion of the matrix 0");
  refused(ph_quat_from_matrix(BAD, out.number), PH_EFINITE, "the quaternion of NaN");
  refused(ph_quat_from_ypr(BAD, out.number), PH_EFINITE, "yaw NaN");
  refused(ph_quat_to_ypr(ZERO, out.number), PH_EQUATERNION, "angles of 0");
  refused(ph_quat_to_euler(ONE4, "xxz", out.number), PH_ESEQUENCE, "angles of xxz");
  refused(ph_quat_to_euler(ONE4, "zx", out.number), PH_ESEQUENCE, "angles of zx");
  refused(ph_quat_to_euler(ONE4, "zxzx", out.number), PH_ESEQUENCE, "angles of zxzx");
  refused(ph_quat_to_euler(ONE4, "ZXZ", out.number), PH_ESEQUENCE, "angles of ZXZ");
  refused(ph_quat_to_euler(ZERO, "zxz", out.number), PH_EQUATERNION, "Euler angles of 0");
  refused(ph_quat_from_euler(E1, "abc", out.number), PH_ESEQUENCE, "turned by abc");
  refused(ph_quat_from_euler(BAD, "zxz", out.number), PH_EFINITE, "turned by Euler angles NaN");
  refused(ph_quat_to_vector(ZERO, out.number), PH_EQUATERNION, "the rotation vector of 0");
  refused(ph_frame_rate_inertial(BAD, E1, E1, out.number), PH_EFINITE, "a frame that turns by NaN");
  refused(ph_frame_rate_inertial(HUGE3, (const double[]){1e200, 0, 0}, E1, out.number), PH_ERANGE,
          "1e200 m at 1e200 rad/s");
  refused(ph_frame_rate_body(E1, BAD, E1, out.number), PH_EFINITE, "a point at NaN");
  refused(ph_frame_acceleration(E1, E1, E1, E1, BAD, a), PH_EFINITE, "an acceleration of NaN");
  refused(ph_frame_acceleration(HUGE3, E1, E1, E1, E1, a), PH_ERANGE,
          "a centrifugal term of 1e400");
}

static void tops(void) {
  const double I[6] = {1, 2, 2.5, 0, 0, 0}, x[7] = {1, 0, 0, 0, 1, 2, 3},
               fast[7] = {1, 0, 0, 0, 1e200, 1e200, 1e200};
  ph_body box;
  ph_top top;
  ph_solid_box(&box, ONE, 1, 1, 1);
  refused(ph_top_init(&out.top, &box, BAD), PH_EFINITE, "a top about nowhere");
  refused(ph_top_init(&out.top, &box, HUGE3), PH_ERANGE, "a top about a point at 1e200 m");
  box.mass = 0;
  refused(ph_top_init(&out.top, &box, NULL), PH_EMASS, "a top without mass");
  refused(ph_top_init_tensor(&out.top, 1, NULL, (const double[]){1, 1, 3, 0, 0, 0}), PH_ETRIANGLE,
          "a top with moments 1, 1, 3");
  refused(ph_top_init_tensor(&out.top, 1, HUGE3, I), PH_EPOSITIVE,
          "a top whose centre is farther than its tensor allows");
  ph_top_init_tensor(&top, 1, NULL, I);
  out.top = pattern.top = top;
  refused(ph_top_gravity(&out.top, 9.8, ZERO), PH_EDIRECTION, "gravity without direction");
  out.top = pattern.top = top;
  refused(ph_top_gravity(&out.top, NOT_A_NUMBER, E1), PH_EFINITE, "NaN gravity");
  refused(ph_top_damping(&out.top, BAD), PH_EFINITE, "NaN damping");
  refused(ph_top_decay(&out.top, ENDLESS), PH_EFINITE, "infinite decay");
  refused(ph_top_torque_body(&out.top, BAD), PH_EFINITE, "NaN torque");
  refused(ph_top_rotor(&out.top, BAD), PH_EFINITE, "NaN rotor");
  refused(ph_top_torque_inertial(&out.top, BAD), PH_EFINITE, "NaN inertial torque");
  refused(ph_top_torque(&top, 0, BAD, NULL, out.number), PH_EFINITE, "torque at NaN");
  refused(ph_top_rates(&top, 0, BAD, NULL, out.number), PH_EFINITE, "rates at NaN");
  refused(ph_top_rates(&top, 0, fast, NULL, out.number), PH_ERANGE, "rates at 1e200 rad/s");
  refused(ph_top_inverse(&top, E1, BAD, out.number), PH_EFINITE, "the torque for NaN");
  refused(ph_top_inverse(&top, HUGE3, E1, out.number), PH_ERANGE, "the torque for 1e200 rad/s");
  refused(ph_top_kinetic(&top, fast, out.number), PH_ERANGE, "T at 1e200 rad/s");
  refused(ph_top_kinetic(&top, BAD, out.number), PH_EFINITE, "T at NaN");
  refused(ph_top_potential(&top, BAD, out.number), PH_EFINITE, "V at NaN");
  refused(ph_top_energy(&top, BAD, out.number), PH_EFINITE, "E at NaN");
  refused(ph_top_momentum(&top, BAD, out.number), PH_EFINITE, "L at NaN");
  refused(ph_top_momentum_body(&top, BAD, out.number), PH_EFINITE, "L at NaN, body axes");
  ok(ph_top_rates(&top, 0, x, BAD, out.number) == PH_OK, "control that is off is not looked at");
  ph_top_control(&top);
  fresh();
  refused(ph_top_rates(&top, 0, x, BAD, out.number), PH_EFINITE, "NaN control that is on");
  ok(ph_top_rates(&top, 0, x, NULL, out.number) == PH_OK, "control that is on may be NULL");
  fresh();
  refused(ph_euler_rates(ZERO, E1, NULL, out.number), PH_EPOSITIVE,
          "Euler's equations without moments");
  refused(ph_euler_rates((const double[]){1, 2, 2}, BAD, NULL, out.number), PH_EFINITE,
          "Euler's equations at NaN");
  refused(ph_symmetric_top(0, 1, E1, &out.symmetric), PH_EPOSITIVE, "a symmetric top with I1 = 0");
  refused(ph_symmetric_top(1, 1, BAD, &out.symmetric), PH_EFINITE, "a symmetric top at NaN");
  refused(ph_symmetric_top(1, 1, HUGE3, &out.symmetric), PH_ERANGE,
          "a symmetric top at 1e200 rad/s");
  refused(ph_symmetric_at(1, -1, x, 1, out.number), PH_EPOSITIVE, "the closed form with I3 < 0");
  refused(ph_symmetric_at(1, 1, x, NOT_A_NUMBER, out.number), PH_EFINITE,
          "the closed form at NaN s");
  refused(ph_symmetric_at(1, 1, (const double[]){0, 0, 0, 0, 1, 1, 1}, 1, out.number),
          PH_EQUATERNION, "the closed form from no attitude");
  refused(ph_top_stability(ZERO, 0, 1, &out.stability), PH_EPOSITIVE, "stability without moments");
  refused(ph_top_stability((const double[]){1, 1, 1}, 3, 1, &out.stability), PH_ECOUNT,
          "stability about axis 3 of 0, 1, 2");
  refused(ph_top_stability((const double[]){1, 1, 1}, 0, NOT_A_NUMBER, &out.stability), PH_EFINITE,
          "stability at NaN");
}

static void planes(void) {
  const double I[6] = {1, 1, 2, 0, 0, 0}, flat[9] = {1, 0, 0, 0, 1, 2, 3, 0, 0};
  const ph_plane disc = {.law = PH_ROLLING,
                         .placed = 1,
                         .half_axes = {1, 1, 0},
                         .axes = {1, 0, 0, 0},
                         .normal = {0, 0, 1},
                         .e1 = {1, 0, 0},
                         .gravity = {0, 0, -9.8}};
  ph_plane p = disc;
  ph_top top, away;
  ph_top_init_tensor(&top, 1, NULL, I);
  ph_top_init_tensor(&away, 1, (const double[]){0, 0, 0.5}, (const double[]){2, 2, 2, 0, 0, 0});
#define PLANE(of, field, value, status, what)                                                      \
  do {                                                                                             \
    p = disc;                                                                                      \
    p.field = value;                                                                               \
    out.top = pattern.top = of;                                                                    \
    refused(ph_top_plane(&out.top, &p), status, what);                                             \
  } while (0)
  PLANE(top, law, 4, PH_EBOUND, "a fifth law of contact");
  PLANE(away, placed, 1, PH_EBOUND, "a top about a point beside its centre on a plane");
  PLANE(top, half_axes[0], -1, PH_ELENGTH, "a half axis of -1 m");
  PLANE(top, rim, -1, PH_ELENGTH, "a rim of -1 m");
  PLANE(top, rim, ENDLESS, PH_EFINITE, "an infinite rim");
  PLANE(top, axes[0], 0, PH_EQUATERNION, "a surface turned by the quaternion 0");
  PLANE(top, normal[2], 0, PH_EDIRECTION, "a plane without normal");
  PLANE(top, normal[0], 1e300, PH_EDIRECTION, "e1 along the normal");
  PLANE(top, e1[0], 0, PH_EDIRECTION, "a plane without e1");
  PLANE(top, friction, -1, PH_EPOSITIVE, "friction of -1");
  PLANE(top, law, PH_COULOMB, PH_EPOSITIVE, "dry friction without smoothing");
#undef PLANE
  ok(ph_top_plane(&top, &disc) == PH_OK, "a disc on a plane");
  out.top = pattern.top = top;
  refused(ph_top_plane(&out.top, &disc), PH_EMETHOD, "a second plane");
  ph_contact contact, before;
  memset(&contact, 0x5a, sizeof contact);
  before = contact;
  refused(ph_top_rates(&top, 0, flat, NULL, out.number), PH_ECONTACT, "rates of a disc lying flat");
  refused(ph_top_contact(&top, 0, flat, NULL, &contact), PH_ECONTACT, "its contact");
  ok(memcmp(&contact, &before, sizeof contact) == 0, "which is not written");
  ph_top_init_tensor(&away, 1, NULL, I);
  refused(ph_top_contact(&away, 0, flat, NULL, &contact), PH_EMETHOD, "the contact of no plane");
  double air[13] = {1, 0, 0, 0, 1, 1, 1, 0, 0, 3, 0, 0, -1};
  ph_gap gap;
  refused(ph_top_gap(&away, air, &gap), PH_EMETHOD, "the gap above no plane");
  refused(ph_top_gap(&top, air, &gap), PH_ECONTACT, "the gap below a disc that lies flat");
  refused(ph_top_impact(&top, &(ph_impact){1.1, 0, 0}, air, out.number), PH_EPOSITIVE,
          "restitution 1.1");
  refused(ph_top_impact(&top, &(ph_impact){1, 0, -2}, air, out.number), PH_EPOSITIVE,
          "tangential -2");
  air[0] = 0;
  refused(ph_top_gap(&top, air, &gap), PH_EQUATERNION, "the gap of the quaternion 0");
  air[3] = NOT_A_NUMBER;
  refused(ph_top_gap(&top, air, &gap), PH_EFINITE, "the gap of the quaternion NaN");
}

static void runs(void) {
  const double I[6] = {1, 2, 2.5, 0, 0, 0}, x[7] = {1, 0, 0, 0, 1, 2, 3};
  const ph_options good = ph_options_default();
  ph_options o = good;
  ph_top top, rod;
  ph_run *run = NULL;
  ph_body b;
  ph_top_init_tensor(&top, 1, NULL, I);
  refused(ph_run_new(&out.run, &top, &good, NOT_A_NUMBER, x), PH_EFINITE, "a run from t = NaN");
  refused(ph_run_new(&out.run, &top, &good, 0, BAD), PH_EFINITE, "a run from NaN");
  refused(ph_run_new(&out.run, &top, &good, 0, ZERO), PH_EQUATERNION, "a run from no attitude");
  o.method = (ph_method)17;
  refused(ph_run_new(&out.run, &top, &o, 0, x), PH_EMETHOD, "method 17");
  o.method = PH_RK4;
  refused(ph_run_new(&out.run, &top, &o, 0, x), PH_EMETHOD, "the classical method without a step");
  o = good, o.step = -1;
  refused(ph_run_new(&out.run, &top, &o, 0, x), PH_ESTEP, "a negative step");
  o = good, o.step = NOT_A_NUMBER;
  refused(ph_run_new(&out.run, &top, &o, 0, x), PH_EFINITE, "a NaN step");
  o = good, o.tolerance = 1;
  refused(ph_run_new(&out.run, &top, &o, 0, x), PH_ETOLERANCE, "a tolerance of 1");
  o = good, o.tolerance = 0;
  refused(ph_run_new(&out.run, &top, &o, 0, x), PH_ETOLERANCE, "a tolerance of 0");
  o = good, o.order = 41;
  refused(ph_run_new(&out.run, &top, &o, 0, x), PH_ETOLERANCE, "a Taylor series of order 41");
  o = good, o.max_steps = 0;
  refused(ph_run_new(&out.run, &top, &o, 0, x), PH_ESTEPS, "a run without steps");
  /* failures on the way leave the run where it is */
  o = good, o.max_steps = 3;
  ph_run_new(&run, &top, &o, 0, x);
  refused(ph_run_to(run, 1e6, NULL, out.number), PH_ESTEPS, "1e6 s in three steps, adaptive");
  ok(ph_run_time(run) == 0 && ph_run_to(run, 0.01, NULL, out.number) == PH_OK,
     "the run is where it was, and goes on");
  fresh();
  refused(ph_run_to(run, NOT_A_NUMBER, NULL, out.number), PH_EFINITE, "a run to NaN");
  ph_run_free(run);
  o.step = 0.001, o.method = PH_RK4;
  ph_run_new(&run, &top, &o, 0, x);
  refused(ph_run_to(run, 1, NULL, out.number), PH_ESTEPS, "1000 steps where three are allowed");
  ph_run_free(run);
  /* negative damping: w grows as exp(t) and leaves the range of double near t = 709 */
  for (int k = 0; k < 3; k++) {
    static const ph_method method[3] = {PH_TAYLOR, PH_RK8PD, PH_RK4};
    o = (ph_options){
        .method = method[k], .tolerance = 1e-6, .step = k == 2 ? 0.25 : 0, .max_steps = 100000};
    ph_top growing;
    ph_top_init_tensor(&growing, 1, NULL, (const double[]){1, 1, 1, 0, 0, 0});
    ph_top_damping(&growing, (const double[]){-400, 0, 0, 0, 0, 0, 0, 0, 0});
    ph_run_new(&run, &growing, &o, 0, (const double[]){1, 0, 0, 0, 1, 0, 0});
    const int s = ph_run_to(run, 100, NULL, out.number);
    ok((s == PH_ERANGE || s == PH_ESTEPS || s == PH_ESTEP) &&
           memcmp(&out, &pattern, sizeof out) == 0,
       "unbounded growth ends with a status (%s)", ph_status_phrase(s));
    seen[s]++;
    ph_run_free(run);
  }
  /* so far from t = 0 that a step does not move time */
  o = (ph_options){.method = PH_RKF45, .tolerance = 1e-10, .max_steps = 100000};
  ph_run_new(&run, &top, &o, 1e25, x);
  refused(ph_run_to(run, 2e25, NULL, out.number), PH_ESTEP, "steps of 1e-3 s at t = 1e25 s");
  ph_run_free(run);
  /* a rod with a torque along itself, in every method */
  ph_rod_straight(&b, ONE, 1);
  ph_top_init(&rod, &b, NULL);
  ph_top_torque_body(&rod, (const double[]){0, 0, 1});
  for (int method = PH_RK4; method <= PH_TAYLOR; method++) {
    o = (ph_options){.method = (ph_method)method, .step = 0.1, .max_steps = 100};
    ph_run_new(&run, &rod, &o, 0, x);
    refused(ph_run_to(run, 1, NULL, out.number), PH_EROD, "torque along a rod");
    ph_run_free(run);
  }
  o = (ph_options){.method = PH_RK8PD, .tolerance = 1e-6, .max_steps = 100};
  ph_run_new(&run, &rod, &o, 0, x);
  refused(ph_run_to(run, 1, NULL, out.number), PH_EROD, "torque along a rod, adaptive");
  ph_run_free(run);
  ph_run_free(NULL);
}

/* Tensors that no body has: taken by ph_body_formal alone, and so is what is made of them. */
static void tensors_formal(void) {
  ph_body b, c;
  ph_top top;
  const double I[6] = {3, 5, 9, 0, 0, 0}, com[3] = {1, 2, 3}, q[4] = {1, 2, 3, 4};
  ok(ph_body_tensor(&b, 2, com, I) == PH_ETRIANGLE, "(3, 5, 9) is no body's tensor");
  ok(ph_body_formal(&b, 2, com, I) == PH_OK && ph_body_check(&b) == PH_OK, "and a formal one");
  ok(memcmp(b.tensor, I, sizeof I) == 0, "which comes back unchanged");
  int s = ph_body_at(&c, &b, com) || ph_body_turned(&c, &c, q) ||
          ph_body_scaled(&c, &c, (const double[]){2, 2, 2});
  ok(s == 0 && ph_body_check(&c) == PH_OK, "also moved, turned and scaled");
  ok(ph_top_init(&top, &c, com) == PH_OK, "a top is made of it");
  s = ph_body_add(&c, &b, &b);
  ok(s == 0 && ph_body_check(&c) == PH_OK && c.tensor[2] == 18, "two of them are added");
  ok(ph_body_formal(&b, 2, com, (const double[]){3, 0, 9, 0, 0, 0}) == PH_EPOSITIVE &&
         ph_body_formal(&b, 2, com, (const double[]){1, 1, 9, 2, 0, 0}) == PH_EPOSITIVE,
     "a moment that is zero or negative is refused");
  ok(ph_body_formal(&b, 0, com, I) == PH_EMASS &&
         ph_body_formal(&b, NOT_A_NUMBER, com, I) == PH_EFINITE,
     "so are mass 0 and what is no number");
  s = ph_body_tensor(&b, 2, com, (const double[]){1, 1, 1, 0, 0, 0});
  ok(s == 0 && !b.formal, "other bodies are not formal");
}

int main(void) {
  fresh();
  bodies();
  shapes();
  tensors();
  tensors_formal();
  rotations();
  tops();
  planes();
  runs();
  int all = 1;
  for (int s = PH_OK + 1; s < PH_EMEMORY; s++)
    if (!seen[s]) {
      diag("never seen: %s", ph_status_phrase(s));
      all = 0;
    }
  ok(all, "every status but `out of memory' has occurred");
  ok(strcmp(ph_status_phrase(-1), ph_status_phrase(PH_ECHATTER + 1)) == 0,
     "an unknown status has a phrase too");
  ok(strcmp(ph_version(), PH_VERSION) == 0, "header and library have one version");
  return tap_done();
}
