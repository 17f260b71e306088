%% -- adaptive.h -- the contract of the embedded Runge-Kutta pair: part of scene.h.  SPDX-License-Identifier: MIT-0
/* ---- Dormand and Prince's pair of orders 5 and 4: steps from a tolerance ---- */

/* One step of size h by the method of order 5: x goes from time t to t + h, the input u held. */
void ${name}_adaptive_step(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h);

/* From time t0 to t1 in at most `most` steps whose estimated error is the tolerance times the size of each kind of state
 * (attitude, rates, ...); returns how many were tried, or -1 if they did not suffice or the state became infinite (x is
 * then where it stopped). */
int ${name}_adaptive_run(const ${name}_model *m, ${name}_real t0, ${name}_real x[], const ${name}_real u[], ${name}_real t1, ${name}_real tolerance, int most);
%% if first then

/* One step of size h by the method of order 5: the scene's own stepper. */
void ${name}_step(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h);
%% end
