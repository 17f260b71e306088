%% -- split.h -- the contract of a splitting stepper: part of scene.h.  SPDX-License-Identifier: MIT-0
/* ---- Splitting, order ${order}: free flow and kicks in turn ---- */

/* One step of size h: x goes from time t to t + h, the input u held.  q must be a unit quaternion (to a few per cent: it is
 * brought back to |q| = 1).  A step of -h undoes it but for rounding. */
void ${name}_${method}_step(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h);
%% if first then

/* One step of size h by the splitting of order ${order}: the scene's own stepper. */
void ${name}_step(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h);
%% end
