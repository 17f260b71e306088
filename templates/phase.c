%% -- phase.c -- phases in pairs, their sines and cosines, quaternions: part of scene.c.  SPDX-License-Identifier: MIT-0
static void ${name}_quaternion_product(const ${name}_real a[4], const ${name}_real b[4], ${name}_real out[4])
{
  out[0] = a[0]*b[0] - a[1]*b[1] - a[2]*b[2] - a[3]*b[3];
  out[1] = a[0]*b[1] + a[1]*b[0] + a[2]*b[3] - a[3]*b[2];
  out[2] = a[0]*b[2] - a[1]*b[3] + a[2]*b[0] + a[3]*b[1];
  out[3] = a[0]*b[3] + a[1]*b[2] - a[2]*b[1] + a[3]*b[0];
}

/* c[0] + c[1] y[1] + ...: a series in multiple angles, y[n+1] = 2 X y[n] - y[n-1], as a polynomial in X; y[0] = 1 and
 * y[1] = first + slope X */
static void ${name}_polynomial(int n, const ${name}_real c[], ${name}_real first, ${name}_real slope, ${name}_real out[])
{
  ${name}_real before[5] = {${one}, ${zero}, ${zero}, ${zero}, ${zero}};
  ${name}_real now[5] = {first, slope, ${zero}, ${zero}, ${zero}}, next[5];
  int i, k;

  for (k = 0; k < n; k++) out[k] = k == 0 ? c[0] : ${zero};
  for (i = 1; i < n; i++) {
    for (k = 0; k <= i; k++) out[k] += c[i]*now[k];
    for (k = 0; k < 5; k++) next[k] = (k > 0 ? ${two}*now[k - 1] : ${zero}) - before[k];
    for (k = 0; k < 5; k++) {
      before[k] = now[k];
      now[k] = next[k];
    }
  }
}

/* the nearest integer, to even; beyond 2^51 (float: 2^22) one of the nearest even ones, which serves as well */
static ${name}_real ${name}_nearest(${name}_real x)
{
  return (x + ${round_off}) - ${round_off};
}

/* sin and cos of pi x, |x| <= 1/2: their series at half of it, and one doubling; no call, so that loops are vectorised */
static void ${name}_sincos(${name}_real x, ${name}_real *s, ${name}_real *c)
{
  const ${name}_real y = ${half}*${pi_high}*x, u = y*y;
%% if single then
  const ${name}_real a = y*(${one} - u*(${one}/6.0F - u*(${one}/120.0F - u*(${one}/5040.0F - u*(${one}/362880.0F)))));
  const ${name}_real b = ${one} - u*(${half} - u*(${one}/24.0F - u*(${one}/720.0F - u*(${one}/40320.0F))));
%% else
  const double u2 = u*u, u4 = u2*u2; /* Horner's rule in two halves, which run side by side */
  const double a0 = 1.0 - u*(1.0/6.0) + u2*(1.0/120.0 - u*(1.0/5040.0));
  const double a1 = 1.0/362880.0 - u*(1.0/39916800.0) + u2*(1.0/6227020800.0 - u*(1.0/1307674368000.0) + u2*(1.0/355687428096000.0));
  const double b0 = 1.0 - u*0.5 + u2*(1.0/24.0 - u*(1.0/720.0));
  const double b1 = 1.0/40320.0 - u*(1.0/3628800.0) + u2*(1.0/479001600.0 - u*(1.0/87178291200.0) + u2*(1.0/20922789888000.0));
  const double a = y*(a0 + u4*a1), b = b0 + u4*b1;
%% end

  *s = ${two}*(a*b);
  *c = (b - a)*(b + a);
}

/* a + b t in pairs */
static ${name}_pair ${name}_phase(${name}_pair a, const ${name}_real b[2], ${name}_real t)
{
  const ${name}_pair p = ${name}_pair_product(b[0], t), s = ${name}_pair_sum(p.hi, a.hi);
  ${name}_pair phase;

  phase.hi = s.hi;
  phase.lo = s.lo + (p.lo + b[1]*t + a.lo);
  return phase;
}
