/* corner.h - steps that end where the equations have corners or jumps.
   SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef CORNER_H
#define CORNER_H

#include "step.h"

typedef struct corners {
  int n;               /* how many sides; 0: the equations are smooth */
  signed char *branch; /* the sign that a step holds each to, 0: none */
  ph_wide *side;       /* n values for each of the points of a step, and n more */
  ph_wide span;        /* of the run: times are found to its roundings */
  int crowded;         /* how many steps in a row were no longer than a few of these */
} corners;

/* A step from x by a method: *h comes in as the length wanted and goes out as the one taken. */
typedef int corner_stepper(void *of, const ph_wide x[], ph_wide *h, ph_wide y[]);

/* Those of the top; what is kept is to be freed with corners_free. PH_EMEMORY. */
int corners_new(corners *c, const ph_top *top);
void corners_free(corners *c);
/* At the start of a run over the span: the sides that x is on. */
void corners_begin(corners *c, const stepper *s, ph_wide span, const ph_wide x[]);
/* Before a step of some length h: where x is on neither side, the one that it goes to. */
int corners_settle(corners *c, stepper *s, ph_wide h, const ph_wide x[]);
/* Of a step *h from x to y that may have passed corners: shortened to end at the first, to a few
   roundings of the time, on its other side. *next: the length to try then, lowered if this one was
   too long for the corners. PH_ECHATTER. */
int corners_cut(corners *c, stepper *s, corner_stepper *again, void *of, const ph_wide x[],
                ph_wide *h, ph_wide *next, ph_wide y[]);

#endif
