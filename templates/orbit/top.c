%% -- top.c -- the closed form of the free top, any moments, any state: part of scene.c.  SPDX-License-Identifier: MIT-0
/* ---- closed form: ${theorem} ----
 *
 * Axes 1, 2, 3 here are principal axes: 2 that of the middle moment, 3 the one about which L circulates, signed so that
 * L1 >= 0, L3 > 0.  With a = w + i z, b = x + i y of the quaternion from these axes to a frame whose z axis is along L,
 *     a(t) = exp(i mu t) theta4(z - i s eta; p)/N,   b(t) = s exp(i mu t) theta1(z - i s eta; p)/N,   z = pi u/(2 K)
 * where u = lambda t + u0 is the argument of Jacobi's functions, L = (B1 cn u, s B2 sn u, B3 dn u), and p = q^2
 * (Jacobi 1849; Whittaker, Analytical Dynamics, section 69).  Near the separatrix the imaginary transformation
 * (DLMF 20.7.30-33) replaces z by V = kappa z, kappa = K/(2 K'), and circular functions by hyperbolic ones. */

/* What is known of the motion in principal axes.  [i] is axis i + 1 of the above.  Moments and rates are scaled by powers
 * of two, the largest to about 1, rates to 2^${rate_spare} at most.  What may be tiny together is scaled once more, so that
 * nothing underflows that matters: w1 and w2 by up12 = 1/down12, w1 and w3 by up13 = 1/down13, and the least moment with the
 * difference of the other two, which is no larger, by 1/small: so I1 and |I3 - I2| if s = 1, I3 and |I2 - I1| if s = -1.
%% if has_rod then
 * They come as J1, J3, d32 and d21; of a rod about axis 3 it is 1 and 0. */
%% else
 * They come as J1, J3, d32 and d21. */
%% end
typedef struct ${name}_top {
  ${name}_pair I[3], J[3];              /* moments: as they are, scaled */
  ${name}_pair w[3];                    /* rates at t = 0 */
  ${name}_pair d21, d31, d32;           /* |I2 - I1|, |I3 - I1|, |I3 - I2| */
  ${name}_pair D;                       /* |G^2 - 2 T I2| over the scales of w1^2, w3^2 and the least moment */
  ${name}_pair cross;                   /* sqrt(J1 I2 d31 d32) */
  ${name}_pair part1, part2, Delta3;    /* J1 d31 w1^2, I2 d32 w2^2 of the scaled w1, w2, and their sum */
  ${name}_pair Lambda1;                 /* J3 d31 w3^2 + I1 d21 w2^2 */
  ${name}_pair k2, kc2;                 /* k^2 up12^2, (1 - k^2) up13^2 */
  ${name}_pair b3, lambda;              /* amplitude of w3; rate of u */
  ${name}_pair T, climb;                /* at u = 0: tan(angle(L, axis 3)/2) up12; twice the rate of a's phase */
  ${name}_real b[3];                    /* amplitudes of the rates, b[0], b[1] up12 */
  ${name}_real axis[3][3];              /* unit vectors, body axes */
  ${name}_real s;                       /* sign of I3 - I1 */
  ${name}_real up12, down12, up13, down13, small;
  int small12, small13, e;      /* exponents of down12, down13; per second is times 2^e */
} ${name}_top;

/* the exponent of the larger of two numbers, if its power of two is one */
static int ${name}_exponent(${name}_real a, ${name}_real b)
{
  int e;
  (void)${frexp}(${fabs}(a) > ${fabs}(b) ? a : b, &e);
  return e < -${pair_top} ? -${pair_top} : e;
}

/* e[0..n) += I w^2 (d.hi + d.lo), without rounding; the new n */
static int ${name}_exact_term(${name}_real e[], int n, ${name}_real I, ${name}_real w, ${name}_pair d)
{
  const ${name}_pair square = ${name}_pair_product(w, w);
  ${name}_real energy[4];
  const int count = ${name}_exact_product(energy, ${name}_exact_product(energy, 0, square.lo, I), square.hi, I);
  for (int i = 0; i < count; i++) {
    n = ${name}_exact_product(e, n, energy[i], d.hi);
    n = ${name}_exact_product(e, n, energy[i], d.lo);
  }
  return n;
}

/* I w^2 d */
static ${name}_pair ${name}_square_term(${name}_pair I, ${name}_pair w, ${name}_pair d)
{
  return ${name}_mul(${name}_mul(I, d), ${name}_mul(w, w));
}

/* I3 w3^2 (I3 - I2) - I1 w1^2 (I2 - I1) = G^2 - 2 T I2: its sign says about which axis L circulates.  Where the terms
%% if diagonal then
 * cancel by more than three bits, without rounding: moments and rates are single numbers. */
%% else
 * cancel by more than three bits, without rounding if the moments and rates are single numbers. */
%% end
static ${name}_pair ${name}_circulation(${name}_pair I1, ${name}_pair I3, ${name}_pair w1, ${name}_pair w3, ${name}_pair d21, ${name}_pair d32)
{
  const ${name}_pair last = ${name}_square_term(I3, w3, d32), first = ${name}_square_term(I1, w1, d21);
  ${name}_pair sum = ${name}_sub(last, first);

%% if not diagonal then
  if (${fabs}(I1.lo) + ${fabs}(I3.lo) + ${fabs}(w1.lo) + ${fabs}(w3.lo) > ${zero}) return sum;
%% end
  if (${eight}*${fabs}(sum.hi) < first.hi + last.hi) { /* rare */
    ${name}_real e[32];
    int n = ${name}_exact_term(e, 0, I3.hi, w3.hi, d32);
    n = ${name}_exact_term(e, n, I1.hi, w1.hi, ${name}_minus(d21));
    sum = ${name}_pair_of(${zero});
    while (n > 0) sum = ${name}_add(sum, ${name}_pair_of(e[--n]));
  }
  return sum;
}

/* Labels and signs of the axes; `order` sorts moments of I, ascending. */
%% if diagonal then
static void ${name}_label(${name}_top *p, const ${name}_pair I[3], const ${name}_pair w[3], const int order[3])
%% else
static void ${name}_label(${name}_top *p, const ${name}_pair I[3], const ${name}_pair w[3], const ${name}_pair axis[3][3], const int order[3])
%% end
{
%% if has_rod then
  const int small = order[0], middle = order[1], large = order[2], rod = !(I[small].hi > ${zero});
%% else
  const int small = order[0], middle = order[1], large = order[2];
%% end
  const ${name}_real down = ${ldexp}(${one}, ${name}_exponent(I[small].hi, ${zero})), up = ${one}/down;
%% if has_rod then
  const ${name}_pair low = ${name}_sub(I[middle], I[small]), least = rod ? ${name}_pair_of(${one}) : ${name}_shift(up, I[small]);
  const ${name}_pair high = rod ? ${name}_pair_of(${zero}) : ${name}_shift(up, ${name}_sub(I[large], I[middle]));
%% else
  const ${name}_pair low = ${name}_sub(I[middle], I[small]), least = ${name}_shift(up, I[small]);
  const ${name}_pair high = ${name}_shift(up, ${name}_sub(I[large], I[middle]));
%% end

  p->small = down;
  p->small13 = ${name}_exponent(w[small].hi, w[large].hi);
  p->down13 = ${ldexp}(${one}, p->small13); p->up13 = ${one}/p->down13;
  p->D = ${name}_circulation(least, I[large], ${name}_shift(p->up13, w[small]), ${name}_shift(p->up13, w[large]), low, high);
  /* D may have underflowed: w1 of an axis of symmetry */
%% if has_rod then
  const int reverse = rod || p->D.hi < ${zero} || !(high.hi > ${zero});
%% else
  const int reverse = p->D.hi < ${zero} || !(high.hi > ${zero});
%% end
  const int own[3] = {reverse ? large : small, middle, reverse ? small : large};
  if (reverse) p->D = ${name}_minus(p->D);
  p->s = reverse ? -${one} : ${one};
  p->d21 = reverse ? high : low; p->d32 = reverse ? low : high;
  p->d31 = ${name}_add(low, ${name}_shift(down, high)); /* of nearly equal pairs two differences have digits */
  const ${name}_real first = w[own[0]].hi < ${zero} ? -${one} : ${one}, last = w[own[2]].hi < ${zero} ? -${one} : ${one};
  const ${name}_real sign[3] = {first, own[1] == (own[0] + 1) % 3 ? first*last : -first*last, last}; /* right-handed */
  for (int i = 0; i < 3; i++) {
    p->I[i] = I[own[i]];
    p->J[i] = own[i] == small ? least : I[own[i]];
    p->w[i] = ${name}_shift(sign[i], w[own[i]]);
%% if diagonal then
    for (int j = 0; j < 3; j++) p->axis[i][j] = sign[i]*(own[i] == j ? ${one} : ${zero});
%% else
    for (int j = 0; j < 3; j++) p->axis[i][j] = sign[i]*axis[own[i]][j].hi;
%% end
  }
}

/* amplitudes, rate and modulus: sums of terms of one sign */
static void ${name}_invariants(${name}_top *p)
{
  const ${name}_real unit = p->s > ${zero} ? p->small : ${one}; /* what J1 and d32 are over */
  p->small12 = ${name}_exponent(p->w[0].hi, p->w[1].hi);
  p->down12 = ${ldexp}(${one}, p->small12); p->up12 = ${one}/p->down12;
  const ${name}_pair w1 = ${name}_shift(p->up12, p->w[0]), w2 = ${name}_shift(p->up12, p->w[1]);
  const ${name}_pair first = ${name}_mul(p->J[0], p->d31), second = ${name}_mul(p->I[1], p->d32);
  p->cross = ${name}_pair_root(${name}_mul(first, second));
  p->part1 = ${name}_mul(first, ${name}_mul(w1, w1)); p->part2 = ${name}_mul(second, ${name}_mul(w2, w2));
  p->Delta3 = ${name}_add(p->part1, p->part2);
  if (p->d21.hi > ${zero}) {
    const ${name}_pair third = ${name}_mul(p->J[2], p->d31);
    p->Lambda1 = ${name}_add(${name}_square_term(p->I[1], p->w[1], p->d21), ${name}_mul(third, ${name}_mul(p->w[2], p->w[2])));
    p->b3 = ${name}_pair_root(${name}_ratio(p->Lambda1, third));
    p->k2 = ${name}_ratio(${name}_mul(p->d21, p->Delta3), ${name}_mul(p->d32, p->Lambda1));
    p->kc2 = ${name}_ratio(${name}_mul(p->d31, p->D), ${name}_mul(p->d32, p->Lambda1));
  } else { /* symmetric about axis 3: w3 is constant, however small, and k = 0 */
    p->b3 = p->w[2];
    p->k2 = ${name}_pair_of(${zero}); p->kc2 = ${name}_pair_of(${one});
    p->small13 = 0; p->down13 = p->up13 = ${one};
  }
  p->lambda = ${name}_ratio(${name}_mul(p->b3, p->cross), ${name}_mul(p->J[0], p->I[1]));

  /* at u = 0, where L = (B1, 0, B3): tan = B1/(|L| + B3); the phase of a turns at (w3 + w1 tan)/2 */
  ${name}_pair L2 = ${name}_pair_of(${zero});
  for (int i = 0; i < 3; i++) {
    const ${name}_pair L = ${name}_mul(p->I[i], p->w[i]);
    L2 = ${name}_add(L2, ${name}_mul(L, L));
  }
  const ${name}_pair g = ${name}_add(${name}_pair_root(L2), ${name}_mul(p->I[2], p->b3));
  const ${name}_pair square = ${name}_ratio(p->Delta3, p->d31); /* B1^2/I1 */
  p->T = ${name}_ratio(${name}_pair_root(${name}_shift(unit, ${name}_mul(p->I[0], square))), g);
  p->climb = ${name}_add(p->b3, ${name}_shift(unit, ${name}_shift(p->down12, ${name}_shift(p->down12, ${name}_ratio(square, g)))));
  p->b[0] = ${sqrt}(square.hi/p->J[0].hi); p->b[1] = ${sqrt}(p->Delta3.hi/second.hi); p->b[2] = p->b3.hi;
}

/* turns or periods as such per second: high + low, and high in halves (${name}_passed) */
static void per_second(const ${name}_top *p, ${name}_pair turns, ${name}_real out[4])
{
  const ${name}_real c = ${split}*turns.hi, high = c - (c - turns.hi);
  out[0] = ${ldexp}(turns.hi, p->e); out[1] = ${ldexp}(turns.lo, p->e);
  out[2] = ${ldexp}(high, p->e); out[3] = ${ldexp}(turns.hi - high, p->e);
}
