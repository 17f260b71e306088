/* free_top.c - the free top to 50 digits and more: the oracle for measurements.
   SPDX-License-Identifier: GPL-3.0-or-later

     free_top [-b BITS] [-e | -p]

   Reads lines of numbers (decimal or hexadecimal, taken exactly as doubles): the tensor xx yy zz xy
   xz yz, the rates w0, the attitude q0, the time t. Prints the rates and the attitude with 40
   digits. With -e each line goes on with seven numbers, the rates and attitude of somebody else,
   and what is printed is how far they are off: rates relative to the largest of them, attitude as
   |q - q'| (signs count); then the largest error of a component relative to itself, of the rates
   and of q. With -p it prints the period of the rates (inf: none, 0: constant) and the mean rate of
   the precession about L.

   The formulas are the textbook's (Landau and Lifshitz, Mechanics, 37; Whittaker, Analytical
   Dynamics, 69), written as they stand: amplitude by the descending Landen transformation (DLMF
   22.20), precession as L t / I3 plus a multiple of Legendre's Pi by Carlson's duplication (DLMF
   19.36). They cancel where they like: of 1280 bits a rod of 1e-12 over 1e27 s loses 200, a saddle
   within 1e-100 of its axis some 700. */
#include <mpfr.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- numbers in a pool that is emptied after each line ---- */

typedef mpfr_ptr num;

enum { POOL = 1 << 18 };
static mpfr_t *pool;
static int used, made;
static mpfr_prec_t bits = 1280;

static num fresh(void) {
  if (used == POOL) {
    fprintf(stderr, "free_top: a loop does not end\n");
    exit(2);
  }
  if (used == made)
    mpfr_init2(pool[made++], bits);
  return pool[used++];
}

#define TWO(name, f)                                                                               \
  static num name(num a, num b) {                                                                  \
    num r = fresh();                                                                               \
    f(r, a, b, MPFR_RNDN);                                                                         \
    return r;                                                                                      \
  }
#define ONE(name, f)                                                                               \
  static num name(num a) {                                                                         \
    num r = fresh();                                                                               \
    f(r, a, MPFR_RNDN);                                                                            \
    return r;                                                                                      \
  }
TWO(add, mpfr_add)
TWO(sub, mpfr_sub)
TWO(mul, mpfr_mul)
TWO(over, mpfr_div)
TWO(angle_of, mpfr_atan2)
ONE(root, mpfr_sqrt)
ONE(negative, mpfr_neg)
ONE(size, mpfr_abs)
ONE(sine, mpfr_sin)
ONE(cosine, mpfr_cos)
ONE(arcsine, mpfr_asin)
ONE(arctangent, mpfr_atan)
ONE(areatangent, mpfr_atanh)
ONE(areasine, mpfr_asinh)
ONE(tangent_h, mpfr_tanh)
ONE(secant_h, mpfr_sech)

static num real(double v) {
  num r = fresh();
  mpfr_set_d(r, v, MPFR_RNDN);
  return r;
}

static num pi_times(double v) {
  num r = fresh();
  mpfr_const_pi(r, MPFR_RNDN);
  return mul(r, real(v));
}

static int sign(num a) {
  return mpfr_sgn(a);
}

static num square(num a) {
  return mul(a, a);
}

static num times(double k, num a) {
  return mul(real(k), a);
}

/* ---- Carlson's integrals ---- */

/* |a| < 2^-n |b| */
static int below(num a, num b, long n) {
  return sign(a) == 0 || (sign(b) != 0 && mpfr_get_exp(a) < mpfr_get_exp(b) - n);
}

/* R_C(1, 1 + e) */
static num rc(num e) {
  if (below(e, real(1), (long)bits))
    return real(1);
  num z = root(size(e));
  return over(sign(e) > 0 ? arctangent(z) : areatangent(z), z);
}

/* *third = R_J(x, y, z, p), result R_F(x, y, z): duplication until nothing is left to be expanded,
   R_J -> A^(-3/2), R_F -> A^(-1/2). */
static num rf_rj(num x, num y, num z, num p, num *third) {
  num sum = real(0), weight = real(1), v[4] = {x, y, z, p};
  for (;;) {
    num mean = over(add(add(v[0], v[1]), add(v[2], add(v[3], v[3]))), real(5));
    int close = 1;
    for (int i = 0; i < 4; i++)
      close = close && below(sub(v[i], mean), mean, (long)bits / 2); /* error: its square */
    if (close) {
      num three = over(add(add(v[0], v[1]), v[2]), real(3));
      *third = add(over(weight, mul(mean, root(mean))), times(6, sum));
      return over(real(1), root(three));
    }
    num r[4];
    for (int i = 0; i < 4; i++)
      r[i] = root(v[i]);
    num step = add(add(mul(r[0], r[1]), mul(r[0], r[2])), mul(r[1], r[2]));
    num d = mul(mul(add(r[3], r[0]), add(r[3], r[1])), add(r[3], r[2]));
    num e = over(mul(mul(sub(v[3], v[0]), sub(v[3], v[1])), sub(v[3], v[2])), square(d));
    sum = add(sum, mul(over(weight, d), rc(e)));
    weight = over(weight, real(4));
    for (int i = 0; i < 4; i++)
      v[i] = over(add(v[i], step), real(4));
  }
}

/* F and Pi(-nu) of sine s and cosine c, |angle| <= pi/2. */
static num legendre(num s, num c, num mc, num nu, num *third) {
  num s2 = square(s), c2 = square(c), rj;
  num rf = rf_rj(c2, add(c2, mul(mc, s2)), real(1), add(real(1), mul(nu, s2)), &rj);
  num first = mul(s, rf);
  *third = sub(first, mul(over(nu, real(3)), mul(mul(s, s2), rj)));
  return first;
}

/* Amplitude, any u: phi_N = 2^N a_N u, 2 phi_(n-1) = phi_n + asin(c_n / a_n sin phi_n). */
static num amplitude(num u, num kc) {
  enum { STEPS = 64 };
  num ratio[STEPS], a = real(1), b = kc;
  int n = 0;
  while (n < STEPS - 1 && !below(sub(a, b), a, (long)bits - 8)) {
    num next = over(add(a, b), real(2));
    ratio[++n] = over(over(sub(a, b), real(2)), next);
    b = root(mul(a, b));
    a = next;
  }
  num phi = mul(u, a);
  for (int i = 0; i < n; i++)
    phi = add(phi, phi);
  for (; n > 0; n--)
    phi = over(add(phi, arcsine(mul(ratio[n], sine(phi)))), real(2));
  return phi;
}

/* ---- quaternions and axes ---- */

static void quat_multiply(num a[4], num b[4], num out[4]) {
  static const int at[4][4] = {{0, 1, 2, 3}, {1, 0, 3, 2}, {2, 3, 0, 1}, {3, 2, 1, 0}};
  static const int minus[4][4] = {{0, 1, 1, 1}, {0, 0, 0, 1}, {0, 1, 0, 0}, {0, 0, 1, 0}};
  num sum[4];
  for (int i = 0; i < 4; i++) {
    sum[i] = real(0);
    for (int k = 0; k < 4; k++) {
      num t = mul(a[k], b[at[i][k]]);
      sum[i] = minus[i][k] ? sub(sum[i], t) : add(sum[i], t);
    }
  }
  memcpy(out, sum, sizeof sum);
}

static void conjugate(num q[4], num out[4]) {
  out[0] = q[0];
  for (int i = 1; i < 4; i++)
    out[i] = negative(q[i]);
}

/* e_i, e_2, e_3 -> axis[0], axis[1], axis[2] */
static void quat_of_axes(num axis[3][3], num q[4]) {
  num d[3] = {axis[0][0], axis[1][1], axis[2][2]}, row[4][4];
  for (int r = 0; r < 4; r++) { /* 4 q_r q */
    row[r][r] = real(1);
    for (int i = 0; i < 3; i++)
      row[r][r] = r == 0 || r == i + 1 ? add(row[r][r], d[i]) : sub(row[r][r], d[i]);
  }
  for (int i = 0; i < 3; i++) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    row[0][1 + i] = row[1 + i][0] = sub(axis[j][k], axis[k][j]);
    row[1 + j][1 + k] = row[1 + k][1 + j] = add(axis[j][k], axis[k][j]);
  }
  int best = 0;
  for (int r = 1; r < 4; r++)
    if (mpfr_cmp(row[r][r], row[best][best]) > 0)
      best = r;
  num n = real(0);
  for (int i = 0; i < 4; i++)
    n = add(n, square(row[best][i]));
  for (int i = 0; i < 4; i++)
    q[i] = over(row[best][i], root(n));
}

/* Jacobi's rotations; axis[k] with moment a[k][k]. */
static void principal(num a[3][3], num axis[3][3]) {
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++)
      axis[i][j] = real(i == j);
  for (int sweep = 0; sweep < 40; sweep++)
    for (int p = 0; p < 2; p++)
      for (int q = p + 1; q < 3; q++) {
        if (sign(a[p][q]) == 0 ||
            (below(a[p][q], a[p][p], (long)bits) && below(a[p][q], a[q][q], (long)bits)))
          continue;
        num theta = over(angle_of(times(2, a[p][q]), sub(a[p][p], a[q][q])), real(2));
        num c = cosine(theta), s = sine(theta);
        for (int i = 0; i < 3; i++) { /* columns, and the axes with them */
          num x = a[i][p], y = a[i][q];
          a[i][p] = add(mul(c, x), mul(s, y));
          a[i][q] = sub(mul(c, y), mul(s, x));
          x = axis[p][i], y = axis[q][i];
          axis[p][i] = add(mul(c, x), mul(s, y));
          axis[q][i] = sub(mul(c, y), mul(s, x));
        }
        for (int i = 0; i < 3; i++) { /* rows */
          num x = a[p][i], y = a[q][i];
          a[p][i] = add(mul(c, x), mul(s, y));
          a[q][i] = sub(mul(c, y), mul(s, x));
        }
        a[p][q] = a[q][p] = real(0);
      }
}

/* ---- the motion ---- */

typedef struct motion {
  int s, separatrix;
  num I[3], B[3], G, lambda, mc, kc, nu, u0, K, Pi;
} motion;

/* Euler's angles at u: psi goes on with the amplitude. w: the rates. */
static void at(const motion *f, num t, num w[3], num q[4]) {
  num u = add(mul(f->lambda, t), f->u0), sn, cn, dn, phi, psi;
  num fast = over(mul(f->G, t), f->I[f->separatrix ? 1 : 2]);
  if (f->separatrix) {
    sn = tangent_h(u), cn = dn = secant_h(u);
    phi = add(fast, times(f->s, arctangent(mul(root(f->nu), sn))));
    psi = angle_of(mul(f->B[0], cn), times(f->s, mul(f->B[1], sn)));
  } else {
    num am = amplitude(u, f->kc), turns = fresh(), part, rest;
    mpfr_rint(turns, over(am, pi_times(1)), MPFR_RNDN);
    rest = sub(am, mul(turns, pi_times(1)));
    sn = sine(rest), cn = cosine(rest);
    dn = root(add(square(cn), mul(f->mc, square(sn))));
    legendre(sn, cn, f->mc, f->nu, &part);
    part = add(part, mul(times(2, turns), f->Pi));
    num factor = over(mul(f->G, sub(f->I[2], f->I[0])), mul(f->lambda, mul(f->I[0], f->I[2])));
    phi = add(fast, mul(factor, part));
    psi = angle_of(mul(f->B[0], cn), times(f->s, mul(f->B[1], sn)));
    psi = sub(psi, times(f->s, mul(turns, pi_times(1))));
    num odd = fresh();
    mpfr_fmod(odd, turns, real(2), MPFR_RNDN);
    if (sign(odd) != 0)
      sn = negative(sn), cn = negative(cn);
  }
  num L[3] = {mul(f->B[0], cn), times(f->s, mul(f->B[1], sn)), mul(f->B[2], dn)};
  num across = root(add(square(L[0]), square(L[1]))), half = over(angle_of(across, L[2]), real(2));
  num plus = over(add(phi, psi), real(2)), minus = over(sub(phi, psi), real(2));
  q[0] = mul(cosine(half), cosine(plus)), q[3] = mul(cosine(half), sine(plus));
  q[1] = mul(sine(half), cosine(minus)), q[2] = mul(sine(half), sine(minus));
  for (int i = 0; i < 3; i++)
    w[i] = over(L[i], f->I[i]);
}

/* What -p prints. */
static num period, precession;

/* x[0..2] rates, x[3..6] attitude of the body whose rates stay. */
static void constant(num w[3], num q[4], num t, num x[7]) {
  num rate = root(add(add(square(w[0]), square(w[1])), square(w[2])));
  num half = over(mul(rate, t), real(2)), turn[4] = {cosine(half)};
  period = real(0), precession = rate;
  for (int i = 0; i < 3; i++) {
    turn[1 + i] = sign(rate) ? mul(sine(half), over(w[i], rate)) : real(0);
    x[i] = w[i];
  }
  quat_multiply(q, turn, x + 3);
}

/* Order of the axes (o[2] the one L circulates about), signs that make L1 >= 0 and L3 > 0. */
static void general(num I[3], num axis[3][3], num w[3], num q0[4], num t, num x[7]) {
  int o[3] = {0, 1, 2};
  for (int i = 1; i < 3; i++)
    for (int j = i; j > 0 && mpfr_cmp(I[o[j]], I[o[j - 1]]) < 0; j--) {
      const int k = o[j];
      o[j] = o[j - 1], o[j - 1] = k;
    }
  num side = sub(mul(mul(I[o[2]], sub(I[o[2]], I[o[1]])), square(w[o[2]])),
                 mul(mul(I[o[0]], sub(I[o[1]], I[o[0]])), square(w[o[0]])));
  motion f = {.s = sign(side) < 0 ? -1 : 1, .separatrix = sign(side) == 0};
  if (f.s < 0) {
    const int k = o[0];
    o[0] = o[2], o[2] = k;
  }
  num e[3][3], v[3], L[3];
  const int odd = (o[1] - o[0] + 3) % 3 == 2;
  const int flip1 = sign(w[o[0]]) < 0, flip3 = sign(w[o[2]]) < 0, flip2 = (flip1 + flip3 + odd) % 2;
  const int flip[3] = {flip1, flip2, flip3};
  f.G = real(0);
  for (int k = 0; k < 3; k++) {
    f.I[k] = I[o[k]];
    v[k] = flip[k] ? negative(w[o[k]]) : w[o[k]];
    L[k] = mul(f.I[k], v[k]);
    f.G = add(f.G, square(L[k]));
    for (int i = 0; i < 3; i++)
      e[k][i] = flip[k] ? negative(axis[o[k]][i]) : axis[o[k]][i];
  }
  num T2 = add(add(mul(L[0], v[0]), mul(L[1], v[1])), mul(L[2], v[2])), G2 = f.G;
  f.G = root(G2);
  num d31 = sub(f.I[2], f.I[0]), d32 = sub(f.I[2], f.I[1]), d21 = sub(f.I[1], f.I[0]);
  num a = sub(mul(T2, f.I[2]), G2), b = sub(G2, mul(T2, f.I[0]));
  f.B[0] = root(over(mul(f.I[0], a), d31));
  f.B[1] = root(over(mul(f.I[1], a), d32));
  f.B[2] = root(over(mul(f.I[2], b), d31));
  f.lambda = root(over(mul(d32, b), mul(mul(f.I[0], f.I[1]), f.I[2])));
  f.mc = size(over(mul(d31, side), mul(d32, b)));
  f.kc = root(f.mc);
  f.nu = over(mul(f.I[2], d21), mul(f.I[0], d32));
  num cn = over(L[0], f.B[0]), sn = times(f.s, over(L[1], f.B[1])), any;
  if (f.separatrix) {
    f.u0 = areasine(over(sn, cn));
    period = over(real(1), real(0)), precession = over(f.G, f.I[1]);
  } else {
    f.K = legendre(real(1), real(0), f.mc, f.nu, &f.Pi);
    f.u0 = legendre(sn, cn, f.mc, f.nu, &any);
    period = over(times(4, f.K), f.lambda);
    precession = over(mul(f.G, sub(f.I[2], f.I[0])), mul(f.K, mul(f.I[0], f.I[2])));
    precession = add(over(f.G, f.I[2]), mul(precession, f.Pi));
  }
  num p0[4], p[4], back[4], frame[4], body[4], none[3], rates[3];
  at(&f, real(0), none, p0);
  at(&f, t, rates, p);
  quat_of_axes(e, body);
  conjugate(p0, back);
  quat_multiply(q0, body, frame);
  quat_multiply(frame, back, frame);
  quat_multiply(frame, p, p);
  conjugate(body, back);
  quat_multiply(p, back, x + 3);
  for (int i = 0; i < 3; i++) {
    x[i] = real(0);
    for (int k = 0; k < 3; k++)
      x[i] = add(x[i], mul(rates[k], e[k][i]));
  }
}

static void solve(const double in[14], num x[7]) {
  static const int at_[3][3] = {{0, 3, 4}, {3, 1, 5}, {4, 5, 2}};
  num a[3][3], axis[3][3], I[3], body[3], w[3], q[4], n = real(0);
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++)
      a[i][j] = real(in[at_[i][j]]);
  principal(a, axis);
  for (int i = 0; i < 3; i++)
    body[i] = real(in[6 + i]);
  for (int k = 0; k < 3; k++) {
    I[k] = a[k][k];
    w[k] = add(add(mul(axis[k][0], body[0]), mul(axis[k][1], body[1])), mul(axis[k][2], body[2]));
  }
  for (int i = 0; i < 4; i++) {
    q[i] = real(in[9 + i]);
    n = add(n, square(q[i]));
  }
  for (int i = 0; i < 4; i++)
    q[i] = over(q[i], root(n));
  int still = 1;
  for (int k = 0; k < 3; k++) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    still = still && (mpfr_equal_p(I[i], I[j]) || sign(w[i]) == 0 || sign(w[j]) == 0);
  }
  if (still)
    constant(body, q, real(in[13]), x);
  else
    general(I, axis, w, q, real(in[13]), x);
}

/* The larger; what is no number is the largest of all. */
static num larger(num a, num b) {
  return mpfr_nan_p(a) || mpfr_cmp(a, b) > 0 ? a : b;
}

/* How far the seven numbers in text are from x: off[] as -e prints them. */
static int compare(num x[7], char *text, double off[4]) {
  num d[4] = {real(0), real(0), real(0), real(0)}, scale = real(0);
  for (int i = 0; i < 7; i++) {
    num v = fresh();
    char *end;
    if (mpfr_strtofr(v, text, &end, 0, MPFR_RNDN), end == text)
      return 0;
    text = end;
    num e = size(sub(v, x[i]));
    const int k = i < 3 ? 0 : 1;
    if (k == 0)
      scale = larger(size(x[i]), scale);
    d[k] = k == 0 ? larger(e, d[k]) : add(d[k], square(e));
    if (!mpfr_zero_p(e)) /* a component that ought to be 0 is infinitely wrong */
      d[2 + k] = larger(over(e, size(x[i])), d[2 + k]);
  }
  d[0] = sign(scale) ? over(d[0], scale) : d[0];
  d[1] = root(d[1]);
  for (int k = 0; k < 4; k++)
    off[k] = mpfr_get_d(d[k], MPFR_RNDN);
  return 1;
}

int main(int argc, char **argv) {
  static char line[4096];
  int errors = 0, periods = 0;
  for (int i = 1; i < argc; i++) {
    if (strcmp(argv[i], "-e") == 0) {
      errors = 1;
    } else if (strcmp(argv[i], "-p") == 0) {
      periods = 1;
    } else if (strcmp(argv[i], "-b") == 0 && i + 1 < argc && atoi(argv[i + 1]) >= 128) {
      bits = atoi(argv[++i]);
    } else {
      fprintf(stderr, "usage: free_top [-b BITS] [-e | -p] < lines\n");
      return 2;
    }
  }
  pool = malloc(POOL * sizeof *pool);
  if (!pool)
    return 2;
  while (fgets(line, sizeof line, stdin)) {
    double in[14], off[4];
    char *p = line, *end;
    for (int i = 0; i < 14; i++, p = end) {
      in[i] = strtod(p, &end);
      if (end == p) {
        fprintf(stderr, "free_top: number %d of a line is missing\n", i + 1);
        return 2;
      }
    }
    num x[7];
    used = 0;
    solve(in, x);
    if (periods) {
      mpfr_printf("%.40Re %.40Re\n", period, precession);
    } else if (!errors) {
      for (int i = 0; i < 7; i++)
        mpfr_printf(i < 6 ? "%.40Re " : "%.40Re\n", x[i]);
    } else if (compare(x, p, off)) {
      printf("%.3g %.3g %.3g %.3g\n", off[0], off[1], off[2], off[3]);
    } else {
      fprintf(stderr, "free_top: -e wants seven numbers after the time\n");
      return 2;
    }
  }
  for (int i = 0; i < made; i++)
    mpfr_clear(pool[i]);
  free(pool);
  mpfr_free_cache();
  return 0;
}
