/* wheels.c - reaction wheels: the linear system that gives w' and the wheels' rates at once.
   SPDX-License-Identifier: GPL-3.0-or-later

   With I the tensor of the body with all wheels locked, and for each wheel J (a.w + W)' = u,
     I w' + sum J W' a = b - w x sum J W a,      J a.w' + J W' = u
   3 + n equations, solved as they stand by elimination with row pivots: what the wheels take from
   the tensor is never subtracted. b of motion/motion.h belongs to the body's own tensor; a wheel
   that is not in it adds J a a^T, and to b its -w x J (a.w) a. */
#include "acts.h"

enum { ROWS = 3 + PH_ACTS };

static int is_wheel(const ph_top *top, int k) {
  return k < top->acts.n && top->effects & PH_WHEEL && top->acts.list[k].kind == PH_WHEEL;
}

/* A y = b in n unknowns, y in place of b; 0 if singular. */
static int eliminate(int n, ph_wide A[ROWS][ROWS], ph_wide b[ROWS]) {
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
  ph_wide A[ROWS][ROWS] = {{0}}, y[ROWS], h[3] = {0}, turning[3], locked[6];
  int n = 3, place[ROWS];
  for (int i = 0; i < 6; i++)
    locked[i] = top->wide_inertia[i];
  for (int k = 0; k < top->acts.n; k++) {
    if (!is_wheel(top, k))
      continue;
    const ph_act *a = &top->acts.list[k];
    ph_wide axis[3];
    wide_load(3, a->v, axis);
    const ph_wide J = (ph_wide)a->v[3];
    place[n] = acts_place(top, k);
    const ph_wide speed = x[place[n]] + (a->flag ? 0 : wide_dot(axis, x + 4));
    if (!a->flag)
      wide_add_outer(locked, J, axis);
    for (int i = 0; i < 3; i++) {
      h[i] += J * speed * axis[i];
      A[i][n] = A[n][i] = J * axis[i];
    }
    A[n][n] = J;
    y[n++] = acts_value(&a->torque[0], t, x);
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
  if (!eliminate(n, A, y))
    return PH_EROD;
  for (int i = 0; i < n; i++)
    dx[i < 3 ? 4 + i : place[i]] = y[i];
  return PH_OK;
}

/* T of the body's own tensor is in the caller's sum: an included wheel moves in it as if locked. */
ph_wide acts_kinetic(const ph_top *top, const ph_wide x[]) {
  ph_wide T = 0, D[6], Dw[3];
  if (acts_tensor(top, x, D)) {
    wide_apply(D, x + 4, Dw);
    T = wide_dot(x + 4, Dw) / 2;
  }
  for (int k = 0; k < top->acts.n; k++)
    if (is_wheel(top, k)) {
      const ph_act *a = &top->acts.list[k];
      ph_wide axis[3];
      wide_load(3, a->v, axis);
      const ph_wide W = x[acts_place(top, k)], along = wide_dot(axis, x + 4);
      T += (ph_wide)a->v[3] / 2 * (a->flag ? W * (W + 2 * along) : (W + along) * (W + along));
    }
  return T;
}

void acts_momentum(const ph_top *top, const ph_wide x[], ph_wide L[3]) {
  ph_wide D[6], Dw[3];
  if (acts_tensor(top, x, D)) {
    wide_apply(D, x + 4, Dw);
    for (int i = 0; i < 3; i++)
      L[i] += Dw[i];
  }
  for (int k = 0; k < top->acts.n; k++)
    if (is_wheel(top, k)) {
      const ph_act *a = &top->acts.list[k];
      ph_wide axis[3];
      wide_load(3, a->v, axis);
      const ph_wide speed = x[acts_place(top, k)] + (a->flag ? 0 : wide_dot(axis, x + 4));
      for (int i = 0; i < 3; i++)
        L[i] += (ph_wide)a->v[3] * speed * axis[i];
    }
}

int acts_locked(const ph_top *top, const ph_wide x[], ph_wide D[6]) {
  int any = acts_tensor(top, x, D);
  for (int k = 0; k < top->acts.n; k++)
    if (is_wheel(top, k) && !top->acts.list[k].flag) {
      ph_wide axis[3];
      wide_load(3, top->acts.list[k].v, axis);
      wide_add_outer(D, (ph_wide)top->acts.list[k].v[3], axis);
      any = 1;
    }
  return any;
}

void acts_whole(const ph_top *top, const ph_wide x[], ph_wide L[3]) {
  wide_apply(top->wide_inertia, x + 4, L);
  acts_momentum(top, x, L);
  for (int i = 0; i < 3 && top->effects & PH_ROTOR; i++)
    L[i] += (ph_wide)top->rotor[i];
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
  for (int k = 0; k < top->acts.n; k++) {
    const ph_act *a = &top->acts.list[k];
    if (is_wheel(top, k)) {
      ph_wide axis[3] = {0};
      wide_load(3, a->v, axis);
      const ph_wide u = acts_value(&a->torque[0], t, x) - (ph_wide)a->v[3] * wide_dot(axis, rate);
      for (int i = 0; i < 3; i++)
        N[i] += u * axis[i];
    } else if (a->kind == PH_PARTS && top->effects & PH_PARTS) {
      for (int i = 0; i < 6; i++)
        D[i] = acts_value(&a->rate[6 + i], 0, x);
      wide_apply(D, w, part);
      for (int i = 0; i < 3; i++)
        N[i] += part[i];
    }
  }
}

/* Positive definite by the pivots of the tensor without the included wheels. */
static int positive(const ph_top *top) {
  ph_wide I[6], A[3][3];
  for (int i = 0; i < 6; i++)
    I[i] = top->wide_inertia[i];
  for (int k = 0; k < top->acts.n; k++)
    if (top->acts.list[k].kind == PH_WHEEL && top->acts.list[k].flag) {
      ph_wide axis[3];
      wide_load(3, top->acts.list[k].v, axis);
      wide_add_outer(I, -(ph_wide)top->acts.list[k].v[3], axis);
    }
  static const int at[3][3] = {{XX, XY, XZ}, {XY, YY, YZ}, {XZ, YZ, ZZ}};
  for (int i = 0; i < 9; i++)
    A[i / 3][i % 3] = I[at[i / 3][i % 3]];
  for (int c = 0; c < 3; c++) {
    if (!(A[c][c] > 0))
      return 0;
    for (int r = c + 1; r < 3; r++)
      for (int k = 2; k >= c; k--)
        A[r][k] -= A[r][c] / A[c][c] * A[c][k];
  }
  return 1;
}

int ph_top_wheel(ph_top *top, const double axis[3], double J, ph_varying torque, int included) {
  ph_wide a[3];
  if (!wide_finite(3, axis) || !isfinite(J))
    return PH_EFINITE;
  wide_load(3, axis, a);
  const ph_wide length = wide_norm(a);
  if (!(length > 0))
    return PH_EDIRECTION;
  if (!(J > 0))
    return PH_EPOSITIVE;
  if (!(top->wide_moment[0] > 0))
    return PH_EROD;
  ph_act *act;
  const int status = acts_new(top, PH_WHEEL, 1, 1, &torque, &act);
  if (status)
    return status;
  for (int i = 0; i < 3; i++)
    act->v[i] = (double)(a[i] / length);
  act->v[3] = J;
  act->flag = included != 0;
  act->torque[0] = torque;
  if (!positive(top)) {
    top->acts.n--;
    return PH_EPOSITIVE;
  }
  top->effects |= PH_WHEEL;
  return PH_OK;
}
