/* polhode.h - the public interface of libpolhode, the general rigid-body library.
   SPDX-License-Identifier: GPL-3.0-or-later

   Mass properties, principal axes, frames, the equations of motion with every effect behind
   a run-time switch, and integration. It is the reference road: it knows nothing of the
   generated code and takes the general formula (second moments, matrix algebra, factorised
   linear systems) where a special case would be shorter.

   Conventions. SI units. Vectors are double[3]. A tensor is double[6] in the order xx yy zz xy
   xz yz, where xy, xz, yz are tensor ENTRIES (minus the products of inertia). A quaternion is
   double[4], scalar first (w, x, y, z), Hamilton product, body to inertial:
   v_inertial = q v_body q*. Angular velocity w and torque are in body axes; the state of motion is
   x = (qw qx qy qz wx wy wz), and rx ry rz vx vy vz where the top moves (polhode_move.h).
   Failure. Every function that can fail returns a status, PH_OK = 0, and leaves its outputs
   untouched otherwise. Nothing prints, exits, or keeps state outside its arguments, so distinct
   objects may be used from distinct threads. Pointers must not be NULL unless it is said.
   Overlap. An output may be the same array as an input of the same type, unless it is said.
   Precision. Inside, sums are formed in long double, which must have 64 bits or more (x86-64,
   AArch64, RISC-V 64; not MSVC), and are rounded once at the end. */
#ifndef POLHODE_H
#define POLHODE_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

#define PH_VERSION "0.1.0"

/* ---- status ---- */

enum ph_status {
  PH_OK = 0,
  PH_EFINITE,     /* a number is NaN or infinite */
  PH_ERANGE,      /* a result exceeds the range of double */
  PH_EMASS,       /* a mass or density is not positive */
  PH_ELENGTH,     /* a length, radius or scale factor is not positive */
  PH_EORDER,      /* an inner size is not smaller than the outer one */
  PH_ECOUNT,      /* a count is wrong: no particles, wrong number of arguments */
  PH_ENAME,       /* no shape of that name */
  PH_EHOLE,       /* what is subtracted is more than what is there */
  PH_EFLAT,       /* points, edges or a matrix span no area or volume */
  PH_ECROSS,      /* an outline crosses or touches itself */
  PH_EBOUND,      /* a height, angle, coordinate or limit beyond what the shape allows */
  PH_EPOSITIVE,   /* a moment of inertia is negative */
  PH_ETRIANGLE,   /* a principal moment exceeds the sum of the other two */
  PH_EDIRECTION,  /* a direction or axis has zero length */
  PH_EQUATERNION, /* a quaternion is zero */
  PH_EMATRIX,     /* a matrix is not a rotation */
  PH_ESEQUENCE,   /* not one of the twelve sequences of Euler angles */
  PH_ECONTACT,    /* a plane is touched in more than one point */
  PH_EROD,        /* torque about an axis without moment of inertia */
  PH_EMETHOD,     /* unknown method, or one that cannot do what is asked */
  PH_ESTEP,       /* step negative, or so small that time stands still */
  PH_ETOLERANCE,  /* tolerance or order outside its bounds */
  PH_ESTEPS,      /* more steps than allowed */
  PH_EMEMORY,     /* out of memory */
  PH_EFILE,       /* a file cannot be opened or read */
  PH_EFORMAT,     /* a file is malformed or cut off */
  PH_EOPEN,       /* the volume of a mesh that does not close */
  PH_EEMPTY,      /* a mesh without volume, area or length */
  PH_ECHATTER     /* equations that jump drive the state back to the jump from both sides */
};

/* A phrase for a status, never NULL, never to be freed. */
const char *ph_status_phrase(int status);
/* PH_VERSION of the library that is linked. */
const char *ph_version(void);

/* ---- bodies: mass, centre, second moments ---- */

/* A rigid body's mass properties in its own axes. com + com_tail is the centre of mass: the tail
   holds what the double does not, so that parts far from the origin keep their small distances.
   second is integral rho s s^T dV with s = r - com (the 3x3 block of the pseudo-inertia, kg m2),
   tensor is tr(second) 1 - second, the inertia tensor about com. Both are kept because second ->
   tensor only adds, tensor -> second cancels: a tensor given by the user comes back unchanged. */
typedef struct ph_body {
  double mass, com[3], com_tail[3], second[6], tensor[6];
  int formal; /* the tensor is of ph_body_formal */
} ph_body;

/* How much matter a shape has: its mass, or its density per volume, area or length. */
typedef struct ph_amount {
  int by_density;
  double value;
} ph_amount;

ph_amount ph_amount_mass(double mass);
ph_amount ph_amount_density(double density);

/* Shapes of given sizes; lengths, radii, angles (rad) must be positive. Frames: "centred" has the
   centroid at the origin, "based" the base in z = 0 and the body on z >= 0, both with axis z. Mass,
   centre and tensor are right to 4 ulp of the largest entry, also for needles, plates, thin walls
   and slivers. PH_EMASS, PH_ELENGTH, PH_EORDER, PH_EBOUND, PH_EFINITE, PH_ERANGE. */
int ph_solid_box(ph_body *b, ph_amount a, double x, double y, double z); /* centred */
int ph_solid_sphere(ph_body *b, ph_amount a, double r);                  /* centred */
int ph_solid_ellipsoid(ph_body *b, ph_amount a, double ax, double by,
                       double cz);                                  /* centred, semi-axes */
int ph_solid_cylinder(ph_body *b, ph_amount a, double r, double h); /* centred, axis z */
int ph_solid_elliptic_cylinder(ph_body *b, ph_amount a, double ax, double by, double h);
int ph_solid_tube(ph_body *b, ph_amount a, double r_in, double r_out,
                  double h);                                    /* centred, axis z */
int ph_solid_cone(ph_body *b, ph_amount a, double r, double h); /* based, apex at z = h */
int ph_solid_elliptic_cone(ph_body *b, ph_amount a, double ax, double by, double h);  /* so */
int ph_solid_frustum(ph_body *b, ph_amount a, double r_base, double r_top, double h); /* based */
int ph_solid_capsule(ph_body *b, ph_amount a, double r, double h); /* centred; h: cylinder */
int ph_solid_hemisphere(ph_body *b, ph_amount a, double r);        /* based */
/* Of a ball of radius r: the cap of height h <= 2r, based; what lies between the planes z1 < z2,
   from -r to r, the ball's centre at the origin; the cone of rays from the centre to a cap of
   height h <= 2r about +z. */
int ph_solid_cap(ph_body *b, ph_amount a, double r, double h);
int ph_solid_zone(ph_body *b, ph_amount a, double r, double z1, double z2);
int ph_solid_sector(ph_body *b, ph_amount a, double r, double h);
/* Of a cylinder about z: the half x >= 0 and the quarter x, y >= 0, both |z| <= h/2; the part
   0 <= z <= h x/r. */
int ph_solid_half_cylinder(ph_body *b, ph_amount a, double r, double h);
int ph_solid_quarter_cylinder(ph_body *b, ph_amount a, double r, double h);
int ph_solid_hoof(ph_body *b, ph_amount a, double r, double h);
int ph_solid_torus(ph_body *b, ph_amount a, double R, double r); /* centred; r <= R */
int ph_solid_hollow_sphere(ph_body *b, ph_amount a, double r_in, double r_out); /* centred */
int ph_solid_paraboloid(ph_body *b, ph_amount a, double r,
                        double h); /* vertex at the origin, radius r at z = h */
int ph_solid_pyramid(ph_body *b, ph_amount a, double x, double y, double h); /* based */
/* Prism on the triangle (0, 0), (x, 0), (0, y), 0 <= z <= z. */
int ph_solid_wedge(ph_body *b, ph_amount a, double x, double y, double z);
int ph_solid_bicylinder(ph_body *b, ph_amount a, double r); /* cylinders about x and y, centred */
/* The regular polyhedron of 4, 6, 8, 12 or 20 faces (else PH_ECOUNT), centred. */
int ph_solid_regular(ph_body *b, ph_amount a, int faces, double edge);

/* Shells; the density is per area. The hemisphere is open and based; the zone as solid_zone; the
   cylinder's ends are closed by discs if `ends`; the cone is the side alone, based, apex z = h. */
int ph_shell_sphere(ph_body *b, ph_amount a, double r);
int ph_shell_hemisphere(ph_body *b, ph_amount a, double r);
int ph_shell_zone(ph_body *b, ph_amount a, double r, double z1, double z2);
int ph_shell_ellipsoid(ph_body *b, ph_amount a, double ax, double by, double cz);
int ph_shell_cylinder(ph_body *b, ph_amount a, double r, double h, int ends);
int ph_shell_cone(ph_body *b, ph_amount a, double r, double h);
int ph_shell_torus(ph_body *b, ph_amount a, double R, double r); /* r <= R */
int ph_shell_box(ph_body *b, ph_amount a, double x, double y, double z);

int ph_plate_disc(ph_body *b, ph_amount a, double r); /* centred, in z = 0 */
int ph_plate_annulus(ph_body *b, ph_amount a, double r_in, double r_out);
int ph_plate_ellipse(ph_body *b, ph_amount a, double ax, double by);
int ph_plate_rectangle(ph_body *b, ph_amount a, double x, double y);
/* Sector of a disc and arc of a circle from the x axis to angle <= 2 pi, centre at the origin. */
int ph_plate_sector(ph_body *b, ph_amount a, double r, double angle);
int ph_wire_arc(ph_body *b, ph_amount a, double r, double angle);

int ph_rod_straight(ph_body *b, ph_amount a, double length); /* centred, along z */
int ph_rod_between(ph_body *b, ph_amount a, const double from[3], const double to[3]);
int ph_wire_hoop(ph_body *b, ph_amount a, double r); /* centred, in z = 0 */
/* (r cos t, r sin t, pitch t/2pi), 0 <= t <= 2 pi turns; turns > 0, pitch of any sign. */
int ph_wire_helix(ph_body *b, ph_amount a, double r, double pitch, double turns);
/* (x, a cosh(x/a), 0), |x| <= span/2. */
int ph_wire_catenary(ph_body *b, ph_amount a, double scale, double span);

/* The same by name ("solid.box", "rod.between", ...; arguments in the order above, points as three
   numbers each, ends 0 or 1): PH_ENAME for an unknown name, PH_ECOUNT for a wrong number of
   arguments. */
int ph_shape_make(ph_body *b, const char *name, ph_amount a, const double arg[], int count);
/* The i-th name of that catalogue, and the names of its arguments with blanks between; NULL past
 * the end. */
const char *ph_shape_name(int i);
const char *ph_shape_arguments(int i);

/* Shapes of points. Vertices and edges are rows of three numbers. PH_EFLAT if they span no area or
   volume; the polyline (n >= 2, of rods, closed: back to the first point) only needs a length. */
int ph_solid_tetrahedron(ph_body *b, ph_amount a, const double vertex[12]);
int ph_solid_parallelepiped(ph_body *b, ph_amount a, const double edge[9]); /* from the origin */
int ph_plate_triangle(ph_body *b, ph_amount a, const double vertex[9]);
int ph_wire_polyline(ph_body *b, ph_amount a, int n, const double point[], int closed);

/* Shapes of plane outlines: n >= 1 polygons, outline 0 with the others as holes in it, count[i]
   points each, all coordinates in one list of pairs. Either orientation. Prism and extrude: x, y
   with 0 <= z <= h; revolve: x, z with x >= 0 (PH_EBOUND), a full turn about z. PH_ECOUNT: less
   than three points; PH_EFLAT; PH_ECROSS: an outline that crosses, touches or repeats itself;
   PH_EHOLE: a hole that is not within outline 0 and clear of it and of the other holes. */
int ph_plate_polygon(ph_body *b, ph_amount a, int n, const int count[], const double point[]);
int ph_solid_prism(ph_body *b, ph_amount a, int n, const double point[], double h); /* n points */
int ph_extrude(ph_body *b, ph_amount a, int n, const int count[], const double point[], double h);
int ph_revolve(ph_body *b, ph_amount a, int n, const int count[], const double point[]);

/* A polynomial in x, y, z: the sum of coefficient x^power[0] y^power[1] z^power[2]; no terms: 0. */
typedef struct ph_term {
  double coefficient;
  int power[3];
} ph_term;
typedef struct ph_polynomial {
  int count;
  const ph_term *term;
} ph_polynomial;

/* The region limit[0] <= u <= limit[1], limit[2] <= v <= limit[3], limit[4] <= w <= limit[5], where
   order = {0, 1, 2} or another permutation says which of x, y, z are u, v, w; limits may depend on
   the variables before. Density (NULL: uniform) is multiplied by a.value, or scaled to the mass
   a.value. Exact up to rounding, by Gauss's rule. PH_EBOUND: order, a limit of a wrong variable,
   limits that cross (where the rule looks), a negative power, or a degree that needs more than 256
   points a line; PH_EMASS: density negative at a point of the rule, or no mass. */
int ph_region(ph_body *b, ph_amount a, const int order[3], const ph_polynomial limit[6],
              const ph_polynomial *density);

/* n particles: masses m[i] > 0 at (r[3i], r[3i+1], r[3i+2]); sums are relative to the first. */
int ph_body_points(ph_body *b, int n, const double m[], const double r[]);
/* A body by its tensor about its centre of mass, or about the origin of coordinates, where second
   moments about com that its rounding makes negative are taken as zero; both are checked as
   ph_body_check does. formal: any positive definite one about the centre, also of no body. */
int ph_body_tensor(ph_body *b, double mass, const double com[3], const double tensor[6]);
int ph_body_tensor_origin(ph_body *b, double mass, const double com[3], const double tensor[6]);
int ph_body_formal(ph_body *b, double mass, const double com[3], const double tensor[6]);
/* A body by its second moments per unit mass about its centre of mass (xx yy zz xy xz yz, m2), as a
   mesh has them: PH_EPOSITIVE if one about some axis is negative by more than rounding. */
int ph_body_moments(ph_body *b, double mass, const double com[3], const double sigma[6]);

/* Placement; out may be in. at: shift by d. turned: rotate about the origin by q (any length but
   0). scaled: r -> diag(k) r with the MASS kept, k not 0; a negative factor mirrors. */
int ph_body_at(ph_body *out, const ph_body *in, const double d[3]);
int ph_body_turned(ph_body *out, const ph_body *in, const double q[4]);
int ph_body_scaled(ph_body *out, const ph_body *in, const double k[3]);
/* r -> A r (row major) with the mass kept, a shear for instance: PH_EFLAT if det A = 0. */
int ph_body_affine(ph_body *out, const ph_body *in, const double A[9]);
/* Union of bodies that do not overlap, and what is left when a hole (a part of a) is taken out.
   PH_EHOLE if mass or a second moment would become negative. */
int ph_body_add(ph_body *out, const ph_body *a, const ph_body *b);
int ph_body_subtract(ph_body *out, const ph_body *a, const ph_body *hole);

/* Is this a body that can exist? PH_EFINITE; PH_EMASS: mass > 0; PH_EPOSITIVE: principal moments >=
   0; PH_ETRIANGLE: I3 <= I1 + I2, both up to 8 units of rounding of the largest (formal: > 0). */
int ph_body_check(const ph_body *b);

#include "polhode_mesh.h" /* bodies from mesh files */

/* ---- inertia tensors ---- */

/* Tensor about a point p given in the body's coordinates: I = I_com + M (d^2 1 - d d^T), d = com -
 * p. */
int ph_tensor_about(const ph_body *b, const double p[3], double tensor[6]);
/* Tensor about another origin by the general formula; a is the new origin and R the centre of mass,
   both seen from the OLD origin: I'_ij = I_ij + M(a^2 d_ij - a_i a_j) - M(2 a.R d_ij - a_i R_j -
   a_j R_i). */
int ph_tensor_shift(const double tensor[6], double mass, const double R[3], const double a[3],
                    double out[6]);
/* Components in axes turned by q: A I A^T, where A is the matrix of v -> q v q* (any length of q
 * but 0). */
int ph_tensor_turn(const double tensor[6], const double q[4], double out[6]);
/* L = I w and T = w.I.w / 2. */
int ph_tensor_momentum(const double tensor[6], const double w[3], double L[3]);
int ph_tensor_energy(const double tensor[6], const double w[3], double *T);
/* PH_OK, PH_EFINITE, PH_EPOSITIVE or PH_ETRIANGLE, as in ph_body_check. */
int ph_tensor_check(const double tensor[6]);

/* Particles (as in ph_body_points) fixed in a body that turns about the origin with w: v = w x r.
   The sums of the definition: I = sum m (r^2 1 - r r^T), T = sum m v^2 / 2, L = sum m r x v.
   PH_ECOUNT, PH_EMASS, PH_EFINITE, PH_ERANGE. */
int ph_particles_tensor(int n, const double m[], const double r[], double tensor[6]);
int ph_particles_energy(int n, const double m[], const double r[], const double w[3], double *T);
int ph_particles_momentum(int n, const double m[], const double r[], const double w[3],
                          double L[3]);

/* ---- principal axes ---- */

/* Moments ascending; axis[k] is the unit vector of moment k in the tensor's axes; axis[0], axis[1],
   axis[2] are right-handed and orthonormal to 4e-16. In axis[0] and axis[1] the first component
   within 1/16 of the largest is positive. Equal moments: coordinate axes if it is diagonal. */
typedef struct ph_axes {
  double moment[3], axis[3][3];
} ph_axes;

/* Of any symmetric matrix, by Jacobi's method: moments to an ulp of the largest, and for a positive
   definite graded tensor each to an ulp of itself times the condition of the tensor scaled to unit
   diagonal (Demmel and Veselic 1992, which QR does not give). PH_EFINITE, PH_ERANGE. */
int ph_principal(const double tensor[6], ph_axes *out);

#include "polhode_attitude.h" /* quaternions, matrices, angles */

/* ---- frames ---- */

/* Transport theorem, all vectors in the same axes: (dr/dt)_inertial = (dr/dt)_body + w x r, and
 * back. */
int ph_frame_rate_inertial(const double w[3], const double r[3], const double body_rate[3],
                           double inertial_rate[3]);
int ph_frame_rate_body(const double w[3], const double r[3], const double inertial_rate[3],
                       double body_rate[3]);

/* Second derivative in the inertial frame, its four terms apart and their sum:
   relative r'' + Coriolis 2 w x r' + Euler w' x r + centripetal w x (w x r), ' in the body frame.
   A term's negative is a force per mass of the turning frame: Coriolis, Euler, centrifugal. */
typedef struct ph_acceleration {
  double relative[3], coriolis[3], euler[3], centripetal[3], total[3];
} ph_acceleration;
int ph_frame_acceleration(const double w[3], const double w_rate[3], const double r[3],
                          const double r_rate[3], const double r_rate2[3], ph_acceleration *out);

/* ---- the rigid body that turns about a fixed origin, or about its centre and moves ---- */

#include "polhode_move.h" /* PH_TRANSLATION and further effects; lengths of states */

enum ph_effect {
  PH_GRAVITY = 1,          /* com x (M g d), d inertial */
  PH_DAMPING = 2,          /* -C w */
  PH_DECAY = 4,            /* -rate L */
  PH_TORQUE_BODY = 8,      /* constant in body axes */
  PH_TORQUE_INERTIAL = 16, /* constant in inertial axes */
  PH_CONTROL = 32,         /* input u, body axes */
  PH_ROTOR = 1024          /* -w x h: a rotor of constant relative momentum h, body axes */
};

/* The model; constant while it is used. Read the first part, change it only by the functions below.
   A moment that the data do not tell from zero (a rod's own axis) is zero, see ph_top_rates. */
typedef struct ph_top {
  double mass, com[3];                       /* centre of mass from the origin, body axes */
  double inertia[6];                         /* about the origin, body axes */
  unsigned effects;                          /* PH_GRAVITY | ... */
  double gravity[3];                         /* g d, m/s2, inertial axes */
  double damping[9];                         /* C, N m s, row major, body axes */
  double decay, rotor[3];                    /* 1/s; N m s, body axes */
  double torque_body[3], torque_inertial[3]; /* N m */
  ph_move move;                              /* translation and frame, polhode_move.h */
  ph_acts acts;                              /* polhode_acts.h */
  /* prepared, private: the tensor and its principal system in full precision */
  long double wide_com[3], wide_inertia[6], wide_second[6], wide_moment[3], wide_axis[3][3];
  const signed char *branch; /* private: NULL, or the signs that a step of a run holds to */
} ph_top;

/* The free top of body b about the point origin (NULL: its centre of mass). Checks b. */
int ph_top_init(ph_top *top, const ph_body *b, const double origin[3]);
/* The same from mass, centre of mass from the origin (NULL: 0), and tensor about the origin. */
int ph_top_init_tensor(ph_top *top, double mass, const double com[3], const double tensor[6]);

/* Each call sets an effect's parameters and switches it on; ph_top_without switches some off. */
int ph_top_gravity(ph_top *top, double g,
                   const double direction[3]); /* direction: inertial, any length but 0 */
int ph_top_damping(ph_top *top, const double C[9]);
int ph_top_decay(ph_top *top, double rate);
int ph_top_torque_body(ph_top *top, const double torque[3]);
int ph_top_torque_inertial(ph_top *top, const double torque[3]);
int ph_top_rotor(ph_top *top, const double momentum[3]);
int ph_top_control(ph_top *top);
void ph_top_without(ph_top *top, unsigned effects);

/* Total torque about the origin, body axes. u: three components, used only with PH_CONTROL; NULL is
   0. q enters as the polynomial q* v q, exact for unit q (any q near it is accepted: stages of a
   stepper). */
int ph_top_torque(const ph_top *top, double t, const double x[], const double u[3], double N[3]);
/* Equations of motion: q' = q (0, w) / 2, I w' = N - w x I w, each component rounded once from long
   double. About an axis without moment w' = 0, and a torque about it is PH_EROD. */
int ph_top_rates(const ph_top *top, double t, const double x[], const double u[3], double dx[]);
/* Of the body alone: N = I w' + w x I w, body axes. What turns in it: ph_top_inverse_at. */
int ph_top_inverse(const ph_top *top, const double w[3], const double w_rate[3], double N[3]);
/* T = w.I.w / 2, V = -M g d.com (0 without gravity), E = T + V; L = I w + h (h: of rotors, whose
 * own energy T leaves out) in body and q L q* in inertial axes. */
int ph_top_kinetic(const ph_top *top, const double x[], double *T);
int ph_top_potential(const ph_top *top, const double x[], double *V);
int ph_top_energy(const ph_top *top, const double x[], double *E);
int ph_top_momentum_body(const ph_top *top, const double x[], double L[3]);
int ph_top_momentum(const ph_top *top, const double x[], double L[3]);

/* ---- motion in principal axes ---- */

/* Euler's equations, I1 w1' = N1 + (I2 - I3) w2 w3 and cyclic; moments positive (PH_EPOSITIVE). N
 * NULL: 0. */
int ph_euler_rates(const double moment[3], const double w[3], const double N[3], double w_rate[3]);

/* The free symmetric top, I1 = I2, axis 3 = body z. */
typedef struct ph_symmetric {
  double Omega; /* (I3 - I1)/I1 w3, rad/s: w circles the axis at this rate, seen from the body */
  double
      precession; /* |L|/I1, rad/s: the axis circles L at this rate, seen from the inertial frame */
  double body_cone;  /* half-angle between w and axis 3, rad, [0, pi] */
  double space_cone; /* half-angle between w and L, rad */
  double nutation;   /* angle between L and axis 3, rad, [0, pi] */
  double T, L;       /* kinetic energy, |angular momentum| */
} ph_symmetric;
int ph_symmetric_top(double I1, double I3, const double w[3], ph_symmetric *out);
/* Its state a time t after x0, exact for any t: attitude = turn about L by |L|t/I1, then x0's, then
 * about axis 3 by -Omega t. */
int ph_symmetric_at(double I1, double I3, const double x0[7], double t, double x[7]);

enum ph_verdict { PH_UNSTABLE = -1, PH_NEUTRAL = 0, PH_STABLE = 1 };

/* Small oscillations of the free top that spins at rate s about principal axis k; i, j, k cyclic:
   w_i' = -Omega1 w_j, w_j' = Omega2 w_i, Omega1 = (Ik - Ij)/Ii s, Omega2 = (Ik - Ii)/Ij s. */
typedef struct ph_stability {
  double Omega1, Omega2, Omega_squared; /* Omega_squared = Omega1 Omega2 */
  double rate;   /* sqrt |Omega_squared|: oscillation or growth, rad/s or 1/s */
  double period; /* 2 pi / rate if stable, else infinity */
  int verdict;   /* enum ph_verdict; neutral: Omega_squared = 0 */
} ph_stability;
int ph_top_stability(const double moment[3], int k, double s, ph_stability *out);

/* ---- integration ---- */

typedef enum ph_method {
  PH_RK4,     /* the classical method, fixed step; in long double */
  PH_RK4_GSL, /* GSL's rk4: two half steps with the difference to the whole one as error */
  PH_RKF45,   /* GSL: Runge-Kutta-Fehlberg */
  PH_RK8PD,   /* GSL: Prince-Dormand 8(9) */
  PH_TAYLOR,  /* Taylor series of q and w in long double: the reference */
  PH_EXACT,   /* no integration: ph_free_top_solve, and PH_EMETHOD if an effect is on */
  PH_IMPLICIT /* Radau's collocation of 3 to 9 stages in long double, for what decays fast */
} ph_method;

typedef struct ph_options {
  ph_method method;
  double step; /* s; > 0: fixed steps of this length or a little less, so that output times are hit;
                  0: adaptive */
  double tolerance; /* adaptive: error of one step relative to |q| = 1 and to |w| (PH_TAYLOR: to
 each component of w); 1e-19 to 0.1 */
  int order;        /* PH_TAYLOR with fixed step: 2 to 40; 0: 24 */
  int free_norm;    /* non-zero: do not project q onto |q| = 1 after each step */
  long max_steps;   /* in one call of ph_run_to */
  int (*stop)(void *context); /* NULL, or asked before each step: not 0 ends the call: PH_ESTEPS */
  void *context;
} ph_options;

/* PH_TAYLOR, adaptive, tolerance 1e-18, projection, 100 million steps. */
ph_options ph_options_default(void);

typedef struct ph_run ph_run;

/* A run of a copy of top from state x0 at t0; q of x0 is normalised first. *run is to be freed with
 * ph_run_free. */
int ph_run_new(ph_run **run, const ph_top *top, const ph_options *options, double t0,
               const double x0[]);
void ph_run_free(ph_run *run); /* NULL is allowed */
/* Go on to time t, forward or backward, with constant control u (NULL: 0), and give the state
   there. On failure the run stays where it was. The state is carried in long double, and |q| = 1 is
   restored by projection after each step (which keeps the method's order), so that it does not
   drift. Over 1000 revolutions PH_TAYLOR keeps 1e-14 in attitude and rates; GSL's methods, whose
   coefficients are doubles, about 1e-12. PH_ESTEP, PH_ESTEPS, PH_EROD, PH_ERANGE, PH_EFINITE. */
int ph_run_to(ph_run *run, double t, const double u[3], double x[]);
double ph_run_time(const ph_run *run);
/* Steps accepted and evaluations of the equations (for PH_TAYLOR: expansions) since ph_run_new. */
long ph_run_steps(const ph_run *run);
/* Steps by the implicit method, to which PH_TAYLOR turns where something decays fast. */
long ph_run_implicit_steps(const ph_run *run);
long ph_run_evaluations(const ph_run *run);

#ifdef __cplusplus
}
#endif
#include "polhode_exact.h" /* free top, elliptic functions */
#endif
