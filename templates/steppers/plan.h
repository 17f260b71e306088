%% -- plan.h -- the contract of the planned method: part of scene.h.  SPDX-License-Identifier: MIT-0
/* ---- planned for an accuracy of ${accuracy} ---- */

%% if steps then
/* The ${what} that holds it [${unit}]. */
#define ${upper}_PLANNED_${constant} (${literal})

%% end
/* The state x at time t0 becomes that at t1 by the planned method, in either direction${input}.
%% for _, line in ipairs(note) do
 * ${line}
%% end
 * Returns the number of steps, or -1 if they are more than an int holds or the state became infinite. */
int ${name}_advance(const ${name}_model *m, ${name}_real t0, ${name}_real x[], const ${name}_real u[], ${name}_real t1);
