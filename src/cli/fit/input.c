/* input.c - inputs of the scene from columns of logs: held, on lines, or the slope of these lines.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A line is followed within a step by its value and its slope, and a step ends where it does: at
 * the next value of any input, and where an input crosses one of its limits.  So no step has a
 * corner inside, and the step's order holds.
 */
#include "fit.h"

#include <math.h>

static double value(const struct fit_input *in, size_t row) {
  return in->log->y[row * (size_t)in->log->columns + (size_t)in->column];
}

/* The first row from `row` on with a value, or the number of rows. */
static size_t found(const struct fit_input *in, size_t row) {
  while (row < in->log->rows && isnan(value(in, row)))
    row++;
  return row;
}

void fit_inputs_begin(const struct fit_problem *f, int log, struct fit_place *at) {
  for (int i = 0; f->input != NULL && i < f->code->inputs; i++) {
    const struct fit_input *in = &f->input[log * f->code->inputs + i];
    at->before[i] = found(in, 0);
    at->after[i] = found(in, at->before[i] + 1);
  }
}

/* The corner after t of an input that moves on a line, at most `until`: where it crosses a
 * limit. */
static double crossing(const struct fit_input *in, double t, double x, double slope, double until) {
  const double limit[2] = {in->low, in->high};
  const double least = 1e-12 * fmax(1, fabs(t)); /* of the last crossing, which was rounded */
  for (int i = 0; i < 2; i++) {
    const double wait = (limit[i] - x) / slope;
    if (wait > least && t + wait < until)
      until = t + wait;
  }
  return until;
}

double fit_inputs_at(const struct fit_problem *f, int log, double t, struct fit_place *at,
                     double u[]) {
  const int n = f->code->inputs;
  double until = (double)INFINITY;
  u[0] = t;
  for (int i = 0; i < n; i++) {
    u[1 + i] = u[1 + n + i] = 0;
    if (f->input == NULL)
      continue;
    const struct fit_input *in = &f->input[log * n + i];
    size_t *before = &at->before[i], *after = &at->after[i];
    while (*after < in->log->rows && in->log->t[*after] <= t) {
      *before = *after;
      *after = found(in, *after + 1);
    }
    const double t0 = in->log->t[*before], x0 = value(in, *before);
    const int inside = t0 <= t && *after < in->log->rows;
    const double t1 = inside ? in->log->t[*after] : t0;
    const double slope = inside && in->kind != FIT_HELD ? (value(in, *after) - x0) / (t1 - t0) : 0;
    until = t < t0 ? fmin(until, t0) : inside ? fmin(until, t1) : until;
    u[1 + i] = in->kind == FIT_SLOPE ? slope : x0 + slope * (t - t0);
    u[1 + n + i] = in->kind == FIT_SLOPE ? 0 : slope;
    if (u[1 + n + i] != 0)
      until = crossing(in, t, u[1 + i], slope, until);
  }
  return until;
}
