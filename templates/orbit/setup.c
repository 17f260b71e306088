%% -- setup.c -- the set-up of the free top's closed form: part of scene.c.  SPDX-License-Identifier: MIT-0
/* ---- set-up from a state ---- */

/* the exponent of the largest of n numbers */
static int ${name}_scale_of(const ${name}_real x[], int n)
{
  ${name}_real largest = ${zero};
  int e;
  for (int i = 0; i < n; i++) largest = ${fabs}(x[i]) > largest ? ${fabs}(x[i]) : largest;
  (void)${frexp}(largest, &e);
  return e;
}

/* q = length out, as a vector of four; out = 0 if q is */
static ${name}_pair ${name}_unit_quaternion(const ${name}_real q[4], ${name}_real out[4])
{
  const int e = ${name}_scale_of(q, 4);
  ${name}_pair sum = ${name}_pair_of(${zero});
  for (int i = 0; i < 4; i++) {
    out[i] = ${ldexp}(q[i], -e);
    sum = ${name}_add(sum, ${name}_pair_product(out[i], out[i]));
  }
  const ${name}_pair length = ${name}_pair_root(sum);
  for (int i = 0; i < 4 && length.hi > ${zero}; i++) out[i] = ${name}_ratio(${name}_pair_of(out[i]), length).hi;
  return length;
}

/* Constant rotation: w and L are parallel; axis 3 is theirs, and p = 0, E = 0. */
static void ${name}_constant(${name}_orbit *o, ${name}_top *p, const ${name}_pair w[3])
{
  ${name}_pair length = ${name}_pair_of(${zero});
  for (int i = 0; i < 3; i++) length = ${name}_add(length, ${name}_pair_product(w[i].hi, w[i].hi));
  length = ${name}_pair_root(length);
  for (int i = 0; i < 3; i++) {
    p->axis[0][i] = p->axis[1][i] = ${zero};
    p->axis[2][i] = length.hi > ${zero} ? ${name}_ratio(w[i], length).hi : ${zero};
  }
  p->b[0] = p->b[1] = ${zero}; p->b[2] = length.hi;
  p->s = ${one}; p->small12 = 0;
  o->a[0] = o->f[5] = o->scale[2] = ${one};
  per_second(p, ${name}_ratio(length, ${name}_pair_scale(${name}_pair_pi, 2)), o->turn);
}

/* what makes rates and quaternion of the terms, from the attitude q0 at t = 0 */
static void ${name}_combine(${name}_orbit *o, const ${name}_top *p, const ${name}_real q0[4])
{
  const ${name}_instant zero_phase = {${zero}, ${zero}, ${zero}, ${zero}};
  const ${name}_real turned = o->hyperbolic ? p->s : ${one}; /* of x and y */
  ${name}_thetas terms = ${name}_terms_of(o, zero_phase, o->hyperbolic);
  const ${name}_real n = ${name}_length2(&terms); /* the rates are over N^2, which is this at u = 0 */
  for (int i = 0; i < 3; i++) {
    const int e = p->e + (i < 2 ? p->small12 : 0);
    for (int j = 0; j < 3; j++) o->w[i][j] = ${ldexp}(n*o->scale[i]*p->b[i]*p->axis[i][j], e);
  }
  /* q(t) = q0 (conj(y0) y(t)), the vector part of the second turned from principal to body axes */
  ${name}_real y[4];
  for (int i = 0; i < 4; i++) for (int j = 0; j < 4; j++) o->q[i][j] = i == j ? ${one} : ${zero};
  terms = ${name}_terms_of(o, ${name}_reduce(o, ${zero}), o->hyperbolic);
  ${name}_attitude_of(o, &terms, y);
  y[1] *= turned; y[2] *= turned;
  (void)${name}_unit_quaternion(y, y);
  for (int i = 1; i < 4; i++) y[i] = -y[i];
  for (int k = 0; k < 4; k++) {
    ${name}_real unit[4] = {${zero}, ${zero}, ${zero}, ${zero}}, d[4], v[4];
    unit[k] = k == 1 || k == 2 ? turned : ${one};
    ${name}_quaternion_product(y, unit, d);
    v[0] = d[0];
    for (int j = 0; j < 3; j++) {
      v[j + 1] = d[1]*p->axis[0][j] + d[2]*p->axis[1][j] + d[3]*p->axis[2][j];
    }
    ${name}_quaternion_product(q0, v, o->q[k]);
  }
}

int ${name}_solve(${name}_orbit *o, const ${name}_model *m, const ${name}_real x0[])
{
  ${name}_orbit made;
  ${name}_top p;
%% if diagonal then
  ${name}_pair I[3], w[3];
%% else
  ${name}_pair I[3], axis[3][3], rate[3], w[3];
%% end
  ${name}_real tensor[6], q0[4], x[${upper}_NX];
  int order[3], moves = 0;

  ${name}_inertia(m, tensor);
  if (!${name}_numbers(x0, ${upper}_NX)) return 1;
  if (!(${name}_unit_quaternion(x0 + ${upper}_QW, q0).hi > ${zero})) return 1;
%% if diagonal then
%% if has_rod then
  if (!${name}_numbers(tensor, 3)) return 1;
%% end
  for (int i = 0; i < 3; i++) { /* ascending; equal moments keep their order */
    int j = i;
    for (; j > 0 && tensor[i] < tensor[order[j - 1]]; j--) order[j] = order[j - 1];
    order[j] = i;
  }
%% if not has_rod then
  if (!(tensor[order[0]] > ${zero})) return 1; /* has underflowed */
%% end
  for (int i = 0; i < 3; i++) I[i] = ${name}_pair_of(${ldexp}(tensor[i], -${name}_scale_of(tensor, 3)));
%% else
  int scale;
  const int oblique = ${fabs}(tensor[3]) + ${fabs}(tensor[4]) + ${fabs}(tensor[5]) > ${zero};
  if (${name}_principal_pairs(tensor, I, axis, order, &scale)) return 1;
  (void)${frexp}(I[order[2]].hi, &scale);
  for (int i = 0; i < 3; i++) I[i] = ${name}_pair_scale(I[i], -scale);
%% end
%% if has_rod then
  if (!(I[order[0]].hi > ${zero})) { /* a rod */
    const ${name}_pair sum = ${name}_add(I[order[1]], I[order[2]]);
    const ${name}_real size = ${eight}*${epsilon}*I[order[2]].hi;

    if (I[order[0]].hi < -size || I[order[2]].hi - I[order[1]].hi > size) return 1;
    I[order[0]] = ${name}_pair_of(${zero});
    I[order[1]] = I[order[2]] = ${name}_pair_scale(sum, -1);
  }
%% end
  int e = ${name}_scale_of(x0 + ${upper}_WX, 3);
  if (e > 0) e = e > ${rate_spare} ? e - ${rate_spare} : 0; /* subnormal rates beside it keep their bits */
%% if diagonal then
  for (int i = 0; i < 3; i++) w[i] = ${name}_pair_of(${ldexp}(x0[${upper}_WX + i], -e));
%% else
  for (int i = 0; i < 3; i++) w[i] = rate[i] = ${name}_pair_of(${ldexp}(x0[${upper}_WX + i], -e));
  for (int i = 0; i < 3 && oblique; i++) { /* else axis i is the body's */
    w[i] = ${name}_scaled(rate[0].hi, axis[i][0]);
    for (int j = 1; j < 3; j++) w[i] = ${name}_add(w[i], ${name}_scaled(rate[j].hi, axis[i][j]));
  }
%% end
  for (int i = 0; i < 3; i++) { /* w x L = 0? */
    const int j = (i + 1) % 3;
    const ${name}_real difference = ${name}_sub(I[i], I[j]).hi;
    if (${fabs}(w[i].hi) > ${zero} && ${fabs}(w[j].hi) > ${zero} && ${fabs}(difference) > ${zero}) moves = 1;
  }
  ${name}_copy(&made, 0, (unsigned int)sizeof(made));
  p.e = e;
  if (moves) {
%% if diagonal then
    ${name}_label(&p, I, w, order);
%% else
    ${name}_label(&p, I, w, (const ${name}_pair(*)[3])axis, order);
%% end
    ${name}_invariants(&p);
    /* from kappa = 1, k'^2 = 17 - 12 sqrt 2, on, where the two series converge alike */
    if (p.kc2.hi*p.down13*p.down13 < ${one}/${n[34]}) ${name}_set_hyperbolic(&made, &p);
    else ${name}_set_circular(&made, &p);
  } else {
%% if diagonal then
    ${name}_constant(&made, &p, w);
%% else
    ${name}_constant(&made, &p, rate);
%% end
  }
  made.s = p.s;
  const ${name}_real fastest = ${fabs}(made.turn[0]) > made.rate[0] ? ${fabs}(made.turn[0]) : made.rate[0];
  made.last = fastest*${last_time} > ${last_turn} ? ${last_turn}/fastest : ${last_time};
  if (!(made.rate[0] - made.rate[0] == ${zero}) || !(made.turn[0] - made.turn[0] == ${zero})) return 1;
  ${name}_combine(&made, &p, q0);
%% if flies then
  const ${name}_real g[3] = {${g1}, ${g2}, ${g3}};
  for (int i = 0; i < 3; i++) made.g[i] = g[i];
  ${name}_launch(&made, x0);
%% end

%% if damped then
  made.decay = ${decay};
  if (!${name}_starts(&made)) return 1;
%% else
  /* Is it made of numbers?  Rates next to the end of the type's range overflow on the way to a state. */
  ${name}_at(&made, ${zero}, x);
  if (!${name}_numbers(x, ${upper}_NX)) return 1;
%% end
  const ${name}_real start[2] = {made.start[0], made.start[1]};
  made.start[0] = ${quarter}; made.start[1] = ${zero}; /* near the separatrix the rates' terms are largest there */
  ${name}_at(&made, ${zero}, x);
  if (!${name}_numbers(x, ${upper}_NX)) return 1;
  made.start[0] = start[0]; made.start[1] = start[1];
  ${name}_copy(o, &made, (unsigned int)sizeof(made));
  return 0;
}
