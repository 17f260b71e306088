%% -- nome.c -- nome and complete integral of a modulus, in pairs: part of scene.c.  SPDX-License-Identifier: MIT-0
/* The nome of modulus k from k^2 = m 2^power <= 0.51, k'^2 = mc: eps = (1 - sqrt k')/(2 (1 + sqrt k')),
 * q = eps + 2 eps^5 + 15 eps^9 + ... (DLMF 19.5.6, 22.20; integers: OEIS A002103), with 1 - sqrt k' = k^2 over two
 * factors.  Comes as a mantissa of the same power. */
static ${name}_pair ${name}_nome(${name}_pair m, ${name}_pair mc, int power)
{
  const ${name}_real series[9] = {${one}, (${name}_real)2, (${name}_real)15, (${name}_real)150, (${name}_real)1707, (${name}_real)20910, (${name}_real)268616,
                                  (${name}_real)3567400, (${name}_real)48555069};
  const ${name}_pair k = ${name}_pair_root(mc), root = ${name}_pair_root(k), first = ${name}_pair_add(${name}_pair_of(${one}), k);
  const ${name}_pair second = ${name}_pair_add(${name}_pair_of(${one}), root);
  const ${name}_pair eps = ${name}_pair_divide(${name}_pair_scale(m, -1), ${name}_pair_multiply(first, ${name}_pair_multiply(second, second)));
  const ${name}_pair e2 = ${name}_pair_scale(${name}_pair_multiply(eps, eps), 2*power), e4 = ${name}_pair_multiply(e2, e2);
  ${name}_pair sum = ${name}_pair_of(series[8]);
  int i;

  for (i = 7; i >= 0; i--) sum = ${name}_pair_add(${name}_pair_of(series[i]), ${name}_pair_multiply(sum, e4));
  return ${name}_pair_multiply(eps, sum);
}

static ${name}_pair ${name}_pi(void)
{
  const ${name}_pair pi = {${pi_high}, ${pi_low}};

  return pi;
}

static ${name}_pair ${name}_log2(void)
{
  const ${name}_pair log2 = {${log2_high}, ${log2_low}};

  return log2;
}

static void ${name}_store(${name}_real out[2], ${name}_pair a)
{
  out[0] = a.hi;
  out[1] = a.lo;
}

/* pi/2 theta3(0; q)^2 = K (DLMF 22.2.2), q <= 0.044 */
static ${name}_pair ${name}_complete(${name}_pair q)
{
  const ${name}_pair q2 = ${name}_pair_multiply(q, q), q3 = ${name}_pair_multiply(q2, q), q5 = ${name}_pair_multiply(q3, q2);
  ${name}_pair t = ${name}_pair_multiply(q5, ${name}_pair_add(${name}_pair_of(${one}), ${name}_pair_multiply(${name}_pair_multiply(q5, q2),
      ${name}_pair_add(${name}_pair_of(${one}), ${name}_pair_multiply(${name}_pair_multiply(q5, q3), q)))));

  t = ${name}_pair_multiply(q, ${name}_pair_add(${name}_pair_of(${one}), ${name}_pair_multiply(q3, ${name}_pair_add(${name}_pair_of(${one}), t))));
  t = ${name}_pair_add(${name}_pair_of(${one}), ${name}_pair_scale(t, 1));
  return ${name}_pair_scale(${name}_pair_multiply(${name}_pi(), ${name}_pair_multiply(t, t)), -1);
}
