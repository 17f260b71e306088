%% -- rosenbrock.h -- the contract of the linearly implicit method: part of scene.h.  SPDX-License-Identifier: MIT-0
/* ---- Rodas5P: linearly implicit, order 5, for stiff effects ---- */

/* One step of size h: x goes from time t to t + h, the input u held.  A fixed step must be short
 * at a fast start, which it does not damp well; ${name}_rosenbrock_run chooses such steps. */
void ${name}_rosenbrock_step(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h);

/* From time t0 to t1 in at most `most` steps whose estimated error is the tolerance times the size of each kind of state
 * (attitude, rates, ...); returns how many were tried, or -1 if they did not suffice or the state became infinite (x is
 * then where it stopped). */
int ${name}_rosenbrock_run(const ${name}_model *m, ${name}_real t0, ${name}_real x[], const ${name}_real u[], ${name}_real t1, ${name}_real tolerance, int most);
%% if first then

/* One step of size h: the scene's own stepper. */
void ${name}_step(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h);
%% end
