%% -- point.h -- what it stores, and the set-up, of the closed form of a point: part of scene.h.  SPDX-License-Identifier: MIT-0
typedef struct ${name}_wave { /* s'' = g - kappa s */
  ${name}_real rate[2];          /* sqrt |kappa| as a pair high + low */
  int kind;                      /* sign of kappa: 1 oscillation, 0 parabola, -1 exponential */
} ${name}_wave;

typedef struct ${name}_orbit { /* in a unit of time 2^-e s, in which the rates are about 1 */
  int e;
%% if framed then
  ${name}_wave along, across;    /* along the axis of the frame, and across it seen from inertial axes */
  ${name}_real turn[2];          /* rate of the frame, as a pair */
  ${name}_real fast[2], slow[2]; /* turn + and - the rate across */
  ${name}_real delta;            /* product of those two */
  ${name}_real n[3];             /* axis of the frame */
  ${name}_real y[3][3];          /* position, velocity and constant force */
  ${name}_real s[3];             /* these along the axis */
  ${name}_real z[3][3], nz[3][3]; /* and across it; and n x these */
%% else
  ${name}_wave wave[3];          /* each coordinate */
  ${name}_real s[3][3];          /* its position, velocity and constant force */
%% end
} ${name}_orbit;

/* Prepare the motion through x0 at t = 0.  Returns 0, or 1 if a number is not finite or beyond the range of the type in
 * a unit of time in which the rates are about 1; *o is untouched then. */
int ${name}_solve(${name}_orbit *o, const ${name}_model *m, const ${name}_real x0[]);

/* The state at time t, of either sign, as long as the phases rate*t stay within the range of the type; no step, no error
 * that grows from step to step; the phases are formed in twice the working precision. */
void ${name}_at(const ${name}_orbit *o, ${name}_real t, ${name}_real x[]);

/* The states at n times: x[i*n + k] is component i at t[k]. */
void ${name}_at_many(const ${name}_orbit *o, int n, const ${name}_real t[], ${name}_real x[]);
