%% -- plan.h -- the contract of the planned method: part of scene.h.  SPDX-License-Identifier: MIT-0
/* ---- planned for an accuracy of ${plan_accuracy} ---- */

%% if plan_steps then
/* The ${plan_what} that holds it [${plan_unit}]. */
#define ${upper}_PLANNED_${plan_constant} (${plan_literal})

%% end
/* The state x at time t0 becomes that at t1 by the planned method, in either direction${plan_input}.
%% for _, line in ipairs(plan_note) do
 * ${line}
%% end
 * Returns the number of steps, or -1 if they are more than an int holds or the state became infinite. */
int ${name}_advance(const ${name}_model *m, ${name}_real t0, ${name}_real x[], const ${name}_real u[], ${name}_real t1);
