/* new.c - a new act of a top.
   SPDX-License-Identifier: GPL-3.0-or-later */
#include "acts.h"

#include <string.h>

int acts_new(ph_top *top, const effect_table *effect, int states, int n, const ph_varying v[],
             ph_act **act) {
  int own = states;
  for (int k = 0; k < top->acts.n; k++)
    own += top->acts.list[k].states;
  if (top->acts.n >= PH_ACTS || states < 0 || own > PH_OWN_STATES)
    return PH_ECOUNT;
  for (int i = 0; i < n; i++) {
    const int status = acts_varying_check(&v[i]);
    if (status)
      return status;
  }
  *act = &top->acts.list[top->acts.n++];
  memset(*act, 0, sizeof **act);
  (*act)->effect = effect;
  (*act)->states = states;
  for (int i = 0; i < n; i++)
    (*act)->sides += acts_varying_sides(&v[i]);
  top->effects |= effect->kind;
  return PH_OK;
}

int acts_unit(const double v[3], double out[3]) {
  ph_wide a[3];
  if (!wide_finite(3, v))
    return PH_EFINITE;
  wide_load(3, v, a);
  const ph_wide n = wide_norm(a);
  if (!(n > 0))
    return PH_EDIRECTION;
  for (int i = 0; i < 3; i++)
    out[i] = (double)(a[i] / n);
  return PH_OK;
}
