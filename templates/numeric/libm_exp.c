%% -- libm_exp.c -- exponentials and hyperbolic functions: part of scene.c.  SPDX-License-Identifier: MIT-0
%% if need.parts then
/* exp(x + low) = (h + *rest) 2^*k, |h| within 0.6..1.4: x = k log 2 + r with |r| <= log(2)/2, k log 2 in two parts of which
 * the first is exact, then 1 + r + r^2 (even + r odd), economised series in r^2 */
static ${name}_real ${name}_libm_exp(${name}_real x, ${name}_real low, int *k, ${name}_real *rest)
{
  const ${name}_real n = x*${inverse_log2};
  const int whole = (int)(n < ${zero} ? n - ${half} : n + ${half});
  const ${name}_real high = x - (${name}_real)whole*${log2_first}, part = (${name}_real)whole*${log2_second};
  const ${name}_real r = high - part, z = r*r, h = ${one} + r;
%% for _, line in ipairs(even_lines) do
  ${line}
%% end
%% for _, line in ipairs(odd_lines) do
  ${line}
%% end
  const ${name}_real q = z*(e + r*o);

  *k = whole;
  *rest = ((${one} - h) + r) + (q + ((high - r) - part + low)*(h + q));
  return h;
}

%% end
%% if need.exp then
static ${name}_real ${name}_exp(${name}_real x)
{
  ${name}_real h, rest;
  int k;

  if (!(x < ${exp_most})) return x*${name}_libm_real(${infinity}); /* infinity, no number */
  if (x < ${exp_least}) return ${zero};
  h = ${name}_libm_exp(x, ${zero}, &k, &rest);
  return ${name}_ldexp(h + rest, k);
}

%% end
%% if need.halves then
/* (exp(x) + sign exp(-x))/2 of x >= 0 below overflow */
static ${name}_real ${name}_libm_halves(${name}_real x, ${name}_real sign)
{
  ${name}_real rest, a, b, sum;
  int k;
  const ${name}_real h = ${name}_libm_exp(x, ${zero}, &k, &rest);

  sum = h + rest;
  rest = ${name}_ldexp((h - sum) + rest, k - 1);
  a = ${name}_ldexp(sum, k - 1);
  b = sign*(${quarter}/a);
  sum = a + b;
  return sum + (((a - sum) + b) + (rest - b*(rest/a)));
}

%% end
%% if need.sinh then
/* below 1: x + x^3 times a series in x^2 */
static ${name}_real ${name}_sinh(${name}_real x)
{
  const ${name}_real size = ${name}_fabs(x);

  if (size < ${one}) {
    const ${name}_real z = x*x;
%% for _, line in ipairs(sinh_lines) do
    ${line}
%% end

    return x + x*(z*p);
  }
  if (!(size < ${sinh_most})) return x*${name}_libm_real(${infinity}); /* infinity, no number */
  return x < ${zero} ? -${name}_libm_halves(size, -${one}) : ${name}_libm_halves(size, -${one});
}

%% end
%% if need.cosh then
static ${name}_real ${name}_cosh(${name}_real x)
{
  const ${name}_real size = ${name}_fabs(x);

  if (!(size < ${sinh_most})) return size*${name}_libm_real(${infinity}); /* infinity, no number */
  return ${name}_libm_halves(size, ${one});
}

%% end
%% if need.tanh then
/* below 5/8 a series, above 1 - 2/(exp(2 x) + 1) */
static ${name}_real ${name}_tanh(${name}_real x)
{
  const ${name}_real size = ${name}_fabs(x);
  ${name}_real t, d, q, rest, sum;
  int k;

  if (size < ${tiny}) return x; /* also keeps -0 */
  if (size < ${tanh_near}) {
    const ${name}_real z = x*x;
%% for _, line in ipairs(tanh_lines) do
    ${line}
%% end

    return x + x*(z*p);
  }
  if (size > ${tanh_far}) {
    sum = ${one};
  } else {
    if (!(x < ${zero} || x > ${zero})) return x; /* no number */
    d = ${name}_libm_exp(${two}*size, ${zero}, &k, &rest);
    t = d + rest;
    rest = ${name}_ldexp((d - t) + rest, k);
    t = ${name}_ldexp(t, k);
    d = t + ${one};
    rest += (t - d) + ${one};
    q = ${two}/d;
    sum = ${one} - q;
    sum += ((${one} - sum) - q) + q*(rest/d);
  }
  return x < ${zero} ? -sum : sum;
}

%% end
