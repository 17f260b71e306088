%% -- integral.c -- exponentials, elliptic integrals and nomes in pairs: part of scene.c.  SPDX-License-Identifier: MIT-0
/* 2^e exp(x): x less a multiple of log 2, divided by 64, the series of exp - 1, and six doublings of exp(x) - 1 */
static ${name}_pair ${name}_pair_exp(${name}_pair x, int e)
{
  const ${name}_pair log2 = {${log2_high}, ${log2_low}};
  const ${name}_real n = ${floor}(x.hi/log2.hi + ${half});
  ${name}_pair y = ${name}_pair_scale(${name}_sub(x, ${name}_scaled(n, log2)), -6), s = ${name}_pair_of(${zero});

  if (!(n > -${n[1048576]})) return ${name}_pair_of(${zero}); /* below whatever e can make of it */
  for (int i = 12; i > 0; i--) { /* s = y/i (1 + s) */
    s = ${name}_mul(y, ${name}_add(${name}_pair_of(${one}), s));
    s = ${name}_ratio(s, ${name}_pair_of((${name}_real)i));
  }
  for (int i = 0; i < 6; i++) s = ${name}_add(${name}_pair_scale(s, 1), ${name}_mul(s, s));
  return ${name}_pair_scale(${name}_add(${name}_pair_of(${one}), s), (int)n + e);
}

/* cos x - 1 and sin x, |x| <= pi: the series at x/64 and six doublings */
static void ${name}_pair_circle(${name}_pair x, ${name}_pair *c1, ${name}_pair *s)
{
  const ${name}_pair y = ${name}_pair_scale(x, -6), y2 = ${name}_mul(y, y);
  ${name}_pair c = ${name}_pair_of(${zero}), d = ${name}_pair_of(${zero});

  for (int i = 16; i > 0; i -= 2) {
    c = ${name}_minus(${name}_mul(y2, ${name}_add(${name}_pair_of(${one}), c)));
    c = ${name}_ratio(c, ${name}_pair_of((${name}_real)(i*(i - 1))));
    d = ${name}_minus(${name}_mul(y2, ${name}_add(${name}_pair_of(${one}), d)));
    d = ${name}_ratio(d, ${name}_pair_of((${name}_real)(i*(i + 1))));
  }
  d = ${name}_mul(y, ${name}_add(${name}_pair_of(${one}), d));
  for (int i = 0; i < 6; i++) { /* cos 2x - 1 = -2 sin^2 x, sin 2x = 2 sin x (1 + (cos x - 1)) */
    const ${name}_pair square = ${name}_mul(d, d);

    d = ${name}_pair_scale(${name}_mul(d, ${name}_add(${name}_pair_of(${one}), c)), 1);
    c = ${name}_minus(${name}_pair_scale(square, 1));
  }
  *c1 = c;
  *s = d;
}

/* Carlson's R_F(x^2, y^2, z^2), at most one of x, y, z = 0: duplication (DLMF 19.26.18) until the three agree to 13 bits
 * (seven steps and some more if one is small: 40 cover every number), then the series of order 7 (DLMF 19.36.1). */
static ${name}_pair ${name}_carlson(${name}_pair x, ${name}_pair y, ${name}_pair z)
{
  ${name}_pair sum = ${name}_pair_of(${zero}), X, Y, Z, E2, E3, s;

  for (int i = 0; i < 40; i++) { /* some 8 times */
    const ${name}_pair xy = ${name}_mul(x, y);
    const ${name}_pair l = ${name}_add(xy, ${name}_mul(z, ${name}_add(x, y)));
    const ${name}_pair x2 = ${name}_pair_scale(${name}_add(${name}_mul(x, x), l), -2);
    const ${name}_pair y2 = ${name}_pair_scale(${name}_add(${name}_mul(y, y), l), -2);
    const ${name}_pair z2 = ${name}_pair_scale(${name}_add(${name}_mul(z, z), l), -2);

    sum = ${name}_add(${name}_add(x2, y2), z2);
    X = ${name}_sub(sum, ${name}_scaled(${n[3]}, x2));
    Y = ${name}_sub(sum, ${name}_scaled(${n[3]}, y2));
    Z = ${name}_sub(sum, ${name}_scaled(${n[3]}, z2));
    if (${fabs}(X.hi) + ${fabs}(Y.hi) + ${fabs}(Z.hi) <= ${carlson_close}*sum.hi) break;
    x = ${name}_pair_root(x2);
    y = ${name}_pair_root(y2);
    z = ${name}_pair_root(z2);
  }
  X = ${name}_ratio(X, sum);
  Y = ${name}_ratio(Y, sum);
  Z = ${name}_ratio(Z, sum);
  E2 = ${name}_mul(X, Y);
  E3 = ${name}_mul(E2, Z);
  E2 = ${name}_sub(E2, ${name}_mul(Z, Z));
  /* 1 - E2/10 + E3/14 + E2^2/24 - 3 E2 E3/44 - 5 E2^3/208 + 3 E3^2/104 + E2^2 E3/16; only the first two corrections
   * need more than the working precision */
  s = ${name}_pair_of(E2.hi*E2.hi/${n[24]} - ${n[3]}*E2.hi*E3.hi/${n[44]}
               + E2.hi*E2.hi*(E3.hi/${n[16]} - ${n[5]}*E2.hi/${n[208]}) + ${n[3]}*E3.hi*E3.hi/${n[104]});
  s = ${name}_add(s, ${name}_ratio(E3, ${name}_pair_of(${n[14]})));
  s = ${name}_sub(s, ${name}_ratio(E2, ${name}_pair_of(${n[10]})));
  s = ${name}_add(${name}_pair_of(${one}), s);
  return ${name}_ratio(s, ${name}_pair_root(${name}_ratio(sum, ${name}_pair_of(${n[3]}))));
}

/* The nome of modulus k from k^2 = m 2^power <= 0.51, k'^2 = mc: eps = (1 - sqrt k')/(2 (1 + sqrt k')),
 * q = eps + 2 eps^5 + 15 eps^9 + ... (DLMF 19.5.6, 22.20; integers: OEIS A002103), with 1 - sqrt k' = k^2 over two
 * factors.  Comes as a mantissa of the same power. */
static ${name}_pair ${name}_nome_of(${name}_pair m, ${name}_pair mc, int power)
{
  const ${name}_real series[9] = {${one}, ${n[2]}, ${n[15]}, ${n[150]}, ${n[1707]}, ${n[20910]}, ${n[268616]},
                                  ${n[3567400]}, ${n[48555069]}};
  const ${name}_pair k = ${name}_pair_root(mc), root = ${name}_pair_root(k), first = ${name}_add(${name}_pair_of(${one}), k);
  const ${name}_pair second = ${name}_add(${name}_pair_of(${one}), root);
  const ${name}_pair eps = ${name}_ratio(${name}_pair_scale(m, -1), ${name}_mul(first, ${name}_mul(second, second)));
  const ${name}_pair e2 = ${name}_pair_scale(${name}_mul(eps, eps), 2*power), e4 = ${name}_mul(e2, e2);
  ${name}_pair sum = ${name}_pair_of(series[8]);

  for (int i = 7; i >= 0; i--) sum = ${name}_add(${name}_pair_of(series[i]), ${name}_mul(sum, e4));
  return ${name}_mul(eps, sum);
}

/* pi/2 theta3(0; q)^2 = K (DLMF 22.2.2), q <= 0.044 */
static ${name}_pair ${name}_complete(${name}_pair q)
{
  const ${name}_pair q2 = ${name}_mul(q, q), q3 = ${name}_mul(q2, q), q5 = ${name}_mul(q3, q2);
  ${name}_pair t = ${name}_mul(q5, ${name}_add(${name}_pair_of(${one}), ${name}_mul(${name}_mul(q5, q2),
      ${name}_add(${name}_pair_of(${one}), ${name}_mul(${name}_mul(q5, q3), q)))));

  t = ${name}_mul(q, ${name}_add(${name}_pair_of(${one}), ${name}_mul(q3, ${name}_add(${name}_pair_of(${one}), t))));
  t = ${name}_add(${name}_pair_of(${one}), ${name}_pair_scale(t, 1));
  return ${name}_pair_scale(${name}_mul(${name}_pair_pi, ${name}_mul(t, t)), -1);
}

/* exp(x) - 1, 0 <= x <= 1: the series at x/64 and six doublings */
static ${name}_pair ${name}_pair_expm1(${name}_pair x)
{
  const ${name}_pair y = ${name}_pair_scale(x, -6), one = ${name}_pair_of(${one});
  ${name}_pair s = ${name}_pair_of(${zero});

  for (int i = 12; i > 0; i--) s = ${name}_ratio(${name}_mul(y, ${name}_add(one, s)), ${name}_pair_of((${name}_real)i));
  for (int i = 0; i < 6; i++) s = ${name}_add(${name}_pair_scale(s, 1), ${name}_mul(s, s));
  return s;
}
