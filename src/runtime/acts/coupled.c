/* coupled.c - wheels and moving parts: the linear system that gives w' and the wheels' rates.
   SPDX-License-Identifier: GPL-3.0-or-later

   With I the tensor of the body with all wheels locked, and for each wheel J (a.w + W)' = u,
     I w' + sum J W' a = b - w x sum J W a,      J a.w' + J W' = u
   3 + n equations, solved as they stand by elimination with row pivots: what the wheels take from
   the tensor is never subtracted. b of motion/motion.h belongs to the body's own tensor; a wheel
   that is not in it adds J a a^T, and to b its -w x J (a.w) a. */
#include "acts.h"

/* Gauss and Jordan with row pivots: A becomes diagonal, no second pass is needed. */
int acts_eliminate(int n, ph_wide A[ACTS_ROWS][ACTS_ROWS], ph_wide b[ACTS_ROWS]) {
  for (int c = 0; c < n; c++) {
    int best = c;
    for (int r = c + 1; r < n; r++)
      if (fabsl(A[r][c]) > fabsl(A[best][c]))
        best = r;
    if (!(fabsl(A[best][c]) > 0))
      return 0;
    for (int k = 0; k < n; k++) {
      const ph_wide swap = A[c][k];
      A[c][k] = A[best][k], A[best][k] = swap;
    }
    const ph_wide swap = b[c];
    b[c] = b[best], b[best] = swap;
    for (int r = 0; r < n; r++) {
      const ph_wide factor = r == c ? 0 : A[r][c] / A[c][c];
      for (int k = c; k < n; k++)
        A[r][k] -= factor * A[c][k];
      b[r] -= factor * b[c];
    }
  }
  for (int r = 0; r < n; r++)
    b[r] /= A[r][r];
  return 1;
}

int acts_solve(const ph_top *top, ph_wide t, const ph_wide x[], const ph_wide b[3], ph_wide dx[]) {
  static const int at[3][3] = {{XX, XY, XZ}, {XY, YY, YZ}, {XZ, YZ, ZZ}};
  ph_wide A[ACTS_ROWS][ACTS_ROWS] = {{0}}, y[ACTS_ROWS], h[3] = {0}, turning[3], locked[6];
  int n = 3, place[ACTS_ROWS];
  for (int i = 0; i < 6; i++)
    locked[i] = top->wide_inertia[i];
  for (acts_at a = acts_first(top, t, x); a.e.act; acts_next(&a)) {
    if (!a.e.act->effect->wheel)
      continue;
    effect_spinner wheel;
    a.e.act->effect->wheel(a.e.act, &wheel);
    const ph_wide J = wheel.J;
    place[n] = a.e.place;
    const ph_wide speed = x[place[n]] + (wheel.included ? 0 : wide_dot(wheel.axis, x + 4));
    if (!wheel.included)
      wide_add_outer(locked, J, wheel.axis);
    for (int i = 0; i < 3; i++) {
      h[i] += J * speed * wheel.axis[i];
      A[i][n] = A[n][i] = J * wheel.axis[i];
    }
    A[n][n] = J;
    y[n++] = a.e.act->effect->motor(&a.e);
  }
  ph_wide D[6], Dw[3];
  if (acts_tensor(top, x,
                  D)) { /* moving parts: their D w turns with the body like what wheels hold */
    wide_apply(D, x + 4, Dw);
    for (int i = 0; i < 3; i++)
      h[i] += Dw[i];
    for (int i = 0; i < 6; i++)
      locked[i] += D[i];
  }
  wide_cross(x + 4, h, turning);
  for (int i = 0; i < 3; i++) {
    for (int j = 0; j < 3; j++)
      A[i][j] = locked[at[i][j]];
    y[i] = b[i] - turning[i];
  }
  if (!acts_eliminate(n, A, y))
    return PH_EROD;
  for (int i = 0; i < n; i++)
    dx[i < 3 ? 4 + i : place[i]] = y[i];
  return PH_OK;
}

/* I w' + sum J W' a + D' w + W x L with J W' = u - J a.w', I that of acts_locked, W the rate at
   which the axes turn; w x I w of the body's own tensor as -w x S w. */
void acts_inverse(const ph_top *top, ph_wide t, const ph_wide x[], const ph_wide rate[3],
                  ph_wide N[3]) {
  const ph_wide *w = x + 4;
  ph_wide held[3] = {0}, L[3] = {0}, slip[3] = {0}, D[6] = {0}, part[3];
  wide_apply(top->wide_inertia, rate, N);
  wide_apply(top->wide_second, w, L);
  wide_cross(w, L, part);
  for (int i = 0; i < 3; i++)
    N[i] -= part[i];
  acts_momentum(top, x, held);
  for (int i = 0; i < 3 && top->effects & PH_ROTOR; i++)
    held[i] += (ph_wide)top->rotor[i];
  wide_cross(w, held, part);
  for (int i = 0; i < 3; i++)
    N[i] += part[i];
  acts_whole(top, x, L);
  acts_slip(top, x, slip);
  wide_cross(slip, L, part);
  for (int i = 0; i < 3; i++)
    N[i] += part[i];
  if (acts_locked(top, x, D)) {
    wide_apply(D, rate, part);
    for (int i = 0; i < 3; i++)
      N[i] += part[i];
  }
  for (acts_at a = acts_first(top, t, x); a.e.act; acts_next(&a)) {
    const effect_table *effect = a.e.act->effect;
    if (effect->wheel) {
      effect_spinner wheel = {{0}, 0, 0};
      effect->wheel(a.e.act, &wheel);
      const ph_wide u = effect->motor(&a.e) - wheel.J * wide_dot(wheel.axis, rate);
      for (int i = 0; i < 3; i++)
        N[i] += u * wheel.axis[i];
    } else if (effect->tensor_rate) {
      for (int i = 0; i < 6; i++)
        D[i] = 0;
      effect->tensor_rate(&a.e, D);
      wide_apply(D, w, part);
      for (int i = 0; i < 3; i++)
        N[i] += part[i];
    }
  }
}
