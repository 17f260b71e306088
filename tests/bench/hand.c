/* hand.c - the plain hand-written RK4 that the emitted stepper is measured against.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "hand.h"

static void attitude(const double x[7], double dx[7]) {
  dx[0] = -0.5 * (x[1] * x[4] + x[2] * x[5] + x[3] * x[6]);
  dx[1] = 0.5 * (x[0] * x[4] + x[2] * x[6] - x[3] * x[5]);
  dx[2] = 0.5 * (x[0] * x[5] + x[3] * x[4] - x[1] * x[6]);
  dx[3] = 0.5 * (x[0] * x[6] + x[1] * x[5] - x[2] * x[4]);
}

static void rhs_moments(const double I[3], const double x[7], double dx[7]) {
  attitude(x, dx);
  dx[4] = (I[1] - I[2]) * x[5] * x[6] / I[0];
  dx[5] = (I[2] - I[0]) * x[6] * x[4] / I[1];
  dx[6] = (I[0] - I[1]) * x[4] * x[5] / I[2];
}

static void rhs_quotients(const double c[3], const double x[7], double dx[7]) {
  attitude(x, dx);
  dx[4] = c[0] * x[5] * x[6];
  dx[5] = c[1] * x[6] * x[4];
  dx[6] = c[2] * x[4] * x[5];
}

#define RK4(rhs)                                                                                   \
  do {                                                                                             \
    double k1[7], k2[7], k3[7], k4[7], y[7];                                                       \
    int i;                                                                                         \
    rhs(p, x, k1);                                                                                 \
    for (i = 0; i < 7; i++)                                                                        \
      y[i] = x[i] + 0.5 * h * k1[i];                                                               \
    rhs(p, y, k2);                                                                                 \
    for (i = 0; i < 7; i++)                                                                        \
      y[i] = x[i] + 0.5 * h * k2[i];                                                               \
    rhs(p, y, k3);                                                                                 \
    for (i = 0; i < 7; i++)                                                                        \
      y[i] = x[i] + h * k3[i];                                                                     \
    rhs(p, y, k4);                                                                                 \
    for (i = 0; i < 7; i++)                                                                        \
      x[i] += h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]);                               \
  } while (0)

void hand_rk4_moments(const double p[3], double x[7], double h) {
  RK4(rhs_moments);
}

void hand_rk4_quotients(const double p[3], double x[7], double h) {
  RK4(rhs_quotients);
}
