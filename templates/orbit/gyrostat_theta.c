%% -- gyrostat_theta.c -- the asymmetric gyrostat's theta functions, set up: part of scene.c.  SPDX-License-Identifier: MIT-0
/* eta times what z has of a second: 2 sqrt(vO vF/RO) R_F(E^2 w^2/(RO vO vF), (vF - lambda vO)^2, (vF + lambda vO)^2) */
static ${name}_pair ${name}_eta_of(const ${name}_quartic *p, int i, ${name}_wide rate, int *kind, int *sign, int *infinite)
{
  const ${name}_wide vO = p->edge[p->origin][i], vF = p->edge[1 - p->origin][i];
  const ${name}_wide product = ${name}_wide_mul(vO, vF), near = ${name}_wide_mul(p->lambda, vO);
  const ${name}_wide less = ${name}_wide_sub(vF, near);
  const int natural = 1 + (i != p->origin); /* u = -1 is below the lower end, but may be in the other gap, too */
  ${name}_wide first;

  *kind = ${name}_wide_sign(less) > 0 ? 1 : 2;
  *sign = (${name}_wide_sign(p->E[i]) < 0) == (*kind == natural) ? -1 : 1;
  *infinite = 0;
  if (!${name}_wide_sign(product)) return ${name}_pair_of(${zero});
  first = ${name}_wide_ratio(${name}_wide_square(${name}_wide_mul(p->E[i], p->width)), ${name}_wide_mul(p->RO, product));
  return ${name}_argument(
    ${name}_wide_scale(${name}_wide_ratio(${name}_wide_mul(${name}_wide_square(rate), product), p->RO), 2), first,
    ${name}_wide_square(less), ${name}_wide_square(${name}_wide_add(vF, near)), infinite);
}

/* half the rate of the phase of a (i = 0) or b at an end but for the factor 1/2: +-w3 + A (1 -+ u) */
static ${name}_pair ${name}_end_rate(const ${name}_quartic *p, int i, int end, int e)
{
  const ${name}_wide w3 = ${name}_wide_mul(p->A[2], ${name}_wide_sub(${name}_wide_add(p->u, p->end[end]), p->g));
  const ${name}_wide swung = ${name}_wide_mul(p->A[1 - p->of[end]], p->edge[end][1 - i]);

  return ${name}_wide_pair(${name}_wide_scale(i == 0 ? ${name}_wide_add(swung, w3) : ${name}_wide_sub(swung, w3), -1), e);
}

/* Away from separatrices.  r = exp(-2 eta), D = Q exp(2 eta), Q the squared nome, S_n = Q^(n(n-1)/2) D^n:
 *     theta2(z - i eta) ~ sum of S_n (exp(-i (2n+1) z) + r^(2n+1) exp(i (2n+1) z)), theta1 with (-1)^n
 * Returns the rate of the phase at the end that is farther from the zero, over that of z. */
static ${name}_pair ${name}_set_circular(${name}_orbit *o, int i, int sign, ${name}_pair eta, int infinite,
                                     ${name}_pair mantissa, int power)
{
  const ${name}_pair one = ${name}_pair_of(${one}), q = ${name}_pair_scale(mantissa, power), x = ${name}_pair_scale(eta, 1);
  const int kind = o->odd[i] > ${half} ? 1 : 2;
  ${name}_pair r = ${name}_pair_of(${zero}), D = r, S = one, first = one, rn, qn = one, top = r, bottom = r;
  ${name}_real c[5], d[5];
  int n;

  if (!infinite) {
    r = ${name}_pair_exp(${name}_minus(x), 0);
    first = x.hi < ${half} ? ${name}_mul(${name}_pair_expm1(x), r) : ${name}_sub(one, r);
    if (${fabs}(mantissa.hi) > ${zero}) D = ${name}_mul(mantissa, ${name}_pair_exp(x, power));
  }
  for (n = 0, rn = r; n < 8; n++) {
    const ${name}_pair plus = ${name}_mul(S, ${name}_add(one, rn));
    const ${name}_pair less = ${name}_mul(S, n == 0 ? first : ${name}_sub(one, rn));

    if (n < 5) {
      c[n] = kind == 1 && n % 2 ? -plus.hi : plus.hi;
      d[n] = (kind == 1) != (sign < 0) ? -less.hi : less.hi;
      if (kind == 1 && n % 2) d[n] = -d[n];
    }
    bottom = ${name}_add(bottom, plus);
    top = ${name}_add(top, ${name}_scaled((${name}_real)(2*n + 1), less));
    S = ${name}_mul(S, ${name}_mul(D, qn));
    qn = ${name}_mul(qn, q);
    rn = ${name}_mul(rn, ${name}_mul(r, r));
  }
  ${name}_polynomial(5, c, kind == 1 ? ${one} : -${one}, ${two}, o->re[i]);
  ${name}_polynomial(5, d, kind == 1 ? -${one} : ${one}, ${two}, o->im[i]);
  top = ${name}_ratio(top, bottom);
  return sign < 0 ? ${name}_minus(top) : top;
}

/* Near one: the same functions with the other period.  q = exp(-P), P the period of the phase zeta:
 *     two bands: theta1 ~ sum of (-1)^n q^(n(n+1)) exp((2n+1)(zeta - i theta)), theta2 sum of (-1)^n q^(n^2) exp(2n ..)
 *     one band: sum of s_n q^(n(n+1)/2) exp((2n+1)(zeta - i theta)), s = 1, 1, -1, -1, .., theta2 with (-1)^n s_n
 * over all n.  Stored: cosines and sines of the multiples of theta, with powers of q so that none grows; returns as above. */
static ${name}_pair ${name}_set_hyperbolic(${name}_orbit *o, int i, int sign, ${name}_pair theta, ${name}_pair q)
{
  const ${name}_pair one = ${name}_pair_of(${one});
  const int single = o->hyperbolic == 2, even = !single && !(o->odd[i] > ${half});
  const ${name}_pair f = single ? q : ${name}_mul(q, q); /* ratio of ratios of the powers */
  ${name}_pair c1, s1, c2, s2, c, s, power = one, fn = one, top = ${name}_pair_of(${zero}), bottom = top, weight, next;
  int negative;

  ${name}_pair_circle(theta, &c1, &s1);
  s2 = ${name}_pair_scale(${name}_mul(s1, ${name}_add(one, c1)), 1);
  c2 = ${name}_sub(one, ${name}_pair_scale(${name}_mul(s1, s1), 1));
  c = even ? one : ${name}_add(one, c1);
  s = even ? ${name}_pair_of(${zero}) : s1;
  for (int n = 0; n < 6; n++) { /* power = f^(n(n-1)/2) */
    negative = single ? ((n + 1)/2 + (o->odd[i] > ${half} ? n : 0)) % 2 : n % 2;
    o->re[i][n] = (negative ? -c.hi : c.hi)*power.hi;
    o->im[i][n] = ((negative != (sign < 0)) ? s.hi : -s.hi)*power.hi;
    if (even && n == 0) o->re[i][n] *= ${half};
    if (n > 0) {
      fn = ${name}_mul(fn, f);
      power = ${name}_mul(power, fn);
    }
    next = ${name}_sub(${name}_mul(c, c2), ${name}_mul(s, s2));
    s = ${name}_add(${name}_mul(s, c2), ${name}_mul(c, s2));
    c = next;
  }
  c = single ? ${name}_add(one, c1) : one;
  s = single ? s1 : ${name}_pair_of(${zero});
  weight = one;
  fn = q;
  for (int n = 0; n < 8; n++) { /* weight = q^(n(n+1)/2) or q^(n^2) */
    negative = single ? ((n + 1)/2) % 2 : n % 2;
    next = negative ? ${name}_minus(weight) : weight;
    if (!single && n == 0) next = ${name}_pair_scale(next, -1);
    bottom = ${name}_add(bottom, ${name}_mul(next, c));
    top = ${name}_add(top, ${name}_scaled((${name}_real)(single ? 2*n + 1 : 2*n), ${name}_mul(next, s)));
    weight = ${name}_mul(weight, fn);
    fn = ${name}_mul(fn, f);
    next = ${name}_sub(${name}_mul(c, c2), ${name}_mul(s, s2));
    s = ${name}_add(${name}_mul(s, c2), ${name}_mul(c, s2));
    c = next;
  }
  top = ${name}_ratio(top, bottom);
  return sign < 0 ? top : ${name}_minus(top);
}

/* All but what depends on the frame; turns come over 2^e seconds.  sign: of eta. */
static void ${name}_set_series(${name}_orbit *o, const ${name}_quartic *p, int e, int sign[2])
{
  const ${name}_pair one = ${name}_pair_of(${one});
  const ${name}_wide four = ${name}_wide_scale(p->gamma, 2);
  ${name}_pair q, K, start, mu, eta, P = one;
  ${name}_wide rate, m, mc;
  ${name}_real largest = ${zero};
  int power, infinite, kind;

  if (${name}_wide_sign(${name}_wide_sub(p->sum, p->gamma)) >= 0 && ${name}_wide_sign(${name}_wide_sub(p->sum, four)) <= 0) {
    o->hyperbolic = 0;
    m = p->m;
    mc = ${name}_wide_ratio(${name}_wide_scale(p->gamma, 1), p->sum);
  } else if (${name}_wide_sign(${name}_wide_sub(p->sum, four)) > 0) {
    o->hyperbolic = 1;
    m = ${name}_wide_ratio(${name}_wide_scale(p->gamma, 1), p->sum);
    mc = p->m;
  } else {
    o->hyperbolic = 2;
    m = ${name}_wide_scale(${name}_wide_ratio(p->sum, p->gamma), -1);
    mc = ${name}_wide_sub(${name}_wide_real(${one}), m);
  }
  power = m.e;
  q = ${name}_nome_of(${name}_wide_pair(m, power), ${name}_wide_pair(mc, 0), power);
  K = ${name}_complete(${name}_pair_scale(q, power));
  rate = ${name}_wide_root(o->hyperbolic == 2 ? p->gamma : ${name}_wide_scale(p->sum, -1));
  rate = ${name}_wide_scale(rate, o->hyperbolic == 1 ? -1 : -2);
  rate = ${name}_wide_mul(rate, ${name}_wide_of(${name}_ratio(${name}_pair_pi, K), 0));
  if (o->hyperbolic) {
    P = ${name}_pair_of(${zero});
    if (q.hi > ${zero}) P = ${name}_minus(${name}_pair_log(q, power));
    if (o->hyperbolic == 1) {
      P = ${name}_pair_scale(P, 1);
      q = ${name}_pair_scale(${name}_mul(q, q), power);
    }
    q = ${name}_pair_scale(q, power);
    o->nome = q.hi;
  }
  ${name}_store(o->period, P);
  o->inverse = P.hi > ${zero} ? ${one}/P.hi : ${zero};

  /* 2 sqrt(X Y) R_F((lambda X - Y)^2 RO, (lambda X + Y)^2 RO, R w^2) from O, or before half a period */
  {
    const ${name}_wide X = ${name}_wide_mul(p->lambda, p->X), less = ${name}_wide_sub(p->Y, X);

    m = ${name}_wide_scale(${name}_wide_mul(${name}_wide_square(rate), ${name}_wide_mul(p->X, p->Y)), 2);
    mc = ${name}_wide_mul(${name}_wide_square(${name}_wide_add(p->Y, X)), p->RO);
    start = ${name}_argument(m, ${name}_wide_mul(${name}_wide_square(less), p->RO), mc,
                             ${name}_wide_mul(p->R, ${name}_wide_square(p->width)), &infinite);
    if (${name}_wide_sign(less) < 0) start = ${name}_sub(${name}_pair_scale(o->hyperbolic ? P : ${name}_pair_pi, -1), start);
    if (!p->away) start = ${name}_minus(start);
  }
  mu = ${name}_wide_pair(rate, e);
  ${name}_store(o->start, o->hyperbolic ? start : ${name}_ratio(start, ${name}_pair_pi));
  ${name}_store(o->rate, o->hyperbolic ? mu : ${name}_ratio(mu, ${name}_pair_pi));
  for (int i = 0; i < 2; i++) {
    ${name}_values v;
    ${name}_pair slope;
    ${name}_instant none = {${zero}, ${zero}, ${one}, ${zero}, ${zero}};
    ${name}_real size, big, small[2];
    int k;

    eta = ${name}_eta_of(p, i, rate, &kind, &sign[i], &infinite);
    o->odd[i] = kind == 1 ? ${one} : ${zero};
    if (o->hyperbolic) {
      slope = ${name}_set_hyperbolic(o, i, sign[i], eta, q);
      if (sign[i] > 0) eta = ${name}_minus(eta);
      ${name}_store(o->jump[i], ${name}_ratio(${name}_pair_scale(eta, o->hyperbolic - 1), ${name}_pair_pi));
    } else {
      slope = ${name}_set_circular(o, i, sign[i], eta, infinite, q, power);
    }
    mu = ${name}_end_rate(p, i, kind == 1 ? 1 - p->origin : p->origin, e);
    mu = ${name}_sub(mu, ${name}_mul(slope, ${name}_wide_pair(rate, e)));
    ${name}_store(o->turn[i], ${name}_ratio(mu, ${name}_pair_scale(${name}_pair_pi, 1)));

    v = ${name}_untwisted(o, none); /* at O |a|^2 = (1 + u)/2 and |b|^2 = (1 - u)/2 */
    big = i == 0 ? ${fabs}(v.w) + ${fabs}(v.z) : ${fabs}(v.x) + ${fabs}(v.y); /* next to a zero squares may vanish */
    (void)${frexp}(big, &k);
    small[0] = ${ldexp}(i == 0 ? v.w : v.x, -k);
    small[1] = ${ldexp}(i == 0 ? v.z : v.y, -k);
    size = ${name}_wide_pair(${name}_wide_root(${name}_wide_scale(p->edge[p->origin][i], -1)), k).hi/
           (${sqrt}(small[0]*small[0] + small[1]*small[1]) + ${least});
    for (k = 0; k < 6; k++) {
      o->re[i][k] *= size;
      o->im[i][k] *= size;
      if (${fabs}(o->re[i][k]) > largest) largest = ${fabs}(o->re[i][k]);
      if (${fabs}(o->im[i][k]) > largest) largest = ${fabs}(o->im[i][k]);
    }
  }
  /* One factor is free.  a and b are about 1 at O and may be large at F: then as far from 1 at both, so that squares fit. */
  (void)${frexp}(largest, &power);
  for (int i = 0; i < 2; i++) {
    int k;

    for (k = 0; k < 6; k++) {
      o->re[i][k] = ${ldexp}(o->re[i][k], -(power/2));
      o->im[i][k] = ${ldexp}(o->im[i][k], -(power/2));
    }
  }
}
