%% -- guard.c -- is a state within the declared ranges?  Part of scene.c.  SPDX-License-Identifier: MIT-0
/* ---- the declared ranges; !(a <= b) also where one is not a number ---- */

int ${name}_within(const ${name}_real x[])
{
%% if guard_norm then
  const ${name}_real qw = x[${upper}_QW], qx = x[${upper}_QX], qy = x[${upper}_QY], qz = x[${upper}_QZ];
  ${name}_real norm;

  /* each component first, so that no square overflows */
  if (!(qw >= -${guard_component} && qw <= ${guard_component})) return 1 + ${upper}_QW;
  if (!(qx >= -${guard_component} && qx <= ${guard_component})) return 1 + ${upper}_QW;
  if (!(qy >= -${guard_component} && qy <= ${guard_component})) return 1 + ${upper}_QW;
  if (!(qz >= -${guard_component} && qz <= ${guard_component})) return 1 + ${upper}_QW;
  norm = qw*qw + qx*qx + qy*qy + qz*qz;
  if (!(norm >= ${guard_least} && norm <= ${guard_most})) return 1 + ${upper}_QW;

%% end
%% for _, s in ipairs(guard_states) do
%%   if s.range then
  if (!(x[${s.name}] >= ${s.low} && x[${s.name}] <= ${s.high})) return 1 + ${s.name};
%%   else
  if (!(x[${s.name}] - x[${s.name}] == ${zero})) return 1 + ${s.name};
%%   end
%% end
  return 0;
}
