/* ball.c - prints what the closed form of a ball's centre gives: part of ball.t, which judges.
   SPDX-License-Identifier: GPL-3.0-or-later

   Arguments: times.  Prints a line for each: p1 p2 v1 v2 W1 W2 W3, as hexadecimal numbers. */
#include "body_orbit.h"

#include <stdio.h>
#include <stdlib.h>

int main(int argc, char **argv) {
  body_model m;
  body_orbit o;
  body_real x[BODY_NX], p[2], v[2], W[3];
  if (body_init(&m, 0) != 0)
    return 1;
  body_initial(&m, x);
  if (body_solve(&o, &m, x) != 0)
    return 1;
  for (int k = 1; k < argc; k++) {
    body_at_centre(&o, (body_real)strtod(argv[k], 0), p, v, W);
    printf("%a %a %a %a %a %a %a\n", (double)p[0], (double)p[1], (double)v[0], (double)v[1],
           (double)W[0], (double)W[1], (double)W[2]);
  }
  return 0;
}
