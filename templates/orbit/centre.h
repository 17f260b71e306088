%% -- centre.h -- what it stores, and the motion, of a rolling ball's centre: part of scene.h.  SPDX-License-Identifier: MIT-0
typedef struct ${name}_orbit {
%% if turning then
  ${name}_real rate, turns[4];        /* k Omega: rad/s; half of it, turns/s: high, low, and high in halves */
  ${name}_real share;                 /* (1 - k) Omega/R, 1/(m s) */
  ${name}_real last;                  /* s; later times are taken for this one, after 2^50 turns (float: 2^46) */
%% end
%% if tilted then
  ${name}_real pull[2], spin[2];      /* (1 - k) gravity along e1 and e2, m/s^2; over R, rad/s^2 */
%% end
  ${name}_real p[2], v[2], W[2];      /* centre of mass, its velocity, angular velocity at t = 0, along e1 and e2 */
  ${name}_real up;                    /* W.n, rad/s, constant */
  ${name}_real e[3][3];               /* e1, e2 and n, inertial axes */
} ${name}_orbit;

/* Prepare the motion of the centre through x0 at t = 0.  q of x0 is normalised.  Returns 0, or 1 if q is 0, a number is
 * not finite or a rate beyond the range of the type; *o is untouched then. */
int ${name}_solve(${name}_orbit *o, const ${name}_model *m, const ${name}_real x0[]);

/* At time t, of either sign: the centre of mass along e1 and e2, p[2], m; its velocity v[2], m/s; the angular velocity
 * W[3], rad/s, in inertial axes, of which the attitude at time t would make the states wx, wy, wz.  Some roundings of the
%% if turning then
 * largest term; the phase k Omega t is formed and reduced in twice the working precision. */
%% else
 * largest term. */
%% end
void ${name}_at_centre(const ${name}_orbit *o, ${name}_real t, ${name}_real p[], ${name}_real v[], ${name}_real W[]);
