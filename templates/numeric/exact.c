%% -- exact.c -- sums of products without rounding: part of scene.c.  SPDX-License-Identifier: MIT-0
/* ---- exact sums ----
 * A sum of products of numbers as numbers that do not overlap, ascending: no digit is lost, so near equality the sign is
 * right (Shewchuk 1997, Discrete Comput. Geom. 18, 305; products: Dekker 1971, Numer. Math. 18, 224). */

/* e[0..n) += b; the new n */
static int ${name}_exact_add(${name}_real e[], int n, ${name}_real b)
{
  int i, k = 0;

  for (i = 0; i < n; i++) {
    const ${name}_real s = b + e[i], v = s - b, low = (b - (s - v)) + (e[i] - v);

    if (low < ${zero} || low > ${zero}) e[k++] = low;
    b = s;
  }
  if (b < ${zero} || b > ${zero}) e[k++] = b;
  return k;
}

/* e[0..n) += a*b; volatile keeps compilers from fusing the products into sums */
static int ${name}_exact_product(${name}_real e[], int n, ${name}_real a, ${name}_real b)
{
  const ${name}_real split = ${split};
  const volatile ${name}_real ca = split*a, cb = split*b, p = a*b;
  const ${name}_real c = ca, ah = c - (c - a), al = a - ah;
  const ${name}_real d = cb, bh = d - (d - b), bl = b - bh;
  const ${name}_real high = p;

  n = ${name}_exact_add(e, n, ((ah*bh - high) + ah*bl + al*bh) + al*bl);
  return ${name}_exact_add(e, n, high);
}
