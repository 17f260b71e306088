%% -- slide.h -- what it stores, and the motion, of a sliding ball's centre: part of scene.h.  SPDX-License-Identifier: MIT-0
typedef struct ${name}_orbit {
  ${name}_real decay, share;          /* of the slip, c G/k, 1/s; k = J/(J + m R^2) */
  ${name}_real rest;                  /* (1 - k)/R, 1/m */
  ${name}_real p[2], v[2], slip[2], W[2]; /* centre of mass, its velocity, the slip and the angular velocity at t = 0 */
  ${name}_real up;                    /* W.n, rad/s, constant */
  ${name}_real e[3][3];               /* e1, e2 and n, inertial axes */
} ${name}_orbit;

/* Prepare the motion of the centre through x0 at t = 0.  q of x0 is normalised.  Returns 0, or 1 if q is 0 or a number is
 * not finite; *o is untouched then. */
int ${name}_solve(${name}_orbit *o, const ${name}_model *m, const ${name}_real x0[]);

/* At time t, of either sign: the centre of mass along e1 and e2, p[2], m; its velocity v[2], m/s; the angular velocity
 * W[3], rad/s, in inertial axes, of which the attitude at time t would make the states wx, wy, wz.  Some roundings of the
 * largest term. */
void ${name}_at_centre(const ${name}_orbit *o, ${name}_real t, ${name}_real p[], ${name}_real v[], ${name}_real W[]);
