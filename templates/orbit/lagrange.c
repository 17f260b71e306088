%% -- lagrange.c -- the heavy symmetric top: its constants and the roots of its cubic: part of scene.c.  SPDX-License-Identifier: MIT-0
/* ---- closed form: ${theorem} ----
 *
 * Axes here: 3 the symmetry axis, pointing to the centre of mass, moments A, A, C; inertial z up; a = w + i z and b = x + i y
 * of the quaternion from these to those.  With c = m g l/A, s = C w3/A, l = Lz/A, u = cos(tilt) = |a|^2 - |b|^2 and the
 * spin (1 - C/A) w3 taken off (Whittaker, Analytical Dynamics, sections 71-73; Klein, Sommerfeld, Theorie des Kreisels 4),
 *     a' = i s a/2 - b conj(W)/2,   b' = -i s b/2 + a W/2,   W' = 2 c conj(a) b,   W = w1 + i w2,
 *     u'^2 = P(u) = 2 c (u - u1)(u - u2)(u - u3) = 2 (1 - u^2)(h - c u) - (l - s u)^2,   h = |W|^2/2 + c u,
 * and -1 <= u1 <= u <= u2 <= 1 <= u3.  Each of X = a, b, W exp(i s t/2) solves Lame's equation X'' = (c u - const) X, and
 * |X|^2 is linear in u with a zero at -1, 1, h/c, where P = -(l + s)^2, -(l - s)^2, -(l - s h/c)^2.  Hence, with
 * z = pi v/(2 K), v' = nu, u = u1 + (u2 - u1) sn^2 v, nu^2 = c (u3 - u1)/2, k^2 = (u2 - u1)/(u3 - u1),
 *     a = exp(i mu t) theta1(z - i eta)/theta4(z),   b and W likewise with theta2 and mu, eta of their own,
 * |eta| = pi tau/(2 K), where sn^2(i tau) or sn^2(K + i tau) is (zero - u1)/(u2 - u1). */

/* What is known of the motion: wide numbers.  Differences of roots are formed without cancellation. */
typedef struct ${name}_cubic {
  ${name}_wide a[2], b[2], W[2];    /* a, b, W at t = 0: real and imaginary part */
  ${name}_wide s, c, w3;
  ${name}_wide above[2], below[2];  /* 1 + u1, 1 + u2; 1 - u1, 1 - u2 */
  ${name}_wide far[2];              /* 2 c (u3 - 1), 2 c (u3 + 1) */
  ${name}_wide rate[3];             /* |W|^2 at u1 and u2; 2 (c u3 - h) */
  ${name}_wide span, gap, whole;    /* u2 - u1; 2 c (u3 - u2), 2 c (u3 - u1) */
  ${name}_wide sn2, cn2, dn2;       /* at t = 0 */
  int sign[3], rising, winding;     /* of l + s, l - s, s h - c l; of u' at t = 0; see lagrange_theta.c */
} ${name}_cubic;

/* half of an exponent, rounded up */
static int ${name}_half_up(int e)
{
  return e >= 0 ? (e + 1)/2 : e/2;
}

/* u0 - u1 = n, the one positive root of p0 - p1 n + p2 n^2 - p3 n^3; p0, p3 >= 0.  Bounds on the roots by powers of two
 * (Fujiwara 1916), Newton's method from above, which is monotone, then three steps in pairs. */
static ${name}_wide ${name}_descent(${name}_wide p0, ${name}_wide p1, ${name}_wide p2, ${name}_wide p3)
{
  const int e0 = ${name}_wide_size(p0), e1 = ${name}_wide_size(p1), e2 = ${name}_wide_size(p2), e3 = ${name}_wide_size(p3);
  const int down = ${name}_wide_sign(p1) < 0 ? e1 : ${no_exponent}, none = ${least_exponent};
  ${name}_pair c[4], n, f;
  ${name}_real x = ${sixteen}, slope, next;
  int j, k, top;

  j = ${name}_half_up(down - e3);
  k = (e0 - e3)/3 + 1;
  if (k > j) j = k;
  if (${name}_wide_sign(p2) > 0) {
    if (e2 - e3 > j) j = e2 - e3;
  } else { /* then each of the terms in n, n^2, n^3 alone gives a bound */
    k = ${name}_half_up(e0 - e2);
    if (down - e2 > k) k = down - e2;
    if (!${name}_wide_sign(p3) || (${name}_wide_sign(p2) && k < j)) j = k;
    if (${name}_wide_sign(p1) > 0 && e0 - e1 < j) j = e0 - e1;
  }
  if (j < none) return ${name}_wide_real(${zero});
  top = e0;
  if (e1 + j > top) top = e1 + j;
  if (e2 + 2*j > top) top = e2 + 2*j;
  if (e3 + 3*j > top) top = e3 + 3*j;
  c[0] = ${name}_wide_pair(p0, top);
  c[1] = ${name}_wide_pair(p1, top - j);
  c[2] = ${name}_wide_pair(p2, top - 2*j);
  c[3] = ${name}_wide_pair(p3, top - 3*j);
  for (int i = 0; i < 100; i++) { /* some 8 times */
    slope = (${two}*c[2].hi - ${three}*c[3].hi*x)*x - c[1].hi;
    if (!(slope < ${zero})) break;
    next = x - (((c[2].hi - c[3].hi*x)*x - c[1].hi)*x + c[0].hi)/slope;
    if (!(next < x)) break;
    x = next;
  }
  n = ${name}_pair_of(x);
  for (int i = 0; i < 3; i++) {
    slope = (${two}*c[2].hi - ${three}*c[3].hi*n.hi)*n.hi - c[1].hi;
    if (!(slope < ${zero})) break;
    f = ${name}_sub(c[2], ${name}_mul(c[3], n));
    f = ${name}_sub(${name}_mul(f, n), c[1]);
    f = ${name}_add(${name}_mul(f, n), c[0]);
    n = ${name}_sub(n, ${name}_pair_of(f.hi/slope));
  }
  return n.hi > ${zero} ? ${name}_wide_of(n, j) : ${name}_wide_real(${zero});
}

/* The roots from the state.  P(u0 + y) = p0 + p1 y + p2 y^2 + 2 c y^3 has the roots -n <= 0 <= y2 <= y3, and
 * P(1 - x) = -d^2 + c1 x + .. - 2 c x^3 the roots x3 <= 0 <= x2 <= x1 = 1 - u1 = 1 - u0 + n; d = l - s. */
static void ${name}_roots(${name}_cubic *p)
{
  const ${name}_wide s = p->s, c = p->c, zero = ${name}_wide_real(${zero});
  const ${name}_wide a2 = ${name}_wide_dot(p->a[0], p->a[0], p->a[1], p->a[1]);
  const ${name}_wide b2 = ${name}_wide_dot(p->b[0], p->b[0], p->b[1], p->b[1]);
  const ${name}_wide W2 = ${name}_wide_dot(p->W[0], p->W[0], p->W[1], p->W[1]);
  const ${name}_wide re = ${name}_wide_dot(p->a[0], p->b[0], p->a[1], p->b[1]); /* conj(a) b */
  const ${name}_wide im = ${name}_wide_sub(${name}_wide_mul(p->a[0], p->b[1]), ${name}_wide_mul(p->a[1], p->b[0]));
  const ${name}_wide up = ${name}_wide_scale(${name}_wide_minus(${name}_wide_dot(re, p->W[0], im, p->W[1])), 1); /* u' */
  const ${name}_wide half_m = ${name}_wide_sub(${name}_wide_mul(re, p->W[1]), ${name}_wide_mul(im, p->W[0]));
  const ${name}_wide m = ${name}_wide_scale(half_m, 1), u0 = ${name}_wide_sub(a2, b2); /* m = l - s u0 */
  const ${name}_wide d = ${name}_wide_sub(m, ${name}_wide_scale(${name}_wide_mul(s, b2), 1)); /* l - s */
  const ${name}_wide up_d = ${name}_wide_add(m, ${name}_wide_scale(${name}_wide_mul(s, a2), 1)); /* l + s */
  const ${name}_wide c2 = ${name}_wide_scale(c, 1);
  const ${name}_wide e = ${name}_wide_sub(${name}_wide_scale(W2, -1), ${name}_wide_mul(c2, b2)); /* h - c */
  const ${name}_wide w = ${name}_wide_sub(${name}_wide_scale(${name}_wide_mul(s, W2), -1), ${name}_wide_mul(c, m)); /* s h - c l */
  const ${name}_wide half_p1 = ${name}_wide_sub(${name}_wide_mul(s, m), ${name}_wide_dot(u0, W2, ${name}_wide_scale(c, 2), ${name}_wide_mul(a2, b2)));
  const ${name}_wide p0 = ${name}_wide_square(up), p1 = ${name}_wide_scale(half_p1, 1);
  const ${name}_wide p2 = ${name}_wide_sub(${name}_wide_mul(${name}_wide_scale(c, 2), u0), ${name}_wide_add(W2, ${name}_wide_square(s)));
  const ${name}_wide n = ${name}_descent(p0, p1, p2, c2), x1 = ${name}_wide_add(${name}_wide_scale(b2, 1), n);

  /* 2 c x^2 - r x - q = 0 for x2 and x3 */
  const ${name}_wide q = ${name}_wide_ratio(${name}_wide_square(d), x1);
  const ${name}_wide c1 = ${name}_wide_sub(${name}_wide_scale(e, 2), ${name}_wide_scale(${name}_wide_mul(d, s), 1));
  const ${name}_wide r = ${name}_wide_ratio(${name}_wide_sub(q, c1), x1);
  ${name}_wide sum = ${name}_wide_root(${name}_wide_add(${name}_wide_square(r), ${name}_wide_scale(${name}_wide_mul(c, q), 3)));
  p->below[0] = x1;
  if (${name}_wide_sign(r) > 0 && ${name}_wide_sign(c)) {
    p->below[1] = ${name}_wide_ratio(${name}_wide_add(sum, r), ${name}_wide_scale(c, 2));
    p->far[0] = ${name}_wide_ratio(q, p->below[1]);
  } else {
    p->far[0] = ${name}_wide_scale(${name}_wide_sub(sum, r), -1);
    p->below[1] = ${name}_wide_sign(p->far[0]) ? ${name}_wide_ratio(q, p->far[0]) : zero;
  }
  p->far[1] = ${name}_wide_add(p->far[0], ${name}_wide_scale(c, 2));

  /* -y1 y2 = p0/(2 c y3), y1 + y2 = (p1 - 2 c y1 y2)/(2 c y3) */
  const ${name}_wide y3 = ${name}_wide_add(p->far[0], ${name}_wide_scale(${name}_wide_mul(c, b2), 2));
  ${name}_wide product = ${name}_wide_ratio(p0, y3);
  sum = ${name}_wide_ratio(${name}_wide_add(p1, ${name}_wide_mul(c2, product)), y3);
  ${name}_wide y2 = ${name}_wide_sign(sum) >= 0 || !${name}_wide_sign(n) ? ${name}_wide_add(sum, n) : ${name}_wide_ratio(product, n);
  if (${name}_wide_sign(y2) < 0) y2 = zero;
  p->span = ${name}_wide_add(n, y2);
  p->gap = ${name}_wide_add(p->far[0], ${name}_wide_mul(c2, p->below[1]));
  p->whole = ${name}_wide_add(p->far[0], ${name}_wide_mul(c2, x1));
  p->above[1] = ${name}_wide_add(${name}_wide_scale(a2, 1), y2);
  p->above[0] = ${name}_wide_ratio(${name}_wide_square(up_d), ${name}_wide_mul(p->above[1], p->far[1]));
  p->sn2 = p->cn2 = zero;
  if (${name}_wide_sign(p->span)) {
    p->sn2 = ${name}_wide_ratio(n, p->span);
    p->cn2 = ${name}_wide_ratio(y2, p->span);
  }
  p->dn2 = ${name}_wide_ratio(y3, p->whole);

  /* |W|^2 = 2 (h - c u); at u2 and u3 the product and the difference are known */
  p->rate[0] = ${name}_wide_add(W2, ${name}_wide_mul(c2, n));
  product = ${name}_wide_ratio(${name}_wide_scale(${name}_wide_square(w), 2), p->rate[0]);
  sum = ${name}_wide_sub(${name}_wide_sub(p->far[0], ${name}_wide_mul(c2, p->below[1])), ${name}_wide_scale(e, 2));
  const int low = ${name}_wide_sign(sum) >= 0;
  if (!low) sum = ${name}_wide_minus(sum);
  sum = ${name}_wide_scale(${name}_wide_add(p->gap, sum), -1);
  p->rate[low ? 2 : 1] = sum;
  p->rate[low ? 1 : 2] = ${name}_wide_sign(sum) ? ${name}_wide_ratio(product, sum) : zero;
  p->sign[0] = ${name}_wide_sign(up_d) < 0 ? -1 : 1;
  p->sign[1] = ${name}_wide_sign(d) < 0 ? -1 : 1;
  p->sign[2] = ${name}_wide_sign(w) < 0 ? -1 : 1;
  p->rising = ${name}_wide_sign(up) < 0 ? -1 : 1;
  p->winding = ${name}_wide_sign(e) > 0 ? -p->sign[2] : p->sign[1];
}
