%% -- lagrange_at.c -- the heavy top at any time: part of scene.c.  SPDX-License-Identifier: MIT-0
/* w, x, y, z of a = w + i z, b = x + i y, and the rates across the axis, all but for one factor */
typedef struct ${name}_values {
  ${name}_real w, x, y, z, f, g;
} ${name}_values;

/* X of a, b and W, see lagrange_theta.c, after turns of a and b; flip: the sign of both */
${upper}_INLINE ${name}_values ${name}_turned(const ${name}_real re[3], const ${name}_real im[3], ${name}_real flip,
                                              ${name}_real turn_a, ${name}_real turn_b)
{
  ${name}_values v;
  ${name}_real sa, ca, sb, cb, re_, im_;

  ${name}_circle(turn_a, &sa, &ca);
  ${name}_circle(turn_b, &sb, &cb);
  v.w = flip*(ca*re[0] - sa*im[0]);
  v.z = flip*(sa*re[0] + ca*im[0]);
  v.x = flip*(cb*re[1] - sb*im[1]);
  v.y = flip*(sb*re[1] + cb*im[1]);
  re_ = ca*cb + sa*sb;
  im_ = ca*sb - sa*cb;
  v.f = re_*re[2] - im_*im[2];
  v.g = im_*re[2] + re_*im[2];
  return v;
}

/* high + low: the phase of the nutation, less whole periods, and the sign of their number; the turns of a and b, less
 * whole ones */
typedef struct ${name}_phases {
  ${name}_real high, low, flip, a, b;
} ${name}_phases;

/* p less whole turns; where nothing is left of a phase, beyond some 2^50 of them, it is put to 0 */
${upper}_INLINE ${name}_real ${name}_fraction_of(${name}_pair p)
{
  const ${name}_real x = (p.hi - ${name}_nearest(p.hi)) + p.lo;

  return ${fabs}(x) <= ${one} ? x : ${zero};
}

/* (-1)^n */
${upper}_INLINE ${name}_real ${name}_parity(${name}_real n)
{
  return ${one} - ${two}*${fabs}(n - ${two}*${name}_nearest(${half}*n));
}

/* away from the separatrix: in half turns of z */
${upper}_INLINE ${name}_phases ${name}_circular_phases(const ${name}_orbit *o, ${name}_real t)
{
  const ${name}_pair start = {o->start[0], o->start[1]}, none = {${zero}, ${zero}};
  const ${name}_pair p = ${name}_phase(start, o->rate, t);
  ${name}_phases f;

  f.flip = ${name}_parity(${name}_nearest(p.hi));
  f.high = ${name}_fraction_of(p);
  f.low = ${zero};
  f.a = ${name}_fraction_of(${name}_phase(none, o->turn[0], t));
  f.b = ${name}_fraction_of(${name}_phase(none, o->turn[1], t));
  return f;
}

/* near it: the phase has the period P, or none, and the turns jump with each */
static ${name}_phases ${name}_hyperbolic_phases(const ${name}_orbit *o, ${name}_real t)
{
  ${name}_pair p = {o->start[0], o->start[1]}, whole, jump;
  ${name}_phases f;
  ${name}_real n;

  p = ${name}_phase(p, o->rate, t);
  n = ${name}_nearest(p.hi*o->inverse);
  f.flip = ${name}_parity(n);
  whole = ${name}_pair_product(n, o->period[0]);
  p = ${name}_pair_sum(p.hi - whole.hi, p.lo - whole.lo - n*o->period[1]);
  f.high = ${fabs}(p.hi)*o->inverse <= ${one} ? p.hi : ${zero};
  f.low = p.lo;
  jump = ${name}_pair_product(n, o->jump[0][0]);
  jump.lo += n*o->jump[0][1];
  f.a = ${name}_fraction_of(${name}_phase(jump, o->turn[0], t));
  jump = ${name}_pair_product(n, o->jump[1][0]);
  jump.lo += n*o->jump[1][1];
  f.b = ${name}_fraction_of(${name}_phase(jump, o->turn[1], t));
  return f;
}

/* the series as polynomials in cos 2z */
${upper}_INLINE ${name}_values ${name}_circular_values(const ${name}_orbit *o, ${name}_phases p)
{
  ${name}_real s, c, x, x2, re[3], im[3], cw, sw, f;

  ${name}_circle(${half}*p.high, &s, &c);
  x = (c - s)*(c + s);
  x2 = x*x;
  re[0] = s*((o->re[0][0] + x*o->re[0][1]) + x2*(o->re[0][2] + x*o->re[0][3]));
  im[0] = c*((o->im[0][0] + x*o->im[0][1]) + x2*(o->im[0][2] + x*o->im[0][3]));
  re[1] = c*((o->re[1][0] + x*o->re[1][1]) + x2*(o->re[1][2] + x*o->re[1][3]));
  im[1] = s*((o->im[1][0] + x*o->im[1][1]) + x2*(o->im[1][2] + x*o->im[1][3]));
  cw = c*((o->re[2][0] + x*o->re[2][1]) + x2*(o->re[2][2] + x*o->re[2][3]));
  sw = s*((o->im[2][0] + x*o->im[2][1]) + x2*(o->im[2][2] + x*o->im[2][3]));
  f = o->winding*s;
  re[2] = c*cw - f*sw;
  im[2] = c*sw + f*cw;
  return ${name}_turned(re, im, p.flip, p.a, p.b);
}

/* in e = exp(-|phase|) and g = q' e^-2 <= 1 */
static ${name}_values ${name}_hyperbolic_values(const ${name}_orbit *o, ${name}_phases p)
{
  const ${name}_real sign = p.high < ${zero} ? -${one} : ${one}, first = ${exp}(-${fabs}(p.high));
  const ${name}_real e = (first - first*(sign*p.low)) + ${least}, root = o->nome/e, g = root*root, E = e*e, f = E*E*g;
  const ${name}_real h = (o->nome*e)*(o->nome*e);
  ${name}_real re[3], im[3];
  int i;

  re[0] = sign*((o->re[0][0] + g*(o->re[0][1] + g*(o->re[0][2] + g*o->re[0][3])))
                - E*(o->re[0][0] + f*(o->re[0][1] + f*(o->re[0][2] + f*o->re[0][3]))));
  im[0] = (o->im[0][0] + g*(o->im[0][1] + g*(o->im[0][2] + g*o->im[0][3])))
          + E*(o->im[0][0] + f*(o->im[0][1] + f*(o->im[0][2] + f*o->im[0][3])));
  for (i = 1; i < 3; i++) {
    re[i] = e*(o->re[i][0] + o->re[i][1]*(g + h) + o->re[i][2]*(g*g + h*h) + o->re[i][3]*(g*g*g + h*h*h));
    im[i] = sign*e*(o->im[i][1]*(g - h) + o->im[i][2]*(g*g - h*h) + o->im[i][3]*(g*g*g - h*h*h));
  }
  return ${name}_turned(re, im, p.flip, p.a, p.b);
}

${upper}_INLINE ${name}_values ${name}_values_at(const ${name}_orbit *o, ${name}_real t)
{
  return o->hyperbolic ? ${name}_hyperbolic_values(o, ${name}_hyperbolic_phases(o, t)) :
                         ${name}_circular_values(o, ${name}_circular_phases(o, t));
}

${upper}_INLINE ${name}_real ${name}_square(const ${name}_values *v)
{
  return (v->w*v->w + v->z*v->z) + (v->x*v->x + v->y*v->y);
}

/* attitude and rates from the values and 1/length of their quaternion */
${upper}_INLINE void ${name}_put(const ${name}_orbit *o, const ${name}_values *v, ${name}_real n, ${name}_real q[4], ${name}_real w[3])
{
  ${name}_real r[4], g;

  w[0] = o->along[0] + n*(v->f*o->across[0][0] + v->g*o->across[1][0]);
  w[1] = o->along[1] + n*(v->f*o->across[0][1] + v->g*o->across[1][1]);
  w[2] = o->along[2] + n*(v->f*o->across[0][2] + v->g*o->across[1][2]);
  r[0] = n*((v->w*o->q[0][0] + v->x*o->q[1][0]) + (v->y*o->q[2][0] + v->z*o->q[3][0]));
  r[1] = n*((v->w*o->q[0][1] + v->x*o->q[1][1]) + (v->y*o->q[2][1] + v->z*o->q[3][1]));
  r[2] = n*((v->w*o->q[0][2] + v->x*o->q[1][2]) + (v->y*o->q[2][2] + v->z*o->q[3][2]));
  r[3] = n*((v->w*o->q[0][3] + v->x*o->q[1][3]) + (v->y*o->q[2][3] + v->z*o->q[3][3]));
  /* rounding only: one Newton step for 1/|q| */
  g = ${threehalves} - ${half}*((r[0]*r[0] + r[1]*r[1]) + (r[2]*r[2] + r[3]*r[3]));
  q[0] = g*r[0];
  q[1] = g*r[1];
  q[2] = g*r[2];
  q[3] = g*r[3];
}

void ${name}_at(const ${name}_orbit *o, ${name}_real t, ${name}_real x[])
{
  const ${name}_values v = ${name}_values_at(o, t);

  ${name}_put(o, &v, ${one}/${sqrt}(${name}_square(&v)), x + ${upper}_QW, x + ${upper}_WX);
}

void ${name}_at_rates(const ${name}_orbit *o, ${name}_real t, ${name}_real w[])
{
  const ${name}_values v = ${name}_values_at(o, t);
  ${name}_real q[4];

  ${name}_put(o, &v, ${one}/${sqrt}(${name}_square(&v)), q, w);
}

void ${name}_at_attitude(const ${name}_orbit *o, ${name}_real t, ${name}_real q[])
{
  const ${name}_values v = ${name}_values_at(o, t);
  ${name}_real w[3];

  ${name}_put(o, &v, ${one}/${sqrt}(${name}_square(&v)), q, w);
}

/* Blocks of one vector of 512 bits: loops of a fixed count over local arrays, without calls or branches, are vectorised;
 * the roots stand alone, as they may set errno. */
enum { ${upper}_BLOCK = ${block} };

${upper}_INLINE void ${name}_some(const ${name}_orbit *o, const ${name}_real t[], size_t n, ${name}_real x[])
{
  ${name}_real v[6][${upper}_BLOCK], state[7][${upper}_BLOCK], root[${upper}_BLOCK];
  size_t i, k;

  for (k = 0; k < ${upper}_BLOCK; k++) {
    const ${name}_values y = ${name}_circular_values(o, ${name}_circular_phases(o, t[k]));

    v[0][k] = y.w;
    v[1][k] = y.x;
    v[2][k] = y.y;
    v[3][k] = y.z;
    v[4][k] = y.f;
    v[5][k] = y.g;
    root[k] = ${name}_square(&y);
  }
  for (k = 0; k < ${upper}_BLOCK; k++) root[k] = ${sqrt}(root[k]);
  for (k = 0; k < ${upper}_BLOCK; k++) {
    const ${name}_values y = {v[0][k], v[1][k], v[2][k], v[3][k], v[4][k], v[5][k]};
    ${name}_real q[4], w[3];

    ${name}_put(o, &y, ${one}/root[k], q, w);
    state[0][k] = q[0];
    state[1][k] = q[1];
    state[2][k] = q[2];
    state[3][k] = q[3];
    state[4][k] = w[0];
    state[5][k] = w[1];
    state[6][k] = w[2];
  }
  for (i = 0; i < 4; i++) {
    for (k = 0; k < ${upper}_BLOCK; k++) x[(${upper}_QW + i)*n + k] = state[i][k];
  }
  for (i = 0; i < 3; i++) {
    for (k = 0; k < ${upper}_BLOCK; k++) x[(${upper}_WX + i)*n + k] = state[4 + i][k];
  }
}

void ${name}_at_many(const ${name}_orbit *o, int n, const ${name}_real t[], ${name}_real x[])
{
  const size_t count = n > 0 ? (size_t)n : 0;
  ${name}_real y[${upper}_NX];
  size_t k = 0, i;

  if (!o->hyperbolic) {
    for (; k + ${upper}_BLOCK <= count; k += ${upper}_BLOCK) ${name}_some(o, t + k, count, x + k);
  }
  for (; k < count; k++) {
    ${name}_at(o, t[k], y);
    for (i = 0; i < ${upper}_NX; i++) x[i*count + k] = y[i];
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
