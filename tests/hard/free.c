/* free.c - asks the emitted code of a free body what else it knows: part of tests/hard.
   SPDX-License-Identifier: GPL-3.0-or-later

     run PARAMETERS... X0... T H N    the period of the rates, the precession's rate, the rotation
                                      number, the first flip after T, and the state N ticks of H s
                                      later; "refused" if there is no closed form or no such tick

   The scene is named free. Numbers are doubles in hexadecimal, rounded to the scene's type. */
#include "scene.h"

#include <stdio.h>
#include <stdlib.h>

int main(int argc, char **argv) {
  free_real p[FREE_NP + 1] = {0}, x0[FREE_NX], x[FREE_NX];
  free_model m;
  free_orbit o;
  if (argc != 1 + FREE_NP + FREE_NX + 3)
    return 2;
  char **next = argv + 1;
  for (int i = 0; i < FREE_NP; i++)
    p[i] = (free_real)strtod(*next++, NULL);
  for (int i = 0; i < FREE_NX; i++)
    x0[i] = (free_real)strtod(*next++, NULL);
  const free_real t = (free_real)strtod(next[0], NULL), h = (free_real)strtod(next[1], NULL);
  const long long n = strtoll(next[2], NULL, 10);
  if (free_init(&m, p) || free_solve(&o, &m, x0) || free_set_tick(&o, h)) {
    printf("refused\n");
    return 0;
  }
  printf("%a %a %a %a\n", (double)free_polhode_period(&o), (double)free_precession_rate(&o),
         (double)free_rotation_number(&o), (double)free_next_flip(&o, t));
  free_at_tick(&o, n, x);
  for (int i = 0; i < FREE_NX; i++)
    printf("%a%c", (double)x[i], i + 1 < FREE_NX ? ' ' : '\n');
  return 0;
}
