/* move.h - translation and the turning frame in long double, for the library's own use.
   SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MOVE_H
#define MOVE_H

#include "numbers/wide.h"

/* Strengths per unit mass, zero where the effect is off. */
typedef struct move_loads {
  ph_wide gravity[3], stiffness[3], linear, drag;
} move_loads;

/* effects/translation.c */
void move_load(const ph_top *top, move_loads *loads);

/* Omega and Omega' at time t, zero without a frame: effects/rotating_frame.c. */
void move_frame(const ph_top *top, ph_wide t, ph_wide Omega[3], ph_wide change[3]);

/* dx comes with q' = q (0, w)/2; the frame's part is added, and r', v' where the top moves. */
void move_rates(const ph_top *top, ph_wide t, const ph_wide x[], ph_wide dx[]);

/* A bound of the terms of m v', or 0 where nothing moves: N. */
ph_wide move_force_size(const ph_top *top, ph_wide t, const ph_wide x[]);

/* m v^2/2; and the potentials of forces and of a steady frame. */
ph_wide move_kinetic(const ph_top *top, const ph_wide x[]);
ph_wide move_potential(const ph_top *top, const ph_wide x[]);

/* A rate (1/s) at which r, v and the frame change, or 0. */
ph_wide move_rate(const ph_top *top, ph_wide t, const ph_wide x[]);

#endif
