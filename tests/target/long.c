/* long.c - a million steps of two steppers of an emitted scene: hashes of the last states.
   SPDX-License-Identifier: GPL-3.0-or-later

   SCENE, UPPER, SCENE_H, H: as in bits.c; --method rk4,semi. */
#include "hash.h"

static volatile real step = (real)H;
static FN(model) model;
static real x[NX];

static void run(void (*advance)(const FN(model) *, real, real[], const real[], real),
                const char *name) {
  const real h = step;
  FN(initial)(&model, x);
  for (long i = 0; i < 1000000; i++)
    advance(&model, (real)i * h, x, (void *)0, h);
  numbers(x, NX);
  item(name);
}

int main(void) {
  start();
  whole(FN(init)(&model, (void *)0));
  item("init");
  run(FN(step), "step");
  run(FN(semi_step), "semi_step");
  return 0;
}
