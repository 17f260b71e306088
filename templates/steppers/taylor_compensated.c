%% -- taylor_compensated.c -- the Taylor step with compensated sums: part of scene.c.  SPDX-License-Identifier: MIT-0
/* Dekker's Fast2Sum (Numer. Math. 18, 224, 1971; Kahan, Comm. ACM 8, 40, 1965): low is what the sum loses, and comes back
 * with the next step. */
void ${name}_taylor_step_compensated(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h, ${name}_real low[${upper}_NX])
{
%% if has_knots then
  const ${name}_real end = t + h;
%% end
  ${name}_real c[${upper}_ORDER + 1][${upper}_ROW], d[${upper}_ROW], more, sum;
%% if has_knots then
  ${name}_real stop, part;

  for (int n = 0; n <= ${knots_count}; n++) { /* from corner to corner */
    stop = ${name}_knot(m, t, end);
    part = stop < end || stop > end ? stop - t : h;
    ${name}_taylor_terms(m, t, x, u, ${upper}_ORDER, c, t + ${half}*part);
    ${name}_taylor_step_by(m, c, ${upper}_ORDER, part, x, d);
%% for _, s in ipairs(states) do
    more = d[${s.index}] + low[${s.name}];
    sum = x[${s.name}] + more;
    low[${s.name}] = more - (sum - x[${s.name}]);
    x[${s.name}] = sum;
%% end
    t = stop;
    h -= part;
    if (!(stop < end || stop > end)) break;
  }
%% else

  ${name}_taylor_series(m, t, x, u, c);
%% if has_roots then
  if (${name}_taylor_lost(c, ${upper}_ORDER, h)) {
    ${name}_taylor_part(m, t, x, u, h);
    return;
  }
%% end
  ${name}_taylor_step_by(m, c, ${upper}_ORDER, h, x, d);
%% for _, s in ipairs(states) do
  more = d[${s.index}] + low[${s.name}];
  sum = x[${s.name}] + more;
  low[${s.name}] = more - (sum - x[${s.name}]);
  x[${s.name}] = sum;
%% end
%% end
}
%% if first then

void ${name}_step_compensated(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h, ${name}_real low[${upper}_NX])
{
  ${name}_taylor_step_compensated(m, t, x, u, h, low);
}
%% end
