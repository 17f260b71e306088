/* descend.c - from a start down to a minimum: GSL's trust region on the triangle of a pass.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * GSL's trust region (multifit_nlinear, Levenberg-Marquardt) sees of the residuals their sum of
 * squares, J'z and J'J alone.  The triangle of a pass has all three: f = (c, rho), df = (R, 0).  So
 * GSL works on n + 1 residuals, however long the log is, and f and df come from the same pass.
 * Its unknowns are steps from the start, of which inside.c makes parameters that are a body.
 * (Geodesic acceleration needs f'' and would see the rotation Q; it is not used.)
 */
#include "fit.h"
#include "host/host.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_multifit_nlinear.h>
#include <gsl/gsl_vector.h>
#include <math.h>
#include <string.h>

/* A residual of a state that is no body: so large that the trust region shrinks. */
#define FAR 1e100

struct search {
  struct fit_problem *f;
  struct fit_sums *s;
  double from[FIT_MOST], step[FIT_MOST], part, slope[FIT_MOST]; /* as inside.c has them */
  int bad;                                                      /* did the last pass fail? */
};

static void visit(struct search *a, const gsl_vector *x) {
  double at[FIT_MOST];
  for (int i = 0; i < a->f->n; i++)
    a->step[i] = gsl_vector_get(x, (size_t)i) - a->from[i];
  a->part = fit_inside(a->f, a->from, a->step, at);
  a->bad = fit_again(a->f, at, a->s);
}

static int reduced(const gsl_vector *x, void *search, gsl_vector *out) {
  struct search *a = search;
  visit(a, x);
  const int n = a->f->n;
  for (int i = 0; i <= n; i++)
    gsl_vector_set(out, (size_t)i, a->bad ? (i < n ? 0 : FAR) : triangle_at(a->s->whole, i, n));
  return interrupt_pending() ? GSL_EFAILED : GSL_SUCCESS;
}

/* The point is from + part step in the free parameters, where part depends on the step, and from +
 * step in the logs' own unknowns: df = part R + (R step) (d part/d step)', and R. */
static int reduced_slope(const gsl_vector *x, void *search, gsl_matrix *out) {
  struct search *a = search;
  visit(a, x);
  const int n = a->f->n, free = a->f->free;
  fit_inside_slope(a->f, a->from, a->step, a->slope);
  for (int i = 0; i <= n; i++) {
    double along = 0; /* the step itself, times the slope of its part */
    for (int k = i; k < free && !a->bad; k++)
      along += triangle_at(a->s->whole, i, k) * a->step[k];
    for (int k = 0; k < n; k++) {
      const double own = a->bad || i > k ? 0 : triangle_at(a->s->whole, i, k);
      gsl_matrix_set(out, (size_t)i, (size_t)k,
                     k < free ? a->part * own + along * a->slope[k] : own);
    }
  }
  return GSL_SUCCESS;
}

/* Half the loss's minimum is looked for: the sum of squares of the triangle's last column. */
double fit_loss(const struct fit_sums *s) {
  double sum = 0;
  for (int i = 0; i <= s->whole->n; i++)
    sum += triangle_at(s->whole, i, s->whole->n) * triangle_at(s->whole, i, s->whole->n);
  return sum;
}

/* The step of Gauss and Newton from the triangle, R step = -c; by how much it lowers the loss if
 * the model is linear, |c|^2; -1: R is singular. */
static double gauss(const struct fit_triangle *a, double step[]) {
  double gain = 0;
  for (int i = a->n - 1; i >= 0; i--) {
    double sum = -triangle_at(a, i, a->n);
    gain += sum * sum;
    for (int k = i + 1; k < a->n; k++)
      sum -= triangle_at(a, i, k) * step[k];
    step[i] = sum / triangle_at(a, i, i);
    if (!isfinite(step[i]))
      return -1;
  }
  return gain;
}

/* Steps of Gauss and Newton for as long as each gains at least half of what it promises: near a
 * minimum they need fewer passes than the trust region, which begins with short ones.  theta is at
 * the least loss that was seen; how many steps; *done: is what is left to gain below a thousandth
 * of what noise makes of the loss? */
static int straight(struct fit_problem *f, double theta[], struct fit_sums *s, int *done) {
  double step[FIT_MOST] = {0}, next[FIT_MOST];
  for (int count = 0;; count++) {
    const double loss = fit_loss(s), gain = gauss(s->whole, step);
    *done = gain >= 0 && s->n > f->n && gain < 1e-3 * loss / (double)(s->n - f->n);
    if (*done || gain < 0 || count == 10 || interrupt_pending())
      return count;
    const double part = fit_inside(f, theta, step, next);
    if (fit_pass(f, next, s) || !(loss - fit_loss(s) > gain * part * (2 - part) / 2))
      return count;
    memcpy(theta, next, (size_t)f->n * sizeof next[0]);
  }
}

/* From theta to a local minimum, about; the iterations that it took, -1: the start is no body. */
int fit_descend(struct fit_problem *f, double theta[], struct fit_sums *s, size_t most) {
  static struct search a;
  gsl_multifit_nlinear_parameters how = gsl_multifit_nlinear_default_parameters();
  gsl_multifit_nlinear_fdf fdf = {
      .f = reduced, .df = reduced_slope, .n = (size_t)f->n + 1, .p = (size_t)f->n, .params = &a};
  gsl_vector_view x = gsl_vector_view_array(theta, (size_t)f->n);
  if (fit_again(f, theta, s))
    return -1;
  int done, count = straight(f, theta, s, &done);
  if (done)
    return count;
  a.f = f;
  a.s = s;
  memcpy(a.from, theta, (size_t)f->n * sizeof theta[0]);
  gsl_multifit_nlinear_workspace *w =
      gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &how, fdf.n, fdf.p);
  if (w == NULL)
    return -1;
  int info = 0;
  if (gsl_multifit_nlinear_init(&x.vector, &fdf, w) == GSL_SUCCESS) {
    gsl_multifit_nlinear_driver(most, 1e-5, 1e-9, 0, NULL, NULL, &info, w);
    count += (int)gsl_multifit_nlinear_niter(w);
    for (int i = 0; i < f->n; i++)
      a.step[i] = gsl_vector_get(gsl_multifit_nlinear_position(w), (size_t)i) - a.from[i];
    fit_inside(f, a.from, a.step, theta);
  }
  gsl_multifit_nlinear_free(w);
  return count;
}
