/* steps.c - firmware that calls each stepper and each function of the closed form of an emitted
   scene once, for costs.lua to count. SCENE: its name; SCENE_H its header's.
   SPDX-License-Identifier: GPL-3.0-or-later

   The calls, in the order that costs.lua knows: nothing, rk4, semi, midpoint, taylor, split4,
   solve, set_tick, at, at_tick. The status is 0 if all states are finite. */
#include SCENE_H
#include "marks.h"

#define JOIN_(a, b) a##_##b
#define JOIN(a, b)  JOIN_(a, b)
#define FN(name)    JOIN(SCENE, name)
typedef FN(real) real;

static volatile real when = (real)12.345, step = (real)0.001;
static FN(model) model;
static FN(orbit) orbit;
static real start[32], x[32], y[32];

static int sound(const real v[]) {
  int good = 1;
  for (int i = 0; i < 7; i++)
    good = good && v[i] - v[i] == 0;
  return good;
}

static real *fresh(void) {
  for (int i = 0; i < 32; i++)
    x[i] = start[i];
  return x;
}

#define STEP(name)                                                                                 \
  fresh();                                                                                         \
  begin(), FN(name)(&model, t, x, (void *)0, h), end();                                            \
  bad |= !sound(x)

int main(void) {
  int bad = FN(init)(&model, (void *)0);
  FN(initial)(&model, start);
  const real t = when, h = step;
  begin(), end();
  STEP(step);
  STEP(semi_step);
  STEP(midpoint_step);
  STEP(taylor_step);
  STEP(split4_step);
  fresh();
  begin(), bad |= FN(solve)(&orbit, &model, x), end();
  begin(), bad |= FN(set_tick)(&orbit, t), end();
  begin(), FN(at)(&orbit, t, y), end();
  bad |= !sound(y);
  begin(), FN(at_tick)(&orbit, 1234567, y), end();
  return FINISH(bad || !sound(y));
}
