%% -- setup.c -- the set-up of the free top's closed form: part of scene.c.  SPDX-License-Identifier: MIT-0
/* ---- set-up from a state ---- */

static ${name}_pair ${name}_unit_quaternion(const ${name}_real q[4], ${name}_real out[4])
{
  ${name}_pair sum = ${name}_pair_of(${zero}), length;
  ${name}_real big = ${zero};
  int i, e;

  for (i = 0; i < 4; i++) big = ${fabs}(q[i]) > big ? ${fabs}(q[i]) : big;
  (void)${frexp}(big, &e);
  for (i = 0; i < 4; i++) {
    out[i] = ${ldexp}(q[i], -e);
    sum = ${name}_add(sum, ${name}_pair_product(out[i], out[i]));
  }
  length = ${name}_pair_root(sum);
  for (i = 0; i < 4 && big > ${zero}; i++) out[i] = ${name}_ratio(${name}_pair_of(out[i]), length).hi;
  return length;
}

/* Constant rotation: w and L are parallel; axis 3 is theirs, and p = 0, E = 0. */
static void ${name}_constant(${name}_orbit *o, ${name}_top *p, const ${name}_real w[3])
{
  ${name}_pair length = ${name}_pair_of(${zero});
  int i, j;

  for (i = 0; i < 3; i++) length = ${name}_add(length, ${name}_pair_product(w[i], w[i]));
  length = ${name}_pair_root(length);
  for (i = 0; i < 3; i++) {
    for (j = 0; j < 2; j++) p->axis[j][i] = ${zero};
    p->axis[2][i] = length.hi > ${zero} ? ${name}_ratio(${name}_pair_of(w[i]), length).hi : ${zero};
  }
  p->b[0] = p->b[1] = ${zero}; p->b[2] = length.hi;
  o->a[0] = o->f[5] = ${one};
  ${name}_store(o->turn, ${name}_ratio(length, ${name}_pair_scale(${name}_pi(), 2)));
  o->scale[2] = ${one};
}

int ${name}_solve(${name}_orbit *o, const ${name}_model *m, const ${name}_real x0[])
{
  ${name}_orbit made;
  ${name}_top p;
%% if diagonal then
  ${name}_pair I[3], w[3];
%% else
  ${name}_pair I[3], axis[3][3], w[3];
%% end
  ${name}_real tensor[6], rate[3], y[4], q0[4], x[${upper}_NX], n, size, turned, largest = ${zero};
  const ${name}_instant zero_phase = {${zero}, ${zero}, ${zero}, ${zero}}, farthest = {${quarter}, ${zero}, ${zero}, ${zero}};
  ${name}_thetas terms;
%% if diagonal then
  int order[3], e, i, j, k;
%% else
  int order[3], scale, oblique, e, i, j, k;
%% end

  ${name}_inertia(m, tensor);
  if (!${name}_numbers(x0, ${upper}_NX)) return 1;
  if (!(${name}_unit_quaternion(x0 + ${upper}_QW, q0).hi > ${zero})) return 1;
%% if diagonal then
  if (!${name}_numbers(tensor, 3)) return 1;
  for (i = 0; i < 3; i++) { /* ascending; equal moments keep their order */
    for (j = i; j > 0 && tensor[i] < tensor[order[j - 1]]; j--) order[j] = order[j - 1];
    order[j] = i;
    I[i] = ${name}_pair_of(tensor[i]);
  }
%% else
  oblique = ${fabs}(tensor[3]) + ${fabs}(tensor[4]) + ${fabs}(tensor[5]) > ${zero};
  if (${name}_principal_pairs(tensor, I, axis, order, &scale)) return 1;
%% end
  (void)${frexp}(I[order[2]].hi, &e);
  for (i = 0; i < 3; i++) I[i] = ${name}_pair_scale(I[i], -e);
  size = ${eight}*${epsilon}*I[order[2]].hi;
  if (!(I[order[0]].hi > ${zero})) { /* a rod */
    const ${name}_pair sum = ${name}_add(I[order[1]], I[order[2]]);

    if (I[order[0]].hi < -size || I[order[2]].hi - I[order[1]].hi > size) return 1;
    I[order[0]] = ${name}_pair_of(${zero});
    I[order[1]] = I[order[2]] = ${name}_pair_scale(sum, -1);
  }
  for (i = 0; i < 3; i++) largest = ${fabs}(x0[${upper}_WX + i]) > largest ? ${fabs}(x0[${upper}_WX + i]) : largest;
  (void)${frexp}(largest, &e);
  if (e > 0) e = e > ${rate_spare} ? e - ${rate_spare} : 0; /* subnormal rates beside it keep their bits */
  for (i = 0; i < 3; i++) rate[i] = ${ldexp}(x0[${upper}_WX + i], -e);
  for (i = 0; i < 3; i++) {
    w[i] = ${name}_pair_of(rate[i]);
%% if not diagonal then
    if (!oblique) continue; /* axis i is the body's */
    w[i] = ${name}_scaled(rate[0], axis[i][0]);
    for (j = 1; j < 3; j++) w[i] = ${name}_add(w[i], ${name}_scaled(rate[j], axis[i][j]));
%% end
  }
  for (i = 0, k = 0; i < 3; i++) { /* w x L = 0? */
    j = (i + 1) % 3;
    n = ${name}_sub(I[i], I[j]).hi;
    if (${fabs}(w[i].hi) > ${zero} && ${fabs}(w[j].hi) > ${zero} && ${fabs}(n) > ${zero}) k = 1;
  }
  ${name}_copy(&made, 0, (unsigned int)sizeof(made));
  made.s = ${one};
  if (!k) {
    p.small12 = 0;
    ${name}_constant(&made, &p, rate);
  } else {
%% if diagonal then
    ${name}_label(&p, I, w, order);
%% else
    ${name}_label(&p, I, w, (const ${name}_pair(*)[3])axis, order);
%% end
    ${name}_invariants(&p);
    made.s = p.s;
    /* from kappa = 1, k'^2 = 17 - 12 sqrt 2, on, where the two series converge alike */
    if (p.kc2.hi*p.down13*p.down13 < ${one}/${n[34]}) ${name}_set_hyperbolic(&made, &p);
    else ${name}_set_circular(&made, &p);
  }
  for (i = 0; i < 2; i++) { /* high parts in halves, for Dekker's product */
    ${name}_real *b = i == 0 ? made.rate : made.turn, c = ${split}*b[0];

    b[2] = c - (c - b[0]); b[3] = b[0] - b[2];
    for (j = 0; j < 4; j++) b[j] = ${ldexp}(b[j], e); /* per second again */
  }
  n = ${fabs}(made.turn[0]) > made.rate[0] ? ${fabs}(made.turn[0]) : made.rate[0];
  made.last = n*${last_time} > ${last_turn} ? ${last_turn}/n : ${last_time};
  if (!(made.rate[0] - made.rate[0] == ${zero}) || !(made.turn[0] - made.turn[0] == ${zero})) return 1;

  /* the rates are over N^2, which is this at u = 0 */
  terms = ${name}_terms_of(&made, zero_phase, made.hyperbolic);
  n = ${name}_length2(&terms);
  for (i = 0; i < 3; i++) for (j = 0; j < 3; j++) {
    made.w[i][j] = ${ldexp}(n*made.scale[i]*p.b[i]*p.axis[i][j], e + (i < 2 ? p.small12 : 0));
  }
  /* q(t) = q0 (conj(y0) y(t)), the vector part of the second turned from principal to body axes */
  for (i = 0; i < 4; i++) for (j = 0; j < 4; j++) made.q[i][j] = i == j ? ${one} : ${zero};
  terms = ${name}_terms_of(&made, ${name}_reduce(&made, ${zero}), made.hyperbolic);
  ${name}_attitude_of(&made, &terms, y);
  turned = made.hyperbolic ? p.s : ${one}; /* of x and y */
  y[1] *= turned; y[2] *= turned;
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
%% if damped then
  made.decay = ${decay};
  if (!${name}_starts(&made)) return 1;
%% else
  /* Is it made of numbers?  Rates next to the end of the type's range overflow on the way to a state. */
  ${name}_state(&made, ${name}_reduce(&made, ${zero}), x);
  if (!${name}_numbers(x, ${upper}_NX)) return 1;
%% end
  ${name}_state(&made, farthest, x); /* near the separatrix the terms of the rates are largest half a flip away */
  if (!${name}_numbers(x, ${upper}_NX)) return 1;
  ${name}_copy(o, &made, (unsigned int)sizeof(made));
  return 0;
}
