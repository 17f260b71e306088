/* acts.c - torques, forces and potentials of the effects of polhode_acts.h.
   SPDX-License-Identifier: GPL-3.0-or-later

   What v[] of an act holds: PH_QUADRATIC c; PH_FRICTION T, s; PH_SPRING three stiffnesses, or one
   if flag is set, then four of the rest attitude, then the axis if flag is set; PH_MAGNETIC m, B,
   rate; PH_WHEEL axis, J. */
#include "acts.h"

/* ---- what varies ---- */

/* The row before t by bisection, then the chord: not a sum of ramps. */
static ph_wide interpolated(int n, const double tv[], ph_wide t) {
  int lo = 0, hi = n - 1;
  if (t <= (ph_wide)tv[0])
    return (ph_wide)tv[1];
  if (t >= (ph_wide)tv[2 * hi])
    return (ph_wide)tv[2 * hi + 1];
  while (hi - lo > 1) {
    const int middle = lo + (hi - lo) / 2;
    if (t < (ph_wide)tv[2 * middle])
      hi = middle;
    else
      lo = middle;
  }
  const ph_wide t0 = (ph_wide)tv[2 * lo], t1 = (ph_wide)tv[2 * hi];
  const ph_wide part = (t - t0) / (t1 - t0);
  return (1 - part) * (ph_wide)tv[2 * lo + 1] + part * (ph_wide)tv[2 * hi + 1];
}

ph_wide acts_value(const ph_varying *v, ph_wide t, const ph_wide x[]) {
  if (v->f)
    return v->f(v->context, t, x);
  return v->rows > 0 ? interpolated(v->rows, v->table, t) : (ph_wide)v->value;
}

static void until(const ph_varying *v, ph_wide t, ph_wide *h) {
  for (int i = 0; i < v->rows && !v->f; i++) {
    const ph_wide step = (ph_wide)v->table[2 * i] - t;
    const ph_wide least = 16 * LDBL_EPSILON * fmaxl(fabsl(t), fabsl(t + step));
    if (step * *h > 0 && fabsl(step) > least && fabsl(step) < fabsl(*h))
      *h = step;
  }
}

ph_wide acts_until(const ph_top *top, ph_wide t, ph_wide h) {
  for (int k = 0; k < top->acts.n; k++) {
    const ph_act *a = &top->acts.list[k];
    if (top->effects & a->kind)
      for (int i = 0; i < 3; i++)
        until(&a->torque[i], t, &h);
  }
  return h;
}

/* ---- torques ---- */

/* (p0, u) = rest* q and K u. */
static void twisted(const ph_act *a, const ph_wide q[4], ph_wide p[4], ph_wide Ku[3]) {
  const ph_wide back[4] = {(ph_wide)a->v[3], -(ph_wide)a->v[4], -(ph_wide)a->v[5],
                           -(ph_wide)a->v[6]};
  wide_quat_multiply(back, q, p);
  if (a->flag) {
    ph_wide axis[3];
    wide_load(3, a->v + 7, axis);
    const ph_wide along = (ph_wide)a->v[0] * wide_dot(axis, p + 1);
    for (int i = 0; i < 3; i++)
      Ku[i] = along * axis[i];
  } else {
    for (int i = 0; i < 3; i++)
      Ku[i] = (ph_wide)a->v[i] * p[1 + i];
  }
}

static void field_at(const ph_act *a, ph_wide t, ph_wide B[3]) {
  wide_load(3, a->v + 3, B);
  if (a->flag) { /* turned about z as a complex number */
    const ph_wide c = cosl((ph_wide)a->v[6] * t), s = sinl((ph_wide)a->v[6] * t);
    const ph_wide x = c * B[0] - s * B[1], y = s * B[0] + c * B[1];
    B[0] = x, B[1] = y;
  }
}

static void torque_of(const ph_act *a, ph_wide t, const ph_wide x[], ph_wide N[3], ph_wide *size) {
  const ph_wide *w = x + 4;
  ph_wide p[4], Ku[3], m[3], B[3], factor = 0;
  switch (a->kind) {
  case PH_QUADRATIC:
    factor = (ph_wide)a->v[0] * wide_norm(w);
    break;
  case PH_FRICTION:
    factor = (ph_wide)a->v[0] / hypotl(wide_norm(w), (ph_wide)a->v[1]);
    break;
  case PH_SPRING: /* dV = 4 Ku.du, du = (p0 d + u x d)/2 for a turn d of the body */
    twisted(a, x, p, Ku);
    wide_cross(p + 1, Ku, N);
    for (int i = 0; i < 3; i++)
      N[i] = 2 * N[i] - 2 * p[0] * Ku[i];
    *size += 4 * wide_norm(Ku);
    return;
  case PH_MAGNETIC:
    wide_load(3, a->v, m);
    field_at(a, t, B);
    wide_sandwich(x, B, 0, B);
    wide_cross(m, B, N);
    *size += wide_norm(m) * wide_norm(B);
    return;
  case PH_VARYING:
  case PH_CUSTOM:
    for (int i = 0; i < 3; i++)
      N[i] = acts_value(&a->torque[i], t, x);
    if (a->kind == PH_VARYING && a->flag)
      wide_sandwich(x, N, 0, N);
    *size += wide_norm(N);
    return;
  default:
    break;
  }
  for (int i = 0; i < 3; i++)
    N[i] = -factor * w[i];
  *size += fabsl(factor) * wide_norm(w);
}

void acts_torque(const ph_top *top, ph_wide t, const ph_wide x[], ph_wide N[3], ph_wide *size) {
  for (int k = 0; k < top->acts.n; k++) {
    const ph_act *a = &top->acts.list[k];
    ph_wide part[3];
    if (!(top->effects & a->kind) || a->kind == PH_WHEEL)
      continue;
    if (a->kind >= PH_GRADIENT)
      acts_torque_more(top, k, t, x, part, size);
    else
      torque_of(a, t, x, part, size);
    for (int i = 0; i < 3; i++)
      N[i] += part[i];
  }
}

/* ---- custom acts: forces and states ---- */

int acts_states(const ph_top *top) {
  int n = 0;
  for (int k = 0; k < top->acts.n; k++)
    if (top->effects & top->acts.list[k].kind)
      n += top->acts.list[k].states;
  return n;
}

int acts_place(const ph_top *top, int i) {
  int n = top->effects & PH_TRANSLATION ? 13 : 7;
  for (int k = 0; k < i; k++)
    if (top->effects & top->acts.list[k].kind)
      n += top->acts.list[k].states;
  return n;
}

void acts_force(const ph_top *top, ph_wide t, const ph_wide x[], ph_wide F[3]) {
  acts_force_more(top, x, F);
  for (int k = 0; k < top->acts.n && top->effects & PH_CUSTOM; k++) {
    const ph_act *a = &top->acts.list[k];
    for (int i = 0; i < 3 && a->kind == PH_CUSTOM; i++)
      F[i] += acts_value(&a->force[i], t, x);
  }
}

void acts_rates(const ph_top *top, ph_wide t, const ph_wide x[], ph_wide dx[]) {
  acts_rates_more(top, x, dx);
  for (int k = 0; k < top->acts.n && top->effects & PH_CUSTOM; k++) {
    const ph_act *a = &top->acts.list[k];
    for (int i = 0; i < a->states && a->kind == PH_CUSTOM; i++)
      dx[acts_place(top, k) + i] = acts_value(&a->rate[i], t, x);
  }
}

ph_wide acts_potential(const ph_top *top, const ph_wide x[]) {
  ph_wide V = 0, p[4], Ku[3], m[3], B[3];
  for (int k = 0; k < top->acts.n; k++) {
    const ph_act *a = &top->acts.list[k];
    if (!(top->effects & a->kind))
      continue;
    if (a->kind == PH_SPRING) {
      twisted(a, x, p, Ku);
      V += 2 * wide_dot(p + 1, Ku);
    } else if (a->kind == PH_MAGNETIC && !a->flag) {
      wide_load(3, a->v, m);
      field_at(a, 0, B);
      wide_sandwich(x, m, 1, m);
      V -= wide_dot(m, B);
    } else if (a->kind == PH_CUSTOM) {
      V += acts_value(&a->potential, 0, x);
    }
  }
  return V;
}
