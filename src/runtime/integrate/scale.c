/* scale.c - by what the error of a step is measured.
   SPDX-License-Identifier: GPL-3.0-or-later

   |q| = 1; w, r and v count by their size and by what the step changes, own states each by its own.
   A body that comes to rest ends with sizes that are rounding: what is left of w, say, where the
   terms of a torque cancel that are large. No step follows that, however short. So a size is never
   less than what the terms of its rate, each on its own, make of it within the step: below the
   rounding of that the rate itself is not known, and a place not below what that makes of it. A
   rate whose terms vanish with the state has no such floor, and a motion that grows out of 1e-100
   is followed from there. */
#include "acts/acts.h"
#include "motion/move.h"
#include "step.h"

int step_scale_at(const stepper *s, const ph_wide x[], step_scale *out) {
  const ph_top *top = s->top;
  *out = (step_scale){.torque = motion_torque_size(top, &s->loads, s->t, x),
                      .force = move_force_size(top, s->t, x)};
  const effect_at plane = acts_constraint(top, s->t, x);
  if (!plane.act)
    return PH_OK;
  const int status = plane.act->effect->reach(&plane, &out->arm, &out->pull);
  out->place = plane.place;
  out->placed = plane.act->states;
  out->torque += (ph_wide)top->mass * out->arm * out->pull;
  return status;
}

/* What state i >= 4 is a part of or beside. A wheel's speed counts from the body's, so at rest
   beside it the speed is known to the rounding of w and no better. A place on a plane is known to
   that of the way to the contact point; a velocity along it and this way times w make the slip
   together, so each is known to the other's. */
static ph_wide beside(const ph_top *top, const step_scale *c, const ph_wide x[], ph_wide h, int i) {
  const int k = i - c->place, slides = c->placed == 4;
  const ph_wide largest = top->wide_moment[2]; /* 0: a particle, which nothing turns */
  if (i < 7) /* of the largest moment: about the others step_relative allows what it is for them */
    return (largest > 0 ? fabsl(h) * c->torque / largest : 0) +
           (slides && c->arm > 0 ? step_size(2, x + c->place + 2) / c->arm : 0);
  if (c->placed && k >= 0 && k < c->placed)
    return k < 2 ? c->arm : c->arm * step_size(3, x + 4) + fabsl(h) * c->pull;
  if (i < 13 && top->effects & PH_TRANSLATION) /* a velocity, and what it makes of a place */
    return fabsl(h) * c->force / (ph_wide)top->mass * (i < 10 ? fabsl(h) : 1);
  return acts_is_wheel(top, i) ? step_size(3, x + 4) : 0;
}

ph_wide step_scale_of(const ph_top *top, const step_scale *c, const ph_wide x[], const ph_wide d[],
                      ph_wide h, int i, int *width) {
  const int shared = ph_top_states(top) - acts_states(top);
  *width = i < 4 ? 4 : i < shared ? 3 : 1;
  return i < 4 ? 1 : step_size(*width, x + i) + step_size(*width, d + i) + beside(top, c, x, h, i);
}

ph_wide step_relative(const ph_top *top, const step_scale *c, const ph_wide x[], const ph_wide d[],
                      ph_wide h, const ph_wide e[]) {
  ph_wide worst = 0;
  for (int i = 0, width; i < ph_top_states(top); i += width) {
    const ph_wide size = step_scale_of(top, c, x, d, h, i, &width);
    ph_wide part = size > 0 ? step_size(width, e + i) / size : 0;
    if (i == 4 && part > 0 && c->torque > 0) { /* about each axis its moment times the error */
      ph_wide L[3];
      wide_apply(top->wide_inertia, e + 4, L);
      part = fminl(part, step_size(3, L) / (fabsl(h) * c->torque));
    }
    worst = fmaxl(worst, part);
  }
  return worst;
}
