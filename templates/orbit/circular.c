%% -- circular.c -- the free top away from the separatrix: part of scene.c.  SPDX-License-Identifier: MIT-0
/* ---- set-up away from the separatrix ---- */

/* z at t = 0 in units of pi, the nome up12^2, its powers q, q^2, q^4, q^8, and M = pi/(2 K), from the
 * means a, g of 1 and k' (DLMF 19.8.2).  After four steps they agree to 2^-35; a series has the rest.
 * The nome: q^(2^n) = e + 2 e^5 + 15 e^9 + ... with e = (a_n - g_n)/(8 a_(n+2)) (DLMF 19.5.6 at the
 * n-th modulus).  From n to n + 1 e becomes e^2 a_(n+2)/a_(n+3), so that q is a product:
 *     q = k^2/(8 a_1 (1 + g_1) sqrt a_3) (a_3/a_4)^(1/4) (a_4/a_5)^(1/8) ...
 * The phase: two of Gauss's transformations, in which z is doubled (DLMF 22.7.2 and its companions),
 * lead to functions of nome q^4, where sc = tan up to q^8 (DLMF 20.2.1-2, 22.2). */
static ${name}_pair ${name}_first_phase(const ${name}_top *p, ${name}_pair *nome, ${name}_pair q[4], ${name}_pair *M)
{
  const ${name}_pair one = ${name}_pair_of(${one}), k = ${name}_pair_root(${name}_shift(p->down13, ${name}_shift(p->down13, p->kc2)));
  const ${name}_pair a1 = ${name}_shift(${half}, ${name}_add(one, k)), g1 = ${name}_pair_root(k);
  const ${name}_pair a2 = ${name}_shift(${half}, ${name}_add(a1, g1)), g2 = ${name}_pair_root(${name}_mul(a1, g1));
  const ${name}_pair a3 = ${name}_shift(${half}, ${name}_add(a2, g2)), g3 = ${name}_pair_root(${name}_mul(a2, g2));
  const ${name}_pair d = ${name}_sub(a3, g3), a4 = ${name}_sub(a3, ${name}_shift(${half}, d)), d2 = ${name}_mul(d, d);
  const ${name}_real last = d2.hi/(${n[16]}*a4.hi);
  /* a_4 - a_5 = (a_3 - g_3)^2/(16 a_5) */
  const ${name}_pair fall = ${name}_ratio(d2, ${name}_shift(${n[16]}, ${name}_sub(a4, ${name}_pair_of(last)))), a5 = ${name}_sub(a4, fall);
  *M = ${name}_sub(a5, ${name}_pair_of(last*last/(${four}*a5.hi)));

  /* (1 + 4 u)^(1/4) = 1 + u - 3/2 u^2 + 7/2 u^3 - 77/8 u^4 + 231/8 u^5, u < 2^-18 */
  ${name}_pair u = ${name}_ratio(${name}_shift(${eighth}, d), a4);
  ${name}_real t = u.hi;
  u = ${name}_add(u, ${name}_sub(${name}_pair_of((t*t*t)*(${n[3.5]} - t*(${n[9.625]} - t*${n[28.875]}))), ${name}_scaled(${threehalves}, ${name}_mul(u, u))));
  /* (1 + 8 r)^(1/8) = 1 + r - 7/2 r^2, and a_5/a_6 = 1 + 16 r^2 */
  const ${name}_pair r = ${name}_ratio(${name}_shift(${eighth}, fall), a5);
  t = r.hi;
  u = ${name}_add(u, ${name}_add(r, ${name}_pair_of(t*(u.hi - ${n[2.5]}*t*(${one} + u.hi)))));
  *nome = ${name}_ratio(p->k2, ${name}_shift(${eight}, ${name}_mul(a1, ${name}_mul(${name}_add(one, g1), ${name}_pair_root(a3)))));
  *nome = ${name}_add(*nome, ${name}_mul(*nome, u));
  q[0] = ${name}_shift(p->down12*p->down12, *nome);
  for (int i = 1; i < 4; i++) q[i] = ${name}_mul(q[i - 1], q[i - 1]);

  const ${name}_real size = ${ldexp}(${one}, -${name}_exponent(p->Delta3.hi, ${zero})), Q8 = q[3].hi, Q24 = Q8*Q8*Q8;
  const ${name}_pair w12 = ${name}_mul(${name}_shift(p->up12, p->w[0]), ${name}_shift(p->up12, p->w[1]));
  const ${name}_pair c = ${name}_shift(size, ${name}_sub(p->part1, ${name}_mul(k, p->part2)));
  const ${name}_pair s = ${name}_shift(p->s*size*${two}, ${name}_mul(a1, ${name}_mul(w12, p->cross)));
  const ${name}_pair x = ${name}_mul(a2, ${name}_sub(${name}_mul(a1, ${name}_mul(c, c)), ${name}_mul(g1, ${name}_mul(s, s))));
  const ${name}_pair y = ${name}_mul(g3, ${name}_shift(${two}, ${name}_mul(a2, ${name}_mul(c, s))));
  ${name}_real more_x = ${zero}, more_y = ${zero};
  for (int i = 0; i < 3; i++) { /* the series know cos 8 z to 2^-15, 2^-30, 2^-45 */
    const ${name}_real X = x.hi + more_x, Y = y.hi + more_y, C = ${two}*((X - Y)*(X + Y)/(X*X + Y*Y));
    more_x = x.hi*(Q24*(C*C + C - ${one}) - Q8*(${one} + C));
    more_y = y.hi*(Q24*(C*C - C - ${one}) - Q8*(${one} - C));
  }
  /* 4 z, or less by a turn if |2 z| > pi/2 (c < 0); sin 2 z has the sign of s w2; pi where c = 0 */
  ${name}_pair z4 = ${name}_pair_angle(${name}_add(x, ${name}_pair_of(more_x)), ${name}_add(y, ${name}_pair_of(more_y)));
  const int below = p->s*p->w[1].hi < ${zero};
  if (c.hi < ${zero} || (!(c.hi > ${zero}) && below)) z4 = ${name}_add(z4, ${name}_shift(below ? -${two} : ${two}, ${name}_pair_pi));
  return ${name}_shift(${quarter}, ${name}_mul(z4, ${name}_inverse_pi));
}

/* The coefficients away from the separatrix: E = q^(1/2) e^eta, r = e^(-2 eta) */
static void ${name}_circular_series(${name}_orbit *o, ${name}_real s, ${name}_real q, ${name}_real E, ${name}_real r)
{
  ${name}_real e[8], g[8], a[4], b[4], c[5], d[4], Q[26], two_ = ${zero}, three_ = ${one}, four_ = ${one};

  /* with g = q/E: theta4 = 1 - q (E^2 + g^2) cos 2z + q^6 (E^4 + g^4) cos 4z - ...,
   * theta1 = (E + g) sin z - ... */
  e[0] = g[0] = Q[0] = ${one};
  for (int n = 1; n < 8; n++) {
    e[n] = e[n - 1]*E;
    g[n] = g[n - 1]*(E*r);
  }
  for (int n = 1; n < 26; n++) Q[n] = Q[n - 1]*q;
  for (int n = 0; n < 4; n++) { /* what q <= exp(-pi/2) leaves above 2^-54 */
    const ${name}_real sign = n % 2 ? -${one} : ${one}, even = sign*Q[n*(2*n - 1)], odd = sign*Q[n*(2*n + 1)];
    a[n] = n == 0 ? ${one} : even*(e[2*n] + g[2*n]);
    b[n] = ${two}*s*even*(e[2*n] - g[2*n]); /* of sin 2nz: b[0] is 0 */
    c[n] = s*odd*(e[2*n + 1] + g[2*n + 1]);
    d[n] = -odd*(e[2*n + 1] - g[2*n + 1]);
  }
  ${name}_polynomial(4, a, ${zero}, ${one}, o->a); ${name}_polynomial(3, b + 1, ${zero}, ${two}, o->b);
  ${name}_polynomial(4, c, ${one}, ${two}, o->c); ${name}_polynomial(4, d, -${one}, ${two}, o->d);

  /* theta2, theta1 (both without 2 q^(1/4)) and theta3 of z; q, and what makes them cn, sn, dn times
   * theta4/theta4(0) */
  for (int n = 1; n < 6; n++) {
    two_ += Q[n*(n - 1)];
    three_ += ${two}*Q[n*n];
    four_ += (n % 2 ? -${two} : ${two})*Q[n*n];
  }
  o->scale[0] = ${one}/two_; o->scale[1] = s*three_/(two_*four_); o->scale[2] = ${one}/three_;
  for (int n = 0; n < 5; n++) c[n] = Q[n*(n + 1)];
  ${name}_polynomial(5, c, -${one}, ${two}, o->f);
  for (int n = 0; n < 5; n++) c[n] = (n ? ${two} : ${one})*Q[n*n];
  ${name}_polynomial(5, c, ${zero}, ${one}, o->f + 5);
}

/* At u = 0 b/a = T.  With v = E - q/E, S = q (E^2 + (q/E)^2) = q (v^2 + 2 q) the two series are
 *     b = v (1 - q^2 (S + q^2) + q^8 (S^2 + q^2 S - q^4) - ...),
 *     a = 1 - S + q^4 (S^2 - 2 q^4) - q^12 (S^3 - 3 q^4 S) + ...:
 * one equation for v, solved by Newton's method, the last step in pairs.  There the phase of a(t)
 * turns at climb/2, theta4 has its part in it, and the rest is mu: with d = q (E^2 - (q/E)^2)
 *     mu = climb/2 + s z' (2 d - 4 q^4 d S + 6 q^12 d (S^2 - q^4) - ...)/a.
 * v, T, E and the root of `nome` are all up12. */
static void ${name}_set_circular(${name}_orbit *o, const ${name}_top *p)
{
  ${name}_pair nome, q[4], M;
  const ${name}_pair start = ${name}_first_phase(p, &nome, q, &M), rate = ${name}_mul(${name}_mul(p->lambda, M), ${name}_inverse_pi);
  const ${name}_pair one = ${name}_pair_of(${one}), q2 = q[1], q4 = q[2], q8 = q[3];
  const ${name}_real square = p->down12*p->down12, T = p->T.hi;
  const ${name}_real Q = q[0].hi, Q2 = q2.hi, Q4 = q4.hi, Q8 = q8.hi, Q16 = Q8*Q8, Q24 = Q8*Q8*Q8;

  ${name}_real x = T/(${one} + Q*(T*T*square)), dS = ${zero}, da = ${zero}, db = ${zero};
  for (int i = 0; i < 4; i++) { /* errors 2^-4, 2^-11, 2^-24, 2^-49, rounding */
    const ${name}_real s = Q*(square*(x*x + ${two}*nome.hi));
    const ${name}_real up = ${one} - s + Q4*(s*s - ${two}*Q4 - Q8*s*(s*s - ${n[3]}*Q4));
    const ${name}_real cube = s*(s*(s + Q2) - ${two}*Q4) - Q4*Q2;
    const ${name}_real down = ${one} - Q2*(s + Q2) + Q8*((s*s + Q2*s - Q4) - Q8*Q2*cube);
    da = Q4*(${two}*s - ${n[3]}*Q8*(s*s - Q4)) - ${one};
    db = Q8*(${two}*s + Q2) - Q2;
    dS = ${two}*Q*(square*x);
    x += (T*up - x*down)/(down - (T*da - x*db)*dS);
  }
  ${name}_pair S = ${name}_mul(${name}_shift(square, q[0]), ${name}_add(${name}_pair_product(x, x), ${name}_shift(${two}, nome))), S2 = ${name}_mul(S, S);
  ${name}_pair a = ${name}_sub(${name}_sub(S2, ${name}_shift(${two}, q4)), ${name}_mul(${name}_mul(q8, S), ${name}_sub(S2, ${name}_scaled(${n[3]}, q4))));
  a = ${name}_add(${name}_sub(one, S), ${name}_mul(q4, a));
  a = ${name}_add(a, ${name}_pair_of(Q24*(S2.hi*(S2.hi - ${four}*Q4) + ${two}*Q8)));
  ${name}_pair b = ${name}_mul(q2, ${name}_add(S, q2));
  ${name}_real rest = Q2*(S.hi*(S2.hi + Q2*S.hi - ${two}*Q4) - Q2*Q4);
  rest = Q16*(rest - Q16*(S.hi*(S.hi*(S.hi*(S.hi + Q2) - ${n[3]}*Q4) - ${two}*Q2*Q4) + Q8));
  b = ${name}_add(${name}_sub(one, b), ${name}_sub(${name}_mul(q8, ${name}_sub(${name}_add(S2, b), ${name}_shift(${two}, q4))), ${name}_pair_of(rest)));
  const ${name}_real dx = ${name}_sub(${name}_mul(p->T, a), ${name}_scaled(x, b)).hi/(b.hi - (T*da - x*db)*dS);
  const ${name}_pair v = ${name}_pair_sum(x, dx);
  S.lo += dS*dx;
  S2.lo += ${two}*S.hi*(dS*dx);
  a.lo += da*dS*dx;

  const ${name}_pair sum = ${name}_pair_root(${name}_add(${name}_mul(v, v), ${name}_shift(${four}, nome))); /* E + q/E */
  const ${name}_real E = ${half}*(v.hi + sum.hi);
  const ${name}_pair d = ${name}_mul(${name}_mul(${name}_shift(square, q[0]), v), sum);
  ${name}_pair turn = ${name}_sub(${name}_shift(${two}, S), ${name}_mul(${name}_scaled(${n[3]}, q8), ${name}_sub(S2, q4)));
  rest = -${four}*Q24*(S.hi*(S2.hi - ${two}*Q4) - ${n[1.25]}*Q16*(S2.hi*S2.hi));
  turn = ${name}_add(${name}_sub(one, ${name}_mul(q4, turn)), ${name}_pair_of(rest));
  turn = ${name}_mul(${name}_mul(rate, ${name}_ratio(d, a)), turn);
  turn = ${name}_add(${name}_shift(${quarter}, ${name}_mul(p->climb, ${name}_inverse_pi)), ${name}_shift(p->s, turn));
  o->hyperbolic = 0;
  o->start[0] = ${half}*start.hi; o->start[1] = ${half}*start.lo;
  per_second(p, ${name}_shift(${half}, rate), o->rate); /* the rates have two periods of theta functions */
  per_second(p, turn, o->turn);
  ${name}_circular_series(o, p->s, Q, E*p->down12, nome.hi/(E*E));
}
