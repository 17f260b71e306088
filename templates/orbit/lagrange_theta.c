%% -- lagrange_theta.c -- the heavy top's theta functions, set up: part of scene.c.  SPDX-License-Identifier: MIT-0
/* tau of function i = a, b, W, and what it lacks of K': from the zero to the end of its gap (DLMF 19.29.4) */
static ${name}_pair ${name}_tau_of(const ${name}_cubic *p, int i, int rest, int *infinite)
{
  const ${name}_wide c2 = ${name}_wide_scale(p->c, 1), g1 = p->whole, g2 = p->gap;
  const ${name}_wide near = i == 1 ? ${name}_wide_mul(c2, p->below[1]) : p->rate[1];   /* 2 c (zero - u2) */
  const ${name}_wide outer = i == 1 ? ${name}_wide_mul(c2, p->below[0]) : p->rate[0];   /* 2 c (zero - u1) */
  const ${name}_wide far = i == 1 ? p->far[0] : p->rate[2];                              /* 2 c (u3 - zero) */

  if (i == 0) {
    if (rest) return ${name}_argument(g1, ${name}_wide_mul(c2, p->above[0]), ${name}_wide_mul(c2, p->above[1]), p->far[1], infinite);
    return ${name}_argument(${name}_wide_mul(p->above[0], g1), ${name}_wide_mul(p->span, g1),
                 ${name}_wide_mul(p->span, p->far[1]), ${name}_wide_mul(p->above[1], g1), infinite);
  }
  if (rest) return ${name}_argument(${name}_wide_mul(far, g1), ${name}_wide_mul(near, g1), ${name}_wide_mul(outer, g2),
                        ${name}_wide_mul(g1, g2), infinite);
  if (i == 1) return ${name}_argument(${name}_wide_mul(p->below[1], g1), ${name}_wide_mul(far, p->span),
                          ${name}_wide_mul(p->span, g2), ${name}_wide_mul(p->below[0], g2), infinite);
  {
    const ${name}_wide span = ${name}_wide_mul(c2, p->span);

    return ${name}_argument(${name}_wide_mul(near, g1), ${name}_wide_mul(far, span), ${name}_wide_mul(span, g2),
                 ${name}_wide_mul(outer, g2), infinite);
  }
}

/* x/(1 - s x) */
static ${name}_pair ${name}_lambert(${name}_pair x, int s)
{
  const ${name}_pair one = ${name}_pair_of(${one});

  return ${name}_ratio(x, s > 0 ? ${name}_sub(one, x) : ${name}_add(one, x));
}

/* amplitudes: |a| at u2, |b| and |W| at u1 */
static void ${name}_scale_series(${name}_orbit *o, int i, ${name}_real factor)
{
  for (int k = 0; k < 4; k++) {
    o->re[i][k] *= factor;
    o->im[i][k] *= factor;
  }
}

/* Away from the separatrix.  D = q exp(2 eta), r = exp(-2 eta); mu = +-z' d log theta4(i eta)/d eta for a, with theta3 for
 * b, as Lambert series (DLMF 20.5.10-13); theta1(z - i eta) ~ sum of (-1)^n q^(n^2) D^n (exp(i (2n+1) z) - r^(2n+1) exp(-..)). */
static void ${name}_set_circular(${name}_orbit *o, const ${name}_cubic *p, const ${name}_real amplitude[3],
                             ${name}_pair q, ${name}_pair K, ${name}_pair nu, ${name}_pair v0, ${name}_pair mu[2])
{
  const ${name}_pair one = ${name}_pair_of(${one}), K2 = ${name}_pair_scale(K, 1), per = ${name}_ratio(${name}_pair_pi, K);
  const ${name}_pair rate = ${name}_ratio(nu, K2), q2 = ${name}_mul(q, q);
  ${name}_real Q[4], three_ = ${one}, four_ = ${one};
  int n, infinite;

  o->hyperbolic = 0;
  ${name}_store(o->start, ${name}_ratio(v0, K2));
  ${name}_store(o->rate, rate);
  ${name}_store(o->period, one);
  o->inverse = ${one};
  o->winding = (${name}_real)p->winding;
  for (n = 0, Q[0] = ${one}; n < 4; n++) {
    if (n > 0) Q[n] = n == 1 ? q.hi : n == 2 ? q2.hi*q2.hi : q2.hi*q2.hi*q2.hi*q2.hi*q.hi; /* q^(n^2) */
    if (n > 0) three_ += ${two}*Q[n];
    if (n > 0) four_ += (n % 2 ? -${two} : ${two})*Q[n];
  }
  for (int i = 0; i < 3; i++) {
    const int s = i == 0 ? 1 : -1;
    const ${name}_real sign = (${name}_real)p->sign[i];
    ${name}_pair x, r, D, sum, power;
    ${name}_real c[4], d[4], peak = ${zero}, rn, Dn;

    x = ${name}_tau_of(p, i, 0, &infinite);
    r = infinite ? ${name}_pair_of(${zero}) : ${name}_pair_exp(${name}_minus(${name}_mul(per, x)), 0);
    x = ${name}_mul(per, ${name}_tau_of(p, i, 1, &infinite));
    D = infinite ? ${name}_pair_of(${zero}) : ${name}_pair_exp(${name}_minus(x), 0);
    if (i < 2) {
      sum = ${name}_pair_of(${zero});
      power = one;
      for (n = 0; n < 12; n++) { /* D q^(2n) and r q^(2n+1); q^24 < 2^-105 */
        const ${name}_pair high = ${name}_mul(D, power), low = ${name}_mul(${name}_mul(r, power), q);

        if (n == 0 && i == 0 && D.hi > ${half}) { /* 1 - D by exp(x) - 1 = 2 sinh(x/2) exp(x/2) */
          sum = ${name}_ratio(one, ${name}_pair_expm1(x));
        } else {
          sum = ${name}_add(sum, ${name}_lambert(high, s));
        }
        sum = ${name}_sub(sum, ${name}_lambert(low, s));
        power = ${name}_mul(power, q2);
      }
      mu[i] = ${name}_mul(${name}_mul(${name}_pair_pi, rate), ${name}_pair_scale(sum, 1));
      if (s*p->sign[i] < 0) mu[i] = ${name}_minus(mu[i]);
    }
    x = ${name}_sub(one, r);
    for (n = 0, rn = r.hi, Dn = ${one}; n < 4; n++) {
      const ${name}_real size = Q[n]*Dn, odd = i == 0 && n % 2 ? -size : size;

      c[n] = odd*(${one} + rn);
      d[n] = odd*(n == 0 ? x.hi : ${one} - rn);
      peak += size*(${one} + rn);
      Dn *= D.hi;
      rn *= r.hi*r.hi;
    }
    for (n = 0; n < 4; n++) d[n] *= i == 0 ? -sign : sign;
    ${name}_polynomial(4, c, i == 0 ? ${one} : -${one}, ${two}, o->re[i]);
    ${name}_polynomial(4, d, i == 0 ? -${one} : ${one}, ${two}, o->im[i]);
    ${name}_scale_series(o, i, amplitude[i]*(i == 0 ? three_/four_ : ${one})/peak);
  }
}

/* Near the separatrix.  theta = pi tau/(2 K'), zeta = pi v/(2 K') has the period P = -log q'; mu' = +-zeta' tan theta + ..
 * of a, the logarithmic derivative of theta2, and of theta3 for b; with each period the phase jumps by -+2 theta. */
static void ${name}_set_hyperbolic(${name}_orbit *o, const ${name}_cubic *p, const ${name}_real amplitude[3],
                               ${name}_pair q, ${name}_pair logq, ${name}_pair K, ${name}_pair nu, ${name}_pair v0, ${name}_pair mu[2])
{
  const ${name}_pair one = ${name}_pair_of(${one}), scale = ${name}_ratio(${name}_pair_pi, ${name}_pair_scale(K, 1)), q2 = ${name}_mul(q, q);
  const ${name}_pair rate = ${name}_mul(nu, scale);
  const ${name}_real Q = q.hi, Q2 = Q*Q;
  const ${name}_real to[4] = {${one}, Q, Q2*Q2, Q2*Q2*Q2*Q2*Q}, from[4] = {${one}, ${one}, Q2, Q2*Q2*Q2}; /* q'^(n^2), q'^(n^2-n) */
  const ${name}_real odd[4] = {Q, Q*Q2, Q*Q2*Q2, Q*Q2*Q2*Q2}, power_of[4] = {${one}, Q, Q2, Q*Q2};
  int n, infinite;

  o->hyperbolic = 1;
  ${name}_store(o->start, ${name}_mul(v0, scale));
  ${name}_store(o->rate, rate);
  ${name}_store(o->period, ${name}_minus(logq));
  o->inverse = logq.hi < ${zero} ? -${one}/logq.hi : ${zero};
  o->winding = ${zero};
  for (int i = 0; i < 3; i++) {
    const ${name}_real sign = (${name}_real)p->sign[i];
    const ${name}_pair tau = ${name}_tau_of(p, i, 0, &infinite), angle = ${name}_mul(scale, tau);
    ${name}_pair c1, s1, c2, s2, sum, power, term;
    ${name}_real x, y;

    ${name}_pair_circle(angle, &c1, &s1);
    s2 = ${name}_pair_scale(${name}_mul(s1, ${name}_add(one, c1)), 1);
    c2 = ${name}_sub(one, ${name}_pair_scale(${name}_mul(s1, s1), 1));
    if (i < 2) {
      sum = ${name}_pair_of(${zero});
      power = i == 0 ? q2 : q;
      for (n = 0; n < 12; n++) { /* 4 x sin 2 theta/(1 + 2 x cos 2 theta + x^2), x = q'^(2n) or q'^(2n-1) */
        term = ${name}_add(one, ${name}_mul(power, ${name}_add(${name}_pair_scale(c2, 1), power)));
        sum = ${name}_add(sum, ${name}_ratio(${name}_mul(power, s2), term));
        power = ${name}_mul(power, q2);
      }
      sum = ${name}_pair_scale(sum, 2);
      if (i == 0) { /* tan theta; cos theta = sin(pi/2 - theta) */
        ${name}_pair c, s;

        ${name}_pair_circle(${name}_mul(scale, ${name}_tau_of(p, i, 1, &infinite)), &c, &s);
        sum = ${name}_add(sum, ${name}_ratio(s1, s));
      }
      mu[i] = ${name}_mul(rate, sum);
      term = ${name}_ratio(tau, ${name}_pair_scale(K, 1));
      if (p->sign[i] < 0) mu[i] = ${name}_minus(mu[i]);
      ${name}_store(o->jump[i], p->sign[i] < 0 ? term : ${name}_minus(term));
    }
    /* exp(-|zeta|) times theta1 for a, theta4 for b and W, at u2 (zeta = P/2) and u1 (zeta = 0) */
    for (n = 0, x = y = ${zero}; n < 4; n++) {
      const ${name}_real multiple = (${name}_real)(i == 0 ? 2*n + 1 : 2*n)*angle.hi;
      const ${name}_real size = (n % 2 ? -${one} : ${one})*(i == 0 ? to[n] : from[n]);

      o->re[i][n] = size*${cos}(multiple);
      o->im[i][n] = -sign*size*${sin}(multiple);
      if (i == 0) {
        x += o->re[i][n]*(${one} - odd[n]);
        y += o->im[i][n]*(${one} + odd[n]);
      } else {
        x += o->re[i][n]*(n == 0 ? ${one} : ${two}*power_of[n]);
      }
    }
    if (i == 0) x = (${one} + ${two}*(Q + Q2*Q2 + Q2*Q2*Q2*Q2*Q))/${sqrt}(x*x + y*y);
    else x = ${two}*(${one} + Q2 + Q2*Q2*Q2)/x;
    ${name}_scale_series(o, i, amplitude[i]*x);
  }
}
