/* sizes.c - how large values and momenta are, by the largest terms they are made of.
   SPDX-License-Identifier: GPL-3.0-or-later */
#include "acts.h"

/* Of a table as a sum of ramps: slope times distance to each row. */
double effect_size(const effect_terms *e, const ph_varying *v) {
  double most = fabs(v->value);
  if (v->f)
    return e->size ? e->size(v, e->t, e->x, ph_top_states(e->top)) : 0;
  for (int i = 0; i < v->rows; i++) {
    const double *row = v->table + 2 * i;
    effect_raise(&most, fabs(row[1]));
    if (i > 0) {
      const double slope = fabs((row[1] - row[-1]) / (row[0] - row[-2]));
      effect_raise(&most,
                   slope * effect_larger(effect_larger(fabs(row[0]), fabs(row[-2])), fabs(e->t)));
    }
  }
  return most;
}

int effect_tensor(const effect_terms *all, double D[6]) {
  ph_wide x[PH_STATES], sum[6];
  wide_load(ph_top_states(all->top), all->x, x);
  const int any = acts_tensor(all->top, x, sum);
  for (int i = 0; i < 6; i++)
    D[i] = (double)sum[i];
  return any;
}

double effect_moment(const effect_terms *e) {
  double most = 0, D[6];
  effect_tensor(e, D);
  for (int i = 0; i < 6; i++)
    effect_raise(&most, fabs(e->top->inertia[i]) + fabs(D[i]));
  return most;
}

double effect_whole(const effect_terms *e) {
  double held = 0;
  effect_terms one = *e;
  one.t = 0;
  for (acts_at a = acts_first(e->top, 0, NULL); a.e.act; acts_next(&a)) {
    one.act = a.e.act;
    one.place = a.e.place;
    if (one.act->effect->term_momentum)
      one.act->effect->term_momentum(&one, &held);
  }
  return effect_moment(e) * effect_norm(e->x + 4) + held +
         (e->top->effects & PH_ROTOR ? effect_norm(e->top->rotor) : 0);
}
