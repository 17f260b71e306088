/* acts.h - all effects of a top together, in long double, for the library's own use.
   SPDX-License-Identifier: GPL-3.0-or-later

   What a single effect does is in effects/NAME.c; here is what follows from their sum. */
#ifndef ACTS_H
#define ACTS_H

#include "effects/effect.h"

/* Is any act switched on? */
static inline int acts_any(const ph_top *top) {
  return (top->effects & PH_ANY_ACT) != 0;
}

/* ---- varying.c ---- */

/* Of a value of the act's, on the branch of its sides that the top holds to. */
ph_wide acts_value(const effect_at *e, ph_wide t, const ph_varying *v);
/* How many functions say where it has corners. */
int acts_varying_sides(const ph_varying *v);
/* PH_OK, PH_ECOUNT or PH_EFINITE. */
int acts_varying_check(const ph_varying *v);
/* Shortens the step *h from t to end at the next row of a table. */
void acts_varying_until(const ph_varying *v, ph_wide t, ph_wide *h);

/* ---- new.c ---- */

/* A new act of the effect, with states of its own, if there is room and the n values that vary can
   be; switched on. */
int acts_new(ph_top *top, const effect_table *effect, int states, int n, const ph_varying v[],
             ph_act **act);
/* The unit vector along v, PH_EFINITE or PH_EDIRECTION. */
int acts_unit(const double v[3], double out[3]);

/* ---- surface.c ---- */

/* From the centre of mass to the point of the surface where the plane of normal g touches it, and
   its rate when g has the rate g_rate: body axes, g a unit vector. 0: there is no single point. */
int acts_surface(const ph_plane *p, const ph_wide g[3], const ph_wide g_rate[3], ph_wide r[3],
                 ph_wide rate[3]);

/* ---- acts.c ---- */

/* The acts that are switched on, one after the other: `for (acts_at a = acts_first(..); a.e.act;
   acts_next(&a))`; number: the act's in the list. */
typedef struct acts_at {
  effect_at e;
  int number;
} acts_at;
acts_at acts_first(const ph_top *top, ph_wide t, const ph_wide x[]);
void acts_next(acts_at *a);

/* States of their own. */
int acts_states(const ph_top *top);
/* Adds their torques to N, body axes, but the motors' of wheels, and a bound of their terms to
 * *size. */
void acts_torque(const ph_top *top, ph_wide t, const ph_wide x[], ph_wide N[3], ph_wide *size);
/* Adds their forces to F, inertial axes. */
void acts_force(const ph_top *top, ph_wide t, const ph_wide x[], ph_wide F[3]);
/* Rates of own states into dx, but the wheels'. */
void acts_rates(const ph_top *top, ph_wide t, const ph_wide x[], ph_wide dx[]);
ph_wide acts_potential(const ph_top *top, const ph_wide x[]);
/* The rate at which the body's axes turn, less w. */
void acts_slip(const ph_top *top, const ph_wide x[], ph_wide slip[3]);
/* What moving parts add to the tensor; 0: none move. */
int acts_tensor(const ph_top *top, const ph_wide x[], ph_wide D[6]);
/* What changes its sign where the equations have corners or jumps: how many, and their values. */
int acts_sides(const ph_top *top);
void acts_side(const ph_top *top, ph_wide t, const ph_wide x[], ph_wide side[]);
/* Are there functions of the caller's that do not say where they have corners? */
int acts_unseen(const ph_top *top);
/* The part of the step h from t up to the next row of a table. */
ph_wide acts_until(const ph_top *top, ph_wide t, ph_wide h);
/* Is number `place` of the state the speed of a wheel? */
int acts_is_wheel(const ph_top *top, int place);
/* Are there wheels or moving parts? Then w' and other rates have to be found together. */
int acts_coupled(const ph_top *top);
/* The act that constrains the body; e.act NULL: there is none. */
effect_at acts_constraint(const ph_top *top, ph_wide t, const ph_wide x[]);

/* ---- single.c: the effects that a top has one of ---- */

/* Adds their constants. */
void acts_load(const ph_top *top, const double u[3], motion_loads *loads);
/* V and their potential. */
ph_wide acts_add_potential(const ph_top *top, const ph_wide x[], ph_wide V);

/* ---- coupled.c: with wheels or moving parts ---- */

enum { ACTS_ROWS = 3 + PH_ACTS };

/* A y = b in n unknowns, y in place of b; 0 if singular. */
int acts_eliminate(int n, ph_wide A[ACTS_ROWS][ACTS_ROWS], ph_wide b[ACTS_ROWS]);

/* w' and the wheels' rates from the b of I w' = b (motion/motion.h), which knows nothing of them.
   PH_EROD. */
int acts_solve(const ph_top *top, ph_wide t, const ph_wide x[], const ph_wide b[3], ph_wide dx[]);
/* The torque from outside with which the state x has the accelerations rate. */
void acts_inverse(const ph_top *top, ph_wide t, const ph_wide x[], const ph_wide rate[3],
                  ph_wide N[3]);

/* ---- held.c: what wheels and moving parts hold ---- */

/* What moving parts add to the tensor, and the wheels that the body's tensor does not include, held
   still: with it the tensor is I of docs/mechanics.md. 0: nothing is added. */
int acts_locked(const ph_top *top, const ph_wide x[], ph_wide D[6]);
/* What they add to T and to the angular momentum in body axes. */
ph_wide acts_kinetic(const ph_top *top, const ph_wide x[]);
void acts_momentum(const ph_top *top, const ph_wide x[], ph_wide L[3]);
/* L of docs/mechanics.md, of all that turns, body axes. */
void acts_whole(const ph_top *top, const ph_wide x[], ph_wide L[3]);

#endif
