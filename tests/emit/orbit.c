/* orbit.c - states of the constant orbit of a baked scene and of the one set up at run time, as
   numbers: part of orbit.t, which judges. SPDX-License-Identifier: GPL-3.0-or-later

   Reads times; prints "own|solved TIME x[7]" for each, and "tick TIME x[7]" at 2^k ticks of the
   scene's step. */
#include "body.h"

#include <math.h>
#include <stdio.h>

static void print(const char *what, double t, const body_real x[]) {
  printf("%s %a", what, t);
  for (int i = 0; i < 3; i++)
    printf(" %a", (double)x[BODY_WX + i]);
  for (int i = 0; i < 4; i++)
    printf(" %a", (double)x[BODY_QW + i]);
  printf("\n");
}

int main(int argc, char **argv) {
  body_model m;
  body_orbit solved;
  body_real x[BODY_NX];
  double t;
  const int ticks = argc > 1 ? argv[1][0] == 'y' : 0;
  if (body_init(&m, NULL) != 0)
    return 1;
  body_initial(&m, x);
  if (body_solve(&solved, &m, x) != 0)
    return 2;
  print("start", 0, x);
  while (scanf("%la", &t) == 1) {
    body_at(&body_own_orbit, (body_real)t, x);
    print("own", (double)(body_real)t, x);
    body_at(&solved, (body_real)t, x);
    print("solved", (double)(body_real)t, x);
  }
  for (int k = 0; ticks && k < 40; k += 3) {
    body_at_tick(&body_own_orbit, k % 2 ? -((int64_t)1 << k) : (int64_t)1 << k, x);
    print("tick", ldexp((double)body_own_orbit.tick, k) * (k % 2 ? -1 : 1), x);
  }
  return 0;
}
