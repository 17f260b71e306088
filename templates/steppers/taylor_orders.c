%% -- taylor_orders.c -- a step of any order, for the planner: part of scene.c.  SPDX-License-Identifier: MIT-0
/* One step of size h of any order up to ${upper}_ORDER: for the planner, which compares orders. */
void ${name}_taylor_step_of(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h, int top);

void ${name}_taylor_step_of(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h, int top)
{
%% if has_switches then
  const ${name}_real end = t + h;
  ${name}_real reached;

  (void)${name}_taylor_integrate(m, t, x, u, end, (end - t) - h, ${zero}, ${most_parts}, top, 0, &reached);
%% else
  ${name}_real c[${upper}_ORDER + 1][${upper}_ROW], d[${upper}_ROW];

  ${name}_taylor_terms(m, t, x, u, top, c${after_t});
  ${name}_taylor_step_by(m, c, top, h, x, d);
%% for _, s in ipairs(states) do
  x[${s.name}] += d[${s.index}];
%% end
%% end
}
