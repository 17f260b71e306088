%% -- gyrostat_solve.c -- the asymmetric gyrostat from its state at t = 0: part of scene.c.  SPDX-License-Identifier: MIT-0
int ${name}_solve(${name}_orbit *o, const ${name}_model *m, const ${name}_real x0[])
{
  static const int axis[3] = {${first}, ${second}, ${third}}; /* the axes here, in the body; the inertial ones go with them */
  ${name}_orbit made;
  ${name}_quartic p;
  ${name}_wide I[3], w[3], M[4], q[4], frame[4], back[4], t[4], G, h, kappa, zero = ${name}_wide_real(${zero});
  ${name}_real c[2][2], value[2][2];
  ${name}_values v;
  int e, sign[2], moves = 0;

%% if not uses_model then
  (void)m;
%% end
  for (int i = 0; i < ${upper}_NX; i++) {
    if (!(x0[i] - x0[i] == ${zero})) return 1;
  }
  I[0] = ${name}_wide_real(${I1});
  I[1] = ${name}_wide_real(${I2});
  I[2] = ${name}_wide_real(${I3});
  q[0] = ${name}_wide_real(x0[${upper}_QW]);
  M[0] = zero;
  for (int i = 0; i < 3; i++) {
    if (${name}_wide_sign(I[i]) <= 0) return 1;
    q[i + 1] = ${name}_wide_real(x0[${upper}_QX + axis[i]]);
    w[i] = ${name}_wide_real(x0[${upper}_WX + axis[i]]);
    M[i + 1] = ${name}_wide_mul(I[i], w[i]);
  }
  if (!${name}_wide_sign(${name}_wide_unit(4, q))) return 1;
  h = ${name}_wide_real(${hr});
  M[3] = ${name}_wide_add(M[3], h);

  /* q = frame t, t from the body's axes to z along M: with all digits of M across the axis */
  ${name}_upright(M + 1, back);
  ${name}_wide_product(q, back, frame);
  (void)${name}_wide_unit(4, frame);
  for (int i = 0; i < 4; i++) t[i] = i > 0 ? ${name}_wide_minus(back[i]) : back[i];
  G = ${name}_wide_unit(3, M + 1);
  ${name}_copy(&made, 0, (unsigned int)sizeof(made));
  e = ${least_exponent}; /* seconds of a power of two */
  for (int i = 0; i < 3; i++) {
    p.A[i] = ${name}_wide_ratio(G, I[i]);
    if (${name}_wide_size(p.A[i]) > e) e = p.A[i].e;
    if (${name}_wide_size(w[i]) > e) e = w[i].e;
  }
  if (e == ${least_exponent}) e = 0;
  if (${name}_wide_sign(G)) {
    const ${name}_wide other = ${name}_wide_ratio(h, I[2]);
    const ${name}_wide across = ${name}_wide_dot(p.A[0], ${name}_wide_square(M[1]), p.A[1], ${name}_wide_square(M[2]));

    p.g = ${name}_wide_ratio(h, G);
    p.v[0] = ${name}_wide_scale(${name}_wide_dot(t[0], t[0], t[3], t[3]), 1);
    p.v[1] = ${name}_wide_scale(${name}_wide_dot(t[1], t[1], t[2], t[2]), 1);
    p.u = ${name}_wide_scale(${name}_wide_sub(p.v[0], p.v[1]), -1);
    /* e - A3 (1 +- g)^2 */
    for (int i = 0; i < 2; i++) {
      const ${name}_wide twice = ${name}_wide_scale(i == 0 ? other : ${name}_wide_minus(other), 1);
      const ${name}_wide less = ${name}_wide_add(${name}_wide_mul(p.A[2], p.v[1 - i]), twice);

      p.E[i] = ${name}_wide_sub(across, ${name}_wide_mul(p.v[i], less));
    }
    /* A2 u - w3 and w3 - A1 u, A2 - A3 and A3 - A1, A1 - A2 from differences of moments */
    for (int i = 0; i < 2; i++) {
      const ${name}_wide less = ${name}_wide_sub(I[2], I[1 - i]), b = ${name}_wide_add(${name}_wide_mul(less, w[2]), h);
      const ${name}_wide d = ${name}_wide_ratio(${name}_wide_mul(less, G), ${name}_wide_mul(I[2], I[1 - i]));

      p.b[i] = ${name}_wide_scale(${name}_wide_ratio(i == 0 ? b : ${name}_wide_minus(b), I[1 - i]), 1);
      p.d[i] = i == 0 ? d : ${name}_wide_minus(d);
    }
    kappa = ${name}_wide_ratio(${name}_wide_mul(${name}_wide_sub(I[1], I[0]), G), ${name}_wide_mul(I[0], I[1]));
    moves = ${name}_band(&p, M[1], M[2], kappa);
  }
  if (moves) {
    ${name}_set_series(&made, &p, e, sign);
  } else { /* w is constant: about M, or without M about the rotor's axis */
    const ${name}_wide along = ${name}_wide_add(${name}_wide_dot(w[0], M[1], w[1], M[2]), ${name}_wide_mul(w[2], M[3]));
    const ${name}_wide omega = ${name}_wide_sign(G) ? along : w[2];
    ${name}_pair turn = ${name}_ratio(${name}_wide_pair(${name}_wide_scale(omega, -1), e), ${name}_pair_scale(${name}_pair_pi, 1));

    ${name}_store(made.turn[0], turn);
    ${name}_store(made.turn[1], ${name}_wide_sign(G) ? turn : ${name}_minus(turn));
    made.period[0] = made.inverse = ${one};
    for (int i = 0; i < 2; i++) {
      const ${name}_wide re = t[i], im = t[3 - i], size = ${name}_wide_root(${name}_wide_dot(re, re, im, im));

      made.re[i][0] = ${name}_wide_pair(size, 0).hi;
    }
    sign[0] = sign[1] = 0;
  }
  for (int i = 0; i < 2; i++) {
    for (int k = 0; k < 2; k++) made.turn[i][k] = ${ldexp}(made.turn[i][k], e);
    made.rate[i] = ${ldexp}(made.rate[i], e);
    if (!(made.rate[i] - made.rate[i] == ${zero}) || !(made.turn[i][0] - made.turn[i][0] == ${zero})) return 1;
  }
  made.mean = ${name}_mean_of(&made, sign);

  /* what turns the series' a and b to those of t = 0 */
  v = ${name}_values_at(&made, ${zero});
  value[0][0] = v.w;
  value[0][1] = v.z;
  value[1][0] = v.x;
  value[1][1] = v.y;
  for (int i = 0; i < 2; i++) {
    const ${name}_wide re = t[i], im = t[3 - i];
    const int top = ${name}_wide_size(re) > ${name}_wide_size(im) ? ${name}_wide_size(re) : ${name}_wide_size(im);
    const ${name}_real s[2] = {${name}_wide_pair(re, top).hi, ${name}_wide_pair(im, top).hi};

    ${name}_between(s, value[i], c[i]);
  }
  for (int k = 0; k < 4; k++) { /* y = re a, re b, im b, im a: q = frame (c_a a, c_b b) */
    const ${name}_real *turn = c[k == 0 || k == 3 ? 0 : 1];
    const int imaginary = k > 1;
    const ${name}_real re = imaginary ? -turn[1] : turn[0], im = imaginary ? turn[0] : turn[1];
    ${name}_real F[4], u[4] = {${zero}, ${zero}, ${zero}, ${zero}}, d[4];

    for (int i = 0; i < 4; i++) F[i] = ${name}_wide_pair(frame[i], 0).hi;
    u[k == 0 || k == 3 ? 0 : 1] = re;
    u[k == 0 || k == 3 ? 3 : 2] = im;
    ${name}_quaternion_product(F, u, d);
    made.q[k][0] = d[0];
    for (int i = 0; i < 3; i++) made.q[k][axis[i] + 1] = d[i + 1];
  }
  { /* w1 = A1 Re, w2 = A2 Im of 2 i conj(c_a) c_b (f + i g); w3 = A3 ((1 - g)|a|^2 - (1 + g)|b|^2) */
    const ${name}_real re = c[0][0]*c[1][0] + c[0][1]*c[1][1], im = c[0][0]*c[1][1] - c[0][1]*c[1][0];
    const ${name}_real A1 = ${two}*${name}_wide_round(p.A[0]), A2 = ${two}*${name}_wide_round(p.A[1]);

    made.across[0][axis[0]] = -A1*im;
    made.across[1][axis[0]] = -A1*re;
    made.across[0][axis[1]] = A2*re;
    made.across[1][axis[1]] = -A2*im;
    made.along[0][axis[2]] = made.along[1][axis[2]] = ${name}_wide_round(w[2]);
    if (${name}_wide_sign(G)) {
      const ${name}_wide one = ${name}_wide_real(${one}), less = ${name}_wide_sub(one, p.g), more = ${name}_wide_add(one, p.g);

      made.along[0][axis[2]] = ${name}_wide_round(${name}_wide_mul(p.A[2], less));
      made.along[1][axis[2]] = -${name}_wide_round(${name}_wide_mul(p.A[2], more));
    }
  }
  if (!${name}_starts(&made)) return 1;
  ${name}_copy(o, &made, (unsigned int)sizeof(made));
  return 0;
}
