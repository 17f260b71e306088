%% -- circular.c -- the free top away from the separatrix: part of scene.c.  SPDX-License-Identifier: MIT-0
/* ---- set-up away from the separatrix ---- */

/* The means a, g of 1 and k' (DLMF 19.8.2), as far as they are needed: after four steps they agree to 2^-35, and what is
 * left is added as a series. */
typedef struct ${name}_agm {
  ${name}_pair k, a1, g1, a2, g2, a3, g3; /* k' first */
  ${name}_pair M;                         /* their limit, pi/(2 K) */
  ${name}_pair q;                         /* nome, up12^2 */
} ${name}_agm;

/* The nome: q^(2^n) = e + 2 e^5 + 15 e^9 + ... with e = (a_n - g_n)/(8 a_(n+2)) (DLMF 19.5.6 at the n-th modulus).  From
 * n to n + 1 e becomes e^2 a_(n+2)/a_(n+3), which gives q as a product that ends quickly,
 *     q = k^2/(8 a_1 (1 + g_1) sqrt a_3) (a_3/a_4)^(1/4) (a_4/a_5)^(1/8) ... */
static void ${name}_nome_of(${name}_agm *f, const ${name}_top *p)
{
  const ${name}_pair one = ${name}_pair_of(${one});
  ${name}_pair a4, a5, d, rest, u;
  ${name}_real t;

  f->k = ${name}_pair_root(${name}_shift(p->down13, ${name}_shift(p->down13, p->kc2)));
  f->a1 = ${name}_shift(${half}, ${name}_add(one, f->k)); f->g1 = ${name}_pair_root(f->k);
  f->a2 = ${name}_shift(${half}, ${name}_add(f->a1, f->g1)); f->g2 = ${name}_pair_root(${name}_mul(f->a1, f->g1));
  f->a3 = ${name}_shift(${half}, ${name}_add(f->a2, f->g2)); f->g3 = ${name}_pair_root(${name}_mul(f->a2, f->g2));
  d = ${name}_sub(f->a3, f->g3); a4 = ${name}_sub(f->a3, ${name}_shift(${half}, d)); u = ${name}_mul(d, d); t = u.hi/(${n[16]}*a4.hi);
  /* a_4 - a_5 = (a_3 - g_3)^2/(16 a_5) */
  rest = ${name}_ratio(u, ${name}_shift(${n[16]}, ${name}_sub(a4, ${name}_pair_of(t)))); a5 = ${name}_sub(a4, rest);
  f->M = ${name}_sub(a5, ${name}_pair_of(t*t/(${four}*a5.hi)));

  /* (1 + 4 u)^(1/4) = 1 + u - 3/2 u^2 + 7/2 u^3 - 77/8 u^4 + 231/8 u^5, u < 2^-18 */
  u = ${name}_ratio(${name}_shift(${eighth}, d), a4); t = u.hi;
  u = ${name}_add(u, ${name}_sub(${name}_pair_of((t*t*t)*(${n[3.5]}
      - t*(${n[9.625]} - t*(${n[28.875]})))),
      ${name}_scaled(${threehalves}, ${name}_mul(u, u))));
  /* (1 + 8 r)^(1/8) = 1 + r - 7/2 r^2, and a_5/a_6 = 1 + 16 r^2 */
  rest = ${name}_ratio(${name}_shift(${eighth}, rest), a5); t = rest.hi;
  u = ${name}_add(u, ${name}_add(rest, ${name}_pair_of(t*(u.hi - ${n[2.5]}*t*(${one} + u.hi)))));
  f->q = ${name}_ratio(p->k2, ${name}_shift(${eight},
      ${name}_mul(f->a1, ${name}_mul(${name}_add(one, f->g1), ${name}_pair_root(f->a3)))));
  f->q = ${name}_add(f->q, ${name}_mul(f->q, u));
}

/* z at t = 0, in units of pi.  Two of Gauss's transformations, in which z is doubled (DLMF 22.7.2 and its companions), lead
 * to functions of nome q^4, where sc = tan up to q^8 (DLMF 20.2.1-2, 22.2). */
static ${name}_pair ${name}_first_phase(const ${name}_top *p, const ${name}_agm *f, ${name}_real q8)
{
  const ${name}_real size = ${ldexp}(${one}, -${name}_exponent(p->Delta3.hi, ${zero})), q24 = q8*q8*q8;
  const ${name}_pair w12 = ${name}_mul(${name}_shift(p->up12, p->w[0]),
      ${name}_shift(p->up12, p->w[1]));
  const ${name}_pair c = ${name}_shift(size, ${name}_sub(p->part1,
      ${name}_mul(f->k, p->part2)));
  const ${name}_pair s = ${name}_shift(p->s*size*${two},
      ${name}_mul(f->a1, ${name}_mul(w12, p->cross)));
  ${name}_pair x = ${name}_mul(f->a2, ${name}_sub(${name}_mul(f->a1,
      ${name}_mul(c, c)), ${name}_mul(f->g1, ${name}_mul(s, s))));
  ${name}_pair y = ${name}_mul(f->g3, ${name}_shift(${two},
      ${name}_mul(f->a2, ${name}_mul(c, s))));
  ${name}_real more_x = ${zero}, more_y = ${zero}, cosine, X, Y;
  int i;

  for (i = 0; i < 3; i++) { /* the series know cos 8 z to 2^-15, 2^-30, 2^-45 */
    X = x.hi + more_x; Y = y.hi + more_y;
    cosine = (X - Y)*(X + Y)/(X*X + Y*Y);
    X = ${two}*cosine;
    more_x = x.hi*(q24*(X*X + X - ${one}) - q8*(${one} + X));
    more_y = y.hi*(q24*(X*X - X - ${one}) - q8*(${one} - X));
  }
  /* 4 z, or less by a turn if |2 z| > pi/2 (c < 0) */
  x = ${name}_pair_angle(${name}_add(x, ${name}_pair_of(more_x)), ${name}_add(y, ${name}_pair_of(more_y)));
  X = p->s*p->w[1].hi; /* sin 2 z has its sign; where c is 0, x is pi */
  if (c.hi < ${zero} || (!(c.hi > ${zero}) && X < ${zero})) x = ${name}_add(x,
      ${name}_shift(X < ${zero} ? -${two} : ${two}, ${name}_pi()));
  return ${name}_shift(${quarter}, ${name}_mul(x, ${name}_inverse_pi()));
}

/* The coefficients away from the separatrix: E = q^(1/2) e^eta, r = e^(-2 eta) */
static void ${name}_circular_series(${name}_orbit *o, ${name}_real s, ${name}_real q, ${name}_real E, ${name}_real r)
{
  ${name}_real e[8], g[8], a[4], b[4], c[5], d[4], Q[26], sign, two_ = ${zero}, three_ = ${one}, four_ = ${one};
  const ${name}_real twice = ${two}*s;
  int n;

  /* theta4: 1 - q (E^2 + g^2) cos 2z + q^6 (E^4 + g^4) cos 4z - ..., g = q/E; theta1: (E + g) sin z - ... */
  e[0] = g[0] = Q[0] = ${one};
  for (n = 1; n < 8; n++) {
    e[n] = e[n - 1]*E; g[n] = g[n - 1]*(E*r);
  }
  for (n = 1; n < 26; n++) Q[n] = Q[n - 1]*q;
  for (n = 0, sign = ${one}; n < 4; n++, sign = -sign) { /* what q <= exp(-pi/2) leaves above 2^-54 */
    const ${name}_real even = sign*Q[n*(2*n - 1)], odd = sign*Q[n*(2*n + 1)];

    a[n] = n == 0 ? ${one} : even*(e[2*n] + g[2*n]);
    b[n] = twice*even*(e[2*n] - g[2*n]); /* of sin 2nz: b[0] is 0 */
    c[n] = s*odd*(e[2*n + 1] + g[2*n + 1]);
    d[n] = -odd*(e[2*n + 1] - g[2*n + 1]);
  }
  ${name}_polynomial(4, a, ${zero}, ${one}, o->a);
  ${name}_polynomial(3, b + 1, ${zero}, ${two}, o->b);
  ${name}_polynomial(4, c, ${one}, ${two}, o->c);
  ${name}_polynomial(4, d, -${one}, ${two}, o->d);

  /* theta2(z; q), theta1(z; q) without 2 q^(1/4), theta3(z; q), each over what makes it cn, sn, dn times
   * theta4/theta4(0) */
  for (n = 0; n < 5; n++) two_ += Q[n*(n + 1)];
  for (n = 1; n < 6; n++) {
    three_ += ${two}*Q[n*n]; four_ += (n % 2 ? -${two} : ${two})*Q[n*n];
  }
  for (n = 0; n < 5; n++) c[n] = Q[n*(n + 1)];
  ${name}_polynomial(5, c, -${one}, ${two}, o->f);
  for (n = 0; n < 5; n++) c[n] = (n ? ${two} : ${one})*Q[n*n];
  ${name}_polynomial(5, c, ${zero}, ${one}, o->f + 5);
  o->scale[0] = ${one}/two_; o->scale[1] = s*three_/(two_*four_); o->scale[2] = ${one}/three_;
}

/* At u = 0 b/a = T.  With v = E - q/E, S = q (E^2 + (q/E)^2) = q (v^2 + 2 q) the two series are
 *     b = v (1 - q^2 (S + q^2) + q^8 (S^2 + q^2 S - q^4) - ...),
 *     a = 1 - S + q^4 (S^2 - 2 q^4) - q^12 (S^3 - 3 q^4 S) + ...:
 * one equation for v, solved by Newton's method, the last step in pairs.  There the phase of a(t) turns at half of
 * `climb`, theta4 has its part in it, and the rest is mu: with d = q (E^2 - (q/E)^2)
 *     mu = climb/2 + s z' (2 d - 4 q^4 d S + 6 q^12 d (S^2 - q^4) - ...)/a. */
static void ${name}_set_circular(${name}_orbit *o, const ${name}_top *p)
{
  const ${name}_pair one = ${name}_pair_of(${one});
  ${name}_pair q, q2, q4, q8, S, S2, a, b, v, d, rate, start, turn;
  ${name}_agm f;
  ${name}_real q24, T = p->T.hi, square = p->down12*p->down12, x, da, db, dS, E, r;
  int i;

  ${name}_nome_of(&f, p);
  q = ${name}_shift(square, f.q); q2 = ${name}_mul(q, q); q4 = ${name}_mul(q2, q2); q8 = ${name}_mul(q4, q4);
  q24 = q8.hi*q8.hi*q8.hi;
  start = ${name}_first_phase(p, &f, q8.hi);
  rate = ${name}_mul(${name}_mul(p->lambda, f.M), ${name}_inverse_pi());

  x = T/(${one} + q.hi*(T*T*square));
  dS = S.hi = da = db = ${zero};
  for (i = 0; i < 4; i++) { /* errors 2^-4, 2^-11, 2^-24, 2^-49, rounding; v, T and E are all up12 */
    const ${name}_real s = q.hi*(square*(x*x + ${two}*f.q.hi)), Q = q4.hi, Q2 = q2.hi, Q8 = q8.hi;
    const ${name}_real up = ${one} - s + Q*(s*s - ${two}*Q - Q8*s*(s*s - ${three}*Q));
    const ${name}_real down = ${one} - Q2*(s + Q2) + Q8*((s*s + Q2*s - Q) - Q8*Q2*(s*(s*(s + Q2) - ${two}*Q) - Q*Q2));

    da = Q*(${two}*s - ${three}*Q8*(s*s - Q)) - ${one};
    db = Q8*(${two}*s + Q2) - Q2;
    dS = ${two}*q.hi*(square*x);
    x += (T*up - x*down)/(down - (T*da - x*db)*dS);
  }
  S = ${name}_mul(${name}_shift(square, q),
      ${name}_add(${name}_pair_product(x, x), ${name}_shift(${two}, f.q)));
  S2 = ${name}_mul(S, S);
  a = ${name}_sub(${name}_sub(S2, ${name}_shift(${two}, q4)),
      ${name}_mul(${name}_mul(q8, S), ${name}_sub(S2, ${name}_scaled(${three}, q4))));
  a = ${name}_add(${name}_sub(one, S), ${name}_mul(q4, a));
  a = ${name}_add(a, ${name}_pair_of(q24*(S2.hi*(S2.hi - ${four}*q4.hi) + ${two}*q8.hi)));
  b = ${name}_mul(q2, ${name}_add(S, q2));
  d = ${name}_mul(q8, ${name}_sub(${name}_add(S2, b), ${name}_shift(${two}, q4)));
  r = q2.hi*(S.hi*(S2.hi + q2.hi*S.hi - ${two}*q4.hi) - q2.hi*q4.hi);
  r = q8.hi*q8.hi*(r - q8.hi*q8.hi*(S.hi*(S.hi*(S.hi*(S.hi + q2.hi) - ${three}*q4.hi) - ${two}*q2.hi*q4.hi) + q8.hi));
  b = ${name}_add(${name}_sub(one, b), ${name}_sub(d, ${name}_pair_of(r)));
  r = ${name}_sub(${name}_mul(p->T, a), ${name}_scaled(x, b)).hi/(b.hi - (T*da - x*db)*dS);
  v = ${name}_pair_sum(x, r);
  S.lo += dS*r;
  S2.lo += ${two}*S.hi*(dS*r);
  a.lo += da*dS*r;

  d = ${name}_pair_root(${name}_add(${name}_mul(v, v), ${name}_shift(${four}, f.q)));
  E = ${half}*(v.hi + d.hi);
  r = f.q.hi/(E*E);
  E *= p->down12;
  d = ${name}_mul(${name}_mul(${name}_shift(square, q), v), d);
  turn = ${name}_sub(${name}_shift(${two}, S),
      ${name}_mul(${name}_scaled(${three}, q8), ${name}_sub(S2, q4)));
  turn = ${name}_add(${name}_sub(one, ${name}_mul(q4, turn)),
      ${name}_pair_of(-${four}*q24*(S.hi*(S2.hi - ${two}*q4.hi)
      - ${n[1.25]}*(q8.hi*q8.hi)*(S2.hi*S2.hi))));
  turn = ${name}_mul(${name}_mul(rate, ${name}_ratio(d, a)), turn);
  turn = ${name}_add(${name}_shift(${quarter}, ${name}_mul(p->climb, ${name}_inverse_pi())),
      ${name}_shift(p->s, turn));
  o->hyperbolic = 0;
  ${name}_store(o->start, ${name}_shift(${half}, start)); /* the rates have two periods of theta functions */
  ${name}_store(o->rate, ${name}_shift(${half}, rate));
  ${name}_store(o->turn, turn);
  ${name}_circular_series(o, p->s, q.hi, E, r);
}
