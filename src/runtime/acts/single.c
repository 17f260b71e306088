/* single.c - the effects that a top has one of, and keeps in itself.
   SPDX-License-Identifier: GPL-3.0-or-later */
#include "acts.h"

void acts_load(const ph_top *top, const double u[3], motion_loads *loads) {
  for (const effect_table *const *effect = effect_all; *effect; effect++)
    if ((*effect)->load)
      (*effect)->load(top, u, loads);
}

ph_wide acts_add_potential(const ph_top *top, const ph_wide x[], ph_wide V) {
  const effect_at at = {top, NULL, 0, x, 0, 0};
  for (const effect_table *const *effect = effect_all; *effect; effect++)
    if ((*effect)->load && (*effect)->potential)
      V += (*effect)->potential(&at);
  return V;
}
