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

/* From time t0 to t1 in at most `most` steps whose estimated error is the tolerance times the size of each kind of state
 * (attitude, rates, ...); returns how many were tried, or -1 if they did not suffice or the state became infinite (x is
%% if has_switches then
 * then where it stopped).
%% if has_sides then
 * The equations have corners, where steps end; -1 also where both sides of one push back to it, so that no motion leads on. */
%% elseif has_switches then
 * The equations have corners, where steps end. */
%% end
%% else
 * then where it stopped). */
%% end
int ${name}_rosenbrock_run(const ${name}_model *m, ${name}_real t0, ${name}_real x[], const ${name}_real u[], ${name}_real t1, ${name}_real tolerance, int most);
%% if first then

/* One step of size h: the scene's own stepper. */
void ${name}_step(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h);
%% end
