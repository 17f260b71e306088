/* hand.h - the plain hand-written RK4 that the emitted stepper is measured against.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * What a competent engineer types in ten minutes: a right-hand side, four calls, loops over seven
 * states; no normalisation of q.  Two versions: the moments in the right-hand side as in the
 * textbook, and their quotients formed once outside. Compiled on its own, with -O2, so that nothing
 * is inlined into the benchmark. */
#ifndef BENCH_HAND_H
#define BENCH_HAND_H

/* I: principal moments. */
void hand_rk4_moments(const double I[3], double x[7], double h);
/* c: (I2 - I3)/I1 and cyclic. */
void hand_rk4_quotients(const double c[3], double x[7], double h);

#endif
