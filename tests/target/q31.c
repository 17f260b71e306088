/* q31.c - firmware for q31.t: an emitted fixed-point step, counted, and its self-test.
   SPDX-License-Identifier: GPL-3.0-or-later

   What is counted: nothing, a step of the scene's motion, one with a component beyond its limit,
   the energy; a fifth mark says that the self-test has passed, and nothing else does. It runs
   without printing, and is judged by what its main returns. */
#include <stdio.h>
#undef printf
#define printf(...) ((void)0)
#define main        selftest
#include "b_q31_test.c"
#undef main
#undef printf
#include "marks.h"

int main(void) {
  static const int32_t u[3] = {1000, -1000, 500};
  int32_t x[B_Q31_NX];
  volatile int32_t energy;
  volatile unsigned bits;
  b_q31_initial(x);
  begin(), end();
  begin(), bits = b_q31_step(x, u), end();
  x[B_Q31_WX] = 2147483647;
  begin(), bits = b_q31_step(x, u), end();
  begin(), energy = b_q31_energy(x), end();
  (void)energy;
  if (selftest() == 0 && bits != 0)
    begin(), end();
  return FINISH(0);
}
