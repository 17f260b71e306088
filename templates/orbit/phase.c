%% -- phase.c -- phases in pairs: part of scene.c.  SPDX-License-Identifier: MIT-0
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
