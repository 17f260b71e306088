%% -- normalise.h -- the attitude as a unit quaternion.  Part of scene.h.  SPDX-License-Identifier: MIT-0
/* Scales q of x to |q| = 1: for a q that was measured, received or averaged, and after steps of another integrator on
 * ${name}_rhs, which lets |q| drift.  (The steps emitted here do it themselves.)  | |q| - 1 | is at most 2 epsilon then,
 * and each component has a relative error below 3 epsilon, unless it leaves the type's normal range; nothing overflows.
 * Returns 0; 1 if q is 0, or a component not a finite number: x is untouched then. */
int ${name}_normalise(${name}_real x[]);
