/* special.c - functions that MPFR lacks, to any number of bits: the uniform ellipsoid shell.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * For semi-axes a_i let p_i = 1/a_i^2 and Q = sum p_i n_i^2 on the unit sphere of directions n. The
 * surface r_i = a_i n_i has dS = a b c sqrt(Q) dn and the unit normal N_i = n_i/(a_i sqrt(Q)), so
 *     area/(4 pi) = a b c G,   G = mean sqrt(Q) = R_G(p)              (DLMF 19.33.1, 19.16.3)
 *     mean of N_x^2 over the surface = H_x/G,   H_x = mean p_x n_x^2/sqrt(Q),   sum H_i = G.
 * H_x is p_x/4 times the integral of t/((t + p_x) s(t)) over t > 0, s^2 = prod (t + p_i) (DLMF
 * 19.16.9), which by 19.21.8 is (p_x/6)(p_y D_y + p_z D_z), D_i = R_D(p_j, p_k, p_i); and by
 * 19.26.18
 *     D_i(p) = 3/(sqrt(p_i)(p_i + l)) + D_i((p + l)/4)/4,
 *     p_i + l = (sqrt p_i + sqrt p_j)(sqrt p_i + sqrt p_k).
 * Every term everywhere is positive: nothing cancels, on the sphere, on needles or on plates.  A
 * step halves the logarithm of the ratio of the p_i until it is small, then divides their relative
 * differences by four; with all equal, D = p^(-3/2).
 */
#include "special.h"

/* Bits beyond the asked for: some 10 roundings a step, and steps grow as the logarithm of bits. */
#define GUARD 40

/* The parts of one evaluation: e[i] = r_i^2 D_i/3 for r_i = smallest axis/axis i. */
struct parts {
  mpfr_t r[3], s[3], x[3], sum[3], e[3], h[3], total, t, u;
};

static void parts_init(struct parts *w, mpfr_prec_t work) {
  for (int i = 0; i < 3; i++)
    mpfr_inits2(work, w->r[i], w->s[i], w->x[i], w->sum[i], w->e[i], w->h[i], (mpfr_ptr)NULL);
  mpfr_inits2(work, w->total, w->t, w->u, (mpfr_ptr)NULL);
}

static void parts_clear(struct parts *w) {
  for (int i = 0; i < 3; i++)
    mpfr_clears(w->r[i], w->s[i], w->x[i], w->sum[i], w->e[i], w->h[i], (mpfr_ptr)NULL);
  mpfr_clears(w->total, w->t, w->u, (mpfr_ptr)NULL);
}

/* Is the largest of x more than twice the smallest? */
static int far_apart(struct parts *w) {
  for (int i = 0; i < 3; i++) {
    mpfr_mul_2ui(w->t, w->x[i], 1, MPFR_RNDN);
    if (mpfr_less_p(w->t, w->x[(i + 1) % 3]) || mpfr_less_p(w->t, w->x[(i + 2) % 3]))
      return 1;
  }
  return 0;
}

/* One duplication, the n-th: e[i] += 4^-n r_i^2/(s_i d_i), x_i = d_i/4. */
static void duplicate(struct parts *w, unsigned long n) {
  for (int i = 0; i < 3; i++)
    mpfr_add(w->sum[i], w->s[(i + 1) % 3], w->s[(i + 2) % 3], MPFR_RNDN);
  for (int i = 0; i < 3; i++) {
    mpfr_mul(w->x[i], w->sum[(i + 1) % 3], w->sum[(i + 2) % 3], MPFR_RNDN);
    mpfr_mul(w->t, w->s[i], w->x[i], MPFR_RNDN);
    mpfr_sqr(w->u, w->r[i], MPFR_RNDN);
    mpfr_div(w->t, w->u, w->t, MPFR_RNDN);
    mpfr_div_2ui(w->t, w->t, 2 * n, MPFR_RNDN);
    mpfr_add(w->e[i], w->e[i], w->t, MPFR_RNDN);
    mpfr_div_2ui(w->x[i], w->x[i], 2, MPFR_RNDN);
  }
  for (int i = 0; i < 3; i++)
    mpfr_sqrt(w->s[i], w->x[i], MPFR_RNDN);
}

/* What is left after n steps: e[i] += 4^-n r_i^2/(3 A^(3/2)), A = (x + y + z + 2 x_i)/5.  A is the
 * mean that R_D's expansion has no first-order term about (DLMF 19.19.7), so the error is second
 * order. */
static void finish(struct parts *w, unsigned long n) {
  for (int i = 0; i < 3; i++) {
    mpfr_mul_ui(w->t, w->x[i], 3, MPFR_RNDN);
    mpfr_add(w->t, w->t, w->x[(i + 1) % 3], MPFR_RNDN);
    mpfr_add(w->t, w->t, w->x[(i + 2) % 3], MPFR_RNDN);
    mpfr_div_ui(w->t, w->t, 5, MPFR_RNDN);
    mpfr_sqrt(w->u, w->t, MPFR_RNDN);
    mpfr_mul(w->t, w->t, w->u, MPFR_RNDN);
    mpfr_mul_ui(w->t, w->t, 3, MPFR_RNDN);
    mpfr_sqr(w->u, w->r[i], MPFR_RNDN);
    mpfr_div(w->t, w->u, w->t, MPFR_RNDN);
    mpfr_div_2ui(w->t, w->t, 2 * n, MPFR_RNDN);
    mpfr_add(w->e[i], w->e[i], w->t, MPFR_RNDN);
  }
}

/* h[i] and their sum, for p scaled by the square of the smallest axis. */
static void shares(struct parts *w, mpfr_t axis[3]) {
  mpfr_prec_t work = mpfr_get_prec(w->t);
  int least = 0;
  for (int i = 1; i < 3; i++)
    if (mpfr_less_p(axis[i], axis[least]))
      least = i;
  for (int i = 0; i < 3; i++) {
    mpfr_div(w->r[i], axis[least], axis[i], MPFR_RNDN);
    mpfr_set(w->s[i], w->r[i], MPFR_RNDN);
    mpfr_sqr(w->x[i], w->r[i], MPFR_RNDN);
    mpfr_set_zero(w->e[i], 1);
  }
  /* after the ratio is 2 each step makes the error of the rest at least 64 times smaller */
  unsigned long n = 0;
  for (mpfr_prec_t left = work / 6 + 1; left > 0; n++) {
    left -= !far_apart(w);
    duplicate(w, n);
  }
  finish(w, n);
  mpfr_set_zero(w->total, 1);
  for (int i = 0; i < 3; i++) {
    mpfr_add(w->h[i], w->e[(i + 1) % 3], w->e[(i + 2) % 3], MPFR_RNDN);
    mpfr_sqr(w->t, w->r[i], MPFR_RNDN);
    mpfr_mul(w->h[i], w->h[i], w->t, MPFR_RNDN);
    mpfr_div_2ui(w->h[i], w->h[i], 1, MPFR_RNDN);
    mpfr_add(w->total, w->total, w->h[i], MPFR_RNDN);
  }
  /* G(p) = total/smallest axis */
  mpfr_div(w->t, w->total, axis[least], MPFR_RNDN);
}

static void with_parts(mpfr_ptr y, mpq_srcptr const arg[3], int area) {
  const mpfr_prec_t work = mpfr_get_prec(y) + GUARD;
  for (int i = 0; i < 3; i++) {
    if (mpq_sgn(arg[i]) <= 0) {
      mpfr_set_nan(y);
      return;
    }
  }
  struct parts w;
  mpfr_t axis[3];
  parts_init(&w, work);
  for (int i = 0; i < 3; i++) {
    mpfr_init2(axis[i], work);
    mpfr_set_q(axis[i], arg[i], MPFR_RNDN);
  }
  shares(&w, axis);
  if (area) {
    for (int i = 0; i < 3; i++)
      mpfr_mul(w.t, w.t, axis[i], MPFR_RNDN);
    mpfr_set(y, w.t, MPFR_RNDN);
  } else {
    mpfr_div(y, w.h[0], w.total, MPFR_RNDN);
  }
  for (int i = 0; i < 3; i++)
    mpfr_clear(axis[i]);
  parts_clear(&w);
}

void rational_ellipsoid_area(mpfr_ptr y, mpq_srcptr const arg[3]) {
  with_parts(y, arg, 1);
}

void rational_ellipsoid_normal(mpfr_ptr y, mpq_srcptr const arg[3]) {
  with_parts(y, arg, 0);
}
