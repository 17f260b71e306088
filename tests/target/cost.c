/* cost.c - firmware that calls each function of an emitted free top once, for count.c to count.
   SPDX-License-Identifier: GPL-3.0-or-later

   The calls, in the order that cost.lua knows: nothing, solve, set_tick, at, at_rates, at_attitude,
   at_tick, step; nearly all paths of solve do the same work, and a state near the separatrix, the
   other half of the code, follows: solve, at, at_tick. The result is 0 if all states are finite. */
#include "brick_centroid.h"
#include "marks.h"

static volatile brick_centroid_real when = 12.345F;
static brick_centroid_model model;
static brick_centroid_orbit orbit;

static int finite(int n, const brick_centroid_real x[]) {
  int good = 1;
  for (int i = 0; i < n; i++)
    good = good && x[i] - x[i] == 0;
  return good;
}

int main(void) {
  brick_centroid_real x[BRICK_CENTROID_NX], y[BRICK_CENTROID_NX], t;
  int bad = brick_centroid_init(&model, (void *)0);
  brick_centroid_initial(&model, x);
  begin(), end();
  begin(), bad |= brick_centroid_solve(&orbit, &model, x), end();
  t = when;
  begin(), bad |= brick_centroid_set_tick(&orbit, t), end();
  begin(), brick_centroid_at(&orbit, t, y), end();
  bad |= !finite(BRICK_CENTROID_NX, y);
  begin(), brick_centroid_at_rates(&orbit, t, y), end();
  bad |= !finite(3, y);
  begin(), brick_centroid_at_attitude(&orbit, t, y), end();
  bad |= !finite(4, y);
  begin(), brick_centroid_at_tick(&orbit, 1234567, y), end();
  bad |= !finite(BRICK_CENTROID_NX, y);
  begin(), brick_centroid_step(&model, t, x, (void *)0, 0.01F), end();
  /* about the middle axis, a thousandth off */
  x[BRICK_CENTROID_WX] = x[BRICK_CENTROID_WZ] = 0.001F;
  x[BRICK_CENTROID_WY] = 1;
  begin(), bad |= brick_centroid_solve(&orbit, &model, x), end();
  bad |= !orbit.hyperbolic;
  bad |= brick_centroid_set_tick(&orbit, t);
  begin(), brick_centroid_at(&orbit, t, y), end();
  begin(), brick_centroid_at_tick(&orbit, 1234567, y), end();
  return bad || !finite(BRICK_CENTROID_NX, y);
}
