%% -- libm_bits.c -- functions on the bits of numbers: part of scene.c.  SPDX-License-Identifier: MIT-0
/* ---- mathematical functions of its own: plain arithmetic, so the same bits everywhere ----
 * IEEE 754 ${format}: sign, ${exponent_bits} bits of exponent + ${bias}, ${fraction_bits} of fraction. */

%% if need.number then
typedef union ${name}_libm_number {
  ${name}_real x;
  ${uint} bits;
} ${name}_libm_number;

%% end
%% if need.bits then
static ${uint} ${name}_libm_bits(${name}_real x)
{
  ${name}_libm_number n;

  n.x = x;
  return n.bits;
}

%% end
%% if need.real then
static ${name}_real ${name}_libm_real(${uint} bits)
{
  ${name}_libm_number n;

  n.bits = bits;
  return n.x;
}

%% end
%% if need.huge then
static ${name}_real ${name}_huge(void)
{
  return ${name}_libm_real(${infinity});
}

%% end
%% if need.fabs then
static ${name}_real ${name}_fabs(${name}_real x)
{
#if defined __GNUC__
  return __builtin_fabs${f}(x); /* never a call */
#else
  ${name}_libm_number n;

  n.x = x;
  n.bits &= ${magnitude};
  return n.x;
#endif
}

%% end
%% if need.copysign then
static ${name}_real ${name}_copysign(${name}_real x, ${name}_real y)
{
  return ${name}_libm_real((${name}_libm_bits(x) & ${magnitude}) | (${name}_libm_bits(y) & ${sign}));
}

%% end
%% if need.floor then
static ${name}_real ${name}_floor(${name}_real x)
{
  ${uint} u = ${name}_libm_bits(x), part;
  const int e = (int)(u >> ${fraction_bits} & ${exponent_field}) - ${bias};

  if (e >= ${fraction_bits}) return x;
  if (e < 0) return u & ${magnitude} ? (u & ${sign} ? -${one} : ${zero}) : x;
  part = ${fraction} >> e;
  if (!(u & part)) return x;
  if (u & ${sign}) u += part;
  return ${name}_libm_real(u & ~part);
}

%% end
%% if need.frexp then
/* x = f 2^*e, 1/2 <= |f| < 1; 0, infinity and no number are f, with e = 0 */
static ${name}_real ${name}_frexp(${name}_real x, int *e)
{
  ${uint} u = ${name}_libm_bits(x);
  int k = (int)(u >> ${fraction_bits} & ${exponent_field}), below = 0;

  *e = 0;
  if (k == ${exponent_last} || !(u & ${magnitude})) return x;
  if (k == 0) { /* rare: subnormal */
    u = ${name}_libm_bits(x*${two_bits});
    k = (int)(u >> ${fraction_bits} & ${exponent_field});
    below = ${digits};
  }
  *e = k - ${bias} + 1 - below;
  return ${name}_libm_real((u & ~${infinity}) | ${half_bits});
}

%% end
%% if need.ldexp then
/* x 2^n, rounded once */
static ${name}_real ${name}_ldexp(${name}_real x, int n)
{
  ${uint} u = ${name}_libm_bits(x);
  int k = (int)(u >> ${fraction_bits} & ${exponent_field});

  if (k == ${exponent_last} || !(u & ${magnitude})) return x;
  if (k == 0) { /* rare: subnormal */
    u = ${name}_libm_bits(x*${two_bits});
    k = (int)(u >> ${fraction_bits} & ${exponent_field}) - ${digits};
  }
  n = n > ${farthest} ? ${farthest} : n < -${farthest} ? -${farthest} : n;
  k += n;
  u &= ~${infinity};
  if (k >= ${exponent_last}) return ${name}_libm_real((u & ${sign}) | ${infinity});
  if (k > 0) return ${name}_libm_real(u | (${uint})k << ${fraction_bits});
  k = k < -60 ? 4 : k + 64; /* subnormal, or nothing: from 2^64 times it */
  return ${name}_libm_real(u | (${uint})k << ${fraction_bits})*${two64};
}

%% end
