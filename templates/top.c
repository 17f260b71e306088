%% -- top.c -- the closed form of the free top, any moments, any state: part of scene.c.  SPDX-License-Identifier: MIT-0
/* ---- closed form: ${theorem} ----
 *
 * Axes 1, 2, 3 here are principal axes: 2 that of the middle moment, 3 the one about which L circulates, signed so that
 * L1 >= 0, L3 > 0.  With a = w + i z, b = x + i y of the quaternion from these axes to a frame whose z axis is along L,
 *     a(t) = exp(i mu t) theta4(z - i s eta; p)/N,   b(t) = s exp(i mu t) theta1(z - i s eta; p)/N,   z = pi u/(2 K)
 * where u = lambda t + u0 is the argument of Jacobi's functions, L = (B1 cn u, s B2 sn u, B3 dn u), and p = q^2
 * (Jacobi 1849; Whittaker, Analytical Dynamics, section 69).  Near the separatrix the imaginary transformation
 * (DLMF 20.7.30-33) replaces z by V = kappa z, kappa = K/(2 K'), and circular functions by hyperbolic ones. */

/* What is known of the motion in principal axes.  [i] is axis i + 1 of the above.  Moments and rates are scaled by powers
 * of two, the largest to about 1; w1 and w2, which may be tiny together, once more by 2^-small12, so w1 and w3 by
 * 2^-small13: nothing underflows that matters. */
typedef struct ${name}_top {
  ${name}_pair I[3], w[3];          /* moments and rates at t = 0 */
  ${name}_pair d21, d31, d32;       /* |I2 - I1|, |I3 - I1|, |I3 - I2| */
  ${name}_pair b[3];                /* amplitudes of the rates, B/I; b[0], b[1] scaled like w1, w2 */
  ${name}_pair G;                   /* |L| */
  ${name}_pair Lambda1;             /* |G^2 - 2 T I1|/I3 */
  ${name}_pair rho;                 /* |I2 - I1|/I3, 0 for a rod about axis 3 */
  ${name}_pair lambda;              /* rate of u */
  ${name}_pair k2, kc2;             /* k^2 2^(-2 small12), (1 - k^2) 2^(-2 small13) */
  ${name}_pair K, Kc;               /* K(k^2), K(1 - k^2) */
  ${name}_pair q, qc;               /* nomes exp(-pi Kc/K) 2^(-2 small12), exp(-pi K/Kc) */
  ${name}_pair log_qc;              /* log of the second; not set if that is 0, on the separatrix */
  ${name}_real axis[3][3];          /* unit vectors, body axes */
  ${name}_real s;                   /* sign of I3 - I1 */
  int small12, small13, hyperbolic;
} ${name}_top;

/* the exponent of the larger of two numbers */
static int ${name}_exponent(${name}_real a, ${name}_real b)
{
  int e;

  (void)${frexp}(${fabs}(a) > ${fabs}(b) ? a : b, &e);
  return e;
}

/* e[0..n) += I w^2 (d.hi + d.lo), without rounding; the new n */
static int ${name}_exact_term(${name}_real e[], int n, ${name}_real I, ${name}_real w, ${name}_pair d)
{
  ${name}_real a[2], b[4];
  int na, nb = 0, i;

  na = ${name}_exact_product(a, 0, w, w);
  for (i = 0; i < na; i++) nb = ${name}_exact_product(b, nb, a[i], I);
  for (i = 0; i < nb; i++) {
    n = ${name}_exact_product(e, n, b[i], d.hi);
    n = ${name}_exact_product(e, n, b[i], d.lo);
  }
  return n;
}

/* I3 w3^2 (I3 - I2) - I1 w1^2 (I2 - I1) = G^2 - 2 T I2: its sign says about which axis L circulates.  Exact before one
 * rounding, if the moments and rates are single numbers. */
static ${name}_pair ${name}_circulation(const ${name}_pair I[3], ${name}_pair w1, ${name}_pair w3, ${name}_pair d21, ${name}_pair d32)
{
  ${name}_pair sum = ${name}_pair_of(${zero});

  if (!(${fabs}(I[0].lo) + ${fabs}(I[2].lo) + ${fabs}(w1.lo) + ${fabs}(w3.lo) > ${zero})) {
    ${name}_real e[32];
    int n;

    n = ${name}_exact_term(e, 0, I[2].hi, w3.hi, d32);
    for (n = ${name}_exact_term(e, n, I[0].hi, w1.hi, ${name}_pair_minus(d21)); n > 0; n--) sum = ${name}_pair_add(sum, ${name}_pair_of(e[n - 1]));
    return sum;
  }
  sum = ${name}_pair_multiply(${name}_pair_multiply(I[2], d32), ${name}_pair_multiply(w3, w3));
  return ${name}_pair_subtract(sum, ${name}_pair_multiply(${name}_pair_multiply(I[0], d21), ${name}_pair_multiply(w1, w1)));
}

/* a quotient's root */
static ${name}_pair ${name}_root_of(${name}_pair a, ${name}_pair b)
{
  return ${name}_pair_root(${name}_pair_divide(a, b));
}

/* Labels and signs of the axes; `order` sorts moments of I, ascending. */
static void ${name}_label(${name}_top *p, const ${name}_pair I[3], const ${name}_pair w[3], const ${name}_pair axis[3][3], const int order[3])
{
  const int small = order[0], middle = order[1], large = order[2];
  const int e = ${name}_exponent(w[small].hi, w[large].hi);
  const ${name}_pair sorted[3] = {I[small], I[middle], I[large]};
  const ${name}_pair low = ${name}_pair_subtract(I[middle], I[small]), high = ${name}_pair_subtract(I[large], I[middle]);
  ${name}_pair D = ${name}_circulation(sorted, ${name}_pair_scale(w[small], -e), ${name}_pair_scale(w[large], -e), low, high);
  const int rod = !(I[small].hi > ${zero}), reverse = rod || D.hi < ${zero};
  const int own[3] = {reverse ? large : small, middle, reverse ? small : large};
  ${name}_real sign[3];
  int i, j;

  p->small13 = e;
  p->s = reverse ? -${one} : ${one};
  p->d21 = reverse ? high : low;
  p->d32 = reverse ? low : high;
  p->d31 = ${name}_pair_subtract(I[large], I[small]);
  sign[0] = w[own[0]].hi < ${zero} ? -${one} : ${one};
  sign[2] = w[own[2]].hi < ${zero} ? -${one} : ${one};
  sign[1] = own[1] == (own[0] + 1) % 3 ? sign[0]*sign[2] : -sign[0]*sign[2]; /* right-handed */
  for (i = 0; i < 3; i++) {
    p->I[i] = I[own[i]];
    p->w[i] = ${name}_pair_times(sign[i], w[own[i]]);
    for (j = 0; j < 3; j++) p->axis[i][j] = sign[i]*axis[own[i]][j].hi;
  }
  p->rho = rod ? ${name}_pair_of(${zero}) : ${name}_pair_divide(p->d21, p->I[2]);
  D = reverse ? ${name}_pair_minus(D) : D;
  if (rod) {
    D = ${name}_pair_scale(p->w[2], -e);
    D = ${name}_pair_multiply(${name}_pair_multiply(D, D), p->d32);
  } else {
    D = ${name}_pair_divide(D, p->I[2]);
  }
  p->kc2 = ${name}_pair_multiply(D, p->d31); /* over |I3 - I2| Lambda1, which ${name}_invariants knows */
}

/* amplitudes, rate and modulus: sums of terms of one sign */
static void ${name}_invariants(${name}_top *p)
{
  ${name}_pair w[3], square[3], Delta3, g, wide;
  int i;

  p->small12 = ${name}_exponent(p->w[0].hi, p->w[1].hi);
  for (i = 0; i < 3; i++) {
    w[i] = i < 2 ? ${name}_pair_scale(p->w[i], -p->small12) : p->w[i];
    square[i] = ${name}_pair_multiply(p->w[i], p->w[i]);
  }
  p->Lambda1 = ${name}_pair_multiply(p->rho, ${name}_pair_multiply(p->I[1], square[1]));
  p->Lambda1 = ${name}_pair_add(p->Lambda1, ${name}_pair_multiply(square[2], p->d31));
  Delta3 = ${name}_pair_multiply(${name}_pair_multiply(p->I[0], p->d31), ${name}_pair_multiply(w[0], w[0]));
  Delta3 = ${name}_pair_add(Delta3, ${name}_pair_multiply(${name}_pair_multiply(p->I[1], p->d32), ${name}_pair_multiply(w[1], w[1])));
  p->b[0] = ${name}_root_of(Delta3, ${name}_pair_multiply(p->I[0], p->d31));
  p->b[1] = ${name}_root_of(Delta3, ${name}_pair_multiply(p->I[1], p->d32));
  p->b[2] = ${name}_root_of(p->Lambda1, p->d31);
  wide = ${name}_pair_multiply(p->d32, p->Lambda1);
  p->lambda = ${name}_root_of(wide, ${name}_pair_multiply(p->I[0], p->I[1]));
  p->k2 = ${name}_pair_divide(${name}_pair_multiply(p->rho, Delta3), wide);
  p->kc2 = ${name}_pair_divide(p->kc2, wide);
  p->G = ${name}_pair_of(${zero});
  for (i = 0; i < 3; i++) {
    g = ${name}_pair_multiply(p->I[i], p->w[i]);
    p->G = ${name}_pair_add(p->G, ${name}_pair_multiply(g, g));
  }
  p->G = ${name}_pair_root(p->G);
}

/* The nome of modulus k from k^2 = m 2^power <= 0.51, k'^2 = mc: eps = (1 - sqrt k')/(2 (1 + sqrt k')),
 * q = eps + 2 eps^5 + 15 eps^9 + ... (DLMF 19.5.6, 22.20; integers: OEIS A002103), with 1 - sqrt k' = k^2 over two
 * factors.  Comes as a mantissa of the same power. */
static ${name}_pair ${name}_nome(${name}_pair m, ${name}_pair mc, int power)
{
  const ${name}_real series[9] = {${one}, (${name}_real)2, (${name}_real)15, (${name}_real)150, (${name}_real)1707, (${name}_real)20910, (${name}_real)268616,
                                  (${name}_real)3567400, (${name}_real)48555069};
  const ${name}_pair k = ${name}_pair_root(mc), root = ${name}_pair_root(k), first = ${name}_pair_add(${name}_pair_of(${one}), k);
  const ${name}_pair second = ${name}_pair_add(${name}_pair_of(${one}), root);
  const ${name}_pair eps = ${name}_pair_divide(${name}_pair_scale(m, -1), ${name}_pair_multiply(first, ${name}_pair_multiply(second, second)));
  const ${name}_pair e2 = ${name}_pair_scale(${name}_pair_multiply(eps, eps), 2*power), e4 = ${name}_pair_multiply(e2, e2);
  ${name}_pair sum = ${name}_pair_of(series[8]);
  int i;

  for (i = 7; i >= 0; i--) sum = ${name}_pair_add(${name}_pair_of(series[i]), ${name}_pair_multiply(sum, e4));
  return ${name}_pair_multiply(eps, sum);
}

static ${name}_pair ${name}_pi(void)
{
  const ${name}_pair pi = {${pi_high}, ${pi_low}};

  return pi;
}

static ${name}_pair ${name}_log2(void)
{
  const ${name}_pair log2 = {${log2_high}, ${log2_low}};

  return log2;
}

static void ${name}_store(${name}_real out[2], ${name}_pair a)
{
  out[0] = a.hi;
  out[1] = a.lo;
}

/* pi/2 theta3(0; q)^2 = K (DLMF 22.2.2), q <= 0.044 */
static ${name}_pair ${name}_complete(${name}_pair q)
{
  const ${name}_pair q2 = ${name}_pair_multiply(q, q), q3 = ${name}_pair_multiply(q2, q), q5 = ${name}_pair_multiply(q3, q2);
  ${name}_pair t = ${name}_pair_multiply(q5, ${name}_pair_add(${name}_pair_of(${one}), ${name}_pair_multiply(${name}_pair_multiply(q5, q2),
      ${name}_pair_add(${name}_pair_of(${one}), ${name}_pair_multiply(${name}_pair_multiply(q5, q3), q)))));

  t = ${name}_pair_multiply(q, ${name}_pair_add(${name}_pair_of(${one}), ${name}_pair_multiply(q3, ${name}_pair_add(${name}_pair_of(${one}), t))));
  t = ${name}_pair_add(${name}_pair_of(${one}), ${name}_pair_scale(t, 1));
  return ${name}_pair_scale(${name}_pair_multiply(${name}_pi(), ${name}_pair_multiply(t, t)), -1);
}

/* Both nomes from the smaller one, log q log q' = pi^2; hyperbolic from kappa = 1 on, where the two series converge alike */
static void ${name}_nomes(${name}_top *p)
{
  const ${name}_pair m = ${name}_pair_scale(p->k2, 2*p->small12), mc = ${name}_pair_scale(p->kc2, 2*p->small13);
  const ${name}_pair pi = ${name}_pi();

  p->hyperbolic = 0;
  if (m.hi <= ${half}) {
    p->q = ${name}_nome(p->k2, mc, 2*p->small12);
    p->K = ${name}_complete(${name}_pair_scale(p->q, 2*p->small12));
    return;
  }
  p->qc = ${name}_nome(p->kc2, m, 2*p->small13);
  p->hyperbolic = 1;
  p->log_qc = ${name}_pair_of(${zero});
  if (p->qc.hi > ${zero}) { /* else on the separatrix, to the last bit */
    p->log_qc = ${name}_pair_log(p->qc);
    p->log_qc = ${name}_pair_add(p->log_qc, ${name}_pair_times((${name}_real)(2*p->small13), ${name}_log2()));
    p->hyperbolic = p->log_qc.hi < -${two}*pi.hi;
  }
  p->qc = ${name}_pair_scale(p->qc, 2*p->small13);
  p->Kc = ${name}_complete(p->qc);
  if (!p->hyperbolic) {
    p->q = ${name}_pair_exp(${name}_pair_divide(${name}_pair_multiply(pi, pi), p->log_qc), -2*p->small12);
    p->K = ${name}_pair_divide(${name}_pair_multiply(p->Kc, p->log_qc), ${name}_pair_minus(pi));
  }
}

/* u0 from sn, cn, dn: F(phi, k^2) = sn R_F(cn^2, dn^2, 1) for |phi| <= pi/2 (DLMF 19.25.5) */
static ${name}_pair ${name}_argument(const ${name}_top *p)
{
  const ${name}_pair sn = ${name}_pair_times(p->s, ${name}_pair_divide(${name}_pair_scale(p->w[1], -p->small12), p->b[1]));
  const ${name}_pair cn = ${name}_pair_divide(${name}_pair_scale(p->w[0], -p->small12), p->b[0]);
  const ${name}_pair dn = ${name}_pair_divide(p->w[2], p->b[2]);

  return ${name}_pair_multiply(sn, ${name}_carlson(cn, dn, ${name}_pair_of(${one})));
}
