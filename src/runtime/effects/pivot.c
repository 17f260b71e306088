/* pivot.c - the support moves: N = R x q* (-m a(t)) q for its acceleration a.
   SPDX-License-Identifier: GPL-3.0-or-later */
#include "acts/acts.h"

#include <string.h>

static void torque(const effect_at *e, ph_wide N[3], ph_wide *size) {
  const ph_act *act = e->act;
  const ph_wide rate = (ph_wide)act->of.pivot.rate;
  ph_wide push[3], part[3];
  for (int i = 0; i < 3; i++)
    push[i] = (ph_wide)e->top->mass * (act->of.pivot.vibrates
                                           ? (ph_wide)act->of.pivot.amplitude * rate * rate *
                                                 cosl(rate * e->t) * (ph_wide)act->of.pivot.axis[i]
                                           : -acts_value(e, e->t, &act->of.pivot.acceleration[i]));
  wide_sandwich(e->x, push, 0, push);
  wide_cross(e->top->wide_com, push, part);
  for (int i = 0; i < 3; i++)
    N[i] += part[i];
  *size += wide_norm(e->top->wide_com) * wide_norm(push);
}

static const ph_varying *varying(const ph_act *act, int *n) {
  *n = 3;
  return act->of.pivot.acceleration;
}

static void term_torque(const effect_terms *e, double term[3]) {
  const double rate = e->act->of.pivot.rate, size = e->act->of.pivot.amplitude * rate * rate;
  double part[3];
  for (int i = 0; i < 3; i++)
    part[i] = e->act->of.pivot.vibrates ? size * e->act->of.pivot.axis[i] * (1 + fabs(rate * e->t))
                                        : effect_size(e, &e->act->of.pivot.acceleration[i]);
  const double most = e->top->mass * effect_norm(e->top->com) * effect_norm(part) * effect_q2(e);
  for (int i = 0; i < 3; i++)
    effect_raise(&term[i], most);
}

struct given {
  ph_varying acceleration[3];
  double amplitude, rate, axis[3];
  int accelerates;
};

static const double none[3];
static const effect_field fields[] = {
    {"acceleration", EFFECT_GIVEN, 0, offsetof(struct given, accelerates), NULL},
    {"acceleration", EFFECT_VARYING, 3, offsetof(struct given, acceleration), NULL},
    {"amplitude", EFFECT_NUMBERS, 1, offsetof(struct given, amplitude), none},
    {"rate", EFFECT_NUMBERS, 1, offsetof(struct given, rate), none},
    {"axis", EFFECT_NUMBERS, 3, offsetof(struct given, axis), none},
    {0}};

static int add(ph_top *top, const void *given) {
  const struct given *g = given;
  return g->accelerates ? ph_top_pivot(top, g->acceleration)
                        : ph_top_vibration(top, g->amplitude, g->rate, g->axis);
}

const effect_table effect_pivot = {.name = "pivot",
                                   .kind = PH_PIVOT,
                                   .fields = fields,
                                   .size = sizeof(struct given),
                                   .add = add,
                                   .torque = torque,
                                   .varying = varying,
                                   .term_torque = term_torque};

int ph_top_vibration(ph_top *top, double amplitude, double rate, const double axis[3]) {
  double unit[3];
  ph_act *act;
  int status = acts_unit(axis, unit);
  if (!status && !(isfinite(amplitude) && isfinite(rate)))
    status = PH_EFINITE;
  if (!status)
    status = acts_new(top, &effect_pivot, 0, 0, NULL, &act);
  if (status)
    return status;
  act->of.pivot.amplitude = amplitude;
  act->of.pivot.rate = rate;
  for (int i = 0; i < 3; i++)
    act->of.pivot.axis[i] = unit[i];
  act->of.pivot.vibrates = 1;
  return PH_OK;
}

int ph_top_pivot(ph_top *top, const ph_varying acceleration[3]) {
  ph_act *act;
  const int status = acts_new(top, &effect_pivot, 0, 3, acceleration, &act);
  if (!status)
    memcpy(act->of.pivot.acceleration, acceleration, sizeof act->of.pivot.acceleration);
  return status;
}
