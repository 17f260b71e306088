/* input.c - inputs of the scene over time, as the code of a fit takes them.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A line is followed within a step by its value and its slope, and a step ends where it does. So no
 * step has a corner inside, and the step's order holds.
 */
#include "fit.h"

#include <math.h>
#include <string.h>

double fit_inputs_at(const struct fit_problem *f, int log, double t, double u[]) {
  const int n = f->code->inputs;
  const struct course *c = f->course != NULL ? f->course[log] : NULL;
  struct course_segment s;
  memset(u, 0, (size_t)(1 + 2 * n) * sizeof u[0]);
  u[0] = t;
  if (c == NULL)
    return (double)INFINITY;
  const double until = course_next(c, t, (double)INFINITY);
  course_segment(c, t, until, &s);
  course_value(&s, n, t, u + 1);
  memcpy(u + 1 + n, s.slope, (size_t)n * sizeof u[0]);
  return until;
}
