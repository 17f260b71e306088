/* translation.c - the centre of mass moves: gravity, drag and a restoring force on it.
   SPDX-License-Identifier: GPL-3.0-or-later

   m v' = m g - linear v - drag |v| v - (kx x, ky y, kz z); motion/move.c has the equations. */
#include "acts/acts.h"
#include "motion/move.h"

#include <string.h>

void move_load(const ph_top *top, move_loads *loads) {
  const ph_wide mass = (ph_wide)top->mass;
  *loads = (move_loads){0};
  for (int i = 0; i < 3; i++) {
    loads->gravity[i] = (ph_wide)top->move.gravity[i];
    if (top->effects & PH_RESTORING)
      loads->stiffness[i] = (ph_wide)top->move.stiffness[i] / mass;
  }
  if (top->effects & PH_DRAG) {
    loads->linear = (ph_wide)top->move.linear / mass;
    loads->drag = (ph_wide)top->move.drag / mass;
  }
}

static void term_rates(const effect_terms *e, double scale[]) {
  const ph_move *m = &e->top->move;
  const double *r = e->x + 7, *v = e->x + 10, speed = effect_norm(v), mass = e->top->mass;
  for (int i = 0; i < 3; i++) {
    scale[7 + i] = fabs(v[i]);
    effect_raise(&scale[10 + i], fabs(m->gravity[i]));
    if (e->top->effects & PH_RESTORING)
      effect_raise(&scale[10 + i], fabs(m->stiffness[i] * r[i]) / mass);
    if (e->top->effects & PH_DRAG)
      effect_raise(&scale[10 + i], effect_larger(m->linear, m->drag * speed) * fabs(v[i]) / mass);
  }
}

static void term_energy(const effect_terms *e, double *scale) {
  const ph_move *m = &e->top->move;
  const double *r = e->x + 7, *v = e->x + 10, mass = e->top->mass;
  for (int i = 0; i < 3; i++) {
    effect_raise(scale, mass * (v[i] * v[i] / 2));
    effect_raise(scale, mass * fabs(m->gravity[i] * r[i]));
    if (e->top->effects & PH_RESTORING)
      effect_raise(scale, fabs(m->stiffness[i]) * r[i] * r[i] / 2);
  }
}

struct given {
  double gravity[3], stiffness[3], linear, drag;
};

static const double none[3];
static const effect_field fields[] = {
    {"gravity", EFFECT_NUMBERS, 3, offsetof(struct given, gravity), NULL},
    {"stiffness", EFFECT_NUMBERS, 3, offsetof(struct given, stiffness), none},
    {"linear", EFFECT_NUMBERS, 1, offsetof(struct given, linear), NULL},
    {"drag", EFFECT_NUMBERS, 1, offsetof(struct given, drag), NULL},
    {0}};

static int add(ph_top *top, const void *given) {
  const struct given *g = given;
  int status = ph_top_translation(top, g->gravity);
  if (!status)
    status = ph_top_restoring(top, g->stiffness);
  return status ? status : ph_top_drag(top, g->linear, g->drag);
}

const effect_table effect_translation = {.name = "translation",
                                         .kind = PH_TRANSLATION,
                                         .fields = fields,
                                         .size = sizeof(struct given),
                                         .add = add,
                                         .term_rates = term_rates,
                                         .term_energy = term_energy};

/* The centre of mass must be the origin, up to the rounding of where it was said to be: against the
   radius of gyration. */
int ph_top_translation(ph_top *top, const double gravity[3]) {
  if (!wide_finite(3, gravity))
    return PH_EFINITE;
  const ph_wide moment = top->wide_inertia[XX] + top->wide_inertia[YY] + top->wide_inertia[ZZ];
  const ph_wide radius = sqrtl(moment / (ph_wide)top->mass);
  if (wide_norm(top->wide_com) > 64 * (ph_wide)DBL_EPSILON * radius)
    return PH_EBOUND;
  memcpy(top->move.gravity, gravity, sizeof top->move.gravity);
  top->effects |= PH_TRANSLATION;
  return PH_OK;
}

int ph_top_drag(ph_top *top, double linear, double drag) {
  if (!isfinite(linear) || !isfinite(drag))
    return PH_EFINITE;
  if (linear < 0 || drag < 0)
    return PH_EPOSITIVE;
  top->move.linear = linear;
  top->move.drag = drag;
  top->effects |= PH_DRAG;
  return PH_OK;
}

int ph_top_restoring(ph_top *top, const double stiffness[3]) {
  if (!wide_finite(3, stiffness))
    return PH_EFINITE;
  memcpy(top->move.stiffness, stiffness, sizeof top->move.stiffness);
  top->effects |= PH_RESTORING;
  return PH_OK;
}
