/* newton.c - the local model of the loss at the end of a pass: curvature, gradient, step.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The loss is L = sum rho(z), its gradient g = J' psi, and H = J' diag(rho'') J its curvature but
 * for what the residuals themselves are bent.  The step is -(H + mu D^2)^-1 g, D = the lengths of
 * the columns (Levenberg, Marquardt); mu = 0 is Newton's.  H is only a model: solve.c asks the
 * loss.
 */
#include "fit.h"

#include <gsl/gsl_blas.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_linalg.h>
#include <gsl/gsl_vector.h>
#include <math.h>

/* Singular values below this part of the largest are rounding: what they belong to is not in the
 * data. */
#define RANK 1e-9

/* What changing an unknown by all of its own size would be: its value, or what its like have where
 * that is small; a radian for a turn, for a rate the largest of that log's initial state. */
static double size_of(const struct fit_problem *f, const double theta[], int k) {
  double size = fabs(theta[k]);
  if (k < f->free)
    return fmax(size, f->size[k]);
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
    const double size = r->size[k] = size_of(f, theta, k);
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

/* out[n*n] = (R'R + mu D^2)^-1 on what the data determine. */
static void damped(const struct fit_result *r, int n, double mu, double out[]) {
  for (int i = 0; i < n; i++)
    for (int k = 0; k < n; k++) {
      double sum = 0;
      for (int j = 0; j < r->rank; j++)
        sum +=
            r->vectors[i * n + j] * r->vectors[k * n + j] / (r->singular[j] * r->singular[j] + mu);
      out[i * n + k] = sum * r->scale[i] * r->scale[k];
    }
}

void fit_inverse(const struct fit_result *r, int n, double out[]) {
  damped(r, n, 0, out);
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

/* to = -C g; the length of that step, |g' C g|^(1/2). */
static double along(const double C[], const double g[], int n, double to[]) {
  double length = 0;
  for (int i = 0; i < n; i++) {
    to[i] = 0;
    for (int k = 0; k < n; k++)
      to[i] -= C[i * n + k] * g[k];
    length -= to[i] * g[i];
  }
  return sqrt(fmax(length, 0));
}

/* Where the loss bends down (cauchy), or few residuals are within its corner, H may be no model:
 * that of the whole triangle, which is positive, stands in for it. */
void fit_model(struct fit_problem *f, const double theta[], const struct fit_sums *s,
               struct fit_result *r) {
  const int n = f->n;
  double step[FIT_MOST];
  for (int k = 0; k < n; k++) {
    r->gradient[k] = 0;
    for (int i = 0; i <= k; i++)
      r->gradient[k] += triangle_at(s->whole, i, k) * triangle_at(s->whole, i, n);
  }
  fit_decompose(f, s->inner != NULL ? s->inner : s->whole, theta, r);
  fit_inverse(r, n, r->covariance);
  r->lost = s->lost;
  if ((s->inner != NULL && r->rank < n) || (s->lost != NULL && !without(s->lost, r->covariance))) {
    fit_decompose(f, s->whole, theta, r);
    fit_inverse(r, n, r->covariance);
    r->lost = NULL;
  }
  r->decrement = along(r->covariance, r->gradient, n, step);
  fit_wall(f, theta, step, &r->wall);
  r->left = r->wall.rule != 0 ? fit_model_step(f, r, 0, step) : r->decrement;
  r->loss = fit_loss(s);
  r->chi2 = s->chi2;
  r->n = s->n;
}

/* Where the step s would cross the wall m s <= b, the least of the model before it is
 *     s - C m (m s - b)/(m C m). */
double fit_model_step(const struct fit_problem *f, const struct fit_result *r, double mu,
                      double step[]) {
  static double C[FIT_MOST * FIT_MOST];
  const int n = f->n;
  const struct fit_wall *w = &r->wall;
  double toward[FIT_MOST], across = 0, over = -w->reach;
  damped(r, n, mu, C);
  if (r->lost != NULL)
    without(r->lost, C);
  const double whole = along(C, r->gradient, n, step);
  for (int k = 0; k < f->free && w->rule != 0; k++)
    over += w->normal[k] * step[k];
  if (w->rule == 0 || over <= 0)
    return whole;
  for (int i = 0; i < n; i++) {
    toward[i] = 0;
    for (int k = 0; k < f->free; k++)
      toward[i] += C[i * n + k] * w->normal[k];
    across += i < f->free ? w->normal[i] * toward[i] : 0;
  }
  double length = -w->reach * over / across; /* s C^-1 s, with C^-1 s = -g - m (m s - b)/(m C m) */
  for (int i = 0; i < n; i++) {
    step[i] -= toward[i] * over / across;
    length -= r->gradient[i] * step[i];
  }
  return sqrt(fmax(length, 0));
}
