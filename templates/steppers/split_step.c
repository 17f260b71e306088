%% -- split_step.c -- drifts and kicks in turn: part of scene.c.  SPDX-License-Identifier: MIT-0
/* ${about} */
void ${name}_${method}_step(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h)
{
%% if kicks then
  static const ${name}_real drift[] = {
%%   for _, s in ipairs(outer.a) do
    ${s},
%%   end
  };
  static const ${name}_real kick[] = {
%%   for _, s in ipairs(outer.b) do
    ${s},
%%   end
  };
  static const ${name}_real at[] = { /* sums of the drifts */
%%   for _, s in ipairs(outer.c) do
    ${s},
%%   end
  };
%% end
%% if kicks then
%% end
%% if has_attitude then
  /* one Newton step for 1/|q|, from the q that comes in, so |q| cannot drift */
  const ${name}_real over = ${half}*(x[${upper}_QW]*x[${upper}_QW] + x[${upper}_QX]*x[${upper}_QX] + x[${upper}_QY]*x[${upper}_QY] + x[${upper}_QZ]*x[${upper}_QZ]) - ${half};
%% else
  const ${name}_real over = ${zero}; /* there is no q */
%% end

%% if kicks then
  for (int i = 0; i < ${outer.n}; i++) {
    ${name}_split_drift(m, x, drift[i]*h, i > 0 ? ${zero} : over);
    ${name}_split_kick(m, t + at[i]*h, x, u, kick[i]*h);
  }
  ${name}_split_drift(m, x, drift[${outer.n}]*h, ${zero});
%% else
  (void)t;
  (void)u;
  ${name}_split_drift(m, x, h, over);
%% end
}
%% if first then

void ${name}_step(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h)
{
  ${name}_${method}_step(m, t, x, u, h);
}
%% end
