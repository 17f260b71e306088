%% -- lagrange_at.c -- the heavy top at any time: part of scene.c.  SPDX-License-Identifier: MIT-0
/* X of a, b and W at the phase r: see lagrange_theta.c */
static void ${name}_circular_at(const ${name}_orbit *o, ${name}_real r, ${name}_real X[3][2])
{
  ${name}_real s, c, x, re, im;
  int i;

  ${name}_sincos(r, &s, &c);
  x = (c - s)*(c + s);
  for (i = 0; i < 3; i++) {
    re = o->re[i][0] + x*(o->re[i][1] + x*(o->re[i][2] + x*o->re[i][3]));
    im = o->im[i][0] + x*(o->im[i][1] + x*(o->im[i][2] + x*o->im[i][3]));
    X[i][0] = (i == 0 ? s : c)*re;
    X[i][1] = (i == 0 ? c : s)*im;
  }
  s *= o->winding;
  re = X[2][0];
  im = X[2][1];
  X[2][0] = c*re - s*im;
  X[2][1] = c*im + s*re;
}

/* low: what r lacks */
static void ${name}_hyperbolic_at(const ${name}_orbit *o, ${name}_real r, ${name}_real low, ${name}_real X[3][2])
{
  const ${name}_real sign = r < ${zero} ? -${one} : ${one}, first = ${exp}(-${fabs}(r)), e = (first - first*(sign*low)) + ${least};
  const ${name}_real root = o->nome/e, g = root*root;
  const ${name}_real E = e*e, h = (o->nome*e)*(o->nome*e), g2 = g*g, h2 = h*h, f = E*E*g;
  int i;

  X[0][0] = (o->re[0][0] + g*(o->re[0][1] + g*(o->re[0][2] + g*o->re[0][3])))
            - E*(o->re[0][0] + f*(o->re[0][1] + f*(o->re[0][2] + f*o->re[0][3])));
  X[0][1] = (o->im[0][0] + g*(o->im[0][1] + g*(o->im[0][2] + g*o->im[0][3])))
            + E*(o->im[0][0] + f*(o->im[0][1] + f*(o->im[0][2] + f*o->im[0][3])));
  X[0][0] *= sign;
  for (i = 1; i < 3; i++) {
    X[i][0] = e*(o->re[i][0] + o->re[i][1]*(g + h) + o->re[i][2]*(g2 + h2) + o->re[i][3]*(g2*g + h2*h));
    X[i][1] = sign*e*(o->im[i][1]*(g - h) + o->im[i][2]*(g2 - h2) + o->im[i][3]*(g2*g - h2*h));
  }
}

/* y = w, x, y, z of the quaternion a = w + i z, b = x + i y, and f = conj(a) b/|..| W, all but for one factor: X after
 * turns[] of a and b, of either sign (flip) */
static void ${name}_turned(const ${name}_real X[3][2], ${name}_real flip, const ${name}_real turns[2], ${name}_real y[4], ${name}_real f[2])
{
  ${name}_real s[2], c[2], half, re, im;
  int i;

  for (i = 0; i < 2; i++) {
    ${name}_sincos(turns[i], &s[i], &half); /* half of it */
    c[i] = (half - s[i])*(half + s[i]);
    s[i] *= ${two}*half;
  }
  y[0] = flip*(c[0]*X[0][0] - s[0]*X[0][1]);
  y[3] = flip*(s[0]*X[0][0] + c[0]*X[0][1]);
  y[1] = flip*(c[1]*X[1][0] - s[1]*X[1][1]);
  y[2] = flip*(s[1]*X[1][0] + c[1]*X[1][1]);
  re = c[0]*c[1] + s[0]*s[1];
  im = c[0]*s[1] - s[0]*c[1];
  f[0] = re*X[2][0] - im*X[2][1];
  f[1] = im*X[2][0] + re*X[2][1];
}

/* phase of the nutation, less the nearest multiple of its period; of a and b, less whole turns; and (-1) to the multiple */
static void ${name}_reduce(const ${name}_orbit *o, ${name}_real t, ${name}_real *r, ${name}_real *low, ${name}_real turns[2], ${name}_real *flip)
{
  ${name}_pair p = {o->start[0], o->start[1]}, whole, jump;
  ${name}_real n;
  int i;

  p = ${name}_phase(p, o->rate, t);
  n = ${name}_nearest(p.hi*o->inverse);
  *flip = ${one} - ${two}*${fabs}(n - ${two}*${name}_nearest(${half}*n));
  whole = ${name}_pair_product(n, o->period[0]);
  whole = ${name}_pair_sum(p.hi - whole.hi, p.lo - whole.lo - n*o->period[1]);
  *low = whole.lo;
  /* beyond some 2^50 periods or turns nothing is left of a phase; it stays in its range */
  *r = ${fabs}(whole.hi)*o->inverse <= ${one} ? whole.hi : ${zero};
  for (i = 0; i < 2; i++) {
    jump = ${name}_pair_product(n, o->jump[i][0]);
    jump.lo += n*o->jump[i][1];
    p = ${name}_phase(jump, o->turn[i], t);
    turns[i] = (p.hi - ${name}_nearest(p.hi)) + p.lo;
    if (!(${fabs}(turns[i]) <= ${one})) turns[i] = ${zero};
  }
}

static void ${name}_functions(const ${name}_orbit *o, ${name}_real t, ${name}_real y[4], ${name}_real f[2])
{
  ${name}_real r, low, flip, turns[2], X[3][2];

  ${name}_reduce(o, t, &r, &low, turns, &flip);
  if (o->hyperbolic) ${name}_hyperbolic_at(o, r, low, X);
  else ${name}_circular_at(o, r, X);
  ${name}_turned((const ${name}_real(*)[2])X, flip, turns, y, f);
}

/* quaternion and rates at x[0], x[stride], ..; what is not wanted is not stored */
static void ${name}_put(const ${name}_orbit *o, const ${name}_real y[4], const ${name}_real f[2], ${name}_real q[], ${name}_real w[])
{
  const ${name}_real n = ${one}/${sqrt}(y[0]*y[0] + y[1]*y[1] + y[2]*y[2] + y[3]*y[3]);
  int i;

  for (i = 0; i < 3; i++) w[i] = o->along[i] + n*(f[0]*o->across[0][i] + f[1]*o->across[1][i]);
  for (i = 0; i < 4; i++) q[i] = n*(y[0]*o->q[0][i] + y[1]*o->q[1][i] + y[2]*o->q[2][i] + y[3]*o->q[3][i]);
  { /* rounding only: one Newton step for 1/|q| */
    const ${name}_real g = ${threehalves} - ${half}*(q[0]*q[0] + q[1]*q[1] + q[2]*q[2] + q[3]*q[3]);

    for (i = 0; i < 4; i++) q[i] *= g;
  }
}

void ${name}_at(const ${name}_orbit *o, ${name}_real t, ${name}_real x[])
{
  ${name}_real y[4], f[2];

  ${name}_functions(o, t, y, f);
  ${name}_put(o, y, f, x + ${upper}_QW, x + ${upper}_WX);
}

void ${name}_at_rates(const ${name}_orbit *o, ${name}_real t, ${name}_real w[])
{
  ${name}_real y[4], f[2], q[4];

  ${name}_functions(o, t, y, f);
  ${name}_put(o, y, f, q, w);
}

void ${name}_at_attitude(const ${name}_orbit *o, ${name}_real t, ${name}_real q[])
{
  ${name}_real y[4], f[2], w[3];

  ${name}_functions(o, t, y, f);
  ${name}_put(o, y, f, q, w);
}

void ${name}_at_many(const ${name}_orbit *o, int n, const ${name}_real t[], ${name}_real x[])
{
  int k, i;

  for (k = 0; k < n; k++) {
    ${name}_real y[4], f[2], state[${upper}_NX];

    ${name}_functions(o, t[k], y, f);
    ${name}_put(o, y, f, state + ${upper}_QW, state + ${upper}_WX);
    for (i = 0; i < ${upper}_NX; i++) x[i*n + k] = state[i];
  }
}

${name}_real ${name}_nutation_period(const ${name}_orbit *o)
{
  if (!(o->rate[0] > ${zero})) return ${zero};
  return o->inverse > ${zero} ? o->period[0]/o->rate[0] : ${huge};
}

${name}_real ${name}_precession_rate(const ${name}_orbit *o)
{
  return o->mean;
}

void ${name}_nutation_range(const ${name}_orbit *o, ${name}_real tilt[2])
{
  tilt[0] = o->tilt[0];
  tilt[1] = o->tilt[1];
}
