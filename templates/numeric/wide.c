%% -- wide.c -- pairs with an exponent of their own, for the set-up of the heavy top: part of scene.c.  SPDX-License-Identifier: MIT-0
/* ---- p 2^e, 1/2 <= |p| < 1 or p = 0: twice the precision, and a range in which nothing over- or underflows ---- */

typedef struct ${name}_wide { ${name}_pair p; int e; } ${name}_wide;

/* p 2^e */
static ${name}_wide ${name}_wide_of(${name}_pair p, int e)
{
  const ${name}_wide zero = {{${zero}, ${zero}}, 0};
  int k;
  if (!(${fabs}(p.hi) > ${zero})) return zero;
  (void)${frexp}(p.hi, &k);
  const ${name}_wide w = {${name}_pair_scale(p, -k), e + k};
  return w;
}

static ${name}_wide ${name}_wide_real(${name}_real a)
{
  int k;
  const ${name}_real fraction = ${frexp}(a, &k);

  return ${name}_wide_of(${name}_pair_of(fraction), k);
}

/* a 2^-e as a pair: 0 where that underflows */
static ${name}_pair ${name}_wide_pair(${name}_wide a, int e)
{
  return ${name}_pair_scale(a.p, a.e - e);
}

static int ${name}_wide_sign(${name}_wide a)
{
  return (a.p.hi > ${zero}) - (a.p.hi < ${zero});
}

/* the exponent; that of 0 is below all others */
static int ${name}_wide_size(${name}_wide a)
{
  return ${name}_wide_sign(a) ? a.e : ${no_exponent};
}

/* a 2^k */
static ${name}_wide ${name}_wide_scale(${name}_wide a, int k)
{
  if (${name}_wide_sign(a)) a.e += k;
  return a;
}

static ${name}_wide ${name}_wide_minus(${name}_wide a)
{
  a.p = ${name}_minus(a.p);
  return a;
}

static ${name}_wide ${name}_wide_mul(${name}_wide a, ${name}_wide b)
{
  return ${name}_wide_of(${name}_mul(a.p, b.p), a.e + b.e);
}

/* b is not 0 */
static ${name}_wide ${name}_wide_ratio(${name}_wide a, ${name}_wide b)
{
  return ${name}_wide_of(${name}_ratio(a.p, b.p), a.e - b.e);
}

static ${name}_wide ${name}_wide_add(${name}_wide a, ${name}_wide b)
{
  if (${name}_wide_size(a) < ${name}_wide_size(b)) {
    const ${name}_wide t = a;

    a = b;
    b = t;
  }
  if (${name}_wide_size(b) < a.e - 120) return a; /* below the last digit */
  return ${name}_wide_of(${name}_add(a.p, ${name}_pair_scale(b.p, b.e - a.e)), a.e);
}

static ${name}_wide ${name}_wide_sub(${name}_wide a, ${name}_wide b)
{
  return ${name}_wide_add(a, ${name}_wide_minus(b));
}

/* 0 of what is not positive */
static ${name}_wide ${name}_wide_root(${name}_wide a)
{
  const int odd = a.e & 1;

  if (${name}_wide_sign(a) <= 0) return ${name}_wide_real(${zero});
  return ${name}_wide_of(${name}_pair_root(${name}_pair_scale(a.p, odd)), (a.e - odd)/2);
}

static ${name}_wide ${name}_wide_square(${name}_wide a)
{
  return ${name}_wide_mul(a, a);
}

/* a b + c d */
static ${name}_wide ${name}_wide_dot(${name}_wide a, ${name}_wide b, ${name}_wide c, ${name}_wide d)
{
  return ${name}_wide_add(${name}_wide_mul(a, b), ${name}_wide_mul(c, d));
}

/* sqrt(f) R_F(x, y, z), homogeneous of degree 0: an argument tau of the above.  `infinite` if two of x, y, z are 0.  Where
 * two are small, R_F(x^2, y^2, 1) = log(4/(x + y)) to their square (DLMF 19.27.2): in pairs one of them could be 0. */
static ${name}_pair ${name}_argument(${name}_wide f, ${name}_wide x, ${name}_wide y, ${name}_wide z, int *infinite)
{
  const ${name}_wide r[3] = {${name}_wide_root(x), ${name}_wide_root(y), ${name}_wide_root(z)}, root = ${name}_wide_root(f);
  int top = ${no_exponent}, zeros = 0, at = 0;

  for (int i = 0; i < 3; i++) {
    zeros += !${name}_wide_sign(r[i]);
    if (${name}_wide_size(r[i]) > top) {
      top = ${name}_wide_size(r[i]);
      at = i;
    }
  }
  *infinite = zeros >= 2;
  if (zeros >= 2) return ${name}_pair_of(${zero});
  const ${name}_wide small = ${name}_wide_add(r[(at + 1) % 3], r[(at + 2) % 3]);
  if (${name}_wide_size(small) < top - 60) {
    const ${name}_wide over = ${name}_wide_ratio(r[at], small);

    return ${name}_mul(${name}_wide_pair(${name}_wide_ratio(root, r[at]), 0), ${name}_pair_log(over.p, over.e + 2));
  }
  return ${name}_mul(${name}_wide_pair(root, top),
               ${name}_carlson(${name}_wide_pair(r[0], top), ${name}_wide_pair(r[1], top), ${name}_wide_pair(r[2], top)));
}
