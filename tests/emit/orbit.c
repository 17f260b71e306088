/* orbit.c - states of constant orbits and of those set up at run time, as numbers: part of orbit.t,
   which judges. SPDX-License-Identifier: GPL-3.0-or-later

   list.h has the orbits, with tensor and initial state of each, and its times.  Prints "own|solved
   N TIME x[7]", and "tick N TIME x[7]" at 2^k ticks, for the orbit N. */
#include "body.h"
#include "list.h"

#include <math.h>
#include <stdio.h>

static void print(const char *what, size_t n, double t, const body_real x[]) {
  printf("%s %zu %a", what, n, t);
  for (int i = 0; i < 3; i++)
    printf(" %a", (double)x[BODY_WX + i]);
  for (int i = 0; i < 4; i++)
    printf(" %a", (double)x[BODY_QW + i]);
  printf("\n");
}

int main(void) {
  for (size_t n = 0; n < sizeof list / sizeof list[0]; n++) {
    body_model m;
    body_orbit solved;
    body_real x[BODY_NX];
    if (body_init(&m, list[n].tensor) != 0 || body_solve(&solved, &m, list[n].state) != 0) {
      printf("refused %zu\n", n);
      continue;
    }
    for (size_t i = 0; i < sizeof list[n].t / sizeof list[n].t[0]; i++) {
      const body_real t = list[n].t[i];
      body_at(&list[n].orbit, t, x);
      print("own", n, (double)t, x);
      body_at(&solved, t, x);
      print("solved", n, (double)t, x);
    }
    for (int k = 0; k < 40; k += 13) {
      body_at_tick(&list[n].orbit, k % 2 ? -((int64_t)1 << k) : (int64_t)1 << k, x);
      print("tick", n, ldexp((double)list[n].orbit.tick, k) * (k % 2 ? -1 : 1), x);
    }
  }
  return 0;
}
