/* inertia_rate.c - moving parts: (I + D(t)) w' = L x w - D' w + N, L = (I + D) w.
   SPDX-License-Identifier: GPL-3.0-or-later

   The act's own state is its time. What D adds to the equations is in acts/coupled.c and
   acts/held.c. */
#include "acts/acts.h"

#include <string.h>

static void tensor(const effect_at *e, ph_wide D[6]) {
  for (int i = 0; i < 6; i++)
    D[i] += acts_value(e, 0, &e->act->of.inertia_rate.tensor[i]);
}

static void tensor_rate(const effect_at *e, ph_wide D[6]) {
  for (int i = 0; i < 6; i++)
    D[i] += acts_value(e, 0, &e->act->of.inertia_rate.rate[i]);
}

static const ph_varying *varying(const ph_act *act, int *n) {
  *n = 12; /* tensor and rate are neighbours */
  return act->of.inertia_rate.tensor;
}

/* -D' w */
static void torque(const effect_at *e, ph_wide N[3], ph_wide *size) {
  ph_wide rate[6] = {0}, part[3];
  tensor_rate(e, rate);
  for (int i = 0; i < 6; i++)
    rate[i] = -rate[i];
  wide_apply(rate, e->x + 4, part);
  for (int i = 0; i < 3; i++)
    N[i] += part[i];
  *size += wide_norm(part);
}

static void rates(const effect_at *e, ph_wide own[]) {
  (void)e;
  own[0] = 1;
}

static void term_torque(const effect_terms *e, double term[3]) {
  const double w = effect_norm(e->x + 4);
  for (int i = 0; i < 6; i++)
    for (int k = 0; k < 3; k++) {
      effect_raise(&term[k], effect_size(e, &e->act->of.inertia_rate.tensor[i]) * w * w);
      effect_raise(&term[k], effect_size(e, &e->act->of.inertia_rate.rate[i]) * w);
    }
}

static void term_rates(const effect_terms *e, double scale[]) {
  scale[e->place] = 1;
}

static void term_energy(const effect_terms *e, double *scale) {
  for (int i = 0; i < 6; i++)
    effect_raise(scale, effect_size(e, &e->act->of.inertia_rate.tensor[i]) *
                            pow(effect_norm(e->x + 4), 2) / 2);
}

static void term_momentum(const effect_terms *e, double *scale) {
  for (int i = 0; i < 6; i++)
    effect_raise(scale, effect_size(e, &e->act->of.inertia_rate.tensor[i]) * effect_norm(e->x + 4));
}

struct given {
  ph_varying tensor[6], rate[6];
};

static const effect_field fields[] = {
    {"tensor", EFFECT_VARYING, 6, offsetof(struct given, tensor), NULL},
    {"rate", EFFECT_VARYING, 6, offsetof(struct given, rate), NULL},
    {0}};

static int add(ph_top *top, const void *given) {
  const struct given *g = given;
  return ph_top_parts(top, g->tensor, g->rate);
}

const effect_table effect_inertia_rate = {.name = "inertia_rate",
                                          .kind = PH_PARTS,
                                          .fields = fields,
                                          .size = sizeof(struct given),
                                          .add = add,
                                          .torque = torque,
                                          .rates = rates,
                                          .tensor = tensor,
                                          .varying = varying,
                                          .tensor_rate = tensor_rate,
                                          .term_torque = term_torque,
                                          .term_rates = term_rates,
                                          .term_energy = term_energy,
                                          .term_momentum = term_momentum};

int ph_top_parts(ph_top *top, const ph_varying D[6], const ph_varying rate[6]) {
  ph_varying all[12];
  ph_act *act;
  memcpy(all, D, 6 * sizeof all[0]);
  memcpy(all + 6, rate, 6 * sizeof all[0]);
  const int status = acts_new(top, &effect_inertia_rate, 1, 12, all, &act);
  if (status)
    return status;
  memcpy(act->of.inertia_rate.tensor, all, sizeof act->of.inertia_rate.tensor);
  memcpy(act->of.inertia_rate.rate, all + 6, sizeof act->of.inertia_rate.rate);
  return PH_OK;
}
