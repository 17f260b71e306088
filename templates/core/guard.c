%% -- guard.c -- is a state within the declared ranges?  Part of scene.c.  SPDX-License-Identifier: MIT-0
/* ---- the declared ranges; !(a <= b) also where one is not a number ---- */

int ${name}_within(const ${name}_real x[])
{
%% if norm then
  ${name}_real norm;

  /* each component first, so that no square overflows */
  if (!(x[${upper}_QW] >= -${component} && x[${upper}_QW] <= ${component})) return 1 + ${upper}_QW;
  if (!(x[${upper}_QX] >= -${component} && x[${upper}_QX] <= ${component})) return 1 + ${upper}_QW;
  if (!(x[${upper}_QY] >= -${component} && x[${upper}_QY] <= ${component})) return 1 + ${upper}_QW;
  if (!(x[${upper}_QZ] >= -${component} && x[${upper}_QZ] <= ${component})) return 1 + ${upper}_QW;
  norm = x[${upper}_QW]*x[${upper}_QW] + x[${upper}_QX]*x[${upper}_QX] + x[${upper}_QY]*x[${upper}_QY] + x[${upper}_QZ]*x[${upper}_QZ];
  if (!(norm >= ${least} && norm <= ${most})) return 1 + ${upper}_QW;

%% end
%% for _, s in ipairs(states) do
%%   if s.range then
  if (!(x[${s.name}] >= ${s.low} && x[${s.name}] <= ${s.high})) return 1 + ${s.name};
%%   else
  if (!(x[${s.name}] - x[${s.name}] == ${zero})) return 1 + ${s.name};
%%   end
%% end
  return 0;
}
