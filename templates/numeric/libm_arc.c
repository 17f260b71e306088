%% -- libm_arc.c -- inverse circular functions: part of scene.c.  SPDX-License-Identifier: MIT-0
%% if need.angle then
/* The angle of the point (x + dx, y + dy), x and y >= 0 and not both 0, as a number and what it is missing.  In the first
 * octant, arctan y/x = arctan b + arctan((y - b x)/(x + b y)), b = 0, 1/2, 1 (DLMF 4.24.15): the numerator is exact, what
 * the quotient is missing follows from its remainder. */
static ${name}_real ${name}_libm_angle(${name}_real y, ${name}_real dy, ${name}_real x, ${name}_real dx, ${name}_real *rest)
{
  const int steep = y > x;
  const ${name}_real v = steep ? x : y, u = steep ? y : x, dv = steep ? dx : dy, du = steep ? dy : dx;
  ${name}_real n = v, d = u, dn = dv, dd = du, base = ${zero}, low = ${zero}, t, z;

  if (v < ${tiny}*u) {
    t = v/u;
    low = ${zero};
  } else {
    if (v >= ${arc_second}*u) {
      n = v - u;
      d = u + v;
      dn = dv - du;
      dd = ((u - d) + v) + (du + dv);
      base = ${quarter_pi_high};
      low = ${quarter_pi_low};
    } else if (v >= ${quarter}*u) {
      n = ${two}*v - u;
      d = ${two}*u + v;
      dn = ${two}*dv - du;
      dd = ((${two}*u - d) + v) + (${two}*du + dv);
      base = ${arc_half_high};
      low = ${arc_half_low};
    }
    t = n/d;
    n = (n - ${name}_libm_product(t, d, &z)) - z;
    low += (n + dn - t*dd)/d;
    z = t*t;
    {
%% for _, line in ipairs(arc_lines) do
      ${line}
%% end

      low += t*(z*p);
    }
  }
  z = base + t;
  low += (base - z) + t;
  if (steep) {
    t = ${half_pi_high} - z;
    low = ((${half_pi_high} - t) - z) + (${half_pi_low} - low);
    z = t;
  }
  *rest = low;
  return z;
}

%% end
%% if need.supplement then
/* pi - (a + rest) */
static ${name}_real ${name}_libm_supplement(${name}_real a, ${name}_real rest)
{
  const ${name}_real left = ${two}*${half_pi_high} - a;

  return left + (((${two}*${half_pi_high} - left) - a) + (${two}*${half_pi_low} - rest));
}

%% end
%% if need.atan then
static ${name}_real ${name}_atan(${name}_real x)
{
  const ${name}_real size = ${name}_fabs(x);
  ${name}_real a, rest;

  if (!(size >= ${tiny})) return x; /* also no number */
  a = ${name}_libm_angle(size, ${zero}, ${one}, ${zero}, &rest);
  a += rest;
  return x < ${zero} ? -a : a;
}

%% end
%% if need.atan2 then
static ${name}_real ${name}_atan2(${name}_real y, ${name}_real x)
{
  const ${uint} left = ${name}_libm_bits(x) & ${sign}, below = ${name}_libm_bits(y) & ${sign};
  ${name}_real u = ${name}_fabs(x), v = ${name}_fabs(y), far, rest = ${zero}, a = ${zero};
  int k;

  if (!(x == x && y == y)) return x + y; /* no number */
  if (v > ${zero}) {
    far = v > u ? v : u;
    if (!(far - far == ${zero})) { /* infinity: a direction of the axes or between them */
      u = u < far ? ${zero} : ${one};
      v = v < far ? ${zero} : ${one};
    } else if ((v > u ? u : v) >= ${tiny}*far) { /* to where nothing over- or underflows, exact */
      (void)${name}_frexp(far, &k);
      u = ${name}_ldexp(u, -k);
      v = ${name}_ldexp(v, -k);
    }
    a = ${name}_libm_angle(v, ${zero}, u, ${zero}, &rest);
  }
  a = left ? ${name}_libm_supplement(a, rest) : a + rest;
  return below ? -a : a;
}

%% end
%% if need.beside then
/* sqrt(1 - x^2), |x| <= 1, and what it is missing: one Newton step */
static ${name}_real ${name}_libm_beside(${name}_real x, ${name}_real *rest)
{
  ${name}_real low, part;
  const ${name}_real square = ${name}_libm_product(x, x, &low), a = ${one} - square, r = ${name}_sqrt(a);

  low = ((${one} - a) - square) - low;
  *rest = r > ${zero} ? (((a - ${name}_libm_product(r, r, &part)) - part) + low)/(${two}*r) : ${zero};
  return r;
}

%% end
%% if need.asin then
static ${name}_real ${name}_asin(${name}_real x)
{
  const ${name}_real size = ${name}_fabs(x);
  ${name}_real a, rest;

  if (!(size <= ${one})) return (x - x)/(x - x); /* no number */
  if (size < ${tiny}) return x;
  a = ${name}_libm_beside(size, &rest);
  a = ${name}_libm_angle(size, ${zero}, a, rest, &rest);
  a += rest;
  return x < ${zero} ? -a : a;
}

%% end
%% if need.acos then
static ${name}_real ${name}_acos(${name}_real x)
{
  const ${name}_real size = ${name}_fabs(x);
  ${name}_real a, rest;

  if (!(size <= ${one})) return (x - x)/(x - x); /* no number */
  a = ${name}_libm_beside(size, &rest);
  a = ${name}_libm_angle(a, rest, size, ${zero}, &rest);
  return x < ${zero} ? ${name}_libm_supplement(a, rest) : a + rest;
}

%% end
