/* stack.c - the stack that calls of an emitted scene take, by painting what lies below.
   SPDX-License-Identifier: GPL-3.0-or-later

   For Arm. SCENE, SCENE_H: as in steps.c. One line a call: its name and bytes, without those of the
   function around it that every call here has. A lowest byte that is 0xA5 by chance counts as
   unused: that would take four in a row to be off by a word. */
#include SCENE_H
#include <stdint.h>
#include <stdio.h>

#define JOIN_(a, b) a##_##b
#define JOIN(a, b)  JOIN_(a, b)
#define FN(name)    JOIN(SCENE, name)
typedef FN(real) real;

enum { BELOW = 16384 };

static volatile real when = (real)12.345, step = (real)0.001;
static FN(model) model;
static FN(orbit) orbit;
static real x[32];

static void nothing(void) {
  __asm__ volatile("" ::: "memory");
}
static void one_step(void) {
  FN(step)(&model, when, x, (void *)0, step);
}
static void one_solve(void) {
  FN(solve)(&orbit, &model, x);
}
static void one_at(void) {
  FN(at)(&orbit, when, x);
}

/* Bytes below the stack pointer as it is here; nothing is called between reading it and the loops.
 */
__attribute__((noinline)) static long painted(void (*call)(void)) {
  volatile uint8_t *top, *low;
  __asm__ volatile("mov %0, sp" : "=r"(top));
  low = top - BELOW;
  for (volatile uint8_t *p = low; p < top; p++)
    *p = 0xA5;
  call();
  while (low < top && *low == 0xA5)
    low++;
  return (long)(top - low);
}

int main(void) {
  FN(init)(&model, (void *)0);
  FN(initial)(&model, x);
  const long none = painted(nothing);
  printf("step %ld\n", painted(one_step) - none);
  printf("solve %ld\n", painted(one_solve) - none);
  printf("at %ld\n", painted(one_at) - none);
  return 0;
}
