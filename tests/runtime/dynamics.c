/* dynamics.c - the equations of motion with each effect, energy, momentum, rods and special
   motions. SPDX-License-Identifier: GPL-3.0-or-later

   The oracle is dynamics written out here another way: I w' + w x I w - N must vanish term by term
   with N formed from vectors turned by matrices, energy and momentum must change at the rate at
   which torque works, and the textbook's formulas in principal axes must agree with the general
   road. Motion in time is integrate.c's. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "polhode.h"
#include "tap.h"

/* One rounding of the result, one of each of a dozen inputs that the oracle forms in double. */
static const double TOL = 8 * DBL_EPSILON;

/* Numbers in (-1, 1), the same on every machine. */
static double uniform(void) {
  static unsigned long long state = 88172645463325252ull;
  state ^= state << 13, state ^= state >> 7, state ^= state << 17;
  return (double)(state >> 11) * 0x1p-52 - 1;
}

static void uniform_state(double x[7]) {
  double q[4];
  do
    for (int i = 0; i < 4; i++)
      q[i] = uniform();
  while (ph_quat_normalize(q, x));
  for (int i = 4; i < 7; i++)
    x[i] = 3 * uniform();
}

/* A body without any symmetry: a box and two balls, turned, about an origin outside of it. */
static int odd_body(ph_body *b) {
  ph_body ball;
  int s = ph_solid_box(b, ph_amount_mass(2.4), 0.2, 0.1, 0.05);
  s = s || ph_solid_sphere(&ball, ph_amount_mass(0.3), 0.03) ||
      ph_body_at(&ball, &ball, (const double[]){0.1, 0.07, 0.02});
  s = s || ph_body_add(b, b, &ball) ||
      ph_body_at(&ball, &ball, (const double[]){-0.25, 0.01, 0.05});
  return s || ph_body_add(b, b, &ball) ||
         ph_body_turned(b, b, (const double[]){0.9, 0.2, -0.3, 0.1});
}

static const double ORIGIN[3] = {0.05, -0.1, 0.02}, DIRECTION[3] = {1, -2, -5},
                    C[9] = {0.3, 0.1, 0, -0.1, 0.2, 0.05, 0, 0, 0.4};
static const double RATE = 0.7, BODY[3] = {0.1, -0.2, 0.3}, INERTIAL[3] = {-0.2, 0.4, 0.1},
                    U[3] = {0.5, 0.25, -1}, HELD[3] = {0.4, -0.7, 0.2};
static const double G = 9.80665;
static const unsigned ALL = 63 | PH_ROTOR;

static int all_effects(ph_top *top) {
  ph_body b;
  return odd_body(&b) || ph_top_init(top, &b, ORIGIN) || ph_top_gravity(top, G, DIRECTION) ||
         ph_top_damping(top, C) || ph_top_decay(top, RATE) || ph_top_torque_body(top, BODY) ||
         ph_top_torque_inertial(top, INERTIAL) || ph_top_control(top) || ph_top_rotor(top, HELD);
}

static void cross(const double a[3], const double b[3], double out[3]) {
  const double c[3] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                       a[0] * b[1] - a[1] * b[0]};
  memcpy(out, c, sizeof c);
}

static void apply(const double I[6], const double w[3], double L[3]) {
  const double v[3] = {I[0] * w[0] + I[3] * w[1] + I[4] * w[2],
                       I[3] * w[0] + I[1] * w[1] + I[5] * w[2],
                       I[4] * w[0] + I[5] * w[1] + I[2] * w[2]};
  memcpy(L, v, sizeof v);
}

/* Torque in body axes by rotation matrices, and the size of its terms. */
static double torque_by_matrix(const ph_top *top, unsigned effects, const double x[7],
                               double N[3]) {
  double R[9], L[3], weight[3], gyro[3], size = 0;
  ph_quat_to_matrix(x, R);
  apply(top->inertia, x + 4, L);
  const double n = sqrt(30);
  for (int i = 0; i < 3; i++)
    weight[i] = top->mass * G / n *
                (R[i] * DIRECTION[0] + R[3 + i] * DIRECTION[1] + R[6 + i] * DIRECTION[2]);
  cross(top->com, weight, N);
  cross(HELD, x + 4, gyro);
  for (int i = 0; i < 3; i++) {
    const double part[7] = {
        N[i],    -(C[3 * i] * x[4] + C[3 * i + 1] * x[5] + C[3 * i + 2] * x[6]),       -RATE * L[i],
        BODY[i], R[i] * INERTIAL[0] + R[3 + i] * INERTIAL[1] + R[6 + i] * INERTIAL[2], U[i],
        gyro[i]};
    N[i] = 0;
    for (int k = 0; k < 7; k++)
      if (effects & (k < 6 ? 1U << k : PH_ROTOR)) {
        N[i] += part[k];
        size = fmax(size, fabs(part[k]));
        for (int j = 0; j < 9 && k == 6; j++) /* whose products may cancel */
          size = fmax(size, fabs(HELD[j / 3] * x[4 + j % 3]));
      }
  }
  return size;
}

static void effects_one_by_one(void) {
  static const char *const name[9] = {"gravity",     "damping",         "decay",
                                      "body torque", "inertial torque", "control",
                                      "rotor",       "all effects",     "no effect"};
  static const unsigned mask[9] = {
      PH_GRAVITY, PH_DAMPING, PH_DECAY, PH_TORQUE_BODY, PH_TORQUE_INERTIAL, PH_CONTROL,
      PH_ROTOR,   ALL,        0};
  ph_top top;
  if (!ok(all_effects(&top) == 0 && top.effects == ALL, "an odd body with all effects is set up"))
    return;
  for (int k = 0; k < 9; k++) {
    ph_top some = top;
    ph_top_without(&some, ALL & ~mask[k]);
    double worst_torque = 0, worst_balance = 0, worst_attitude = 0;
    for (int n = 0; n < 1000; n++) {
      double x[7], N[3], want[3], dx[7], L[3], turning[3], change[3], inverse[3];
      uniform_state(x);
      const double size = torque_by_matrix(&some, mask[k], x, want);
      int s = ph_top_torque(&some, 0, x, U, N) || ph_top_rates(&some, 0, x, U, dx) ||
              ph_top_inverse(&some, x + 4, dx + 4, inverse);
      apply(top.inertia, x + 4, L);
      cross(x + 4, L, turning);
      apply(top.inertia, dx + 4, change);
      /* I w' and w x I w are sums of entries times rates, each rounded: the size is that of a
       * product */
      double terms = fmax(size, DBL_MIN), fastest = 0;
      for (int i = 0; i < 3; i++)
        fastest = fmax(fastest, fmax(fabs(dx[4 + i]), x[4 + i] * x[4 + i]));
      for (int i = 0; i < 6; i++)
        terms = fmax(terms, fabs(top.inertia[i]) * fastest);
      for (int i = 0; i < 3; i++) {
        worst_torque =
            fmax(worst_torque, s ? HUGE_VAL : fabs(N[i] - want[i]) / fmax(size, DBL_MIN));
        worst_balance = fmax(worst_balance, fabs(change[i] + turning[i] - want[i]) / terms);
        worst_balance = fmax(worst_balance, fabs(inverse[i] - want[i]) / terms);
      }
      const double pure[4] = {0, x[4] / 2, x[5] / 2, x[6] / 2};
      double dq[4];
      ph_quat_multiply(x, pure, dq);
      for (int i = 0; i < 4; i++)
        worst_attitude = fmax(worst_attitude, fabs(dq[i] - dx[i]));
    }
    near(worst_torque, 0, TOL, "%s: torque as by matrices, 1000 states", name[k]);
    near(worst_balance, 0, TOL, "%s: I w' + w x I w = N, both ways", name[k]);
    near(worst_attitude, 0, TOL, "%s: q' = q (0, w)/2", name[k]);
  }
}

static void power(void) {
  /* dE/dt by the chain rule from the rates: w.I.w' + dV/dq.q' = power of all torques but gravity;
   * dL/dt in inertial axes = q N q*. */
  ph_top top;
  double worst_energy = 0, worst_momentum = 0;
  all_effects(&top);
  for (int n = 0; n < 200; n++) {
    double x[7], dx[7], N[3], wN = 0, x1[7], x2[7], E1, E2, L1[3], L2[3], want[3], gravity[3];
    ph_top weight = top;
    uniform_state(x);
    ph_top_without(&weight, ALL & ~(unsigned)PH_GRAVITY);
    ph_top_rates(&top, 0, x, U, dx);
    ph_top_torque(&top, 0, x, U, N);
    ph_top_torque(&weight, 0, x, NULL, gravity);
    for (int i = 0; i < 3; i++)
      wN += x[4 + i] * (N[i] - gravity[i]);
    const double h =
        0x1p-16; /* central difference: error h^2/6 times third derivatives of size 1e4 */
    for (int i = 0; i < 7; i++)
      x1[i] = x[i] - h * dx[i], x2[i] = x[i] + h * dx[i];
    ph_top_energy(&top, x1, &E1), ph_top_energy(&top, x2, &E2);
    ph_top_momentum(&top, x1, L1), ph_top_momentum(&top, x2, L2);
    cross(x + 4, HELD, gravity); /* on the rotor, whose h turns along */
    for (int i = 0; i < 3; i++)
      want[i] = N[i] + gravity[i];
    ph_quat_rotate(x, want, want);
    worst_energy = fmax(worst_energy, fabs((E2 - E1) / (2 * h) - wN));
    for (int i = 0; i < 3; i++)
      worst_momentum = fmax(worst_momentum, fabs((L2[i] - L1[i]) / (2 * h) - want[i]));
  }
  near(worst_energy, 0, 1e-7, "dE/dt is the power of the torques other than gravity");
  near(worst_momentum, 0, 1e-7, "dL/dt in the inertial frame is the torque on body and rotor");
}

static void gravity_by_hand(void) {
  /* a mass of 2 kg at 3 m from the pivot along body z, lying along inertial x, weight down: torque
   * about y is -M g l ... x -> down */
  ph_body b;
  ph_top top;
  double N[3], V, x[7] = {0, 0, 0, 0, 0, 0, 0};
  ph_quat_from_axis((const double[]){0, 1, 0}, 1.5707963267948966, x); /* body z to inertial x */
  ph_solid_sphere(&b, ph_amount_mass(2), 0.5);
  int s = ph_top_init(&top, &b, (const double[]){0, 0, -3}) ||
          ph_top_gravity(&top, 10, (const double[]){0, 0, -8});
  ok(s == 0 && top.com[2] == 3, "a ball of 2 kg hangs 3 m from its pivot");
  ph_top_torque(&top, 0, x, NULL, N);
  near_all(3, N, ((const double[]){0, 60, 0}), 60 * TOL,
           "held level, its weight turns it down with 60 N m");
  ph_top_potential(&top, x, &V);
  near(V, 0, 60 * TOL, "level with the pivot V = 0");
  ph_top_potential(&top, (const double[]){1, 0, 0, 0, 0, 0, 0}, &V);
  near(V, 60, 0, "upright V = M g l");
}

static void rods(void) {
  ph_body b;
  ph_top top;
  double dx[7], x[7] = {1, 0, 0, 0, 0.3, -0.2, 5}, L[3];
  int s = ph_rod_straight(&b, ph_amount_mass(12), 1) || ph_top_init(&top, &b, NULL);
  ok(s == 0, "a rod along z, moments 1, 1, 0, is a top");
  ok(ph_top_rates(&top, 0, x, NULL, dx) == PH_OK, "it moves freely");
  /* w1' = (I2 - I3)/I1 w2 w3 = -1, w2' = (I3 - I1)/I2 w3 w1 = -1.5 */
  near_all(3, dx + 4, ((const double[]){-1, -1.5, 0}), TOL, "w1' = w2 w3, w2' = -w3 w1, w3' = 0");
  ph_top_momentum_body(&top, x, L);
  near_all(3, L, ((const double[]){0.3, -0.2, 0}), TOL,
           "it carries no angular momentum along itself");
  ph_top_control(&top);
  ok(ph_top_rates(&top, 0, x, (const double[]){1, 2, 0}, dx) == PH_OK,
     "torque across it is accepted");
  dx[0] = 77;
  ok(ph_top_rates(&top, 0, x, (const double[]){1, 2, 1e-9}, dx) == PH_EROD && dx[0] == 77,
     "torque along it is refused, and the output untouched");
  /* the same rod askew: its rounded tensor has a third moment of 1e-17, which must not be divided
   * by */
  const double to[3] = {1, 2, 2}, from[3] = {-1, -2, -2};
  s = ph_rod_between(&b, ph_amount_mass(1), from, to) || ph_top_init(&top, &b, NULL) ||
      ph_top_torque_body(&top, (const double[]){2, -1, 0});
  ok(s == 0 && ph_top_rates(&top, 0, x, NULL, dx) == PH_OK, "an oblique rod is a rod");
  double along = (dx[4] + 2 * dx[5] + 2 * dx[6]) / 3, across = hypot(hypot(dx[4], dx[5]), dx[6]);
  near(along, 0, TOL * across, "and keeps its rate along itself");
  ok(across < 100, "and is not thrown about by a moment made of rounding");
  s = ph_top_torque_body(&top, to);
  ok(s == 0 && ph_top_rates(&top, 0, x, NULL, dx) == PH_EROD, "torque along it is refused");
  /* gravity about its own end: the torque is across the rod whatever the rounding */
  s = ph_top_init(&top, &b, from) || ph_top_gravity(&top, 9.81, (const double[]){0.1, 0.2, -3});
  int refused = 0;
  for (int n = 0; n < 1000; n++) {
    uniform_state(x);
    refused += ph_top_rates(&top, 0, x, NULL, dx) != PH_OK;
  }
  ok(s == 0 && refused == 0, "a rod hung by its end swings in 1000 attitudes");
  /* exactly known thin moments are moments */
  s = ph_top_init_tensor(&top, 1, NULL, (const double[]){1, 1, 1e-30, 0, 0, 0}) ||
      ph_top_torque_body(&top, (const double[]){0, 0, 1e-30});
  ok(s == 0 && ph_top_rates(&top, 0, x, NULL, dx) == PH_OK,
     "a moment of 1e-30 beside 1 is a moment");
  near(dx[6], 1, TOL, "and is accelerated by a torque of 1e-30");
  /* a single particle about itself has no moment at all */
  s = ph_body_points(&b, 1, (const double[]){1}, (const double[]){4, 5, 6}) ||
      ph_top_init(&top, &b, NULL);
  ok(s == 0 && ph_top_rates(&top, 0, x, NULL, dx) == PH_OK && dx[4] == 0 && dx[5] == 0 &&
         dx[6] == 0,
     "a particle about itself keeps any w");
}

static void scales(void) {
  /* moments * 2^100, rates * 2^-70: rates of change scale by 2^-140, bit by bit */
  const double k = 0x1p100, r = 0x1p-70, I[6] = {3, 2, 2.5, 0.5, -0.25, 0.125};
  double big[6], x[7], y[7], dx[7], dy[7];
  ph_top a, b;
  for (int i = 0; i < 6; i++)
    big[i] = k * I[i];
  int s = ph_top_init_tensor(&a, 1, NULL, I) || ph_top_init_tensor(&b, k, NULL, big);
  uniform_state(x);
  for (int i = 0; i < 7; i++)
    y[i] = i < 4 ? x[i] : r * x[i];
  s = s || ph_top_rates(&a, 0, x, NULL, dx) || ph_top_rates(&b, 0, y, NULL, dy);
  ok(s == 0 && dy[4] == r * r * dx[4] && dy[5] == r * r * dx[5] && dy[6] == r * r * dx[6],
     "units of 2^100 in moments and 2^-70 in rates change no digit");
}

int main(void) {
  effects_one_by_one();
  power();
  gravity_by_hand();
  rods();
  scales();
  return tap_done();
}
