%% -- series.c -- means over arcs and catenaries, each only where it is used: part of scene.c.  SPDX-License-Identifier: MIT-0

/* Means over an arc and a catenary.  Their closed forms cancel for a short curve, so up to 3 they are summed as power
 * series in pairs, which makes the alternating ones good to the last digit too (the moduli add up to less than 32 times
 * the sum; ${series_terms} terms); beyond 3 nothing cancels in the closed form. */
static int ${name}_short(${name}_real x)
{
  return x*x <= ${nine};
}
%% if has_sums then

/* the next term of a series: t*x/n */
static ${name}_pair ${name}_term(${name}_pair t, ${name}_pair x, int n)
{
  return ${name}_pair_quotient(${name}_mul(t, x), ${name}_pair_of((${name}_real)n));
}
%% end
%% if has_weights then

static ${name}_pair ${name}_times(${name}_pair t, ${name}_real weight)
{
  return ${name}_mul(t, ${name}_pair_of(weight));
}
%% end
%% if has_arc_across then

/* Mean of sin(t)^2 over |t| <= h: (1 - sin(2 h)/(2 h))/2 = sum of -(-4 h^2)^n/(2 (2 n + 1)!), n >= 1. */
static ${name}_real ${name}_arc_across(${name}_real h)
{
  const ${name}_real y = ${two}*h;
  ${name}_pair x, t = ${name}_pair_of(${one}), sum = t;

  if (!${name}_short(h)) return ${half}*(${one} - ${sin}(y)/y);
  x = ${name}_pair_product(y, y);
  for (int n = 2; n <= ${series_terms}; n++) {
    t = ${name}_minus(${name}_term(t, x, 2*n*(2*n + 1)));
    sum = ${name}_add(sum, t);
  }
  return ${name}_mul(x, sum).hi/${twelve};
}
%% end
%% if has_arc_along then

/* Variance of cos(t) over |t| <= h: (1 + sin(2 h)/(2 h))/2 - (sin(h)/h)^2 = sum of (n - 2) (-4 h^2)^(n - 1)/(2 n)!,
 * n >= 3. */
static ${name}_real ${name}_arc_along(${name}_real h)
{
  const ${name}_real y = ${two}*h;
  ${name}_real mean;
  ${name}_pair x, t = ${name}_pair_of(${one}), sum = t;

  if (!${name}_short(h)) {
    mean = ${sin}(h)/h;
    return ${half}*(${one} + ${sin}(y)/y) - mean*mean;
  }
  x = ${name}_pair_product(y, y);
  for (int n = 4; n <= ${series_terms}; n++) {
    t = ${name}_minus(${name}_term(t, x, (2*n - 1)*(2*n)));
    sum = ${name}_add(sum, ${name}_times(t, (${name}_real)(n - 2)));
  }
  return ${name}_mul(x, ${name}_mul(x, sum)).hi/${n720};
}
%% end
%% if has_arc_lever then

/* Mean of t sin(t) over |t| <= h: sin(h)/h - cos(h) = sum of -2 n (-h^2)^n/(2 n + 1)!, n >= 1. */
static ${name}_real ${name}_arc_lever(${name}_real h)
{
  ${name}_pair x, t = ${name}_pair_of(${one}), sum = t;

  if (!${name}_short(h)) return ${sin}(h)/h - ${cos}(h);
  x = ${name}_pair_product(h, h);
  for (int n = 2; n <= ${series_terms}; n++) {
    t = ${name}_minus(${name}_term(t, x, 2*n*(2*n + 1)));
    sum = ${name}_add(sum, ${name}_times(t, (${name}_real)n));
  }
  return ${name}_mul(x, sum).hi/${three};
}
%% end
%% if has_catenary_rise then

/* Catenary cosh(x), |x| <= u, half length s = sinh(u): mean height over its vertex divided by s,
 * (u/s + cosh(u))/2 - 1 = sum of (2 u)^(2 n + 1) (1/2 - 4^-n)/(2 n + 1)!/(2 s), s^2 = sum of (2 u)^(2 n)/(2 (2 n)!), n >= 1. */
static ${name}_real ${name}_catenary_rise(${name}_real u)
{
  const ${name}_real y = ${two}*u;
  ${name}_real w, d, power = ${quarter};
  ${name}_pair x, t = ${name}_pair_of(${one}), square = t, odd = t, sum = ${name}_pair_of(${quarter});

  if (!${name}_short(u)) { /* 1/s = 2 w/d, coth(u) = 1 + 2 w^2/d */
    w = ${exp}(-u);
    d = ${one} - w*w;
    return ${half} - w*(${two} - y*w/d - w)/d;
  }
  x = ${name}_pair_product(y, y);
  for (int n = 2; n <= ${series_terms}; n++) {
    power *= ${quarter};
    t = ${name}_term(t, x, (2*n - 1)*(2*n));
    odd = ${name}_term(odd, x, 2*n*(2*n + 1));
    square = ${name}_add(square, t);
    sum = ${name}_add(sum, ${name}_times(odd, ${half} - power));
  }
  return y*${name}_pair_quotient(sum, square).hi/${three};
}
%% end
%% if has_catenary_height then

/* Variance of the height divided by s^2, 1/12 + (3/4 - u coth(u)/2)/s^2 - u^2/(4 s^4) =
 *     sum of (2 u)^(2 n) (4^n - 24 n + 32)/(96 (2 n)!)/s^4, n >= 3. */
static ${name}_real ${name}_catenary_height(${name}_real u)
{
  const ${name}_real y = ${two}*u;
  const ${name}_pair one = ${name}_pair_of(${one});
  ${name}_pair x, t = one, even = one, square, sum = ${name}_pair_of(${n24});
  ${name}_real w, i, power = ${n64};

  if (!${name}_short(u)) { /* i = 1/s, coth(u) = 1 + w i */
    w = ${exp}(-u);
    i = ${two}*w/(${one} - w*w);
    return ${one}/${twelve} - i*i*(${half}*u*(${one} + w*i) - ${threequarters} + ${quarter}*(u*i)*(u*i));
  }
  x = ${name}_pair_product(y, y);
  for (int n = 4; n <= ${series_terms}; n++) {
    power *= ${four};
    t = ${name}_term(t, x, (2*n - 1)*(2*n));
    even = ${name}_add(even, t);
    sum = ${name}_add(sum, ${name}_times(t, power - (${name}_real)(24*n - 32)));
  }
  square = ${name}_add(one, ${name}_term(${name}_add(one, ${name}_term(even, x, 30)), x, 12)); /* s^2/u^2 */
  sum = ${name}_pair_quotient(sum, ${name}_mul(square, square));
  return ${name}_mul(x, sum).hi/${n4320};
}
%% end
%% if has_catenary_width then

/* Variance of x divided by u^2: 1 - 2 coth(u)/u + 2/u^2 = (1 + q)/(3 + q), q = u^2/(5 + u^2/(7 + ...)), from Lambert's
 * continued fraction of tanh (DLMF 4.39.1). */
static ${name}_real ${name}_catenary_width(${name}_real u)
{
  ${name}_real w, q = ${zero};

  if (!${name}_short(u)) {
    w = ${exp}(-u);
    return ${one} - ${two}/u*((u - ${one})/u + ${two}*(w*w)/(${one} - w*w));
  }
  for (int n = ${series_terms}; n >= 2; n--) q = u*u/((${name}_real)(2*n + 1) + q);
  return (${one} + q)/(${three} + q);
}
%% end
