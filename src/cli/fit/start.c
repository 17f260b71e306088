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
    struct fit_sums only = {.whole = NULL};
    if (fit_pass(f, theta, &only) || only.n < 4 * f->n)
      continue;
    const int more = fit_descend(f, theta, s, 60);
    count = more < 0 ? -1 : count + more;
  }
  f->until = whole;
  return count;
}

/* A step that is good enough for the search: half of it changes chi-square by less than a
 * thousandth. One that is too long may leave the range of numbers, too, or make minima that the
 * motion does not have. */
static void first_step(struct fit_problem *f, const double theta[]) {
  struct fit_sums one = {.whole = NULL}, half = one;
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
  struct fit_sums now = {.whole = NULL}, other = now;
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

/* The least that the search has come to. */
struct best {
  double theta[FIT_MOST], loss;
};

static int take(struct fit_problem *f, double theta[], struct fit_sums *s, struct best *b) {
  if (interrupt_pending() || fit_pass(f, theta, s) || !(fit_loss(s) < b->loss * (1 - LESS)))
    return 0;
  memcpy(b->theta, theta, (size_t)f->n * sizeof theta[0]);
  b->loss = fit_loss(s);
  return 1;
}

/* Is the best so good that nothing else need be tried? */
static int good(struct fit_problem *f, int has_sigma, struct fit_sums *s, const struct best *b) {
  return has_sigma && isfinite(b->loss) && !fit_pass(f, b->theta, s) &&
         !incredible(s->chi2, s->n, f->n);
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
  first_step(f, theta);
  better_starts(f, theta);
  memcpy(begun, theta, sizeof begun);
  memcpy(other, theta, sizeof other);
  const int first = fit_descend(f, other, s, 100);
  r->iterations = first;
  if (first >= 0)
    take(f, other, s, &b);
  if (f->linear != NULL && !good(f, has_sigma, s, &b)) {
    memcpy(other, begun, sizeof other);
    const int count = fit_linear(f, other) ? fit_descend(f, other, s, 100) : -1;
    r->iterations += count > 0 ? count : 0;
    if (count >= 0 && take(f, other, s, &b))
      r->way = FIT_BY_MOMENTUM;
  }
  if (!good(f, has_sigma, s, &b)) {
    const int count = lengthen(f, begun, other, s);
    r->iterations += count > 0 ? count : 0;
    if (count >= 0 && take(f, other, s, &b))
      r->way = FIT_BY_PIECES;
  }
  if (f->starts > 0)
    sobol(f, begun, s, &b, r);
  memcpy(theta, isfinite(b.loss) ? b.theta : begun, (size_t)f->n * sizeof theta[0]);
}
