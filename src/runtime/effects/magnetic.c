/* magnetic.c - a magnetic moment of the body in a uniform field: N = m x q* B q.
   SPDX-License-Identifier: GPL-3.0-or-later

   The field stands still, with V = -m.(q* B q), or turns about inertial z. */
#include "acts/acts.h"

static void field_at(const ph_act *act, ph_wide t, ph_wide B[3]) {
  wide_load(3, act->of.magnetic.field, B);
  if (act->of.magnetic.turns) { /* turned about z as a complex number */
    const ph_wide rate = (ph_wide)act->of.magnetic.rate, c = cosl(rate * t), s = sinl(rate * t);
    const ph_wide x = c * B[0] - s * B[1], y = s * B[0] + c * B[1];
    B[0] = x, B[1] = y;
  }
}

static void torque(const effect_at *e, ph_wide N[3], ph_wide *size) {
  ph_wide m[3], B[3], part[3];
  wide_load(3, e->act->of.magnetic.moment, m);
  field_at(e->act, e->t, B);
  wide_sandwich(e->x, B, 0, B);
  wide_cross(m, B, part);
  for (int i = 0; i < 3; i++)
    N[i] += part[i];
  *size += wide_norm(m) * wide_norm(B);
}

static ph_wide potential(const effect_at *e) {
  ph_wide m[3], B[3];
  if (e->act->of.magnetic.turns)
    return 0;
  wide_load(3, e->act->of.magnetic.moment, m);
  field_at(e->act, 0, B);
  wide_sandwich(e->x, m, 1, m);
  return -wide_dot(m, B);
}

static double strength(const effect_terms *e) {
  return effect_norm(e->act->of.magnetic.moment) * effect_norm(e->act->of.magnetic.field);
}

static void term_torque(const effect_terms *e, double term[3]) {
  for (int i = 0; i < 3; i++)
    effect_raise(&term[i], strength(e) * effect_q2(e));
}

static void term_energy(const effect_terms *e, double *scale) {
  if (!e->act->of.magnetic.turns)
    effect_raise(scale, strength(e));
}

struct given {
  double moment[3], field[3], rate;
  int rotating;
};

static const effect_field fields[] = {
    {"moment", EFFECT_NUMBERS, 3, offsetof(struct given, moment), NULL},
    {"field", EFFECT_NUMBERS, 3, offsetof(struct given, field), NULL},
    {"rotating", EFFECT_FLAG, 0, offsetof(struct given, rotating), NULL},
    {"rate", EFFECT_NUMBERS, 1, offsetof(struct given, rate), NULL},
    {0}};

static int add(ph_top *top, const void *given) {
  const struct given *g = given;
  return ph_top_magnetic(top, g->moment, g->field, g->rotating, g->rate);
}

const effect_table effect_magnetic = {.name = "magnetic",
                                      .kind = PH_MAGNETIC,
                                      .fields = fields,
                                      .size = sizeof(struct given),
                                      .add = add,
                                      .torque = torque,
                                      .potential = potential,
                                      .term_torque = term_torque,
                                      .term_energy = term_energy};

int ph_top_magnetic(ph_top *top, const double moment[3], const double field[3], int turns,
                    double rate) {
  ph_act *act;
  if (!wide_finite(3, moment) || !wide_finite(3, field) || !isfinite(rate))
    return PH_EFINITE;
  const int status = acts_new(top, &effect_magnetic, 0, 0, NULL, &act);
  if (status)
    return status;
  for (int i = 0; i < 3; i++) {
    act->of.magnetic.moment[i] = moment[i];
    act->of.magnetic.field[i] = field[i];
  }
  act->of.magnetic.rate = rate;
  act->of.magnetic.turns = turns != 0;
  return PH_OK;
}
