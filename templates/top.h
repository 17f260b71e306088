%% -- top.h -- its contract: part of scene.h.  SPDX-License-Identifier: MIT-0
/* ---- closed form: ${theorem} ----
 */
typedef struct ${name}_orbit {
  ${name}_real start[2], rate[2];     /* phase of the rates, at t = 0 and per second, as pairs high + low */
  ${name}_real period[2], inverse;    /* its period, 0 for ever */
  ${name}_real turn[2], jump[2];      /* turns about L per second, and less per period of the phase */
  ${name}_real a_re[4], a_im[4], b_re[4], b_im[4], f[3][5], nome, scale[3], s;
  ${name}_real q[4][4], w[3][3];
  int hyperbolic;
} ${name}_orbit;

int ${name}_solve(${name}_orbit *o, const ${name}_model *m, const ${name}_real x0[]);

void ${name}_at(const ${name}_orbit *o, ${name}_real t, ${name}_real x[]);
