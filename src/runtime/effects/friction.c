/* friction.c - dry friction, smooth through rest: N = -T w/sqrt(w.w + s^2).
   SPDX-License-Identifier: GPL-3.0-or-later */
#include "acts/acts.h"

static void torque(const effect_at *e, ph_wide N[3], ph_wide *size) {
  const ph_wide *w = e->x + 4, speed = wide_norm(w);
  const ph_wide factor =
      (ph_wide)e->act->of.friction.torque / hypotl(speed, (ph_wide)e->act->of.friction.smoothing);
  for (int i = 0; i < 3; i++)
    N[i] -= factor * w[i];
  *size += fabsl(factor) * speed;
}

static void term_torque(const effect_terms *e, double term[3]) {
  const double factor =
      e->act->of.friction.torque / hypot(effect_norm(e->x + 4), e->act->of.friction.smoothing);
  for (int i = 0; i < 3; i++)
    effect_raise(&term[i], factor * fabs(e->x[4 + i]));
}

struct given {
  double torque, smoothing;
};

static const effect_field fields[] = {
    {"torque", EFFECT_NUMBERS, 1, offsetof(struct given, torque), NULL},
    {"smoothing", EFFECT_NUMBERS, 1, offsetof(struct given, smoothing), NULL},
    {0}};

static int add(ph_top *top, const void *given) {
  const struct given *g = given;
  return ph_top_friction(top, g->torque, g->smoothing);
}

const effect_table effect_friction = {.name = "friction",
                                      .kind = PH_FRICTION,
                                      .fields = fields,
                                      .size = sizeof(struct given),
                                      .add = add,
                                      .torque = torque,
                                      .term_torque = term_torque};

int ph_top_friction(ph_top *top, double T, double s) {
  ph_act *act;
  if (T < 0 || s <= 0)
    return PH_EBOUND;
  if (!isfinite(T) || !isfinite(s))
    return PH_EFINITE;
  const int status = acts_new(top, &effect_friction, 0, 0, NULL, &act);
  if (!status) {
    act->of.friction.torque = T;
    act->of.friction.smoothing = s;
  }
  return status;
}
