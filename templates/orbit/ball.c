%% -- ball.c -- a ball that rolls on a level plane at rest: part of scene.c.  SPDX-License-Identifier: MIT-0
/* ---- closed form: ${theorem} ---- */

int ${name}_solve(${name}_orbit *o, const ${name}_model *m, const ${name}_real x0[])
{
  const ${name}_real *w = x0 + ${upper}_WX;
  const ${name}_real e[3][3] = {{${a1}, ${a2}, ${a3}}, {${b1}, ${b2}, ${b3}}, {${n1}, ${n2}, ${n3}}};
  const ${name}_real R = ${R};
  ${name}_pair rate[3];
  ${name}_real left[4] = {${zero}, ${zero}, ${zero}, ${zero}}, along[3];
  ${name}_orbit p;

%% if uses_model then
%% else
  (void)m; /* every constant is in the code */
%% end
  if (!${name}_numbers(x0, ${upper}_NX)) return 1;
  for (int i = 0; i < 3; i++) {
    p.w[i] = w[i];
    rate[i] = ${name}_pair_of(w[i]);
  }
  ${name}_half_turns(${name}_unit_vector(rate, left + 1), p.about);
  if (!(p.about[3] - p.about[3] == ${zero})) return 1; /* |w| is beyond the range of the type */
  p.last = p.about[0]*${last_time} > ${last_turn} ? ${last_turn}/p.about[0] : ${last_time};

  if (${name}_spin(x0, e, p.q[0], along) == ${zero}) return 1;
  ${name}_quaternion_product(p.q[0], left, p.q[1]);

  /* V = R W x n, W x n = (W.e2) e1 - (W.e1) e2 */
  p.v[0] = R*along[1];
  p.v[1] = -R*along[0];
  for (int i = 0; i < 2; i++) p.p[i] = x0[${upper}_P1 + i];
  if (!(p.v[0] - p.v[0] == ${zero} && p.v[1] - p.v[1] == ${zero}) || !${name}_starts(&p)) return 1;
  ${name}_copy(o, &p, (unsigned int)sizeof(p));
  return 0;
}

void ${name}_at(const ${name}_orbit *o, ${name}_real t, ${name}_real x[])
{
  ${name}_real s, c, n, *q = x + ${upper}_QW;

  ${name}_circle(${name}_phase(o, o->about, t), &s, &c);
  for (int i = 0; i < 4; i++) q[i] = c*o->q[0][i] + s*o->q[1][i];
  n = ${threehalves} - ${half}*((q[0]*q[0] + q[1]*q[1]) + (q[2]*q[2] + q[3]*q[3])); /* one Newton step for 1/|q| */
  for (int i = 0; i < 4; i++) q[i] *= n;
  for (int i = 0; i < 3; i++) x[${upper}_WX + i] = o->w[i];
  for (int i = 0; i < 2; i++) x[${upper}_P1 + i] = o->p[i] + t*o->v[i];
}

void ${name}_at_many(const ${name}_orbit *o, int n, const ${name}_real t[], ${name}_real x[])
{
  ${name}_real y[${upper}_NX];

  for (int k = 0; k < n; k++) {
    ${name}_at(o, t[k], y);
    for (int i = 0; i < ${upper}_NX; i++) x[i*n + k] = y[i];
  }
}
