/* rotating_frame.c - the axes that are otherwise inertial turn at Omega = rate + rate_dot t.
   SPDX-License-Identifier: GPL-3.0-or-later

   motion/move.c has the equations and the rate at a time. */
#include "acts/acts.h"
#include "motion/move.h"

#include <string.h>

/* |Omega| and |Omega'|, component by component. */
static void turning(const effect_terms *e, double t, double Omega[3], double change[3]) {
  const ph_move *m = &e->top->move;
  for (int i = 0; i < 3; i++) {
    change[i] = fabs(m->rate_dot[i]);
    Omega[i] = effect_larger(fabs(m->rate[i]), change[i] * fabs(t));
  }
}

static void term_rates(const effect_terms *e, double scale[]) {
  /* which q multiplies x, y, z of Omega in row i of (0, Omega) q / 2 */
  static const int row[4][3] = {{1, 2, 3}, {0, 3, 2}, {3, 0, 1}, {2, 1, 0}};
  double Omega[3], change[3], u[3];
  turning(e, e->t, Omega, change);
  for (int i = 0; i < 4; i++)
    for (int k = 0; k < 3; k++)
      effect_raise(&scale[i], fabs(0.5 * e->x[row[i][k]]) * Omega[k]);
  if (!(e->top->effects & PH_TRANSLATION))
    return;
  const double *r = e->x + 7, *v = e->x + 10;
  for (int i = 0; i < 3; i++) { /* terms of 2 v + Omega x r */
    const int a = (i + 1) % 3, b = (i + 2) % 3;
    u[i] =
        effect_larger(2 * fabs(v[i]), effect_larger(Omega[a] * fabs(r[b]), Omega[b] * fabs(r[a])));
  }
  for (int i = 0; i < 3; i++) {
    const int a = (i + 1) % 3, b = (i + 2) % 3;
    effect_raise(&scale[10 + i], effect_larger(Omega[a] * u[b], Omega[b] * u[a]));
    effect_raise(&scale[10 + i], effect_larger(change[a] * fabs(r[b]), change[b] * fabs(r[a])));
  }
}

static void term_energy(const effect_terms *e, double *scale) {
  double Omega[3], change[3];
  turning(e, 0, Omega, change);
  const double fastest = effect_larger(effect_larger(Omega[0], Omega[1]), Omega[2]);
  /* Omega . (q L q*), L of all that turns: turned vectors are as large as they were */
  effect_raise(scale, fastest * effect_whole(e));
  for (int i = 0; i < 3 && e->top->effects & PH_TRANSLATION; i++) {
    const int a = (i + 1) % 3, b = (i + 2) % 3;
    const double u = effect_larger(Omega[a] * fabs(e->x[7 + b]), Omega[b] * fabs(e->x[7 + a]));
    effect_raise(scale, e->top->mass * (u * u));
  }
}

struct given {
  double rate[3], rate_dot[3];
  int centrifugal, moves;
};

static const double none[3];
static const effect_field fields[] = {
    {"rate", EFFECT_NUMBERS, 3, offsetof(struct given, rate), NULL},
    {"rate_dot", EFFECT_NUMBERS, 3, offsetof(struct given, rate_dot), none},
    {"centrifugal", EFFECT_FLAG, 0, offsetof(struct given, centrifugal), NULL},
    {"moves", EFFECT_FLAG, 0, offsetof(struct given, moves), NULL}, /* a translation is meant */
    {0}};

static int add(ph_top *top, const void *given) {
  const struct given *g = given;
  const int status = ph_top_frame(top, g->rate, g->rate_dot, g->centrifugal);
  return status || !g->moves || top->effects & PH_TRANSLATION ? status
                                                              : ph_top_translation(top, none);
}

const effect_table effect_rotating_frame = {.name = "rotating_frame",
                                            .kind = PH_FRAME,
                                            .fields = fields,
                                            .size = sizeof(struct given),
                                            .add = add,
                                            .term_rates = term_rates,
                                            .term_energy = term_energy};

int ph_top_frame(ph_top *top, const double rate[3], const double rate_dot[3], int centrifugal) {
  if (!wide_finite(3, rate) || !wide_finite(3, rate_dot))
    return PH_EFINITE;
  memcpy(top->move.rate, rate, sizeof top->move.rate);
  memcpy(top->move.rate_dot, rate_dot, sizeof top->move.rate_dot);
  top->move.centrifugal = centrifugal != 0;
  top->effects |= PH_FRAME;
  return PH_OK;
}
