/* euler.c - what the lecture derives in principal axes: Euler's equations, the symmetric top,
   stability.
   SPDX-License-Identifier: GPL-3.0-or-later

   These are the textbook's formulas on purpose (Landau and Lifshitz, Mechanics, 33, 36, 37), so
   that the general road of motion.c can be held against them. Differences of moments are formed
   exactly in long double before anything is multiplied, so nearly symmetric bodies lose nothing. */
#include "numbers/wide.h"

static int moments_check(int n, const double moment[]) {
  if (!wide_finite(n, moment))
    return PH_EFINITE;
  for (int i = 0; i < n; i++)
    if (!(moment[i] > 0))
      return PH_EPOSITIVE;
  return PH_OK;
}

/* I1 w1' = N1 + (I2 - I3) w2 w3, cyclic (Landau and Lifshitz, 36.5). */
int ph_euler_rates(const double moment[3], const double w[3], const double N[3], double w_rate[3]) {
  const int status = moments_check(3, moment);
  if (status)
    return status;
  if (!wide_finite(3, w) || (N && !wide_finite(3, N)))
    return PH_EFINITE;
  ph_wide rate[3];
  for (int i = 0; i < 3; i++) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const ph_wide difference = (ph_wide)moment[j] - (ph_wide)moment[k];
    rate[i] =
        ((N ? (ph_wide)N[i] : 0) + difference * (ph_wide)w[j] * (ph_wide)w[k]) / (ph_wide)moment[i];
  }
  return wide_store(3, rate, w_rate);
}

/* Angles are arctangents of two lengths, never arccosines: exact near 0 and pi, and 0 for a top at
 * rest. */
int ph_symmetric_top(double I1, double I3, const double w[3], ph_symmetric *out) {
  const int status = moments_check(2, (const double[]){I1, I3});
  if (status)
    return status;
  if (!wide_finite(3, w))
    return PH_EFINITE;
  const ph_wide a = (ph_wide)I1, c = (ph_wide)I3, w3 = (ph_wide)w[2];
  const ph_wide across = hypotl((ph_wide)w[0], (ph_wide)w[1]);
  const ph_wide L = hypotl(a * across, c * w3);
  const ph_wide v[7] = {
      (c - a) / a * w3,
      L / a,
      atan2l(across, w3),
      /* w and L lie in one plane with the axis: their angle from its tangent, (I3 - I1) w_across w3
         over w.L */
      fabsl(atan2l((c - a) * across * w3, a * across * across + c * w3 * w3)),
      atan2l(a * across, c * w3),
      (a * across * across + c * w3 * w3) / 2,
      L,
  };
  double d[7];
  const int stored = wide_store(7, v, d);
  if (stored)
    return stored;
  *out = (ph_symmetric){d[0], d[1], d[2], d[3], d[4], d[5], d[6]};
  return PH_OK;
}

/* Unit quaternion of a turn by angle about e (a unit vector, or anything if angle is 0). */
static void turn_about(const ph_wide e[3], ph_wide angle, ph_wide q[4]) {
  q[0] = cosl(angle / 2);
  for (int i = 0; i < 3; i++)
    q[1 + i] = sinl(angle / 2) * e[i];
}

/* w' = (-Omega w2, Omega w1, 0). L is fixed in space, so the body turns about L at |L|/I1 (which
   carries the axis around) and about its own axis at w3 - L3/I1 = -Omega. Both phases are formed in
   long double: at 1000 revolutions they are good to 1e-16 rad. */
int ph_symmetric_at(double I1, double I3, const double x0[7], double t, double x[7]) {
  const int status = moments_check(2, (const double[]){I1, I3});
  if (status)
    return status;
  if (!wide_finite(7, x0) || !isfinite(t))
    return PH_EFINITE;
  ph_wide q[4], outer[4], inner[4], w[3], L[3];
  const int unit = wide_load_unit(x0, q);
  if (unit)
    return unit;
  wide_load(3, x0 + 4, w);
  const ph_wide a = (ph_wide)I1, c = (ph_wide)I3, Omega = (c - a) / a * w[2];
  L[0] = a * w[0], L[1] = a * w[1], L[2] = c * w[2];
  wide_sandwich(q, L, 1, L);
  const ph_wide size = wide_norm(L), e3[3] = {0, 0, 1};
  for (int i = 0; i < 3; i++)
    L[i] = size > 0 ? L[i] / size : 0;
  turn_about(L, size / a * (ph_wide)t, outer);
  turn_about(e3, -Omega * (ph_wide)t, inner);
  wide_quat_multiply(outer, q, outer);
  wide_quat_multiply(outer, inner, q);
  const ph_wide co = cosl(Omega * (ph_wide)t), si = sinl(Omega * (ph_wide)t);
  const ph_wide state[7] = {q[0], q[1], q[2], q[3], co * w[0] - si * w[1], si * w[0] + co * w[1],
                            w[2]};
  return wide_store(7, state, x);
}

/* Linear in what is across the spin: w_i'' = -Omega1 Omega2 w_i. The verdict is the sign of a
   product of two exact differences, so no tolerance decides it. */
int ph_top_stability(const double moment[3], int k, double s, ph_stability *out) {
  const int status = moments_check(3, moment);
  if (status)
    return status;
  if (!isfinite(s))
    return PH_EFINITE;
  if (k < 0 || k > 2)
    return PH_ECOUNT;
  const int i = (k + 1) % 3, j = (k + 2) % 3;
  const ph_wide Ii = (ph_wide)moment[i], Ij = (ph_wide)moment[j], Ik = (ph_wide)moment[k];
  const ph_wide one = (Ik - Ij) / Ii * (ph_wide)s, two = (Ik - Ii) / Ij * (ph_wide)s;
  const ph_wide squared = one * two, rate = sqrtl(fabsl(squared));
  const ph_wide v[4] = {one, two, squared, rate};
  double d[4];
  const int stored = wide_store(4, v, d);
  if (stored)
    return stored;
  const ph_wide pi = 3.14159265358979323846264338327950288L;
  *out = (ph_stability){.Omega1 = d[0], .Omega2 = d[1], .Omega_squared = d[2], .rate = d[3]};
  out->verdict = squared > 0 ? PH_STABLE : squared < 0 ? PH_UNSTABLE : PH_NEUTRAL;
  out->period = out->verdict == PH_STABLE ? (double)(2 * pi / rate) : HUGE_VAL;
  return PH_OK;
}
