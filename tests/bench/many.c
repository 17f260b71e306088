/* many.c - what a step costs when many bodies move at once: emitted in lanes, emitted alone, and
 * hand-written; and the same of a Taylor run to the end of the scene.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * argv[1] names the compiler's flags.  All rows run in turn, REPEATS rounds, and the median counts.
 * The bodies differ a little in their rates, so that no two do the same.  The results are compared,
 * too: a body among many has the bits that it has alone.
 */
#include "clock.h"
#include "hand.h"
#include "tumbling_box.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { REPEATS = 15, BODIES = 1024, STEPS = 200, RUNS = 256, STATES = 7, ROWS = 5 };

typedef tumbling_box_real real;

static tumbling_box_model box;
static double quotients[3];
static real start[STATES * BODIES], x[STATES * BODIES];
static const real h = (real)1e-3, horizon = 100;
static int steps[BODIES];

/* component i of body k of n to or from one body's state */
static void take(real *one, const real *all, int n, int k) {
  for (int i = 0; i < STATES; i++)
    one[i] = all[i * n + k];
}

static void give(const real *one, real *all, int n, int k) {
  for (int i = 0; i < STATES; i++)
    all[i * n + k] = one[i];
}

static double by_hand(void) {
  double one[STATES];
  for (int i = 0; i < STATES; i++)
    one[i] = (double)start[i * BODIES];
  const double t = now();
  for (int j = 0; j < STEPS * BODIES; j++)
    hand_rk4_quotients(quotients, one, (double)h);
  return (now() - t) / STEPS / BODIES;
}

static double alone(void) {
  const double t = now();
  for (int k = 0; k < BODIES; k++) {
    real one[STATES];
    take(one, start, BODIES, k);
    for (int j = 0; j < STEPS; j++)
      tumbling_box_step(&box, 0, one, NULL, h);
    give(one, x, BODIES, k);
  }
  return (now() - t) / STEPS / BODIES;
}

static double together(void) {
  memcpy(x, start, sizeof x);
  const double t = now();
  tumbling_box_advance_many(&box, 0, x, NULL, h, STEPS, BODIES);
  return (now() - t) / STEPS / BODIES;
}

static double run_alone(void) {
  const double t = now();
  for (int k = 0; k < RUNS; k++) {
    real one[STATES];
    take(one, start, BODIES, k);
    steps[k] = tumbling_box_taylor_run(&box, 0, one, NULL, horizon, TOLERANCE, 1000000);
    give(one, x, RUNS, k);
  }
  return (now() - t) / RUNS;
}

static double run_together(void) {
  for (int i = 0; i < STATES; i++)
    memcpy(x + i * RUNS, start + i * BODIES, RUNS * sizeof x[0]);
  const double t = now();
  tumbling_box_taylor_run_many(&box, 0, x, NULL, horizon, TOLERANCE, 1000000, steps, RUNS);
  return (now() - t) / RUNS;
}

static const struct {
  const char *name;
  double (*run)(void);
  int against; /* the row that it is to be faster than */
  int same;    /* and has the bits of */
} rows[ROWS] = {{"hand-written RK4 step, one body", by_hand, -1, 0},
                {"emitted RK4 step, one body", alone, 0, 0},
                {"emitted RK4 step, many bodies", together, 0, 1},
                {"emitted Taylor run, one body", run_alone, -1, 0},
                {"emitted Taylor run, many bodies", run_together, 3, 1}};

int main(int argc, char **argv) {
  static double time[ROWS][REPEATS];
  static real before[STATES * BODIES];
  double I[6], middle[ROWS];
  real first[STATES];

  if (tumbling_box_init(&box, NULL) != 0)
    return 1;
  tumbling_box_initial(&box, first);
  {
    real tensor[6];
    tumbling_box_inertia(&box, tensor);
    for (int i = 0; i < 6; i++)
      I[i] = (double)tensor[i];
  }
  for (int i = 0; i < 3; i++)
    quotients[i] = (I[(i + 1) % 3] - I[(i + 2) % 3]) / I[i];
  for (int k = 0; k < BODIES; k++) {
    real one[STATES];
    memcpy(one, first, sizeof one);
    one[4] += (real)(1e-4 * k);
    give(one, start, BODIES, k);
  }
  int unequal = 0;
  for (int j = -1; j < REPEATS; j++) { /* round -1 warms up */
    for (int r = 0; r < ROWS; r++) {
      const double t = rows[r].run() * 1e9;
      if (j >= 0)
        time[r][j] = t;
      unequal += rows[r].same && memcmp(before, x, sizeof x) != 0;
      memcpy(before, x, sizeof x);
    }
  }
  printf("%s: ns a step, or a run of %g s to %g\n", argc > 1 ? argv[1] : "", (double)horizon,
         (double)TOLERANCE);
  for (int r = 0; r < ROWS; r++) {
    qsort(time[r], REPEATS, sizeof time[r][0], ascending);
    middle[r] = time[r][REPEATS / 2];
    printf("  %-34s %10.2f", rows[r].name, middle[r]);
    if (rows[r].against >= 0)
      printf("  %6.2f times as fast", middle[rows[r].against] / middle[r]);
    puts("");
  }
  if (unequal)
    puts("  the bits of bodies among many and alone differ");
  return unequal != 0;
}
