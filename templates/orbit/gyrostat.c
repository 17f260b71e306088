%% -- gyrostat.c -- the asymmetric gyrostat: its quartic and the invariants of it: part of scene.c.  SPDX-License-Identifier: MIT-0
/* ---- closed form: ${theorem} ----
 *
 * Axes here: 3 the rotor's, moments I1, I2, I3; inertial z along M = I w + h e3, |M| = G; a = w + i z and b = x + i y of the
 * quaternion from these to those.  u = M3/G = |a|^2 - |b|^2, (M1 + i M2)/G = 2 i conj(a) b, A = G/I, g = h/G (Volterra
 * 1899, Acta Math. 22, 201; Wittenburg, Dynamics of Multibody Systems):
 *     u'^2 = P1(u) P2(u),  Pi = (A1 - A2) (Mi/G)^2,  P1 + P2 = (A1 - A2)(1 - u^2),
 *     P1 = e - A3 (u - g)^2 - A2 (1 - u^2),  e constant,
 * so that P1 P2 <= 0 at u = -1 and 1, where a and b vanish.  Between adjacent roots of P1 P2 = X Y R(u), X and Y the distances
 * to them (0 at O and F), w = X + Y,  w^2 R = RO Y^2 + 2 B X Y + RF X^2.  With Gamma^2 = RO RF, lambda^2 = RF/RO,
 *     (1 + c)/(1 - c) = lambda X/Y:  c = sn(nu t, m),  m = (B - Gamma)/(B + Gamma) < 1,  nu^2 = (B + Gamma)/2:
 * four real roots have m > 0, two have m < 0, and nothing happens between.  O is the end with the larger R, F the slow one
 * near a separatrix.  sn has the periods 4 K, 2 i K' (m < 0: 4 K and half their sum), |a|^2 and |b|^2 have one zero each in
 * the gap beyond O or that beyond F, which for m < 0 are one, so with z = 0 at O, pi/2 at F
 *     a, b = exp(i mu t) theta1(z - i eta) or exp(i mu t) theta2(z - i eta), all but for one factor,
 * of the nome squared, which is that of m, signed as m.  eta is an integral to the zero (DLMF 19.29), mu the rest of the
 * rate of its phase, known at both ends, where one of M1, M2 is 0:  (+-w3 + Ai (1 -+ u))/2. */

typedef struct ${name}_quartic {
  ${name}_wide A[3], u, g, v[2];           /* v: 1 + u, 1 - u */
  ${name}_wide c[2], b[2], d[2];           /* P1, P2 = c + b n + d n^2 at u + n, times the sign of A1 - A2 */
  ${name}_wide edge[2][2];                 /* 1 + u, 1 - u at the roots */
  ${name}_wide end[2];                     /* the roots n <= 0 <= n on either side */
  ${name}_wide E[2];                       /* P1 at u = -1, 1 */
  ${name}_wide width, RO, B, gamma, lambda, sum, m; /* sum = B + Gamma */
  ${name}_wide X, Y, R;                    /* at t = 0 */
  int of[2], origin, away;               /* whose roots; which is O; 1: away from O */
} ${name}_quartic;

/* the nearest root on either side of 0 of c + b n + d n^2, c >= 0, taken if it is nearer than end[] */
static void ${name}_nearest_roots(${name}_quartic *p, int i)
{
  const ${name}_wide c = p->c[i], b = p->b[i], d = p->d[i];
  const ${name}_wide disc = ${name}_wide_sub(${name}_wide_square(b), ${name}_wide_scale(${name}_wide_mul(c, d), 2));
  ${name}_wide q, n[2];
  int side, count = 0;

  if (${name}_wide_sign(disc) < 0) return;
  q = ${name}_wide_root(disc);
  q = ${name}_wide_scale(${name}_wide_sign(b) < 0 ? ${name}_wide_sub(q, b) : ${name}_wide_minus(${name}_wide_add(q, b)), -1);
  if (${name}_wide_sign(d)) n[count++] = ${name}_wide_ratio(q, d);
  if (${name}_wide_sign(q)) n[count++] = ${name}_wide_ratio(c, q);
  for (int k = 0; k < count; k++) {
    side = ${name}_wide_sign(n[k]);
    if (!side) side = ${name}_wide_sign(b) > 0 ? -1 : ${name}_wide_sign(b) < 0 ? 1 : 0;
    if (side <= 0 && (p->of[0] < 0 || ${name}_wide_sign(${name}_wide_sub(n[k], p->end[0])) > 0)) {
      p->end[0] = n[k];
      p->of[0] = i;
    }
    if (side >= 0 && (p->of[1] < 0 || ${name}_wide_sign(${name}_wide_sub(n[k], p->end[1])) < 0)) {
      p->end[1] = n[k];
      p->of[1] = i;
    }
  }
}

static ${name}_wide ${name}_positive(${name}_wide x)
{
  return ${name}_wide_sign(x) > 0 ? x : ${name}_wide_real(${zero});
}

/* c + b n + d n^2 */
static ${name}_wide ${name}_parabola(${name}_wide c, ${name}_wide b, ${name}_wide d, ${name}_wide n)
{
  return ${name}_wide_add(c, ${name}_wide_mul(n, ${name}_wide_add(b, ${name}_wide_mul(d, n))));
}

/* The ends of the band and what R is there; 0 if nothing moves.  u1, u2 = M1/G, M2/G; kappa = A1 - A2. */
static int ${name}_band(${name}_quartic *p, ${name}_wide u1, ${name}_wide u2, ${name}_wide kappa)
{
  const ${name}_wide zero = ${name}_wide_real(${zero});
  ${name}_wide r[3], disc, R[2], speed;
  int i, j;

  speed = ${name}_wide_minus(${name}_wide_mul(kappa, ${name}_wide_mul(u1, u2)));
  if (!${name}_wide_sign(speed) && !${name}_wide_sign(${name}_wide_mul(u2, p->b[0]))
      && !${name}_wide_sign(${name}_wide_mul(u1, p->b[1]))) return 0;
  p->c[0] = ${name}_wide_mul(kappa, ${name}_wide_square(u1));
  p->c[1] = ${name}_wide_mul(kappa, ${name}_wide_square(u2));
  for (i = 0; i < 2 && ${name}_wide_sign(kappa) < 0; i++) {
    p->c[i] = ${name}_wide_minus(p->c[i]);
    p->b[i] = ${name}_wide_minus(p->b[i]);
    p->d[i] = ${name}_wide_minus(p->d[i]);
  }
  p->of[0] = p->of[1] = -1;
  p->end[0] = p->end[1] = zero;
  ${name}_nearest_roots(p, 0);
  ${name}_nearest_roots(p, 1);
  if (p->of[0] < 0 || p->of[1] < 0) return 0;
  p->width = ${name}_wide_sub(p->end[1], p->end[0]);
  for (int k = 0; k < 2; k++) { /* the smaller one from P1 + P2, so that it is 0 with the other P */
    ${name}_wide *v = p->edge[k], value;

    j = 1 - p->of[k];
    v[0] = ${name}_positive(${name}_wide_add(p->v[0], p->end[k]));
    v[1] = ${name}_positive(${name}_wide_sub(p->v[1], p->end[k]));
    i = ${name}_wide_sign(${name}_wide_sub(v[1], v[0])) < 0;
    value = ${name}_positive(${name}_parabola(p->c[j], p->b[j], p->d[j], p->end[k]));
    if (${name}_wide_sign(kappa)) {
      const ${name}_wide size = ${name}_wide_sign(kappa) < 0 ? ${name}_wide_minus(kappa) : kappa;

      v[i] = ${name}_wide_ratio(value, ${name}_wide_mul(size, v[1 - i]));
    }
  }
  i = p->of[0];
  j = p->of[1];
  if (i == j) { /* R = -d times the other parabola */
    const ${name}_wide f = ${name}_wide_minus(p->d[i]);

    j = 1 - i;
    r[0] = ${name}_wide_mul(f, p->c[j]);
    r[1] = ${name}_wide_mul(f, p->b[j]);
    r[2] = ${name}_wide_mul(f, p->d[j]);
    disc = ${name}_wide_sub(${name}_wide_square(p->b[j]), ${name}_wide_scale(${name}_wide_mul(p->c[j], p->d[j]), 2));
    disc = ${name}_wide_mul(${name}_wide_square(f), disc);
    for (int k = 0; k < 2; k++) {
      R[k] = ${name}_wide_mul(f, ${name}_positive(${name}_parabola(p->c[j], p->b[j], p->d[j], p->end[k])));
    }
  } else { /* of each one factor is left */
    const ${name}_wide e = ${name}_wide_add(p->b[i], ${name}_wide_mul(p->d[i], p->end[0]));
    const ${name}_wide f = ${name}_wide_add(p->b[j], ${name}_wide_mul(p->d[j], p->end[1]));

    /* c = -n (b + d n) */
    r[0] = ${name}_wide_sign(p->end[0]) ? ${name}_wide_minus(${name}_wide_ratio(p->c[i], p->end[0])) : e;
    r[1] = ${name}_wide_sign(p->end[1]) ? ${name}_wide_ratio(p->c[j], p->end[1]) : ${name}_wide_minus(f);
    r[0] = ${name}_wide_mul(r[0], r[1]);
    r[1] = ${name}_wide_minus(${name}_wide_dot(p->d[i], f, p->d[j], e));
    r[2] = ${name}_wide_minus(${name}_wide_mul(p->d[i], p->d[j]));
    disc = ${name}_wide_square(${name}_wide_sub(${name}_wide_mul(p->d[i], f), ${name}_wide_mul(p->d[j], e)));
    for (int k = 0; k < 2; k++) { /* at its own end a factor is the slope; at the other the value over the width */
      const int own = p->of[k], other = p->of[1 - k];
      const ${name}_wide n = p->end[k], slope = ${name}_wide_add(p->b[own], ${name}_wide_scale(${name}_wide_mul(p->d[own], n), 1));

      R[k] = ${name}_positive(k == 0 ? slope : ${name}_wide_minus(slope));
      if (${name}_wide_sign(p->width)) {
        const ${name}_wide value = ${name}_parabola(p->c[other], p->b[other], p->d[other], n);

        R[k] = ${name}_wide_mul(R[k], ${name}_wide_ratio(${name}_positive(value), p->width));
      } else {
        R[k] = ${name}_wide_square(R[k]);
      }
    }
  }
  p->origin = ${name}_wide_sign(${name}_wide_sub(R[0], R[1])) >= 0 ? 0 : 1;
  p->RO = R[p->origin];
  if (!${name}_wide_sign(p->RO)) return 0;
  p->lambda = ${name}_wide_root(${name}_wide_ratio(R[1 - p->origin], p->RO));
  p->gamma = ${name}_wide_mul(p->lambda, p->RO);
  p->B = ${name}_wide_add(r[0], ${name}_wide_mul(r[1], ${name}_wide_scale(${name}_wide_add(p->end[0], p->end[1]), -1)));
  p->B = ${name}_wide_add(p->B, ${name}_wide_mul(r[2], ${name}_wide_mul(p->end[0], p->end[1])));
  disc = ${name}_wide_scale(${name}_wide_mul(${name}_wide_square(p->width), disc), -2); /* B^2 - Gamma^2 */
  if (${name}_wide_sign(p->B) >= 0) p->sum = ${name}_wide_add(p->B, p->gamma);
  else p->sum = ${name}_positive(${name}_wide_ratio(${name}_wide_minus(disc), ${name}_wide_sub(p->gamma, p->B)));
  p->m = ${name}_wide_sign(p->sum) ? ${name}_wide_ratio(disc, ${name}_wide_square(p->sum)) : zero;
  p->R = r[0];
  p->X = p->origin ? p->end[1] : ${name}_wide_minus(p->end[0]);
  p->Y = p->origin ? ${name}_wide_minus(p->end[0]) : p->end[1];
  p->away = (${name}_wide_sign(speed) < 0) == p->origin || !${name}_wide_sign(speed);
  return 1;
}
