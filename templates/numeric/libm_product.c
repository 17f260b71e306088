%% -- libm_product.c -- exact products: part of scene.c.  SPDX-License-Identifier: MIT-0
%% if need.product then
/* a*b = hi + lo exactly: Dekker 1971, Numer. Math. 18, 224 */
static ${name}_real ${name}_libm_product(${name}_real a, ${name}_real b, ${name}_real *lo)
{
  const ${name}_real c = ${split}*a, ah = c - (c - a), al = a - ah;
  const ${name}_real d = ${split}*b, bh = d - (d - b), bl = b - bh;
  const ${name}_real hi = a*b;

  *lo = ((ah*bh - hi) + ah*bl + al*bh) + al*bl;
  return hi;
}

%% end
