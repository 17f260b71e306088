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

${run}
%% if first then

/* One step of size h by the method of order 5: the scene's own stepper. */
void ${name}_step(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h);
%% end
