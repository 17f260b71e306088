%% -- phase.c -- phases in pairs, quaternions, series as polynomials: part of scene.c.  SPDX-License-Identifier: MIT-0
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

/* a + b t in pairs: Knuth's two-sum, Dekker's product */
${upper}_INLINE ${name}_pair ${name}_phase(${name}_pair a, const ${name}_real b[2], ${name}_real t)
{
  ${name}_pair p;
  ${name}_real sum, part;
#if defined ${fast_fma} || defined __${fast_fma} || defined __FMA__ || (defined __ARM_FEATURE_FMA && (__ARM_FP & ${arm_fma}))

  p.hi = ${fma}(b[0], t, ${zero}); /* no compiler may fuse this one */
  p.lo = ${fma}(b[0], t, -p.hi);
#else
  const ${name}_real c = ${split}*b[0], high = c - (c - b[0]), low = b[0] - high;
  const ${name}_real d = ${split}*t, head = d - (d - t), tail = t - head;

  p.hi = b[0]*t;
  p.lo = ((high*head - p.hi) + high*tail + low*head) + low*tail;
#endif
  sum = p.hi + a.hi;
  part = sum - p.hi;
  p.lo = ((p.hi - (sum - part)) + (a.hi - part)) + (p.lo + b[1]*t + a.lo);
  p.hi = sum;
  return p;
}
