/* free_top.h - parts of the free top's solution, for the library's own use.
   SPDX-License-Identifier: GPL-3.0-or-later

   Private: axes.c defines the first two for free_top.c, which gives integrate/run.c the last. */
#ifndef FREE_TOP_H
#define FREE_TOP_H

#include "numbers/pair.h"

/* Principal system with twice the digits, moments ascending, axes right-handed. */
void free_top_axes(const ph_wide tensor[6], pair moment[3], pair axis[3][3]);

/* I3 (I3 - I2) w3^2 - I1 (I2 - I1) w1^2, rounded once from the exact sum: its sign says on which
   side of the separatrix the motion is, and 0 is on it. */
pair free_top_side(const pair moment[3], const pair w[3]);

/* ph_free_top_at for a difference of two times; wide: before it is rounded, range unchecked. */
int free_top_at(const ph_free_top *f, pair t, double x[7]);
void free_top_at_wide(const ph_free_top *f, pair t, ph_wide v[7]);

#endif
