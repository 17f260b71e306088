/* polhode_plane.h - a body on a plane: part of polhode.h, which includes it.
   SPDX-License-Identifier: GPL-3.0-or-later

   The plane passes through the inertial origin; its unit normal n points to the body's side. It may
   turn at a constant rate about n through the origin. The body's surface is smooth and convex:
   an ellipsoid whose half axes may be 0 (a disc), rolled over by a ball of the radius `rim` (a
   sphere: half axes 0). The contact point is the one whose outward normal is -n.
   States of its own, where it has any: the coordinates of the centre of mass along e1 and
   e2 = n x e1, and unless the body rolls the components of its velocity along them. Its height
   above the plane follows from the attitude.
     PH_ROLLING   the contact point has the velocity of the plane's point under it
     PH_SMOOTH    the force is along n
     PH_VISCOUS   and -c N v against the slip v;  PH_COULOMB: -mu N v/sqrt(v.v + s^2)
   The equations hold while the reaction N is positive. */
#ifndef POLHODE_PLANE_H
#define POLHODE_PLANE_H

#ifdef __cplusplus
extern "C" {
#endif

enum ph_plane_law { PH_ROLLING, PH_SMOOTH, PH_VISCOUS, PH_COULOMB };

typedef struct ph_plane {
  int law;
  int placed;              /* PH_SMOOTH: are there states of the centre of mass? Else there are */
  double half_axes[3];     /* m, not negative */
  double axes[4];          /* quaternion: from the ellipsoid's axes to the body's */
  double rim, centre[3];   /* m; centre of the surface, body axes, from the centre of mass */
  double normal[3], e1[3]; /* any length but 0; e1 is made perpendicular to the normal */
  double rate;             /* rad/s, about n */
  double gravity[3];       /* m/s2, inertial axes */
  double friction, smoothing; /* c in s/m, or mu and s in m/s */
} ph_plane;

/* What touches the plane, and how: all vectors in inertial axes, point and com from the origin of
   the plane. */
typedef struct ph_contact {
  double reaction; /* N, along n */
  double force[3]; /* of the plane on the body, N */
  double com[3], velocity[3];
  double point[3], slip[3];
} ph_contact;

struct ph_top;

/* PH_EBOUND: the top was not made about its centre of mass, or the law is none of the four;
   PH_EMETHOD: it has wheels, moving parts or a plane already; PH_ELENGTH: a length is negative, or
   all are 0; PH_EDIRECTION: the normal is 0, or e1 is along it; PH_EPOSITIVE: friction is negative,
   or s is not positive. */
int ph_top_plane(struct ph_top *top, const ph_plane *plane);
/* PH_EMETHOD without a plane; PH_ECONTACT: it lies flat on a disc's face. */
int ph_top_contact(const struct ph_top *top, double t, const double x[], const double u[3],
                   ph_contact *out);

#ifdef __cplusplus
}
#endif
#endif
