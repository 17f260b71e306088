/* rotor.c - a rotor of constant relative momentum h (gyrostat): -w x h to the torque, h to L.
   SPDX-License-Identifier: GPL-3.0-or-later */
#include "acts/acts.h"

#include <string.h>

static void load(const ph_top *top, const double u[3], motion_loads *loads) {
  (void)u;
  if (top->effects & PH_ROTOR)
    wide_load(3, top->rotor, loads->rotor);
}

static void term_torque(const effect_terms *e, double term[3]) {
  const double *w = e->x + 4, *h = e->top->rotor;
  for (int j = 0; j < 3 && e->top->effects & PH_ROTOR; j++) {
    const int a = (j + 1) % 3, b = (j + 2) % 3;
    effect_raise(&term[j], effect_larger(fabs(w[a] * h[b]), fabs(w[b] * h[a])));
  }
}

static void term_momentum(const effect_terms *e, double *scale) {
  if (e->top->effects & PH_ROTOR)
    effect_raise(scale, effect_norm(e->top->rotor));
}

struct given {
  double momentum[3];
};

static const effect_field fields[] = {
    {"momentum", EFFECT_NUMBERS, 3, offsetof(struct given, momentum), NULL}, {0}};

/* Several add up. */
static int add(ph_top *top, const void *given) {
  const struct given *g = given;
  double sum[3];
  for (int i = 0; i < 3; i++)
    sum[i] = (top->effects & PH_ROTOR ? top->rotor[i] : 0) + g->momentum[i];
  return ph_top_rotor(top, sum);
}

const effect_table effect_rotor = {.name = "rotor",
                                   .kind = PH_ROTOR,
                                   .fields = fields,
                                   .size = sizeof(struct given),
                                   .add = add,
                                   .load = load,
                                   .term_torque = term_torque,
                                   .term_momentum = term_momentum};

int ph_top_rotor(ph_top *top, const double momentum[3]) {
  if (!wide_finite(3, momentum))
    return PH_EFINITE;
  memcpy(top->rotor, momentum, sizeof top->rotor);
  top->effects |= PH_ROTOR;
  return PH_OK;
}
