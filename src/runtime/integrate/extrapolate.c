/* extrapolate.c - one step by Gragg's midpoint rule, extrapolated, in long double.
   SPDX-License-Identifier: GPL-3.0-or-later

   For equations whose Taylor series are not formed. With n = 2, 4, 6, .. substeps of H/n the rule
     z_1 = z_0 + h f(z_0),   z_{m+1} = z_{m-1} + 2 h f(z_m)
   has, for even n, an error in even powers of h (Gragg, SIAM J. Numer. Anal. 2 (1965) 384), which
   polynomial extrapolation in h^2 removes power by power (Hairer, Norsett, Wanner, Solving ODEs I,
   II.9). What is extrapolated is the increment z_n - z_0, so that its rounding is that of the
   change. A column is one more power; when COLUMNS of them do not reach the tolerance, the step was
   too long. The rule never asks for f at the end of the step, so a corner in its last part is seen
   by no column. Gragg's smoothed value (z_{n-1} + z_n + h f(z_n))/2 has the same limit and powers
   and does ask: what extrapolation leaves of their difference counts as an error too. A corner at
   (1 - a) H makes it half of the increment's own error or more. Where there are none but those that
   corner.c knows, it is asked for less: an eighth, so that smooth equations cost what the columns
   ask for. */
#include "acts/acts.h"
#include "step.h"

enum { COLUMNS = 12, BEST = 9, SEEN = 8 };

/* The increment over H by n substeps from x, whose rates are f0; *smoothed: Gragg's smoothed one
   less that. */
static int midpoint(stepper *s, const ph_wide x[], const ph_wide f0[], ph_wide H, int n,
                    ph_wide out[], ph_wide smoothed[]) {
  const int states = ph_top_states(s->top);
  ph_wide z[PH_STATES], before[PH_STATES], now[PH_STATES], f[PH_STATES] = {0};
  const ph_wide h = H / n;
  for (int i = 0; i < states; i++) {
    before[i] = 0;
    now[i] = h * f0[i];
  }
  for (int m = 1; m <= n; m++) {
    for (int i = 0; i < states; i++)
      z[i] = x[i] + now[i];
    const int status = motion_rates(s->top, &s->loads, s->t + m * h, z, f);
    s->evaluations++;
    if (status) /* beyond its start a step that is too long may leave what the equations admit */
      return status == PH_EROD ? PH_ERANGE : status;
    for (int i = 0; i < states && m < n; i++) {
      const ph_wide next = before[i] + 2 * h * f[i];
      before[i] = now[i];
      now[i] = next;
    }
  }
  for (int i = 0; i < states; i++) {
    out[i] = now[i];
    smoothed[i] = (before[i] - now[i] + h * f[i]) / 2;
  }
  return wide_fits(states, now) && wide_fits(states, smoothed) ? PH_OK : PH_ERANGE;
}

/* Row k of the table, whose first column is in row, becomes its last one: T holds the columns of
   the row before. *error: by how much the last column changed it. */
static void extrapolate(int states, int k, ph_wide T[COLUMNS][PH_STATES], ph_wide row[],
                        ph_wide error[]) {
  for (int j = 1; j <= k; j++) {
    const ph_wide ratio = (ph_wide)(k + 1) / (k + 1 - j);
    for (int i = 0; i < states; i++) {
      const ph_wide better = row[i] + (row[i] - T[j - 1][i]) / (ratio * ratio - 1);
      T[j - 1][i] = row[i];
      error[i] = better - row[i];
      row[i] = better;
    }
  }
  for (int i = 0; i < states; i++)
    T[k][i] = row[i];
}

int step_extrapolate(stepper *s, const ph_wide x[], ph_wide tolerance, ph_wide *h, ph_wide *next,
                     ph_wide out[]) {
  const int n = ph_top_states(s->top);
  ph_wide T[COLUMNS][PH_STATES], D[COLUMNS][PH_STATES], f0[PH_STATES];
  const ph_wide enough = fmaxl(tolerance, 32 * LDBL_EPSILON), part = s->unseen ? 1 : SEEN;
  step_scale scale;
  int status = step_scale_at(s, x, &scale);
  if (!status)
    status = motion_rates(s->top, &s->loads, s->t, x, f0);
  s->evaluations++;
  if (status)
    return status;
  for (;;) {
    ph_wide e = HUGE_VALL, row[PH_STATES], seen[PH_STATES], error[PH_STATES], none[PH_STATES];
    int k = 0;
    for (; k < COLUMNS && e > enough; k++) {
      status = midpoint(s, x, f0, *h, 2 * (k + 1), row, seen);
      if (status)
        break;
      extrapolate(n, k, T, row, error);
      extrapolate(n, k, D, seen, none);
      if (k > 0)
        e = fmaxl(step_relative(s->top, &scale, x, row, *h, error),
                  step_relative(s->top, &scale, x, row, *h, seen) / part);
    }
    if (status && status != PH_ERANGE)
      return status;
    if (!status && (e <= enough || tolerance == 0)) {
      for (int i = 0; i < n; i++)
        out[i] = x[i] + row[i];
      *next = fabsl(*h) * (k < BEST - 2 ? 2 : k < BEST ? 1.25L : k == BEST ? 1 : 0.8L);
      return wide_fits(n, out) ? PH_OK : PH_ERANGE;
    }
    if (s->t + *h == s->t)
      return PH_ESTEP;
    *h *= status ? 0.1L : 0.4L;
  }
}
