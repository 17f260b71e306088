%% -- ball.h -- what it stores, and the motion, of a ball on a level plane: part of scene.h.  SPDX-License-Identifier: MIT-0
typedef struct ${name}_orbit {
  ${name}_real q[2][4];               /* q0, and q0 times the direction of w */
  ${name}_real about[4];              /* |w|/2, turns/s: high, low, and high in halves */
  ${name}_real w[3];                  /* rad/s, constant */
  ${name}_real p[2], v[2];            /* centre of mass at t = 0, m, and its velocity, m/s */
  ${name}_real last;                  /* s; later times are taken for this one, after 2^50 turns (float: 2^46) */
} ${name}_orbit;

/* Prepare the motion through x0 at t = 0.  q of x0 is normalised.  Returns 0, or 1 if q is 0, a number is not
 * finite or a rate beyond the range of the type; *o is untouched then. */
int ${name}_solve(${name}_orbit *o, const ${name}_model *m, const ${name}_real x0[]);

/* The state at time t, of either sign.  Errors are at most ${orbit_bound} of the attitude as an angle (rad), and some roundings
 * of the place; phases are formed and reduced in twice the working precision. */
void ${name}_at(const ${name}_orbit *o, ${name}_real t, ${name}_real x[]);

/* The states at n times: x[i*n + k] is component i at t[k]. */
void ${name}_at_many(const ${name}_orbit *o, int n, const ${name}_real t[], ${name}_real x[]);
