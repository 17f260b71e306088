/* held.c - what wheels and moving parts hold: tensor, energy, angular momentum.
   SPDX-License-Identifier: GPL-3.0-or-later */
#include "acts.h"

/* What a wheel turns at: beside the body if that has it in its tensor, else in space. */
static ph_wide speed_of(const effect_at *e, const effect_spinner *wheel) {
  return e->x[e->place] + (wheel->included ? 0 : wide_dot(wheel->axis, e->x + 4));
}

/* T of the body's own tensor is in the caller's sum: an included wheel moves in it as if locked. */
ph_wide acts_kinetic(const ph_top *top, const ph_wide x[]) {
  ph_wide T = 0, D[6], Dw[3];
  if (acts_tensor(top, x, D)) {
    wide_apply(D, x + 4, Dw);
    T = wide_dot(x + 4, Dw) / 2;
  }
  for (acts_at a = acts_first(top, 0, x); a.e.act; acts_next(&a))
    if (a.e.act->effect->wheel) {
      effect_spinner wheel;
      a.e.act->effect->wheel(a.e.act, &wheel);
      const ph_wide W = x[a.e.place], along = wide_dot(wheel.axis, x + 4);
      T += wheel.J / 2 * (wheel.included ? W * (W + 2 * along) : (W + along) * (W + along));
    } else if (a.e.act->effect->kinetic) {
      T += a.e.act->effect->kinetic(&a.e);
    }
  return T;
}

void acts_momentum(const ph_top *top, const ph_wide x[], ph_wide L[3]) {
  ph_wide D[6], Dw[3];
  if (acts_tensor(top, x, D)) {
    wide_apply(D, x + 4, Dw);
    for (int i = 0; i < 3; i++)
      L[i] += Dw[i];
  }
  for (acts_at a = acts_first(top, 0, x); a.e.act; acts_next(&a))
    if (a.e.act->effect->wheel) {
      effect_spinner wheel;
      a.e.act->effect->wheel(a.e.act, &wheel);
      const ph_wide speed = speed_of(&a.e, &wheel);
      for (int i = 0; i < 3; i++)
        L[i] += wheel.J * speed * wheel.axis[i];
    }
}

int acts_locked(const ph_top *top, const ph_wide x[], ph_wide D[6]) {
  int any = acts_tensor(top, x, D);
  for (acts_at a = acts_first(top, 0, x); a.e.act; acts_next(&a))
    if (a.e.act->effect->wheel) {
      effect_spinner wheel;
      a.e.act->effect->wheel(a.e.act, &wheel);
      if (wheel.included)
        continue;
      wide_add_outer(D, wheel.J, wheel.axis);
      any = 1;
    }
  return any;
}

void acts_whole(const ph_top *top, const ph_wide x[], ph_wide L[3]) {
  wide_apply(top->wide_inertia, x + 4, L);
  acts_momentum(top, x, L);
  for (int i = 0; i < 3 && top->effects & PH_ROTOR; i++)
    L[i] += (ph_wide)top->rotor[i];
}
