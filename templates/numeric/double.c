%% -- double.c -- functions of pairs, for the set-up of the closed form: part of scene.c.  SPDX-License-Identifier: MIT-0
/* ---- functions of pairs, to about twice the working precision ---- */

static ${name}_pair ${name}_pair_subtract(${name}_pair a, ${name}_pair b)
{
  return ${name}_pair_add(a, ${name}_pair_minus(b));
}

static ${name}_pair ${name}_pair_times(${name}_real a, ${name}_pair b)
{
  const ${name}_pair p = ${name}_pair_product(a, b.hi);

  return ${name}_pair_tidy(p.hi, p.lo + a*b.lo);
}

/* a power of two times b: exact */
static ${name}_pair ${name}_pair_shift(${name}_real power, ${name}_pair b)
{
  b.hi *= power;
  b.lo *= power;
  return b;
}

/* the same for any exponent */
static ${name}_pair ${name}_pair_scale(${name}_pair a, int e)
{
  a.hi = ${ldexp}(a.hi, e);
  a.lo = ${ldexp}(a.lo, e);
  return a;
}

/* the leading quotient, and that of its remainder */
static ${name}_pair ${name}_pair_divide(${name}_pair a, ${name}_pair b)
{
  const ${name}_real q = a.hi/b.hi;
  const ${name}_pair p = ${name}_pair_product(q, b.hi);

  return ${name}_pair_tidy(q, (((a.hi - p.hi) - p.lo) + (a.lo - q*b.lo))/b.hi);
}

/* one Newton step: sqrt(a) = r + (a - r^2)/(2 r) */
static ${name}_pair ${name}_pair_root(${name}_pair a)
{
  const ${name}_real r = a.hi > ${zero} ? ${sqrt}(a.hi) : ${zero};
  const ${name}_pair p = ${name}_pair_product(r, r);

  if (!(r > ${zero})) return ${name}_pair_of(${zero});
  return ${name}_pair_tidy(r, (((a.hi - p.hi) - p.lo) + a.lo)*(${half}/r));
}

/* Artanh (sign = 1) or arctan (sign = -1) of x, |x| <= 1/16: x + sign x^3/3 + x^5/5 + ... (DLMF 4.38.2, 4.24.3).  From
 * x^13 on, 2^-48 of the whole, the working precision will do; what is left out is 2^-100. */
static ${name}_pair ${name}_pair_arc(${name}_pair x, ${name}_real sign)
{
  static const ${name}_pair odd[6] = {
%% for _, c in ipairs(odd_reciprocals) do
    {${c.high}, ${c.low}},
%% end
  };
  const ${name}_pair square = ${name}_pair_multiply(x, x), z = ${name}_pair_shift(sign, square);
  const ${name}_real t = z.hi, seven = ${one}/(${name}_real)13 + t*(${one}/(${name}_real)15 + t*(${one}/(${name}_real)17
    + t*(${one}/(${name}_real)19 + t*(${one}/(${name}_real)21
        + t*(${one}/(${name}_real)23 + t*(${one}/(${name}_real)25))))));
  ${name}_pair s = ${name}_pair_of(seven);
  int i;

  for (i = 5; i >= 0; i--) s = ${name}_pair_add(odd[i], ${name}_pair_multiply(z, s));
  return ${name}_pair_multiply(x, s);
}

static ${name}_pair ${name}_pi(void)
{
  const ${name}_pair pi = {${pi_high}, ${pi_low}};

  return pi;
}

%% if not lagrange then
static ${name}_pair ${name}_inverse_pi(void)
{
  const ${name}_pair inverse = {${inverse_pi_high}, ${inverse_pi_low}};

  return inverse;
}

%% end
static ${name}_pair ${name}_log2(void)
{
  const ${name}_pair log2 = {${log2_high}, ${log2_low}};

  return log2;
}

%% if not lagrange then
/* The angle of (x, y), -pi..pi; 0 if both are 0.  In the first octant, arctan y/x = arctan j/8 + arctan of a rest below
 * 1/16 (DLMF 4.24.15). */
static ${name}_pair ${name}_pair_angle(${name}_pair x, ${name}_pair y)
{
  static const ${name}_pair arctan[9] = {
%% for _, c in ipairs(arctan_eighths) do
    {${c.high}, ${c.low}},
%% end
  };
  const ${name}_pair pi = ${name}_pi();
  const int left = x.hi < ${zero}, below = y.hi < ${zero};
  const ${name}_pair u = left ? ${name}_pair_minus(x) : x, v = below ? ${name}_pair_minus(y) : y;
  const int steep = v.hi > u.hi;
  const ${name}_pair far = steep ? v : u, near = steep ? u : v;
  ${name}_pair angle;
  ${name}_real eighths;

  if (!(far.hi > ${zero})) return ${name}_pair_of(${zero});
  eighths = near.hi/far.hi;
  if (!(eighths <= ${one})) return ${name}_pair_of(eighths); /* no number */
  eighths = ${floor}((${name}_real)8*eighths + ${half});
  angle = ${name}_pair_divide(${name}_pair_subtract(near, ${name}_pair_times(eighths/(${name}_real)8, far)),
               ${name}_pair_add(far, ${name}_pair_times(eighths/(${name}_real)8, near)));
  angle = ${name}_pair_add(arctan[(int)eighths], ${name}_pair_arc(angle, -${one}));
  if (steep) angle = ${name}_pair_subtract(${name}_pair_shift(${half}, pi), angle);
  if (left) angle = ${name}_pair_subtract(pi, angle);
  return below ? ${name}_pair_minus(angle) : angle;
}

%% end
/* log(2^e a), a > 0: of 2^e, of 1 + j/8, and 2 artanh of a rest below 1/16 */
static ${name}_pair ${name}_pair_log(${name}_pair a, int e)
{
  static const ${name}_pair log[9] = {
%% for _, c in ipairs(log_eighths) do
    {${c.high}, ${c.low}},
%% end
  };
  ${name}_pair near;
  ${name}_real eighths;
  int own;

  if (!(a.hi > ${zero} && a.hi - a.hi == ${zero})) return ${name}_pair_of(${sqrt}(-${one})); /* no number */
  (void)${frexp}(a.hi, &own);
  a = ${name}_pair_scale(a, 1 - own);
  eighths = ${floor}((${name}_real)8*(a.hi - ${one}) + ${half});
  near = ${name}_pair_of(${one} + eighths/(${name}_real)8);
  near = ${name}_pair_shift(${two}, ${name}_pair_arc(${name}_pair_divide(${name}_pair_subtract(a, near),
      ${name}_pair_add(a, near)), ${one}));
  near = ${name}_pair_add(log[(int)eighths], near);
  return ${name}_pair_add(${name}_pair_times((${name}_real)(e + own - 1), ${name}_log2()), near);
}

static void ${name}_store(${name}_real out[2], ${name}_pair a)
{
  out[0] = a.hi;
  out[1] = a.lo;
}
