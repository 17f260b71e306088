/* implicit.h - the implicit method of implicit.c, for run.c.
   SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef IMPLICIT_H
#define IMPLICIT_H

#include "step.h"

enum { IMPLICIT_MOST = 9 }; /* stages: as many as half of the digits that a tolerance asks for */

/* The method's numbers, and room for its matrices; to be freed with free. */
typedef struct implicit {
  int stages;
  ph_wide c[IMPLICIT_MOST], A[IMPLICIT_MOST][IMPLICIT_MOST], slope[IMPLICIT_MOST];
  double *J, *small, *large;
} implicit;

/* PH_EMEMORY. */
int implicit_new(implicit **out, int states, double tolerance);

/* A step, as step_extrapolate has them; tolerance 0: one of *h, or PH_ESTEP. */
int step_implicit(stepper *s, implicit *m, const ph_wide x[], ph_wide tolerance, ph_wide *h,
                  ph_wide *next, ph_wide out[]);

/* The rate of what decays fastest, 1/s, as a step of h sees it; 0 if what is fastest oscillates. */
int step_decay(stepper *s, const ph_wide x[], ph_wide h, ph_wide *rate);

#endif
