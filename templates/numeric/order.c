%% -- order.c -- the signs of differences of moments from the parameters: part of scene.c.  SPDX-License-Identifier: MIT-0
%% if sums then
/* The sign of a sum of `rows` products of `columns` factors f, row by row.  Rows are scaled by one power of two, so that
 * the largest does not overflow; what is smaller by 2^-${range} times is lost. */
static int ${name}_sign_of_sum(int rows, int columns, const ${name}_real f[])
{
  ${name}_real sum[${terms}], space[2][${factors}], *p = space[0], *q = space[1];
  int n = 0, most = 0, first = 1, i, np, nq, power;

  for (int r = 0; r < rows; r++) { /* the largest row's exponent */
    int total = 0, zero = 0;

    for (int c = 0; c < columns; c++) {
      if (!(f[r*columns + c] < ${zero} || f[r*columns + c] > ${zero})) zero = 1;
      (void)${frexp}(f[r*columns + c], &power);
      total += power;
    }
    if (!zero && (first || total > most)) {
      most = total;
      first = 0;
    }
  }
  for (int r = 0; r < rows; r++) {
    int total = ${top} - most;

    for (int c = 0; c < columns; c++) {
      (void)${frexp}(f[r*columns + c], &power);
      total += power;
    }
    p[0] = ${ldexp}(${one}, total);
    np = 1;
    for (int c = 0; c < columns; c++) {
      const ${name}_real factor = ${frexp}(f[r*columns + c], &power);
      ${name}_real *const before = p;

      for (nq = 0, i = 0; i < np; i++) nq = ${name}_exact_product(q, nq, p[i], factor);
      p = q;
      q = before;
      np = nq;
    }
    for (i = 0; i < np; i++) n = ${name}_exact_add(sum, n, p[i]);
  }
  return n == 0 ? 0 : sum[n - 1] > ${zero} ? 1 : -1;
}

%% end
/* Which principal moments are larger: the signs of differences of moments, see ${name}_spin_stable. */
%% if proof then
/*@ assigns order[0 .. 2] \from p[0 .. ${upper}_NP - 1];
    ensures \initialized(order + (0 .. 2));
    ensures \forall int i; 0 <= i < 3 ==> -1 <= order[i] <= 1; */
%% end
static void ${name}_sort_moments(const ${name}_real p[], int order[3])
{
%% for _, line in ipairs(lines) do
  ${line}
%% end
}
