/* polhode_exact.h - the part of libpolhode that needs no integration; polhode.h includes it.
   SPDX-License-Identifier: GPL-3.0-or-later

   The conventions are those of polhode.h. */
#ifndef POLHODE_EXACT_H
#define POLHODE_EXACT_H

#include "polhode.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- the free top, exact at any time ---- */

enum ph_free_kind {
  PH_FREE_CONSTANT,  /* w does not change: rest, a sphere, a spin about a principal axis */
  PH_FREE_ROD,       /* no moment about the body's own axis */
  PH_FREE_PERIODIC,  /* every other body and state; the symmetric top is modulus 0 */
  PH_FREE_SEPARATRIX /* exactly L^2 = 2 T I2: tends to a spin about the middle axis, not periodic */
};

/* One motion of a free top. Angles are not reduced: turn is what the body turns about L, right hand
   about L, while w goes round once, so (turn, period) say where the body is after any number of
   periods. Where the rates are not periodic, period is infinite and turn 0. */
typedef struct ph_free_top {
  int kind;          /* enum ph_free_kind */
  double T, L;       /* kinetic energy, |angular momentum| */
  double m, mc;      /* the parameter k^2 and 1 - k^2 of the elliptic functions */
  double period;     /* of the polhode, s */
  double turn;       /* about L in a period, rad */
  double precession; /* mean rate about L, rad/s: turn / period, or its limit */
  /* prepared, private; [2] are sums of two */
  long double m_wide, period_wide, turn_wide, precession_wide;
  long double moment[3], axis[3][3], B[3], sign, lambda, K, kc, kappa, nu, u0;
  long double half_rate[2], turn_rate[2], half_turn[2], q[4], p[4], w[3], Ls[3];
} ph_free_top;

/* The free top in closed form from state x0 at t = 0: the classification, the modulus and all
   rates, with twice the digits of long double. Whether the state is on the separatrix is decided by
   an exact sum. Rates by Jacobi's functions, attitude by Carlson's integrals. PH_EMETHOD if an
   effect is switched on; PH_EFINITE, PH_EQUATERNION, PH_ERANGE. */
int ph_free_top_solve(ph_free_top *out, const ph_top *top, const double x0[7]);
/* The state at time t, either sign, in bounded time; q is the one that goes on continuously from
   q0. In attitude and rates (relative to the largest) right to 1e-15 while the phases stay below
   1e18 rad. PH_EFINITE, PH_ERANGE. */
int ph_free_top_at(const ph_free_top *f, double t, double x[7]);
/* The first time after t when the middle component of the angular momentum changes its sign: the
   top "flips" there when it moves near the separatrix. Infinite if that does not happen again. */
int ph_free_top_flip(const ph_free_top *f, double t, double *when);

/* ---- the free top, linearised ---- */

/* The small-oscillation state at time t after x0: the spin w about the nearest principal axis is
   kept, the transverse rates, e w at first, oscillate or grow (ph_top_stability). Rates and
   attitude are exact for a symmetric top about its axis, a rod about its line, a sphere, a pure
   spin, at any amplitude. Else the rates are wrong by O(e^2) w and a phase that runs away by O(e^2)
   of a turn each period, and so is the attitude, by O(e^2) w t about the axis; L, made of these
   rates, keeps its direction in space. x may be x0. PH_EMETHOD if an effect is switched on;
   PH_EFINITE, PH_EQUATERNION, PH_ERANGE. */
int ph_top_linearised(const ph_top *top, const double x0[7], double t, double x[7]);

/* ---- elliptic integrals and functions ---- */

/* The parameter m = k^2, 0 <= m <= 1, or its complement: 1 - m tells moduli near 1 apart. */
typedef struct ph_modulus {
  int complement;
  double value;
} ph_modulus;
ph_modulus ph_modulus_m(double m);
ph_modulus ph_modulus_mc(double mc);

/* Legendre's integrals, complete (phi = pi/2) and incomplete with any real phi; the characteristic
   n < 1: Pi = integral of dx / ((1 - n sin^2 x) sqrt(1 - m sin^2 x)). Right to 1 ulp (2 for |phi| >
   1e15). PH_EBOUND: m outside [0, 1] or n >= 1; PH_ERANGE: infinite (m = 1). */
int ph_elliptic_complete_k(ph_modulus m, double *K);
int ph_elliptic_complete_e(ph_modulus m, double *E);
int ph_elliptic_complete_pi(double n, ph_modulus m, double *Pi);
int ph_elliptic_f(double phi, ph_modulus m, double *F);
int ph_elliptic_e(double phi, ph_modulus m, double *E);
int ph_elliptic_pi(double n, double phi, ph_modulus m, double *Pi);

/* Jacobi's functions of any real u; am is the amplitude that goes on continuously from 0. u is
   reduced by the period with twice the digits of long double, so that it may be 1e15. */
typedef struct ph_jacobi {
  double sn, cn, dn, am;
} ph_jacobi;
int ph_elliptic_jacobi(double u, ph_modulus m, ph_jacobi *out);

#ifdef __cplusplus
}
#endif

#endif
