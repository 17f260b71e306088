%% -- analysis.h -- their contracts: part of scene.h.  SPDX-License-Identifier: MIT-0
/* ---- stability, small oscillations ---- */

/* Spin s about principal axis k (0, 1, 2) of the three moments I, slightly disturbed (i, j, k in
 * cyclic order):
 *     w_i' = -Omega1 w_j,    w_j' = Omega2 w_i
 *     Omega1 = (I_k - I_j)/I_i s,    Omega2 = (I_k - I_i)/I_j s
 * Omega[0], Omega[1] are these; *rate = sqrt |Omega1 Omega2|: the oscillation's angular frequency
 * (period 2 pi/rate) or the growth rate, 1/s.  Returns 1 stable, -1 unstable, 0 neutral (equal
 * moments or no spin). */
int ${name}_stability(const ${name}_real I[3], int k, ${name}_real s,
    ${name}_real Omega[2], ${name}_real *rate);

/* The small-oscillation solution: rates w (principal axes) at time t after w0, the spin about axis
 * k taken as constant.  Exact for a symmetric top about its axis; else its error is of second order
 * in the disturbance. */
void ${name}_linearised(const ${name}_real I[3], int k, const ${name}_real w0[3],
    ${name}_real t, ${name}_real w[3]);
