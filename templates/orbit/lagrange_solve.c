%% -- lagrange_solve.c -- the heavy top from its state at t = 0: part of scene.c.  SPDX-License-Identifier: MIT-0
/* the half angle of sin^2 = x/2, cos^2 = y/2, doubled: asin s = s R_F(c^2, 1, 1) (DLMF 19.25.7) */
static ${name}_real ${name}_angle_of(${name}_wide x, ${name}_wide y)
{
  const ${name}_pair one = ${name}_pair_of(${one});
  const ${name}_pair s = ${name}_wide_pair(${name}_wide_root(${name}_wide_scale(x, -1)), 0);
  const ${name}_pair c = ${name}_wide_pair(${name}_wide_root(${name}_wide_scale(y, -1)), 0);

  return ${two}*${name}_mul(s, ${name}_carlson(c, one, one)).hi;
}

/* The series of all but the phases at t = 0. */
static void ${name}_set_series(${name}_orbit *o, const ${name}_cubic *p, ${name}_pair mu[2])
{
  const ${name}_wide k2 = ${name}_wide_ratio(${name}_wide_mul(${name}_wide_scale(p->c, 1), p->span), p->whole);
  const ${name}_wide kc2 = ${name}_wide_ratio(p->gap, p->whole);
  const int power = k2.e + (k2.e & 1), powerc = kc2.e + (kc2.e & 1);
  const ${name}_pair m = ${name}_wide_pair(k2, 0), mc = ${name}_wide_pair(kc2, 0), one = ${name}_pair_of(${one});
  ${name}_pair root, v, nu, q;
  ${name}_real amplitude[3];
  int e = p->whole.e + (p->whole.e & 1);

  root = ${name}_pair_root(${name}_wide_pair(p->whole, e)); /* 2 nu = sqrt(whole) */
  nu = ${name}_pair_scale(root, e/2 - 1);
  amplitude[0] = ${name}_wide_round(${name}_wide_root(${name}_wide_scale(p->above[1], -1)));
  amplitude[1] = ${name}_wide_round(${name}_wide_root(${name}_wide_scale(p->below[0], -1)));
  amplitude[2] = ${name}_wide_round(${name}_wide_root(p->rate[0]));

  /* v0 = sn R_F(cn^2, dn^2, 1) for |v0| <= K (DLMF 19.25.5) */
  v = ${name}_wide_pair(${name}_wide_root(p->sn2), 0);
  v = ${name}_mul(v, ${name}_carlson(${name}_wide_pair(${name}_wide_root(p->cn2), 0), ${name}_wide_pair(${name}_wide_root(p->dn2), 0), one));
  if (p->rising < 0) v = ${name}_minus(v);
  if (m.hi <= ${half}) {
    q = ${name}_nome_of(${name}_wide_pair(k2, power), mc, power);
    q = ${name}_pair_scale(q, power);
    ${name}_set_circular(o, p, amplitude, q, ${name}_complete(q), nu, v, mu);
  } else {
    ${name}_pair logq = ${name}_pair_of(${zero});

    q = ${name}_nome_of(${name}_wide_pair(kc2, powerc), m, powerc);
    o->nome = ${ldexp}(${name}_pair_root(q).hi, powerc/2);
    if (q.hi > ${zero}) logq = ${name}_pair_log(q, powerc);
    q = ${name}_pair_scale(q, powerc);
    ${name}_set_hyperbolic(o, p, amplitude, q, logq, ${name}_complete(q), nu, v, mu);
  }
}
/* p q, of complex numbers */
static void ${name}_complex(const ${name}_real p[2], const ${name}_real q[2], ${name}_real out[2])
{
  const ${name}_real re = p[0]*q[0] - p[1]*q[1];

  out[1] = p[0]*q[1] + p[1]*q[0];
  out[0] = re;
}

int ${name}_solve(${name}_orbit *o, const ${name}_model *m, const ${name}_real x0[])
{
  ${name}_orbit made;
  ${name}_cubic p;
  ${name}_wide body[4], frame[4], q[4], w[4], t[4], back[4], v[3], I1, I3;
  const ${name}_wide zero = ${name}_wide_real(${zero});
  ${name}_pair mu[2], spin, turn;
  ${name}_values v0;
  ${name}_real weight, value[3][2], c[4][2], n, least;
  int i, e, rest, drop;

%% if not uses_model then
  (void)m;
%% end
  for (i = 0; i < ${upper}_NX; i++) {
    if (!(x0[i] - x0[i] == ${zero})) return 1;
  }
  I1 = ${name}_wide_real(${I1});
  I3 = ${name}_wide_real(${I3});
  if (${name}_wide_sign(I1) <= 0) return 1;

  /* frames: `body` from the axes here to the body's, `frame` to inertial ones */
  weight = ${Mgk};
  v[0] = ${name}_wide_real(${kx});
  v[1] = ${name}_wide_real(${ky});
  v[2] = ${name}_wide_real(${kz});
  for (i = 0; i < 3; i++) t[i] = v[i];
  p.c = ${name}_wide_unit(3, t); /* |k| */
  if (!${name}_wide_sign(p.c)) return 1;
  p.c = ${name}_wide_ratio(${name}_wide_real(${fabs}(weight)), ${name}_wide_mul(p.c, I1));
  for (i = 0; i < 3 && weight < ${zero}; i++) v[i] = ${name}_wide_minus(v[i]);
  ${name}_upright(v, body);
  v[0] = ${name}_wide_real(${up_x});
  v[1] = ${name}_wide_real(${up_y});
  v[2] = ${name}_wide_real(${up_z});
  ${name}_upright(v, frame);

  for (i = 0; i < 4; i++) q[i] = ${name}_wide_real(x0[${upper}_QW + i]);
  if (!${name}_wide_sign(${name}_wide_unit(4, q))) return 1;
  for (i = 0; i < 4; i++) back[i] = i > 0 ? ${name}_wide_minus(frame[i]) : frame[i];
  ${name}_wide_product(back, q, t);
  ${name}_wide_product(t, body, q);
  (void)${name}_wide_unit(4, q);
  p.a[0] = q[0];
  p.a[1] = q[3];
  p.b[0] = q[1];
  p.b[1] = q[2];
  for (i = 0; i < 4; i++) back[i] = i > 0 ? ${name}_wide_minus(body[i]) : body[i];
  for (i = 0; i < 4; i++) w[i] = i > 0 ? ${name}_wide_real(x0[${upper}_WX + i - 1]) : zero;
  ${name}_wide_product(back, w, t);
  ${name}_wide_product(t, body, w);
  p.W[0] = w[1];
  p.W[1] = w[2];
  p.w3 = w[3];
  p.s = ${name}_wide_ratio(${name}_wide_mul(I3, p.w3), I1);

  ${name}_copy(&made, 0, (unsigned int)sizeof(made));
  rest = !${name}_wide_sign(p.W[0]) && !${name}_wide_sign(p.W[1])
      && (!${name}_wide_sign(p.c) || (!${name}_wide_sign(p.a[0]) && !${name}_wide_sign(p.a[1])) || (!${name}_wide_sign(p.b[0]) && !${name}_wide_sign(p.b[1])));
  e = 0;
  if (rest) { /* the axis stays where it is */
    made.inverse = made.period[0] = ${one};
    spin = ${name}_wide_pair(p.w3, 1);
    mu[0] = mu[1] = ${name}_pair_of(${zero});
    for (i = 0; i < 2; i++) {
      p.above[i] = ${name}_wide_scale(${name}_wide_dot(p.a[0], p.a[0], p.a[1], p.a[1]), 1);
      p.below[i] = ${name}_wide_scale(${name}_wide_dot(p.b[0], p.b[0], p.b[1], p.b[1]), 1);
    }
    p.sign[0] = p.sign[1] = 0;
    made.im[0][0] = ${name}_wide_round(${name}_wide_root(${name}_wide_scale(p.above[0], -1)));
    made.re[1][0] = ${name}_wide_round(${name}_wide_root(${name}_wide_scale(p.below[0], -1)));
  } else { /* in units of time of a power of two */
    e = ${name}_wide_size(p.s);
    if (${name}_wide_size(p.W[0]) > e) e = p.W[0].e;
    if (${name}_wide_size(p.W[1]) > e) e = p.W[1].e;
    if (${name}_half_up(${name}_wide_size(p.c)) > e) e = ${name}_half_up(p.c.e);
    p.s = ${name}_wide_scale(p.s, -e);
    p.c = ${name}_wide_scale(p.c, -2*e);
    p.w3 = ${name}_wide_scale(p.w3, -e);
    for (i = 0; i < 2; i++) p.W[i] = ${name}_wide_scale(p.W[i], -e);
    ${name}_roots(&p);
    ${name}_set_series(&made, &p, mu);
    spin = ${name}_wide_pair(${name}_wide_sub(p.w3, p.s), 1); /* (1 - C/A) w3/2 */
  }
  for (i = 0; i < 2; i++) {
    turn = i == 0 ? ${name}_add(mu[0], spin) : ${name}_sub(mu[1], spin);
    turn = ${name}_ratio(turn, ${name}_pair_scale(${name}_pair_pi, 1));
    ${name}_store(made.turn[i], ${name}_pair_scale(turn, e));
    made.rate[i] = ${ldexp}(made.rate[i], e);
  }
  for (i = 0; i < 2; i++) {
    if (!(made.rate[i] - made.rate[i] == ${zero}) || !(made.turn[i][0] - made.turn[i][0] == ${zero})) return 1;
  }
  made.tilt[0] = ${name}_angle_of(p.below[1], p.above[1]);
  made.tilt[1] = ${name}_angle_of(p.below[0], p.above[0]);

  /* b/a goes round once more in a period of the nutation, unless the axis passes through the vertical */
  for (i = 0; i < 2; i++) {
    if (!${name}_wide_sign(i == 0 ? p.above[0] : p.below[1])) p.sign[i] = 0;
  }
  made.mean = ${name}_mean_of(&made, p.sign);

  /* What turns the series' a, b and W = -conj(a) b .. to those of t = 0, from the two that are farthest from a zero. */
  v0 = ${name}_values_at(&made, ${zero});
  value[0][0] = v0.w;
  value[0][1] = v0.z;
  value[1][0] = v0.x;
  value[1][1] = v0.y;
  value[2][0] = -v0.f;
  value[2][1] = -v0.g;
  n = made.hyperbolic ? ${exp}(-${fabs}(made.start[0])) : ${one};
  n += made.nome/(n + ${least})*made.nome;
  for (i = 0, drop = 2, least = ${zero}; i < 3; i++) {
    const ${name}_wide *from = i == 0 ? p.a : i == 1 ? p.b : p.W;
    const int top = ${name}_wide_size(from[${name}_wide_size(from[1]) > ${name}_wide_size(from[0])]);
    const ${name}_real s[2] = {${name}_wide_pair(from[0], top).hi, ${name}_wide_pair(from[1], top).hi};
    const ${name}_real natural = ${fabs}(made.re[i][0]) + ${fabs}(made.im[i][0]);
    const ${name}_real size = (${fabs}(value[i][0]) + ${fabs}(value[i][1]))/((i == 0 ? ${one} : n)*natural + ${least});

    ${name}_between(s, value[i], c[i]);
    if (!rest && (i == 0 || size < least)) {
      least = size;
      drop = i;
    }
  }
  c[3][0] = c[2][0];
  c[3][1] = drop == 0 ? -c[2][1] : c[2][1]; /* c_W = conj(c_a) c_b */
  if (drop == 0) ${name}_complex(c[1], c[3], c[0]);
  if (drop == 1) ${name}_complex(c[0], c[3], c[1]);
  c[3][0] = c[0][0];
  c[3][1] = -c[0][1];
  ${name}_complex(c[3], c[1], c[2]);

  /* q = frame (c_a a, c_b b) conj(body), and the rates across the axis */
  {
    ${name}_real F[4], B[4], u[4], d[4], g[4];

    for (i = 0; i < 4; i++) {
      F[i] = ${name}_wide_round(frame[i]);
      B[i] = ${name}_wide_round(body[i]);
    }
    for (int k = 0; k < 4; k++) {
      const int from = k == 0 || k == 3 ? 0 : 1; /* y = re a, re b, im b, im a */
      const ${name}_real unit[2] = {k == 0 || k == 1 ? ${one} : ${zero}, k == 0 || k == 1 ? ${zero} : ${one}};
      ${name}_real z[2];

      ${name}_complex(unit, c[from], z);
      u[0] = from == 0 ? z[0] : ${zero};
      u[1] = from == 1 ? z[0] : ${zero};
      u[2] = from == 1 ? z[1] : ${zero};
      u[3] = from == 0 ? z[1] : ${zero};
      ${name}_quaternion_product(F, u, d);
      for (i = 0; i < 4; i++) g[i] = i > 0 ? -B[i] : B[i];
      ${name}_quaternion_product(d, g, made.q[k]);
    }
    for (int k = 0; k < 3; k++) { /* the axes here, seen from the body */
      for (i = 0; i < 4; i++) u[i] = i == k + 1 ? ${one} : ${zero};
      ${name}_quaternion_product(B, u, d);
      for (i = 0; i < 4; i++) g[i] = i > 0 ? -B[i] : B[i];
      ${name}_quaternion_product(d, g, u);
      for (i = 0; i < 3; i++) {
        if (k == 2) made.along[i] = ${name}_wide_round(${name}_wide_scale(p.w3, e))*u[i + 1];
        if (k == 0) {
          made.across[0][i] = -c[2][0]*u[i + 1];
          made.across[1][i] = c[2][1]*u[i + 1];
        }
        if (k == 1) {
          made.across[0][i] = ${ldexp}(made.across[0][i] - c[2][1]*u[i + 1], e);
          made.across[1][i] = ${ldexp}(made.across[1][i] - c[2][0]*u[i + 1], e);
        }
      }
    }
  }
  if (!${name}_starts(&made)) return 1;
  ${name}_copy(o, &made, (unsigned int)sizeof(made));
  return 0;
}
