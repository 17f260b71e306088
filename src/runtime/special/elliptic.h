/* elliptic.h - elliptic integrals and functions in long double, for the library's own use.
   SPDX-License-Identifier: GPL-3.0-or-later

   Private. The modulus always comes as the complement kc = k', 0 < kc (k'^2 = 1 - m), so that
   nothing is lost as m -> 1. Arguments are valid; nothing is checked. */
#ifndef ELLIPTIC_H
#define ELLIPTIC_H

#include "numbers/pair.h"

/* Carlson's symmetric integrals (carlson.c). R_F, R_J: at most one of x, y, z is 0, p > 0; R_C:
   x >= 0, y > 0; R_D(x, y, z) = R_J(x, y, z, z). */
ph_wide carlson_rf(ph_wide x, ph_wide y, ph_wide z);
ph_wide carlson_rc(ph_wide x, ph_wide y);
ph_wide carlson_rj(ph_wide x, ph_wide y, ph_wide z, ph_wide p);
ph_wide carlson_rd(ph_wide x, ph_wide y, ph_wide z);

/* Complete integrals with twice the digits (elliptic_complete.c), kc > 0, p > 0, a, b >= 0:
   integral over [0, pi/2] of (a cos^2 + b sin^2) / ((cos^2 + p sin^2) sqrt(cos^2 + kc^2 sin^2)),
   Bulirsch's cel (Numer. Math. 13, 1969). K is p = a = b = 1. */
pair elliptic_cel(pair kc, pair p, pair a, pair b);
pair elliptic_k(pair kc);

/* sn, cn, dn of u, |u| <= K up to rounding; kc = 0: tanh and sech of any u. Pairs, because K - u
   decides the digits of a small cn. */
void elliptic_sncndn(pair u, pair K, ph_wide kc, ph_wide *sn, ph_wide *cn, ph_wide *dn);

#endif
