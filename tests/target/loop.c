/* loop.c - the whole of a small firmware: set-up, a loop of steps, a result.
   SPDX-License-Identifier: GPL-3.0-or-later

   SCENE, SCENE_H: as in steps.c. With startup.c all that is in the flash memory; its size is what
   numbers.t asks for. Status 0, by semihosting: after 1000 steps |q| is 1 to some roundings. */
#include SCENE_H

#define JOIN_(a, b) a##_##b
#define JOIN(a, b)  JOIN_(a, b)
#define FN(name)    JOIN(SCENE, name)
typedef FN(real) real;

static FN(model) model;
static real x[16];
static volatile unsigned int ticks; /* what a timer's interrupt would count */

int main(void) {
  const real h = (real)0.001;
  if (FN(init)(&model, (void *)0))
    return 2;
  FN(initial)(&model, x);
  for (; ticks < 1000; ticks++)
    FN(step)(&model, (real)ticks * h, x, (void *)0, h);
  const real off = x[0] * x[0] + x[1] * x[1] + x[2] * x[2] + x[3] * x[3] - (real)1;
  return !(off * off < (real)1e-10);
}
