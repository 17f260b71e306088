%% -- special.c -- functions that libm lacks, each only where it is used: part of scene.c.  SPDX-License-Identifier: MIT-0
/* ---- functions that libm lacks ---- */
%% if has_clamp then

/* x within low .. high, else the limit that is nearer; NaN counts as 0, so that what comes out is within the limits
 * whatever goes in, and drives nothing if they allow that */
static ${name}_real ${name}_clamp(${name}_real x, ${name}_real low, ${name}_real high)
{
  const ${name}_real number = x == x ? x : ${zero};
  return number > low ? (number < high ? number : high) : low;
}
%% end
%% if has_sign then

/* 1, -1, and 0 at 0 */
static ${name}_real ${name}_sign(${name}_real x)
{
  return x < ${zero} ? -${one} : x > ${zero} ? ${one} : ${zero};
}
%% end
%% if has_min then

static ${name}_real ${name}_min(${name}_real x, ${name}_real y)
{
  return y < x ? y : x;
}
%% end
%% if has_max then

static ${name}_real ${name}_max(${name}_real x, ${name}_real y)
{
  return x < y ? y : x;
}
%% end
%% if has_ellipsoid or has_sums then

static ${name}_pair ${name}_pair_quotient(${name}_pair a, ${name}_pair b)
{
  const ${name}_real q = a.hi/b.hi;
  ${name}_pair p = ${name}_pair_product(q, b.hi);

  return ${name}_pair_sum(q, (((a.hi - p.hi) - p.lo) + (a.lo - q*b.lo))/b.hi);
}
%% end
%% if has_ellipsoid then

/* one Newton step: sqrt(a) = r + (a - r^2)/(2 r) */
static ${name}_pair ${name}_positive_root(${name}_pair a)
{
  const ${name}_real r = ${sqrt}(a.hi);
  ${name}_pair p = ${name}_pair_product(r, r);

  return ${name}_pair_sum(r, (((a.hi - p.hi) - p.lo) + a.lo)/(${two}*r));
}

/* a times a power of two */
static ${name}_pair ${name}_pair_scaled(${name}_pair a, ${name}_real power)
{
  a.hi *= power;
  a.lo *= power;
  return a;
}

/* The ellipsoid of semi-axes a, b, c is r_i = a_i n_i, n on the unit sphere, with p_i = 1/a_i^2, Q = sum p_i n_i^2:
 *     dS = a b c sqrt(Q) dn,   unit normal N_i = n_i/(a_i sqrt(Q)),
 *     area/(4 pi) = a b c (H_a + H_b + H_c),   mean of N_a^2 = H_a/(H_a + H_b + H_c),
 *     H_i = mean of p_i n_i^2/sqrt(Q) = p_i (p_j D_j + p_k D_k)/6,   D_i = R_D(p_j, p_k, p_i)
 * (DLMF 19.33.1, 19.16.9, 19.21.8).  Duplication (19.26.18), with s_i = sqrt(p_i):
 *     D_i(p) = 3/(s_i d_i) + D_i(d/4)/4,   d_i = (s_i + s_j)(s_i + s_k).
 * All terms are positive: nothing cancels, on the sphere, on needles or on plates.  A step halves log(p_j/p_i); once
 * that is small a step makes the p_i four times more equal, and what is left, p^(-3/2), 64 times more exact.
 *
 * axis: sorted here, largest first.  h[i] = H_i times axis[2], in that order; returns their sum. */
static ${name}_pair ${name}_ellipsoid_parts(${name}_real axis[3], ${name}_pair h[3])
{
  ${name}_pair r[3], s[3], x[3], e[3], sum[3], t; /* r_i = s_i of the first step, e_i = r_i^2 D_i/3 */
  ${name}_real scale = ${one}, least, mean;
  int i, j, k, left = ${ellipsoid_steps};

  for (i = 0; i < 3; i++) {
    j = i % 2; /* neighbours 0 1, 1 2, 0 1: three values are sorted */
    if (axis[j] < axis[j + 1]) {
      least = axis[j];
      axis[j] = axis[j + 1];
      axis[j + 1] = least;
    }
  }
  for (i = 0; i < 3; i++) {
    r[i].hi = axis[2]/axis[i];
    r[i].lo = ${zero};
    /* a ratio that would vanish: no result depends on it to first order */
    if (r[i].hi < ${ellipsoid_least}) r[i].hi = ${ellipsoid_least};
    s[i] = r[i];
    x[i] = ${name}_pair_product(r[i].hi, r[i].hi);
    e[i].hi = e[i].lo = ${zero};
  }
  while (left > 0) { /* some 10 times */
    if (x[2].hi <= ${two}*x[0].hi) left--;
    for (i = 0; i < 3; i++) sum[i] = ${name}_add(s[(i + 1) % 3], s[(i + 2) % 3]);
    for (i = 0; i < 3; i++) {
      x[i] = ${name}_mul(sum[(i + 1) % 3], sum[(i + 2) % 3]);
      t = ${name}_mul(${name}_pair_quotient(r[i], s[i]), ${name}_pair_quotient(r[i], x[i]));
      e[i] = ${name}_add(e[i], ${name}_pair_scaled(t, scale));
      x[i] = ${name}_pair_scaled(x[i], ${quarter});
      s[i] = ${name}_positive_root(x[i]);
    }
    scale *= ${quarter};
  }
  for (i = 0; i < 3; i++) { /* the rest about the mean that R_D has no first-order term in (DLMF 19.19.7) */
    j = (i + 1) % 3;
    k = (i + 2) % 3;
    mean = (${three}*x[i].hi + x[j].hi + x[k].hi)/${five};
    t.hi = scale*(r[i].hi/${sqrt}(mean))*(r[i].hi/(${three}*mean));
    t.lo = ${zero};
    e[i] = ${name}_add(e[i], t);
  }
  for (i = 0; i < 3; i++) {
    t = ${name}_pair_scaled(${name}_add(e[(i + 1) % 3], e[(i + 2) % 3]), ${half});
    h[i] = ${name}_mul(r[i], ${name}_mul(r[i], t));
  }
  return ${name}_add(${name}_add(h[0], h[1]), h[2]);
}
%% end
%% if has_ellipsoid_area then

/* area of the ellipsoid of semi-axes a, b, c > 0, divided by 4 pi */
static ${name}_real ${name}_ellipsoid_area(${name}_real a, ${name}_real b, ${name}_real c)
{
  ${name}_real axis[3];
  ${name}_pair h[3], sum;

  axis[0] = a;
  axis[1] = b;
  axis[2] = c;
  sum = ${name}_ellipsoid_parts(axis, h);
  return axis[0]*(axis[1]*sum.hi);
}
%% end
%% if has_ellipsoid_normal then

/* mean over that surface of the square of the unit normal's component along a */
static ${name}_real ${name}_ellipsoid_normal(${name}_real a, ${name}_real b, ${name}_real c)
{
  ${name}_real axis[3];
  ${name}_pair h[3], sum;

  axis[0] = a;
  axis[1] = b;
  axis[2] = c;
  sum = ${name}_ellipsoid_parts(axis, h);
  return h[(b > a) + (c > a)].hi/sum.hi;
}
%% end
${series}
