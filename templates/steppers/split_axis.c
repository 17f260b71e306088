%% -- split_axis.c -- free flow, symmetric about an axis of the frame: part of scene.c.  SPDX-License-Identifier: MIT-0
/* The free body over a time tau */
static void ${name}_split_drift(const ${name}_model *m, ${name}_real x[], ${name}_real tau, ${name}_real over)
{
  ${name}_real *w = x + ${upper}_WX;
  const ${name}_real spin = ${c}*w[${i}] + ${h}; /* |L|/I1 along the axis less the rate */
%% if has_attitude then
  ${name}_real p[3];

  p[0] = w[0];
  p[1] = w[1];
  p[2] = w[2];
  p[${i}] += spin;
  ${name}_split_along(x, p, tau, over);
%% end
  ${name}_split_about(x, ${i}, ${j}, ${k}, -${half}*tau*spin);
  (void)m;
%% if not has_attitude then
  (void)over;
%% end
%% for _, line in ipairs(place) do
  ${line}
%% end
}
