/* solve.c - the unknowns with the least loss.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * What GSL ends at is not believed: steps of the local model (newton.c) follow, each of which must
 * lower the loss itself, until the gradient is that of a small part of a standard error.  Each
 * step ends at a new reference of the initial attitudes, so derivatives are always by small turns
 * about the attitude that there is: nothing that is told depends on where the search began.  Then
 * the integration's step is chosen, by what it does to that estimate alone.
 */
#include "fit.h"
#include "host/host.h"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_errno.h>
#include <math.h>
#include <string.h>

/* The last step of all, in standard errors: derivatives and residuals are those of the estimate to
 * that part, and what is told of them. */
#define LAST 1e-9
/* Converged is what ends with a step below this (rounding may leave more than LAST). */
#define STILL 1e-7
/* As near is near enough to compare steps of the integration. */
#define NEAR 1e-8
/* What rounding may leave at most, of millions of rows. */
#define SHORT 1e-5
/* The error of the integration, in standard errors of the estimate. */
#define STEP_ERROR 1e-7
/* The corner of Huber's loss: 95 % efficient where the noise is normal (Huber 1981). */
#define HUBER 1.345
/* Changes of the loss below this part of it are rounding. */
#define ROUNDING 1e-11

enum { STEPS = 200, HALVINGS = 12 };

/* The turns of initial attitudes become part of their references. */
static void recentre(struct fit_problem *f, double theta[]) {
  for (int log = 0; log < f->logs && f->own > 0 && f->code->attitude >= 0; log++) {
    double *a = theta + f->free + log * f->own + f->code->attitude, q[4];
    fit_turned(f->reference + 4 * log, a, q, NULL);
    fit_refer(f, log, q);
    a[0] = a[1] = a[2] = 0;
  }
}

/* A step of the model from theta on, in r->theta; is the loss there lower (or, where its change is
 * rounding, the gradient)?  If not all is as before.  *mu: the damping, which it adapts. */
static int stepped(struct fit_problem *f, struct fit_sums *s, struct fit_result *r, double *mu) {
  double step[FIT_MOST], old[FIT_MOST];
  const double loss = r->loss, before = r->left;
  fit_model_step(f, r, *mu, step);
  memcpy(old, r->theta, sizeof old);
  memcpy(f->former, f->reference, (size_t)(4 * f->logs) * sizeof f->former[0]);
  if (r->wall.rule != 0)
    fit_to_wall(f, old, step, &r->wall, r->theta);
  else
    fit_inside(f, old, step, r->theta);
  recentre(f, r->theta);
  if (!fit_pass(f, r->theta, s)) {
    const double now = fit_loss(s), change = now - loss;
    const int rounded = fabs(change) <= ROUNDING * loss;
    if (change < 0 || rounded)
      fit_model(f, r->theta, s, r);
    if (rounded ? r->left < before : change < 0) {
      *mu = *mu > 1e-6 ? *mu / 10 : 0;
      return 1;
    }
  }
  memcpy(r->theta, old, sizeof old);
  for (int log = 0; log < f->logs; log++)
    fit_refer(f, log, f->former + 4 * log);
  if (!fit_pass(f, r->theta, s))
    fit_model(f, r->theta, s, r);
  *mu = *mu > 0 ? *mu * 8 : 1e-4;
  return 0;
}

/* Steps until the next one is below `enough` standard errors, or no step leads down; has it come to
 * the minimum? */
static int polish(struct fit_problem *f, struct fit_sums *s, struct fit_result *r, double enough) {
  double mu = 0;
  r->converged = 0;
  if (fit_pass(f, r->theta, s))
    return 0;
  fit_model(f, r->theta, s, r);
  for (int i = 0; i < STEPS && r->rank > 0 && r->left >= enough && mu < 1e12; i++) {
    const double before = r->left;
    if (interrupt_pending() || (!stepped(f, s, r, &mu) && before < SHORT))
      break; /* what is left is rounding */
  }
  r->converged = r->left < fmax(enough, SHORT);
  return r->converged;
}

/* How far in standard errors the estimate of steps `times` as long is from this one, by the model.
 */
static double shift(struct fit_problem *f, struct fit_sums *s, const struct fit_result *r,
                    double times) {
  static struct fit_result other;
  f->h *= times;
  const int bad = fit_pass(f, r->theta, s);
  f->h /= times;
  if (bad)
    return (double)INFINITY;
  fit_model(f, r->theta, s, &other);
  return other.left;
}

/* Of the steps h0/2, h0/4 .. the longest whose error is small.  The error of a method of order 4
 * falls 16 times as the step is halved, so what is left is a fifteenth of how far the estimate
 * moved.  Where it ends depends on the estimate alone, and not on the step that the search had. */
static void refine(struct fit_problem *f, struct fit_sums *s, struct fit_result *r, double h0) {
  int k = (int)fmax(1, round(log2(h0 / f->h))), least = 1;
  double last = 0;
  for (int i = 0; i < HALVINGS && !interrupt_pending(); i++) {
    f->h = ldexp(h0, -k);
    if (!polish(f, s, r, NEAR))
      return;
    const double moved = shift(f, s, r, 2);
    r->step_shift = moved / 15;
    if (r->step_shift >= STEP_ERROR) {
      if (moved < 15 * SHORT && last > 0 && moved > last / 4)
        return; /* it does not fall by any law: rounding, of millions of rows */
      last = moved;
      least = k + 1;
      k += (int)fmin(5, fmax(1, ceil(log2(r->step_shift / STEP_ERROR) / 4)));
    } else if (k > least && (shift(f, s, r, 4) - moved) / 15 < STEP_ERROR) {
      k--;
    } else {
      return;
    }
  }
}

/* From how many sigmas on a value is no noise: one of n normal ones is so far with a probability of
 * 0.01.  Without a stated sigma all are the residuals' own. */
static double limit_of(const struct fit_result *r, int unknowns, int has_sigma) {
  const double own = r->n > unknowns ? sqrt(r->chi2 / (double)(r->n - unknowns)) : 1;
  return gsl_cdf_ugaussian_Qinv(0.005 / (double)(r->n > 0 ? r->n : 1)) * (has_sigma ? 1 : own);
}

/* The local minimum near r->theta, and what is told of it. */
static void settle(struct fit_problem *f, struct fit_sums *s, const struct fit_sums *room,
                   int has_sigma, double h0, struct fit_result *r) {
  if (polish(f, s, r, SHORT))
    refine(f, s, r, h0);
  const int found = r->converged;
  s->outer = f->loss != FIT_SQUARES ? room->outer : NULL;
  s->counts = room->counts;
  s->outliers = room->outliers;
  s->growth = room->growth;
  s->traces = room->traces;
  s->outliers->limit = limit_of(r, f->n, has_sigma);
  polish(f, s, r, found ? LAST : (double)INFINITY);
  r->converged = found && r->converged && r->wall.rule == 0;
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
  const double corner = f->corner, h0 = f->h;
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
  settle(f, &s, room, has_sigma, h0, r);
  if (!r->converged && f->refused == 0)
    f->refused = r->wall.rule; /* the way on would break it */
  gsl_set_error_handler(handler);
}
