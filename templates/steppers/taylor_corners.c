%% -- taylor_corners.c -- steps that end where a square root vanishes: part of scene.c.  SPDX-License-Identifier: MIT-0
/* A square root sqrt(u) is not negative; its series is where u vanishes within the step: a speed comes to rest there, and the
 * solution has a corner that the series does not see.  Returns the step that ends just beyond the first such time (what
 * goes wrong in between is the square of ${corner_part} of the step), or h.  Looked for at four points of the step. */
static ${name}_real ${name}_taylor_corner(${name}_real c[][${upper}_ROW], int top, ${name}_real h)
{
  int i, points;

  for (int k = ${upper}_MOVING; k < ${upper}_ROW; k++) {
    ${name}_real low = ${zero}, high = ${zero}, s;

    for (i = 0, points = 4; i < ${corner_halvings}; i++) {
      ${name}_real r = c[top][k];

      s = points > 0 ? low + ${quarter}*h : low + ${half}*(high - low);
      for (int n = top - 1; n >= 0; n--) r = c[n][k] + s*r;
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

  ${name}_rhs(m, t, x, u, a);
  for (int i = 0; i < ${upper}_NX; i++) y[i] = x[i] + ${half}*h*a[i];
  ${name}_rhs(m, t + ${half}*h, y, u, b);
  for (int i = 0; i < ${upper}_NX; i++) y[i] = x[i] + ${half}*h*b[i];
  ${name}_rhs(m, t + ${half}*h, y, u, c);
  for (int i = 0; i < ${upper}_NX; i++) y[i] = x[i] + h*c[i];
  ${name}_rhs(m, t + h, y, u, d);
  for (int i = 0; i < ${upper}_NX; i++) y[i] = x[i] + h*((a[i] + d[i]) + ${two}*(b[i] + c[i]))/${six};
}

/* Away from where a root is zero and has no series: behind it the motion is smooth, so the step, h or a quarter of it and so on,
 * is one over which two steps of Runge and Kutta's agree with one to a few roundings.  Returns it; 0, and x as it is, where
 * the rates are not finite. */
static ${name}_real ${name}_taylor_leave(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h)
{
  ${name}_real whole[${upper}_NX], first[${upper}_NX], both[${upper}_NX];
  int i, close;

  for (int n = 0; n < ${corner_halvings}; n++) {
    h *= ${quarter};
    ${name}_taylor_rk4(m, t, x, u, h, whole);
    ${name}_taylor_rk4(m, t, x, u, ${half}*h, first);
    ${name}_taylor_rk4(m, t + ${half}*h, first, u, ${half}*h, both);
    for (i = 0, close = 1; i < ${upper}_NX; i++)
      close = close && ${fabs}(both[i] - whole[i]) <= ${leaving}*(${fabs}(both[i]) + ${fabs}(both[i] - x[i]));
    if (close) break;
  }
  for (i = 0; i < ${upper}_NX; i++) {
    if (!(both[i] - both[i] == ${zero})) return ${zero};
  }
  for (i = 0; i < ${upper}_NX; i++) x[i] = both[i];
  return h;
}
