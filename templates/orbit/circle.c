%% -- circle.c -- phases in turns, sine and cosine without a call: part of scene.c.  SPDX-License-Identifier: MIT-0
/* ---- phases in turns: no call and no branch, so that loops over times are vectorised ---- */

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

%% if not axial and not lagrange then
/* b t = hi + lo, b high + low with its high part in halves b[2] + b[3], t in halves as well: Dekker's product */
${upper}_INLINE ${name}_pair ${name}_passed(const ${name}_real b[4], ${name}_real t, ${name}_real head, ${name}_real tail)
{
  ${name}_pair p;

#if defined ${fast_fma} || defined __${fast_fma} || defined __FMA__ || (defined __ARM_FEATURE_FMA && (__ARM_FP & ${arm_fma}))
  (void)head;
  (void)tail;
  p.hi = ${fma}(b[0], t, ${zero}); /* no compiler may fuse this one */
  p.lo = ${fma}(b[0], t, -p.hi) + b[1]*t;
#else
  p.hi = b[0]*t;
  p.lo = (((b[2]*head - p.hi) + b[2]*tail + b[3]*head) + b[3]*tail) + b[1]*t;
#endif
  return p;
}

%% end
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
