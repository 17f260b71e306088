/* drift.c - how energy and momentum drift in a long run of each stepper, for a scene called top.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 *     ./drift PERIOD REVOLUTIONS
 * A line a stepper: name; steps in a revolution (0: as many as its tolerance asks for); largest
 * error of the energy (in units of the kinetic energy at the start) in the first and in the last
 * thousandth of the run; the same of the momentum, in units of |L|; largest | |q| - 1 | in the
 * last. MOMENTUM says which momentum: 0 the vector in inertial axes, 1 its component along z.
 */
#include "top.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

typedef void step_function(const top_model *, double, double *, const double *, double);
typedef int run_function(const top_model *, double, double *, const double *, double, double, int);

static const struct {
  const char *name;
  int steps; /* in a revolution */
  step_function *step;
  run_function *run;
} rows[] = {
#include "steppers.h"
};

static top_model model;
static double T0, E0, L0[3];

struct errors {
  double energy, momentum, norm;
};

static void look(const double x[], struct errors *e) {
  double L[3], size = sqrt(L0[0] * L0[0] + L0[1] * L0[1] + L0[2] * L0[2]);
  const double q = sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2] + x[3] * x[3]);
  top_momentum(&model, x, L);
  for (int i = MOMENTUM ? 2 : 0; i < 3; i++)
    e->momentum = fmax(e->momentum, fabs(L[i] - L0[i]) / size);
  e->energy = fmax(e->energy, fabs(top_energy(&model, x) - E0) / T0);
  e->norm = fmax(e->norm, fabs(q - 1.0));
}

int main(int argc, char **argv) {
  const double period = argc == 3 ? atof(argv[1]) : 0.0;
  const long turns = argc == 3 ? atol(argv[2]) : 0;
  if (!(period > 0.0) || turns < 1000 || top_init(&model, NULL))
    return 2;
  for (unsigned n = 0; n < sizeof rows / sizeof *rows; n++) {
    struct errors first = {0, 0, 0}, last = {0, 0, 0};
    double x[TOP_NX], I[6];
    top_initial(&model, x);
    top_inertia(&model, I);
    E0 = top_energy(&model, x);
    T0 = 0.5 * (I[0] * x[4] * x[4] + I[1] * x[5] * x[5] + I[2] * x[6] * x[6]);
    top_momentum(&model, x, L0);
    for (long turn = 0; turn < turns; turn++) {
      struct errors *e = turn < turns / 1000 ? &first : turn >= turns - turns / 1000 ? &last : NULL;
      const double t = (double)turn * period;
      if (rows[n].run) {
        if (rows[n].run(&model, t, x, NULL, t + period, 1e-14, 100000) < 0)
          return 1;
        if (e)
          look(x, e);
        continue;
      }
      const double h = period / rows[n].steps;
      for (int i = 0; i < rows[n].steps; i++) {
        rows[n].step(&model, t + i * h, x, NULL, h);
        if (e)
          look(x, e);
      }
    }
    printf("%s %d %.1e %.1e %.1e %.1e %.1e\n", rows[n].name, rows[n].steps, first.energy,
           last.energy, first.momentum, last.momentum, last.norm);
    fflush(stdout);
  }
  return 0;
}
