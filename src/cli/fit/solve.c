/* solve.c - the unknowns with the least sum of squares.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * GSL's trust region (multifit_nlinear, Levenberg-Marquardt) sees of the residuals their sum of
 * squares, J'z and J'J alone.  The triangle of a pass has all three: f = (c, rho), df = (R, 0).  So
 * GSL works on n + 1 residuals, however long the log is, and f and df come from the same pass.
 * (Geodesic acceleration needs f'' and would see the rotation Q; it is not used.)
 *
 * What GSL ends at is not believed: Newton steps follow until the last is a small part of a
 * standard error, then the integration's step is halved until that moves the estimate no more.
 */
#include "fit.h"
#include "host/host.h"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_linalg.h>
#include <gsl/gsl_multifit_nlinear.h>
#include <gsl/gsl_vector.h>
#include <math.h>
#include <string.h>

/* A residual of a state that is no body: so large that the trust region shrinks. */
#define FAR 1e100
/* Steps below this part of a standard error are none. */
#define STILL 1e-7
/* A Newton step as short as this is done without a pass that looks again: the next one would be
 * shorter by a large factor, and the last pass of all sees it. */
#define SHORT 1e-5
/* The error of the integration, in standard errors of the estimate. */
#define STEP_ERROR 1e-7
/* Singular values below this part of the largest are rounding: what they belong to is not in the
 * data. */
#define RANK 1e-9

struct search {
  struct fit_problem *f;
  struct fit_sums *s;
  double at[FIT_MOST];
  int done, bad; /* is the pass at `at` done, did it fail? */
};

static void visit(struct search *a, const gsl_vector *x) {
  int same = a->done;
  for (int i = 0; i < a->f->n; i++) {
    const double xi = gsl_vector_get(x, (size_t)i);
    same = same && xi == a->at[i];
    a->at[i] = xi;
  }
  if (same)
    return;
  a->bad = fit_pass(a->f, a->at, a->s);
  a->done = 1;
}

static int reduced(const gsl_vector *x, void *search, gsl_vector *out) {
  struct search *a = search;
  visit(a, x);
  const int n = a->f->n;
  for (int i = 0; i <= n; i++)
    gsl_vector_set(out, (size_t)i, a->bad ? (i < n ? 0 : FAR) : triangle_at(a->s->whole, i, n));
  return interrupt_pending() ? GSL_EFAILED : GSL_SUCCESS;
}

static int reduced_slope(const gsl_vector *x, void *search, gsl_matrix *out) {
  struct search *a = search;
  visit(a, x);
  const int n = a->f->n;
  for (int i = 0; i <= n; i++)
    for (int k = 0; k < n; k++)
      gsl_matrix_set(out, (size_t)i, (size_t)k,
                     a->bad || i > k ? 0 : triangle_at(a->s->whole, i, k));
  return GSL_SUCCESS;
}

/* Half the loss's minimum is looked for: the sum of squares of the triangle's last column. */
static double loss_of(const struct fit_sums *s) {
  double sum = 0;
  for (int i = 0; i <= s->whole->n; i++)
    sum += triangle_at(s->whole, i, s->whole->n) * triangle_at(s->whole, i, s->whole->n);
  return sum;
}

/* From theta to a local minimum, about; the iterations that it took, -1: the start is no body. */
static int descend(struct fit_problem *f, double theta[], struct fit_sums *s, size_t most) {
  struct search a = {.f = f, .s = s};
  gsl_multifit_nlinear_parameters how = gsl_multifit_nlinear_default_parameters();
  gsl_multifit_nlinear_fdf fdf = {
      .f = reduced, .df = reduced_slope, .n = (size_t)f->n + 1, .p = (size_t)f->n, .params = &a};
  gsl_vector_view x = gsl_vector_view_array(theta, (size_t)f->n);
  if (fit_pass(f, theta, s))
    return -1;
  gsl_multifit_nlinear_workspace *w =
      gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &how, fdf.n, fdf.p);
  if (w == NULL)
    return -1;
  int info = 0, count = 0;
  if (gsl_multifit_nlinear_init(&x.vector, &fdf, w) == GSL_SUCCESS) {
    gsl_multifit_nlinear_driver(most, 1e-5, 1e-9, 0, NULL, NULL, &info, w);
    count = (int)gsl_multifit_nlinear_niter(w);
    for (int i = 0; i < f->n; i++)
      theta[i] = gsl_vector_get(gsl_multifit_nlinear_position(w), (size_t)i);
  }
  gsl_multifit_nlinear_free(w);
  return count;
}

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

/* The step -H^-1 g, where g = J' psi = R'c of the whole triangle and H that of the loss (for least
 * squares J'J); its length in standard errors. */
static double newton(struct fit_problem *f, const double theta[], struct fit_sums *s,
                     struct fit_result *r, double step[]) {
  const int n = f->n;
  double g[FIT_MOST], length = 0;
  fit_decompose(f, s->inner != NULL ? s->inner : s->whole, theta, r);
  fit_inverse(r, n, r->covariance);
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

/* Newton's steps from where the trust region ended; the sum of their lengths, or -1: none led down.
 */
static double polish(struct fit_problem *f, struct fit_sums *s, struct fit_result *r,
                     double enough) {
  double step[FIT_MOST], whole = 0;
  r->converged = 0;
  if (fit_pass(f, r->theta, s))
    return -1;
  for (int i = 0; i < 30; i++) {
    r->decrement = newton(f, r->theta, s, r, step);
    r->loss = loss_of(s);
    r->chi2 = s->chi2;
    r->n = s->n;
    r->converged = r->decrement < enough;
    for (int j = 0; r->converged && j < f->n; j++)
      r->theta[j] += step[j]; /* it is known, and as short as this it needs no pass */
    if (r->converged || r->rank == 0)
      return whole + r->decrement;
    /* half as far until the loss falls (where the step is long: a short one is within rounding) */
    double t = 1, old[FIT_MOST];
    memcpy(old, r->theta, sizeof old);
    for (int k = 0;; k++, t /= 2) {
      for (int j = 0; j < f->n; j++)
        r->theta[j] = old[j] + t * step[j];
      if (!fit_pass(f, r->theta, s) && (r->decrement < 1e-2 || loss_of(s) < r->loss))
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
  for (int i = 0; i < 12 && r->converged; i++) {
    f->h /= 2;
    const double moved = polish(f, s, r, SHORT);
    if (moved < 0)
      return;
    r->step_shift = moved / 15;
    if (r->step_shift < STEP_ERROR || interrupt_pending())
      return;
    /* one jump to where the law of order 4 expects the error to be small, with something to spare
     */
    const double jump = pow(STEP_ERROR / r->step_shift, 0.25) * 1.4;
    if (jump < 0.5)
      f->h *= fmax(jump, 1.0 / 32);
    else
      continue;
    if (polish(f, s, r, SHORT) < 0)
      return;
  }
}

/* Is chi-square of n residuals incredible? */
static int incredible(double chi2, long n, int unknowns) {
  const double dof = (double)(n - unknowns);
  return dof > 0 && chi2 > 1.5 * dof && gsl_cdf_chisq_Q(chi2, dof) < 1e-6;
}

/* Record by record, each twice as long as the one before: a wrong period is seen early and mended.
 */
static int lengthen(struct fit_problem *f, const double start[], double theta[],
                    struct fit_sums *s) {
  const double whole = f->until;
  double last = 0;
  for (int i = 0; i < f->logs; i++)
    last = fmax(last, f->log[i]->t[f->log[i]->rows - 1]);
  memcpy(theta, start, (size_t)f->n * sizeof theta[0]);
  int count = 0;
  for (int k = 8; k >= 0 && count >= 0; k--) {
    f->until = k == 0 ? whole : last / (double)(1 << k);
    struct fit_sums only = {NULL, NULL, NULL, NULL, 0, 0};
    if (fit_pass(f, theta, &only) || only.n < 4 * f->n)
      continue;
    const int more = descend(f, theta, s, 60);
    count = more < 0 ? -1 : count + more;
  }
  f->until = whole;
  return count;
}

/* A step that is good enough for the search: half of it changes chi-square by less than a
 * thousandth. One that is too long may leave the range of numbers, too, or make minima that the
 * motion does not have. */
static void first_step(struct fit_problem *f, const double theta[]) {
  struct fit_sums one = {NULL, NULL, NULL, NULL, 0, 0}, half = one;
  int bad = fit_pass(f, theta, &one);
  for (int i = 0; i < 10 && f->refused == 0; i++) {
    f->h /= 2;
    const int worse = fit_pass(f, theta, &half);
    if (!bad && !worse && fabs(one.chi2 - half.chi2) < 1e-3 * half.chi2) {
      f->h *= 2;
      return;
    }
    one = half;
    bad = worse;
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

/* Where column `first` of a log has its first value, with `count` columns; -1: nowhere. */
static long first_row(const struct fit_log *log, int first, int count) {
  for (size_t i = 0; i < log->rows; i++) {
    int there = 1;
    for (int k = 0; k < count; k++) {
      const double x = log->y[i * (size_t)log->columns + (size_t)(first + k)];
      there = there && x == x;
    }
    if (there)
      return (long)i;
  }
  return -1;
}

/* What a log's first rows say of its initial state, in place of the scene's. */
static void from_rows(struct fit_problem *f, int log, double theta[]) {
  const struct fit_log *l = f->log[log];
  const int at = f->code->attitude;
  for (int i = 0; i < f->channels; i++) {
    const struct fit_channel *c = &f->channel[log * f->channels + i];
    const long row = first_row(l, c->column, c->attitude ? 4 : 1);
    const double *y = l->y + (size_t)(row < 0 ? 0 : row) * (size_t)l->columns + c->column;
    if (row >= 0 && c->attitude)
      memcpy(f->reference + 4 * log, y, 4 * sizeof y[0]);
    else if (row >= 0 && c->state >= 0 && (at < 0 || c->state < at || c->state > at + 3))
      theta[f->free + log * f->own + c->state - (at >= 0 && c->state > at)] = y[0];
  }
}

/* Of each log's initial state the better of the scene's and what the first rows say. */
static void better_starts(struct fit_problem *f, double theta[]) {
  struct fit_sums now = {NULL, NULL, NULL, NULL, 0, 0}, other = now;
  for (int log = 0; log < f->logs && f->own > 0; log++) {
    double old[FIT_MOST], q[4];
    memcpy(old, theta, sizeof old);
    memcpy(q, f->reference + 4 * log, sizeof q);
    const int bad = fit_pass(f, theta, &now);
    from_rows(f, log, theta);
    if (fit_pass(f, theta, &other) || (!bad && !(other.chi2 < now.chi2))) {
      memcpy(theta, old, sizeof old);
      memcpy(f->reference + 4 * log, q, sizeof q);
    }
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
  r->loss = loss_of(s);
  r->chi2 = s->chi2;
  r->n = s->n;
  return 1;
}

void fit_solve(struct fit_problem *f, const double start[], int has_sigma, struct fit_result *r,
               struct fit_sums *room) {
  struct fit_sums s = {room->whole, NULL, NULL, NULL, 0, 0};
  gsl_error_handler_t *handler = gsl_set_error_handler_off();
  memset(r, 0, sizeof *r);
  memcpy(r->theta, start, FIT_MOST * sizeof start[0]);
  first_step(f, r->theta);
  better_starts(f, r->theta);
  double begun[FIT_MOST];
  memcpy(begun, r->theta, sizeof begun);
  r->iterations = descend(f, r->theta, &s, 100);
  const int bad = r->iterations < 0 || fit_pass(f, r->theta, &s);
  if (!interrupt_pending() && (bad || !has_sigma || incredible(s.chi2, s.n, f->n))) {
    const double before = bad ? (double)INFINITY : loss_of(&s);
    double other[FIT_MOST];
    const int count = lengthen(f, begun, other, &s);
    if (count >= 0 && !fit_pass(f, other, &s) && loss_of(&s) < before * (1 - 1e-3)) {
      memcpy(r->theta, other, (size_t)f->n * sizeof other[0]);
      r->lengthened = 1;
    }
    r->iterations += count > 0 ? count : 0;
  }
  recentre(f, r->theta);
  if (f->huber > 0)
    s.inner = room->inner;
  if (polish(f, &s, r, SHORT) >= 0)
    refine(f, &s, r);
  /* the last pass, with all that is reported; if it sees a step left, once more with care */
  s.outer = f->huber > 0 ? room->outer : NULL;
  s.counts = room->counts;
  recentre(f, r->theta);
  if (report(f, &s, r) && r->converged && r->decrement >= STILL) {
    polish(f, &s, r, STILL);
    report(f, &s, r);
  }
  r->converged = r->converged && r->decrement < STILL;
  gsl_set_error_handler(handler);
}
