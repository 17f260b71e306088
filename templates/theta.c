%% -- theta.c -- theta functions of the free top, and its state at any time: part of scene.c.  SPDX-License-Identifier: MIT-0
static void ${name}_quaternion_product(const ${name}_real a[4], const ${name}_real b[4], ${name}_real out[4])
{
  out[0] = a[0]*b[0] - a[1]*b[1] - a[2]*b[2] - a[3]*b[3];
  out[1] = a[0]*b[1] + a[1]*b[0] + a[2]*b[3] - a[3]*b[2];
  out[2] = a[0]*b[2] - a[1]*b[3] + a[2]*b[0] + a[3]*b[1];
  out[3] = a[0]*b[3] + a[1]*b[2] - a[2]*b[1] + a[3]*b[0];
}

/* c[0] + c[1] y[1] + ...: a series in multiple angles, y[n+1] = 2 X y[n] - y[n-1], as a polynomial in X; y[0] = 1 and
 * y[1] = first + slope X */
static void ${name}_polynomial(int n, const ${name}_real c[], ${name}_real first, ${name}_real slope, ${name}_real out[])
{
  ${name}_real before[5] = {${one}, ${zero}, ${zero}, ${zero}, ${zero}};
  ${name}_real now[5] = {first, slope, ${zero}, ${zero}, ${zero}}, next[5];
  int i, k;

  for (k = 0; k < n; k++) out[k] = k == 0 ? c[0] : ${zero};
  for (i = 1; i < n; i++) {
    for (k = 0; k <= i; k++) out[k] += c[i]*now[k];
    for (k = 0; k < 5; k++) next[k] = (k > 0 ? ${two}*now[k - 1] : ${zero}) - before[k];
    for (k = 0; k < 5; k++) {
      before[k] = now[k];
      now[k] = next[k];
    }
  }
}

/* Away from the separatrix.  q^(1/2) e^eta = E = exp(-pi F/(2 K)), F = B3 R_F(B1^2, B2^2, G^2), e^(-2 eta) = r = q/E^2;
 * mu = G/(2 I2) - s z'/2 d log theta2(i eta; q)/d eta, whose terms are of the size of the rates. */
static void ${name}_circular(${name}_orbit *o, const ${name}_top *p)
{
  const ${name}_pair one = ${name}_pair_of(${one}), pi = ${name}_pi(), K2 = ${name}_pair_scale(p->K, 1);
  const ${name}_pair rate = ${name}_pair_divide(p->lambda, K2), start = ${name}_pair_divide(${name}_argument(p), K2);
  const ${name}_pair q = ${name}_pair_scale(p->q, 2*p->small12);
  ${name}_pair F, E, E2, r, r2, up, down, odd, power, D, total;
  ${name}_real e[8], g[8], c[5], Q[26], sign;
  int n;

  F = ${name}_carlson(${name}_pair_scale(${name}_pair_multiply(p->I[0], p->b[0]), p->small12),
               ${name}_pair_scale(${name}_pair_multiply(p->I[1], p->b[1]), p->small12), p->G);
  F = ${name}_pair_multiply(${name}_pair_multiply(p->I[2], p->b[2]), F);
  E = ${name}_pair_exp(${name}_pair_divide(${name}_pair_multiply(pi, F), ${name}_pair_minus(K2)), -p->small12);
  r = ${name}_pair_divide(p->q, ${name}_pair_multiply(E, E));
  E = ${name}_pair_scale(E, p->small12);
  E2 = ${name}_pair_multiply(E, E);

  /* sum (2n+1) q^(n^2) E^(2n) (1 - r^(2n+1)) over the same without 2n+1 and with a plus */
  r2 = ${name}_pair_multiply(r, r);
  up = down = ${name}_pair_of(${zero});
  power = one; /* q^(n^2) E^(2n) */
  odd = r;     /* r^(2n+1) */
  D = ${name}_pair_multiply(q, E2);
  total = ${name}_pair_multiply(q, q);
  for (n = 0; n < 8; n++) {
    up = ${name}_pair_add(up, ${name}_pair_times((${name}_real)(2*n + 1), ${name}_pair_multiply(power, ${name}_pair_subtract(one, odd))));
    down = ${name}_pair_add(down, ${name}_pair_multiply(power, ${name}_pair_add(one, odd)));
    odd = ${name}_pair_multiply(odd, r2);
    power = ${name}_pair_multiply(power, D);
    D = ${name}_pair_multiply(D, total);
  }
  D = ${name}_pair_multiply(${name}_pair_divide(up, down), rate);
  total = ${name}_pair_divide(p->G, ${name}_pair_multiply(pi, p->I[1]));
  total = ${name}_pair_scale(${name}_pair_subtract(total, ${name}_pair_times(p->s, D)), -2);
  o->hyperbolic = 0;
  ${name}_store(o->start, ${name}_pair_scale(start, -1)); /* the rates have two periods of theta functions */
  ${name}_store(o->rate, ${name}_pair_scale(rate, -1));
  ${name}_store(o->turn, total);

  /* theta4: 1 - q (E^2 + g^2) cos 2z + q^6 (E^4 + g^4) cos 4z - ..., g = q/E; theta1: (E + g) sin z - ... */
  e[0] = g[0] = ${one};
  for (n = 1; n < 8; n++) {
    e[n] = e[n - 1]*E.hi;
    g[n] = g[n - 1]*(E.hi*r.hi);
  }
  Q[0] = ${one}; /* powers of q */
  for (n = 1; n < 26; n++) Q[n] = Q[n - 1]*q.hi;
  /* what q <= exp(-pi/2) leaves above 2^-54 */
  for (n = 0, sign = ${one}; n < 4; n++, sign = -sign) c[n] = n == 0 ? ${one} : sign*Q[n*(2*n - 1)]*(e[2*n] + g[2*n]);
  ${name}_polynomial(4, c, ${zero}, ${one}, o->a);
  for (n = 1, sign = -${two}; n < 4; n++, sign = -sign) c[n - 1] = p->s*sign*Q[n*(2*n - 1)]*(e[2*n] - g[2*n]);
  ${name}_polynomial(3, c, ${zero}, ${two}, o->b);
  for (n = 0, sign = ${one}; n < 4; n++, sign = -sign) c[n] = p->s*sign*Q[n*(2*n + 1)]*(e[2*n + 1] + g[2*n + 1]);
  ${name}_polynomial(4, c, ${one}, ${two}, o->c);
  for (n = 0, sign = -${one}; n < 4; n++, sign = -sign) c[n] = sign*Q[n*(2*n + 1)]*(e[2*n + 1] - g[2*n + 1]);
  ${name}_polynomial(4, c, -${one}, ${two}, o->d);

  /* theta2(z; q), theta1(z; q) without 2 q^(1/4), theta3(z; q), each over what makes it cn, sn, dn times theta4/theta4(0) */
  {
    ${name}_real two_ = ${zero}, three_ = ${one}, four_ = ${one};

    for (n = 0; n < 5; n++) two_ += Q[n*(n + 1)];
    for (n = 1; n < 6; n++) {
      three_ += ${two}*Q[n*n];
      four_ += (n % 2 ? -${two} : ${two})*Q[n*n];
    }
    for (n = 0; n < 5; n++) c[n] = Q[n*(n + 1)];
    ${name}_polynomial(5, c, -${one}, ${two}, o->f);
    for (n = 0; n < 5; n++) c[n] = (n ? ${two} : ${one})*Q[n*n];
    ${name}_polynomial(5, c, ${zero}, ${one}, o->f + 5);
    o->scale[0] = ${one}/two_;
    o->scale[1] = p->s*three_/(two_*four_);
    o->scale[2] = ${one}/three_;
  }
}

/* c[n] p^(n(n + 1)) cosh((2n + 1)V)/cosh V, n < 4, summed, as a polynomial in U = p cosh 2V */
static void ${name}_multiples(const ${name}_real c[4], ${name}_real p, ${name}_real out[4])
{
  const ${name}_real p2 = p*p, p4 = p2*p2, p8 = p4*p4;

  out[0] = c[0] - p2*(c[1] + p4*(c[2] - p4*p2*c[3]));
  out[1] = ${two}*p*(c[1] - p4*(c[2] + ${two}*p4*p2*c[3]));
  out[2] = ${two}*${two}*p4*(c[2] - p4*p2*c[3]);
  out[3] = ${eight}*p8*p*c[3];
}

/* Near the separatrix.  h = kappa eta = pi v/(4 K'), sc(v, k') = sqrt(I1 (I3 - I2)/(I3 (I2 - I1))); V has the period
 * pi kappa = -log(q')/2 (none on the separatrix), at which the phase about L jumps by -2 s h; between,
 * mu = G/(2 I2) - s V' theta4'(2h; q')/theta4(2h; q'). */
static void ${name}_hyperbolic(${name}_orbit *o, const ${name}_top *p)
{
  const ${name}_pair one = ${name}_pair_of(${one}), pi = ${name}_pi(), K4 = ${name}_pair_scale(p->Kc, 2);
  const ${name}_pair scale = ${name}_pair_divide(pi, K4);
  const ${name}_pair rate = ${name}_pair_multiply(p->lambda, scale), start = ${name}_pair_multiply(${name}_argument(p), scale);
  const ${name}_pair sum = ${name}_pair_multiply(p->I[1], p->d31);
  const ${name}_pair sn = ${name}_root_of(${name}_pair_multiply(p->I[0], p->d32), sum), cn = ${name}_root_of(${name}_pair_multiply(p->I[2], p->d21), sum);
  const ${name}_pair dn = ${name}_pair_multiply(p->G, ${name}_root_of(p->rho, ${name}_pair_multiply(p->I[1], p->Lambda1)));
  const ${name}_pair v = ${name}_pair_multiply(sn, ${name}_carlson(cn, dn, one));
  ${name}_pair turn = ${name}_pair_divide(v, K4), c1, s1, c, s, up, down, power, odd, ratio;
  ${name}_real cosine[4], sine[4]; const ${name}_real h = ${name}_pair_multiply(pi, turn).hi; ${name}_real P, Q, Q2, two_, three_, four_;
  int n;

  ${name}_pair_circle(${name}_pair_scale(${name}_pair_multiply(pi, turn), 2), &c1, &s1); /* 4h: cos - 1, sin */
  up = ${name}_pair_of(${zero});
  down = one;
  c = ${name}_pair_add(one, c1);
  s = s1;
  power = p->qc;
  odd = ${name}_pair_multiply(p->qc, ${name}_pair_multiply(p->qc, p->qc));
  for (n = 1; n < 5; n++) { /* theta4(x) = 1 - 2 q' cos 2x + 2 q'^4 cos 4x - ... */
    ratio = c;
    up = ${name}_pair_add(up, ${name}_pair_times((${name}_real)(n % 2 ? 4*n : -4*n), ${name}_pair_multiply(power, s)));
    down = ${name}_pair_add(down, ${name}_pair_times((${name}_real)(n % 2 ? -2 : 2), ${name}_pair_multiply(power, c)));
    c = ${name}_pair_subtract(${name}_pair_add(ratio, ${name}_pair_multiply(ratio, c1)), ${name}_pair_multiply(s, s1));
    s = ${name}_pair_add(${name}_pair_add(s, ${name}_pair_multiply(s, c1)), ${name}_pair_multiply(ratio, s1));
    power = ${name}_pair_multiply(power, odd);
    odd = ${name}_pair_multiply(odd, ${name}_pair_multiply(p->qc, p->qc));
  }
  up = ${name}_pair_multiply(rate, ${name}_pair_divide(up, down));
  up = ${name}_pair_subtract(${name}_pair_divide(p->G, ${name}_pair_scale(p->I[1], 1)), ${name}_pair_times(p->s, up));
  up = ${name}_pair_divide(up, ${name}_pair_scale(pi, 1));
  if (p->qc.hi > ${zero} || p->log_qc.hi < ${zero}) {
    const ${name}_pair period = ${name}_pair_minus(p->log_qc), per = ${name}_pair_divide(rate, period);

    turn = ${name}_pair_times(p->s, turn);
    ${name}_store(o->rate, per);
    ${name}_store(o->start, ${name}_pair_divide(start, period));
    ${name}_store(o->turn, ${name}_pair_subtract(up, ${name}_pair_scale(${name}_pair_multiply(turn, per), 1)));
    o->jump = turn.hi;
    o->half = ${name}_pair_divide(period, ${name}_pair_scale(${name}_log2(), 1)).hi;
  } else { /* none: that of ${no_period}, beyond which V never comes */
    const ${name}_pair period = ${name}_pair_times(${no_period}, ${name}_log2());

    ${name}_store(o->rate, ${name}_pair_scale(${name}_pair_divide(rate, period), -1));
    ${name}_store(o->start, ${name}_pair_scale(${name}_pair_divide(start, period), -1));
    ${name}_store(o->turn, up);
    o->half = ${no_period};
  }

  o->hyperbolic = o->half < ${two}*${binary_limit} ? 1 : 2;
  P = ${sqrt}(p->qc.hi);
  Q = p->qc.hi;
  Q2 = Q*Q;
  o->nome = ${half}*P;
  for (n = 0; n < 4; n++) {
    cosine[n] = ${cos}((${name}_real)(2*n + 1)*h);
    sine[n] = (n % 2 ? p->s : -p->s)*${sin}((${name}_real)(2*n + 1)*h);
  }
  ${name}_multiples(cosine, P, o->a);
  ${name}_multiples(sine, P, o->b);
  o->f[0] = ${one} + ${two}*Q2*Q2; /* with (n + 1/2)^2 = 2 (n(n + 1)/2) + 1/4 ... */
  o->f[1] = -${eight}*${two}*Q2*Q;
  o->f[2] = ${eight}*${two}*Q2;
  o->f[3] = -${two}*Q;
  o->f[4] = ${two}*${two};
  o->f[5] = ${one} + Q2;
  o->f[6] = -${two}*${two}*(Q + ${threehalves}*${two}*Q2*Q2*Q);
  o->f[7] = ${eight}*${two}*Q2*Q2;
  /* cn, sn, dn times theta2/theta2(0), nome q', scaled */
  two_ = ${one} + Q*Q + Q*Q*Q*Q*Q*Q;
  three_ = ${one} + ${two}*(Q + Q*Q*Q*Q);
  four_ = ${one} - ${two}*(Q - Q*Q*Q*Q);
  o->scale[0] = ${one}/four_;
  o->scale[1] = p->s*three_/(${two}*two_*four_);
  o->scale[2] = ${one}/three_;
}

static ${name}_pair ${name}_unit_quaternion(const ${name}_real q[4], ${name}_real out[4])
{
  ${name}_pair sum = ${name}_pair_of(${zero}), length;
  ${name}_real big = ${zero};
  int i, e;

  for (i = 0; i < 4; i++) big = ${fabs}(q[i]) > big ? ${fabs}(q[i]) : big;
  (void)${frexp}(big, &e);
  for (i = 0; i < 4; i++) {
    out[i] = ${ldexp}(q[i], -e);
    sum = ${name}_pair_add(sum, ${name}_pair_product(out[i], out[i]));
  }
  length = ${name}_pair_root(sum);
  for (i = 0; i < 4 && big > ${zero}; i++) out[i] = ${name}_pair_divide(${name}_pair_of(out[i]), length).hi;
  return length;
}

/* all numbers 0 */
static void ${name}_clear(${name}_orbit *o)
{
  int i;

  for (i = 0; i < 4; i++) o->rate[i] = o->turn[i] = o->a[i] = o->b[i] = o->c[i] = o->d[i] = ${zero};
  for (i = 0; i < 2; i++) o->rate_tick[i] = o->rate_start[i] = o->turn_tick[i] = o->turn_start[i] = 0;
  for (i = 0; i < 10; i++) o->f[i] = ${zero};
  for (i = 0; i < 3; i++) o->scale[i] = ${zero};
  o->start[0] = o->start[1] = o->jump = o->half = o->nome = o->tick = ${zero};
  o->s = ${one};
  o->hyperbolic = 0;
}

/* Constant rotation: w and L are parallel; axis 3 is theirs, and p = 0, E = 0. */
static void ${name}_constant(${name}_orbit *o, ${name}_top *p, const ${name}_real w[3])
{
  ${name}_pair length = ${name}_pair_of(${zero});
  int i, j;

  for (i = 0; i < 3; i++) length = ${name}_pair_add(length, ${name}_pair_product(w[i], w[i]));
  length = ${name}_pair_root(length);
  for (i = 0; i < 3; i++) {
    for (j = 0; j < 2; j++) p->axis[j][i] = ${zero};
    p->axis[2][i] = length.hi > ${zero} ? ${name}_pair_divide(${name}_pair_of(w[i]), length).hi : ${zero};
  }
  p->b[0] = p->b[1] = ${name}_pair_of(${zero});
  p->b[2] = length;
  o->a[0] = o->f[5] = ${one};
  ${name}_store(o->turn, ${name}_pair_divide(length, ${name}_pair_scale(${name}_pi(), 2)));
  o->scale[2] = ${one};
}

int ${name}_solve(${name}_orbit *o, const ${name}_model *m, const ${name}_real x0[])
{
  ${name}_orbit made;
  ${name}_top p;
  ${name}_pair I[3], axis[3][3], w[3];
  ${name}_real tensor[6], rate[3], y[4], q0[4], n, size, turned, largest = ${zero};
  const ${name}_phases phases = {${zero}, ${zero}, ${zero}, ${zero}};
  ${name}_terms terms;
  int order[3], scale, e, i, j, k;

  ${name}_inertia(m, tensor);
  for (i = 0; i < ${upper}_NX; i++) {
    if (!(x0[i] - x0[i] == ${zero})) return 1;
  }
  if (!(${name}_unit_quaternion(x0 + ${upper}_QW, q0).hi > ${zero})) return 1;
  if (${name}_principal_pairs(tensor, I, axis, order, &scale)) return 1;
  (void)${frexp}(I[order[2]].hi, &e);
  for (i = 0; i < 3; i++) I[i] = ${name}_pair_scale(I[i], -e);
  size = ${eight}*${epsilon}*I[order[2]].hi;
  if (!(I[order[0]].hi > ${zero})) { /* a rod */
    const ${name}_pair sum = ${name}_pair_add(I[order[1]], I[order[2]]);

    if (I[order[0]].hi < -size || I[order[2]].hi - I[order[1]].hi > size) return 1;
    I[order[0]] = ${name}_pair_of(${zero});
    I[order[1]] = I[order[2]] = ${name}_pair_scale(sum, -1);
  }
  for (i = 0; i < 3; i++) largest = ${fabs}(x0[${upper}_WX + i]) > largest ? ${fabs}(x0[${upper}_WX + i]) : largest;
  (void)${frexp}(largest, &e);
  for (i = 0; i < 3; i++) rate[i] = ${ldexp}(x0[${upper}_WX + i], -e);
  for (i = 0; i < 3; i++) {
    w[i] = ${name}_pair_times(rate[0], axis[i][0]);
    for (j = 1; j < 3; j++) w[i] = ${name}_pair_add(w[i], ${name}_pair_times(rate[j], axis[i][j]));
  }
  for (i = 0, k = 0; i < 3; i++) { /* w x L = 0? */
    j = (i + 1) % 3;
    n = ${name}_pair_subtract(I[i], I[j]).hi;
    if (${fabs}(w[i].hi) > ${zero} && ${fabs}(w[j].hi) > ${zero} && ${fabs}(n) > ${zero}) k = 1;
  }
  ${name}_clear(&made);
  if (!k) {
    p.small12 = 0;
    ${name}_constant(&made, &p, rate);
  } else {
    ${name}_label(&p, I, w, (const ${name}_pair(*)[3])axis, order);
    ${name}_invariants(&p);
    ${name}_nomes(&p);
    made.s = p.s;
    if (p.hyperbolic) ${name}_hyperbolic(&made, &p);
    else ${name}_circular(&made, &p);
  }
  for (i = 0; i < 2; i++) { /* high parts in halves, for Dekker's product */
    ${name}_real *b = i == 0 ? made.rate : made.turn, c = ${split}*b[0];

    b[2] = c - (c - b[0]);
    b[3] = b[0] - b[2];
    for (j = 0; j < 4; j++) b[j] = ${ldexp}(b[j], e); /* per second again */
  }
  n = ${fabs}(made.turn[0]) > made.rate[0] ? ${fabs}(made.turn[0]) : made.rate[0];
  made.last = n*${last_time} > ${last_turn} ? ${last_turn}/n : ${last_time};
  if (!(made.rate[0] - made.rate[0] == ${zero}) || !(made.turn[0] - made.turn[0] == ${zero})) return 1;

  /* the rates are over N^2, which is this at u = 0 */
  terms = ${name}_terms_of(&made, phases, made.hyperbolic);
  n = ${name}_square(&terms);
  for (i = 0; i < 3; i++) {
    for (j = 0; j < 3; j++) {
      made.w[i][j] = ${ldexp}(n*made.scale[i]*p.b[i].hi*p.axis[i][j], e + (i < 2 ? p.small12 : 0));
    }
  }
  /* q(t) = q0 (conj(y0) y(t)), the vector part of the second turned from principal to body axes */
  for (i = 0; i < 4; i++) {
    for (j = 0; j < 4; j++) made.q[i][j] = i == j ? ${one} : ${zero};
  }
  terms = ${name}_terms_of(&made, ${name}_reduce(&made, ${zero}), made.hyperbolic);
  ${name}_attitude_of(&made, &terms, y);
  turned = made.hyperbolic ? p.s : ${one}; /* of x and y */
  y[1] *= turned;
  y[2] *= turned;
  (void)${name}_unit_quaternion(y, y);
  for (k = 0; k < 4; k++) {
    ${name}_real unit[4] = {${zero}, ${zero}, ${zero}, ${zero}}, d[4], v[4];

    unit[k] = k == 1 || k == 2 ? turned : ${one};
    for (i = 1; i < 4; i++) y[i] = k == 0 ? -y[i] : y[i];
    ${name}_quaternion_product(y, unit, d);
    v[0] = d[0];
    for (j = 0; j < 3; j++) v[j + 1] = d[1]*p.axis[0][j] + d[2]*p.axis[1][j] + d[3]*p.axis[2][j];
    ${name}_quaternion_product(q0, v, made.q[k]);
  }
  *o = made;
  return 0;
}
