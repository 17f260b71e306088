/* bits.c - runs what an emitted scene has and prints a hash of the bits of each function's results.
   SPDX-License-Identifier: GPL-3.0-or-later

   SCENE: its name, UPPER the same in capitals, SCENE_H its header's, H a step in s, FIRST the
   method of SCENE_step; HAS_function for each function of the header (bits.lua reads it). One line
   an item: its name and FNV-1a of 64 bits over the numbers in their order, each from its highest
   byte to its lowest, whatever the machine's own order is (hash.h). Only integers are printed. A
   build that evaluates in another precision than the type's says so and compares nothing (status
   3). */
#include "hash.h"
#include <float.h>

enum { STEPS = 100, TIMES = 17 };

static volatile real one = 1, step = (real)H; /* nothing is known when compiling */
static FN(model) model;
static real x0[NX], x[NX], u[NU + 1];

/* every state of a run */
static void run(void (*advance)(const FN(model) *, real, real[], const real[], real),
                const char *name) {
  const real h = step;
  memcpy(x, x0, sizeof x);
  for (int i = 0; i < STEPS; i++) {
    advance(&model, (real)i * h, x, u, h);
    numbers(x, NX);
  }
  item(name);
}

static void quantities(void) {
  real out[9];
#if HAS_mass
  number(FN(mass)(&model, out));
  numbers(out, 3);
  item("mass");
#endif
#if HAS_inertia
  FN(inertia)(&model, out);
  numbers(out, 6);
  item("inertia");
#endif
#if HAS_inertia_at
  FN(inertia_at)(&model, x0, out);
  numbers(out, 6);
  item("inertia_at");
#endif
#if HAS_energy
  number(FN(energy)(&model, x0));
  number(FN(energy)(&model, x));
  item("energy");
#endif
#if HAS_jacobi_integral
  number(FN(jacobi_integral)(&model, step, x));
  item("jacobi_integral");
#endif
#if HAS_momentum
  FN(momentum)(&model, x, out);
  numbers(out, 3);
  item("momentum");
#endif
#if HAS_momentum_body
  FN(momentum_body)(&model, x, out);
  numbers(out, 3);
  item("momentum_body");
#endif
#if HAS_torque
  FN(torque)(&model, x, x0, out);
  numbers(out, 3);
  item("torque");
#endif
}

static void equations(void) {
  static real J[NX * NX];
  FN(rhs)(&model, step, x, u, J);
  numbers(J, NX);
  item("rhs");
  FN(jacobian)(&model, step, x, u, J);
  numbers(J, NX * NX);
  item("jacobian");
#if HAS_acceleration
  FN(acceleration)(x, x0, x + 1, x0 + 1, x + 2, J, J + 3, J + 6, J + 9);
  FN(rate)(x, x0, x + 1, J + 12);
  numbers(J, 15);
  item("acceleration");
#endif
#if HAS_step_transition
  memcpy(x, x0, sizeof x);
  FN(step_transition)(&model, step, x, u, step, J);
  numbers(x, NX);
  numbers(J, NX * NX);
  item("step_transition");
#endif
}

#if HAS_principal
static void principal(void) {
  real moments[3], axes[9], w[3], pair[2], r;
  whole(FN(principal)(&model, moments, axes));
  numbers(moments, 3);
  numbers(axes, 9);
  item("principal");
  {
    const real I[6] = {4 * one, 5 * one, 6 * one, one / 3, -one / 7, one / 5};
    whole(FN(principal_of)(I, moments, axes));
  }
  numbers(moments, 3);
  numbers(axes, 9);
  item("principal_of");
  for (int k = 0; k < 3; k++) {
    whole(FN(stability)(moments, k, one, pair, &r));
    numbers(pair, 2);
    number(r);
  }
  item("stability");
  for (int k = 0; k < 3; k++) {
    const real e[3] = {one, one / 10, one / 9};
    FN(linearised)(moments, k, e, one, w);
    numbers(w, 3);
  }
  item("linearised");
  for (int k = 0; k < 6; k++)
    whole(FN(spin_stable)(&model, k / 2, k % 2));
  item("spin_stable");
}
#endif

#if HAS_at_tick
static void ticks(const FN(orbit) * o, const char *name) {
  static const int64_t n[5] = {0, 1, -77777, 1000000, INT64_C(123456789012345)};
  for (int i = 0; i < 5; i++) {
    FN(at_tick)(o, n[i], x);
    numbers(x, NX);
  }
  item(name);
}
#endif

#if HAS_solve
static FN(orbit) orbit;

static void closed(void) {
  static real t[TIMES], many[TIMES * NX];
  whole(FN(solve)(&orbit, &model, x0));
  item("solve");
  for (int i = 0; i < TIMES; i++)
    t[i] = ((real)(i * i * i) - 5) * step * 31;
  for (int i = 0; i < TIMES; i++) {
    FN(at)(&orbit, t[i], x);
    numbers(x, NX);
  }
  item("at");
#if HAS_at_rates
  for (int i = 0; i < TIMES; i++) {
    FN(at_rates)(&orbit, t[i], x);
    numbers(x, 3);
  }
  item("at_rates");
#endif
#if HAS_at_attitude
  for (int i = 0; i < TIMES; i++) {
    FN(at_attitude)(&orbit, t[i], x);
    numbers(x, 4);
  }
  item("at_attitude");
#endif
#if HAS_at_many
  FN(at_many)(&orbit, TIMES, t, many);
  numbers(many, TIMES * NX);
  item("at_many");
#endif
#if HAS_at_tick
  whole(FN(set_tick)(&orbit, step));
  ticks(&orbit, "at_tick");
#endif
#if HAS_polhode_period
  number(FN(polhode_period)(&orbit));
#endif
#if HAS_precession_rate
  number(FN(precession_rate)(&orbit));
#endif
#if HAS_precession_period
  number(FN(precession_period)(&orbit));
#endif
#if HAS_rotation_number
  number(FN(rotation_number)(&orbit));
#endif
#if HAS_next_flip
  number(FN(next_flip)(&orbit, one));
#endif
#if HAS_nutation_period
  number(FN(nutation_period)(&orbit));
#endif
#if HAS_nutation_range
  FN(nutation_range)(&orbit, x);
  numbers(x, 2);
#endif
  item("queries");
}
#endif

int main(void) {
#if defined FLT_EVAL_METHOD && FLT_EVAL_METHOD
  printf("evaluation method %d: not compared\n", (int)FLT_EVAL_METHOD);
  return 3;
#endif
  start();
  whole(FN(init)(&model, (void *)0));
  FN(initial)(&model, x0);
  numbers(x0, NX);
  item("initial");
  for (int i = 0; i < NU; i++)
    u[i] = one / (real)(i + 3);
  run(FN(step), FIRST "_step");
#if HAS_rk4_step
  run(FN(rk4_step), "rk4_step");
#endif
#if HAS_adaptive_step
  run(FN(adaptive_step), "adaptive_step");
#endif
#if HAS_taylor_step
  run(FN(taylor_step), "taylor_step");
#endif
#if HAS_midpoint_step
  run(FN(midpoint_step), "midpoint_step");
#endif
#if HAS_semi_step
  run(FN(semi_step), "semi_step");
#endif
#if HAS_split2_step
  run(FN(split2_step), "split2_step");
#endif
#if HAS_split4_step
  run(FN(split4_step), "split4_step");
#endif
#if HAS_adaptive_run
  memcpy(x, x0, sizeof x);
  whole(FN(adaptive_run)(&model, 0, x, u, 20 * step, one / 10000, 1000));
  numbers(x, NX);
  item("adaptive_run");
#endif
#if HAS_taylor_run
  memcpy(x, x0, sizeof x);
  whole(FN(taylor_run)(&model, 0, x, u, 20 * step, one / 10000, 1000));
  numbers(x, NX);
  item("taylor_run");
#endif
  for (int i = 0; i < NX; i++) /* a state of no meaning, the same whatever the steppers do */
    x[i] = x0[i] * (one + one / 16) + (real)(i + 1) / 32;
  quantities();
  equations();
#if HAS_principal
  principal();
#endif
#if HAS_own_orbit
  ticks(&FN(own_orbit), "own_orbit");
#endif
#if HAS_solve
  closed();
#endif
  return 0;
}
