/* plane.c - bodies/chaplygin_ball.lua by the emitted code, for make bench-plane.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * plane TRUTH SECONDS writes the state at the end to the file TRUTH, by the Taylor series at 1e-15,
 * as qw qx qy qz wx wy wz p1 p2; the peers (plane_simbody.cpp, plane_scipy.py) read it. All print
 * the same columns: ns for the rates, ms for a run, the error of the angular velocity at its end.
 */
#include "clock.h"
#include "chaplygin_ball.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { ROUNDS = 11, CALLS = 200000, NX = CHAPLYGIN_BALL_NX };

static double median(double list[ROUNDS]) {
  qsort(list, ROUNDS, sizeof *list, ascending);
  return list[ROUNDS / 2];
}

int main(int argc, char **argv) {
  chaplygin_ball_model m;
  double start[NX], x[NX], truth[NX], dx[NX], rates[ROUNDS], runs[ROUNDS], sum = 0;
  if (argc < 3 || chaplygin_ball_init(&m, NULL) != 0)
    return 1;
  const double span = atof(argv[2]);
  chaplygin_ball_initial(&m, start);
  memcpy(truth, start, sizeof truth);
  chaplygin_ball_taylor_run(&m, 0, truth, NULL, span, 1e-15, 1000000);
  FILE *file = fopen(argv[1], "w");
  if (!file)
    return 1;
  for (int i = 0; i < NX; i++)
    fprintf(file, "%.17g\n", truth[i]);
  fclose(file);
  for (int r = 0; r < ROUNDS; r++) {
    double t = now();
    memcpy(x, start, sizeof x);
    for (int k = 0; k < CALLS; k++) {
      x[4] = start[4] + 1e-9 * k;
      chaplygin_ball_rhs(&m, 0, x, NULL, dx);
      sum += dx[5];
    }
    rates[r] = (now() - t) / CALLS;
    t = now();
    memcpy(x, start, sizeof x);
    chaplygin_ball_adaptive_run(&m, 0, x, NULL, span, 1e-9, 1000000);
    runs[r] = now() - t;
  }
  double error = 0;
  for (int i = 4; i < 7; i++)
    error = fmax(error, fabs(x[i] - truth[i]));
  printf("%-40s %12.4g %12.4g %12.2g\n", "emitted code, adaptive", median(rates) * 1e9,
         median(runs) * 1e3, error);
  return sum == 0.5; /* the rates are looked at */
}
