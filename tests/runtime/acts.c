/* acts.c - the effects of polhode_acts.h against closed forms.
   SPDX-License-Identifier: GPL-3.0-or-later

   Motion about one axis can be integrated by hand, with I w' = N:
     drag       w = w0/(1 + c w0 t/I)
     friction   F(w) = F(w0) - T t/I,  F(w) = sqrt(w^2 + s^2) - s asinh(s/w)
     spring     a mathematical pendulum of rate sqrt(k/I); so does a magnet in a field, with m B for
   k. Its period is 2 pi/(rate agm(1, cos(amplitude/2))) (Gauss; DLMF 19.8.5, 22.19.4) field that
   turns: a magnet along it, turning with it, stays so table      w is the integral of straight
   lines wheel      (I - J) w' = -u, W' = u/J - w' Tolerances: states are rounded to double once,
   2^-53; a run adds some hundreds of steps with 1e-18 each.  1e-15 of the size is a few units of
   the first. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "polhode.h"
#include "tap.h"

#define CHECK(condition) ((condition) ? (void)0 : (void)ok(0, "%s", #condition))

static const double PI_2 = 1.57079632679489661923;

static const ph_varying OFF; /* 0 */

static ph_varying varying(double value, int rows, const double table[],
                          long double (*f)(void *, long double, const long double[]),
                          void *context) {
  const ph_varying v = {.value = value, .rows = rows, .table = table, .f = f, .context = context};
  return v;
}

static ph_top body(double xx, double yy, double zz) {
  const double tensor[6] = {xx, yy, zz, 0, 0, 0};
  ph_top top;
  CHECK(ph_top_init_tensor(&top, 1, NULL, tensor) == PH_OK);
  return top;
}

/* The state a time t later; x: as long as the top's state. */
static int go_by(const ph_top *top, ph_method method, double step, double t, double x[]) {
  ph_options options = ph_options_default();
  ph_run *run = NULL;
  options.method = method;
  options.step = step;
  if (method == PH_RK8PD)
    options.tolerance = 1e-15;
  int status = ph_run_new(&run, top, &options, 0, x);
  if (status == PH_OK)
    status = ph_run_to(run, t, NULL, x);
  ph_run_free(run);
  return status;
}

static int go(const ph_top *top, double t, double x[]) {
  return go_by(top, PH_TAYLOR, 0, t, x);
}

static double off(double got, long double want) {
  return fabs((double)(((long double)got - want) / want));
}

static long double agm(long double a, long double b) {
  while (fabsl(a - b) > 4 * LDBL_EPSILON * a) {
    const long double mean = (a + b) / 2;
    b = sqrtl(a * b);
    a = mean;
  }
  return a;
}

/* ---- against the rates ---- */

static void drag_and_friction(void) {
  const double I = 0.7, c = 0.3, T = 0.2, s = 0.05;
  ph_top top = body(1.1, 1.3, I);
  double x[7] = {1, 0, 0, 0, 0, 0, 5};
  CHECK(ph_top_quadratic(&top, c) == PH_OK);
  ok(go(&top, 40, x) == PH_OK, "a long run with drag");
  near(off(x[6], 5 / (1 + (long double)c * 5 * 40 / (long double)I)), 0, 1e-15,
       "drag about an axis");
  double rest[7] = {1, 0, 0, 0, 0, 0, 0}, dx[7];
  ok(ph_top_rates(&top, 0, rest, NULL, dx) == PH_OK && dx[6] == 0 && go(&top, 1, rest) == PH_OK,
     "drag at rest is zero");
  ph_top_without(&top, PH_QUADRATIC);
  x[6] = 5;
  ok(go(&top, 1, x) == PH_OK && x[6] == 5, "switched off, the spin stays");

  top = body(1.1, 1.3, I);
  CHECK(ph_top_friction(&top, T, s) == PH_OK);
  double y[7] = {1, 0, 0, 0, 0, 0, 2};
  CHECK(go(&top, 6.9, y) == PH_OK);
  const long double w = (long double)y[6], S = (long double)s;
  const long double F = sqrtl(w * w + S * S) - S * asinhl(S / w);
  const long double F0 =
      sqrtl(4 + S * S) - S * asinhl(S / 2) - (long double)T * 6.9L / (long double)I;
  ok(y[6] > s && y[6] < 4 * s, "friction has brought it near the smoothing rate");
  near((double)(F - F0), 0, 1e-15,
       "friction about an axis, sqrt(w^2 + s^2) - s asinh(s/w) falls evenly");
}

/* ---- pendulums ---- */

static void swings(ph_top *top, double rate, double amplitude, const char *what) {
  double x[7] = {cos(amplitude / 2), 0, 0, sin(amplitude / 2), 0, 0, 0}, start[7];
  memcpy(start, x, sizeof x);
  const long double mean = agm(1, cosl((long double)amplitude / 2));
  const double quarter = (double)((long double)PI_2 / ((long double)rate * mean));
  double E0, E, size = 0;
  CHECK(ph_top_energy(top, x, &E0) == PH_OK);
  CHECK(go(top, quarter, x) == PH_OK);
  CHECK(ph_top_energy(top, x, &E) == PH_OK);
  /* at the bottom the angle moves at 2 rate sin(amplitude/2); the time is good to 2^-53 of itself
   */
  const double fast = 2 * rate * sin(amplitude / 2);
  near(x[3] / (fast * quarter), 0, 4 * DBL_EPSILON, "%s: a quarter of the period down", what);
  near(off(x[6], -(long double)fast), 0, 4 * DBL_EPSILON, "%s: the rate there", what);
  near((E - E0) / (rate * rate), 0, 8 * DBL_EPSILON, "%s: the energy", what);
  for (int k = 0; k < 3; k++)
    CHECK(go(top, quarter, x) == PH_OK);
  for (int i = 0; i < 7; i++)
    size = fmax(size, fabs(x[i] - start[i]) / (i < 4 ? 1 : rate));
  /* what four roundings of the time leave grows on the way past the top, where it is slowest */
  near(size, 0, 32 * DBL_EPSILON / cos(amplitude / 2),
       "%s: back after the whole, the time in four parts", what);
}

static void pendulums(void) {
  static const double axis[3] = {0, 0, 2}, rest[4] = {3, 0, 0, 0}, k3[3] = {0.5, 0.25, 2};
  static const double moment[3] = {0.4, 0, 0}, field[3] = {5, 0, 0};
  for (int n = 0; n < 3; n++) {
    const double amplitude = n == 0 ? 0.01 : n == 1 ? 1.5 : 3.1;
    ph_top top = body(1, 1, 0.5);
    CHECK(ph_top_spring_axis(&top, 2, axis, rest) == PH_OK);
    swings(&top, 2, amplitude, "spring about an axis");
    top = body(1, 1, 0.5);
    CHECK(ph_top_spring(&top, k3, rest) == PH_OK);
    swings(&top, 2, amplitude, "three springs");
    top = body(1, 1, 0.5);
    CHECK(ph_top_magnetic(&top, moment, field, 0, 0) == PH_OK);
    swings(&top, 2, amplitude, "magnet");
  }
}

/* The torque is minus the slope of the potential along small turns of the body, for any attitude.
 */
static void gradients(void) {
  static const double rest[4] = {0.3, -0.5, 0.7, 0.2}, k3[3] = {0.5, 1.25, 2},
                      axis[3] = {1, -2, 0.5};
  static const double moment[3] = {0.4, -0.3, 1.1}, field[3] = {0.5, 2, -1};
  for (int n = 0; n < 3; n++) {
    ph_top top = body(1, 1, 0.5);
    CHECK((n == 0   ? ph_top_spring(&top, k3, rest)
           : n == 1 ? ph_top_spring_axis(&top, 1.5, axis, rest)
                    : ph_top_magnetic(&top, moment, field, 0, 0)) == PH_OK);
    double x[7] = {0.5, 0.5, -0.5, 0.5, 0, 0, 0}, N[3], worst = 0;
    CHECK(ph_top_torque(&top, 0, x, NULL, N) == PH_OK);
    for (int i = 0; i < 3; i++) {
      const double e = 1e-4; /* central difference: error e^2/6 of V''' < 8 k, and 1e-16/e */
      double V[2];
      for (int side = 0; side < 2; side++) {
        const double unit[3] = {i == 0, i == 1, i == 2};
        double turn[4], y[7] = {0};
        CHECK(ph_quat_from_axis(unit, side ? e : -e, turn) == PH_OK);
        ph_quat_multiply(x, turn, y);
        CHECK(ph_top_potential(&top, y, &V[side]) == PH_OK);
      }
      worst = fmax(worst, fabs((V[1] - V[0]) / (2 * e) + N[i]));
    }
    near(worst, 0, 4e-8, "torque %d is the slope of the potential", n);
  }
}

/* ---- time ---- */

static void times(void) {
  static const double moment[3] = {0.4, 0, 0}, field[3] = {5, 0, 0};
  ph_top top = body(1, 1, 0.5);
  double x[7] = {1, 0, 0, 0, 0, 0, 3};
  CHECK(ph_top_magnetic(&top, moment, field, 1, 3) == PH_OK);
  CHECK(go(&top, 2, x) == PH_OK);
  near(fabs(x[0] - cos(3)) + fabs(x[3] - sin(3)) + fabs(x[6] - 3), 0, 4 * DBL_EPSILON,
       "a magnet turns with its field");

  /* 0 until 1, up to 2 N m at 1.5, flat until 3, down to -1 at 4: areas 0.5, 3, 0.5, and -1 each
     second from then on */
  static const double table[] = {1, 0, 1.5, 2, 3, 2, 4, -1};
  static const struct {
    double t, area;
  } at[] = {{0.5, 0}, {1, 0}, {1.25, 0.125}, {1.5, 0.5}, {2, 1.5}, {3, 3.5}, {4, 4}, {6, 2}};
  const ph_varying N[3] = {OFF, OFF, varying(0, 4, table, NULL, NULL)};
  for (int inertial = 0; inertial < 2; inertial++)
    for (size_t k = 0; k < sizeof at / sizeof at[0]; k++)
      for (int method = 0; method < 3;
           method += 1 + inertial) { /* rk4 is exact about a fixed axis */
        double y[7] = {1, 0, 0, 0, 0, 0, 0};
        top = body(1, 1, 0.5);
        CHECK(ph_top_varying(&top, inertial, N) == PH_OK);
        CHECK(go_by(&top,
                    method == 0   ? PH_TAYLOR
                    : method == 1 ? PH_RK4
                                  : PH_RK8PD,
                    method == 1 ? 1.0 / 64 : 0, at[k].t, y) == PH_OK);
        /* GSL steps over the corners to its tolerance of 1e-15 a step, rk4's steps end at them */
        near(y[6] - at[k].area / 0.5, 0, method == 2 ? 1e-12 : 1e-15 * 8,
             "table to %g s, method %d", at[k].t, method);
      }
}

/* ---- wheels ---- */

static void wheels(void) {
  const double I = 2.5, J = 0.25, u = 0.1;
  for (int included = 0; included < 2; included++) {
    const double axis[3] = {0, 0, 3};
    ph_top top = body(1, 2, included ? I : I - J);
    const ph_varying motor = varying(u, 0, NULL, NULL, NULL);
    CHECK(ph_top_wheel(&top, axis, J, motor, included) == PH_OK);
    ok(ph_top_states(&top) == 8, "a wheel adds a state");
    double x[8] = {1, 0, 0, 0, 0, 0, 0, 0}, L[3], E;
    CHECK(go(&top, 10, x) == PH_OK);
    near(off(x[6], -u * 10 / (long double)(I - J)), 0, 8 * DBL_EPSILON, "the body is pushed back");
    near(off(x[7], u * 10 / (long double)J + u * 10 / (long double)(I - J)), 0, 8 * DBL_EPSILON,
         "the wheel's relative speed");
    CHECK(ph_top_momentum(&top, x, L) == PH_OK && ph_top_energy(&top, x, &E) == PH_OK);
    near(fabs(L[2]) / (u * 10), 0, 8 * DBL_EPSILON, "the angular momentum stays 0");
    /* each side has its share of L = u t: E = L^2/2 (1/(I - J) + 1/J) */
    near(off(E, (1 / (long double)(I - J) + 1 / (long double)J) / 2), 0, 16 * DBL_EPSILON,
         "the energy");
  }
  /* Without a torque, slanted wheels in a tumbling body: L in inertial axes and the energy stay. */
  ph_top top = body(1, 2, 2.5);
  const double a[3] = {1, 0, 1}, b[3] = {0.2, -1, 0.4};
  const ph_varying free_wheel = {0};
  CHECK(ph_top_wheel(&top, a, 0.1, free_wheel, 1) == PH_OK);
  CHECK(ph_top_wheel(&top, b, 0.3, free_wheel, 0) == PH_OK);
  double x[9] = {0.5, 0.5, 0.5, 0.5, 0.7, -0.3, 0.9, 6, -11}, L0[3], L1[3], E0, E1, worst = 0;
  CHECK(ph_top_momentum(&top, x, L0) == PH_OK && ph_top_energy(&top, x, &E0) == PH_OK);
  CHECK(go(&top, 30, x) == PH_OK);
  CHECK(ph_top_momentum(&top, x, L1) == PH_OK && ph_top_energy(&top, x, &E1) == PH_OK);
  for (int i = 0; i < 3; i++)
    worst = fmax(worst, fabs(L1[i] - L0[i]));
  near(worst / 4, 0, 16 * DBL_EPSILON, "two free wheels keep L");
  near(E1 / E0 - 1, 0, 16 * DBL_EPSILON, "and the energy");
  ph_top_without(&top, PH_WHEEL);
  ok(ph_top_states(&top) == 7, "switched off, their states are gone");
  /* A wheel along the axis of a symmetric body: its rate is a sum that vanishes but for rounding.
   */
  ph_top even = body(0.3, 0.3, 0.1);
  const double z[3] = {0, 0, 1};
  double rest[8] = {1, 0, 0, 0, 1, 0.3, 2, 0};
  CHECK(ph_top_wheel(&even, z, 0.01, free_wheel, 1) == PH_OK);
  CHECK(go(&even, 10, rest) == PH_OK);
  near(rest[6] - 2, 0, 8 * DBL_EPSILON, "a wheel at rest stays beside the body: w3");
  near(rest[7], 0, 8 * DBL_EPSILON, "and its speed");
}

/* ---- the user's own ---- */

static long double own_rate(void *context, long double t, const long double x[]) {
  (void)t;
  return *(const double *)context * (long double)x[7]; /* grows */
}

static long double own_torque(void *context, long double t, const long double x[]) {
  (void)context, (void)x;
  return 3 * t * t;
}

static void custom(void) {
  double growth = 0.5, x[8] = {1, 0, 0, 0, 0, 0, 0, 2};
  ph_top top = body(1, 2, 2.5);
  const ph_varying N[3] = {OFF, varying(0, 0, NULL, own_torque, NULL), OFF},
                   rate = varying(0, 0, NULL, own_rate, &growth);
  CHECK(ph_top_custom(&top, N, NULL, NULL, 1, &rate) == PH_OK);
  CHECK(go(&top, 2, x) == PH_OK);
  near(off(x[5], 4), 0, 4 * DBL_EPSILON, "a torque of one's own");
  near(off(x[7], 2 * expl(1)), 0, 4 * DBL_EPSILON, "a state of one's own");
}

static void refusals(void) {
  static const double zero[4] = {0, 0, 0, 0}, z[3] = {0, 0, 1}, falling[4] = {1, 0, 1, 2};
  ph_top top = body(1, 2, 2.5);
  const ph_varying none = {0}, bad[3] = {OFF, OFF, varying(0, 2, falling, NULL, NULL)};
  ok(ph_top_quadratic(&top, -1) == PH_EBOUND, "negative drag");
  ok(ph_top_friction(&top, 1, 0) == PH_EBOUND, "friction that is not smooth");
  ok(ph_top_quadratic(&top, NAN) == PH_EFINITE, "drag that is no number");
  ok(ph_top_spring(&top, z, zero) == PH_EQUATERNION, "a rest attitude of 0");
  ok(ph_top_spring_axis(&top, 1, zero, falling) == PH_EDIRECTION, "an axis of 0");
  ok(ph_top_varying(&top, 0, bad) == PH_ECOUNT, "times that do not ascend");
  ok(ph_top_wheel(&top, z, 2.5, none, 1) == PH_EPOSITIVE, "a wheel with all of the body's moment");
  ok(ph_top_wheel(&top, z, 0, none, 1) == PH_EPOSITIVE, "a wheel without a moment");
  ok(top.acts.n == 0 && top.effects == 0, "none of them was added");
  int status = PH_OK, n = 0;
  while (status == PH_OK && n < 100)
    status = ph_top_quadratic(&top, 0.1), n++;
  ok(status == PH_ECOUNT && n == PH_ACTS + 1, "no more acts than there is room for");
  ph_top rod = body(1, 1, 0);
  ok(ph_top_wheel(&rod, z, 1, none, 0) == PH_EROD, "a wheel in a rod");
}

int main(void) {
  drag_and_friction();
  pendulums();
  gradients();
  times();
  wheels();
  custom();
  refusals();
  return tap_done();
}
