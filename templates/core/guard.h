%% -- guard.h -- is a state within the declared ranges?  Part of scene.h.  SPDX-License-Identifier: MIT-0
/* ---- the guard: step, check, go on or recover ---- */

/* Is x within the ranges that the scene declares?  0, or 1 + the index of the first state that is not (1 + ${upper}_WX);
 * a NaN is within no range.
%% if norm then
 *   attitude (its first component stands for it): |q|^2 from 1/4 to 4
%% end
%% for _, line in ipairs(about) do
 *   ${line}
%% end
 */
int ${name}_within(const ${name}_real x[]);
