%% -- midpoint.h -- the contract of the midpoint rule: part of scene.h.  SPDX-License-Identifier: MIT-0
/* ---- Implicit midpoint rule on the rotation group: order 2, symmetric in time, for long runs ---- */

/* One step of size h: x goes from time t to t + h, the input u held.  The angular momentum in inertial axes changes by
 * the torque's impulse and rounding only, whatever h is, and |q| = 1 after every step (a q of another length is brought
 * to 1).  The equations of the step are solved by ${count} Newton iterations, always.
%% if free then
 * They converge for h |w| <= 0.7, to the last digit for h |w| <= 0.35, and the energy is then kept, too.  For a larger h
 * the last finite iterate is taken: momentum and |q| are kept still, the motion is wrong.
%% else
 * They converge for h |w| <= 0.35 and h^2 (torque per radian)/I, h (damping)/I small against 1; the energy of a scene
 * that conserves it then oscillates and does not drift.  For a larger h the last finite iterate is taken: |q| is 1 still,
 * the motion is wrong. */
%% end
%% if free then
 */
%% end
void ${name}_midpoint_step(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h);
%% if transition then

/* The same step and its transition matrix, row major, NX x NX: F[i*NX + k] = d x[i](t + h)/d x[k](t), by the theorem on
 * implicit functions, exact where the iteration has converged. */
void ${name}_midpoint_step_transition(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h, ${name}_real F[]);
%% end
%% if transition_u then

/* How the same step depends on the input, row major, NX x NU: G[i*NU + k] = d x[i](t + h)/d u[k], u held during the step; 0
 * where u[k] is beyond its limits.  x stays as it is. */
void ${name}_midpoint_step_transition_u(const ${name}_model *m, ${name}_real t, const ${name}_real x[], const ${name}_real u[], ${name}_real h, ${name}_real G[]);
%% end
%% if first then

/* The same: the scene's own stepper. */
void ${name}_step(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h);
%%   if transition then
void ${name}_step_transition(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h, ${name}_real F[]);
%%   end
%%   if transition_u then
void ${name}_step_transition_u(const ${name}_model *m, ${name}_real t, const ${name}_real x[], const ${name}_real u[], ${name}_real h, ${name}_real G[]);
%%   end
%% end
