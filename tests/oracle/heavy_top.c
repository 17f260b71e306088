/* heavy_top.c - the heavy top with many digits: a Taylor series of high order with MPFR.
   SPDX-License-Identifier: GPL-3.0-or-later

     heavy_top [-b BITS] [-p] [-r] [-e] < lines

   A line is I1 I2 I3 (principal moments about the fixed point), m g r (3 numbers, body axes), w0
   (3), q0 (4, any length but 0), t, in any notation of strtod, taken as the exact doubles; gravity
   points along -z. A line of the result: rates and attitude, 7 numbers of 40 digits. With -e seven
   more numbers follow t in a line, and the result is: largest error of their rates over the largest
   rate, and of their attitude, |q - q'|.

     With -r the three numbers m g r are instead the momentum h of a rotor, relative to the body,
   and nothing else acts: I w' = (I w + h) x w.

     With -p an approximation of the period of gamma_z follows t: the body is symmetric about z, and
   t may be long.

     I w' = (I w) x w + gamma x (m g r),   gamma = R(q)^T ez,   gamma' = gamma x w,   q' = q (0,
   w)/2

   (Goldstein, Poole, Safko, 3rd ed., section 5.7). All are products of two, so each order of the
   series follows from those below by sums of products; gamma is a state of its own, and its length
   and its agreement with q are not used. The order follows the bits, and steps are so long that the
   last terms stand at 2^-BITS of the largest: nothing here knows of symmetry, roots or theta
   functions. Equal moments about two axes and no torque about the third leave w of that axis
   untouched, also where its moment is 0 (a rod). */
#include <mpfr.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { ORDER_MOST = 200, STATES = 10 };

static mpfr_prec_t bits = 256;
static int order = 80;

static mpfr_t x[STATES][ORDER_MOST + 1]; /* w, gamma, q: coefficients of (t - t0)^n */
static mpfr_t I[3], load[3], sum, term, h, left, largest, power;
static int rotor;    /* load is the momentum of a rotor */
static int still[3]; /* w of this axis is constant */

/* sum += s sum over k of a_k b_(n-k) */
static void convolve(int s, mpfr_t *a, mpfr_t *b, int n, mpfr_t total) {
  for (int k = 0; k <= n; k++) {
    mpfr_mul(term, a[k], b[n - k], MPFR_RNDN);
    if (s > 0)
      mpfr_add(total, total, term, MPFR_RNDN);
    else
      mpfr_sub(total, total, term, MPFR_RNDN);
  }
}

/* coefficients of order n + 1 from those up to n */
static void next_order(int n) {
  static mpfr_t part;
  static int made;
  if (!made)
    mpfr_init2(part, bits), made = 1;
  for (int i = 0; i < 3; i++) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    mpfr_set_zero(x[i][n + 1], 1);
    if (!still[i]) { /* I_i w_i' = (I_j - I_k) w_j w_k + gamma_j r_k - gamma_k r_j, -w_j h_k + w_k
                        h_j */
      mpfr_set_zero(part, 1);
      convolve(1, x[j], x[k], n, part);
      mpfr_sub(term, I[j], I[k], MPFR_RNDN);
      mpfr_mul(part, part, term, MPFR_RNDN);
      const int v = rotor ? 0 : 3;
      mpfr_mul(term, x[v + (rotor ? k : j)][n], load[rotor ? j : k], MPFR_RNDN);
      mpfr_add(part, part, term, MPFR_RNDN);
      mpfr_mul(term, x[v + (rotor ? j : k)][n], load[rotor ? k : j], MPFR_RNDN);
      mpfr_sub(part, part, term, MPFR_RNDN);
      mpfr_div(part, part, I[i], MPFR_RNDN);
      mpfr_div_si(x[i][n + 1], part, n + 1, MPFR_RNDN);
    }
    mpfr_set_zero(part, 1); /* gamma x w */
    convolve(1, x[3 + j], x[k], n, part);
    convolve(-1, x[3 + k], x[j], n, part);
    mpfr_div_si(x[3 + i][n + 1], part, n + 1, MPFR_RNDN);
  }
  for (int i = 0; i < 4; i++) { /* q (0, w)/2 */
    static const int at[4][4] = {{0, 1, 2, 3}, {1, 0, 3, 2}, {2, 3, 0, 1}, {3, 2, 1, 0}};
    static const int minus[4][4] = {{0, 1, 1, 1}, {0, 0, 0, 1}, {0, 1, 0, 0}, {0, 0, 1, 0}};
    mpfr_set_zero(part, 1);
    for (int k = 0; k < 4; k++)
      if (at[i][k] > 0)
        convolve(minus[i][k] ? -1 : 1, x[6 + k], x[at[i][k] - 1], n, part);
    mpfr_div_si(x[6 + i][n + 1], part, 2 * (n + 1), MPFR_RNDN);
  }
}

/* the largest coefficient of order n */
static void size_of(int n, mpfr_t out) {
  mpfr_set_zero(out, 1);
  for (int i = 0; i < STATES; i++)
    if (mpfr_cmpabs(x[i][n], out) > 0)
      mpfr_abs(out, x[i][n], MPFR_RNDN);
}

static void advance(void) {
  mpfr_set_zero(sum, 1);
  while (mpfr_sgn(left) != 0) {
    for (int n = 0; n < order; n++)
      next_order(n);
    /* |h|: the last two terms are 2^-bits */
    mpfr_abs(h, left, MPFR_RNDN);
    for (int n = order - 1; n <= order; n++) {
      size_of(n, largest);
      if (mpfr_zero_p(largest))
        continue;
      mpfr_set_ui_2exp(power, 1, -(mpfr_exp_t)bits, MPFR_RNDN);
      mpfr_div(largest, power, largest, MPFR_RNDN);
      mpfr_rootn_ui(largest, largest, (unsigned long)n, MPFR_RNDN);
      if (mpfr_cmp(largest, h) < 0)
        mpfr_set(h, largest, MPFR_RNDN);
    }
    if (mpfr_sgn(left) < 0)
      mpfr_neg(h, h, MPFR_RNDN);
    for (int i = 0; i < STATES; i++) { /* Horner */
      mpfr_set(sum, x[i][order], MPFR_RNDN);
      for (int n = order - 1; n >= 0; n--) {
        mpfr_mul(sum, sum, h, MPFR_RNDN);
        mpfr_add(sum, sum, x[i][n], MPFR_RNDN);
      }
      mpfr_set(x[i][0], sum, MPFR_RNDN);
    }
    mpfr_sub(left, left, h, MPFR_RNDN);
  }
}

static void begin(const double in[14]) {
  for (int i = 0; i < 3; i++) {
    mpfr_set_d(I[i], in[i], MPFR_RNDN);
    mpfr_set_d(load[i], in[3 + i], MPFR_RNDN);
    mpfr_set_d(x[i][0], in[6 + i], MPFR_RNDN);
  }
  for (int i = 0; i < 3; i++) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    still[i] = in[j] == in[k] && in[3 + j] == 0 && in[3 + k] == 0;
  }
  mpfr_set_zero(sum, 1);
  for (int i = 0; i < 4; i++) {
    mpfr_set_d(x[6 + i][0], in[9 + i], MPFR_RNDN);
    mpfr_sqr(term, x[6 + i][0], MPFR_RNDN);
    mpfr_add(sum, sum, term, MPFR_RNDN);
  }
  mpfr_sqrt(sum, sum, MPFR_RNDN);
  for (int i = 0; i < 4; i++)
    mpfr_div(x[6 + i][0], x[6 + i][0], sum, MPFR_RNDN);
  /* the upward vertical in the body: 2 (xz - wy), 2 (yz + wx), 1 - 2 (x^2 + y^2) */
  for (int i = 0; i < 3; i++) {
    mpfr_t *a = x[i == 0 ? 7 : i == 1 ? 8 : 7], *b = x[i == 2 ? 7 : 9], *c = i == 2 ? x[8] : x[6];
    mpfr_t *d = i == 0 ? x[8] : i == 1 ? x[7] : x[8];
    mpfr_mul(sum, a[0], b[0], MPFR_RNDN);
    mpfr_mul(term, c[0], d[0], MPFR_RNDN);
    if (i == 0)
      mpfr_sub(sum, sum, term, MPFR_RNDN);
    else
      mpfr_add(sum, sum, term, MPFR_RNDN);
    mpfr_mul_si(sum, sum, i == 2 ? -2 : 2, MPFR_RNDN);
    if (i == 2)
      mpfr_add_ui(sum, sum, 1, MPFR_RNDN);
    mpfr_set(x[3 + i][0], sum, MPFR_RNDN);
  }
  mpfr_set_d(left, in[13], MPFR_RNDN);
}

/* (a, b) times exp(i angle) */
static void turn(mpfr_t a, mpfr_t b, mpfr_t angle) {
  mpfr_sin_cos(largest, power, angle, MPFR_RNDN);
  mpfr_mul(sum, a, power, MPFR_RNDN);
  mpfr_mul(term, b, largest, MPFR_RNDN);
  mpfr_sub(sum, sum, term, MPFR_RNDN);
  mpfr_mul(a, a, largest, MPFR_RNDN);
  mpfr_mul(b, b, power, MPFR_RNDN);
  mpfr_add(b, b, a, MPFR_RNDN);
  mpfr_set(a, sum, MPFR_RNDN);
}

/* out = the angle from c + i d to a + i b */
static void angle_between(mpfr_t out, mpfr_t a, mpfr_t b, mpfr_t c, mpfr_t d) {
  mpfr_atan2(out, b, a, MPFR_RNDN);
  mpfr_atan2(term, d, c, MPFR_RNDN);
  mpfr_sub(out, out, term, MPFR_RNDN);
}

/* The state after the long time t, for a body symmetric about z: it comes back after a period of
   gamma_z, but for turns A of w + i z and B of x + i y of the quaternion; N of them are powers.
   period: an approximation of it. */
static void repeat(const double in[14], double period) {
  mpfr_t T, A, B, N;
  mpfr_inits2(bits, T, A, B, N, (mpfr_ptr)0);
  begin(in);
  mpfr_set_d(left, period / 5, MPFR_RNDN); /* away from a turning point, where gamma_z' = 0 */
  advance();
  mpfr_t start[5];
  for (int i = 0; i < 5; i++) { /* gamma_z and q */
    mpfr_init2(start[i], bits);
    mpfr_set(start[i], x[5 + i][0], MPFR_RNDN);
  }
  mpfr_set_d(T, period, MPFR_RNDN);
  mpfr_set(left, T, MPFR_RNDN);
  for (int i = 0; i < 5; i++) { /* Newton: each step doubles the digits */
    advance();
    next_order(0);
    mpfr_sub(left, start[0], x[5][0], MPFR_RNDN);
    mpfr_div(left, left, x[5][1], MPFR_RNDN);
    mpfr_add(T, T, left, MPFR_RNDN);
  }
  advance();
  angle_between(A, x[6][0], x[9][0], start[1], start[4]);
  angle_between(B, x[7][0], x[8][0], start[2], start[3]);
  begin(in);
  mpfr_div(N, left, T, MPFR_RNDN);
  mpfr_rint(N, N, MPFR_RNDN);
  mpfr_mul(T, T, N, MPFR_RNDN);
  mpfr_sub(left, left, T, MPFR_RNDN);
  mpfr_mul(A, A, N, MPFR_RNDN);
  mpfr_mul(B, B, N, MPFR_RNDN);
  turn(x[6][0], x[9][0], A);
  turn(x[7][0], x[8][0], B);
  mpfr_sub(B, B, A, MPFR_RNDN);
  turn(x[0][0], x[1][0], B);
  turn(x[3][0], x[4][0], B);
  advance();
  for (int i = 0; i < 5; i++)
    mpfr_clear(start[i]);
  mpfr_clears(T, A, B, N, (mpfr_ptr)0);
}

/* How far the seven numbers in text, rates and attitude, are from the state; the attitude up to its
 * sign. */
static int compare(char *text, double *rates, double *attitude) {
  double most = 0, plus = 0, minus = 0;
  *rates = 0;
  for (int i = 0; i < 7; i++) {
    mpfr_t *v = x[i < 3 ? i : i + 3];
    char *end;
    if (mpfr_strtofr(term, text, &end, 0, MPFR_RNDN), end == text)
      return 0;
    text = end;
    mpfr_sub(sum, term, v[0], MPFR_RNDN);
    const double e = mpfr_get_d(sum, MPFR_RNDN), size = mpfr_get_d(v[0], MPFR_RNDN);
    mpfr_add(sum, term, v[0], MPFR_RNDN);
    const double f = mpfr_get_d(sum, MPFR_RNDN);
    if (i < 3) {
      if (!((e < 0 ? -e : e) <= *rates))
        *rates = e < 0 ? -e : e;
      most = size > most ? size : -size > most ? -size : most;
    } else {
      plus += e * e;
      minus += f * f;
    }
  }
  mpfr_set_zero(sum, 1);
  for (int i = 0; i < 3; i++) { /* a pendulum at its turn has the rate sqrt(m g r/I) all the same */
    mpfr_max(sum, sum, I[i], MPFR_RNDN);
  }
  for (int i = 0; i < 3 && mpfr_sgn(sum) > 0 && !rotor; i++) {
    mpfr_div(term, load[i], sum, MPFR_RNDN);
    mpfr_abs(term, term, MPFR_RNDN);
    mpfr_sqrt(term, term, MPFR_RNDN);
    const double rate = mpfr_get_d(term, MPFR_RNDN);
    most = rate > most ? rate : most;
  }
  *rates = most > 0 ? *rates / most : *rates;
  mpfr_set_d(sum, plus < minus ? plus : minus, MPFR_RNDN);
  if (plus != plus)
    mpfr_set_nan(sum);
  mpfr_sqrt(sum, sum, MPFR_RNDN);
  *attitude = mpfr_get_d(sum, MPFR_RNDN);
  return 1;
}

int main(int argc, char **argv) {
  static char line[4096];
  int errors = 0, longer = 0;
  for (int i = 1; i < argc; i++) {
    if (strcmp(argv[i], "-e") == 0) {
      errors = 1;
    } else if (strcmp(argv[i], "-p") == 0) {
      longer = 1;
    } else if (strcmp(argv[i], "-r") == 0) {
      rotor = 1;
    } else if (strcmp(argv[i], "-b") == 0 && i + 1 < argc && atoi(argv[i + 1]) >= 64) {
      bits = atoi(argv[++i]);
    } else {
      fprintf(stderr, "usage: heavy_top [-b BITS] [-p] [-r] [-e] < lines\n");
      return 2;
    }
  }
  order = (int)(bits / 4 + 16);
  if (order > ORDER_MOST)
    order = ORDER_MOST;
  for (int i = 0; i < STATES; i++)
    for (int n = 0; n <= order; n++)
      mpfr_init2(x[i][n], bits);
  for (int i = 0; i < 3; i++)
    mpfr_inits2(bits, I[i], load[i], (mpfr_ptr)0);
  mpfr_inits2(bits, sum, term, h, left, largest, power, (mpfr_ptr)0);
  while (fgets(line, sizeof line, stdin)) {
    double in[15], rates, attitude;
    char *p = line, *end;
    for (int i = 0; i < 14 + longer; i++, p = end) {
      in[i] = strtod(p, &end);
      if (end == p) {
        fprintf(stderr, "heavy_top: number %d of a line is missing\n", i + 1);
        return 2;
      }
    }
    if (longer) {
      repeat(in, in[14]);
    } else {
      begin(in);
      advance();
    }
    if (!errors) {
      for (int i = 0; i < 7; i++)
        mpfr_printf(i < 6 ? "%.40Re " : "%.40Re\n", x[i < 3 ? i : i + 3][0]);
    } else if (compare(p, &rates, &attitude)) {
      printf("%.3g %.3g\n", rates, attitude);
    } else {
      fprintf(stderr, "heavy_top: -e wants seven numbers after the time\n");
      return 2;
    }
  }
  mpfr_free_cache();
  return 0;
}
