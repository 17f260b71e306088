/* taylor.h - the Taylor series of a step, shared by taylor.c and taylor_move.c.
   SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TAYLOR_H
#define TAYLOR_H

#include "step.h"

/* Coefficients x_n H^n; S = second moments times w; speed = |v|, of use only with PH_DRAG. */
typedef struct series {
  ph_wide q[TAYLOR_MAX + 1][4], w[TAYLOR_MAX + 1][3], S[TAYLOR_MAX + 1][3];
  ph_wide r[TAYLOR_MAX + 1][3], v[TAYLOR_MAX + 1][3], speed[TAYLOR_MAX + 1];
} series;

/* The largest multiple of H at which term k of n components stays below bound. */
ph_wide taylor_reach(int n, const ph_wide term[], int k, ph_wide bound);

/* Adds the n-th coefficient of -(0, Omega) q to dq. */
void taylor_frame(const stepper *s, const series *c, int n, ph_wide H, ph_wide dq[4]);
/* Coefficients n + 1 of r and v from those up to n. */
void taylor_move(const stepper *s, series *c, int n, ph_wide H);
/* The largest multiple of H, at most `longest`, for which r and v, relative to their sizes, keep to
   the tolerance. */
ph_wide taylor_move_reach(const stepper *s, series *c, int order, ph_wide tolerance,
                          ph_wide longest);
/* Is there quadratic drag? */
int taylor_drags(const stepper *s);
/* With quadratic drag: where, before sigma, the velocity has turned by a right angle, or sigma. */
ph_wide taylor_turn(const stepper *s, const series *c, int order, ph_wide sigma);
/* With quadratic drag: close to rest, where the series is of no use, the length of a step worth
   trying; else 0. Of c the coefficients 0 and 1 are known; rate: of the state. */
ph_wide taylor_rest(const stepper *s, const series *c, ph_wide H, ph_wide rate);

#endif
