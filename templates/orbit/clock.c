%% -- clock.c -- integrals of exp(-rate t), regular at rate = 0: part of scene.c.  SPDX-License-Identifier: MIT-0
/* ---- the means of exp ----
 * f1 = (exp(y) - 1)/y and f2 = (exp(y) - 1 - y)/y^2, in pairs: from f2 = 1/2 + z/3! + z^2/4! + ..., f1 = 1 + z f2 at
 * z = y/2^n, |z| < 1/16, by n doublings,
 *     f2(2z) = f2/2 + (f1/2)^2,   f1(2z) = f1 (1 + z f1/2).
 * Where y < 0 neither can cancel: 0 < f1, f2 and -1 < z f1. */
%% if axial then
static void ${name}_means(${name}_pair y, ${name}_pair *f1, ${name}_pair *f2)
%% else
static ${name}_pair ${name}_mean(${name}_pair y)
%% end
{
  const ${name}_pair one = ${name}_pair_of(${one}), half = ${name}_pair_of(${half});
  ${name}_pair z, a, b, s = one;
  int i, n;

  (void)${frexp}(y.hi, &n);
  n = n > -4 ? n + 4 : 0;
  z.hi = ${ldexp}(y.hi, -n);
  z.lo = ${ldexp}(y.lo, -n);
  for (i = 17; i > 8; i--) s.hi = ${one} + z.hi*s.hi/(${name}_real)i; /* terms below 2^-40: the working precision will do */
  for (; i > 2; i--) s = ${name}_add(one, ${name}_ratio(${name}_mul(z, s), ${name}_pair_of((${name}_real)i)));
  b = ${name}_mul(half, s);
  a = ${name}_add(one, ${name}_mul(z, b));
  for (i = 0; i < n; i++) { /* some 6 times */
    const ${name}_pair h = ${name}_mul(half, a);

%% if axial then
    b = ${name}_add(${name}_mul(half, b), ${name}_mul(h, h));
%% end
    a = ${name}_mul(a, ${name}_add(one, ${name}_mul(z, h)));
    z = ${name}_add(z, z);
  }
%% if axial then
  *f1 = a;
  *f2 = b;
%% else
  return a;
%% end
}
%% if axial then

/* exp(y) of a pair, rounded */
static ${name}_real ${name}_exponential(${name}_pair y)
{
  const ${name}_real e = ${exp}(y.hi);

  return e + e*y.lo;
}
%% else

/* (1 - exp(-rate t))/rate: the time of the free motion at the time t of the damped one */
static ${name}_pair ${name}_free_time(${name}_real rate, ${name}_real t)
{
  return ${name}_mul(${name}_pair_of(t), ${name}_mean(${name}_pair_product(-rate, t)));
}

/* exp(-rate t) */
static ${name}_real ${name}_fading(${name}_real rate, ${name}_real t)
{
  const ${name}_pair p = ${name}_pair_product(-rate, t);
  const ${name}_real e = ${exp}(p.hi);

  return e + e*p.lo;
}
%% end
