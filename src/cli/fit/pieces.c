/* pieces.c - multiple shooting: a log in pieces, each with an initial state of its own.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Where a motion forgets its beginning (chaos), a long log has no smooth sum of squares; pieces
 * that are shorter than that have one (H. G. Bock, in: Modelling of Chemical Reaction Systems,
 * Springer 1981).  Nothing ties the pieces together here: their states are unknowns like those of
 * several logs, so the standard errors hold even if the motion was disturbed between them. The
 * search goes from piece to piece: the motion found so far says how the next one begins.
 */
#include "fit.h"
#include "host/host.h"

#include <math.h>
#include <string.h>

void fit_pieces_cut(struct fit_problem *f) {
  const int n = f->pieces;
  for (int i = 0; i < f->logs; i++) {
    struct fit_log *log = &f->log[i];
    const size_t k = (size_t)(i % n), first = log->rows * k / (size_t)n,
                 last = log->rows * (k + 1) / (size_t)n;
    log->rows = last - first;
    log->t += first;
    log->y += first * (size_t)log->columns;
    log->line += first;
    log->begin = k > 0 ? log->t[0] : 0;
  }
}

/* A state as the unknowns of a log. */
static void put(struct fit_problem *f, int log, const double x[], double theta[]) {
  double *own = theta + f->free + log * f->own;
  for (int i = 0; i < f->code->states; i++)
    if (i == f->code->attitude) {
      fit_refer(f, log, x + i);
      own[0] = own[1] = own[2] = 0;
      own += 3;
      i += 3;
    } else {
      *own++ = x[i];
    }
}

int fit_pieces_approach(struct fit_problem *f, double theta[], struct fit_sums *s) {
  double x[64];
  int count = 0;
  for (f->active = 1; count >= 0; f->active++) {
    const int now = f->active - 1;
    if (now % f->pieces > 0 && !fit_state(f, theta, now - 1, f->log[now].begin, x))
      put(f, now, x, theta);
    fit_better_start(f, now, theta);
    if (now == 0)
      fit_first_step(f, theta, s);
    const int more = fit_descend(f, theta, s, now + 1 < f->logs ? 30 : 100);
    count = more < 0 || interrupt_pending() ? -1 : count + more;
    if (f->active == f->logs)
      break;
  }
  f->active = f->logs;
  return count;
}
