%% -- double.c -- functions of pairs, for the set-up of the closed form: part of scene.c.  SPDX-License-Identifier: MIT-0
/* ---- functions of pairs, to about twice the working precision ---- */

static ${name}_pair ${name}_sub(${name}_pair a, ${name}_pair b)
{
  return ${name}_add(a, ${name}_minus(b));
}

static ${name}_pair ${name}_scaled(${name}_real a, ${name}_pair b)
{
  const ${name}_pair p = ${name}_pair_product(a, b.hi);
  return ${name}_pair_tidy(p.hi, p.lo + a*b.lo);
}

/* a power of two times b: exact */
static ${name}_pair ${name}_shift(${name}_real power, ${name}_pair b)
{
  return ${name}_parts(power*b.hi, power*b.lo);
}

/* the same for any exponent */
static ${name}_pair ${name}_pair_scale(${name}_pair a, int e)
{
  return ${name}_parts(${ldexp}(a.hi, e), ${ldexp}(a.lo, e));
}

/* the leading quotient, and that of its remainder */
static ${name}_pair ${name}_ratio(${name}_pair a, ${name}_pair b)
{
  const ${name}_real q = a.hi/b.hi;
  const ${name}_pair p = ${name}_pair_product(q, b.hi);
  return ${name}_pair_tidy(q, (((a.hi - p.hi) - p.lo) + (a.lo - q*b.lo))/b.hi);
}

/* one Newton step: sqrt(a) = r + (a - r^2)/(2 r) */
static ${name}_pair ${name}_pair_root(${name}_pair a)
{
  if (!(a.hi > ${zero})) return ${name}_pair_of(${zero});
  const ${name}_real r = ${sqrt}(a.hi);
  const ${name}_pair p = ${name}_pair_product(r, r);
  return ${name}_pair_tidy(r, (((a.hi - p.hi) - p.lo) + a.lo)*(${half}/r));
}

/* Artanh (sign = 1) or arctan (sign = -1) of x, |x| <= 1/16: x + sign x^3/3 + x^5/5 + ... (DLMF
 * 4.38.2, 4.24.3).  From x^13 on, 2^-48 of it, the working precision will do; the rest is 2^-100. */
static ${name}_pair ${name}_pair_arc(${name}_pair x, ${name}_real sign)
{
  static const ${name}_pair odd[6] = { /* 1, 1/3, 1/5, ... */
%% for _, c in ipairs(odd_reciprocals) do
    {${c.high}, ${c.low}},
%% end
  };
  const ${name}_pair z = ${name}_shift(sign, ${name}_mul(x, x));
  const ${name}_real t = z.hi;
  ${name}_pair s = ${name}_pair_of(${one}/${n[13]} + t*(${one}/${n[15]} + t*(${one}/${n[17]}
      + t*(${one}/${n[19]} + t*(${one}/${n[21]} + t*(${one}/${n[23]} + t*(${one}/${n[25]})))))));
  for (int i = 5; i >= 0; i--) s = ${name}_add(odd[i], ${name}_mul(z, s));
  return ${name}_mul(x, s);
}

static const ${name}_pair ${name}_pair_pi = {${pi_high}, ${pi_low}};

%% if not lagrange then
static const ${name}_pair ${name}_inverse_pi = {${inverse_pi_high}, ${inverse_pi_low}};

%% end
static const ${name}_pair ${name}_log_two = {${log2_high}, ${log2_low}};

%% if not lagrange then
/* The angle of (x, y), -pi..pi; 0 if both are 0.  In the first octant it is arctan j/8 + the arctan
 * of a rest below 1/16 (DLMF 4.24.15). */
static ${name}_pair ${name}_pair_angle(${name}_pair x, ${name}_pair y)
{
  static const ${name}_pair arctan[9] = { /* of j/8 */
%% for _, c in ipairs(arctan_eighths) do
    {${c.high}, ${c.low}},
%% end
  };
  const int left = x.hi < ${zero}, below = y.hi < ${zero};
  const ${name}_pair u = left ? ${name}_minus(x) : x, v = below ? ${name}_minus(y) : y;
  const int steep = v.hi > u.hi;
  const ${name}_pair far = steep ? v : u, near = steep ? u : v;
  if (!(far.hi > ${zero})) return ${name}_pair_of(${zero});
  const ${name}_real quotient = near.hi/far.hi, j = ${floor}(${eight}*quotient + ${half});
  if (!(quotient <= ${one})) return ${name}_pair_of(quotient); /* no number */
  const ${name}_pair rest = ${name}_ratio(${name}_sub(near, ${name}_scaled(j/${eight}, far)), ${name}_add(far, ${name}_scaled(j/${eight}, near)));
  ${name}_pair angle = ${name}_add(arctan[(int)j], ${name}_pair_arc(rest, -${one}));
  if (steep) angle = ${name}_sub(${name}_shift(${half}, ${name}_pair_pi), angle);
  if (left) angle = ${name}_sub(${name}_pair_pi, angle);
  return below ? ${name}_minus(angle) : angle;
}

%% end
/* log(2^e a), a > 0: of 2^e, of 1 + j/8, and 2 artanh of a rest below 1/16 */
static ${name}_pair ${name}_pair_log(${name}_pair a, int e)
{
  static const ${name}_pair log[9] = { /* of 1 + j/8 */
%% for _, c in ipairs(log_eighths) do
    {${c.high}, ${c.low}},
%% end
  };
  int own;
  if (!(a.hi > ${zero} && a.hi - a.hi == ${zero})) return ${name}_pair_of(${sqrt}(-${one})); /* no number */
  (void)${frexp}(a.hi, &own);
  a = ${name}_pair_scale(a, 1 - own);
  const ${name}_real j = ${floor}(${eight}*(a.hi - ${one}) + ${half});
  const ${name}_pair near = ${name}_pair_of(${one} + j/${eight});
  const ${name}_pair rest = ${name}_shift(${two}, ${name}_pair_arc(${name}_ratio(${name}_sub(a, near), ${name}_add(a, near)), ${one}));
  return ${name}_add(${name}_scaled((${name}_real)(e + own - 1), ${name}_log_two), ${name}_add(log[(int)j], rest));
}

static void ${name}_store(${name}_real out[2], ${name}_pair a)
{
  out[0] = a.hi;
  out[1] = a.lo;
}
