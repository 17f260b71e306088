/* motion.h - the equations of motion in long double, for the library's own use.
   SPDX-License-Identifier: GPL-3.0-or-later

   Private: motion.c defines them, integrate/taylor.c and integrate/step.c integrate them. States
   are x = (q, w) or (q, w, r, v), u may be NULL. */
#ifndef MOTION_H
#define MOTION_H

#include "numbers/wide.h"

/* Force of gravity M g d, constant torques, what rotors hold, as long doubles: zero when the effect
 * is off. */
typedef struct motion_loads {
  ph_wide weight[3], inertial[3], body[3], damping[9], decay, rotor[3];
} motion_loads;

void motion_load(const ph_top *top, const double u[3], motion_loads *loads);

/* w' from the b of I w' = b, that is N - w x I w; about axes without moment w' = 0. size < 0: take
   it for granted that no torque acts there, else PH_EROD when a torque above 32 ulp of size
   does. */
int motion_solve(const ph_top *top, const ph_wide b[3], ph_wide size, ph_wide w_rate[3]);

/* A bound of the terms of I w' = N - w x I w but those of a constraint, N m. */
ph_wide motion_torque_size(const ph_top *top, const motion_loads *loads, ph_wide t,
                           const ph_wide x[]);

/* x' = f(t, x), ph_top_states(top) numbers; PH_OK or PH_EROD. */
int motion_rates(const ph_top *top, const motion_loads *loads, ph_wide t, const ph_wide x[],
                 ph_wide dx[]);

#endif
