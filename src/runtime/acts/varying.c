/* varying.c - numbers that vary: constants, tables over time, functions of the state.
   SPDX-License-Identifier: GPL-3.0-or-later */
#include "acts.h"

/* The row before t by bisection, then the chord: not a sum of ramps. */
static ph_wide interpolated(int n, const double tv[], ph_wide t) {
  int lo = 0, hi = n - 1;
  if (t <= (ph_wide)tv[0])
    return (ph_wide)tv[1];
  if (t >= (ph_wide)tv[2 * hi])
    return (ph_wide)tv[2 * hi + 1];
  while (hi - lo > 1) {
    const int middle = lo + (hi - lo) / 2;
    if (t < (ph_wide)tv[2 * middle])
      hi = middle;
    else
      lo = middle;
  }
  const ph_wide t0 = (ph_wide)tv[2 * lo], t1 = (ph_wide)tv[2 * hi];
  const ph_wide part = (t - t0) / (t1 - t0);
  return (1 - part) * (ph_wide)tv[2 * lo + 1] + part * (ph_wide)tv[2 * hi + 1];
}

int acts_varying_sides(const ph_varying *v) {
  return v->f && v->piece ? v->sides : 0;
}

ph_wide acts_value(const effect_at *e, ph_wide t, const ph_varying *v) {
  if (!v->f)
    return v->rows > 0 ? interpolated(v->rows, v->table, t) : (ph_wide)v->value;
  if (e->top->branch && acts_varying_sides(v) > 0) {
    int n, first = e->side;
    for (const ph_varying *u = e->act->effect->varying(e->act, &n); u != v; u++)
      first += acts_varying_sides(u);
    const ph_wide y = v->piece(v->context, t, e->x, e->top->branch + first, NULL);
    if (isfinite(y)) /* a root does not go on beyond its zero */
      return y;
  }
  return v->f(v->context, t, e->x);
}

int acts_varying_check(const ph_varying *v) {
  if (v->f)
    return v->sides < 0 ? PH_ECOUNT : PH_OK;
  if (v->rows == 0)
    return isfinite(v->value) ? PH_OK : PH_EFINITE;
  if (v->rows < 2 || !v->table)
    return PH_ECOUNT;
  if (!wide_finite(2 * v->rows, v->table))
    return PH_EFINITE;
  for (int i = 1; i < v->rows; i++)
    if (!(v->table[2 * i] > v->table[2 * i - 2]))
      return PH_ECOUNT;
  return PH_OK;
}

void acts_varying_until(const ph_varying *v, ph_wide t, ph_wide *h) {
  for (int i = 0; i < v->rows && !v->f; i++) {
    const ph_wide step = (ph_wide)v->table[2 * i] - t;
    const ph_wide least = 16 * LDBL_EPSILON * fmaxl(fabsl(t), fabsl(t + step));
    if (step * *h > 0 && fabsl(step) > least && fabsl(step) < fabsl(*h))
      *h = step;
  }
}
