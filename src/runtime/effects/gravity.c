/* gravity.c - uniform gravity about a fixed point: N = R x q* (M g d) q, V = -M g d.(q R q*).
   SPDX-License-Identifier: GPL-3.0-or-later */
#include "acts/acts.h"

static void load(const ph_top *top, const double u[3], motion_loads *loads) {
  (void)u;
  for (int i = 0; i < 3 && top->effects & PH_GRAVITY; i++)
    loads->weight[i] = (ph_wide)top->mass * (ph_wide)top->gravity[i];
}

/* Zero when the centre of mass is level with the origin. */
static ph_wide potential(const effect_at *e) {
  motion_loads loads = {{0}, {0}, {0}, {0}, 0, {0}};
  ph_wide com[3];
  load(e->top, NULL, &loads);
  wide_sandwich(e->x, e->top->wide_com, 1, com);
  return -wide_dot(loads.weight, com);
}

/* A vector turned into body axes: its terms are as large as the vector, whatever is left of
   them. */
static void term_torque(const effect_terms *e, double term[3]) {
  const double *com = e->top->com;
  for (int j = 0; j < 3 && e->top->effects & PH_GRAVITY; j++)
    effect_raise(&term[j], effect_larger(fabs(com[(j + 1) % 3]), fabs(com[(j + 2) % 3])) *
                               e->top->mass * effect_norm(e->top->gravity) * effect_q2(e));
}

static void term_energy(const effect_terms *e, double *scale) {
  if (e->top->effects & PH_GRAVITY)
    effect_raise(scale, e->top->mass * effect_norm(e->top->com) * effect_norm(e->top->gravity));
}

struct given {
  double g, direction[3];
};

static const double down[3] = {0, 0, -1};
static const effect_field fields[] = {
    {"g", EFFECT_NUMBERS, 1, offsetof(struct given, g), NULL},
    {"direction", EFFECT_NUMBERS, 3, offsetof(struct given, direction), down},
    {0}};

/* Several add up; what cancels altogether is no gravity. */
static int add(ph_top *top, const void *given) {
  const struct given *g = given;
  const ph_top before = *top;
  const int status = ph_top_gravity(top, g->g, g->direction);
  if (status || !(before.effects & PH_GRAVITY))
    return status;
  for (int i = 0; i < 3; i++)
    top->gravity[i] += before.gravity[i];
  if (!(effect_norm(top->gravity) > 0))
    ph_top_without(top, PH_GRAVITY);
  return PH_OK;
}

const effect_table effect_gravity = {.name = "gravity",
                                     .kind = PH_GRAVITY,
                                     .fields = fields,
                                     .size = sizeof(struct given),
                                     .add = add,
                                     .load = load,
                                     .potential = potential,
                                     .term_torque = term_torque,
                                     .term_energy = term_energy};

/* Kept as one vector g d, so that no later line needs |d| = 1. */
int ph_top_gravity(ph_top *top, double g, const double direction[3]) {
  if (!isfinite(g) || !wide_finite(3, direction))
    return PH_EFINITE;
  ph_wide d[3];
  wide_load(3, direction, d);
  const ph_wide n = wide_norm(d);
  if (!(n > 0))
    return PH_EDIRECTION;
  for (int i = 0; i < 3; i++)
    top->gravity[i] = (double)((ph_wide)g * d[i] / n);
  top->effects |= PH_GRAVITY;
  return PH_OK;
}
