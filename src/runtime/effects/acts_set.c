/* acts_set.c - the calls of polhode_acts.h that add an effect, but the wheel's.
   SPDX-License-Identifier: GPL-3.0-or-later */
#include "acts.h"

#include <string.h>

static int varying_check(const ph_varying *v) {
  if (v->f)
    return PH_OK;
  if (v->rows == 0)
    return isfinite(v->value) ? PH_OK : PH_EFINITE;
  if (v->rows < 2 || !v->table)
    return PH_ECOUNT;
  if (!wide_finite(2 * v->rows, v->table))
    return PH_EFINITE;
  for (int i = 1; i < v->rows; i++)
    if (!(v->table[2 * i] > v->table[2 * i - 2]))
      return PH_ECOUNT;
  return PH_OK;
}

int acts_new(ph_top *top, enum ph_act_kind kind, int states, int n, const ph_varying v[],
             ph_act **act) {
  int own = states;
  for (int k = 0; k < top->acts.n; k++)
    own += top->acts.list[k].states;
  if (top->acts.n >= PH_ACTS || states < 0 || own > PH_OWN_STATES)
    return PH_ECOUNT;
  for (int i = 0; i < n; i++) {
    const int status = varying_check(&v[i]);
    if (status)
      return status;
  }
  *act = &top->acts.list[top->acts.n++];
  memset(*act, 0, sizeof **act);
  (*act)->kind = kind;
  (*act)->states = states;
  return PH_OK;
}

/* An act of numbers alone, switched on. */
static int add(ph_top *top, enum ph_act_kind kind, int n, const double v[], ph_act **act) {
  if (!wide_finite(n, v))
    return PH_EFINITE;
  const int status = acts_new(top, kind, 0, 0, NULL, act);
  if (status)
    return status;
  memcpy((*act)->v, v, (size_t)n * sizeof v[0]);
  top->effects |= kind;
  return PH_OK;
}

int ph_top_quadratic(ph_top *top, double c) {
  ph_act *act;
  return c < 0 ? PH_EBOUND : add(top, PH_QUADRATIC, 1, &c, &act);
}

int ph_top_friction(ph_top *top, double T, double s) {
  const double v[2] = {T, s};
  ph_act *act;
  return T < 0 || s <= 0 ? PH_EBOUND : add(top, PH_FRICTION, 2, v, &act);
}

static int spring(ph_top *top, const double v[10], int one) {
  ph_wide q[4];
  ph_act *act;
  int status = wide_load_unit(v + 3, q);
  if (!status)
    status = add(top, PH_SPRING, 10, v, &act);
  for (int i = 0; i < 4 && !status; i++)
    act->v[3 + i] = (double)q[i];
  if (!status)
    act->flag = one;
  return status;
}

int ph_top_spring(ph_top *top, const double k[3], const double rest[4]) {
  const double v[10] = {k[0], k[1], k[2], rest[0], rest[1], rest[2], rest[3]};
  return spring(top, v, 0);
}

int ph_top_spring_axis(ph_top *top, double k, const double axis[3], const double rest[4]) {
  ph_wide a[3];
  if (!wide_finite(3, axis))
    return PH_EFINITE;
  wide_load(3, axis, a);
  const ph_wide n = wide_norm(a);
  if (!(n > 0))
    return PH_EDIRECTION;
  const double v[10] = {k,
                        0,
                        0,
                        rest[0],
                        rest[1],
                        rest[2],
                        rest[3],
                        (double)(a[0] / n),
                        (double)(a[1] / n),
                        (double)(a[2] / n)};
  return spring(top, v, 1);
}

int ph_top_magnetic(ph_top *top, const double moment[3], const double field[3], int turns,
                    double rate) {
  const double v[7] = {moment[0], moment[1], moment[2], field[0], field[1], field[2], rate};
  ph_act *act;
  const int status = add(top, PH_MAGNETIC, 7, v, &act);
  if (!status)
    act->flag = turns != 0;
  return status;
}

int ph_top_varying(ph_top *top, int inertial, const ph_varying torque[3]) {
  ph_act *act;
  const int status = acts_new(top, PH_VARYING, 0, 3, torque, &act);
  if (status)
    return status;
  memcpy(act->torque, torque, sizeof act->torque);
  act->flag = inertial != 0;
  top->effects |= PH_VARYING;
  return PH_OK;
}

int ph_top_custom(ph_top *top, const ph_varying torque[3], const ph_varying force[3],
                  const ph_varying *potential, int n, const ph_varying rate[]) {
  ph_varying all[7 + PH_OWN_STATES] = {{0}};
  if (n < 0 || n > PH_OWN_STATES)
    return PH_ECOUNT;
  for (int i = 0; i < 3; i++) {
    if (torque)
      all[i] = torque[i];
    if (force)
      all[3 + i] = force[i];
  }
  if (potential)
    all[6] = *potential;
  for (int i = 0; i < n; i++)
    all[7 + i] = rate[i];
  ph_act *act;
  const int status = acts_new(top, PH_CUSTOM, n, 7 + n, all, &act);
  if (status)
    return status;
  memcpy(act->torque, all, sizeof act->torque);
  memcpy(act->force, all + 3, sizeof act->force);
  act->potential = all[6];
  memcpy(act->rate, all + 7, (size_t)n * sizeof all[0]);
  top->effects |= PH_CUSTOM;
  return PH_OK;
}
