%% -- split_full.c -- free flow, axes and moments of any kind: part of scene.c.  SPDX-License-Identifier: MIT-0
/* The free body over a time tau, with p = L/Ia in the place of the rates: the rotation about L, and those about two axes
 * n times in turn */
static void ${name}_split_drift(const ${name}_model *m, ${name}_real x[], ${name}_real tau, int n, const ${name}_real a[], const ${name}_real b[])
{
  ${name}_real *w = x + ${upper}_WX;
  const ${name}_real *u = m->split_u, *d = m->split_d, *k = m->split_b, *l = m->split_c;
  const ${name}_real half = ${half}*tau;
%% if has_attitude then
  /* one Newton step for 1/|q|, from the q that comes in, so |q| cannot drift */
  const ${name}_real over = ${half}*(x[${upper}_QW]*x[${upper}_QW] + x[${upper}_QX]*x[${upper}_QX] + x[${upper}_QY]*x[${upper}_QY] + x[${upper}_QZ]*x[${upper}_QZ]) - ${half};
%% end
  ${name}_real w0[3], p0[3];

  /* p = U^T D U w */
  for (int i = 0; i < 3; i++) w0[i] = w[i];
  w[0] += u[0]*w[1] + u[1]*w[2];
  w[1] += u[2]*w[2];
  for (int i = 0; i < 3; i++) w[i] *= d[i];
  w[2] += u[1]*w[0] + u[2]*w[1];
  w[1] += u[0]*w[0];
  for (int i = 0; i < 3; i++) p0[i] = w[i];
%% if has_attitude then
  ${name}_split_along(x, w, tau, over);
%% end
  for (int i = 0; i <= n; i++) {
    ${name}_split_about(x, k, a[i]*half*(m->split_fb*(k[0]*w[0] + k[1]*w[1] + k[2]*w[2])));
    if (i < n) ${name}_split_about(x, l, b[i]*half*(m->split_fc*(l[0]*w[0] + l[1]*w[1] + l[2]*w[2])));
  }
  /* the same steps back, for the change */
  for (int i = 0; i < 3; i++) w[i] -= p0[i];
  w[1] -= u[0]*w[0];
  w[2] -= u[1]*w[0] + u[2]*w[1];
  for (int i = 0; i < 3; i++) w[i] /= d[i];
  w[1] -= u[2]*w[2];
  w[0] -= u[0]*w[1] + u[1]*w[2];
  for (int i = 0; i < 3; i++) w[i] += w0[i];
%% for _, line in ipairs(place) do
  ${line}
%% end
}
