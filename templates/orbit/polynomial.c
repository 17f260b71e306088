%% -- polynomial.c -- a series in multiple angles as a polynomial: part of scene.c.  SPDX-License-Identifier: MIT-0
/* c[0] + c[1] y[1] + ...: a series in multiple angles, y[n+1] = 2 X y[n] - y[n-1], as a polynomial in X; y[0] = 1 and
 * y[1] = first + slope X */
static void ${name}_polynomial(int n, const ${name}_real c[], ${name}_real first, ${name}_real slope, ${name}_real out[])
{
  ${name}_real even[5] = {${one}, ${zero}, ${zero}, ${zero}, ${zero}}, odd[5] = {first, slope, ${zero}, ${zero}, ${zero}};
  for (int k = 0; k < n; k++) out[k] = k == 0 ? c[0] : ${zero};
  for (int i = 1; i < n; i++) {
    ${name}_real *const y = i % 2 ? odd : even, *const other = i % 2 ? even : odd; /* other: y[i-1], y[i+1] */
    for (int k = 0; k <= i; k++) out[k] += c[i]*y[k];
    for (int k = 0; k < 5; k++) other[k] = (k > 0 ? ${two}*y[k - 1] : ${zero}) - other[k];
  }
}
