/* control.c - the torque that a controller gives, body axes: N = u.
   SPDX-License-Identifier: GPL-3.0-or-later */
#include "acts/acts.h"

static void load(const ph_top *top, const double u[3], motion_loads *loads) {
  for (int i = 0; i < 3 && top->effects & PH_CONTROL && u; i++)
    loads->body[i] += (ph_wide)u[i];
}

static void term_torque(const effect_terms *e, double term[3]) {
  for (int i = 0; i < 3 && e->top->effects & PH_CONTROL && e->u; i++)
    effect_raise(&term[i], fabs(e->u[i]));
}

static const effect_field fields[] = {{0}};

static int add(ph_top *top, const void *given) {
  (void)given;
  return ph_top_control(top);
}

const effect_table effect_control = {.name = "control",
                                     .kind = PH_CONTROL,
                                     .fields = fields,
                                     .size = 1,
                                     .add = add,
                                     .inputs = 3,
                                     .load = load,
                                     .term_torque = term_torque};

int ph_top_control(ph_top *top) {
  top->effects |= PH_CONTROL;
  return PH_OK;
}
