/* start.c - where the search begins, and begins again where that led to no minimum worth the name.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * First from the scene's own values.  Where chi-square is incredible at what that led to, or where
 * no sigma tells: for a body that nothing acts on the linear start (linear.c), then the log from
 * its first piece on, twice as long each time.  With --starts, points of Sobol's sequence in the
 * parameters' ranges.  The least of all is taken.
 */
#include "fit.h"
#include "host/host.h"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_qrng.h>
#include <math.h>
#include <string.h>

/* By how much a minimum must be below another to be one of its own. */
#define LESS 1e-3
/* Two ends of the search are the same minimum. */
#define SAME 1e-6

/* Is chi-square of n residuals incredible? */
static int incredible(double chi2, long n, int unknowns) {
  const double dof = (double)(n - unknowns);
  return dof > 0 && chi2 > 1.5 * dof && gsl_cdf_chisq_Q(chi2, dof) < 1e-6;
}

/* Record by record, each twice as long as the one before: a wrong period is seen early and
 * mended. */
static int lengthen(struct fit_problem *f, const double start[], double theta[],
                    struct fit_sums *s) {
  const double whole = f->until;
  double last = 0;
  for (int i = 0; i < f->logs; i++)
    last = fmax(last, f->log[i].t[f->log[i].rows - 1]);
  memcpy(theta, start, (size_t)f->n * sizeof theta[0]);
  int count = 0;
  for (int k = 8; k >= 0 && count >= 0; k--) {
    f->until = k == 0 ? whole : last / (double)(1 << k);
    struct fit_sums only = {.whole = NULL};
    if (fit_pass(f, theta, &only) || only.n < 4 * f->n)
      continue;
    const int more = fit_descend(f, theta, s, 60);
    count = more < 0 ? -1 : count + more;
  }
  f->until = whole;
  return count;
}

/* The least that the search has come to. */
struct best {
  double theta[FIT_MOST], loss, chi2;
  long n;
};

static int take(struct fit_problem *f, double theta[], struct fit_sums *s, struct best *b) {
  if (interrupt_pending() || fit_again(f, theta, s) || !(fit_loss(s) < b->loss * (1 - LESS)))
    return 0;
  memcpy(b->theta, theta, (size_t)f->n * sizeof theta[0]);
  b->loss = fit_loss(s);
  b->chi2 = s->chi2;
  b->n = s->n;
  return 1;
}

/* Is the best so good that nothing else need be tried? */
static int good(const struct fit_problem *f, int has_sigma, const struct best *b) {
  return has_sigma && isfinite(b->loss) && !incredible(b->chi2, b->n, f->n);
}

/* From points of Sobol's sequence (P. Bratley, B. Fox, ACM TOMS 14 (1988), in GSL), what is no body
 * passed over. */
static void sobol(struct fit_problem *f, const double begun[], struct fit_sums *s, struct best *b,
                  struct fit_result *r) {
  double theta[FIT_MOST], u[FIT_MOST], loss[FIT_STARTS] = {0};
  gsl_qrng *q = gsl_qrng_alloc(gsl_qrng_sobol, (unsigned)f->free);
  for (int i = 0; q != NULL && i < 20 * f->starts && r->tried < f->starts; i++) {
    struct fit_sums only = {.whole = NULL};
    gsl_qrng_get(q, u);
    memcpy(theta, begun, sizeof theta);
    for (int k = 0; k < f->free; k++)
      theta[k] = f->low[k] + (f->high[k] - f->low[k]) * u[k];
    if (interrupt_pending() || (fit_pass(f, theta, &only) && f->refused != 0))
      continue;
    loss[r->tried] = (double)INFINITY;
    const int count = lengthen(f, theta, u, s);
    r->iterations += count > 0 ? count : 0;
    if (count >= 0 && !fit_pass(f, u, s))
      loss[r->tried] = fit_loss(s);
    r->tried++;
    if (count >= 0 && take(f, u, s, b))
      r->way = FIT_BY_SOBOL;
  }
  for (int i = 0; i < r->tried; i++)
    r->same += loss[i] <= b->loss * (1 + SAME);
  gsl_qrng_free(q);
}

void fit_approach(struct fit_problem *f, double theta[], int has_sigma, struct fit_sums *s,
                  struct fit_result *r) {
  struct best b = {.loss = (double)INFINITY};
  double begun[FIT_MOST], other[FIT_MOST];
  if (f->pieces > 1 || f->near) {
    r->way = FIT_BY_NODES;
    if (f->near)
      fit_first_step(f, theta, s);
    r->iterations = f->near ? fit_descend(f, theta, s, 100) : fit_pieces_approach(f, theta, s);
    return;
  }
  /* With the step as it is: where that leads to a good minimum it was short enough for the search.
   * If not, with one that is looked for. */
  const double h = f->h;
  for (int i = has_sigma ? 0 : 1; i < 2 && !good(f, has_sigma, &b); i++) {
    if (i == 1)
      fit_first_step(f, theta, s);
    if (i == 1 && has_sigma && f->h == h)
      break;
    b.loss = (double)INFINITY;
    for (int log = 0; log < f->logs; log++)
      fit_better_start(f, log, theta);
    memcpy(begun, theta, (size_t)f->n * sizeof begun[0]);
    memcpy(other, theta, (size_t)f->n * sizeof begun[0]);
    const int first = fit_descend(f, other, s, 100);
    r->iterations += first > 0 ? first : 0;
    if (first >= 0)
      take(f, other, s, &b);
  }
  if (f->linear != NULL && !good(f, has_sigma, &b)) {
    memcpy(other, begun, sizeof other);
    const int count = fit_linear(f, other) ? fit_descend(f, other, s, 100) : -1;
    r->iterations += count > 0 ? count : 0;
    if (count >= 0 && take(f, other, s, &b))
      r->way = FIT_BY_MOMENTUM;
  }
  if (!good(f, has_sigma, &b)) {
    const int count = lengthen(f, begun, other, s);
    r->iterations += count > 0 ? count : 0;
    if (count >= 0 && take(f, other, s, &b))
      r->way = FIT_BY_PIECES;
  }
  if (f->starts > 0)
    sobol(f, begun, s, &b, r);
  memcpy(theta, isfinite(b.loss) ? b.theta : begun, (size_t)f->n * sizeof theta[0]);
}
