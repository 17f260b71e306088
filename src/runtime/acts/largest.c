/* largest.c - the largest terms that all effects of a top bring.
   SPDX-License-Identifier: GPL-3.0-or-later */
#include "acts.h"

/* The effects that the top itself keeps first, act NULL; then each act. */
typedef struct turns {
  const effect_table *const *next;
  acts_at act;
  effect_terms e;
} turns;

static turns begin(const effect_terms *all) {
  turns s = {effect_all, acts_first(all->top, 0, NULL), *all};
  return s;
}

/* The next effect, or NULL. */
static const effect_table *next(turns *s) {
  s->e.act = NULL;
  for (; *s->next; s->next++)
    if ((*s->next)->load || ((*s->next)->kind & s->e.top->effects & ~(unsigned)PH_ANY_ACT))
      return *s->next++;
  s->e.act = s->act.e.act;
  s->e.place = s->act.e.place;
  if (!s->e.act)
    return NULL;
  acts_next(&s->act);
  return s->e.act->effect;
}

void effect_term_torque(const effect_terms *all, double term[3]) {
  turns s = begin(all);
  for (const effect_table *effect; (effect = next(&s)) != NULL;)
    if (effect->term_torque)
      effect->term_torque(&s.e, term);
}

void effect_term_rates(const effect_terms *all, double scale[]) {
  turns s = begin(all);
  for (const effect_table *effect; (effect = next(&s)) != NULL;)
    if (effect->term_rates)
      effect->term_rates(&s.e, scale);
}

void effect_term_energy(const effect_terms *all, double *scale) {
  turns s = begin(all);
  s.e.t = 0;
  for (const effect_table *effect; (effect = next(&s)) != NULL;)
    if (effect->term_energy)
      effect->term_energy(&s.e, scale);
}

void effect_term_momentum(const effect_terms *all, double *scale) {
  turns s = begin(all);
  s.e.t = 0;
  for (const effect_table *effect; (effect = next(&s)) != NULL;)
    if (effect->term_momentum)
      effect->term_momentum(&s.e, scale);
}

void effect_carried(const ph_top *top, double tensor[6]) {
  static const int at[9] = {XX, XY, XZ, XY, YY, YZ, XZ, YZ, ZZ};
  for (int k = 0; k < top->acts.n; k++) {
    const ph_act *act = &top->acts.list[k];
    effect_spinner wheel;
    if (!act->effect->wheel)
      continue;
    act->effect->wheel(act, &wheel);
    for (int i = 0; i < 9 && wheel.included; i++)
      if (i / 3 <= i % 3)
        tensor[at[i]] -= (double)wheel.J * (double)wheel.axis[i / 3] * (double)wheel.axis[i % 3];
  }
}
