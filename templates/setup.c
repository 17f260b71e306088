%% -- setup.c -- the set-up of the free top's closed form: part of scene.c.  SPDX-License-Identifier: MIT-0
static void ${name}_store(${name}_real out[2], ${name}_pair a)
{
  out[0] = a.hi;
  out[1] = a.lo;
}

static void ${name}_quaternion_product(const ${name}_real a[4], const ${name}_real b[4], ${name}_real out[4])
{
  out[0] = a[0]*b[0] - a[1]*b[1] - a[2]*b[2] - a[3]*b[3];
  out[1] = a[0]*b[1] + a[1]*b[0] + a[2]*b[3] - a[3]*b[2];
  out[2] = a[0]*b[2] - a[1]*b[3] + a[2]*b[0] + a[3]*b[1];
  out[3] = a[0]*b[3] + a[1]*b[2] - a[2]*b[1] + a[3]*b[0];
}

/* c[0] + c[1] y[1] + ...: a series in multiple angles, y[n+1] = 2 X y[n] - y[n-1], as a polynomial in X; y[0] = 1 and
 * y[1] = first + slope X */
static void ${name}_polynomial(int n, const ${name}_real c[], ${name}_real first, ${name}_real slope, ${name}_real out[])
{
  ${name}_real before[5] = {${one}, ${zero}, ${zero}, ${zero}, ${zero}};
  ${name}_real now[5] = {first, slope, ${zero}, ${zero}, ${zero}}, next[5];
  int i, k;

  for (k = 0; k < n; k++) out[k] = k == 0 ? c[0] : ${zero};
  for (i = 1; i < n; i++) {
    for (k = 0; k <= i; k++) out[k] += c[i]*now[k];
    for (k = 0; k < 5; k++) next[k] = (k > 0 ? ${two}*now[k - 1] : ${zero}) - before[k];
    for (k = 0; k < 5; k++) {
      before[k] = now[k];
      now[k] = next[k];
    }
  }
}
/* The means a, g of 1 and k' (DLMF 19.8.2), as far as they are needed: after four steps they agree to 2^-35, and what is
 * left is added as a series. */
typedef struct ${name}_means {
  ${name}_pair k, a1, g1, a2, g2, a3, g3; /* k' first */
  ${name}_pair M;                         /* their limit, pi/(2 K) */
  ${name}_pair q;                         /* nome, up12^2 */
} ${name}_means;

/* The nome: q^(2^n) = e + 2 e^5 + 15 e^9 + ... with e = (a_n - g_n)/(8 a_(n+2)) (DLMF 19.5.6 at the n-th modulus).  From
 * n to n + 1 e becomes e^2 a_(n+2)/a_(n+3), which gives q as a product that ends quickly,
 *     q = k^2/(8 a_1 (1 + g_1) sqrt a_3) (a_3/a_4)^(1/4) (a_4/a_5)^(1/8) ... */
static void ${name}_nome(${name}_means *f, const ${name}_top *p)
{
  const ${name}_pair one = ${name}_pair_of(${one});
  ${name}_pair a4, a5, d, rest, u;
  ${name}_real t;

  f->k = ${name}_pair_root(${name}_pair_shift(p->down13, ${name}_pair_shift(p->down13, p->kc2)));
  f->a1 = ${name}_pair_shift(${half}, ${name}_pair_add(one, f->k));
  f->g1 = ${name}_pair_root(f->k);
  f->a2 = ${name}_pair_shift(${half}, ${name}_pair_add(f->a1, f->g1));
  f->g2 = ${name}_pair_root(${name}_pair_multiply(f->a1, f->g1));
  f->a3 = ${name}_pair_shift(${half}, ${name}_pair_add(f->a2, f->g2));
  f->g3 = ${name}_pair_root(${name}_pair_multiply(f->a2, f->g2));
  d = ${name}_pair_subtract(f->a3, f->g3);
  a4 = ${name}_pair_subtract(f->a3, ${name}_pair_shift(${half}, d));
  u = ${name}_pair_multiply(d, d);
  t = u.hi/(${eight}*${two}*a4.hi);
  rest = ${name}_pair_divide(u, ${name}_pair_shift(${eight}*${two}, ${name}_pair_subtract(a4, ${name}_pair_of(t)))); /* a_4 - a_5 = (a_3 - g_3)^2/(16 a_5) */
  a5 = ${name}_pair_subtract(a4, rest);
  f->M = ${name}_pair_subtract(a5, ${name}_pair_of(t*t/(${two}*${two}*a5.hi)));

  u = ${name}_pair_divide(${name}_pair_shift(${half}*${quarter}, d), a4); /* (1 + 4 u)^(1/4) = 1 + u - 3/2 u^2 + 7/2 u^3 - 77/8 u^4 + 231/8 u^5, u < 2^-18 */
  t = u.hi;
  u = ${name}_pair_add(u, ${name}_pair_subtract(${name}_pair_of((t*t*t)*((${name}_real)7/${two} - t*((${name}_real)77/${eight} - t*((${name}_real)231/${eight})))), ${name}_pair_times(${threehalves}, ${name}_pair_multiply(u, u))));
  rest = ${name}_pair_divide(${name}_pair_shift(${half}*${quarter}, rest), a5); /* (1 + 8 r)^(1/8) = 1 + r - 7/2 r^2, and a_5/a_6 = 1 + 16 r^2 */
  t = rest.hi;
  u = ${name}_pair_add(u, ${name}_pair_add(rest, ${name}_pair_of(t*(u.hi - (${two} + ${half})*t*(${one} + u.hi)))));
  f->q = ${name}_pair_divide(p->k2, ${name}_pair_shift(${eight}, ${name}_pair_multiply(f->a1, ${name}_pair_multiply(${name}_pair_add(one, f->g1), ${name}_pair_root(f->a3)))));
  f->q = ${name}_pair_add(f->q, ${name}_pair_multiply(f->q, u));
}

/* z at t = 0, in units of pi.  Two of Gauss's transformations, in which z is doubled (DLMF 22.7.2 and its companions), lead
 * to functions of nome q^4, where sc = tan up to q^8 (DLMF 20.2.1-2, 22.2). */
static ${name}_pair ${name}_start(const ${name}_top *p, const ${name}_means *f, ${name}_real q8)
{
  const ${name}_real size = ${ldexp}(${one}, -${name}_exponent(p->Delta3.hi, ${zero})), q24 = q8*q8*q8;
  const ${name}_pair w12 = ${name}_pair_multiply(${name}_pair_shift(p->up12, p->w[0]), ${name}_pair_shift(p->up12, p->w[1]));
  const ${name}_pair c = ${name}_pair_shift(size, ${name}_pair_subtract(p->part1, ${name}_pair_multiply(f->k, p->part2)));
  const ${name}_pair s = ${name}_pair_shift(p->s*size*${two}, ${name}_pair_multiply(f->a1, ${name}_pair_multiply(w12, p->cross)));
  ${name}_pair x = ${name}_pair_multiply(f->a2, ${name}_pair_subtract(${name}_pair_multiply(f->a1, ${name}_pair_multiply(c, c)), ${name}_pair_multiply(f->g1, ${name}_pair_multiply(s, s))));
  ${name}_pair y = ${name}_pair_multiply(f->g3, ${name}_pair_shift(${two}, ${name}_pair_multiply(f->a2, ${name}_pair_multiply(c, s))));
  ${name}_real more_x = ${zero}, more_y = ${zero}, cosine, X, Y;
  int i;

  for (i = 0; i < 3; i++) { /* the series know cos 8 z to 2^-15, 2^-30, 2^-45 */
    X = x.hi + more_x;
    Y = y.hi + more_y;
    cosine = (X - Y)*(X + Y)/(X*X + Y*Y);
    X = ${two}*cosine;
    more_x = x.hi*(q24*(X*X + X - ${one}) - q8*(${one} + X));
    more_y = y.hi*(q24*(X*X - X - ${one}) - q8*(${one} - X));
  }
  x = ${name}_pair_angle(${name}_pair_add(x, ${name}_pair_of(more_x)), ${name}_pair_add(y, ${name}_pair_of(more_y))); /* 4 z, or less by a turn if |2 z| > pi/2 */
  if (c.hi < ${zero}) x = ${name}_pair_add(x, ${name}_pair_shift(p->s*p->w[1].hi < ${zero} ? -${two} : ${two}, ${name}_pi()));
  return ${name}_pair_shift(${quarter}, ${name}_pair_multiply(x, ${name}_inverse_pi()));
}

/* The coefficients of away from the separatrix: E = q^(1/2) e^eta, r = e^(-2 eta) */
static void ${name}_circular_series(${name}_orbit *o, ${name}_real s, ${name}_real q, ${name}_real E, ${name}_real r)
{
  ${name}_real e[8], g[8], c[5], Q[26], sign;
  int n;

  /* theta4: 1 - q (E^2 + g^2) cos 2z + q^6 (E^4 + g^4) cos 4z - ..., g = q/E; theta1: (E + g) sin z - ... */
  e[0] = g[0] = ${one};
  for (n = 1; n < 8; n++) {
    e[n] = e[n - 1]*E;
    g[n] = g[n - 1]*(E*r);
  }
  Q[0] = ${one}; /* powers of q */
  for (n = 1; n < 26; n++) Q[n] = Q[n - 1]*q;
  /* what q <= exp(-pi/2) leaves above 2^-54 */
  for (n = 0, sign = ${one}; n < 4; n++, sign = -sign) c[n] = n == 0 ? ${one} : sign*Q[n*(2*n - 1)]*(e[2*n] + g[2*n]);
  ${name}_polynomial(4, c, ${zero}, ${one}, o->a);
  for (n = 1, sign = -${two}; n < 4; n++, sign = -sign) c[n - 1] = s*sign*Q[n*(2*n - 1)]*(e[2*n] - g[2*n]);
  ${name}_polynomial(3, c, ${zero}, ${two}, o->b);
  for (n = 0, sign = ${one}; n < 4; n++, sign = -sign) c[n] = s*sign*Q[n*(2*n + 1)]*(e[2*n + 1] + g[2*n + 1]);
  ${name}_polynomial(4, c, ${one}, ${two}, o->c);
  for (n = 0, sign = -${one}; n < 4; n++, sign = -sign) c[n] = sign*Q[n*(2*n + 1)]*(e[2*n + 1] - g[2*n + 1]);
  ${name}_polynomial(4, c, -${one}, ${two}, o->d);

  /* theta2(z; q), theta1(z; q) without 2 q^(1/4), theta3(z; q), each over what makes it cn, sn, dn times theta4/theta4(0) */
  {
    ${name}_real two_ = ${zero}, three_ = ${one}, four_ = ${one};

    for (n = 0; n < 5; n++) two_ += Q[n*(n + 1)];
    for (n = 1; n < 6; n++) {
      three_ += ${two}*Q[n*n];
      four_ += (n % 2 ? -${two} : ${two})*Q[n*n];
    }
    for (n = 0; n < 5; n++) c[n] = Q[n*(n + 1)];
    ${name}_polynomial(5, c, -${one}, ${two}, o->f);
    for (n = 0; n < 5; n++) c[n] = (n ? ${two} : ${one})*Q[n*n];
    ${name}_polynomial(5, c, ${zero}, ${one}, o->f + 5);
    o->scale[0] = ${one}/two_;
    o->scale[1] = s*three_/(two_*four_);
    o->scale[2] = ${one}/three_;
  }
}

/* At u = 0 b/a = T.  With v = E - q/E, S = q (E^2 + (q/E)^2) = q (v^2 + 2 q) the two series are
 *     b = v (1 - q^2 (S + q^2) + q^8 (S^2 + q^2 S - q^4) - ...),
 *     a = 1 - S + q^4 (S^2 - 2 q^4) - q^12 (S^3 - 3 q^4 S) + ...:
 * one equation for v, solved by Newton's method, the last step in pairs.  There the phase of a turns at half of `climb`,
 * of which s z' 2 d log a/d(2 eta), with d = q (E^2 - (q/E)^2), is due to theta4: the rest is mu.  All terms are of the
 * size of the rates. */
static void ${name}_circular(${name}_orbit *o, const ${name}_top *p)
{
  const ${name}_pair one = ${name}_pair_of(${one});
  ${name}_pair q, q2, q4, q8, S, S2, a, b, v, d, rate, start, turn;
  ${name}_means f;
  ${name}_real q24, T = p->T.hi, square = p->down12*p->down12, x, da, db, dS, E, r;
  int i;

  ${name}_nome(&f, p);
  q = ${name}_pair_shift(square, f.q);
  q2 = ${name}_pair_multiply(q, q);
  q4 = ${name}_pair_multiply(q2, q2);
  q8 = ${name}_pair_multiply(q4, q4);
  q24 = q8.hi*q8.hi*q8.hi;
  start = ${name}_start(p, &f, q8.hi);
  rate = ${name}_pair_multiply(${name}_pair_multiply(p->lambda, f.M), ${name}_inverse_pi());

  x = T/(${one} + q.hi*(T*T*square));
  dS = S.hi = da = db = ${zero};
  for (i = 0; i < 4; i++) { /* errors 2^-4, 2^-11, 2^-24, 2^-49, rounding; v, T and E are all up12 */
    const ${name}_real s = q.hi*(square*(x*x + ${two}*f.q.hi)), Q = q4.hi, Q2 = q2.hi, Q8 = q8.hi;
    const ${name}_real up = ${one} - s + Q*(s*s - ${two}*Q - Q8*s*(s*s - (${two} + ${one})*Q));
    const ${name}_real down = ${one} - Q2*(s + Q2) + Q8*((s*s + Q2*s - Q) - Q8*Q2*(s*(s*(s + Q2) - ${two}*Q) - Q*Q2));

    da = Q*(${two}*s - (${two} + ${one})*Q8*(s*s - Q)) - ${one};
    db = Q8*(${two}*s + Q2) - Q2;
    dS = ${two}*q.hi*(square*x);
    x += (T*up - x*down)/(down - (T*da - x*db)*dS);
  }
  S = ${name}_pair_multiply(${name}_pair_shift(square, q), ${name}_pair_add(${name}_pair_product(x, x), ${name}_pair_shift(${two}, f.q)));
  S2 = ${name}_pair_multiply(S, S);
  a = ${name}_pair_subtract(${name}_pair_subtract(S2, ${name}_pair_shift(${two}, q4)), ${name}_pair_multiply(${name}_pair_multiply(q8, S), ${name}_pair_subtract(S2, ${name}_pair_times(${three}, q4))));
  a = ${name}_pair_add(${name}_pair_subtract(one, S), ${name}_pair_multiply(q4, a));
  a = ${name}_pair_add(a, ${name}_pair_of(q24*(S2.hi*(S2.hi - ${four}*q4.hi) + ${two}*q8.hi)));
  b = ${name}_pair_multiply(q2, ${name}_pair_add(S, q2));
  d = ${name}_pair_multiply(q8, ${name}_pair_subtract(${name}_pair_add(S2, b), ${name}_pair_shift(${two}, q4)));
  r = q2.hi*(S.hi*(S2.hi + q2.hi*S.hi - ${two}*q4.hi) - q2.hi*q4.hi);
  r = q8.hi*q8.hi*(r - q8.hi*q8.hi*(S.hi*(S.hi*(S.hi*(S.hi + q2.hi) - ${three}*q4.hi) - ${two}*q2.hi*q4.hi) + q8.hi));
  b = ${name}_pair_add(${name}_pair_subtract(one, b), ${name}_pair_subtract(d, ${name}_pair_of(r)));
  r = ${name}_pair_subtract(${name}_pair_multiply(p->T, a), ${name}_pair_times(x, b)).hi/(b.hi - (T*da - x*db)*dS);
  v = ${name}_pair_sum(x, r);
  S.lo += dS*r;
  S2.lo += ${two}*S.hi*(dS*r);
  a.lo += da*dS*r;

  d = ${name}_pair_root(${name}_pair_add(${name}_pair_multiply(v, v), ${name}_pair_shift(${four}, f.q)));
  E = ${half}*(v.hi + d.hi);
  r = f.q.hi/(E*E);
  E *= p->down12;
  d = ${name}_pair_multiply(${name}_pair_multiply(${name}_pair_shift(square, q), v), d);
  turn = ${name}_pair_subtract(${name}_pair_shift(${two}, S), ${name}_pair_multiply(${name}_pair_times(${three}, q8), ${name}_pair_subtract(S2, q4)));
  turn = ${name}_pair_add(${name}_pair_subtract(one, ${name}_pair_multiply(q4, turn)), ${name}_pair_of(-${four}*q24*(S.hi*(S2.hi - ${two}*q4.hi) - (${four} + ${one})/${four}*(q8.hi*q8.hi)*(S2.hi*S2.hi))));
  turn = ${name}_pair_multiply(${name}_pair_multiply(rate, ${name}_pair_divide(d, a)), turn);
  turn = ${name}_pair_add(${name}_pair_shift(${quarter}, ${name}_pair_multiply(p->climb, ${name}_inverse_pi())), ${name}_pair_shift(p->s, turn));
  o->hyperbolic = 0;
  ${name}_store(o->start, ${name}_pair_shift(${half}, start)); /* the rates have two periods of theta functions */
  ${name}_store(o->rate, ${name}_pair_shift(${half}, rate));
  ${name}_store(o->turn, turn);
  ${name}_circular_series(o, p->s, q.hi, E, r);
}

/* c[n] p^(n(n + 1)) cosh((2n + 1)V)/cosh V, n < 4, summed, as a polynomial in U = p cosh 2V */
static void ${name}_multiples(const ${name}_real c[4], ${name}_real p, ${name}_real out[4])
{
  const ${name}_real p2 = p*p, p4 = p2*p2, p8 = p4*p4;

  out[0] = c[0] - p2*(c[1] + p4*(c[2] - p4*p2*c[3]));
  out[1] = ${two}*p*(c[1] - p4*(c[2] + ${two}*p4*p2*c[3]));
  out[2] = ${two}*${two}*p4*(c[2] - p4*p2*c[3]);
  out[3] = ${eight}*p8*p*c[3];
}

/* The coefficients near the separatrix, Q the nome of k': cosine[n] = cos((2n + 1)h), sine[n] = -+s sin((2n + 1)h), or a
 * multiple of both */
static void ${name}_hyperbolic_series(${name}_orbit *o, ${name}_real s, ${name}_real Q, const ${name}_real cosine[4], const ${name}_real sine[4])
{
  const ${name}_real P = ${sqrt}(Q), Q2 = Q*Q;
  ${name}_real two_, three_, four_;

  o->nome = ${half}*P;
  ${name}_multiples(cosine, P, o->a);
  ${name}_multiples(sine, P, o->b);
  o->f[0] = ${one} + ${two}*Q2*Q2; /* with (n + 1/2)^2 = 2 (n(n + 1)/2) + 1/4 ... */
  o->f[1] = -${eight}*${two}*Q2*Q;
  o->f[2] = ${eight}*${two}*Q2;
  o->f[3] = -${two}*Q;
  o->f[4] = ${two}*${two};
  o->f[5] = ${one} + Q2;
  o->f[6] = -${two}*${two}*(Q + ${threehalves}*${two}*Q2*Q2*Q);
  o->f[7] = ${eight}*${two}*Q2*Q2;
  /* cn, sn, dn times theta2/theta2(0), nome q', scaled */
  two_ = ${one} + Q*Q + Q*Q*Q*Q*Q*Q;
  three_ = ${one} + ${two}*(Q + Q*Q*Q*Q);
  four_ = ${one} - ${two}*(Q - Q*Q*Q*Q);
  o->scale[0] = ${one}/four_;
  o->scale[1] = s*three_/(${two}*two_*four_);
  o->scale[2] = ${one}/three_;
}

/* V at t = 0 for k' <= 0.172, by the imaginary transformation: functions of 2 i V of nome Q (DLMF 22.6.ix, 22.2), from
 * cd = dn of that, which is 1 - w + ... over 1 + w + ..., w = 2 Q cosh 4V, and sc = tanh of it, which gives sinh 2V.
 * Where dn u < sqrt k' the same for K - u, half a period less V: so w <= sqrt Q. */
static ${name}_pair ${name}_hyperbolic_start(const ${name}_top *p, ${name}_pair k, ${name}_pair Q, ${name}_pair period)
{
  const ${name}_pair one = ${name}_pair_of(${one}), w1 = ${name}_pair_shift(p->up13, p->w[0]), w3 = ${name}_pair_shift(p->up13, p->w[2]);
  const ${name}_pair kc = ${name}_pair_root(p->kc2), Q2 = ${name}_pair_multiply(Q, Q);
  const ${name}_pair two_ = ${name}_pair_add(one, ${name}_pair_add(Q2, ${name}_pair_of(Q2.hi*Q2.hi*Q2.hi))), three_ = ${name}_pair_add(one, ${name}_pair_shift(${two}, ${name}_pair_add(Q, ${name}_pair_multiply(Q2, Q2))));
  const ${name}_real q = Q.hi, sign = (p->w[1].hi < ${zero}) == (p->s < ${zero}) ? ${one} : -${one};
  ${name}_real dn = w3.hi/p->b3.hi, more;
  const int far = dn*dn*p->down13 < kc.hi;
  int e = p->small12 - p->small13;
  ${name}_pair up, down, y, w, V;

  up = ${name}_pair_multiply(${name}_pair_shift(p->w[1].hi < ${zero} ? -p->up12 : p->up12, p->w[1]), p->cross);
  down = ${name}_pair_multiply(w1, ${name}_pair_multiply(p->J[0], p->d31)); /* sc = up/down 2^e */
  if (far) {
    y = ${name}_pair_root(${name}_pair_divide(${name}_pair_multiply(k, p->part2), p->Delta3));
    w = ${name}_pair_multiply(up, kc);
    up = down;
    down = w;
    e = -p->small12;
  } else {
    y = ${name}_pair_divide(${name}_pair_multiply(p->J[0], ${name}_pair_multiply(p->Lambda1, k)), ${name}_pair_multiply(p->J[2], p->Delta3));
    y = ${name}_pair_divide(${name}_pair_shift(p->up12, ${name}_pair_multiply(w1, ${name}_pair_root(y))), w3);
  }
  w = ${name}_pair_divide(${name}_pair_subtract(one, y), ${name}_pair_add(one, y));
  more = Q2.hi*(w.hi*w.hi - ${two}*Q2.hi); /* 2 Q^4 cosh 8V = Q^2 (w^2 - 2 Q^2) */
  dn = w.hi*(${one} + more);
  more = Q2.hi*(dn*dn - ${two}*Q2.hi);
  w = ${name}_pair_add(w, ${name}_pair_of(w.hi*more));
  up = ${name}_pair_multiply(${name}_pair_multiply(up, two_), ${name}_pair_add(${name}_pair_subtract(one, w), ${name}_pair_of(more)));
  V = ${name}_pair_subtract(one, ${name}_pair_multiply(Q, ${name}_pair_add(w, Q)));
  V = ${name}_pair_add(V, ${name}_pair_of(Q2.hi*Q2.hi*(w.hi*w.hi + q*w.hi - Q2.hi)));
  V = ${name}_pair_divide(up, ${name}_pair_multiply(${name}_pair_multiply(down, three_), V)); /* sinh 2V 2^-e */
  if (${ldexp}(V.hi, e) > ${one}) {
    y = ${name}_pair_scale(${name}_pair_divide(one, V), -e);
    V = ${name}_pair_log(${name}_pair_multiply(V, ${name}_pair_add(one, ${name}_pair_root(${name}_pair_add(one, ${name}_pair_multiply(y, y))))), e);
  } else {
    V = ${name}_pair_scale(V, e);
    V = ${name}_pair_log(${name}_pair_add(V, ${name}_pair_root(${name}_pair_add(one, ${name}_pair_multiply(V, V)))), 0);
  }
  V = ${name}_pair_shift(${half}, V);
  if (far) V = ${name}_pair_subtract(${name}_pair_shift(${half}, period), V);
  return ${name}_pair_shift(sign, V);
}

/* Near the separatrix, Q the nome of k'.  Its period is pi kappa = -log(Q)/2 (none on the separatrix), at which the phase
 * about L jumps by -2 s h, h = kappa eta.  At u = 0 b/a = T is
 *     (sin h - Q sin 3h + Q^3 sin 5h - ...)/(cos h + Q cos 3h + Q^3 cos 5h + ...),
 * an equation for x = tan h; c = cos 2h.  Half of `climb` there is mu - s V' d log theta2/dh. */
static void ${name}_hyperbolic(${name}_orbit *o, const ${name}_top *p)
{
  const ${name}_pair one = ${name}_pair_of(${one});
  const ${name}_pair k = ${name}_pair_root(${name}_pair_shift(p->down12, ${name}_pair_shift(p->down12, p->k2))), more = ${name}_pair_add(one, ${name}_pair_root(k));
  const ${name}_real T = ${name}_pair_shift(p->down12, p->T).hi, square = p->down13*p->down13;
  ${name}_pair Q, Q2, Q3, c, first, second, up, down, rise, rate, start, turn, period, tangent;
  ${name}_real sine[5], cosine[5], q, q3, q6, x, C, dc, slope, r;
  int i;

  /* nome (DLMF 19.5.6) up13^2; theta3(0; Q)^2 = 2 K'/pi */
  Q = ${name}_pair_divide(${name}_pair_shift(${half}, p->kc2), ${name}_pair_multiply(${name}_pair_add(one, k), ${name}_pair_multiply(more, more)));
  Q2 = ${name}_pair_shift(square, ${name}_pair_shift(square, ${name}_pair_multiply(Q, Q)));
  Q2 = ${name}_pair_multiply(Q2, Q2);
  Q = ${name}_pair_add(Q, ${name}_pair_multiply(Q, ${name}_pair_add(${name}_pair_shift(${two}, Q2), ${name}_pair_of((${two}*${eight} - ${one})*(Q2.hi*Q2.hi)))));
  period = ${name}_pair_of(${zero});
  if (Q.hi > ${zero}) period = ${name}_pair_shift(-${half}, ${name}_pair_log(Q, 2*p->small13)); /* else on the separatrix, to the last bit */
  Q = ${name}_pair_shift(square, Q);
  Q2 = ${name}_pair_multiply(Q, Q);
  Q3 = ${name}_pair_multiply(Q2, Q);
  q = Q.hi;
  q3 = Q3.hi;
  q6 = q3*q3;
  c = ${name}_pair_add(Q, ${name}_pair_add(${name}_pair_multiply(Q2, Q2), ${name}_pair_of(q6*q3)));
  c = ${name}_pair_add(one, ${name}_pair_shift(${two}, c));
  rate = ${name}_pair_divide(${name}_pair_shift(${half}, p->lambda), ${name}_pair_multiply(c, c));

  x = T;
  slope = C = dc = ${zero};
  for (i = 0; i < 3; i++) { /* errors 2^-8, 2^-25, 2^-59 */
    const ${name}_real u = ${one}/(${one} + x*x);

    C = (${one} - x*x)*u;
    dc = -${four}*x*(u*u);
    slope = ${one} - q*(${one} + ${two}*C) + q3*(${four}*C*C + ${two}*C - ${one});
    r = T*(${one} + q*(${two}*C - ${one}) + q3*(${four}*C*C - ${two}*C - ${one})) - x*slope;
    slope += dc*(x*(q3*(${eight}*C + ${two}) - ${two}*q) - T*(${two}*q + q3*(${eight}*C - ${two})));
    x += r/slope;
  }
  sine[0] = cosine[0] = ${one}; /* over sin h, cos h: of h, 3 h, ... 9 h */
  sine[1] = ${two}*C + ${one};
  cosine[1] = ${two}*C - ${one};
  for (i = 2; i < 5; i++) {
    sine[i] = ${two}*C*sine[i - 1] - sine[i - 2];
    cosine[i] = ${two}*C*cosine[i - 1] - cosine[i - 2];
  }

  c = ${name}_pair_product(x, x);
  c = ${name}_pair_divide(${name}_pair_subtract(one, c), ${name}_pair_add(one, c));
  first = ${name}_pair_multiply(Q, ${name}_pair_add(one, ${name}_pair_shift(${two}, c)));
  second = ${name}_pair_multiply(Q3, ${name}_pair_subtract(${name}_pair_shift(${two}, ${name}_pair_add(c, ${name}_pair_shift(${two}, ${name}_pair_multiply(c, c)))), one));
  up = ${name}_pair_add(${name}_pair_subtract(one, first), ${name}_pair_subtract(second, ${name}_pair_of(q6*(sine[3] - q3*q*sine[4]))));
  down = ${name}_pair_subtract(${name}_pair_add(first, second), ${name}_pair_shift(${two}, ${name}_pair_add(Q, ${name}_pair_shift(${two}, ${name}_pair_multiply(Q3, c)))));
  down = ${name}_pair_add(${name}_pair_add(one, down), ${name}_pair_of(q6*(cosine[3] + q3*q*cosine[4])));
  rise = ${name}_pair_add(${name}_pair_add(one, ${name}_pair_times(${three}, first)), ${name}_pair_add(${name}_pair_times(${four} + ${one}, second), ${name}_pair_of(q6*((${eight} - ${one})*sine[3] + (${eight} + ${one})*q3*q*sine[4]))));
  r = ${name}_pair_subtract(${name}_pair_multiply(${name}_pair_shift(p->down12, p->T), down), ${name}_pair_times(x, up)).hi/slope;
  tangent = ${name}_pair_sum(x, r);
  rise.lo += dc*r*((${two}*${three})*q + (${four} + ${one})*q3*(${eight}*C + ${two}));
  down.lo += dc*r*(${two}*q + q3*(${eight}*C - ${two}));
  rise = ${name}_pair_multiply(rate, ${name}_pair_divide(${name}_pair_multiply(tangent, rise), down));
  turn = ${name}_pair_add(${name}_pair_shift(${half}, p->climb), ${name}_pair_shift(p->s, rise));

  start = ${name}_hyperbolic_start(p, k, Q, period);
  turn = ${name}_pair_shift(${half}, ${name}_pair_multiply(turn, ${name}_inverse_pi()));
  if (period.hi > ${zero}) {
    const ${name}_pair twice = ${name}_pair_shift(${two}, period), jump = ${name}_pair_shift(p->s, ${name}_pair_multiply(${name}_pair_angle(one, tangent), ${name}_inverse_pi()));

    rate = ${name}_pair_divide(rate, twice);
    ${name}_store(o->rate, rate);
    ${name}_store(o->start, ${name}_pair_divide(start, twice));
    ${name}_store(o->turn, ${name}_pair_subtract(turn, ${name}_pair_shift(${two}, ${name}_pair_multiply(jump, rate))));
    o->jump = jump.hi;
    o->half = ${name}_pair_divide(period, ${name}_log2()).hi;
  } else { /* none: that of ${no_period}, beyond which V never comes */
    const ${name}_pair twice = ${name}_pair_shift(${two}, ${name}_pair_times(${no_period}, ${name}_log2()));

    ${name}_store(o->rate, ${name}_pair_divide(rate, twice));
    ${name}_store(o->start, ${name}_pair_divide(start, twice));
    ${name}_store(o->turn, turn);
    o->half = ${no_period};
  }
  o->hyperbolic = o->half < ${two}*${binary_limit} ? 1 : 2;
  for (i = 0; i < 4; i++) sine[i] *= (i % 2 ? p->s : -p->s)*tangent.hi; /* all over cos h */
  ${name}_hyperbolic_series(o, p->s, q, cosine, sine);
}

static ${name}_pair ${name}_unit_quaternion(const ${name}_real q[4], ${name}_real out[4])
{
  ${name}_pair sum = ${name}_pair_of(${zero}), length;
  ${name}_real big = ${zero};
  int i, e;

  for (i = 0; i < 4; i++) big = ${fabs}(q[i]) > big ? ${fabs}(q[i]) : big;
  (void)${frexp}(big, &e);
  for (i = 0; i < 4; i++) {
    out[i] = ${ldexp}(q[i], -e);
    sum = ${name}_pair_add(sum, ${name}_pair_product(out[i], out[i]));
  }
  length = ${name}_pair_root(sum);
  for (i = 0; i < 4 && big > ${zero}; i++) out[i] = ${name}_pair_divide(${name}_pair_of(out[i]), length).hi;
  return length;
}

/* all numbers 0 */
static void ${name}_clear(${name}_orbit *o)
{
  int i;

  for (i = 0; i < 4; i++) o->rate[i] = o->turn[i] = o->a[i] = o->b[i] = o->c[i] = o->d[i] = ${zero};
  for (i = 0; i < 2; i++) o->rate_tick[i] = o->rate_start[i] = o->turn_tick[i] = o->turn_start[i] = 0;
  for (i = 0; i < 10; i++) o->f[i] = ${zero};
  for (i = 0; i < 3; i++) o->scale[i] = ${zero};
  o->start[0] = o->start[1] = o->jump = o->half = o->nome = o->tick = ${zero};
  o->s = ${one};
  o->hyperbolic = 0;
}

/* Constant rotation: w and L are parallel; axis 3 is theirs, and p = 0, E = 0. */
static void ${name}_constant(${name}_orbit *o, ${name}_top *p, const ${name}_real w[3])
{
  ${name}_pair length = ${name}_pair_of(${zero});
  int i, j;

  for (i = 0; i < 3; i++) length = ${name}_pair_add(length, ${name}_pair_product(w[i], w[i]));
  length = ${name}_pair_root(length);
  for (i = 0; i < 3; i++) {
    for (j = 0; j < 2; j++) p->axis[j][i] = ${zero};
    p->axis[2][i] = length.hi > ${zero} ? ${name}_pair_divide(${name}_pair_of(w[i]), length).hi : ${zero};
  }
  p->b[0] = p->b[1] = ${zero};
  p->b[2] = length.hi;
  o->a[0] = o->f[5] = ${one};
  ${name}_store(o->turn, ${name}_pair_divide(length, ${name}_pair_scale(${name}_pi(), 2)));
  o->scale[2] = ${one};
}

int ${name}_solve(${name}_orbit *o, const ${name}_model *m, const ${name}_real x0[])
{
  ${name}_orbit made;
  ${name}_top p;
  ${name}_pair I[3], axis[3][3], w[3];
  ${name}_real tensor[6], rate[3], y[4], q0[4], n, size, turned, largest = ${zero};
  const ${name}_phases phases = {${zero}, ${zero}, ${zero}, ${zero}};
  ${name}_terms terms;
  int order[3], scale, e, i, j, k;

  ${name}_inertia(m, tensor);
  for (i = 0; i < ${upper}_NX; i++) {
    if (!(x0[i] - x0[i] == ${zero})) return 1;
  }
  if (!(${name}_unit_quaternion(x0 + ${upper}_QW, q0).hi > ${zero})) return 1;
  if (${name}_principal_pairs(tensor, I, axis, order, &scale)) return 1;
  (void)${frexp}(I[order[2]].hi, &e);
  for (i = 0; i < 3; i++) I[i] = ${name}_pair_scale(I[i], -e);
  size = ${eight}*${epsilon}*I[order[2]].hi;
  if (!(I[order[0]].hi > ${zero})) { /* a rod */
    const ${name}_pair sum = ${name}_pair_add(I[order[1]], I[order[2]]);

    if (I[order[0]].hi < -size || I[order[2]].hi - I[order[1]].hi > size) return 1;
    I[order[0]] = ${name}_pair_of(${zero});
    I[order[1]] = I[order[2]] = ${name}_pair_scale(sum, -1);
  }
  for (i = 0; i < 3; i++) largest = ${fabs}(x0[${upper}_WX + i]) > largest ? ${fabs}(x0[${upper}_WX + i]) : largest;
  (void)${frexp}(largest, &e);
  for (i = 0; i < 3; i++) rate[i] = ${ldexp}(x0[${upper}_WX + i], -e);
  for (i = 0; i < 3; i++) {
    w[i] = ${name}_pair_times(rate[0], axis[i][0]);
    for (j = 1; j < 3; j++) w[i] = ${name}_pair_add(w[i], ${name}_pair_times(rate[j], axis[i][j]));
  }
  for (i = 0, k = 0; i < 3; i++) { /* w x L = 0? */
    j = (i + 1) % 3;
    n = ${name}_pair_subtract(I[i], I[j]).hi;
    if (${fabs}(w[i].hi) > ${zero} && ${fabs}(w[j].hi) > ${zero} && ${fabs}(n) > ${zero}) k = 1;
  }
  ${name}_clear(&made);
  if (!k) {
    p.small12 = 0;
    ${name}_constant(&made, &p, rate);
  } else {
    ${name}_label(&p, I, w, (const ${name}_pair(*)[3])axis, order);
    ${name}_invariants(&p);
    made.s = p.s;
    /* from kappa = 1, k'^2 = 17 - 12 sqrt 2, on, where the two series converge alike */
    if (p.kc2.hi*p.down13*p.down13 < ${one}/(${name}_real)34) ${name}_hyperbolic(&made, &p);
    else ${name}_circular(&made, &p);
  }
  for (i = 0; i < 2; i++) { /* high parts in halves, for Dekker's product */
    ${name}_real *b = i == 0 ? made.rate : made.turn, c = ${split}*b[0];

    b[2] = c - (c - b[0]);
    b[3] = b[0] - b[2];
    for (j = 0; j < 4; j++) b[j] = ${ldexp}(b[j], e); /* per second again */
  }
  if (!(made.rate[0] - made.rate[0] == ${zero}) || !(made.turn[0] - made.turn[0] == ${zero})) return 1;

  /* the rates are over N^2, which is this at u = 0 */
  terms = ${name}_terms_of(&made, phases, made.hyperbolic);
  n = ${name}_square(&terms);
  for (i = 0; i < 3; i++) {
    for (j = 0; j < 3; j++) {
      made.w[i][j] = ${ldexp}(n*made.scale[i]*p.b[i]*p.axis[i][j], e + (i < 2 ? p.small12 : 0));
    }
  }
  /* q(t) = q0 (conj(y0) y(t)), the vector part of the second turned from principal to body axes */
  for (i = 0; i < 4; i++) {
    for (j = 0; j < 4; j++) made.q[i][j] = i == j ? ${one} : ${zero};
  }
  terms = ${name}_terms_of(&made, ${name}_reduce(&made, ${zero}), made.hyperbolic);
  ${name}_attitude_of(&made, &terms, y);
  turned = made.hyperbolic ? p.s : ${one}; /* of x and y */
  y[1] *= turned;
  y[2] *= turned;
  (void)${name}_unit_quaternion(y, y);
  for (k = 0; k < 4; k++) {
    ${name}_real unit[4] = {${zero}, ${zero}, ${zero}, ${zero}}, d[4], v[4];

    unit[k] = k == 1 || k == 2 ? turned : ${one};
    for (i = 1; i < 4; i++) y[i] = k == 0 ? -y[i] : y[i];
    ${name}_quaternion_product(y, unit, d);
    v[0] = d[0];
    for (j = 0; j < 3; j++) v[j + 1] = d[1]*p.axis[0][j] + d[2]*p.axis[1][j] + d[3]*p.axis[2][j];
    ${name}_quaternion_product(q0, v, made.q[k]);
  }
  *o = made;
  return 0;
}
