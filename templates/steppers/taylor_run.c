%% -- taylor_run.c -- the Taylor stepper's choice of step and order: part of scene.c.  SPDX-License-Identifier: MIT-0
/* An IEEE 754 number's bits, read as an integer, are its logarithm but for a straight line between powers of two: log2 |x|
 * to 0.09, and the inverse function. */
typedef union ${name}_taylor_bits {
  ${name}_real x;
  ${taylor_int} n;
} ${name}_taylor_bits;

static ${name}_real ${name}_taylor_log2(${name}_real x)
{
  ${name}_taylor_bits b;

  b.x = ${fabs}(x);
  return (${name}_real)b.n*${taylor_bit} - ${taylor_bias};
}

static ${name}_real ${name}_taylor_exp2(${name}_real x) /* x within the range of exponents */
{
  ${name}_taylor_bits b;

  b.n = (${taylor_int})((x + ${taylor_bias})*${taylor_scale});
  return b.x;
}

/* The largest step h at which the last two terms are below a part of the first ones of their kind of state, |c[n]| h^n <=
 * part |c[i]| h^i for some i < 3; the part is `local`, or `rate` h if that is larger. */
static ${name}_real ${name}_taylor_size(${name}_real c[][${upper}_ROW], int top, ${name}_real local, ${name}_real rate)
{
  const ${name}_real log_local = ${name}_taylor_log2(local), log_rate = ${name}_taylor_log2(rate);
  ${name}_real log_h = ${eight}*${eight}, head[3], tail, at, best, part[5];
  int i, k, n;

  for (i = 0; i < 5; i++) part[i] = ${one}/(${name}_real)(top - i > 0 ? top - i : 1);

%% for _, k in ipairs(taylor_kinds) do
  /* ${k.about} */
  for (i = 0; i < 3; i++) {
    head[i] = ${zero};
    for (k = ${k.first}; k < ${k.last}; k++) head[i] = ${fabs}(c[i][k]) > head[i] ? ${fabs}(c[i][k]) : head[i];
    head[i] = ${name}_taylor_log2(head[i]);
  }
  for (n = top - 1; n <= top; n++) {
    tail = ${zero};
    for (k = ${k.first}; k < ${k.last}; k++) tail = ${fabs}(c[n][k]) > tail ? ${fabs}(c[n][k]) : tail;
    if (!(tail > ${zero})) continue; /* nothing moves */
    tail = ${name}_taylor_log2(tail);
    best = ${one} - ${taylor_bias};
    for (i = 0; i < 3 && i + 1 < n; i++) {
      at = (log_local + head[i] - tail)*part[top - n + i];
      best = at > best ? at : best;
      at = (log_rate + head[i] - tail)*part[top - n + i + 1];
      best = at > best ? at : best;
    }
    log_h = best < log_h ? best : log_h;
  }
%% end
  return ${name}_taylor_exp2(log_h);
}

static ${name}_real ${name}_taylor_limit(${name}_real size, ${name}_real h)
{
  return size < ${fabs}(h) ? h < ${zero} ? -size : size : h;
}

%% if has_roots then
/* A square root sqrt(u) is not negative; its series is where u vanishes within the step: a speed comes to rest there, and the
 * solution has a corner that the series does not see.  Returns the step that ends just beyond the first such time (what
 * goes wrong in between is the square of ${corner_part} of the step), or h.  Looked for at four points of the step. */
static ${name}_real ${name}_taylor_corner(${name}_real c[][${upper}_ROW], int top, ${name}_real h)
{
  int k, n, i, points;

  for (k = ${upper}_MOVING; k < ${upper}_ROW; k++) {
    ${name}_real low = ${zero}, high = ${zero}, s;

    for (i = 0, points = 4; i < ${corner_halvings}; i++) {
      ${name}_real r = c[top][k];

      s = points > 0 ? low + ${quarter}*h : low + ${half}*(high - low);
      for (n = top - 1; n >= 0; n--) r = c[n][k] + s*r;
      if (r < ${zero}) {
        high = s;
        points = 0;
      } else {
        low = s;
        if (points == 1) break; /* none */
        if (points > 0) points--;
      }
    }
    if (!(high < ${zero} || high > ${zero})) continue;
    s = high + ${corner_part}*h;
    h = ${fabs}(s) < ${fabs}(h) ? s : h;
  }
  return h;
}

/* One step by the classical Runge-Kutta method to y; k1: the rates at its start. */
static void ${name}_taylor_rk4(const ${name}_model *m, ${name}_real t, const ${name}_real x[], const ${name}_real u[], ${name}_real h,
                               ${name}_real y[])
{
  ${name}_real a[${upper}_NX], b[${upper}_NX], c[${upper}_NX], d[${upper}_NX];
  int i;

  ${name}_rhs(m, t, x, u, a);
  for (i = 0; i < ${upper}_NX; i++) y[i] = x[i] + ${half}*h*a[i];
  ${name}_rhs(m, t + ${half}*h, y, u, b);
  for (i = 0; i < ${upper}_NX; i++) y[i] = x[i] + ${half}*h*b[i];
  ${name}_rhs(m, t + ${half}*h, y, u, c);
  for (i = 0; i < ${upper}_NX; i++) y[i] = x[i] + h*c[i];
  ${name}_rhs(m, t + h, y, u, d);
  for (i = 0; i < ${upper}_NX; i++) y[i] = x[i] + h*((a[i] + d[i]) + ${two}*(b[i] + c[i]))/${taylor_six};
}

/* Away from where a root is zero and has no series: behind it the motion is smooth, so the step, h or a quarter of it and so on,
 * is one over which two steps of Runge and Kutta's agree with one to a few roundings.  Returns it. */
static ${name}_real ${name}_taylor_leave(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h)
{
  ${name}_real whole[${upper}_NX], first[${upper}_NX], both[${upper}_NX];
  int i, n, close;

  for (n = 0; n < ${corner_halvings}; n++) {
    h *= ${quarter};
    ${name}_taylor_rk4(m, t, x, u, h, whole);
    ${name}_taylor_rk4(m, t, x, u, ${half}*h, first);
    ${name}_taylor_rk4(m, t + ${half}*h, first, u, ${half}*h, both);
    for (i = 0, close = 1; i < ${upper}_NX; i++)
      close = close && ${fabs}(both[i] - whole[i]) <= ${taylor_leaving}*(${fabs}(both[i]) + ${fabs}(both[i] - x[i]));
    if (close) break;
  }
  for (i = 0; i < ${upper}_NX; i++) x[i] = both[i];
  return h;
}

%% end
/* The order for a tolerance.  Steps grow as tolerance^(1/n) and cost some a + b n + c n^2: the least time to a given end is
 * at n = const - const log(tolerance), const - log(tolerance)/2 with products alone (Jorba, Zou 2005, section 3.1). */
static int ${name}_taylor_top(${name}_real tolerance)
{
%% if taylor_packed then
#if defined ${upper}_PACKED
  const ${name}_real least = ${taylor_least_packed};
#else
  const ${name}_real least = ${taylor_least};
#endif
%% else
  const ${name}_real least = ${taylor_least};
%% end
  const ${name}_real top = least - ${taylor_slope}*${name}_taylor_log2(tolerance);

  return top < (${name}_real)${upper}_ORDER ? top > ${four} ? (int)top : 4 : ${upper}_ORDER;
}

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
%% for _, s in ipairs(taylor_states) do
  x[${s.name}] += d[${s.index}];
%% end
  return h;
}

int ${name}_taylor_run(const ${name}_model *m, ${name}_real t0, ${name}_real x[], const ${name}_real u[], ${name}_real t1, ${name}_real tolerance, int most)
{
  static const int moving[${upper}_MOVING] = {
%% for _, s in ipairs(taylor_states) do
    ${s.name},
%% end
  };
  const ${name}_real finest = ${taylor_finest}, local = tolerance < finest ? tolerance : finest;
  const int top = ${name}_taylor_top(tolerance);
  ${name}_real c[${upper}_ORDER + 1][${upper}_ROW], d[${upper}_ROW], lost[${upper}_MOVING + 1];
  ${name}_real t = t0;
  int steps, k;

  for (k = 0; k <= ${upper}_MOVING; k++) lost[k] = ${zero}*(${name}_real)k; /* 0, and no call of memset */
  for (steps = 0; steps < most; steps++) {
%% if has_knots then
    const ${name}_real end = ${name}_knot(m, t, t1), left = (end - t) - lost[${upper}_MOVING]; /* from corner to corner */
%% else
    const ${name}_real left = (t1 - t) - lost[${upper}_MOVING];
%% end
    ${name}_real h, next_t;

    if (!(left > ${zero} || left < ${zero})) return steps;
    ${name}_taylor_terms(m, t, x, u, top, c${taylor_before_end});
%% if has_roots then
    if (${name}_taylor_lost(c, top, ${zero})) {
      h = ${name}_taylor_leave(m, t, x, u, left);
      if (!(t + h > t || t + h < t)) return -1;
      t += h;
      for (k = 0; k <= ${upper}_MOVING; k++) lost[k] = ${zero};
      continue;
    }
%% end
    h = ${name}_taylor_limit(${name}_taylor_size(c, top, local, tolerance/(t1 - t0)), left);
%% if has_roots then
    h = ${name}_taylor_corner(c, top, h);
%% end
    if (!(h > ${zero} || h < ${zero})) return -1;
    ${name}_taylor_step_by(m, c, top, h, x, d);
    for (k = 0; k < ${upper}_MOVING; k++) { /* Kahan: what rounding took from the last sum is in the next one */
      const ${name}_real add = d[k] + lost[k], sum = c[0][k] + add;

      if (!(sum - sum == ${zero})) return -1;
      lost[k] = add - (sum - c[0][k]);
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
