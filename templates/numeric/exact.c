%% -- exact.c -- sums of products without rounding: part of scene.c.  SPDX-License-Identifier: MIT-0
/* ---- sums of products as numbers that do not overlap, ascending: no digit is lost, so the sign is
 * right near equality, too (Shewchuk 1997, Discrete Comput. Geom. 18, 305) ---- */

/* e[0..n) += b; the new n */
static int ${name}_exact_add(${name}_real e[], int n, ${name}_real b)
{
  int k = 0;
  for (int i = 0; i < n; i++) {
    const ${name}_pair s = ${name}_pair_sum(b, e[i]);
    if (s.lo < ${zero} || s.lo > ${zero}) e[k++] = s.lo;
    b = s.hi;
  }
  if (b < ${zero} || b > ${zero}) e[k++] = b;
  return k;
}

/* e[0..n) += a*b; the new n */
static int ${name}_exact_product(${name}_real e[], int n, ${name}_real a, ${name}_real b)
{
  const ${name}_pair p = ${name}_pair_product(a, b);
  return ${name}_exact_add(e, ${name}_exact_add(e, n, p.lo), p.hi);
}
