%% -- axial.h -- what it stores, and its set-up: part of scene.h.  SPDX-License-Identifier: MIT-0
typedef struct ${name}_orbit {
  ${name}_real k[3], s;                   /* axis; w along it at t = 0, over |k| */
  ${name}_real push;                      /* torque over moment along the axis: rad/s^2 over |k| */
  ${name}_real across[3], turned[3];      /* w across the axis at t = 0, and that turned by a quarter about the axis */
  ${name}_real decay1[2], decay3[2];      /* c1/I1 and c3/I3, 1/s, as pairs high + low */
  ${name}_real free[2], pushed[2], steady[2]; /* turns about the axis that s, push and the rotors make, see the code */
} ${name}_orbit;

/* Prepare the rates through x0 at t = 0; the attitude of x0 is not used.  Returns 0, or 1 if a number is not finite or a
 * rate beyond the range of the type; *o is untouched then. */
int ${name}_solve(${name}_orbit *o, const ${name}_model *m, const ${name}_real x0[]);

/* The rates w[3], rad/s, body axes, at time t, of either sign, as long as they and their phase stay within the range of the
 * type.  The phase is formed in twice the working precision and whole turns taken off. */
void ${name}_at_rates(const ${name}_orbit *o, ${name}_real t, ${name}_real w[]);
