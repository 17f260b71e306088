/* spring.c - a spring that turns the body back to its attitude of rest: V = 2 u.K u.
   SPDX-License-Identifier: GPL-3.0-or-later

   (p0, u) = rest* q, K diagonal, or k a a^T about one axis. V is a polynomial of the quaternion,
   regular at half a turn where the angle is not. */
#include "acts/acts.h"

/* (p0, u) and K u. */
static void twisted(const ph_act *act, const ph_wide q[4], ph_wide p[4], ph_wide Ku[3]) {
  const double *rest = act->of.spring.rest, *k = act->of.spring.k;
  const ph_wide back[4] = {(ph_wide)rest[0], -(ph_wide)rest[1], -(ph_wide)rest[2],
                           -(ph_wide)rest[3]};
  wide_quat_multiply(back, q, p);
  if (act->of.spring.one) {
    ph_wide axis[3];
    wide_load(3, act->of.spring.axis, axis);
    const ph_wide along = (ph_wide)k[0] * wide_dot(axis, p + 1);
    for (int i = 0; i < 3; i++)
      Ku[i] = along * axis[i];
  } else {
    for (int i = 0; i < 3; i++)
      Ku[i] = (ph_wide)k[i] * p[1 + i];
  }
}

static double stiffest(const ph_act *act) {
  const double *k = act->of.spring.k;
  return act->of.spring.one ? k[0] : effect_larger(k[0], effect_larger(k[1], k[2]));
}

/* dV = 4 Ku.du, du = (p0 d + u x d)/2 for a turn d of the body. */
static void torque(const effect_at *e, ph_wide N[3], ph_wide *size) {
  ph_wide p[4], Ku[3], part[3];
  twisted(e->act, e->x, p, Ku);
  wide_cross(p + 1, Ku, part);
  for (int i = 0; i < 3; i++)
    N[i] += 2 * part[i] - 2 * p[0] * Ku[i];
  *size += 4 * (ph_wide)stiffest(e->act); /* u is a difference of four products */
}

static ph_wide potential(const effect_at *e) {
  ph_wide p[4], Ku[3];
  twisted(e->act, e->x, p, Ku);
  return 2 * wide_dot(p + 1, Ku);
}

/* Each of p0 and u is a sum of four products. */
static void term_torque(const effect_terms *e, double term[3]) {
  for (int i = 0; i < 3; i++)
    effect_raise(&term[i], 4 * effect_q2(e) * stiffest(e->act));
}

static void term_energy(const effect_terms *e, double *scale) {
  effect_raise(scale, 2 * stiffest(e->act));
}

struct given {
  double stiffness[3], rest[4], axis[3];
  int one;
};

static const double none[3];
static const effect_field fields[] = {
    {"stiffness", EFFECT_NUMBERS, 3, offsetof(struct given, stiffness), NULL},
    {"rest", EFFECT_NUMBERS, 4, offsetof(struct given, rest), NULL},
    {"axis", EFFECT_GIVEN, 0, offsetof(struct given, one), NULL},
    {"axis", EFFECT_NUMBERS, 3, offsetof(struct given, axis), none},
    {0}};

static int add(ph_top *top, const void *given) {
  const struct given *g = given;
  return g->one ? ph_top_spring_axis(top, g->stiffness[0], g->axis, g->rest)
                : ph_top_spring(top, g->stiffness, g->rest);
}

const effect_table effect_spring = {.name = "spring",
                                    .kind = PH_SPRING,
                                    .fields = fields,
                                    .size = sizeof(struct given),
                                    .add = add,
                                    .torque = torque,
                                    .potential = potential,
                                    .term_torque = term_torque,
                                    .term_energy = term_energy};

static int spring(ph_top *top, const double k[3], const double rest[4], ph_act **act) {
  ph_wide q[4];
  int status = wide_load_unit(rest, q);
  if (!status && !wide_finite(3, k))
    status = PH_EFINITE;
  if (!status)
    status = acts_new(top, &effect_spring, 0, 0, NULL, act);
  for (int i = 0; i < 4 && !status; i++) {
    (*act)->of.spring.rest[i] = (double)q[i];
    if (i < 3)
      (*act)->of.spring.k[i] = k[i];
  }
  return status;
}

int ph_top_spring(ph_top *top, const double k[3], const double rest[4]) {
  ph_act *act;
  return spring(top, k, rest, &act);
}

int ph_top_spring_axis(ph_top *top, double k, const double axis[3], const double rest[4]) {
  const double stiffness[3] = {k, 0, 0};
  double a[3];
  ph_act *act;
  int status = acts_unit(axis, a);
  if (!status)
    status = spring(top, stiffness, rest, &act);
  for (int i = 0; i < 3 && !status; i++)
    act->of.spring.axis[i] = a[i];
  if (!status)
    act->of.spring.one = 1;
  return status;
}
