%% -- double.c -- functions of pairs, for the set-up of the closed form: part of scene.c.  SPDX-License-Identifier: MIT-0
/* ---- functions of pairs, to about twice the working precision ---- */

static ${name}_pair ${name}_pair_scale(${name}_pair a, int e)
{
  a.hi = ${ldexp}(a.hi, e);
  a.lo = ${ldexp}(a.lo, e);
  return a;
}

static ${name}_pair ${name}_pair_subtract(${name}_pair a, ${name}_pair b)
{
  return ${name}_pair_add(a, ${name}_pair_minus(b));
}

/* two quotients: the remainder of the first is formed in pairs */
static ${name}_pair ${name}_pair_divide(${name}_pair a, ${name}_pair b)
{
  const ${name}_real q = a.hi/b.hi;
  const ${name}_pair r = ${name}_pair_subtract(a, ${name}_pair_multiply(${name}_pair_of(q), b));

  return ${name}_pair_sum(q, r.hi/b.hi);
}

static ${name}_pair ${name}_pair_times(${name}_real a, ${name}_pair b)
{
  return ${name}_pair_multiply(${name}_pair_of(a), b);
}

/* one Newton step: sqrt(a) = r + (a - r^2)/(2 r) */
static ${name}_pair ${name}_pair_root(${name}_pair a)
{
  const ${name}_real r = a.hi > ${zero} ? ${sqrt}(a.hi) : ${zero};
  const ${name}_pair p = ${name}_pair_product(r, r);

  if (!(r > ${zero})) return ${name}_pair_of(${zero});
  return ${name}_pair_sum(r, ((a.hi - p.hi) - p.lo + a.lo)/(${two}*r));
}

/* 2^e exp(x): x less a multiple of log 2, divided by 64, the series of exp - 1, and six doublings of exp(x) - 1 */
static ${name}_pair ${name}_pair_exp(${name}_pair x, int e)
{
  const ${name}_pair log2 = {${log2_high}, ${log2_low}};
  const ${name}_real n = ${floor}(x.hi/log2.hi + ${half});
  ${name}_pair y = ${name}_pair_scale(${name}_pair_subtract(x, ${name}_pair_times(n, log2)), -6), s = ${name}_pair_of(${zero});
  int i;

  for (i = 12; i > 0; i--) { /* s = y/i (1 + s) */
    s = ${name}_pair_multiply(y, ${name}_pair_add(${name}_pair_of(${one}), s));
    s = ${name}_pair_divide(s, ${name}_pair_of((${name}_real)i));
  }
  for (i = 0; i < 6; i++) s = ${name}_pair_add(${name}_pair_scale(s, 1), ${name}_pair_multiply(s, s));
  return ${name}_pair_scale(${name}_pair_add(${name}_pair_of(${one}), s), (int)n + e);
}

/* log a = l + log(1 + r), r = a exp(-l) - 1, where l is good to the working precision */
static ${name}_pair ${name}_pair_log(${name}_pair a)
{
  const ${name}_pair l = ${name}_pair_of(${log}(a.hi));
  const ${name}_pair r = ${name}_pair_subtract(${name}_pair_multiply(a, ${name}_pair_exp(${name}_pair_minus(l), 0)), ${name}_pair_of(${one}));

  return ${name}_pair_add(l, ${name}_pair_subtract(r, ${name}_pair_scale(${name}_pair_multiply(r, r), -1)));
}

/* cos x - 1 and sin x, |x| <= pi: the series at x/64 and six doublings */
static void ${name}_pair_circle(${name}_pair x, ${name}_pair *c1, ${name}_pair *s)
{
  const ${name}_pair y = ${name}_pair_scale(x, -6), y2 = ${name}_pair_multiply(y, y);
  ${name}_pair c = ${name}_pair_of(${zero}), d = ${name}_pair_of(${zero});
  int i;

  for (i = 16; i > 0; i -= 2) {
    c = ${name}_pair_minus(${name}_pair_multiply(y2, ${name}_pair_add(${name}_pair_of(${one}), c)));
    c = ${name}_pair_divide(c, ${name}_pair_of((${name}_real)(i*(i - 1))));
    d = ${name}_pair_minus(${name}_pair_multiply(y2, ${name}_pair_add(${name}_pair_of(${one}), d)));
    d = ${name}_pair_divide(d, ${name}_pair_of((${name}_real)(i*(i + 1))));
  }
  d = ${name}_pair_multiply(y, ${name}_pair_add(${name}_pair_of(${one}), d));
  for (i = 0; i < 6; i++) { /* cos 2x - 1 = -2 sin^2 x, sin 2x = 2 sin x (1 + (cos x - 1)) */
    const ${name}_pair square = ${name}_pair_multiply(d, d);

    d = ${name}_pair_scale(${name}_pair_multiply(d, ${name}_pair_add(${name}_pair_of(${one}), c)), 1);
    c = ${name}_pair_minus(${name}_pair_scale(square, 1));
  }
  *c1 = c;
  *s = d;
}

/* Carlson's R_F(x^2, y^2, z^2), at most one of x, y, z = 0: duplication (DLMF 19.26.18) until the three agree to 13 bits
 * (seven steps and some more if one is small: 40 cover every number), then the series of order 7 (DLMF 19.36.1). */
static ${name}_pair ${name}_carlson(${name}_pair x, ${name}_pair y, ${name}_pair z)
{
  ${name}_pair sum = ${name}_pair_of(${zero}), X, Y, Z, E2, E3, s;
  int i;

  for (i = 0; i < 40; i++) {
    const ${name}_pair xy = ${name}_pair_multiply(x, y);
    const ${name}_pair l = ${name}_pair_add(xy, ${name}_pair_multiply(z, ${name}_pair_add(x, y)));
    const ${name}_pair x2 = ${name}_pair_scale(${name}_pair_add(${name}_pair_multiply(x, x), l), -2);
    const ${name}_pair y2 = ${name}_pair_scale(${name}_pair_add(${name}_pair_multiply(y, y), l), -2);
    const ${name}_pair z2 = ${name}_pair_scale(${name}_pair_add(${name}_pair_multiply(z, z), l), -2);

    sum = ${name}_pair_add(${name}_pair_add(x2, y2), z2);
    X = ${name}_pair_subtract(sum, ${name}_pair_times((${name}_real)3, x2));
    Y = ${name}_pair_subtract(sum, ${name}_pair_times((${name}_real)3, y2));
    Z = ${name}_pair_subtract(sum, ${name}_pair_times((${name}_real)3, z2));
    if (${fabs}(X.hi) + ${fabs}(Y.hi) + ${fabs}(Z.hi) <= ${carlson_close}*sum.hi) break;
    x = ${name}_pair_root(x2);
    y = ${name}_pair_root(y2);
    z = ${name}_pair_root(z2);
  }
  X = ${name}_pair_divide(X, sum);
  Y = ${name}_pair_divide(Y, sum);
  Z = ${name}_pair_divide(Z, sum);
  E2 = ${name}_pair_multiply(X, Y);
  E3 = ${name}_pair_multiply(E2, Z);
  E2 = ${name}_pair_subtract(E2, ${name}_pair_multiply(Z, Z));
  /* 1 - E2/10 + E3/14 + E2^2/24 - 3 E2 E3/44 - 5 E2^3/208 + 3 E3^2/104 + E2^2 E3/16; only the first two corrections
   * need more than the working precision */
  s = ${name}_pair_of(E2.hi*E2.hi/(${name}_real)24 - (${name}_real)3*E2.hi*E3.hi/(${name}_real)44
               + E2.hi*E2.hi*(E3.hi/(${name}_real)16 - (${name}_real)5*E2.hi/(${name}_real)208) + (${name}_real)3*E3.hi*E3.hi/(${name}_real)104);
  s = ${name}_pair_add(s, ${name}_pair_divide(E3, ${name}_pair_of((${name}_real)14)));
  s = ${name}_pair_subtract(s, ${name}_pair_divide(E2, ${name}_pair_of((${name}_real)10)));
  s = ${name}_pair_add(${name}_pair_of(${one}), s);
  return ${name}_pair_divide(s, ${name}_pair_root(${name}_pair_divide(sum, ${name}_pair_of((${name}_real)3))));
}
