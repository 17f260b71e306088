/* polhode_move.h - translation and the turning base frame: part of polhode.h, which includes it.
   SPDX-License-Identifier: GPL-3.0-or-later

   With PH_TRANSLATION a top moves freely and turns about its centre of mass; its state is then
   x = (q, w, r, v), 13 numbers, with r and v of the centre of mass. With PH_FRAME the axes that are
   otherwise inertial turn: r, v and q are relative to them, w stays the inertial rate in body axes.
     m v' = m g - linear v - drag |v| v - (kx x, ky y, kz z) - 2 m Omega x v
            - m Omega x (Omega x r) - m Omega' x r,   q' = (q (0, w) - (0, Omega) q) / 2
   (Landau, Lifshitz, Mechanics, section 39; Goldstein 4.91.) Energy is that of the motion relative
   to the frame with the frame's own potential, -m (Omega x r)^2/2 - Omega.L, where Omega is
   constant (Jacobi's integral); where it changes, without that potential. */
#ifndef POLHODE_MOVE_H
#define POLHODE_MOVE_H

#include "polhode_acts.h" /* effects that there may be many of; PH_STATES */

#ifdef __cplusplus
extern "C" {
#endif

enum ph_move_effect { /* further bits of ph_top.effects */
                      PH_TRANSLATION = 64,
                      PH_DRAG = 128,      /* -linear v - drag |v| v */
                      PH_RESTORING = 256, /* -(kx x, ky y, kz z) */
                      PH_FRAME = 512
};

typedef struct ph_move {
  double gravity[3];           /* m/s2, in the base axes */
  double linear, drag;         /* N s/m, N s2/m2 */
  double stiffness[3];         /* N/m */
  double rate[3], rate_dot[3]; /* Omega = rate + rate_dot t in the frame's axes, rad/s, rad/s2 */
  int centrifugal;             /* 0: the term Omega x (Omega x r) is left out */
} ph_move;

struct ph_top;

/* Each sets its parameters and switches the effect on; ph_top_without switches it off. Translation:
   PH_EBOUND unless the top was made about its centre of mass. Drag must not be negative:
   PH_EPOSITIVE; a negative stiffness repels. */
int ph_top_translation(struct ph_top *top, const double gravity[3]);
int ph_top_drag(struct ph_top *top, double linear, double drag);
int ph_top_restoring(struct ph_top *top, const double stiffness[3]);
int ph_top_frame(struct ph_top *top, const double rate[3], const double rate_dot[3],
                 int centrifugal);
/* Length of the state: 7, or 13 with PH_TRANSLATION, and what polhode_acts.h adds. */
int ph_top_states(const struct ph_top *top);

#ifdef __cplusplus
}
#endif
#endif
