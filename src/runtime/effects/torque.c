/* torque.c - a torque that is given: constant, in body or in inertial axes, or varying.
   SPDX-License-Identifier: GPL-3.0-or-later */
#include "acts/acts.h"

#include <string.h>

static void load(const ph_top *top, const double u[3], motion_loads *loads) {
  (void)u;
  for (int i = 0; i < 3; i++) {
    if (top->effects & PH_TORQUE_INERTIAL)
      loads->inertial[i] = (ph_wide)top->torque_inertial[i];
    if (top->effects & PH_TORQUE_BODY)
      loads->body[i] += (ph_wide)top->torque_body[i];
  }
}

/* Of an act: it varies. */
static void torque(const effect_at *e, ph_wide N[3], ph_wide *size) {
  ph_wide part[3];
  for (int i = 0; i < 3; i++)
    part[i] = acts_value(e, e->t, &e->act->of.torque.component[i]);
  if (e->act->of.torque.inertial)
    wide_sandwich(e->x, part, 0, part);
  for (int i = 0; i < 3; i++)
    N[i] += part[i];
  *size += wide_norm(part);
}

static const ph_varying *varying(const ph_act *act, int *n) {
  *n = 3;
  return act->of.torque.component;
}

static void term_torque(const effect_terms *e, double term[3]) {
  const unsigned effects = e->top->effects;
  double part[3];
  for (int i = 0; i < 3 && !e->act; i++) {
    if (effects & PH_TORQUE_INERTIAL)
      effect_raise(&term[i], effect_norm(e->top->torque_inertial) * effect_q2(e));
    if (effects & PH_TORQUE_BODY)
      effect_raise(&term[i], fabs(e->top->torque_body[i]));
  }
  if (!e->act)
    return;
  for (int i = 0; i < 3; i++)
    part[i] = effect_size(e, &e->act->of.torque.component[i]);
  for (int i = 0; i < 3; i++) {
    effect_raise(&term[i], part[i]);
    if (e->act->of.torque.inertial)
      effect_raise(&term[i], effect_norm(part) * effect_q2(e));
  }
}

struct given {
  double body[3], inertial[3];
  int varies, turned;
  ph_varying varying[3];
};

static const double none[3];
static const effect_field fields[] = {
    {"body", EFFECT_NUMBERS, 3, offsetof(struct given, body), none},
    {"inertial", EFFECT_NUMBERS, 3, offsetof(struct given, inertial), none},
    {"varying", EFFECT_GIVEN, 0, offsetof(struct given, varies), NULL},
    {"varying", EFFECT_VARYING, 3, offsetof(struct given, varying), NULL},
    {"turned", EFFECT_FLAG, 0, offsetof(struct given, turned), NULL}, /* varying in inertial axes */
    {0}};

static int is_there(const double v[3]) {
  return v[0] != 0 || v[1] != 0 || v[2] != 0;
}

/* Constant ones add up. */
static int add(ph_top *top, const void *given) {
  const struct given *g = given;
  double body[3], inertial[3];
  for (int i = 0; i < 3; i++) {
    body[i] = (top->effects & PH_TORQUE_BODY ? top->torque_body[i] : 0) + g->body[i];
    inertial[i] =
        (top->effects & PH_TORQUE_INERTIAL ? top->torque_inertial[i] : 0) + g->inertial[i];
  }
  int status = g->varies ? ph_top_varying(top, g->turned, g->varying) : PH_OK;
  if (!status && is_there(g->body))
    status = ph_top_torque_body(top, body);
  if (!status && is_there(g->inertial))
    status = ph_top_torque_inertial(top, inertial);
  return status;
}

const effect_table effect_torque = {.name = "torque",
                                    .kind = PH_VARYING,
                                    .fields = fields,
                                    .size = sizeof(struct given),
                                    .add = add,
                                    .load = load,
                                    .torque = torque,
                                    .varying = varying,
                                    .term_torque = term_torque};

int ph_top_torque_body(ph_top *top, const double torque_body[3]) {
  if (!wide_finite(3, torque_body))
    return PH_EFINITE;
  memcpy(top->torque_body, torque_body, sizeof top->torque_body);
  top->effects |= PH_TORQUE_BODY;
  return PH_OK;
}

int ph_top_torque_inertial(ph_top *top, const double torque_inertial[3]) {
  if (!wide_finite(3, torque_inertial))
    return PH_EFINITE;
  memcpy(top->torque_inertial, torque_inertial, sizeof top->torque_inertial);
  top->effects |= PH_TORQUE_INERTIAL;
  return PH_OK;
}

int ph_top_varying(ph_top *top, int inertial, const ph_varying component[3]) {
  ph_act *act;
  const int status = acts_new(top, &effect_torque, 0, 3, component, &act);
  if (status)
    return status;
  memcpy(act->of.torque.component, component, sizeof act->of.torque.component);
  act->of.torque.inertial = inertial != 0;
  return PH_OK;
}
