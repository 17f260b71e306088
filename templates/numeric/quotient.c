%% -- quotient.c -- division of pairs: part of scene.c.  SPDX-License-Identifier: MIT-0
/* a/b for b not 0: the remainder of a first quotient is formed in pairs */
static ${name}_pair ${name}_ratio(${name}_pair a, ${name}_pair b)
{
  const ${name}_real q = a.hi/b.hi;
  const ${name}_pair r = ${name}_add(a, ${name}_minus(${name}_mul(${name}_pair_of(q), b)));

  return ${name}_pair_sum(q, r.hi/b.hi);
}
