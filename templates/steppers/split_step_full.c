%% -- split_step_full.c -- the same where the drift has a splitting of its own: part of scene.c.  SPDX-License-Identifier: MIT-0
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
  static const ${name}_real a[] = { /* the free body's own splitting */
%% for _, s in ipairs(inner.a) do
    ${s},
%% end
  };
  static const ${name}_real b[] = {
%% for _, s in ipairs(inner.b) do
    ${s},
%% end
  };
%% if kicks then

  for (int i = 0; i < ${outer.n}; i++) {
    ${name}_split_drift(m, x, drift[i]*h, ${inner.n}, a, b);
    ${name}_split_kick(m, t + at[i]*h, x, u, kick[i]*h);
  }
  ${name}_split_drift(m, x, drift[${outer.n}]*h, ${inner.n}, a, b);
%% else

  (void)t;
  (void)u;
  ${name}_split_drift(m, x, h, ${inner.n}, a, b);
%% end
}
%% if first then

void ${name}_step(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h)
{
  ${name}_${method}_step(m, t, x, u, h);
}
%% end
