%% -- lagrange.h -- what it stores, and the set-up, of the heavy top's closed form: part of scene.h.  SPDX-License-Identifier: MIT-0
typedef struct ${name}_orbit {
  ${name}_real start[2], rate[2];   /* phase of the nutation at t = 0, and per second, as pairs high + low */
  ${name}_real period[2], inverse;  /* its period; on the separatrix, which has none, both are 0 */
  ${name}_real turn[2][2], jump[2][2]; /* of a and b: turns per second, and what goes off with each period of the phase */
  ${name}_real re[3][4], im[3][4], nome; /* series of a, b and the rates across the axis, see ${name}_functions */
  ${name}_real winding;             /* of the rates' phase against that of b/a */
  ${name}_real mean;                /* rad/s, the rate about the vertical */
  ${name}_real tilt[2];             /* rad, smallest and largest */
  ${name}_real q[4][4], along[3], across[2][3]; /* quaternion and rates are combinations of these */
%% if has_tick_fields then
  ${name}_real tick;                /* s; the rest is set by ${name}_set_tick: fractions of two periods, of turns of a and b */
  struct {
    uint64_t start[2], tick[2];
  } counts[3];
%% end
  int hyperbolic;                   /* near the separatrix */
} ${name}_orbit;

/* Prepare the motion through x0 at t = 0, q of x0 normalised.  Returns 0, or 1 if q is 0, a number not finite, the moment
 * across the axis not positive, or a rate beyond the range of the type; *o is untouched then. */
int ${name}_solve(${name}_orbit *o, const ${name}_model *m, const ${name}_real x0[]);
