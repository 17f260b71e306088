%% -- theta_at.c -- the free top's state at a time, from an orbit: part of scene.c.  SPDX-License-Identifier: MIT-0
%% if vectorised then
/* ---- evaluation: no call and no branch on data but for `hyperbolic`, so that loops over times are vectorised ---- */
%% else
/* ---- evaluation ---- */
%% end

/* high + low: the phase of the rates in their periods, less whole ones; the turns about L */
typedef struct ${name}_instant { ${name}_real high, low, turn, turn_low; } ${name}_instant;

/* The pair e^(-i mu t) (a + i b, c + i d) of quaternion components w + i z, x + i y, and cn, sn, dn,
 * but for constant factors and their norms; and the turns that mu t makes. */
typedef struct ${name}_thetas { ${name}_real a, b, c, d, cn, sn, dn, turn; } ${name}_thetas;

%% if single or damped then
/* the sum less whole numbers as the high part, what it has rounded as the low one */
${inline} void ${name}_join(${name}_real *high, ${name}_real *low)
{
  const ${name}_real sum = *high + *low;

  *low -= sum - *high;
  *high = sum - ${name}_nearest(sum);
}

%% end
${inline} ${name}_instant ${name}_reduce(const ${name}_orbit *o, ${name}_real at)
{
  const ${name}_real before = at > o->last ? o->last : at, t = before < -o->last ? -o->last : before; /* no number stays none */
  const ${name}_real c = ${split}*t, head = c - (c - t), tail = t - head;
  const ${name}_pair p = ${name}_passed(o->rate, t, head, tail), turn = ${name}_passed(o->turn, t, head, tail);
  const ${name}_real sum = p.hi + o->start[0], part = sum - p.hi; /* Knuth's two-sum */
  const ${name}_real rest = (p.hi - (sum - part)) + (o->start[0] - part);
%% if not single then
  const ${name}_instant phases = {sum - ${name}_nearest(sum), rest + (p.lo + o->start[1]), turn.hi, turn.lo};
%% else
  ${name}_instant phases = {sum - ${name}_nearest(sum), rest + (p.lo + o->start[1]), turn.hi, turn.lo};

  phases.low -= ${name}_nearest(phases.low); /* from 2^22 on: low may have whole periods, and the nearest was an even one */
  phases.turn_low -= ${name}_nearest(phases.turn_low);
  phases.turn -= ${name}_nearest(phases.turn);
  ${name}_join(&phases.high, &phases.low);
  ${name}_join(&phases.turn, &phases.turn_low);
%% end
  return phases;
}

/* 2^x and 2^-x, |x| <= ${binary_limit}: the even and the odd part of 2^f, f = x less the nearest integer n,
 * which the sum with a large number leaves in the last bits (IEEE 754), next to the exponent's */
${inline} void ${name}_exponentials(${name}_real x, ${name}_real *up, ${name}_real *down)
{
  union { ${name}_real number; ${bits_type} bits; } a, b;
%% if single then
  const ${name}_real n = ${name}_nearest(x), f = x - n, u = f*f, u2 = u*u;
%% else
  const ${name}_real n = ${name}_nearest(x), f = x - n, u = f*f, u2 = u*u, u4 = u2*u2;
%% end
%% for _, line in ipairs(even_lines) do
  ${line}
%% end
%% for _, line in ipairs(odd_lines) do
  ${line}
%% end
  const ${name}_real odd = f*o;
  a.number = ${binary_one} + n; b.number = ${binary_one} - n;
  a.bits <<= ${binary_shift}; b.bits <<= ${binary_shift};
  *up = a.number*(e + odd); *down = b.number*(e - odd);
}

/* away from the separatrix: the series as polynomials in X = cos 2z */
${inline} ${name}_thetas ${name}_circular_terms(const ${name}_orbit *o, ${name}_instant p)
{
  ${name}_real s, c;
  ${name}_circle(p.high + p.low, &s, &c);
  const ${name}_real X = (c - s)*(c + s), X2 = X*X;
  const ${name}_real even = o->f[0] + X2*(o->f[2] + X2*o->f[4]), odd = X*(o->f[1] + X2*o->f[3]);
  ${name}_thetas y;
  y.a = (o->a[0] + X*o->a[1]) + X2*(o->a[2] + X*o->a[3]);
  y.b = (s*c)*((o->b[0] + X*o->b[1]) + X2*o->b[2]);
  y.c = s*((o->c[0] + X*o->c[1]) + X2*(o->c[2] + X*o->c[3]));
  y.d = c*((o->d[0] + X*o->d[1]) + X2*(o->d[2] + X*o->d[3]));
  y.cn = c*(even + odd); y.sn = s*(even - odd); /* theta2(z) = theta1(z + pi/2) */
  y.dn = (o->f[5] + X2*(o->f[7] + X2*o->f[9])) + X*(o->f[6] + X2*o->f[8]);
  y.turn = (p.turn - ${name}_nearest(p.turn)) + p.turn_low;
  return y;
}

/* near it: in U = p' X, X = cosh 2V, which stays below 1; where 2^|x| would exceed the range all but
 * 1/cosh is 1, and x is cut if it can come there */
${inline} ${name}_thetas ${name}_hyperbolic_terms(const ${name}_orbit *o, ${name}_instant p, int cut)
{
  const ${name}_real n = ${name}_nearest(${two}*p.high); /* -1, 0, 1: V has two periods in one of the rates */
  const ${name}_real flip = ${one} - ${two}*${fabs}(n), r = (${two}*p.high - n) + ${two}*p.low, ahead = o->jump*r;
  ${name}_real x = r*o->half, up, down;
  if (cut) {
    x = x < ${binary_limit} ? x : ${binary_limit};
    x = x > -${binary_limit} ? x : -${binary_limit};
  }
  ${name}_exponentials(x, &up, &down);
  const ${name}_real c = up + down, s = up - down; /* 2 cosh V, 2 sinh V */
  const ${name}_real U = o->nome*(c*c) - ${two}*o->nome, U2 = U*U;
  ${name}_real even = o->a[0] + U2*o->a[2], odd = U*(o->a[1] + U2*o->a[3]);
  ${name}_thetas y;
  y.a = c*(even + odd); y.c = flip*s*(even - odd);
  even = o->b[0] + U2*o->b[2]; odd = U*(o->b[1] + U2*o->b[3]);
  y.b = s*(even - odd); y.d = flip*c*(even + odd);
  even = o->f[0] + U2*(o->f[1] + U2*o->f[2]);
  odd = o->f[3] + U2*o->f[4];
  y.cn = flip*(even - odd); y.dn = even + odd;
  y.sn = c*(flip*s)*(o->f[5] + U2*(o->f[6] + U2*o->f[7]));
  y.turn = (p.turn - ${name}_nearest(p.turn + ahead)) + (ahead + p.turn_low);
  return y;
}

/* the attitude q[4] times a length, whose square is ${name}_length2 */
${inline} void ${name}_attitude_of(const ${name}_orbit *o, const ${name}_thetas *y, ${name}_real q[])
{
  ${name}_real s, c;
  ${name}_circle(y->turn, &s, &c);
  const ${name}_real qw = c*y->a - s*y->b, qx = c*y->c - s*y->d, qy = s*y->c + c*y->d, qz = s*y->a + c*y->b;
  q[0] = (qw*o->q[0][0] + qx*o->q[1][0]) + (qy*o->q[2][0] + qz*o->q[3][0]);
  q[1] = (qw*o->q[0][1] + qx*o->q[1][1]) + (qy*o->q[2][1] + qz*o->q[3][1]);
  q[2] = (qw*o->q[0][2] + qx*o->q[1][2]) + (qy*o->q[2][2] + qz*o->q[3][2]);
  q[3] = (qw*o->q[0][3] + qx*o->q[1][3]) + (qy*o->q[2][3] + qz*o->q[3][3]);
}

${inline} ${name}_real ${name}_length2(const ${name}_thetas *y)
{
  return (y->a*y->a + y->b*y->b) + (y->c*y->c + y->d*y->d);
}

/* the rates; n is one over that square */
${inline} void ${name}_rates_of(const ${name}_orbit *o, const ${name}_thetas *y, ${name}_real n, ${name}_real w[])
{
  w[0] = n*(y->cn*o->w[0][0] + y->sn*o->w[1][0] + y->dn*o->w[2][0]);
  w[1] = n*(y->cn*o->w[0][1] + y->sn*o->w[1][1] + y->dn*o->w[2][1]);
  w[2] = n*(y->cn*o->w[0][2] + y->sn*o->w[1][2] + y->dn*o->w[2][2]);
}

${inline} ${name}_thetas ${name}_terms_of(const ${name}_orbit *o, ${name}_instant p, int hyperbolic)
{
  return hyperbolic > 0 ? ${name}_hyperbolic_terms(o, p, hyperbolic > 1) : ${name}_circular_terms(o, p);
}

/* 1/|q| from n, which is 1/${name}_length2 and 1/|q|^2 but for rounding, and its root: a Newton step, added so
 * that the difference from a half is exact and only the sum is rounded */
${inline} ${name}_real ${name}_inverse_length(const ${name}_real q[4], ${name}_real n, ${name}_real root)
{
  return root + root*(${half} - (${half}*n)*((q[0]*q[0] + q[1]*q[1]) + (q[2]*q[2] + q[3]*q[3])));
}

%% if has_tick_fields or damped then
/* attitude and rates */
${inline} void ${name}_state(const ${name}_orbit *o, ${name}_instant p, ${name}_real x[])
{
  const ${name}_thetas y = ${name}_terms_of(o, p, o->hyperbolic);
%% else
void ${name}_at(const ${name}_orbit *o, ${name}_real t, ${name}_real x[])
{
  const ${name}_thetas y = ${name}_terms_of(o, ${name}_reduce(o, t), o->hyperbolic);
%% end
  const ${name}_real n = ${one}/${name}_length2(&y);
  ${name}_real q[4];
  ${name}_attitude_of(o, &y, q);
  const ${name}_real root = ${name}_inverse_length(q, n, ${sqrt}(n));
  for (int i = 0; i < 4; i++) x[${upper}_QW + i] = root*q[i];
  ${name}_rates_of(o, &y, n, x + ${upper}_WX);
%% if flies then
  ${name}_carried(o, t, x);
%% end
}

%% if damped then
/* in a time of twice the working precision, and slower */
void ${name}_at(const ${name}_orbit *o, ${name}_real t, ${name}_real x[])
{
  const ${name}_pair y = ${name}_passed_decays(o->decay, t), time = ${name}_free_time(o, t, y);
  ${name}_instant p = ${name}_reduce(o, time.hi);

  p.low += ${name}_turns_of(o->rate[0], time.lo);
  p.turn_low += ${name}_turns_of(o->turn[0], time.lo);
  ${name}_join(&p.high, &p.low);
  ${name}_join(&p.turn, &p.turn_low);
  ${name}_state(o, p, x);
  ${name}_fade(y, x + ${upper}_WX);
}
%% else
%% if has_tick_fields then
void ${name}_at(const ${name}_orbit *o, ${name}_real t, ${name}_real x[])
{
  ${name}_state(o, ${name}_reduce(o, t), x);
}

%% end
void ${name}_at_rates(const ${name}_orbit *o, ${name}_real t, ${name}_real w[])
{
  const ${name}_thetas y = ${name}_terms_of(o, ${name}_reduce(o, t), o->hyperbolic);

  ${name}_rates_of(o, &y, ${one}/${name}_length2(&y), w);
}

void ${name}_at_attitude(const ${name}_orbit *o, ${name}_real t, ${name}_real q[])
{
  const ${name}_thetas y = ${name}_terms_of(o, ${name}_reduce(o, t), o->hyperbolic);
  const ${name}_real n = ${one}/${name}_length2(&y);
  ${name}_real v[4];
  ${name}_attitude_of(o, &y, v);
  const ${name}_real root = ${name}_inverse_length(v, n, ${sqrt}(n));
  for (int i = 0; i < 4; i++) q[i] = root*v[i];
}
%% end
