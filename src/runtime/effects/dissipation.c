/* dissipation.c - an energy sink inside the body: N = k L x (L x w).
   SPDX-License-Identifier: GPL-3.0-or-later

   The axes turn at w + k L x w, so that L stays in space; T' = -k |L x w|^2. */
#include "acts/acts.h"

/* L and L x w. */
static void momentum(const effect_at *e, ph_wide L[3], ph_wide part[3]) {
  acts_whole(e->top, e->x, L);
  wide_cross(L, e->x + 4, part);
}

/* The double bracket as (L.w) L - L^2 w, but for its cancellation. */
static void torque(const effect_at *e, ph_wide N[3], ph_wide *size) {
  ph_wide L[3], part[3];
  momentum(e, L, part);
  wide_cross(L, part, part);
  for (int i = 0; i < 3; i++) {
    part[i] *= (ph_wide)e->act->of.dissipation.k;
    N[i] += part[i];
  }
  *size += wide_norm(part);
}

static void slip(const effect_at *e, ph_wide out[3]) {
  ph_wide L[3], part[3];
  momentum(e, L, part);
  for (int i = 0; i < 3; i++)
    out[i] += (ph_wide)e->act->of.dissipation.k * part[i];
}

static void term_torque(const effect_terms *e, double term[3]) {
  const double most = e->act->of.dissipation.k * pow(effect_whole(e), 2) * effect_norm(e->x + 4);
  for (int i = 0; i < 3; i++)
    effect_raise(&term[i], most);
}

static void term_rates(const effect_terms *e, double scale[]) {
  for (int i = 0; i < 4; i++)
    effect_raise(&scale[i], e->act->of.dissipation.k * effect_whole(e) * effect_norm(e->x + 4) / 2);
}

struct given {
  double k;
};

static const effect_field fields[] = {{"k", EFFECT_NUMBERS, 1, offsetof(struct given, k), NULL},
                                      {0}};

static int add(ph_top *top, const void *given) {
  const struct given *g = given;
  return ph_top_dissipation(top, g->k);
}

const effect_table effect_dissipation = {.name = "dissipation",
                                         .kind = PH_DISSIPATION,
                                         .fields = fields,
                                         .size = sizeof(struct given),
                                         .add = add,
                                         .torque = torque,
                                         .slip = slip,
                                         .term_torque = term_torque,
                                         .term_rates = term_rates};

int ph_top_dissipation(ph_top *top, double k) {
  ph_act *act;
  if (k < 0)
    return PH_EBOUND;
  if (!isfinite(k))
    return PH_EFINITE;
  const int status = acts_new(top, &effect_dissipation, 0, 0, NULL, &act);
  if (!status)
    act->of.dissipation.k = k;
  return status;
}
