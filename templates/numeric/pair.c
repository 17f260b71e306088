%% -- pair.c -- arithmetic of twice the precision: part of scene.c.  SPDX-License-Identifier: MIT-0
/* ---- pairs high + low carry twice the precision: Dekker 1971, Numer. Math. 18, 224; Knuth, TAOCP 2, 4.2.2 ---- */

typedef struct ${name}_pair { ${name}_real hi, lo; } ${name}_pair;

static ${name}_pair ${name}_parts(${name}_real hi, ${name}_real lo)
{
  const ${name}_pair p = {hi, lo};
  return p;
}

static ${name}_pair ${name}_pair_of(${name}_real a)
{
  return ${name}_parts(a, ${zero});
}

static ${name}_pair ${name}_minus(${name}_pair a)
{
  return ${name}_parts(-a.hi, -a.lo);
}

/* a + b = hi + lo exactly (Knuth's two-sum) */
static ${name}_pair ${name}_pair_sum(${name}_real a, ${name}_real b)
{
  const ${name}_real s = a + b, bb = s - a;
  return ${name}_parts(s, (a - (s - bb)) + (b - bb));
}

/* Does the machine fuse a*b + c?  Then compilers may do so unasked, which spoils Dekker's halves. */
#if defined ${fast_fma} || defined __${fast_fma} || defined __FMA__ || (defined __ARM_FEATURE_FMA && (__ARM_FP & ${arm_fma}))
#define ${upper}_FUSES
#endif

/* a*b = hi + lo exactly (Dekker's product, of factors in halves); volatile keeps hi what it is */
static ${name}_pair ${name}_pair_product(${name}_real a, ${name}_real b)
{
#ifdef ${upper}_FUSES
  const volatile ${name}_real product = a*b;
  const ${name}_real hi = product;
  return ${name}_parts(hi, ${fma}(a, b, -hi));
#else
  const ${name}_real c = ${split}*a, ah = c - (c - a), al = a - ah;
  const ${name}_real d = ${split}*b, bh = d - (d - b), bl = b - bh, hi = a*b;
  return ${name}_parts(hi, ((ah*bh - hi) + ah*bl + al*bh) + al*bl);
#endif
}

%% if add or multiply then
/* the same for |lo| <= |hi|, or hi a multiple of the last place of lo (Dekker's fast two-sum) */
static ${name}_pair ${name}_pair_tidy(${name}_real hi, ${name}_real lo)
{
  const ${name}_real s = hi + lo;
  return ${name}_parts(s, lo - (s - hi));
}

%% end
%% if add then
static ${name}_pair ${name}_add(${name}_pair a, ${name}_pair b)
{
  const ${name}_pair s = ${name}_pair_sum(a.hi, b.hi);
  return ${name}_pair_tidy(s.hi, s.lo + (a.lo + b.lo));
}

%% end
%% if multiply then
static ${name}_pair ${name}_mul(${name}_pair a, ${name}_pair b)
{
  const ${name}_pair p = ${name}_pair_product(a.hi, b.hi);
  return ${name}_pair_tidy(p.hi, p.lo + (a.hi*b.lo + a.lo*b.hi));
}
%% end
