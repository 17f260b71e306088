%% -- floors.c -- what the errors of the steppers' steps are measured by at least: part of scene.c.  SPDX-License-Identifier: MIT-0
%% if in_space then
/* A body at rest in space: its forces cancel, and what is left of them is rounding, which no step follows.  So a size counts
 * as at least what the terms of its rate, each on its own, make of it in the step: of a velocity, and of a place. */
static ${head}
{
%%   for _, line in ipairs(lines) do
  ${line}
%%   end
}
%% else
/* At rest v and w x r cancel, and so do torques: what is left of them is rounding, which no step follows.  So a size counts
 * as at least what the terms of its rate, each on its own, make of it in the step: of w, of a velocity along the plane and
 * of a place on it. */
static void ${name}_floors(const ${name}_model *m, const ${name}_real x[], ${name}_real h, ${name}_real least[3])
{
  ${name}_real w = ${zero}, v = ${zero};

%% if not uses_model then
  (void)m;
%% end
%% for _, s in ipairs(rates) do
  w = ${fabs}(x[${s.name}]) > w ? ${fabs}(x[${s.name}]) : w;
%% end
%% for _, s in ipairs(speeds) do
  v = ${fabs}(x[${s.name}]) > v ? ${fabs}(x[${s.name}]) : v;
%% end
  least[0] = ${fabs}(h)*${turn} + v/${reach};
  least[1] = ${fabs}(h)*${pull} + w*${reach};
  least[2] = ${reach};
}
%% end

