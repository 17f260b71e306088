%% -- split_kick.c -- what changes the rates and the velocity: part of scene.c.  SPDX-License-Identifier: MIT-0
/* What changes the rates and the velocity beside the free motion */
static ${head}
{
%% for _, line in ipairs(lines) do
  ${line}
%% end
}

%% if slowed then
/* The rates over a time tau, attitude and place held, by the midpoint rule */
%% else
/* The rates over a time tau, attitude and place held */
%% end
static void ${name}_split_kick(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real tau)
{
  ${name}_real dx[${upper}_NX];
%% if slowed then
  ${name}_real y[${upper}_NX];
%% end

  ${name}_split_rates(m, t, x, u, dx);
%% if slowed then
  for (int i = 0; i < ${upper}_NX; i++) y[i] = x[i];
%%   for _, s in ipairs(states) do
  y[${s}] += ${half}*tau*dx[${s}];
%%   end
  ${name}_split_rates(m, t, y, u, dx);
%% end
%% for _, s in ipairs(states) do
  x[${s}] += tau*dx[${s}];
%% end
}
