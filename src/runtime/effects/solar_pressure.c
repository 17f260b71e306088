/* solar_pressure.c - sunlight on plates: F = -P A c ((1 - rho) s + 2 rho c n) for c = n.s > 0.
   SPDX-License-Identifier: GPL-3.0-or-later */
#include "acts/acts.h"

enum { AREA, REFLECTIVITY, NORMAL, CENTRE = 5, PLATE = 8 }; /* numbers of a plate */

static void sun_at(const effect_at *e, ph_wide sun[3]) {
  wide_load(3, e->act->of.solar_pressure.sun, sun);
  wide_sandwich(e->x, sun, 0, sun);
}

/* Force in body axes, and where it acts; 0 in the dark. */
static int plate(const effect_at *e, int i, const ph_wide sun[3], ph_wide F[3], ph_wide centre[3]) {
  const ph_act *act = e->act;
  const double *row = act->of.solar_pressure.plates + PLATE * i;
  ph_wide n[3];
  wide_load(3, row + NORMAL, n);
  wide_load(3, row + CENTRE, centre);
  const ph_wide length = wide_norm(n), c = wide_dot(n, sun) / length;
  if (effect_sign(e, i, c) <= 0)
    return 0;
  const ph_wide push = (ph_wide)act->of.solar_pressure.pressure * (ph_wide)row[AREA] * c;
  const ph_wide mirror = (ph_wide)row[REFLECTIVITY];
  for (int k = 0; k < 3; k++)
    F[k] = -push * ((1 - mirror) * sun[k] + 2 * mirror * c * n[k] / length);
  return 1;
}

static void torque(const effect_at *e, ph_wide N[3], ph_wide *size) {
  ph_wide sun[3];
  sun_at(e, sun);
  for (int i = 0; i < e->act->of.solar_pressure.n; i++) {
    ph_wide F[3], centre[3], part[3];
    if (!plate(e, i, sun, F, centre))
      continue;
    wide_cross(centre, F, part);
    for (int k = 0; k < 3; k++)
      N[k] += part[k];
    *size += wide_norm(centre) * wide_norm(F);
  }
}

static void force(const effect_at *e, ph_wide F[3]) {
  ph_wide sun[3], sum[3] = {0};
  sun_at(e, sun);
  for (int i = 0; i < e->act->of.solar_pressure.n; i++) {
    ph_wide part[3], centre[3];
    if (!plate(e, i, sun, part, centre))
      continue;
    for (int k = 0; k < 3; k++)
      sum[k] += part[k];
  }
  wide_sandwich(e->x, sum, 1, sum);
  for (int k = 0; k < 3; k++)
    F[k] += sum[k];
}

/* n.s of each plate: its torque has a corner where this is 0. */
static ph_wide side(const effect_at *e, int i) {
  ph_wide sun[3], n[3];
  sun_at(e, sun);
  wide_load(3, e->act->of.solar_pressure.plates + PLATE * i + NORMAL, n);
  const ph_wide c = wide_dot(n, sun);
  return fabsl(c) > 8 * LDBL_EPSILON * wide_norm(n) ? c : 0;
}

static void term_torque(const effect_terms *e, double term[3]) {
  const double q2 = effect_q2(e);
  for (int i = 0; i < e->act->of.solar_pressure.n; i++) {
    const double *row = e->act->of.solar_pressure.plates + PLATE * i;
    const double arm = effect_norm(row + CENTRE);
    for (int k = 0; k < 3; k++)
      effect_raise(&term[k], 2 * e->act->of.solar_pressure.pressure * row[AREA] * arm * q2 * q2);
  }
}

static void term_rates(const effect_terms *e, double scale[]) {
  const double *plates = e->act->of.solar_pressure.plates, P = e->act->of.solar_pressure.pressure;
  for (int i = 0; i < e->act->of.solar_pressure.n && e->top->effects & PH_TRANSLATION; i++)
    for (int k = 0; k < 3; k++)
      effect_raise(&scale[10 + k], 2 * P * plates[PLATE * i + AREA] / e->top->mass);
}

struct given {
  double flux, sun[3];
  effect_list plates;
};

static const effect_field fields[] = {
    {"flux", EFFECT_NUMBERS, 1, offsetof(struct given, flux), NULL},
    {"sun", EFFECT_NUMBERS, 3, offsetof(struct given, sun), NULL},
    {"plates", EFFECT_LIST, 0, offsetof(struct given, plates), NULL},
    {0}};

static int add(ph_top *top, const void *given) {
  const struct given *g = given;
  return ph_top_solar(top, g->flux, g->sun, g->plates.n / PLATE, g->plates.v);
}

const effect_table effect_solar_pressure = {.name = "solar_pressure",
                                            .kind = PH_SOLAR,
                                            .fields = fields,
                                            .size = sizeof(struct given),
                                            .add = add,
                                            .torque = torque,
                                            .force = force,
                                            .side = side,
                                            .term_torque = term_torque,
                                            .term_rates = term_rates};

int ph_top_solar(ph_top *top, double flux, const double sun[3], int n, const double plates[]) {
  static const double light = 299792458; /* m/s */
  double unit[3];
  ph_act *act;
  if (n < 1)
    return PH_ECOUNT;
  if (!wide_finite(PLATE * n, plates))
    return PH_EFINITE;
  for (int i = 0; i < n; i++) {
    const double *row = plates + PLATE * i;
    const int status = acts_unit(row + NORMAL, unit);
    if (status)
      return status;
    if (row[AREA] < 0 || row[REFLECTIVITY] < 0 || row[REFLECTIVITY] > 1)
      return PH_EBOUND;
  }
  int status = flux < 0 ? PH_EBOUND : acts_unit(sun, unit);
  if (!status && !isfinite(flux))
    status = PH_EFINITE;
  if (!status)
    status = acts_new(top, &effect_solar_pressure, 0, 0, NULL, &act);
  if (status)
    return status;
  act->of.solar_pressure.pressure = flux / light;
  for (int i = 0; i < 3; i++)
    act->of.solar_pressure.sun[i] = unit[i];
  act->of.solar_pressure.n = act->sides = n;
  act->of.solar_pressure.plates = plates;
  return PH_OK;
}
