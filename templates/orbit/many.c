%% -- many.c -- the free top's state at many times: part of scene.c.  SPDX-License-Identifier: MIT-0
/* ---- many times at once, in blocks of one vector of 512 bits ----
 * Loops of a fixed count over local arrays, without calls or branches: GCC and Clang vectorise them as they are, GCC at -O2
 * too.  The roots have a loop of their own, the only one that stays scalar where a root may set errno.  (One comparison is
 * left nearest to the separatrix, `hyperbolic` = 2, for which GCC wants -O3.) */
enum { ${upper}_BLOCK = ${block} };

${inline} void ${name}_block(const ${name}_orbit *o, int hyperbolic, const ${name}_real t[], size_t n, ${name}_real x[])
{
  ${name}_real q[4][${upper}_BLOCK], w[3][${upper}_BLOCK], inverse[${upper}_BLOCK], root[${upper}_BLOCK];

  for (size_t k = 0; k < ${upper}_BLOCK; k++) {
    const ${name}_thetas y = ${name}_terms_of(o, ${name}_reduce(o, t[k]), hyperbolic);
    ${name}_real v[4], r[3];

    inverse[k] = ${one}/${name}_length2(&y);
    ${name}_rates_of(o, &y, inverse[k], r);
    w[0][k] = r[0];
    w[1][k] = r[1];
    w[2][k] = r[2];
    ${name}_attitude_of(o, &y, v);
    q[0][k] = v[0];
    q[1][k] = v[1];
    q[2][k] = v[2];
    q[3][k] = v[3];
  }
  for (size_t k = 0; k < ${upper}_BLOCK; k++) root[k] = ${sqrt}(inverse[k]);
  for (size_t k = 0; k < ${upper}_BLOCK; k++) {
    const ${name}_real v[4] = {q[0][k], q[1][k], q[2][k], q[3][k]};

    root[k] = ${name}_inverse_length(v, inverse[k], root[k]);
  }
  for (size_t i = 0; i < 4; i++) {
    for (size_t k = 0; k < ${upper}_BLOCK; k++) x[(${upper}_QW + i)*n + k] = root[k]*q[i][k];
  }
  for (size_t i = 0; i < 3; i++) {
    for (size_t k = 0; k < ${upper}_BLOCK; k++) x[(${upper}_WX + i)*n + k] = w[i][k];
  }
}

/* all of at least one block; the last two may overlap */
${inline} void ${name}_blocks(const ${name}_orbit *o, int hyperbolic, size_t n, const ${name}_real t[], ${name}_real x[])
{
  size_t k = 0;

  for (; k + ${upper}_BLOCK <= n; k += ${upper}_BLOCK) ${name}_block(o, hyperbolic, t + k, n, x + k);
  if (k < n) ${name}_block(o, hyperbolic, t + n - ${upper}_BLOCK, n, x + n - ${upper}_BLOCK);
}

void ${name}_at_many(const ${name}_orbit *o, int n, const ${name}_real t[], ${name}_real x[])
{
  ${name}_real y[${upper}_NX];

  if (n >= ${upper}_BLOCK) {
    if (o->hyperbolic == 0) ${name}_blocks(o, 0, (size_t)n, t, x);
    else if (o->hyperbolic == 1) ${name}_blocks(o, 1, (size_t)n, t, x);
    else ${name}_blocks(o, 2, (size_t)n, t, x);
    return;
  }
  for (int k = 0; k < n; k++) {
    ${name}_at(o, t[k], y);
    for (int i = 0; i < ${upper}_NX; i++) x[i*n + k] = y[i];
  }
}
