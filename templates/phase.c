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

#if defined __GNUC__
#define ${upper}_INLINE static inline __attribute__((always_inline)) /* GCC and Clang vectorise what they inline */
#else
#define ${upper}_INLINE static inline
#endif

/* the nearest integer, to even; beyond 2^51 (float: 2^22) one of the nearest even ones, which serves as well */
${upper}_INLINE ${name}_real ${name}_nearest(${name}_real x)
{
  return (x + ${round_off}) - ${round_off};
}

/* sin and cos of 2 pi x, |x| <= 1/2 and a little: those of the half, economised series, and one doubling */
${upper}_INLINE void ${name}_circle(${name}_real x, ${name}_real *sine, ${name}_real *cosine)
{
  const ${name}_real u = x*x, u2 = u*u, u4 = u2*u2;
%% for _, line in ipairs(sine_lines) do
  ${line}
%% end
%% for _, line in ipairs(cosine_lines) do
  ${line}
%% end
  const ${name}_real half = x*s;

  *sine = ${two}*(half*c);
  *cosine = (c - half)*(c + half);
}

/* a + b t in pairs: Knuth's two-sum, Dekker's product */
${upper}_INLINE ${name}_pair ${name}_phase(${name}_pair a, const ${name}_real b[2], ${name}_real t)
{
  ${name}_pair p;
  ${name}_real sum, part;
#if defined ${fast_fma} || defined __${fast_fma} || defined __FMA__ || defined __ARM_FEATURE_FMA

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
