%% -- taylor_run.c -- the Taylor stepper's choice of order, and its run: part of scene.c.  SPDX-License-Identifier: MIT-0
/* The order for a tolerance.  Steps grow as tolerance^(1/n) and cost some a + b n + c n^2: the least time to a given end is
 * at n = const - const log(tolerance), const - log(tolerance)/2 with products alone (Jorba, Zou 2005, section 3.1). */
static int ${name}_taylor_top(${name}_real tolerance)
{
%% if packed then
#if defined ${upper}_PACKED
  const ${name}_real least = ${least_packed};
#else
  const ${name}_real least = ${least};
#endif
%% else
  const ${name}_real least = ${least};
%% end
  const ${name}_real top = least - ${slope}*${name}_taylor_log2(tolerance);

  return top < (${name}_real)${upper}_ORDER ? top > ${four} ? (int)top : 4 : ${upper}_ORDER;
}

%% if has_switches then
${switched}
%% else
${name}_real ${name}_taylor_adapt(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h, ${name}_real tolerance)
{
  ${name}_real c[${upper}_ORDER + 1][${upper}_ROW], d[${upper}_ROW];

%% if has_knots then
  h = ${name}_knot(m, t, t + h) - t;
  ${name}_taylor_terms(m, t, x, u, ${upper}_ORDER, c, t + ${half}*h);
%% else
  ${name}_taylor_series(m, t, x, u, c);
%% end
%% if has_roots then
  if (${name}_taylor_lost(c, ${upper}_ORDER, ${zero})) return ${name}_taylor_leave(m, t, x, u, h);
%% end
  h = ${name}_taylor_limit(${name}_taylor_size(c, ${upper}_ORDER, tolerance, ${zero}), h);
%% if has_roots then
  h = ${name}_taylor_corner(c, ${upper}_ORDER, h);
%% end
  ${name}_taylor_step_by(m, c, ${upper}_ORDER, h, x, d);
%% for _, s in ipairs(states) do
  x[${s.name}] += d[${s.index}];
%% end
  return h;
}

int ${name}_taylor_run(const ${name}_model *m, ${name}_real t0, ${name}_real x[], const ${name}_real u[], ${name}_real t1, ${name}_real tolerance, int most)
{
  static const int moving[${upper}_MOVING] = {
%% for _, s in ipairs(states) do
    ${s.name},
%% end
  };
  const ${name}_real finest = ${finest}, local = tolerance < finest ? tolerance : finest;
  const int top = ${name}_taylor_top(tolerance);
  ${name}_real c[${upper}_ORDER + 1][${upper}_ROW], d[${upper}_ROW], lost[${upper}_MOVING + 1];
  ${name}_real t = t0;

  for (int k = 0; k <= ${upper}_MOVING; k++) lost[k] = ${zero}*(${name}_real)k; /* 0, and no call of memset */
  for (int steps = 0; steps < most; steps++) {
%% if has_knots then
    const ${name}_real end = ${name}_knot(m, t, t1), left = (end - t) - lost[${upper}_MOVING]; /* from corner to corner */
%% else
    const ${name}_real left = (t1 - t) - lost[${upper}_MOVING];
%% end
    ${name}_real h, next_t;

    if (!(left > ${zero} || left < ${zero})) return steps;
    ${name}_taylor_terms(m, t, x, u, top, c${before_end});
%% if has_roots then
    if (${name}_taylor_lost(c, top, ${zero})) {
      h = ${name}_taylor_leave(m, t, x, u, left);
      if (!(t + h > t || t + h < t)) return -1;
      t += h;
      for (int k = 0; k <= ${upper}_MOVING; k++) lost[k] = ${zero};
      continue;
    }
%% end
    h = ${name}_taylor_limit(${name}_taylor_size(c, top, local, tolerance/(t1 - t0)), left);
%% if has_roots then
    h = ${name}_taylor_corner(c, top, h);
%% end
    if (!(h > ${zero} || h < ${zero})) return -1;
    ${name}_taylor_step_by(m, c, top, h, x, d);
    for (int k = 0; k < ${upper}_MOVING; k++) { /* Kahan: what rounding took from the last sum is in the next one */
      const ${name}_real more = d[k] + lost[k], sum = c[0][k] + more;

      if (!(sum - sum == ${zero})) return -1;
      lost[k] = more - (sum - c[0][k]);
      x[moving[k]] = sum;
    }
%% if has_knots then
    if (!(h < left || h > left)) {
      t = end;
      lost[${upper}_MOVING] = ${zero};
      continue;
    }
%% end
    h += lost[${upper}_MOVING];
    next_t = t + h;
    lost[${upper}_MOVING] = h - (next_t - t);
    t = next_t;
  }
  return -1;
}
%% if first then

void ${name}_step(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h)
{
  ${name}_taylor_step(m, t, x, u, h);
}
%% end
%% end
