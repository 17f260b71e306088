/* gravity_gradient.c - the gradient of gravity on an orbit: N = 3 mu/r^3 o x I o.
   SPDX-License-Identifier: GPL-3.0-or-later

   o = q* (cos f, sin f, 0) q points from the attracting centre; f grows evenly on a circular orbit
   and is the act's own state, the true anomaly, on an elliptic one. */
#include "acts/acts.h"

/* With S = tr(I)/2 - I the second moments, o x I o = -o x S o: what all moments share is not there
   to cancel. */
static void torque(const effect_at *e, ph_wide N[3], ph_wide *size) {
  const ph_top *top = e->top;
  const ph_wide mu = (ph_wide)e->act->of.gravity_gradient.mu;
  ph_wide r = (ph_wide)e->act->of.gravity_gradient.a, angle, S[6], part[3], turn[3];
  if (e->act->of.gravity_gradient.elliptic) {
    const ph_wide ecc = (ph_wide)e->act->of.gravity_gradient.e;
    angle = e->x[e->place];
    r *= (1 - ecc) * (1 + ecc) / (1 + ecc * cosl(angle));
  } else {
    angle = sqrtl(mu / r) / r * e->t;
  }
  ph_wide o[3] = {cosl(angle), sinl(angle), 0};
  wide_sandwich(e->x, o, 0, o);
  for (int i = 0; i < 6; i++)
    S[i] = top->wide_second[i];
  wide_apply(S, o, part);
  wide_cross(part, o, turn);
  ph_wide D[6], Do[3];
  if (acts_locked(top, e->x, D)) {
    wide_apply(D, o, Do);
    wide_cross(o, Do, part);
    for (int i = 0; i < 3; i++)
      turn[i] += part[i];
  }
  const ph_wide factor = 3 * mu / (r * r * r);
  for (int i = 0; i < 3; i++)
    N[i] += factor * turn[i];
  *size += factor * (fabsl(S[0]) + fabsl(S[1]) + fabsl(S[2]));
}

/* Kepler's second law r^2 f' = sqrt(mu p), r = p/(1 + e cos f). */
static void rates(const effect_at *e, ph_wide own[]) {
  if (!e->act->of.gravity_gradient.elliptic)
    return;
  const ph_wide ecc = (ph_wide)e->act->of.gravity_gradient.e;
  const ph_wide p = (ph_wide)e->act->of.gravity_gradient.a * (1 - ecc) * (1 + ecc);
  const ph_wide r = p / (1 + ecc * cosl(e->x[e->place]));
  own[0] = sqrtl((ph_wide)e->act->of.gravity_gradient.mu * p) / (r * r);
}

/* (1 + e)^n for (1 + e cos f)^n; a phase that is made of time turns by its own rounding. */
static double orbit(const effect_terms *e, double *rate) {
  const int elliptic = e->act->of.gravity_gradient.elliptic;
  const double ecc = elliptic ? e->act->of.gravity_gradient.e : 0;
  const double p = e->act->of.gravity_gradient.a * (1 - ecc) * (1 + ecc);
  const double strength = e->act->of.gravity_gradient.mu / (p * p * p);
  *rate = sqrt(strength) * (1 + ecc) * (1 + ecc);
  return 3 * strength * pow(1 + ecc, 3) * (elliptic ? 1 : 1 + fabs(*rate * e->t));
}

static void term_torque(const effect_terms *e, double term[3]) {
  double rate;
  const double most = orbit(e, &rate) * effect_moment(e) * effect_q2(e) * effect_q2(e);
  for (int i = 0; i < 3; i++)
    effect_raise(&term[i], most);
}

static void term_rates(const effect_terms *e, double scale[]) {
  if (e->act->of.gravity_gradient.elliptic)
    orbit(e, scale + e->place);
}

struct given {
  double mu, radius, e;
  int elliptic;
};

static const effect_field fields[] = {
    {"mu", EFFECT_NUMBERS, 1, offsetof(struct given, mu), NULL},
    {"radius", EFFECT_NUMBERS, 1, offsetof(struct given, radius), NULL},
    {"e", EFFECT_NUMBERS, 1, offsetof(struct given, e), NULL},
    {"elliptic", EFFECT_FLAG, 0, offsetof(struct given, elliptic), NULL},
    {0}};

static int add(ph_top *top, const void *given) {
  const struct given *g = given;
  return g->elliptic ? ph_top_gravity_gradient_orbit(top, g->mu, g->radius, g->e)
                     : ph_top_gravity_gradient(top, g->mu, g->radius);
}

const effect_table effect_gravity_gradient = {.name = "gravity_gradient",
                                              .kind = PH_GRADIENT,
                                              .fields = fields,
                                              .size = sizeof(struct given),
                                              .add = add,
                                              .torque = torque,
                                              .rates = rates,
                                              .term_torque = term_torque,
                                              .term_rates = term_rates};

static int orbiting(ph_top *top, double mu, double a, double e, int elliptic) {
  ph_act *act;
  if (!isfinite(mu) || !isfinite(a) || !isfinite(e))
    return PH_EFINITE;
  const int status = acts_new(top, &effect_gravity_gradient, elliptic, 0, NULL, &act);
  if (status)
    return status;
  act->of.gravity_gradient.mu = mu;
  act->of.gravity_gradient.a = a;
  act->of.gravity_gradient.e = e;
  act->of.gravity_gradient.elliptic = elliptic;
  return PH_OK;
}

int ph_top_gravity_gradient(ph_top *top, double mu, double radius) {
  return mu < 0 || radius <= 0 ? PH_EBOUND : orbiting(top, mu, radius, 0, 0);
}

int ph_top_gravity_gradient_orbit(ph_top *top, double mu, double a, double e) {
  return mu < 0 || a <= 0 || e < 0 || e >= 1 ? PH_EBOUND : orbiting(top, mu, a, e, 1);
}
