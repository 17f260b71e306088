%% -- taylor_transition.c -- the transition matrix of the Taylor step: part of scene.c.  SPDX-License-Identifier: MIT-0
/* The coefficients of the states that move and, after them, of what neighbours along v depart by: v' = f'(x) v, the
 * variational equations, whose series is the derivative of the series (Hairer, Norsett, Wanner I, section I.14).
%% if has_inputs then
 * v has NX numbers of the states and then NU of the inputs.
%% end
 */
static void ${name}_taylor_tangent(const ${name}_model *m, ${name}_real t, const ${name}_real x[], const ${name}_real v[],
                       const ${name}_real u[], ${name}_real c[][${count}]${side})
{
%% if has_lanes then
  ${name}_real a[${upper}_ORDER + 1][${lanes}], b[${upper}_ORDER + 1][${lanes}], p[${lanes}];
%% end
  ${name}_real y[${places}];
%% for _, line in ipairs(outer) do
  ${line}
%% end

%% for _, line in ipairs(voids) do
  ${line}
%% end
%% for _, line in ipairs(start) do
  ${line}
%% end
  for (int n = 0; n < ${count}; n++) c[0][n] = y[n];
%% for _, level in ipairs(levels) do
%%   for _, lane in ipairs(level.lanes) do
  a[0][${lane.index}] = ${lane.first};
  b[0][${lane.index}] = ${lane.right};
%%   end
%% end
  {
%% for _, line in ipairs(next) do
    ${line}
%% end
  }
  for (int n = 0; n < ${count}; n++) c[1][n] = y[n];

  for (int n = 1; n < ${upper}_ORDER; n++) {
    const ${name}_real after = ${one}/(${name}_real)(n + 1);
%% if uses_order then
    const ${name}_real order = (${name}_real)n;
%% end
%% for _, line in ipairs(loads) do
    ${line}
%% end

%% for _, level in ipairs(levels) do
%%   if level.has_lanes then
%%     for _, z in ipairs(level.unknown) do
    y[${z}] = ${zero};
%%     end
%%     for _, lane in ipairs(level.lanes) do
    a[n][${lane.index}] = ${lane.left}; /* ${lane.about} */
    b[n][${lane.index}] = ${lane.right};
%%     end
    for (int l = ${level.first}; l < ${level.last}; l++) p[l] = a[0][l]*b[n][l];
    for (int j = 1; j <= n; j++) {
      for (int l = ${level.first}; l < ${level.last}; l++) p[l] += a[j][l]*b[n - j][l];
    }
%%   end
%%   for _, line in ipairs(level.lines) do
    ${line}
%%   end
%%   for _, line in ipairs(level.known) do
    ${line}
%%   end
%% end
%% for _, line in ipairs(after) do
    ${line}
%% end
    for (int i = 0; i < ${count}; i++) c[n + 1][i] = y[i];
  }
}

/* v at the end of a step of size h from v at its start, and with it what the step does to keep |q| = 1:
 * q1 = (3/2 - |q|^2/2) q(h), so v1 = (3/2 - |q|^2/2) v(h) - (q.v) q(h). */
static void ${name}_taylor_along(${name}_real c[][${count}], ${name}_real h, ${name}_real v[])
{
  ${name}_real s[${count}];
%% if attitude then
  const ${name}_real *q = c[0], *w = c[0] + ${upper}_MOVING;
  const ${name}_real k = ${threehalves} - ${half}*(q[0]*q[0] + q[1]*q[1] + q[2]*q[2] + q[3]*q[3]);
  const ${name}_real d = q[0]*w[0] + q[1]*w[1] + q[2]*w[2] + q[3]*w[3];
%% end

  for (int i = 0; i < ${count}; i++) {
    s[i] = c[${upper}_ORDER][i];
    for (int n = ${upper}_ORDER - 1; n >= 0; n--) s[i] = c[n][i] + h*s[i];
  }
%% if attitude then
  for (int i = 0; i < 4; i++) s[${upper}_MOVING + i] = k*s[${upper}_MOVING + i] - d*s[i];
%% end
%% for _, s in ipairs(tangents) do
  v[${s.name}] = s[${s.along}];
%% end
}

%% if shift then
/* The step's frame turns by g s |q|^2, g = L/I2, and its own derivative where |q| changes has that, too: h q (0, g). */
static void ${name}_taylor_longer(const ${name}_model *m, const ${name}_real x[], const ${name}_real q0[4], ${name}_real h, ${name}_real F[])
{
%%   for _, line in ipairs(frame.loads) do
  ${line}
%%   end
%%   for _, line in ipairs(frame.lines) do
  ${line}
%%   end
  const ${name}_real *q = x + ${upper}_QW;
  const ${name}_real d[4] = {-q[1]*gx - q[2]*gy - q[3]*gz, q[0]*gx + q[2]*gz - q[3]*gy,
                       q[0]*gy - q[1]*gz + q[3]*gx, q[0]*gz + q[1]*gy - q[2]*gx};

  (void)m;
  for (int i = 0; i < 4; i++) {
    for (int k = 0; k < 4; k++) F[i*${upper}_NX + k] += h*d[i]*q0[k];
  }
}

%% end
void ${name}_taylor_step_transition(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h, ${name}_real F[])
{
%% if has_inputs then
  ${name}_real c[${upper}_ORDER + 1][${count}], v[${upper}_NX + ${upper}_NU];
%% else
  ${name}_real c[${upper}_ORDER + 1][${count}], v[${upper}_NX];
%% end
%% if has_knots then
  const ${name}_real end = t + h;
  ${name}_real stop, part;
%% end
%% if shift then
  const ${name}_real q[4] = {x[${upper}_QW], x[${upper}_QX], x[${upper}_QY], x[${upper}_QZ]};
%% end

  for (int i = 0; i < ${upper}_NX*${upper}_NX; i++) F[i] = i % (${upper}_NX + 1) == 0 ? ${one} : ${zero};
%% if has_knots then
  for (int n = 0; n <= ${knots_count}; n++) { /* from corner to corner */
    stop = ${name}_knot(m, t, end);
    part = stop < end || stop > end ? stop - t : h;
    for (int k = 0; k < ${upper}_NX; k++) {
%% if has_inputs then
      for (int i = 0; i < ${upper}_NX + ${upper}_NU; i++) v[i] = i < ${upper}_NX ? F[i*${upper}_NX + k] : ${zero};
%% else
      for (int i = 0; i < ${upper}_NX; i++) v[i] = F[i*${upper}_NX + k];
%% end
      ${name}_taylor_tangent(m, t, x, v, u, c, t + ${half}*part);
      ${name}_taylor_along(c, part, v);
      for (int i = 0; i < ${upper}_NX; i++) F[i*${upper}_NX + k] = v[i];
    }
    ${name}_taylor_step(m, t, x, u, part);
    t = stop;
    h -= part;
    if (!(stop < end || stop > end)) break;
  }
%% else
  for (int k = 0; k < ${upper}_NX; k++) {
%% if has_inputs then
    for (int i = 0; i < ${upper}_NX + ${upper}_NU; i++) v[i] = i < ${upper}_NX ? F[i*${upper}_NX + k] : ${zero};
%% else
    for (int i = 0; i < ${upper}_NX; i++) v[i] = F[i*${upper}_NX + k];
%% end
    ${name}_taylor_tangent(m, t, x, v, u, c);
    ${name}_taylor_along(c, h, v);
    for (int i = 0; i < ${upper}_NX; i++) F[i*${upper}_NX + k] = v[i];
  }
  ${name}_taylor_step(m, t, x, u, h);
%% end
%% if shift then
  ${name}_taylor_longer(m, x, q, h, F);
%% end
}
%% if has_inputs then

void ${name}_taylor_step_transition_u(const ${name}_model *m, ${name}_real t, const ${name}_real x[], const ${name}_real u[], ${name}_real h, ${name}_real G[])
{
  ${name}_real c[${upper}_ORDER + 1][${count}], v[${upper}_NX + ${upper}_NU];

  for (int k = 0; k < ${upper}_NU; k++) {
%%   if has_knots then
    const ${name}_real end = t + h;
    ${name}_real y[${upper}_NX], now = t, left = h, stop, part;

    for (int i = 0; i < ${upper}_NX; i++) y[i] = x[i];
%%   end
    for (int i = 0; i < ${upper}_NX + ${upper}_NU; i++) v[i] = i == ${upper}_NX + k ? ${one} : ${zero};
%%   if has_knots then
    for (int n = 0; n <= ${knots_count}; n++) { /* from corner to corner */
      stop = ${name}_knot(m, now, end);
      part = stop < end || stop > end ? stop - now : left;
      ${name}_taylor_tangent(m, now, y, v, u, c, now + ${half}*part);
      ${name}_taylor_along(c, part, v);
      ${name}_taylor_step(m, now, y, u, part);
      now = stop;
      left -= part;
      if (!(stop < end || stop > end)) break;
    }
%%   else
    ${name}_taylor_tangent(m, t, x, v, u, c);
    ${name}_taylor_along(c, h, v);
%%   end
    for (int i = 0; i < ${upper}_NX; i++) G[i*${upper}_NU + k] = v[i];
  }
}
%% end
%% if first then

void ${name}_step_transition(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h, ${name}_real F[])
{
  ${name}_taylor_step_transition(m, t, x, u, h, F);
}
%%   if has_inputs then

void ${name}_step_transition_u(const ${name}_model *m, ${name}_real t, const ${name}_real x[], const ${name}_real u[], ${name}_real h, ${name}_real G[])
{
  ${name}_taylor_step_transition_u(m, t, x, u, h, G);
}
%%   end
%% end
