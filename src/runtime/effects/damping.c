/* damping.c - linear damping: N = -C w, or in proportion to the momentum, N = -rate I w.
   SPDX-License-Identifier: GPL-3.0-or-later */
#include "acts/acts.h"

#include <string.h>

static void load(const ph_top *top, const double u[3], motion_loads *loads) {
  (void)u;
  if (top->effects & PH_DAMPING)
    wide_load(9, top->damping, loads->damping);
  if (top->effects & PH_DECAY)
    loads->decay = (ph_wide)top->decay;
}

static void term_torque(const effect_terms *e, double term[3]) {
  const double *w = e->x + 4;
  for (int j = 0; j < 3; j++)
    for (int k = 0; k < 3; k++) {
      if (e->top->effects & PH_DAMPING)
        effect_raise(&term[j], fabs(e->top->damping[3 * j + k] * w[k]));
      if (e->top->effects & PH_DECAY)
        effect_raise(&term[j], fabs(e->top->decay) * e->spread[3 * j + k] * fabs(w[k]));
    }
}

struct given {
  double rate, C[9];
  int decays, damps;
};

static const double none[9];
static const effect_field fields[] = {
    {"rate", EFFECT_GIVEN, 0, offsetof(struct given, decays), NULL},
    {"rate", EFFECT_NUMBERS, 1, offsetof(struct given, rate), none},
    {"C", EFFECT_GIVEN, 0, offsetof(struct given, damps), NULL},
    {"C", EFFECT_NUMBERS, 9, offsetof(struct given, C), none},
    {0}};

/* C w and rate L are different laws, so both may be there; several of one add up. */
static int add(ph_top *top, const void *given) {
  const struct given *g = given;
  const double decay = (top->effects & PH_DECAY ? top->decay : 0) + g->rate;
  double C[9];
  for (int i = 0; i < 9; i++)
    C[i] = (top->effects & PH_DAMPING ? top->damping[i] : 0) + g->C[i];
  const int status = g->damps ? ph_top_damping(top, C) : PH_OK;
  return status || !g->decays ? status : ph_top_decay(top, decay);
}

const effect_table effect_damping = {.name = "damping",
                                     .kind = PH_DAMPING,
                                     .fields = fields,
                                     .size = sizeof(struct given),
                                     .add = add,
                                     .load = load,
                                     .term_torque = term_torque};

int ph_top_damping(ph_top *top, const double C[9]) {
  if (!wide_finite(9, C))
    return PH_EFINITE;
  memcpy(top->damping, C, sizeof top->damping);
  top->effects |= PH_DAMPING;
  return PH_OK;
}

int ph_top_decay(ph_top *top, double rate) {
  if (!isfinite(rate))
    return PH_EFINITE;
  top->decay = rate;
  top->effects |= PH_DECAY;
  return PH_OK;
}
