%% -- rosenbrock.h -- the contract of the linearly implicit method: part of scene.h.  SPDX-License-Identifier: MIT-0
/* ---- Rodas5P: linearly implicit, order 5, for stiff effects ---- */

/* One step of size h: x goes from time t to t + h, the input u held.  A fixed step must be short
%% if has_switches then
 * at a fast start, which it does not damp well; ${name}_rosenbrock_run chooses such steps.
%%   if has_sides then
 * It has parts that end at the corners of the equations; x becomes no number where no motion leads on from one. */
%%   else
 * It has parts that end at the corners of the equations. */
%%   end
%% else
 * at a fast start, which it does not damp well; ${name}_rosenbrock_run chooses such steps. */
%% end
void ${name}_rosenbrock_step(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h);

${run}
%% if first then

/* One step of size h: the scene's own stepper. */
void ${name}_step(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h);
%% end
