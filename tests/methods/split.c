/* split.c - measures the emitted splitting steppers of a scene called top; split.t judges.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 *     ./split T STEPS HALVINGS
 * prints, a line each and by method:
 *     order NAME e0 e1 ..      largest error at T with STEPS, 2 STEPS .. steps, against the Taylor
 * series of order 20 back NAME e              what is left of the start after STEPS steps forth and
 * back, in units of the state's size drift NAME a b q l       largest |E - E0| in the first and in
 * the last tenth of 100 000 steps, in units of the kinetic energy; largest | |q| - 1 |; change of
 * |L| in units of |L| (0 where nothing turns)
 */
#include "top.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

typedef void step_function(const top_model *, top_real, top_real *, const top_real *, top_real);

static const struct {
  const char *name;
  step_function *step;
} methods[] = {
    {"split2", top_split2_step},
#ifndef ONLY_2
    {"split4", top_split4_step},
    {"split6", top_split6_step},
#endif
};
enum { METHODS = sizeof methods / sizeof *methods, LONG = 100000 };

static const top_real u[3] = {(top_real)0.002, (top_real)-0.001, (top_real)0.0015};
static top_model model;

/* largest difference, each kind of state in units of its size in b */
static double difference(const top_real a[], const top_real b[]) {
  double worst = 0.0, size[2] = {1e-30, 1e-30};
  for (int i = 0; i < TOP_NX; i++) {
    const int kind = i >= 4;
    size[kind] = fmax(size[kind], fabs((double)b[i]));
  }
  for (int i = 0; i < TOP_NX; i++)
    worst = fmax(worst, fabs((double)a[i] - (double)b[i]) / size[i >= 4]);
  return worst;
}

static void run(step_function *step, top_real x[], int n, top_real h) {
  for (int i = 0; i < n; i++)
    step(&model, (top_real)i * h, x, u, h);
}

static void orders(int m, const top_real want[], double T, int steps, int halvings) {
  printf("order %s", methods[m].name);
  for (int k = 0; k <= halvings; k++) {
    top_real x[TOP_NX];
    const int n = steps << k;
    top_initial(&model, x);
    run(methods[m].step, x, n, (top_real)(T / n));
    printf(" %.6e", difference(x, want));
  }
  printf("\n");
}

static void back(int m, double T, int steps) {
  top_real x[TOP_NX], x0[TOP_NX];
  const top_real h = (top_real)(T / steps);
  top_initial(&model, x0);
  top_initial(&model, x);
  run(methods[m].step, x, steps, h);
  for (int i = steps; i > 0; i--)
    methods[m].step(&model, (top_real)i * h, x, u, -h);
  printf("back %s %.6e\n", methods[m].name, difference(x, x0));
}

static double length(const top_real x[]) {
#ifdef TURNS
  top_real L[3];
  top_momentum_body(&model, x, L);
  return sqrt((double)(L[0] * L[0] + L[1] * L[1] + L[2] * L[2]));
#else
  (void)x;
  return 1.0;
#endif
}

static void drift(int m, double T, int steps) {
  top_real x[TOP_NX];
  const top_real h = (top_real)(T / steps);
  top_initial(&model, x);
  const double E0 = (double)top_energy(&model, x), L0 = length(x);
  double first = 0.0, last = 0.0, norm = 0.0, l = 0.0;
  for (int i = 0; i < LONG; i++) {
    methods[m].step(&model, (top_real)i * h, x, u, h);
    const double e = fabs((double)top_energy(&model, x) - E0);
    if (i < LONG / 10)
      first = fmax(first, e);
    if (i >= LONG - LONG / 10)
      last = fmax(last, e);
#ifdef TURNS
    norm = fmax(norm,
                fabs(sqrt((double)(x[0] * x[0] + x[1] * x[1] + x[2] * x[2] + x[3] * x[3])) - 1.0));
#endif
    l = fmax(l, fabs(length(x) - L0) / L0);
  }
  printf("drift %s %.6e %.6e %.6e %.6e\n", methods[m].name, first / fabs(E0), last / fabs(E0), norm,
         l);
}

int main(int argc, char **argv) {
  if (argc != 4)
    return 2;
  const double T = atof(argv[1]);
  const int steps = atoi(argv[2]), halvings = atoi(argv[3]);
  top_real want[TOP_NX];
  if (top_init(&model, NULL))
    return 1;
  top_initial(&model, want);
  for (int i = 0; i < 64 * steps; i++)
    top_taylor_step(&model, (top_real)(i * (T / (64 * steps))), want, u,
                    (top_real)(T / (64 * steps)));
  for (int m = 0; m < METHODS; m++) {
    orders(m, want, T, steps, halvings);
    back(m, T, steps);
    drift(m, T, steps);
  }
  return 0;
}
