%% -- taylor_step.c -- one step of the Taylor series: part of scene.c.  SPDX-License-Identifier: MIT-0
void ${name}_taylor_step(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h)
{
  ${name}_real c[${upper}_ORDER + 1][${upper}_ROW], d[${upper}_ROW];

  ${name}_taylor_series(m, t, x, u, c);
%% if has_roots then
  if (${name}_taylor_lost(c, ${upper}_ORDER, h)) {
    ${name}_taylor_part(m, t, x, u, h);
    return;
  }
%% end
  ${name}_taylor_step_by(m, c, ${upper}_ORDER, h, x, d);
%% for _, s in ipairs(states) do
  x[${s.name}] += d[${s.index}];
%% end
}
