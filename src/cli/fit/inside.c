/* inside.c - steps that stay among the parameters that are a body.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The rules of a scene (second moments that are positive: tr(I)/2 - I > 0, so the triangle
 * inequality; masses, lengths) leave an open set of parameters, for entries of a tensor a convex
 * cone.  Let t be where the straight way from a body p along dp leaves it.  Then
 *     p + dp/sqrt(1 + 1/t^2)
 * is inside for every dp, reaches every body, and is p + dp for short steps: to the third order. So
 * no trial of a search is refused, whatever the parameters are of the tensor.  (Charts of the
 * tensor alone, as the logarithm of Cholesky's factor of tr(I)/2 - I, need all six entries free:
 * C. Rucker, P. M. Wensing, IEEE Robotics and Automation Letters 7 (2022).)
 * Where the border is, the rules themselves say: they are the emitted ones, and cheap.
 */
#include "fit.h"

#include <math.h>
#include <string.h>

/* A border so many steps away is none: it shortens the step by 5e-7. */
#define FARTHEST 1024
/* By so much the border is nearer, that a rounded step stays inside, too. */
#define SPARE 1.0001
/* A normal of the border is taken from where this part of a parameter lies between; a search that
 * stays at the border keeps that part of the way from it, which rounding does not cross. */
#define BACK  1e-3
#define APART 1e-9

/* 0, or the rule that the parameters break. */
static int broken(struct fit_problem *f, const double from[], const double step[], double t) {
  for (int i = 0; i < f->free; i++)
    f->p[f->free_index[i]] = from[i] + t * step[i];
  return f->code->init(f->model, f->p);
}

double fit_border(struct fit_problem *f, const double from[], const double step[], int *rule) {
  double in = 0, out = FARTHEST;
  int what = broken(f, from, step, out);
  *rule = 0;
  if (what == 0 || broken(f, from, step, 0) != 0)
    return 0; /* (or what is left is no body to begin with) */
  *rule = what;
  for (int i = 0; i < 60; i++) {
    const double t = (in + out) / 2;
    what = broken(f, from, step, t);
    if (what != 0) {
      out = t;
      *rule = what;
    } else {
      in = t;
    }
  }
  return in > 0 ? SPARE / in : (double)INFINITY;
}

double fit_inside(struct fit_problem *f, const double from[], const double step[], double to[]) {
  int rule;
  const double near = fit_border(f, from, step, &rule), part = 1 / sqrt(1 + near * near);
  for (int i = 0; i < f->n; i++)
    to[i] = from[i] + (i < f->free ? part : 1) * step[i];
  return part;
}

/* The derivatives of 1/t by the step: a normal of the border where the step leaves it. */
static void border_slope(struct fit_problem *f, const double from[], const double step[],
                         double slope[]) {
  double size = 0, moved[FIT_MOST];
  int rule;
  memcpy(moved, step, (size_t)f->free * sizeof step[0]);
  for (int k = 0; k < f->free; k++)
    size = fmax(size, fabs(step[k]));
  for (int k = 0; k < f->free; k++) {
    const double h = 1e-5 * size; /* 1/t is of degree 1 in dp: the quotient is good to 1e-10 */
    moved[k] = step[k] + h;
    const double right = fit_border(f, from, moved, &rule);
    moved[k] = step[k] - h;
    slope[k] = (right - fit_border(f, from, moved, &rule)) / (2 * h);
    moved[k] = step[k];
  }
}

void fit_inside_slope(struct fit_problem *f, const double from[], const double step[],
                      double slope[]) {
  int rule;
  const double near = fit_border(f, from, step, &rule);
  const double d = near == 0 || isinf(near) ? 0 : -near / pow(1 + near * near, 1.5);
  if (d != 0)
    border_slope(f, from, step, slope);
  for (int k = 0; k < f->free; k++)
    slope[k] = d != 0 ? d * slope[k] : 0;
}

/* Seen from a point a little back along the step: where `from` is at the border, no difference
 * tells a direction of it. */
void fit_wall(struct fit_problem *f, const double from[], const double step[], struct fit_wall *w) {
  double *behind = w->behind, back = (double)INFINITY, along = 0;
  w->rule = 0;
  for (int k = 0; k < f->free; k++)
    if (step[k] != 0 && from[k] != 0)
      back = fmin(back, BACK * fabs(from[k] / step[k]));
  for (int k = 0; k < f->free && isfinite(back); k++)
    behind[k] = from[k] - back * step[k];
  int rule;
  const double near = isfinite(back) ? fit_border(f, behind, step, &rule) : 0;
  const double reach = near > 0 ? SPARE / near - back : 1;
  if (isinf(near) || reach >= 1)
    return;
  border_slope(f, behind, step, w->normal);
  for (int k = 0; k < f->free; k++)
    along += w->normal[k] * step[k];
  w->reach = along * (reach - APART * back);
  w->rule = along > 0 ? rule : 0;
}

void fit_to_wall(struct fit_problem *f, const double from[], const double step[],
                 const struct fit_wall *w, double to[]) {
  double whole[FIT_MOST];
  int rule;
  for (int k = 0; k < f->n; k++)
    to[k] = from[k] + step[k];
  for (int k = 0; k < f->free; k++)
    whole[k] = to[k] - w->behind[k];
  const double near = fit_border(f, w->behind, whole, &rule);
  const double part = near > 0 ? fmin(1, (1 - APART) * SPARE / near) : 1;
  for (int k = 0; k < f->free; k++)
    to[k] = w->behind[k] + part * whole[k];
}
