%% -- hyperbolic.c -- the free top near the separatrix: part of scene.c.  SPDX-License-Identifier: MIT-0
/* ---- set-up near the separatrix ---- */

/* c[n] p^(n(n + 1)) cosh((2n + 1)V)/cosh V, n < 4, summed, as a polynomial in U = p cosh 2V */
static void ${name}_multiples(const ${name}_real c[4], ${name}_real p, ${name}_real out[4])
{
  const ${name}_real p2 = p*p, p4 = p2*p2, p8 = p4*p4;

  out[0] = c[0] - p2*(c[1] + p4*(c[2] - p4*p2*c[3]));
  out[1] = ${two}*p*(c[1] - p4*(c[2] + ${two}*p4*p2*c[3]));
  out[2] = ${four}*p4*(c[2] - p4*p2*c[3]);
  out[3] = ${eight}*p8*p*c[3];
}

/* The coefficients, Q the nome of k': cosine[n] = cos((2n + 1)h), sine[n] = -+s sin((2n + 1)h), or a
 * multiple of both */
static void ${name}_hyperbolic_series(${name}_orbit *o, ${name}_real s, ${name}_real Q, const ${name}_real cosine[4], const ${name}_real sine[4])
{
  const ${name}_real P = ${sqrt}(Q), Q2 = Q*Q, two_ = ${one} + Q*Q + Q*Q*Q*Q*Q*Q;
  const ${name}_real three_ = ${one} + ${two}*(Q + Q*Q*Q*Q), four_ = ${one} - ${two}*(Q - Q*Q*Q*Q);

  o->nome = ${half}*P;
  ${name}_multiples(cosine, P, o->a); ${name}_multiples(sine, P, o->b);
  /* cn, sn, dn times theta2/theta2(0), nome q', scaled */
  o->scale[0] = ${one}/four_; o->scale[1] = s*three_/(${two}*two_*four_); o->scale[2] = ${one}/three_;
  o->f[0] = ${one} + ${two}*Q2*Q2; /* with (n + 1/2)^2 = 2 (n(n + 1)/2) + 1/4 ... */
  o->f[1] = -${n[16]}*Q2*Q; o->f[2] = ${n[16]}*Q2; o->f[3] = -${two}*Q; o->f[4] = ${four};
  o->f[5] = ${one} + Q2; o->f[6] = -${four}*(Q + ${n[3]}*Q2*Q2*Q); o->f[7] = ${n[16]}*Q2*Q2;
}

/* V at t = 0 for k' <= 0.172, by the imaginary transformation: functions of 2 i V of nome Q (DLMF
 * 22.6.ix, 22.2), from cd = dn of that, which is 1 - w + ... over 1 + w + ..., w = 2 Q cosh 4V, and
 * sc = tanh of it, which gives sinh 2V.  Where dn u < sqrt k' the same for K - u, half a period less
 * V: so w <= sqrt Q. */
static ${name}_pair ${name}_hyperbolic_start(const ${name}_top *p, ${name}_pair k, ${name}_pair Q, ${name}_pair period)
{
  const ${name}_pair one = ${name}_pair_of(${one}), w1 = ${name}_shift(p->up13, p->w[0]), w3 = ${name}_shift(p->up13, p->w[2]);
  const ${name}_pair kc = ${name}_pair_root(p->kc2), Q2 = ${name}_mul(Q, Q);
  const ${name}_pair two_ = ${name}_add(one, ${name}_add(Q2, ${name}_pair_of(Q2.hi*Q2.hi*Q2.hi)));
  const ${name}_pair three_ = ${name}_add(one, ${name}_shift(${two}, ${name}_add(Q, ${name}_mul(Q2, Q2))));
  const ${name}_real q = Q.hi, dn = w3.hi/p->b3.hi;
  const int far = dn*dn*p->down13 < kc.hi, back = p->w[1].hi < ${zero};
  const ${name}_pair s = ${name}_mul(${name}_shift(back ? -p->up12 : p->up12, p->w[1]), p->cross);
  const ${name}_pair c = ${name}_mul(w1, ${name}_mul(p->J[0], p->d31));
  const ${name}_pair up = far ? c : s, down = far ? ${name}_mul(s, kc) : c; /* sc = up/down 2^e */
  const int e = far ? -p->small12 : p->small12 - p->small13;
  const ${name}_pair above = far ? ${name}_mul(k, p->part2) : ${name}_mul(p->J[0], ${name}_mul(p->Lambda1, k));
  ${name}_pair cd = ${name}_pair_root(${name}_ratio(above, far ? p->Delta3 : ${name}_mul(p->J[2], p->Delta3)));
  if (!far) cd = ${name}_ratio(${name}_shift(p->up12, ${name}_mul(w1, cd)), w3);
  ${name}_pair w = ${name}_ratio(${name}_sub(one, cd), ${name}_add(one, cd));
  ${name}_real more = Q2.hi*(w.hi*w.hi - ${two}*Q2.hi); /* 2 Q^4 cosh 8V = Q^2 (w^2 - 2 Q^2) */
  const ${name}_real better = w.hi*(${one} + more);
  more = Q2.hi*(better*better - ${two}*Q2.hi);
  w = ${name}_add(w, ${name}_pair_of(w.hi*more));
  const ${name}_pair top_ = ${name}_mul(${name}_mul(up, two_), ${name}_add(${name}_sub(one, w), ${name}_pair_of(more)));
  ${name}_pair V = ${name}_sub(one, ${name}_mul(Q, ${name}_add(w, Q)));
  V = ${name}_add(V, ${name}_pair_of(Q2.hi*Q2.hi*(w.hi*w.hi + q*w.hi - Q2.hi)));
  V = ${name}_ratio(top_, ${name}_mul(${name}_mul(down, three_), V)); /* sinh 2V 2^-e; then V = arsinh(that)/2 */
  if (${ldexp}(V.hi, e) > ${one}) {
    const ${name}_pair y = ${name}_pair_scale(${name}_ratio(one, V), -e);
    V = ${name}_shift(${half}, ${name}_pair_log(${name}_mul(V, ${name}_add(one, ${name}_pair_root(${name}_add(one, ${name}_mul(y, y))))), e));
  } else {
    V = ${name}_pair_scale(V, e);
    V = ${name}_shift(${half}, ${name}_pair_log(${name}_add(V, ${name}_pair_root(${name}_add(one, ${name}_mul(V, V)))), 0));
  }
  if (far) V = ${name}_sub(${name}_shift(${half}, period), V);
  return back == (p->s < ${zero}) ? V : ${name}_minus(V);
}

/* Q is the nome of k'.  The period of V is pi kappa = -log(Q)/2 (none on the separatrix), at which
 * the phase about L jumps by -2 s h, h = kappa eta.  At u = 0 b/a = T is
 *     (sin h - Q sin 3h + Q^3 sin 5h - ...)/(cos h + Q cos 3h + Q^3 cos 5h + ...),
 * an equation for x = tan h; c = cos 2h.  Half of `climb` there is mu - s V' d log theta2/dh. */
static void ${name}_set_hyperbolic(${name}_orbit *o, const ${name}_top *p)
{
  const ${name}_pair one = ${name}_pair_of(${one}), k = ${name}_pair_root(${name}_shift(p->down12, ${name}_shift(p->down12, p->k2)));
  const ${name}_pair more = ${name}_add(one, ${name}_pair_root(k));
  const ${name}_real square = p->down13*p->down13;

  /* nome (DLMF 19.5.6) up13^2; theta3(0; Q)^2 = 2 K'/pi */
  ${name}_pair nome = ${name}_ratio(${name}_shift(${half}, p->kc2), ${name}_mul(${name}_add(one, k), ${name}_mul(more, more)));
  ${name}_pair fourth = ${name}_shift(square, ${name}_shift(square, ${name}_mul(nome, nome)));
  fourth = ${name}_mul(fourth, fourth);
  nome = ${name}_add(nome, ${name}_mul(nome, ${name}_add(${name}_shift(${two}, fourth), ${name}_pair_of(${n[15]}*(fourth.hi*fourth.hi)))));
  const int periodic = nome.hi > ${zero}; /* else on the separatrix, to the last bit */
  const ${name}_pair period = periodic ? ${name}_shift(-${half}, ${name}_pair_log(nome, 2*p->small13)) : ${name}_pair_of(${zero});
  const ${name}_pair Q = ${name}_shift(square, nome), Q2 = ${name}_mul(Q, Q), Q3 = ${name}_mul(Q2, Q);
  const ${name}_real q = Q.hi, q3 = Q3.hi, q6 = q3*q3;
  const ${name}_pair three_ = ${name}_add(one, ${name}_shift(${two}, ${name}_add(Q, ${name}_add(${name}_mul(Q2, Q2), ${name}_pair_of(q6*q3)))));
  const ${name}_pair lambda = ${name}_ratio(${name}_shift(${half}, p->lambda), ${name}_mul(three_, three_));

  const ${name}_real T = ${name}_shift(p->down12, p->T).hi;
  ${name}_real x = T, slope = ${zero}, C = ${zero}, dc = ${zero};
  for (int i = 0; i < 3; i++) { /* errors 2^-8, 2^-25, 2^-59 */
    const ${name}_real u = ${one}/(${one} + x*x);
    C = (${one} - x*x)*u;
    dc = -${four}*x*(u*u);
    slope = ${one} - q*(${one} + ${two}*C) + q3*(${four}*C*C + ${two}*C - ${one});
    const ${name}_real miss = T*(${one} + q*(${two}*C - ${one}) + q3*(${four}*C*C - ${two}*C - ${one})) - x*slope;
    slope += dc*(x*(q3*(${eight}*C + ${two}) - ${two}*q) - T*(${two}*q + q3*(${eight}*C - ${two})));
    x += miss/slope;
  }
  ${name}_real sine[5], cosine[5]; /* over sin h, cos h: of h, 3 h, ... 9 h */
  sine[0] = cosine[0] = ${one};
  sine[1] = ${two}*C + ${one}; cosine[1] = ${two}*C - ${one};
  for (int i = 2; i < 5; i++) {
    sine[i] = ${two}*C*sine[i - 1] - sine[i - 2];
    cosine[i] = ${two}*C*cosine[i - 1] - cosine[i - 2];
  }

  const ${name}_pair x2 = ${name}_pair_product(x, x), c = ${name}_ratio(${name}_sub(one, x2), ${name}_add(one, x2));
  const ${name}_pair first = ${name}_mul(Q, ${name}_add(one, ${name}_shift(${two}, c)));
  const ${name}_pair second = ${name}_mul(Q3, ${name}_sub(${name}_shift(${two}, ${name}_add(c, ${name}_shift(${two}, ${name}_mul(c, c)))), one));
  const ${name}_pair up = ${name}_add(${name}_sub(one, first), ${name}_sub(second, ${name}_pair_of(q6*(sine[3] - q3*q*sine[4]))));
  ${name}_pair down = ${name}_sub(${name}_add(first, second), ${name}_shift(${two}, ${name}_add(Q, ${name}_shift(${two}, ${name}_mul(Q3, c)))));
  down = ${name}_add(${name}_add(one, down), ${name}_pair_of(q6*(cosine[3] + q3*q*cosine[4])));
  ${name}_pair rise = ${name}_add(${name}_scaled(${n[5]}, second), ${name}_pair_of(q6*(${n[7]}*sine[3] + ${n[9]}*q3*q*sine[4])));
  rise = ${name}_add(${name}_add(one, ${name}_scaled(${n[3]}, first)), rise);
  const ${name}_real dx = ${name}_sub(${name}_mul(${name}_shift(p->down12, p->T), down), ${name}_scaled(x, up)).hi/slope;
  const ${name}_pair tangent = ${name}_pair_sum(x, dx);
  rise.lo += dc*dx*(${n[6]}*q + ${n[5]}*q3*(${eight}*C + ${two}));
  down.lo += dc*dx*(${two}*q + q3*(${eight}*C - ${two}));
  rise = ${name}_mul(lambda, ${name}_ratio(${name}_mul(tangent, rise), down));
  ${name}_pair turn = ${name}_shift(${half}, ${name}_mul(${name}_add(${name}_shift(${half}, p->climb), ${name}_shift(p->s, rise)), ${name}_inverse_pi));

  o->half = ${no_period}; /* if there is none: V never comes so far */
  const ${name}_pair twice = ${name}_shift(${two}, periodic ? period : ${name}_scaled(o->half, ${name}_log_two));
  const ${name}_pair start = ${name}_ratio(${name}_hyperbolic_start(p, k, Q, period), twice), rate = ${name}_ratio(lambda, twice);
  if (periodic) {
    const ${name}_pair jump = ${name}_shift(p->s, ${name}_mul(${name}_pair_angle(one, tangent), ${name}_inverse_pi));
    turn = ${name}_sub(turn, ${name}_shift(${two}, ${name}_mul(jump, rate)));
    o->jump = jump.hi; o->half = ${name}_ratio(period, ${name}_log_two).hi;
  }
  o->hyperbolic = o->half < ${binary_end} ? 1 : 2;
  o->start[0] = start.hi; o->start[1] = start.lo;
  per_second(p, rate, o->rate);
  per_second(p, turn, o->turn);
  for (int i = 0; i < 4; i++) sine[i] *= (i % 2 ? p->s : -p->s)*tangent.hi; /* all over cos h */
  ${name}_hyperbolic_series(o, p->s, q, cosine, sine);
}
