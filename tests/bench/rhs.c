/* rhs.c - what one right-hand side costs: emitted, and by the general library.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The scene has one effect; the library has every switch and all but that one off. The same states
 * in turn, in one run; the least of REPEATS rounds each. The library evaluates in long double,
 * which is part of its price. The rates are compared too.
 */
#include "clock.h"
#include "heavy_top.h"
#include "polhode.h"

#include <math.h>
#include <stdio.h>

enum { REPEATS = 41, CALLS = 20000, STATES = 64 };

int main(void) {
  heavy_top_model m;
  ph_top top;
  double com[3], I[6], x[STATES][7], dx[7], other[7], least[2] = {HUGE_VAL, HUGE_VAL}, worst = 0;
  const double down[3] = {0, 0, -1}, one[3] = {1, 2, 3};
  const double C[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1}, u[3] = {0, 0, 0};
  volatile double sink = 0;

  if (heavy_top_init(&m, NULL) != 0)
    return 1;
  const double mass = heavy_top_mass(&m, com);
  heavy_top_inertia(&m, I);
  if (ph_top_init_tensor(&top, mass, com, I) != 0 || ph_top_gravity(&top, 9.80665, down) != 0 ||
      ph_top_damping(&top, C) != 0 || ph_top_decay(&top, 1) != 0 || ph_top_rotor(&top, one) != 0 ||
      ph_top_torque_body(&top, one) != 0 || ph_top_torque_inertial(&top, one) != 0 ||
      ph_top_control(&top) != 0)
    return 1;
  ph_top_without(&top, ~(unsigned)PH_GRAVITY);
  for (int k = 0; k < STATES; k++) {
    double n = 0;
    heavy_top_initial(&m, x[k]);
    for (int i = 0; i < 7; i++)
      x[k][i] += 0.3 * sin(1.7 * k + 2.3 * i);
    for (int i = 0; i < 4; i++)
      n += x[k][i] * x[k][i];
    for (int i = 0; i < 4; i++)
      x[k][i] /= sqrt(n);
  }
  for (int k = 0; k < REPEATS; k++) {
    double start = now();
    for (int i = 0; i < CALLS; i++) {
      heavy_top_rhs(&m, 0, x[i % STATES], NULL, dx);
      sink += dx[4];
    }
    least[0] = fmin(least[0], (now() - start) / CALLS * 1e9);
    start = now();
    for (int i = 0; i < CALLS; i++) {
      if (ph_top_rates(&top, 0, x[i % STATES], u, other) != 0)
        return 1;
      sink += other[4];
    }
    least[1] = fmin(least[1], (now() - start) / CALLS * 1e9);
  }
  for (int k = 0; k < STATES; k++) {
    heavy_top_rhs(&m, 0, x[k], NULL, dx);
    if (ph_top_rates(&top, 0, x[k], u, other) != 0)
      return 1;
    for (int i = 0; i < 7; i++)
      worst = fmax(worst, fabs(dx[i] - other[i]) / (1 + fabs(dx[i])));
  }
  printf("one right-hand side of the heavy top, least of %d rounds of %d\n", (int)REPEATS,
         (int)CALLS);
  printf("  %-52s %8.1f ns\n", "emitted for the scene", least[0]);
  printf("  %-52s %8.1f ns\n", "general library, all other switches off", least[1]);
  printf("  ratio %.1f (at least 5 wanted); largest difference %.2g\n", least[1] / least[0], worst);
  return 0;
}
