%% -- split_turn.c -- turns of the attitude: part of scene.c.  SPDX-License-Identifier: MIT-0
/* q = q (c, e), of which c is c1 less than 1: what is added to q is rounded once, with it.  c q by itself would be rounded to
 * a whole step of the last place where c is next to 1, more of a small mantissa than of a large one: a turn, always the
 * same way. */
static void ${name}_split_turn(${name}_real x[], ${name}_real c1, const ${name}_real e[3])
{
  const ${name}_real w = x[${upper}_QW], a = x[${upper}_QX], b = x[${upper}_QY], d = x[${upper}_QZ];

  x[${upper}_QW] = w - (c1*w + e[0]*a + e[1]*b + e[2]*d);
  x[${upper}_QX] = a - (c1*a - e[0]*w - e[2]*b + e[1]*d);
  x[${upper}_QY] = b - (c1*b - e[1]*w - e[0]*d + e[2]*a);
  x[${upper}_QZ] = d - (c1*d - e[2]*w - e[1]*a + e[0]*b);
}

/* About L by the angle |p| tau, p = L/I: L stays.  over: what |q| is over 1, and is less by afterwards. */
static void ${name}_split_along(${name}_real x[], const ${name}_real p[3], ${name}_real tau, ${name}_real over)
{
  const ${name}_real half = ${half}*tau;
  ${name}_real e[3], c, s;

  e[0] = half*p[0];
  e[1] = half*p[1];
  e[2] = half*p[2];
  ${name}_split_half(e[0]*e[0] + e[1]*e[1] + e[2]*e[2], &c, &s);
  s *= ${one} - over;
  e[0] *= s;
  e[1] *= s;
  e[2] *= s;
  ${name}_split_turn(x, (${one} - c) + over*c, e);
}
