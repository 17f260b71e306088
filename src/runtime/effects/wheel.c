/* wheel.c - a reaction wheel: J (a.w + W)' = u, and the wheel takes -u a from the body.
   SPDX-License-Identifier: GPL-3.0-or-later

   Hughes, Spacecraft Attitude Dynamics, 3.5. w' and W' are found together, acts/coupled.c. */
#include "acts/acts.h"

static void wheel(const ph_act *act, effect_spinner *out) {
  wide_load(3, act->of.wheel.axis, out->axis);
  out->J = (ph_wide)act->of.wheel.J;
  out->included = act->of.wheel.included;
}

static ph_wide motor(const effect_at *e) {
  return acts_value(e, e->t, &e->act->of.wheel.motor);
}

static const ph_varying *varying(const ph_act *act, int *n) {
  *n = 1;
  return &act->of.wheel.motor;
}

static void term_torque(const effect_terms *e, double term[3]) {
  const double *axis = e->act->of.wheel.axis, *w = e->x + 4;
  double speed = fabs(e->x[e->place]);
  for (int i = 0; i < 3; i++)
    effect_raise(&speed, fabs(axis[i] * w[i]));
  for (int i = 0; i < 3; i++) {
    effect_raise(&term[i], e->act->of.wheel.J * speed * effect_norm(w));
    effect_raise(&term[i], effect_size(e, &e->act->of.wheel.motor));
  }
}

static void term_rates(const effect_terms *e, double scale[]) {
  double *own = scale + e->place;
  own[0] = effect_size(e, &e->act->of.wheel.motor) / e->act->of.wheel.J;
  for (int i = 0; i < 3; i++)
    effect_raise(own, fabs(e->act->of.wheel.axis[i]) * scale[4 + i]);
}

static void term_energy(const effect_terms *e, double *scale) {
  const double speed = effect_larger(fabs(e->x[e->place]), effect_norm(e->x + 4));
  effect_raise(scale, e->act->of.wheel.J * pow(speed, 2) / 2);
}

static void term_momentum(const effect_terms *e, double *scale) {
  const double speed = effect_larger(fabs(e->x[e->place]), effect_norm(e->x + 4));
  effect_raise(scale, e->act->of.wheel.J * speed);
}

struct given {
  double axis[3], inertia;
  ph_varying torque;
  int included;
};

static const effect_field fields[] = {
    {"axis", EFFECT_NUMBERS, 3, offsetof(struct given, axis), NULL},
    {"inertia", EFFECT_NUMBERS, 1, offsetof(struct given, inertia), NULL},
    {"torque", EFFECT_VARYING, 1, offsetof(struct given, torque), NULL},
    {"included", EFFECT_FLAG, 0, offsetof(struct given, included), NULL},
    {0}};

static int add(ph_top *top, const void *given) {
  const struct given *g = given;
  return ph_top_wheel(top, g->axis, g->inertia, g->torque, g->included);
}

const effect_table effect_wheel = {.name = "wheel",
                                   .kind = PH_WHEEL,
                                   .fields = fields,
                                   .size = sizeof(struct given),
                                   .add = add,
                                   .wheel = wheel,
                                   .motor = motor,
                                   .varying = varying,
                                   .term_torque = term_torque,
                                   .term_rates = term_rates,
                                   .term_energy = term_energy,
                                   .term_momentum = term_momentum};

/* Positive definite by the pivots of the tensor without the included wheels. */
static int positive(const ph_top *top) {
  static const int at[3][3] = {{XX, XY, XZ}, {XY, YY, YZ}, {XZ, YZ, ZZ}};
  ph_wide I[6], A[3][3];
  for (int i = 0; i < 6; i++)
    I[i] = top->wide_inertia[i];
  for (int k = 0; k < top->acts.n; k++) {
    const ph_act *act = &top->acts.list[k];
    ph_wide axis[3];
    if (act->effect != &effect_wheel || !act->of.wheel.included)
      continue;
    wide_load(3, act->of.wheel.axis, axis);
    wide_add_outer(I, -(ph_wide)act->of.wheel.J, axis);
  }
  for (int i = 0; i < 9; i++)
    A[i / 3][i % 3] = I[at[i / 3][i % 3]];
  for (int c = 0; c < 3; c++) {
    if (!(A[c][c] > 0))
      return 0;
    for (int r = c + 1; r < 3; r++)
      for (int k = 2; k >= c; k--)
        A[r][k] -= A[r][c] / A[c][c] * A[c][k];
  }
  return 1;
}

int ph_top_wheel(ph_top *top, const double axis[3], double J, ph_varying torque, int included) {
  const unsigned before = top->effects;
  double a[3];
  ph_act *act;
  if (!isfinite(J))
    return PH_EFINITE;
  int status = acts_unit(axis, a);
  if (status)
    return status;
  if (!(J > 0))
    return PH_EPOSITIVE;
  if (!(top->wide_moment[0] > 0))
    return PH_EROD;
  status = acts_new(top, &effect_wheel, 1, 1, &torque, &act);
  if (status)
    return status;
  for (int i = 0; i < 3; i++)
    act->of.wheel.axis[i] = a[i];
  act->of.wheel.J = J;
  act->of.wheel.included = included != 0;
  act->of.wheel.motor = torque;
  if (positive(top))
    return PH_OK;
  top->acts.n--;
  top->effects = before;
  return PH_EPOSITIVE;
}
