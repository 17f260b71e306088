%% -- phase.c -- phases in pairs: part of scene.c.  SPDX-License-Identifier: MIT-0
/* a + b t in pairs: Knuth's two-sum, Dekker's product */
${inline} ${name}_pair ${name}_phase(${name}_pair a, const ${name}_real b[2], ${name}_real t)
{
#ifdef ${upper}_FUSES
  const ${name}_real hi = ${fma}(b[0], t, ${zero}); /* no compiler may fuse this one */
  const ${name}_real lo = ${fma}(b[0], t, -hi);
#else
  const ${name}_real c = ${split}*b[0], high = c - (c - b[0]), low = b[0] - high;
  const ${name}_real d = ${split}*t, head = d - (d - t), tail = t - head, hi = b[0]*t;
  const ${name}_real lo = ((high*head - hi) + high*tail + low*head) + low*tail;
#endif
  const ${name}_real sum = hi + a.hi, part = sum - hi;
  return ${name}_parts(sum, ((hi - (sum - part)) + (a.hi - part)) + (lo + b[1]*t + a.lo));
}
