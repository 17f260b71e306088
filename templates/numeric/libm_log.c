%% -- libm_log.c -- logarithm and powers: part of scene.c.  SPDX-License-Identifier: MIT-0
%% if need.mantissa then
/* x = m 2^*k with m within sqrt(1/2)..sqrt(2), 0 < x < infinity */
static ${name}_real ${name}_libm_mantissa(${name}_real x, int *k)
{
  ${uint} u = ${name}_libm_bits(x);
  int below = 0;

  if (u < ${hidden}) { /* rare: subnormal */
    u = ${name}_libm_bits(x*${two_bits});
    below = ${digits};
  }
  u += ${one_bits} - ${root_half_bits};
  *k = (int)(u >> ${fraction_bits}) - ${bias} - below;
  return ${name}_libm_real((u & ${fraction}) + ${root_half_bits});
}

%% end
%% if need.log then
/* k log 2 + log(1 + f), with s = f/(2 + f): log(1 + f) = 2 s + 2 s^3/3 + ... = f - (f^2/2 - s (f^2/2 + R)), R an economised
 * series in s^2 (the form of Ng, in Sun's fdlibm, 1993) */
static ${name}_real ${name}_log(${name}_real x)
{
  ${name}_real f, s, z, h, n;
  int k;

  if (!(x > ${zero})) return x < ${zero} ? (x - x)/(x - x) : x - ${name}_libm_real(${infinity});
  if (!(x - x == ${zero})) return x;
  f = ${name}_libm_mantissa(x, &k) - ${one};
  n = (${name}_real)k;
  s = f/(${two} + f);
  z = s*s;
  h = ${half}*f*f;
  {
%% for _, line in ipairs(log_lines) do
    ${line}
%% end

    return n*${log2_first} - ((h - (s*(h + z*p) + n*${log2_second})) - f);
  }
}

%% end
%% if need.pow then
/* log x as a number and what it is missing, to 2^-${pow_bits} of it: as above, but s, s^2, s^3/3 and the sums as two numbers */
static ${name}_real ${name}_libm_log(${name}_real x, ${name}_real *rest)
{
  int k;
  const ${name}_real m = ${name}_libm_mantissa(x, &k), f = m - ${one}, d = ${one} + m, s = f/d, n = (${name}_real)k;
  ${name}_real low, c, dc, e, de, g, dg, sum, more;
  const ${name}_real back = ${name}_libm_product(s, d, &low);
  const ${name}_real ds = (((f - back) - low) - s*((${one} - d) + m))/d;
  const ${name}_real z = ${name}_libm_product(s, s, &low), dz = low + ${two}*s*ds;
%% for _, line in ipairs(pow_lines) do
  ${line}
%% end

  c = ${third_high} + z*p;
  dc = ((${third_high} - c) + z*p) + ${third_low};
  e = ${name}_libm_product(z, c, &de);
  de += z*dc + dz*c;
  g = ${two}*${name}_libm_product(s, e, &dg);
  dg = ${two}*(dg + s*de + ds*e);
  sum = n*${log2_first} + ${two}*s;
  low = (n*${log2_first} - sum) + ${two}*s;
  more = sum + g;
  low += (sum - more) + g;
  low += n*${log2_second} + (${two}*ds + dg);
  sum = more + low;
  *rest = (more - sum) + low;
  return sum;
}

/* x^y = exp(y log x); what C's annex F says of infinities, zeros and negative x */
static ${name}_real ${name}_pow(${name}_real x, ${name}_real y)
{
  const ${name}_real size = ${name}_fabs(x), infinite = ${name}_libm_real(${infinity});
  const int whole = !(${name}_floor(y) < y), odd = whole && ${name}_floor(${half}*y) < ${half}*y;
  const ${name}_real way = odd && (${name}_libm_bits(x) & ${sign}) ? -${one} : ${one};
  ${name}_real power = y > ${pow_most} ? ${pow_most} : y < -${pow_most} ? -${pow_most} : y, low, log, h;
  int k;

  if (y == ${zero} || x == ${one}) return ${one};
  if (!(x == x && y == y)) return x + y; /* no number */
  if (size == ${zero} || size == infinite) return (size == ${zero}) == (y < ${zero}) ? way*infinite : way*${zero};
  if (x < ${zero} && !whole) return (x - x)/(x - x); /* no number */
  log = ${name}_libm_log(size, &low);
  low *= power;
  power = ${name}_libm_product(power, log, &h);
  low += h;
  if (power > ${sinh_most}) return way*infinite;
  if (power < ${exp_least}) return way*${zero};
  h = ${name}_libm_exp(power, low, &k, &low);
  return way*${name}_ldexp(h + low, k);
}

%% end
