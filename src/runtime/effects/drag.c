/* drag.c - quadratic drag on the turning: N = -c |w| w.
   SPDX-License-Identifier: GPL-3.0-or-later */
#include "acts/acts.h"

static void torque(const effect_at *e, ph_wide N[3], ph_wide *size) {
  const ph_wide *w = e->x + 4, speed = wide_norm(w);
  const ph_wide factor = (ph_wide)e->act->of.drag.c * speed;
  for (int i = 0; i < 3; i++)
    N[i] -= factor * w[i];
  *size += fabsl(factor) * speed;
}

static void term_torque(const effect_terms *e, double term[3]) {
  const double factor = e->act->of.drag.c * effect_norm(e->x + 4);
  for (int i = 0; i < 3; i++)
    effect_raise(&term[i], factor * fabs(e->x[4 + i]));
}

struct given {
  double c;
};

static const effect_field fields[] = {{"c", EFFECT_NUMBERS, 1, offsetof(struct given, c), NULL},
                                      {0}};

static int add(ph_top *top, const void *given) {
  const struct given *g = given;
  return ph_top_quadratic(top, g->c);
}

const effect_table effect_drag = {.name = "drag",
                                  .kind = PH_QUADRATIC,
                                  .fields = fields,
                                  .size = sizeof(struct given),
                                  .add = add,
                                  .torque = torque,
                                  .term_torque = term_torque};

int ph_top_quadratic(ph_top *top, double c) {
  ph_act *act;
  if (c < 0)
    return PH_EBOUND;
  if (!isfinite(c))
    return PH_EFINITE;
  const int status = acts_new(top, &effect_drag, 0, 0, NULL, &act);
  if (!status)
    act->of.drag.c = c;
  return status;
}
