/* step.h - one step of a method, for run.c.
   SPDX-License-Identifier: GPL-3.0-or-later

   Private. A stepper maps (x, h) to the state after h and an estimate of the error of that step,
   relative to |q| = 1 and to the size of w. It changes nothing else but its counters. */
#ifndef STEP_H
#define STEP_H

#include <gsl/gsl_odeiv2.h>

#include "motion/motion.h"

enum { TAYLOR_DEFAULT = 24, TAYLOR_MAX = 40 };

typedef struct stepper {
  const ph_top *top;
  motion_loads loads;
  ph_wide t;            /* time at the start of the step */
  gsl_odeiv2_step *gsl; /* NULL for PH_RK4 and PH_TAYLOR */
  ph_wide base[PH_STATES],
      h;      /* a GSL step's start and length: GSL integrates the increment over [0, 1] */
  int status; /* why the equations could not be evaluated */
  int unseen; /* may there be corners that nobody tells of? */
  long evaluations;
} stepper;

/* Classical Runge-Kutta. */
int step_rk4(stepper *s, const ph_wide x[], ph_wide h, ph_wide out[]);
/* A GSL method. */
int step_gsl(stepper *s, const ph_wide x[], ph_wide h, ph_wide out[], ph_wide *error);
/* Taylor series. tolerance > 0: *h comes in as the longest step wanted and goes out as the one
 * taken. */
int step_taylor(stepper *s, const ph_wide x[], int order, ph_wide tolerance, ph_wide *h,
                ph_wide out[]);

/* The midpoint rule with extrapolation. *h comes in as the longest step wanted and goes out as the
   one taken; *next: what to try then. tolerance 0: a step of *h with all columns. PH_ESTEP. */
int step_extrapolate(stepper *s, const ph_wide x[], ph_wide tolerance, ph_wide *h, ph_wide *next,
                     ph_wide out[]);

/* What the error of a step from a state is measured by: scale.c. */
typedef struct step_scale {
  ph_wide torque, force; /* the sums of their terms, N m and N */
  ph_wide arm, pull;     /* of a body on a plane: to the contact point; the largest acceleration */
  int place, placed;     /* its own states */
} step_scale;
int step_scale_at(const stepper *s, const ph_wide x[], step_scale *out);
/* The size of state i, which the step h changes by d, and how many states have it together. */
ph_wide step_scale_of(const ph_top *top, const step_scale *c, const ph_wide x[], const ph_wide d[],
                      ph_wide h, int i, int *width);
/* The largest component of e in parts of the state's size. */
ph_wide step_relative(const ph_top *top, const step_scale *c, const ph_wide x[], const ph_wide d[],
                      ph_wide h, const ph_wide e[]);

/* A rate (1/s) at which the state changes: the larger of |w| and sqrt |w'|. PH_EROD. */
int step_rate(stepper *s, const ph_wide x[], ph_wide *rate);

/* Largest |v_i|. */
static inline ph_wide step_size(int n, const ph_wide v[]) {
  ph_wide size = 0;
  for (int i = 0; i < n; i++)
    size = fmaxl(size, fabsl(v[i]));
  return size;
}

#endif
