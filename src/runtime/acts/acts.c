/* acts.c - sums over the acts of a top that are switched on.
   SPDX-License-Identifier: GPL-3.0-or-later */
#include "acts.h"

/* From the act `number` on, the first that is switched on. */
static void find(acts_at *a) {
  const ph_top *top = a->e.top;
  a->e.act = NULL;
  for (; a->number < top->acts.n; a->number++)
    if (top->effects & top->acts.list[a->number].effect->kind) {
      a->e.act = &top->acts.list[a->number];
      return;
    }
}

acts_at acts_first(const ph_top *top, ph_wide t, const ph_wide x[]) {
  acts_at a = {{top, NULL, t, x, top->effects & PH_TRANSLATION ? 13 : 7, 0}, 0};
  find(&a);
  return a;
}

void acts_next(acts_at *a) {
  a->e.place += a->e.act->states;
  a->e.side += a->e.act->sides;
  a->number++;
  find(a);
}

int acts_states(const ph_top *top) {
  int n = 0;
  for (acts_at a = acts_first(top, 0, NULL); a.e.act; acts_next(&a))
    n += a.e.act->states;
  return n;
}

void acts_torque(const ph_top *top, ph_wide t, const ph_wide x[], ph_wide N[3], ph_wide *size) {
  for (acts_at a = acts_first(top, t, x); a.e.act; acts_next(&a)) {
    ph_wide part[3] = {0};
    if (!a.e.act->effect->torque)
      continue;
    a.e.act->effect->torque(&a.e, part, size);
    for (int i = 0; i < 3; i++)
      N[i] += part[i];
  }
}

void acts_force(const ph_top *top, ph_wide t, const ph_wide x[], ph_wide F[3]) {
  for (acts_at a = acts_first(top, t, x); a.e.act; acts_next(&a))
    if (a.e.act->effect->force)
      a.e.act->effect->force(&a.e, F);
}

void acts_rates(const ph_top *top, ph_wide t, const ph_wide x[], ph_wide dx[]) {
  for (acts_at a = acts_first(top, t, x); a.e.act; acts_next(&a))
    if (a.e.act->effect->rates)
      a.e.act->effect->rates(&a.e, dx + a.e.place);
}

ph_wide acts_potential(const ph_top *top, const ph_wide x[]) {
  ph_wide V = 0;
  for (acts_at a = acts_first(top, 0, x); a.e.act; acts_next(&a))
    if (a.e.act->effect->potential)
      V += a.e.act->effect->potential(&a.e);
  return V;
}

void acts_slip(const ph_top *top, const ph_wide x[], ph_wide slip[3]) {
  for (int i = 0; i < 3; i++)
    slip[i] = 0;
  for (acts_at a = acts_first(top, 0, x); a.e.act; acts_next(&a))
    if (a.e.act->effect->slip)
      a.e.act->effect->slip(&a.e, slip);
}

int acts_tensor(const ph_top *top, const ph_wide x[], ph_wide D[6]) {
  int any = 0;
  for (int i = 0; i < 6; i++)
    D[i] = 0;
  for (acts_at a = acts_first(top, 0, x); a.e.act; acts_next(&a))
    if (a.e.act->effect->tensor) {
      a.e.act->effect->tensor(&a.e, D);
      any = 1;
    }
  return any;
}

/* The values of an act that vary; NULL: none. */
static const ph_varying *varying(const acts_at *a, int *n) {
  *n = 0;
  return a->e.act->effect->varying ? a->e.act->effect->varying(a->e.act, n) : NULL;
}

int acts_sides(const ph_top *top) {
  int n = 0;
  for (acts_at a = acts_first(top, 0, NULL); a.e.act; acts_next(&a))
    n += a.e.act->sides;
  return n;
}

void acts_side(const ph_top *top, ph_wide t, const ph_wide x[], ph_wide side[]) {
  for (acts_at a = acts_first(top, t, x); a.e.act; acts_next(&a)) {
    int n, at = a.e.side;
    const ph_varying *v = varying(&a, &n);
    for (int i = 0; i < a.e.act->sides && a.e.act->effect->side; i++)
      side[at + i] = a.e.act->effect->side(&a.e, i);
    for (int i = 0; i < n; at += acts_varying_sides(&v[i++]))
      if (acts_varying_sides(&v[i]) > 0)
        v[i].piece(v[i].context, t, x, top->branch + at, side + at);
  }
}

int acts_unseen(const ph_top *top) {
  for (acts_at a = acts_first(top, 0, NULL); a.e.act; acts_next(&a)) {
    int n;
    const ph_varying *v = varying(&a, &n);
    for (int i = 0; i < n; i++)
      if (v[i].f && !v[i].piece)
        return 1;
  }
  return 0;
}

ph_wide acts_until(const ph_top *top, ph_wide t, ph_wide h) {
  for (acts_at a = acts_first(top, t, NULL); a.e.act; acts_next(&a)) {
    int n;
    const ph_varying *v = varying(&a, &n);
    for (int i = 0; i < n; i++)
      acts_varying_until(&v[i], t, &h);
  }
  return h;
}

int acts_is_wheel(const ph_top *top, int place) {
  for (acts_at a = acts_first(top, 0, NULL); a.e.act; acts_next(&a))
    if (a.e.act->effect->wheel && a.e.place == place)
      return 1;
  return 0;
}

int acts_coupled(const ph_top *top) {
  for (acts_at a = acts_first(top, 0, NULL); a.e.act; acts_next(&a))
    if (a.e.act->effect->wheel || a.e.act->effect->tensor)
      return 1;
  return 0;
}

effect_at acts_constraint(const ph_top *top, ph_wide t, const ph_wide x[]) {
  acts_at a = acts_first(top, t, x);
  while (a.e.act && !a.e.act->effect->constrain)
    acts_next(&a);
  return a.e;
}
