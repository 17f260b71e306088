%% -- closed.h -- its contract: part of scene.h.  SPDX-License-Identifier: MIT-0
/* ---- closed form: ${theorem} ----
 *
%% for _, line in ipairs(closed_text) do
 * ${line}
%% end
 */
typedef struct ${name}_orbit {
  ${name}_real q[4][4];               /* q0, l q0, q0 k, l q0 k: the quaternions that q(t) is a combination of */
  ${name}_real precession[2];         /* |L|/(2 I1), rad/s: half the rate about L, as a pair high + low */
%% if symmetric then
  ${name}_real spin[2];               /* (I1 - I3)/(2 I1) k.w, rad/s: half the rate about k, as a pair */
%% end
  ${name}_real along[3], across[3], turned[3]; /* w = along + cos(a) across + sin(a) turned, a the spin angle */
} ${name}_orbit;

/* Prepare the motion through x0 at t = 0.  q of x0 is normalised.  Returns 0, or 1 if q is 0, a number is not
 * finite or a rate beyond the range of the type; *o is untouched then. */
int ${name}_solve(${name}_orbit *o, const ${name}_model *m, const ${name}_real x0[]);

/* The state at time t, of either sign, as long as the phases rate*t stay within the range of the type: attitude and
 * rates, no step, no error that grows from step to step; the phases are formed in twice the working precision. */
void ${name}_at(const ${name}_orbit *o, ${name}_real t, ${name}_real x[]);
