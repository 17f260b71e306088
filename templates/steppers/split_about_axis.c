%% -- split_about_axis.c -- a turn about an axis of the body: part of scene.c.  SPDX-License-Identifier: MIT-0
/* About the body's axis i by twice the angle a; j and k follow i in cyclic order.  1 - cos is added apart, so that the
 * length of (w[j], w[k]) does not creep. */
static void ${name}_split_about(${name}_real x[], int i, int j, int k, ${name}_real a)
{
  ${name}_real *w = x + ${upper}_WX;
  const ${name}_real y = w[j], z = w[k];
  ${name}_real c, s, v;
%% if has_attitude then
  ${name}_real *q = x + ${upper}_QX;
  const ${name}_real qw = x[${upper}_QW], qi = q[i], qj = q[j], qk = q[k];
%% end

  ${name}_split_half(a*a, &c, &s);
  s *= a;
%% if has_attitude then
  x[${upper}_QW] = c*qw - s*qi;
  q[i] = c*qi + s*qw;
  q[j] = c*qj + s*qk;
  q[k] = c*qk - s*qj;
%% else
  (void)i;
%% end
  v = ${two}*s*s;
  s *= ${two}*c;
  w[j] = y + (s*z - v*y);
  w[k] = z - (s*y + v*z);
}
