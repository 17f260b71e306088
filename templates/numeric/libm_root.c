%% -- libm_root.c -- square and cube root: part of scene.c.  SPDX-License-Identifier: MIT-0
%% if need.sqrt then
/* correctly rounded, as IEEE 754 wants it: by the processor, else bit by bit, the last one for the rounding */
static ${name}_real ${name}_sqrt(${name}_real x)
{
#if defined __GNUC__ && (defined ${sse_math} || defined __aarch64__ || defined __wasm__ || \
  (defined __ARM_FP && (__ARM_FP & ${arm_fma})) || (defined __riscv_flen && __riscv_flen >= ${width}))
  return __builtin_sqrt${f}(x); /* one instruction, with -fno-math-errno */
#else
  ${name}_libm_number n;
  ${uint} m, root = 0, twice = 0, bit;
  int e;

  n.x = x;
  m = n.bits;
  e = (int)(m >> ${fraction_bits});
  if (!(x > ${zero}) || m >= ${infinity}) return x < ${zero} ? (x - x)/(x - x) : x + x; /* no root; 0, infinity, no number */
  m &= ${fraction};
  if (e > 0) {
    m |= ${hidden};
  } else {
    e = 1;
    while (m < ${hidden}) { /* rare: subnormal */
      m <<= 1;
      e--;
    }
  }
  e += ${bias};
  m <<= 1 + e%2; /* so that the exponent is even; the root of m has one bit more than the result */
  e /= 2;
  for (bit = ${hidden}*2U; bit != 0; bit >>= 1) { /* some ${digits} times */
    const ${uint} t = twice + bit;

    if (t <= m) {
      twice = t + bit;
      m -= t;
      root += bit;
    }
    m <<= 1;
  }
  if (m != 0) root += root & 1U; /* what is left breaks the tie */
  n.bits = (root >> 1) + ((${uint})(e - 1) << ${fraction_bits});
  return n.x;
#endif
}

%% end
%% if need.cbrt then
/* a third of the exponent, then Halley's steps t (t^3 + 2 x)/(2 t^3 + x); before the last one t is cut so that its square is
 * exact (Kahan, in Sun's fdlibm, 1993) */
static ${name}_real ${name}_cbrt(${name}_real x)
{
  ${uint} u = ${name}_libm_bits(x) & ${magnitude};
  const int subnormal = u < ${hidden};
  ${name}_real size, t, r;

  if (u == 0 || u >= ${infinity}) return x;
  size = ${name}_libm_real(u);
  if (subnormal) size *= ${cube};
  t = ${name}_libm_real(${name}_libm_bits(size)/3U + ${cbrt_start});
  for (int i = 0; i < ${cbrt_steps}; i++) {
    r = size/(t*t);
    t += t*((r - t)/(t + t + r));
  }
  t = ${name}_libm_real(${name}_libm_bits(t) & ${high_half});
  r = size/(t*t);
  t += t*((r - t)/(t + t + r));
  if (subnormal) t *= ${cube_root};
  return x < ${zero} ? -t : t;
}

%% end
