/* hard_cases.c - the hard motions of make hard-peers, and the textbook's equations.
   SPDX-License-Identifier: GPL-3.0-or-later

   Moments ascend where the oracle is the free top's. The bound is the error in rates (relative to
   the largest) and attitude that a user of a relative tolerance of 1e-12 may hope for: a thousand
   of them. */
#include "hard_peers.h"

#include <math.h>

#define TURN 0.70710678118654752
#define Q                                                                                          \
  { 1, 0, 0, 0 }

const struct motion hard_motions[] = {
    {.name = "moments equal but for 1e-12",
     .hard = "differences of moments have 4 digits",
     .I = {1, 1.000000000001, 1.000000000002},
     .w = {1, 1, 1},
     .q = Q,
     .t = 1000,
     .bound = 1e-9},
    {.name = "needle, 1e-8",
     .hard = "one moment is 1e-8 of the others",
     .I = {1e-8, 1, 1.000000001},
     .w = {100, 1, 0.5},
     .q = Q,
     .t = 100,
     .bound = 1e-9},
    {.name = "within 1e-10 of the separatrix",
     .hard = "each passage multiplies errors",
     .I = {3, 4, 6},
     .w = {2, 0, 1.0000000001},
     .q = Q,
     .t = 100,
     .bound = 1e-9},
    {.name = "within 1e-10 on the other side",
     .hard = "the same, with other turns",
     .I = {3, 4, 6},
     .w = {2.0000000001, 0, 1},
     .q = Q,
     .t = 100,
     .bound = 1e-9},
    {.name = "on the separatrix",
     .hard = "exact data; any rounding leaves it",
     .I = {3, 4, 6},
     .w = {2, 0, 1},
     .q = Q,
     .t = 100,
     .bound = 1e-9},
    {.name = "spin 1e-300 off the middle axis",
     .hard = "falls over after 1197 s",
     .I = {1, 2, 3},
     .w = {1e-300, 1, 0},
     .q = Q,
     .t = 1300,
     .bound = 1e-9},
    {.name = "a time of 1e9 s",
     .hard = "1e8 turns",
     .I = {1, 2, 3},
     .w = {1, 1, 1},
     .q = Q,
     .t = 1e9,
     .bound = 1e-9},
    {.name = "moments 1e30, rates 1e-30",
     .hard = "scales; products of rates are 1e-60",
     .I = {1e30, 2e30, 3e30},
     .w = {1e-30, 1e-30, 1e-30},
     .q = Q,
     .t = 2e31,
     .bound = 1e-9},
    {.name = "moments 1e-30, rates 1e30",
     .hard = "scales; a step is 1e-32 s",
     .I = {1e-30, 2e-30, 3e-30},
     .w = {1e30, 1e30, 1e30},
     .q = Q,
     .t = 2e-29,
     .bound = 1e-9},
    {.name = "rates that are denormal",
     .hard = "products of rates are 0",
     .I = {1, 2, 3},
     .w = {3e-309, 1e-309, 2e-309},
     .q = Q,
     .t = 1e308,
     .bound = 1e-9},
    {.name = "zero everything",
     .hard = "nothing to scale steps by",
     .I = {1, 2, 3},
     .w = {0, 0, 0},
     .q = Q,
     .t = 100,
     .bound = 1e-9},
    {.name = "sleeping top at the critical spin",
     .hard = "double root; 1e-8 off upright",
     .I = {1, 1, 0.5},
     .load = {0, 0, 1},
     .w = {1e-8, 0, 4},
     .q = Q,
     .t = 100,
     .oracle = HEAVY,
     .bound = 1e-9},
    {.name = "sleeping top below it",
     .hard = "falls from 1e-12 off upright",
     .I = {1, 1, 0.5},
     .load = {0, 0, 1},
     .w = {1e-12, 0, 3},
     .q = Q,
     .t = 60,
     .oracle = HEAVY,
     .bound = 1e-9},
    {.name = "cusps",
     .hard = "let go at rest but for its spin",
     .I = {1, 1, 0.5},
     .load = {0, 0, 1},
     .w = {0, 0, 20},
     .q = {TURN, TURN, 0, 0},
     .t = 200,
     .oracle = HEAVY,
     .bound = 1e-9},
    {.name = "stiff damping, c/I = 1e6",
     .hard = "over after 1e-5 s, and then 1 s of nothing",
     .I = {1, 1, 1},
     .c = 1e6,
     .w = {0, 0, 1e6},
     .q = Q,
     .t = 1,
     .oracle = ANALYTIC,
     .turn = 1,
     .bound = 1e-9},
    {.name = "dry friction, at rest after 1 s",
     .hard = "sign(w) smoothed over 1e-9 rad/s: a rate of 1e9",
     .I = {1, 1, 1},
     .T = 1,
     .s = 1e-9,
     .w = {0, 0, 1},
     .q = Q,
     .t = 10,
     .oracle = ANALYTIC,
     .turn = 0.5, /* (w sqrt(w^2 + s^2) + s^2 asinh(w/s))/2 I/T = 0.5 + 1.1e-17 */
     .bound = 1e-9},
    {.name = "a wheel saturates at 1 s",
     .hard = "its torque ends; an adaptive step may pass over that",
     .I = {1, 1, 1},
     .torque = {0, 0, 1},
     .off = 1,
     .w = {0, 0, 0},
     .q = Q,
     .t = 3,
     .oracle = ANALYTIC,
     .wz = 1,
     .turn = 2.5,
     .bound = 1e-9},
    {.name = "mass burns to 1e-9",
     .hard = "w = L/I grows to 1e9",
     .I = {1, 1, 1},
     .burn = 1,
     .w = {0, 0, 1},
     .q = Q,
     .t = 0.999999999,
     .oracle = ANALYTIC,
     .wz = 0,
     .bound = 1e-6},
};
const int hard_motion_count = sizeof hard_motions / sizeof hard_motions[0];

int hard_rates(double t, const double x[], double dx[], void *run) {
  struct peer_run *r = run;
  const struct motion *m = r->m;
  const double *q = x, *w = x + 4;
  if (++r->calls > BUDGET)
    return 1;
  const double left = m->burn > 0 ? 1 - t / m->burn : 1,
               I[3] = {m->I[0] * left, m->I[1] * left, m->I[2] * left};
  const double g[3] = {2 * (q[1] * q[3] - q[0] * q[2]), 2 * (q[2] * q[3] + q[0] * q[1]),
                       q[0] * q[0] - q[1] * q[1] - q[2] * q[2] + q[3] * q[3]};
  const double rub =
      m->T > 0 ? m->T / sqrt(w[0] * w[0] + w[1] * w[1] + w[2] * w[2] + m->s * m->s) : 0;
  for (int i = 0; i < 3; i++) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    double N = (m->I[j] - m->I[k]) * left * w[j] * w[k] + g[j] * m->load[k] - g[k] * m->load[j];
    N -= (m->c + rub) * w[i];
    if (t < m->off)
      N += m->torque[i];
    if (m->burn > 0)
      N += m->I[i] / m->burn * w[i];
    dx[4 + i] = N / I[i];
  }
  dx[0] = -(q[1] * w[0] + q[2] * w[1] + q[3] * w[2]) / 2;
  dx[1] = (q[0] * w[0] + q[2] * w[2] - q[3] * w[1]) / 2;
  dx[2] = (q[0] * w[1] + q[3] * w[0] - q[1] * w[2]) / 2;
  dx[3] = (q[0] * w[2] + q[1] * w[1] - q[2] * w[0]) / 2;
  return 0;
}
