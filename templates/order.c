%% -- order.c -- the signs of differences of moments from the parameters: part of scene.c.  SPDX-License-Identifier: MIT-0
%% if order_sums then
/* ---- exact signs ----
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

/* The sign of a sum of `rows` products of `columns` factors f, row by row.  Rows are scaled by one power of two, so that
 * the largest does not overflow; what is smaller by 2^-${order_range} times is lost. */
static int ${name}_sign_of_sum(int rows, int columns, const ${name}_real f[])
{
  ${name}_real sum[${order_terms}], p[${order_factors}], q[${order_factors}];
  int n = 0, most = 0, first = 1, r, c, i, k, np, nq, power;

  for (r = 0; r < rows; r++) { /* the largest row's exponent */
    int total = 0, zero = 0;

    for (c = 0; c < columns; c++) {
      if (!(f[r*columns + c] < ${zero} || f[r*columns + c] > ${zero})) zero = 1;
      (void)${frexp}(f[r*columns + c], &power);
      total += power;
    }
    if (!zero && (first || total > most)) {
      most = total;
      first = 0;
    }
  }
  for (r = 0; r < rows; r++) {
    int total = ${order_top} - most;

    for (c = 0; c < columns; c++) {
      (void)${frexp}(f[r*columns + c], &power);
      total += power;
    }
    p[0] = ${ldexp}(${one}, total);
    np = 1;
    for (c = 0; c < columns; c++) {
      const ${name}_real factor = ${frexp}(f[r*columns + c], &power);

      for (nq = 0, i = 0; i < np; i++) nq = ${name}_exact_product(q, nq, p[i], factor);
      for (np = nq, k = 0; k < np; k++) p[k] = q[k];
    }
    for (i = 0; i < np; i++) n = ${name}_exact_add(sum, n, p[i]);
  }
  return n == 0 ? 0 : sum[n - 1] > ${zero} ? 1 : -1;
}

%% end
/* Which principal moments are larger: the signs of differences of moments, see ${name}_spin_stable. */
static void ${name}_order(const ${name}_real p[], int order[3])
{
%% for _, line in ipairs(order_lines) do
%%   if line == "" then

%%   else
  ${line}
%%   end
%% end
}
