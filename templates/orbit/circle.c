%% -- circle.c -- phases in turns, sine and cosine without a call: part of scene.c.  SPDX-License-Identifier: MIT-0
/* ---- phases in turns: no call and no branch ---- */

%% if vectorised then
#if defined __GNUC__
#define ${upper}_INLINE static inline __attribute__((always_inline)) /* GCC and Clang vectorise loops over what they inline */
#else
#define ${upper}_INLINE static inline
#endif

%% end
/* the nearest integer, to even; beyond ${nearest_end} one of the nearest even ones, which serves as well */
${inline} ${name}_real ${name}_nearest(${name}_real x)
{
  return (x + ${round_off}) - ${round_off};
}

%% if not axial and not lagrange then
/* b t, b = b[0] + b[1], b[0] = b[2] + b[3] and t = head + tail in halves: Dekker's product */
${inline} ${name}_pair ${name}_passed(const ${name}_real b[4], ${name}_real t, ${name}_real head, ${name}_real tail)
{
#ifdef ${upper}_FUSES
  (void)head; (void)tail;
  const ${name}_real hi = ${fma}(b[0], t, ${zero}); /* no compiler may fuse this one */
  const ${name}_real lo = ${fma}(b[0], t, -hi);
#else
  const ${name}_real hi = b[0]*t;
  const ${name}_real lo = ((b[2]*head - hi) + b[2]*tail + b[3]*head) + b[3]*tail;
#endif
  return ${name}_parts(hi, lo + b[1]*t);
}

%% end
/* sin and cos of 2 pi x, |x| <= 1/2 and a little: doubled from economised series for the half */
${inline} void ${name}_circle(${name}_real x, ${name}_real *sine, ${name}_real *cosine)
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
