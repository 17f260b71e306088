%% -- split_about.c -- a turn about any axis: part of scene.c.  SPDX-License-Identifier: MIT-0
/* About the axis k, a unit vector, by twice the angle a, in the sense of ${name}_split_along; 1 - cos is added apart, so
 * that the length of w does not creep. */
static void ${name}_split_about(${name}_real x[], const ${name}_real k[3], ${name}_real a)
{
  ${name}_real *w = x + ${upper}_WX;
  ${name}_real e[3], f[3], c, s;

  for (int i = 0; i < 3; i++) e[i] = a*k[i];
  ${name}_split_half(e[0]*e[0] + e[1]*e[1] + e[2]*e[2], &c, &s);
  for (int i = 0; i < 3; i++) e[i] *= s;
%% if has_attitude then
  ${name}_split_turn(x, ${one} - c, e);
%% end
  /* w -= 2 e x (c w - e x w) */
  f[0] = c*w[0] - (e[1]*w[2] - e[2]*w[1]);
  f[1] = c*w[1] - (e[2]*w[0] - e[0]*w[2]);
  f[2] = c*w[2] - (e[0]*w[1] - e[1]*w[0]);
  w[0] -= ${two}*(e[1]*f[2] - e[2]*f[1]);
  w[1] -= ${two}*(e[2]*f[0] - e[0]*f[2]);
  w[2] -= ${two}*(e[0]*f[1] - e[1]*f[0]);
}
