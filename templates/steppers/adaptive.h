%% -- adaptive.h -- the contract of the embedded Runge-Kutta pair: part of scene.h.  SPDX-License-Identifier: MIT-0
/* ---- Dormand and Prince's pair of orders 5 and 4: steps from a tolerance ---- */

%% if has_switches then
/* One step of size h by the method of order 5: x goes from time t to t + h, the input u held.
%%   if has_sides then
 * It has parts that end at the corners of the equations; x becomes no number where no motion leads on from one. */
%%   else
 * It has parts that end at the corners of the equations. */
%%   end
%% else
/* One step of size h by the method of order 5: x goes from time t to t + h, the input u held. */
%% end
void ${name}_adaptive_step(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h);

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
int ${name}_adaptive_run(const ${name}_model *m, ${name}_real t0, ${name}_real x[], const ${name}_real u[], ${name}_real t1, ${name}_real tolerance, int most);
%% if first then

/* One step of size h by the method of order 5: the scene's own stepper. */
void ${name}_step(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h);
%% end
