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

/* y = -rate t, less than 0 where it decays; beyond ${clock_end} it is that: no result within the range of the type is so
 * far.  rate and t are scaled, so that the product of huge and tiny ones neither over- nor underflows in a split. */
static ${name}_pair ${name}_passed_decays(${name}_real rate, ${name}_real t)
{
  ${name}_real y;
  int e;

  (void)${frexp}(t, &e);
  rate = ${ldexp}(-rate, e);
  t = ${ldexp}(t, -e);
  y = rate*t;
  if (y > ${clock_end}) return ${name}_pair_of(${clock_end});
  if (y < -${clock_end}) return ${name}_pair_of(-${clock_end});
  return ${name}_pair_product(rate, t);
}

/* (1 - exp(-rate t))/rate: the time of the free motion at the time t of the damped one; within -o->last and o->last, as
 * the free motion takes its own time.  It is t f1(y) with the last doubling of f1 after the product by t: so nothing
 * overflows but what is later than o->last. */
static ${name}_pair ${name}_free_time(const ${name}_orbit *o, ${name}_real t, ${name}_pair y)
{
  const ${name}_pair z = {${half}*y.hi, ${half}*y.lo};
  const ${name}_pair end = ${name}_pair_of(t < ${zero} ? -o->last : o->last);
  ${name}_pair f, doubled, time;

  if (y.hi < -${clock_rest}) { /* exp(y) is nothing beside 1 */
    if (!(${fabs}(o->decay)*o->last > ${one})) return end;
    time = ${name}_ratio(${name}_pair_of(${one}), ${name}_pair_of(o->decay));
  } else {
    if (y.hi > ${clock_growth} || ${fabs}(t) > ${clock_late}) return end;
    f = ${name}_mean(z);
    doubled = ${name}_add(${name}_pair_of(${one}), ${name}_mul(z, ${name}_mul(${name}_pair_of(${half}), f)));
    f = ${name}_mul(${name}_pair_of(t), f);
    if (${fabs}(f.hi*doubled.hi) > o->last) return end;
    time = ${name}_mul(f, doubled);
  }
  return ${fabs}(time.hi) > o->last ? end : time; /* no number stays none */
}

/* what the low part of the time adds to a phase of that rate, less whole turns */
static ${name}_real ${name}_turns_of(${name}_real rate, ${name}_real low)
{
  const ${name}_pair turns = ${name}_pair_product(rate, low);

  return (turns.hi - ${name}_nearest(turns.hi)) + turns.lo;
}

/* w times exp(y).  Where that alone is beyond the range of the type, its fourth root, four times: a rate of 0 stays
 * 0, a huge one that fades and a tiny one that grows are right, and what is beyond the range is infinite or 0. */
static void ${name}_fade(${name}_pair y, ${name}_real w[3])
{
  const int far = ${fabs}(y.hi) > ${clock_fade};
  const ${name}_real part = far ? ${quarter} : ${one}, e = ${exp}(part*y.hi), factor = e + e*(part*y.lo);

  for (int i = 0; i < 3; i++) {
    w[i] *= factor;
    if (far) w[i] = ((w[i]*factor)*factor)*factor;
  }
}
%% end
