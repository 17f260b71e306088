%% -- libm_circular.c -- sine, cosine, tangent: part of scene.c.  SPDX-License-Identifier: MIT-0
%% if need.reduce then
/* x = (n + f) pi/2 with |f| <= 1/2 and 0 < x < infinity: y[0] + y[1] = f pi/2, n comes modulo 4.  The bits of 2/pi that
 * matter times the integer in x, whole turns falling off by overflow (Payne and Hanek 1983, SIGNUM Newsletter 18, 1, 19).
 * No ${format} is nearer to a multiple of pi/2 than 2^-${nearest_multiple}; ${product_bits} bits of the product are kept. */
static ${uint} ${name}_libm_reduce(${name}_real x, ${name}_real y[2])
{
  static const uint32_t inverse[] = { /* 2/pi = 0.A2F9836E..., after ${leading_zeros} zeros */
%% for _, line in ipairs(inverse_lines) do
    ${line}
%% end
  };
%% if single then
  const uint32_t u = ${name}_libm_bits(x), m = (u & ${fraction}) | ${hidden};
  const int at = (int)(u >> ${fraction_bits}) - 120;
  const uint32_t *w = inverse + at/32;
  const int left = at%32, right = 31 - left;
  const uint32_t w0 = w[0] << left | w[1] >> 1 >> right;
  const uint32_t w1 = w[1] << left | w[2] >> 1 >> right, w2 = w[2] << left | w[3] >> 1 >> right;
  const uint64_t p = ((uint64_t)(m*w0) << 32) + (uint64_t)m*w1 + ((uint64_t)m*w2 >> 32); /* quarter turns, 2^-62 */
  const uint32_t n = (uint32_t)(p >> 61) + 1U;
  const uint64_t f = p - ((uint64_t)(n >> 1) << 62), size = n & 1U ? f : 0 - f; /* the nearest n, and |f| */
  const uint64_t angle = (size >> 32)*${half_pi_fixed} + ((size & 0xFFFFFFFFU)*${half_pi_fixed} >> 32); /* 2^-61 */
  const ${name}_real high = (${name}_real)(uint32_t)(angle >> 38)*${high_unit};
  const ${name}_real low = (${name}_real)(uint32_t)(angle >> 6)*${low_unit};
  const ${name}_real sum = high + low, rest = (high - sum) + low;

  y[0] = n & 1U ? sum : -sum;
  y[1] = n & 1U ? rest : -rest;
  return n >> 1;
%% else
  const ${name}_real k = (x*${inverse_half_pi} + ${round_off}) - ${round_off};
  const ${name}_real t = x - k*${half_pi_first}, w = k*${half_pi_second}; /* the product of 20 and 33 bits is exact */
  ${uint} u, m;
  uint32_t window[6], words[6];
  ${uint} carry = 0, high, low, n;
  ${name}_real f, rest, part, high_part;
  int at;

  y[0] = t - w;
  if (x < ${nearby} && ${name}_fabs(y[0]) > ${too_near}) { /* Cody and Waite 1980: off by less than 2^-66 */
    y[1] = (t - y[0]) - w;
    return (${uint})(int32_t)k;
  }
  u = ${name}_libm_bits(x);
  m = (u & ${fraction}) | ${hidden};
  at = (int)(u >> ${fraction_bits}) - 1013;
  for (int i = 0; i < 6; i++) {
    const uint32_t *p = inverse + at/32 + i;

    window[i] = p[0] << at%32 | p[1] >> 1 >> (31 - at%32);
  }
  for (int i = 4; i >= 0; i--) { /* m times the window, its upper words */
    const ${uint} a = (m & 0xFFFFFFFFU)*window[i], b = (m >> 32)*window[i + 1];
    const ${uint} sum = carry + (a & 0xFFFFFFFFU) + (b & 0xFFFFFFFFU);

    words[i] = (uint32_t)sum;
    carry = (sum >> 32) + (a >> 32) + (b >> 32);
  }
  high = (${uint})words[0] << 32 | words[1]; /* quarter turns, 2^-62 */
  low = (${uint})words[2] << 32 | words[3];
  n = (high >> 61) + 1U;
  high -= n >> 1 << 62;
  if (!(n & 1U)) { /* |f| */
    high = ~high + (low == 0 ? 1U : 0U);
    low = 0 - low;
  }
  f = (${name}_real)(high >> 9)*${two53_inverse};
  part = (${name}_real)((high & 511U) << 44 | low >> 20)*${two106_inverse} +
    (${name}_real)(low & 0xFFFFFU)*${two126_inverse};
  rest = part + (f - (f + part));
  f += part;
  high_part = ${name}_libm_product(f, ${half_pi_high}, &part);
  part += f*${half_pi_low} + rest*${half_pi_high};
  f = high_part + part;
  rest = (high_part - f) + part;
  y[0] = n & 1U ? f : -f;
  y[1] = n & 1U ? rest : -rest;
  return n >> 1;
%% end
}

%% end
%% if need.near then
/* Sine and cosine of y + low, |y| <= pi/4, as two numbers each, what is and what is missing; series in y^2, economised
 * (Lanczos 1938, J. Math. Phys. 17, 123) */
static ${name}_real ${name}_libm_sine(${name}_real y, ${name}_real low, ${name}_real *rest)
{
  const ${name}_real z = y*y;
%% for _, line in ipairs(sine_lines) do
  ${line}
%% end

  *rest = y*(z*s) + (low - ${half}*z*low);
  return y;
}

static ${name}_real ${name}_libm_cosine(${name}_real y, ${name}_real low, ${name}_real *rest)
{
  const ${name}_real z = y*y, h = ${half}*z, most = ${one} - h;
%% for _, line in ipairs(cosine_lines) do
  ${line}
%% end

  *rest = ((${one} - most) - h) + (z*(z*c) - y*low);
  return most;
}

%% end
%% if need.circular then
/* sine of x + k pi/2 */
static ${name}_real ${name}_libm_circular(${name}_real x, ${uint} k)
{
  const ${uint} u = ${name}_libm_bits(x), size = u & ${magnitude};
  ${name}_real y[2], most, rest;

  if (size >= ${infinity}) return x - x;
  y[0] = x;
  y[1] = ${zero};
  if (size > ${quarter_pi_bits}) {
    y[0] = ${name}_libm_real(size);
    k += ${name}_libm_reduce(y[0], y) + (k == 0 && u != size ? 2U : 0U); /* odd sine, even cosine */
  } else if (size < ${tiny_bits}) {
    return k == 0 ? x : ${one}; /* also keeps -0 */
  }
  most = k & 1U ? ${name}_libm_cosine(y[0], y[1], &rest) : ${name}_libm_sine(y[0], y[1], &rest);
  most += rest;
  return k & 2U ? -most : most;
}

%% end
%% if need.sin then
static ${name}_real ${name}_sin(${name}_real x)
{
  return ${name}_libm_circular(x, 0);
}

%% end
%% if need.cos then
static ${name}_real ${name}_cos(${name}_real x)
{
  return ${name}_libm_circular(x, 1);
}

%% end
%% if need.tan then
/* sine over cosine, with the remainder of the division and what both are missing */
static ${name}_real ${name}_tan(${name}_real x)
{
  const ${uint} u = ${name}_libm_bits(x), size = u & ${magnitude};
  ${uint} k = 0;
  ${name}_real y[2], s, c, ds, dc, q, low;

  if (size >= ${infinity}) return x - x;
  if (size < ${tiny_bits}) return x;
  y[0] = x;
  y[1] = ${zero};
  if (size > ${quarter_pi_bits}) {
    k = ${name}_libm_reduce(${name}_libm_real(size), y);
    if (u != size) {
      y[0] = -y[0];
      y[1] = -y[1];
    }
  }
  s = ${name}_libm_sine(y[0], y[1], &ds);
  c = ${name}_libm_cosine(y[0], y[1], &dc);
  y[0] = s + ds; /* the rest below the last place */
  y[1] = (s - y[0]) + ds;
  q = c + dc;
  low = (c - q) + dc;
  s = k & 1U ? q : y[0];
  ds = k & 1U ? low : y[1];
  c = k & 1U ? -y[0] : q;
  dc = k & 1U ? -y[1] : low;
  q = s/c;
  s -= ${name}_libm_product(q, c, &low);
  return q + ((s - low) + (ds - q*dc))/c;
}

%% end
