%% -- states.c -- attitude and rates at times, from values of theta functions: part of scene.c.  SPDX-License-Identifier: MIT-0
${inline} ${name}_values ${name}_values_at(const ${name}_orbit *o, ${name}_real t)
{
  return o->hyperbolic ? ${name}_hyperbolic_values(o, ${name}_hyperbolic_phases(o, t)) :
                         ${name}_circular_values(o, ${name}_circular_phases(o, t));
}

void ${name}_at(const ${name}_orbit *o, ${name}_real t, ${name}_real x[])
{
  const ${name}_values v = ${name}_values_at(o, t);

  ${name}_put(o, &v, ${one}/${sqrt}(${name}_length2(&v)), x + ${upper}_QW, x + ${upper}_WX);
}

void ${name}_at_rates(const ${name}_orbit *o, ${name}_real t, ${name}_real w[])
{
  const ${name}_values v = ${name}_values_at(o, t);
  ${name}_real q[4];

  ${name}_put(o, &v, ${one}/${sqrt}(${name}_length2(&v)), q, w);
}

void ${name}_at_attitude(const ${name}_orbit *o, ${name}_real t, ${name}_real q[])
{
  const ${name}_values v = ${name}_values_at(o, t);
  ${name}_real w[3];

  ${name}_put(o, &v, ${one}/${sqrt}(${name}_length2(&v)), q, w);
}

/* Blocks of one vector of 512 bits: loops of a fixed count over local arrays, without calls or branches, are vectorised;
 * the roots stand alone, as they may set errno. */
enum { ${upper}_BLOCK = ${block} };

${inline} void ${name}_some(const ${name}_orbit *o, const ${name}_real t[], size_t n, ${name}_real x[])
{
  ${name}_real v[6][${upper}_BLOCK], state[7][${upper}_BLOCK], root[${upper}_BLOCK];

  for (size_t k = 0; k < ${upper}_BLOCK; k++) {
    const ${name}_values y = ${name}_circular_values(o, ${name}_circular_phases(o, t[k]));

    v[0][k] = y.w;
    v[1][k] = y.x;
    v[2][k] = y.y;
    v[3][k] = y.z;
    v[4][k] = y.f;
    v[5][k] = y.g;
    root[k] = ${name}_length2(&y);
  }
  for (size_t k = 0; k < ${upper}_BLOCK; k++) root[k] = ${sqrt}(root[k]);
  for (size_t k = 0; k < ${upper}_BLOCK; k++) {
    const ${name}_values y = {v[0][k], v[1][k], v[2][k], v[3][k], v[4][k], v[5][k]};
    ${name}_real q[4], w[3];

    ${name}_put(o, &y, ${one}/root[k], q, w);
    state[0][k] = q[0];
    state[1][k] = q[1];
    state[2][k] = q[2];
    state[3][k] = q[3];
    state[4][k] = w[0];
    state[5][k] = w[1];
    state[6][k] = w[2];
  }
  for (size_t i = 0; i < 4; i++) {
    for (size_t k = 0; k < ${upper}_BLOCK; k++) x[(${upper}_QW + i)*n + k] = state[i][k];
  }
  for (size_t i = 0; i < 3; i++) {
    for (size_t k = 0; k < ${upper}_BLOCK; k++) x[(${upper}_WX + i)*n + k] = state[4 + i][k];
  }
}

void ${name}_at_many(const ${name}_orbit *o, int n, const ${name}_real t[], ${name}_real x[])
{
  const size_t count = n > 0 ? (size_t)n : 0;
  ${name}_real y[${upper}_NX];
  size_t k = 0;

  if (!o->hyperbolic) {
    for (; k + ${upper}_BLOCK <= count; k += ${upper}_BLOCK) ${name}_some(o, t + k, count, x + k);
  }
  for (; k < count; k++) {
    ${name}_at(o, t[k], y);
    for (size_t i = 0; i < ${upper}_NX; i++) x[i*count + k] = y[i];
  }
}
