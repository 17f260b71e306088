%% -- split_oblique.c -- free flow, symmetric about any axis: part of scene.c.  SPDX-License-Identifier: MIT-0
/* The free body over a time tau */
static void ${name}_split_drift(const ${name}_model *m, ${name}_real x[], ${name}_real tau, ${name}_real over)
{
  ${name}_real *w = x + ${upper}_WX;
  const ${name}_real k[3] = {${kx}, ${ky}, ${kz}};
  const ${name}_real spin = ${c}*(k[0]*w[0] + k[1]*w[1] + k[2]*w[2]) + ${h};
%% if has_attitude then
  ${name}_real p[3];

  for (int i = 0; i < 3; i++) p[i] = w[i] + spin*k[i];
  ${name}_split_along(x, p, tau, over);
%% end
  ${name}_split_about(x, k, -${half}*tau*spin);
  (void)m;
%% if not has_attitude then
  (void)over;
%% end
%% for _, line in ipairs(place) do
  ${line}
%% end
}
