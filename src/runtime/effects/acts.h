/* acts.h - the effects of polhode_acts.h in long double, for the library's own use.
   SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ACTS_H
#define ACTS_H

#include "numbers/wide.h"

/* Is any act switched on? */
static inline int acts_any(const ph_top *top) {
  return (top->effects & PH_ANY_ACT) != 0;
}

/* States of their own; of act number i the place of the first in the whole state. */
int acts_states(const ph_top *top);
int acts_place(const ph_top *top, int i);

ph_wide acts_value(const ph_varying *v, ph_wide t, const ph_wide x[]);

/* Adds their torques to N, body axes, but the motors' of wheels, and a bound of their terms to
 * *size. */
void acts_torque(const ph_top *top, ph_wide t, const ph_wide x[], ph_wide N[3], ph_wide *size);
/* Adds the forces of custom acts to F. */
void acts_force(const ph_top *top, ph_wide t, const ph_wide x[], ph_wide F[3]);
/* Rates of own states of custom acts into dx. */
void acts_rates(const ph_top *top, ph_wide t, const ph_wide x[], ph_wide dx[]);
/* Of the acts of acts_more.c: the torque of act k, in place of what N had; the forces, added; rates
   of own states. */
void acts_torque_more(const ph_top *top, int k, ph_wide t, const ph_wide x[], ph_wide N[3],
                      ph_wide *size);
void acts_force_more(const ph_top *top, const ph_wide x[], ph_wide F[3]);
void acts_rates_more(const ph_top *top, const ph_wide x[], ph_wide dx[]);
/* What moving parts add to the tensor; 0: none move. */
int acts_tensor(const ph_top *top, const ph_wide x[], ph_wide D[6]);
/* The same and the wheels that the body's tensor does not include, held still: with it the tensor
   is I of docs/mechanics.md. 0: nothing is added. */
int acts_locked(const ph_top *top, const ph_wide x[], ph_wide D[6]);
/* L of docs/mechanics.md, of all that turns, body axes. */
void acts_whole(const ph_top *top, const ph_wide x[], ph_wide L[3]);
/* The rate at which the body's axes turn, less w. */
void acts_slip(const ph_top *top, const ph_wide x[], ph_wide slip[3]);
/* With wheels or moving parts: w' and the wheels' rates from the b of I w' = b (motion/motion.h),
   which knows nothing of them. PH_EROD. */
int acts_solve(const ph_top *top, ph_wide t, const ph_wide x[], const ph_wide b[3], ph_wide dx[]);

/* The torque from outside with which the state x has the accelerations rate. */
void acts_inverse(const ph_top *top, ph_wide t, const ph_wide x[], const ph_wide rate[3],
                  ph_wide N[3]);

/* What they add to T, V and to the angular momentum in body axes. */
ph_wide acts_kinetic(const ph_top *top, const ph_wide x[]);
ph_wide acts_potential(const ph_top *top, const ph_wide x[]);
void acts_momentum(const ph_top *top, const ph_wide x[], ph_wide L[3]);

/* A new act, not yet switched on, if there is room and the n values that vary can be. */
int acts_new(ph_top *top, enum ph_act_kind kind, int states, int n, const ph_varying v[],
             ph_act **act);

/* n.s of plate `number` of those in the sun's light: its torque has a corner where this is 0. The
   result is 0 if there is no such plate. */
int acts_side(const ph_top *top, const ph_wide x[], int number, ph_wide *side);

/* The part of the step h from t up to the next row of a table. */
ph_wide acts_until(const ph_top *top, ph_wide t, ph_wide h);

#endif
