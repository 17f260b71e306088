/* solve.c - the unknowns with the least sum of squares.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * What GSL ends at is not believed: Newton steps follow until the last is a small part of a
 * standard error, then the integration's step is halved until that moves the estimate no more.
 */
#include "fit.h"
#include "host/host.h"

#include <gsl/gsl_blas.h>
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_linalg.h>
#include <gsl/gsl_vector.h>
#include <math.h>
#include <string.h>

/* Steps below this part of a standard error are none. */
#define STILL 1e-7
/* A Newton step as short as this is done without a pass that looks again: the next one would be
 * shorter by a large factor, and the last pass of all sees it. */
#define SHORT 1e-5
/* A step below this moves chi-square and residuals by less than is printed of them. */
#define SEEN 1e-6
/* The error of the integration, in standard errors of the estimate. */
#define STEP_ERROR 1e-7
/* The corner of Huber's loss: 95 % efficient where the noise is normal (Huber 1981). */
#define HUBER 1.345
/* Singular values below this part of the largest are rounding: what they belong to is not in the
 * data. */
#define RANK 1e-9

/* ---- at the minimum ---- */

/* What changing an unknown by all of its own size would be: its value, a radian for a turn, for a
 * rate the largest of that log's initial state. */
static double size_of(const struct fit_problem *f, const double theta[], int k) {
  double size = fabs(theta[k]);
  if (k < f->free)
    return size;
  const int first = k - (k - f->free) % f->own, at = f->code->attitude;
  if (at >= 0 && k - first >= at && k - first < at + 3)
    return 1;
  for (int i = 0; i < f->own; i++)
    size = fmax(size, fabs(theta[first + i]));
  return size;
}

void fit_decompose(const struct fit_problem *f, const struct fit_triangle *a, const double theta[],
                   struct fit_result *r) {
  const int n = a->n;
  gsl_matrix *u = gsl_matrix_alloc((size_t)n, (size_t)n),
             *v = gsl_matrix_alloc((size_t)n, (size_t)n);
  gsl_vector *s = gsl_vector_alloc((size_t)n);
  for (int k = 0; k < n; k++) {
    const double size = size_of(f, theta, k);
    double length = 0;
    for (int i = 0; i <= k; i++)
      length = hypot(length, triangle_at(a, i, k));
    const int still = !(length > 0) || (size > 0 && length * size < RANK);
    r->scale[k] = still ? (size > 0 ? size : 1) : 1 / length;
    for (int i = 0; i < n; i++)
      gsl_matrix_set(u, (size_t)i, (size_t)k,
                     i > k || still ? 0 : triangle_at(a, i, k) * r->scale[k]);
  }
  gsl_linalg_SV_decomp_jacobi(u, v, s);
  r->rank = 0;
  for (int k = 0; k < n; k++) {
    r->singular[k] = gsl_vector_get(s, (size_t)k);
    r->rank += r->singular[k] > RANK * r->singular[0];
    for (int i = 0; i < n; i++)
      r->vectors[i * n + k] = gsl_matrix_get(v, (size_t)i, (size_t)k);
  }
  gsl_matrix_free(u);
  gsl_matrix_free(v);
  gsl_vector_free(s);
}

void fit_inverse(const struct fit_result *r, int n, double out[]) {
  for (int i = 0; i < n; i++)
    for (int k = 0; k < n; k++) {
      double sum = 0;
      for (int j = 0; j < r->rank; j++)
        sum += r->vectors[i * n + j] * r->vectors[k * n + j] / (r->singular[j] * r->singular[j]);
      out[i * n + k] = sum * r->scale[i] * r->scale[k];
    }
}

/* C = H^-1 where H is that of the triangle in r less N = R'R of the lost one: by the identity
 *     (P - R'R)^-1 = C + C R' (1 - R C R')^-1 R C,  C = P^-1
 * (Woodbury); 0, and C as it is: H is not positive. */
static int without(const struct fit_triangle *lost, double C[]) {
  const size_t n = (size_t)lost->n;
  gsl_matrix *R = gsl_matrix_calloc(n, n), *RC = gsl_matrix_alloc(n, n),
             *K = gsl_matrix_alloc(n, n);
  gsl_matrix_view c = gsl_matrix_view_array(C, n, n);
  for (size_t i = 0; i < n; i++)
    for (size_t k = i; k < n; k++)
      gsl_matrix_set(R, i, k, triangle_at(lost, (int)i, (int)k));
  gsl_blas_dgemm(CblasNoTrans, CblasNoTrans, 1, R, &c.matrix, 0, RC);
  gsl_matrix_set_identity(K);
  gsl_blas_dgemm(CblasNoTrans, CblasTrans, -1, RC, R, 1, K);
  const int positive = gsl_linalg_cholesky_decomp1(K) == GSL_SUCCESS;
  if (positive) { /* C += (L^-1 R C)' (L^-1 R C) */
    gsl_blas_dtrsm(CblasLeft, CblasLower, CblasNoTrans, CblasNonUnit, 1, K, RC);
    gsl_blas_dgemm(CblasTrans, CblasNoTrans, 1, RC, RC, 1, &c.matrix);
  }
  gsl_matrix_free(R);
  gsl_matrix_free(RC);
  gsl_matrix_free(K);
  return positive;
}

/* The step -H^-1 g, where g = J' psi = R'c of the whole triangle and H that of the loss (for least
 * squares J'J); its length in standard errors. */
static double newton(struct fit_problem *f, const double theta[], struct fit_sums *s,
                     struct fit_result *r, double step[]) {
  const int n = f->n;
  double g[FIT_MOST], length = 0;
  fit_decompose(f, s->inner != NULL ? s->inner : s->whole, theta, r);
  fit_inverse(r, n, r->covariance);
  if (s->lost != NULL && !without(s->lost, r->covariance)) {
    fit_decompose(f, s->whole, theta, r);
    fit_inverse(r, n, r->covariance);
  }
  for (int k = 0; k < n; k++) {
    g[k] = 0;
    for (int i = 0; i <= k; i++)
      g[k] += triangle_at(s->whole, i, k) * triangle_at(s->whole, i, n);
  }
  for (int i = 0; i < n; i++) {
    step[i] = 0;
    for (int k = 0; k < n; k++)
      step[i] -= r->covariance[i * n + k] * g[k];
    length -= step[i] * g[i];
  }
  return sqrt(fmax(length, 0));
}

/* Newton's steps from where the trust region ended; the sum of their lengths, or -1: none led
 * down. */
static double polish(struct fit_problem *f, struct fit_sums *s, struct fit_result *r,
                     double enough) {
  double step[FIT_MOST], whole = 0;
  r->converged = 0;
  if (fit_again(f, r->theta, s))
    return -1;
  for (int i = 0; i < 30; i++) {
    const double before = i > 0 ? r->decrement : f->stride;
    r->decrement = newton(f, r->theta, s, r, step);
    if (before > 0)
      r->contraction = r->decrement / before;
    f->stride = 0;
    r->loss = fit_loss(s);
    r->chi2 = s->chi2;
    r->n = s->n;
    /* of millions of rows what is left may be rounding: then steps no longer shrink */
    r->rounding = i > 0 && r->decrement < SHORT && r->decrement > 0.3 * before;
    r->converged = r->decrement < enough || r->rounding;
    if (r->converged) { /* the step is known, and as short as this it needs no pass */
      double from[FIT_MOST];
      memcpy(from, r->theta, (size_t)f->n * sizeof from[0]);
      fit_inside(f, from, step, r->theta);
    }
    if (r->converged || r->rank == 0)
      return whole + r->decrement;
    /* half as far until the loss falls (where the step is long: a short one is within rounding) */
    double t = 1, old[FIT_MOST], now[FIT_MOST];
    memcpy(old, r->theta, sizeof old);
    for (int k = 0;; k++, t /= 2) {
      for (int j = 0; j < f->n; j++)
        now[j] = t * step[j];
      fit_inside(f, old, now, r->theta);
      if (!fit_pass(f, r->theta, s) && (r->decrement < 1e-2 || fit_loss(s) < r->loss))
        break;
      if (k == 12) {
        memcpy(r->theta, old, sizeof old);
        fit_pass(f, r->theta, s);
        return -1;
      }
    }
    whole += t * r->decrement;
  }
  return -1;
}

/* The step is halved until the estimate stays: the error of a method of order 4 falls 16 times, so
 * what is left is a fifteenth of how far the estimate moved. */
static void refine(struct fit_problem *f, struct fit_sums *s, struct fit_result *r) {
  double last = 0;
  for (int i = 0; i < 12 && r->converged; i++) {
    f->h /= 2;
    const double moved = polish(f, s, r, SHORT);
    if (moved < 0)
      return;
    r->step_shift = moved / 15;
    if (r->step_shift < STEP_ERROR || interrupt_pending())
      return;
    if (moved < SHORT && moved > last / 4 && last > 0)
      return; /* it does not fall by any law: rounding, of millions of rows */
    last = moved;
    /* one jump to where the law of order 4 expects the error to be small, with something to
     * spare */
    const double jump = pow(STEP_ERROR / r->step_shift, 0.25) * 1.4;
    if (jump < 0.5)
      f->h *= fmax(jump, 1.0 / 32);
    else
      continue;
    if (polish(f, s, r, SHORT) < 0)
      return;
  }
}

/* The turns of initial attitudes become part of their references. */
static void recentre(struct fit_problem *f, double theta[]) {
  for (int log = 0; log < f->logs && f->own > 0 && f->code->attitude >= 0; log++) {
    double *a = theta + f->free + log * f->own + f->code->attitude, q[4];
    fit_turned(f->reference + 4 * log, a, q, NULL);
    memcpy(f->reference + 4 * log, q, sizeof q);
    a[0] = a[1] = a[2] = 0;
  }
}

/* What is said of theta, by a pass; is it a body? */
static int report(struct fit_problem *f, struct fit_sums *s, struct fit_result *r) {
  double step[FIT_MOST];
  if (fit_pass(f, r->theta, s)) {
    r->converged = 0;
    return 0;
  }
  r->decrement = newton(f, r->theta, s, r, step);
  r->loss = fit_loss(s);
  r->chi2 = s->chi2;
  r->n = s->n;
  return 1;
}

/* From how many sigmas on a value is no noise: one of n normal ones is so far with a probability of
 * 0.01.  Without a stated sigma all are the residuals' own. */
static double limit_of(const struct fit_result *r, int unknowns, int has_sigma) {
  const double own = r->n > unknowns ? sqrt(r->chi2 / (double)(r->n - unknowns)) : 1;
  return gsl_cdf_ugaussian_Qinv(0.005 / (double)(r->n > 0 ? r->n : 1)) * (has_sigma ? 1 : own);
}

void fit_solve(struct fit_problem *f, const double start[], int has_sigma, struct fit_result *r,
               struct fit_sums *room) {
  struct fit_sums s = {.whole = room->whole};
  gsl_error_handler_t *handler = gsl_set_error_handler_off();
  memset(r, 0, offsetof(struct fit_result, vectors)); /* the matrices as far as they are used */
  memset(r->vectors, 0, (size_t)(f->n * f->n) * sizeof r->vectors[0]);
  memset(r->covariance, 0, (size_t)(f->n * f->n) * sizeof r->covariance[0]);
  memcpy(r->theta, start, (size_t)f->n * sizeof start[0]);
  const int robust = f->loss != FIT_SQUARES, cauchy = f->loss == FIT_CAUCHY;
  const double corner = f->corner;
  if (cauchy) { /* it has many minima: from that of Huber's */
    f->loss = FIT_HUBER;
    f->corner = HUBER;
  }
  fit_approach(f, r->theta, has_sigma, &s, r);
  if (cauchy) {
    f->loss = FIT_CAUCHY;
    f->corner = corner;
    fit_descend(f, r->theta, &s, 100);
  }
  recentre(f, r->theta);
  if (robust)
    s.inner = room->inner;
  if (cauchy)
    s.lost = room->lost;
  r->contraction = 1;
  if (memcmp(s.of.theta, r->theta, (size_t)f->n * sizeof r->theta[0]) != 0)
    f->stride = 0; /* of another search */
  const int found = polish(f, &s, r, SHORT) >= 0;
  s.outer = robust ? room->outer : NULL;
  s.counts = room->counts;
  s.outliers = room->outliers;
  s.growth = room->growth;
  s.traces = room->traces;
  s.outliers->limit = limit_of(r, f->n, has_sigma);
  if (found)
    refine(f, &s, r);
  recentre(f, r->theta);
  /* A pass more, with all that is reported, unless the last one was a step away that none of that
   * shows; if it sees a step left, once more with care. */
  int still = r->converged && r->decrement < SEEN && r->contraction * r->decrement < STILL;
  if (!still && report(f, &s, r) && r->converged && r->decrement >= STILL) {
    polish(f, &s, r, STILL);
    report(f, &s, r);
  }
  r->converged = r->converged && (still || r->decrement < (r->rounding ? SHORT : STILL));
  if (!r->converged && f->refused == 0) { /* is it a rule that the way on would break? */
    double step[FIT_MOST];
    newton(f, r->theta, &s, r, step);
    if (fit_border(f, r->theta, step, &f->refused) < 1)
      f->refused = 0;
  }
  gsl_set_error_handler(handler);
}
