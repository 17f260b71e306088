/* acts_more.c - largest terms of the acts of acts_more.c: gravity gradient, sunlight, moving
 * support, moving parts, energy sink. See run.c for what they are for.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "engine.h"

#include <math.h>

static double larger(double a, double b) {
  return a > b ? a : b;
}

static double norm(const double v[3]) {
  return hypot(hypot(v[0], v[1]), v[2]);
}

/* Largest entry of the tensor, and of what moving parts add to it. */
static double largest_moment(const ph_top *top, double t, const double x[]) {
  double most = 0, D[6];
  engine_acts_tensor(top, t, x, D);
  for (int i = 0; i < 6; i++)
    most = larger(most, fabs(top->inertia[i]) + fabs(D[i]));
  return most;
}

/* (1 + e)^n for (1 + e cos f)^n; a phase that is made of time turns by its own rounding. */
static double orbit(const ph_act *a, double t, double *rate) {
  const double e = a->flag ? a->v[2] : 0, p = a->v[1] * (1 - e) * (1 + e);
  const double strength = a->v[0] / (p * p * p);
  *rate = sqrt(strength) * (1 + e) * (1 + e);
  return 3 * strength * pow(1 + e, 3) * (a->flag ? 1 : 1 + fabs(*rate * t));
}

static double angular_momentum(const ph_top *top, double t, const double x[]) {
  return largest_moment(top, t, x) * norm(x + 4) + engine_acts_momentum(top, x) +
         (top->effects & PH_ROTOR ? norm(top->rotor) : 0);
}

double engine_acts_more(const ph_top *top, int k, double t, const double x[]) {
  const ph_act *a = &top->acts.list[k];
  const double q2 = x[0] * x[0] + x[1] * x[1] + x[2] * x[2] + x[3] * x[3], w = norm(x + 4);
  double most = 0, rate, part[3];
  switch (a->kind) {
  case PH_GRADIENT:
    return orbit(a, t, &rate) * largest_moment(top, t, x) * q2 * q2;
  case PH_SOLAR:
    for (int i = 0; i < a->rows; i++)
      most = larger(most, 2 * a->v[0] * a->table[8 * i] * norm(a->table + 8 * i + 5) * q2 * q2);
    return most;
  case PH_PIVOT:
    for (int i = 0; i < 3; i++)
      part[i] = a->flag ? a->v[0] * a->v[1] * a->v[1] * a->v[2 + i] * (1 + fabs(a->v[1] * t))
                        : engine_varying_size(top, &a->torque[i], t, x);
    return top->mass * norm(top->com) * norm(part) * q2;
  case PH_PARTS:
    for (int i = 0; i < 6; i++) {
      most = larger(most, engine_varying_size(top, &a->rate[i], t, x) * w * w);
      most = larger(most, engine_varying_size(top, &a->rate[6 + i], t, x) * w);
    }
    return most;
  default:
    return a->v[0] * pow(angular_momentum(top, t, x), 2) * w;
  }
}

void engine_acts_more_scale(const ph_top *top, double t, const double x[], double scale[]) {
  for (int k = 0; k < top->acts.n; k++) {
    const ph_act *a = &top->acts.list[k];
    if (!(top->effects & a->kind))
      continue;
    if (a->kind == PH_GRADIENT && a->flag)
      orbit(a, t, scale + engine_own_place(top, k));
    else if (a->kind == PH_PARTS)
      scale[engine_own_place(top, k)] = 1;
    else if (a->kind == PH_DISSIPATION)
      for (int i = 0; i < 4; i++)
        scale[i] = larger(scale[i], a->v[0] * angular_momentum(top, t, x) * norm(x + 4) / 2);
    for (int i = 0; i < a->rows && a->kind == PH_SOLAR && top->effects & PH_TRANSLATION; i++)
      for (int j = 0; j < 3; j++)
        scale[10 + j] = larger(scale[10 + j], 2 * a->v[0] * a->table[8 * i] / top->mass);
  }
}

int engine_acts_tensor(const ph_top *top, double t, const double x[], double D[6]) {
  int any = 0;
  for (int i = 0; i < 6; i++)
    D[i] = 0;
  for (int k = 0; k < top->acts.n && top->effects & PH_PARTS; k++)
    if (top->acts.list[k].kind == PH_PARTS) {
      any = 1;
      for (int i = 0; i < 6; i++)
        D[i] += engine_varying_value(top, &top->acts.list[k].rate[i], t, x);
    }
  return any;
}
