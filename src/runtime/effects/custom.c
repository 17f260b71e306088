/* custom.c - the user's own effect: torque, force, potential and rates of own states.
   SPDX-License-Identifier: GPL-3.0-or-later */
#include "acts/acts.h"

#include <string.h>

static void torque(const effect_at *e, ph_wide N[3], ph_wide *size) {
  ph_wide part[3];
  for (int i = 0; i < 3; i++) {
    part[i] = acts_value(e, e->t, &e->act->of.custom.torque[i]);
    N[i] += part[i];
  }
  *size += wide_norm(part);
}

static void force(const effect_at *e, ph_wide F[3]) {
  for (int i = 0; i < 3; i++)
    F[i] += acts_value(e, e->t, &e->act->of.custom.force[i]);
}

static void rates(const effect_at *e, ph_wide own[]) {
  for (int i = 0; i < e->act->states; i++)
    own[i] = acts_value(e, e->t, &e->act->of.custom.rate[i]);
}

static ph_wide potential(const effect_at *e) {
  return acts_value(e, 0, &e->act->of.custom.potential);
}

static const ph_varying *varying(const ph_act *act, int *n) {
  *n = 7 + act->states; /* torque, force, potential and rates are neighbours */
  return act->of.custom.torque;
}

static void term_torque(const effect_terms *e, double term[3]) {
  for (int i = 0; i < 3; i++)
    effect_raise(&term[i], effect_size(e, &e->act->of.custom.torque[i]));
}

static void term_rates(const effect_terms *e, double scale[]) {
  for (int i = 0; i < 3 && e->top->effects & PH_TRANSLATION; i++)
    effect_raise(&scale[10 + i], effect_size(e, &e->act->of.custom.force[i]) / e->top->mass);
  for (int i = 0; i < e->act->states; i++)
    scale[e->place + i] = effect_size(e, &e->act->of.custom.rate[i]);
}

static void term_energy(const effect_terms *e, double *scale) {
  effect_raise(scale, effect_size(e, &e->act->of.custom.potential));
}

struct given {
  ph_varying torque[3], force[3], potential, rate[PH_OWN_STATES];
  int states;
};

static const effect_field fields[] = {
    {"torque", EFFECT_VARYING, 3, offsetof(struct given, torque), NULL},
    {"force", EFFECT_VARYING, 3, offsetof(struct given, force), NULL},
    {"potential", EFFECT_VARYING, 1, offsetof(struct given, potential), NULL},
    {"states", EFFECT_VARYING, PH_OWN_STATES, offsetof(struct given, rate), NULL},
    {"states", EFFECT_LENGTH, 0, offsetof(struct given, states), NULL},
    {0}};

static int add(ph_top *top, const void *given) {
  const struct given *g = given;
  return ph_top_custom(top, g->torque, g->force, &g->potential, g->states, g->rate);
}

const effect_table effect_custom = {.name = "custom",
                                    .kind = PH_CUSTOM,
                                    .fields = fields,
                                    .size = sizeof(struct given),
                                    .add = add,
                                    .torque = torque,
                                    .force = force,
                                    .rates = rates,
                                    .potential = potential,
                                    .varying = varying,
                                    .term_torque = term_torque,
                                    .term_rates = term_rates,
                                    .term_energy = term_energy};

int ph_top_custom(ph_top *top, const ph_varying torque_body[3], const ph_varying force_inertial[3],
                  const ph_varying *energy, int n, const ph_varying rate[]) {
  ph_varying all[7 + PH_OWN_STATES] = {{0}};
  if (n < 0 || n > PH_OWN_STATES)
    return PH_ECOUNT;
  for (int i = 0; i < 3; i++) {
    if (torque_body)
      all[i] = torque_body[i];
    if (force_inertial)
      all[3 + i] = force_inertial[i];
  }
  if (energy)
    all[6] = *energy;
  for (int i = 0; i < n; i++)
    all[7 + i] = rate[i];
  ph_act *act;
  const int status = acts_new(top, &effect_custom, n, 7 + n, all, &act);
  if (status)
    return status;
  memcpy(act->of.custom.torque, all, sizeof act->of.custom.torque);
  memcpy(act->of.custom.force, all + 3, sizeof act->of.custom.force);
  act->of.custom.potential = all[6];
  memcpy(act->of.custom.rate, all + 7, (size_t)n * sizeof all[0]);
  return PH_OK;
}
