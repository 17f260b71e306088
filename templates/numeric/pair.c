%% -- pair.c -- arithmetic of twice the precision: part of scene.c.  SPDX-License-Identifier: MIT-0
/* ---- pairs high + low carry twice the precision: Dekker 1971, Numer. Math. 18, 224; Knuth, TAOCP 2, 4.2.2 ---- */

typedef struct ${name}_pair {
  ${name}_real hi, lo;
} ${name}_pair;

/* a + b = hi + lo exactly (Knuth's two-sum) */
static ${name}_pair ${name}_pair_sum(${name}_real a, ${name}_real b)
{
  ${name}_pair s;
  ${name}_real bb;

  s.hi = a + b;
  bb = s.hi - a;
  s.lo = (a - (s.hi - bb)) + (b - bb);
  return s;
}

/* a*b = hi + lo exactly.  Where the machine has a fused operation compilers may fuse products into sums, which would
 * spoil Dekker's halves: there it is used, and volatile keeps hi what it is. */
static ${name}_pair ${name}_pair_product(${name}_real a, ${name}_real b)
{
#if defined ${fast_fma} || defined __${fast_fma} || defined __FMA__ || (defined __ARM_FEATURE_FMA && (__ARM_FP & ${arm_fma}))
  const volatile ${name}_real high = a*b;
  ${name}_pair p;

  p.hi = high;
  p.lo = ${fma}(a, b, -p.hi);
  return p;
#else
  const ${name}_real split = ${split}; /* Dekker's product, factors split in halves */
  ${name}_real c, ah, al, bh, bl;
  ${name}_pair p;

  c = split*a;
  ah = c - (c - a);
  al = a - ah;
  c = split*b;
  bh = c - (c - b);
  bl = b - bh;
  p.hi = a*b;
  p.lo = ((ah*bh - p.hi) + ah*bl + al*bh) + al*bl;
  return p;
#endif
}

static ${name}_pair ${name}_pair_of(${name}_real a)
{
  ${name}_pair p;

  p.hi = a;
  p.lo = ${zero};
  return p;
}

static ${name}_pair ${name}_pair_minus(${name}_pair a)
{
  a.hi = -a.hi;
  a.lo = -a.lo;
  return a;
}

%% if add or multiply then
/* hi + lo = the same, |lo| <= |hi| or hi a multiple of the last place of lo (Dekker's fast two-sum) */
static ${name}_pair ${name}_pair_tidy(${name}_real hi, ${name}_real lo)
{
  ${name}_pair s;

  s.hi = hi + lo;
  s.lo = lo - (s.hi - hi);
  return s;
}

%% end
%% if add then
static ${name}_pair ${name}_pair_add(${name}_pair a, ${name}_pair b)
{
  ${name}_pair s = ${name}_pair_sum(a.hi, b.hi);

  return ${name}_pair_tidy(s.hi, s.lo + (a.lo + b.lo));
}

%% end
%% if multiply then
static ${name}_pair ${name}_pair_multiply(${name}_pair a, ${name}_pair b)
{
  ${name}_pair p = ${name}_pair_product(a.hi, b.hi);

  return ${name}_pair_tidy(p.hi, p.lo + (a.hi*b.lo + a.lo*b.hi));
}
%% end
