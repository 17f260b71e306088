/* move.c - the centre of mass in space, and base axes that turn.
   SPDX-License-Identifier: GPL-3.0-or-later

   Term by term as polhode_move.h writes them, each cross product formed on its own. */
#include "move.h"

#include "acts/acts.h"

int ph_top_states(const ph_top *top) {
  return (top->effects & PH_TRANSLATION ? 13 : 7) + acts_states(top);
}

void move_frame(const ph_top *top, ph_wide t, ph_wide Omega[3], ph_wide change[3]) {
  for (int i = 0; i < 3; i++) {
    change[i] = top->effects & PH_FRAME ? (ph_wide)top->move.rate_dot[i] : 0;
    Omega[i] = top->effects & PH_FRAME ? (ph_wide)top->move.rate[i] + change[i] * t : 0;
  }
}

void move_rates(const ph_top *top, ph_wide t, const ph_wide x[], ph_wide dx[]) {
  ph_wide Omega[3], change[3], u[3], a[3];
  move_frame(top, t, Omega, change);
  if (top->effects & PH_FRAME) {
    const ph_wide pure[4] = {0, Omega[0], Omega[1], Omega[2]};
    ph_wide turn[4];
    wide_quat_multiply(pure, x, turn);
    for (int i = 0; i < 4; i++)
      dx[i] -= turn[i] / 2;
  }
  if (!(top->effects & PH_TRANSLATION))
    return;
  const ph_wide *r = x + 7, *v = x + 10;
  const ph_wide speed = wide_norm(v);
  move_loads loads;
  move_load(top, &loads);
  for (int i = 0; i < 3; i++)
    a[i] =
        loads.gravity[i] - loads.stiffness[i] * r[i] - (loads.linear + loads.drag * speed) * v[i];
  ph_wide F[3] = {0, 0, 0};
  acts_force(top, t, x, F);
  for (int i = 0; i < 3; i++)
    a[i] += F[i] / (ph_wide)top->mass;
  wide_cross(Omega, v, u);
  for (int i = 0; i < 3; i++)
    a[i] -= 2 * u[i];
  wide_cross(change, r, u);
  for (int i = 0; i < 3; i++)
    a[i] -= u[i];
  wide_cross(Omega, r, u);
  wide_cross(Omega, u, u);
  for (int i = 0; i < 3; i++) {
    dx[7 + i] = v[i];
    dx[10 + i] = a[i] - (top->move.centrifugal ? u[i] : 0);
  }
}

ph_wide move_force_size(const ph_top *top, ph_wide t, const ph_wide x[]) {
  if (!(top->effects & PH_TRANSLATION))
    return 0;
  ph_wide Omega[3], change[3], F[3] = {0}, sum = 0;
  move_loads loads;
  move_load(top, &loads);
  move_frame(top, t, Omega, change);
  acts_force(top, t, x, F);
  const ph_wide turning = wide_norm(Omega), speed = wide_norm(x + 10);
  for (int i = 0; i < 3; i++)
    sum += fabsl(loads.gravity[i]) + fabsl(loads.stiffness[i] * x[7 + i]);
  sum += (loads.linear + loads.drag * speed + 2 * turning) * speed;
  sum += (turning * turning + wide_norm(change)) * wide_norm(x + 7);
  return (ph_wide)top->mass * sum + wide_norm(F);
}

ph_wide move_kinetic(const ph_top *top, const ph_wide x[]) {
  return top->effects & PH_TRANSLATION ? (ph_wide)top->mass * wide_dot(x + 10, x + 10) / 2 : 0;
}

ph_wide move_potential(const ph_top *top, const ph_wide x[]) {
  ph_wide V = 0, Omega[3], change[3], L[3], u[3];
  move_frame(top, 0, Omega, change);
  const int steady = change[0] == 0 && change[1] == 0 && change[2] == 0;
  if (steady) {
    acts_whole(top, x, L);
    wide_sandwich(x, L, 1, L);
    V -= wide_dot(Omega, L);
  }
  if (!(top->effects & PH_TRANSLATION))
    return V;
  for (int i = 0; i < 3; i++) {
    V -= (ph_wide)top->mass * (ph_wide)top->move.gravity[i] * x[7 + i];
    if (top->effects & PH_RESTORING)
      V += (ph_wide)top->move.stiffness[i] * x[7 + i] * x[7 + i] / 2;
  }
  wide_cross(Omega, x + 7, u);
  return steady && top->move.centrifugal ? V - (ph_wide)top->mass * wide_dot(u, u) / 2 : V;
}

ph_wide move_rate(const ph_top *top, ph_wide t, const ph_wide x[]) {
  ph_wide Omega[3], change[3], k = 0, rate = 0;
  move_frame(top, t, Omega, change);
  if (top->effects & PH_TRANSLATION) {
    move_loads loads;
    move_load(top, &loads);
    for (int i = 0; i < 3; i++)
      k = fmaxl(k, fabsl(loads.stiffness[i]));
    rate = sqrtl(k) + loads.linear + loads.drag * wide_norm(x + 10);
  }
  return rate + wide_norm(Omega) + sqrtl(wide_norm(change));
}
