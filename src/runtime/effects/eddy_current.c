/* eddy_current.c - a conductor that turns in a uniform field: N = -k B x (w x B).
   SPDX-License-Identifier: GPL-3.0-or-later

   Youngquist and others, Am. J. Phys. 84 (2016) 181. In inertial axes, where B stands still: the
   currents make the moment m = k w x B, and N = m x B. */
#include "acts/acts.h"

static void torque(const effect_at *e, ph_wide N[3], ph_wide *size) {
  ph_wide w[3], B[3], m[3], part[3];
  wide_load(3, e->act->of.eddy_current.field, B);
  wide_sandwich(e->x, e->x + 4, 1, w);
  wide_cross(w, B, m);
  wide_cross(m, B, part);
  wide_sandwich(e->x, part, 0, part);
  for (int i = 0; i < 3; i++)
    N[i] += (ph_wide)e->act->of.eddy_current.k * part[i];
  *size += (ph_wide)e->act->of.eddy_current.k * wide_norm(w) * wide_dot(B, B);
}

static void term_torque(const effect_terms *e, double term[3]) {
  const double B = effect_norm(e->act->of.eddy_current.field) * effect_q2(e);
  for (int i = 0; i < 3; i++)
    effect_raise(&term[i], e->act->of.eddy_current.k * B * B * effect_norm(e->x + 4));
}

struct given {
  double k, field[3];
};

static const effect_field fields[] = {
    {"k", EFFECT_NUMBERS, 1, offsetof(struct given, k), NULL},
    {"field", EFFECT_NUMBERS, 3, offsetof(struct given, field), NULL},
    {0}};

static int add(ph_top *top, const void *given) {
  const struct given *g = given;
  return ph_top_eddy_current(top, g->k, g->field);
}

const effect_table effect_eddy_current = {.name = "eddy_current",
                                          .kind = PH_EDDY_CURRENT,
                                          .fields = fields,
                                          .size = sizeof(struct given),
                                          .add = add,
                                          .torque = torque,
                                          .term_torque = term_torque};

int ph_top_eddy_current(ph_top *top, double k, const double field[3]) {
  ph_act *act;
  if (k < 0)
    return PH_EBOUND;
  if (!isfinite(k) || !wide_finite(3, field))
    return PH_EFINITE;
  const int status = acts_new(top, &effect_eddy_current, 0, 0, NULL, &act);
  if (status)
    return status;
  act->of.eddy_current.k = k;
  for (int i = 0; i < 3; i++)
    act->of.eddy_current.field[i] = field[i];
  return PH_OK;
}
