/* begin.c - before a search: the integration's step, and the initial states that the rows tell.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "fit.h"

#include <math.h>
#include <string.h>

void fit_first_step(struct fit_problem *f, const double theta[], struct fit_sums *s) {
  struct fit_sums half = {.whole = NULL};
  f->h /= 2;
  int worse = fit_pass(f, theta, &half);
  f->h *= 2;
  int bad = fit_again(f, theta, s); /* with derivatives: the search begins with them */
  double chi2 = s->chi2;
  for (int i = 0; i < 10 && f->refused == 0; i++) {
    if (!bad && !worse && fabs(chi2 - half.chi2) < 1e-3 * half.chi2)
      return;
    f->h /= 2;
    chi2 = half.chi2;
    bad = worse;
    f->h /= 2;
    worse = fit_pass(f, theta, &half);
    f->h *= 2;
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
  const struct fit_log *l = &f->log[log];
  const int at = f->code->attitude;
  for (int i = 0; i < f->channels; i++) {
    const struct fit_channel *c = &f->channel[log * f->channels + i];
    const long row = first_row(l, c->column, c->attitude ? 4 : 1);
    const double *y = l->y + (size_t)(row < 0 ? 0 : row) * (size_t)l->columns + c->column;
    if (row >= 0 && c->attitude)
      fit_refer(f, log, y);
    else if (row >= 0 && c->state >= 0 && (at < 0 || c->state < at || c->state > at + 3))
      theta[f->free + log * f->own + c->state - (at >= 0 && c->state > at)] = y[0];
  }
}

void fit_better_start(struct fit_problem *f, int log, double theta[]) {
  struct fit_sums now = {.whole = NULL}, other = now;
  double old[FIT_MOST], q[4];
  if (f->own == 0)
    return;
  memcpy(old, theta, (size_t)f->n * sizeof old[0]);
  memcpy(q, f->reference + 4 * log, sizeof q);
  const int bad = fit_pass(f, theta, &now);
  from_rows(f, log, theta);
  if (fit_pass(f, theta, &other) || (!bad && !(other.chi2 < now.chi2))) {
    memcpy(theta, old, (size_t)f->n * sizeof old[0]);
    fit_refer(f, log, q);
  }
}
