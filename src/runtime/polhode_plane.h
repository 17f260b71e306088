/* polhode_plane.h - a body on a plane: part of polhode.h, which includes it.
   SPDX-License-Identifier: GPL-3.0-or-later

   The plane passes through the inertial origin; its unit normal n points to the body's side. It may
   turn at a constant rate about n through the origin. The body's surface is smooth and convex, and
   is rolled over by a ball of the radius `rim`:
     PH_ELLIPSOID   the half axes may be 0: a disc has two, a sphere (its rim) none
     PH_PARABOLOID  z = x^2/(2 a) + y^2/(2 b), a and b the first two of half_axes; `centre` is its
                    lowest point
     PH_SUPPORT     of a support function h(n): the distance from the centre to the plane that
                    touches it where its outward normal is n
   The contact point is the one whose outward normal is -n.
   States of its own, where it has any: the coordinates of the centre of mass along e1 and
   e2 = n x e1, and unless the body rolls the components of its velocity along them. Its height
   above the plane follows from the attitude.
     PH_ROLLING   the contact point has the velocity of the plane's point under it
     PH_SMOOTH    the force is along n
     PH_VISCOUS   and -c N v against the slip v;  PH_COULOMB: -mu N v/sqrt(v.v + s^2)
   With a rate w of turning beside the plane, the torque N f(w_n) n + N f(w_t), f(w) = -c w, or
   -a w/sqrt(w.w + e^2), resists its part along n (spinning) and its part across n (rolling).
   The equations hold while the reaction N is positive. */
#ifndef POLHODE_PLANE_H
#define POLHODE_PLANE_H

#ifdef __cplusplus
extern "C" {
#endif

enum ph_plane_law { PH_ROLLING, PH_SMOOTH, PH_VISCOUS, PH_COULOMB };

enum ph_plane_surface { PH_ELLIPSOID, PH_PARABOLOID, PH_SUPPORT };

/* out: h at the unit vector n in the surface's axes, its gradient, and its second derivatives xx,
   yy, zz, xy, xz, yz, of any function of three numbers that is h where n.n = 1. What is not finite
   has no contact point there. The context stays the caller's and must live as long as the top. */
typedef struct ph_support {
  void (*jet)(void *context, const long double n[3], long double out[10]);
  void *context;
} ph_support;

typedef struct ph_resistance {
  double coefficient; /* c in m s; with a smoothing a in m */
  double smoothing;   /* e in rad/s; 0: none */
} ph_resistance;

typedef struct ph_plane {
  int law;
  int placed;              /* PH_SMOOTH: are there states of the centre of mass? Else there are */
  int surface;             /* PH_ELLIPSOID is 0 */
  double half_axes[3];     /* m, not negative */
  double axes[4];          /* quaternion: from the surface's axes to the body's */
  double rim, centre[3];   /* m; centre of the surface, body axes, from the centre of mass */
  double normal[3], e1[3]; /* any length but 0; e1 is made perpendicular to the normal */
  double rate;             /* rad/s, about n */
  double gravity[3];       /* m/s2, inertial axes */
  double friction, smoothing; /* c in s/m, or mu and s in m/s */
  ph_resistance spinning, rolling;
  ph_support support; /* of PH_SUPPORT */
} ph_plane;

/* What touches the plane, and how: all vectors in inertial axes, point and com from the origin of
   the plane. */
typedef struct ph_contact {
  double reaction; /* N, along n */
  double force[3]; /* of the plane on the body, N */
  double com[3], velocity[3];
  double point[3], slip[3];
} ph_contact;

/* What happens when a body meets the plane: restitution e, 0 to 1; coefficient of friction,
   INFINITY where it sticks; restitution along the plane, -1 to 1. */
typedef struct ph_impact {
  double restitution, friction, tangential;
} ph_impact;

/* The lowest point of a body in the air, in inertial axes: its distance from the plane, negative
   below it, the rate of that, the point, and its velocity against the plane. */
typedef struct ph_gap {
  double gap, rate, point[3], slip[3];
} ph_gap;

struct ph_top;

/* PH_EBOUND: the top was not made about its centre of mass, the law or surface is none of the
   above, or PH_SUPPORT has no function; PH_EMETHOD: it has wheels, moving parts or a plane already;
   PH_ELENGTH: a length is negative, or all are 0; PH_EDIRECTION: the normal is 0, or e1 is along
   it; PH_EPOSITIVE: friction is negative, or s is not positive. */
int ph_top_plane(struct ph_top *top, const ph_plane *plane);
/* PH_EMETHOD without a plane; PH_ECONTACT: it lies flat on a disc's face, or a paraboloid's open
   side is below. */
int ph_top_contact(const struct ph_top *top, double t, const double x[], const double u[3],
                   ph_contact *out);

/* Of the same body in the air, x its attitude (body to inertial), rates (body axes), position and
   velocity of the centre of mass (inertial axes): its lowest point. Errors as above;
   PH_EQUATERNION, PH_EFINITE. */
int ph_top_gap(const struct ph_top *top, const double x[13], ph_gap *out);
/* x becomes the state after the impact, normal the impulse along n, N s: 0 where the lowest point
   does not approach the plane. Energy is never made. PH_EPOSITIVE: a number of the law is out of
   its range. Chatterjee, Ruina, J. Appl. Mech. 65 (1998) 939. */
int ph_top_impact(const struct ph_top *top, const ph_impact *law, double x[13], double *normal);

#ifdef __cplusplus
}
#endif
#endif
