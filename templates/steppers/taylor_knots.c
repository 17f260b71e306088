%% -- taylor_knots.c -- a Taylor step over the corners of tables: part of scene.c.  SPDX-License-Identifier: MIT-0
void ${name}_taylor_step(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h)
{
  const ${name}_real end = t + h;
  ${name}_real c[${upper}_ORDER + 1][${upper}_ROW], d[${upper}_ROW], stop, part;

  for (int n = 0; n <= ${knots_count}; n++) { /* from corner to corner */
    stop = ${name}_knot(m, t, end);
    part = stop < end || stop > end ? stop - t : h;
    ${name}_taylor_terms(m, t, x, u, ${upper}_ORDER, c, t + ${half}*part);
%% if has_roots then
    if (${name}_taylor_lost(c, ${upper}_ORDER, part)) {
      ${name}_taylor_part(m, t, x, u, part);
      t = stop;
      h -= part;
      if (!(stop < end || stop > end)) break;
      continue;
    }
%% end
    ${name}_taylor_step_by(m, c, ${upper}_ORDER, part, x, d);
%% for _, s in ipairs(states) do
    x[${s.name}] += d[${s.index}];
%% end
    t = stop;
    h -= part;
    if (!(stop < end || stop > end)) break;
  }
}
