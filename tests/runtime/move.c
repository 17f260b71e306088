/* move.c - translation and the turning frame, against tables, closed forms and an inertial
   observer. SPDX-License-Identifier: GPL-3.0-or-later

   Oracles: forced_top.json (points in rotating frames, 32 digits); falling and rising with
   quadratic drag (tanh and tan, log cosh), linear drag and springs in closed form, in long double;
   the same free body seen from an inertial frame. Tolerances: a run adds steps in long double and
   rounds once, so what is left is the tolerance 1e-18 of each of some hundreds of steps and the
   rounding to double: 1e-15 of the size of r or v. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "polhode.h"
#include "reference/moving.h"
#include "tap.h"

/* A step of the preparation; the test says which line failed. */
#define CHECK(condition) ((condition) ? (void)0 : (void)ok(0, "%s", #condition))
#define COUNT(table)     (sizeof(table) / sizeof(table)[0])

static const double NONE[3] = {0, 0, 0};

static void point(ph_top *top, double mass, const double gravity[3]) {
  static const double tensor[6] = {0, 0, 0, 0, 0, 0};
  CHECK(ph_top_init_tensor(top, mass, NULL, tensor) == PH_OK);
  CHECK(ph_top_translation(top, gravity) == PH_OK);
}

/* The state x (13 numbers) a time t later. */
static int go(const ph_top *top, ph_method method, double step, double t, double x[]) {
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

static double off(int n, const double got[], const long double want[]) {
  long double size = 0, error = 0;
  for (int i = 0; i < n; i++) {
    size = fmaxl(size, fabsl(want[i]));
    error = fmaxl(error, fabsl((long double)got[i] - want[i]));
  }
  return (double)(error / size);
}

/* ---- the table ---- */

static void table_top(const char *id, ph_top *top) {
  static const double down[3] = {0, 0, -9.81};
  double rate[3] = {0, 0, 0}, rate_dot[3] = {0, 0, 0}, k[3] = {0, 0, 0};
  point(top, 1, strcmp(id, "dropped_particle_full") == 0 ? down : NONE);
  if (strcmp(id, "foucault_pendulum_linear") == 0) {
    rate[2] = 5.4905505623459494e-05;
    k[0] = k[1] = 0.1464179104477612;
    CHECK(ph_top_restoring(top, k) == PH_OK);
    CHECK(ph_top_frame(top, rate, rate_dot, 0) == PH_OK);
    return;
  }
  if (strcmp(id, "bead_on_rotating_rod") == 0) { /* along the rod the centrifugal force repels */
    k[0] = -1.25 * 1.25;
    CHECK(ph_top_restoring(top, k) == PH_OK);
    return;
  }
  if (strcmp(id, "dropped_particle_full") == 0) {
    rate[1] = 5.156303965692141e-05;
    rate[2] = 5.1563039656921404e-05;
  } else if (strcmp(id, "free_particle_constant_omega") == 0) {
    rate[0] = 0.3, rate[1] = -0.5, rate[2] = 0.8;
  } else {
    rate[2] = 0.4, rate_dot[2] = 0.1;
  }
  CHECK(ph_top_frame(top, rate, rate_dot, 1) == PH_OK);
}

static void reference(void) {
  static const struct {
    ph_method method;
    const char *name;
    double bound;
  } methods[] = {{PH_TAYLOR, "Taylor", 4e-15}, {PH_RK8PD, "rk8pd", 1e-11}};
  for (size_t m = 0; m < COUNT(methods); m++)
    for (size_t i = 0; i < COUNT(moving_rows); i++) {
      const int n = moving_rows[i].n / 2;
      ph_top top;
      double x[PH_STATES] = {1};
      table_top(moving_rows[i].id, &top);
      memcpy(x + 7, moving_rows[i].x0, (size_t)n * sizeof x[0]);
      memcpy(x + 10, moving_rows[i].x0 + n, (size_t)n * sizeof x[0]);
      CHECK(go(&top, methods[m].method, 0, moving_rows[i].t, x) == PH_OK);
      const double r = off(n, x + 7, moving_rows[i].x), v = off(n, x + 10, moving_rows[i].x + n);
      ok(r <= methods[m].bound && v <= methods[m].bound, "%s at %g s by %s (%.2g, %.2g)",
         moving_rows[i].id, moving_rows[i].t, methods[m].name, r, v);
    }
}

/* ---- drag and springs in closed form ---- */

static void falling(void) {
  static const double g = 9.81, c = 0.02, m = 0.5, down[3] = {0, 0, -9.81};
  const long double vt = sqrtl((long double)m * (long double)g / (long double)c);
  const long double s = (long double)g / vt;
  ph_top top;
  point(&top, m, down);
  CHECK(ph_top_drag(&top, 0, c) == PH_OK);
  for (double t = 0.125; t < 100; t *= 4) { /* from rest: |v| v is no power series in v there */
    double x[PH_STATES] = {1};
    CHECK(go(&top, PH_TAYLOR, 0, t, x) == PH_OK);
    const long double a = s * (long double)t;
    const long double log_cosh = a + log1pl(expl(-2 * a)) - logl(2);
    const long double z[1] = {-vt * vt / (long double)g * log_cosh}, v[1] = {-vt * tanhl(a)};
    ok(off(1, x + 9, z) <= 1e-15 && off(1, x + 12, v) <= 1e-15, "falls %g s with drag (%.2g, %.2g)",
       t, off(1, x + 9, z), off(1, x + 12, v));
  }
  /* up, over the top, and down: v = vt tan(b - s t) until the top, then - vt tanh(s t - b) */
  const double v0 = 40;
  const long double b = atanl((long double)v0 / vt),
                    top_z = -vt * vt / (long double)g * logl(cosl(b));
  for (double t = 0.5; t < 20; t *= 2) {
    double x[PH_STATES] = {1};
    x[12] = v0;
    CHECK(go(&top, PH_TAYLOR, 0, t, x) == PH_OK);
    const long double a = s * (long double)t - b;
    const long double v = a < 0 ? -vt * tanl(a) : -vt * tanhl(a);
    const long double z =
        top_z + vt * vt / (long double)g * (a < 0 ? logl(cosl(a)) : -logl(coshl(a)));
    ok(fabsl((long double)x[12] - v) <= 1e-14L * vt &&
           fabsl((long double)x[9] - z) <= 1e-14L * top_z,
       "thrown up, at %g s with drag (%.2Lg, %.2Lg)", t, (long double)x[12] - v,
       (long double)x[9] - z);
  }
}

static void linear(void) {
  static const double sideways[3] = {3, 0, -9.81}, k[3] = {2, 0, 50};
  ph_top top;
  point(&top, 2, sideways);
  CHECK(ph_top_drag(&top, 0.5, 0) == PH_OK);
  double x[PH_STATES] = {1, 0, 0, 0, 0, 0, 0, 1, 2, 3, 4, 5, 6};
  CHECK(go(&top, PH_TAYLOR, 0, 7, x) == PH_OK);
  for (int i = 0; i < 3;
       i++) { /* v' = a - v/4: v = 4 a + (v0 - 4 a) e, r = r0 + 4 a t + 4 (v0 - 4 a)(1 - e) */
    const long double e = expl(-7.0L / 4), A = 4 * (long double)sideways[i], d = 4.0L + i - A;
    const long double v[1] = {A + d * e}, r[1] = {1 + i + 7 * A + 4 * d * -expm1l(-7.0L / 4)};
    ok(off(1, x + 7 + i, r) <= 1e-15 && off(1, x + 10 + i, v) <= 1e-15, "linear drag, component %d",
       i);
  }
  ph_top_without(&top, PH_DRAG);
  CHECK(ph_top_restoring(&top, k) == PH_OK);
  double y[PH_STATES] = {1, 0, 0, 0, 0, 0, 0, 1, 2, 3, 4, 5, 6};
  CHECK(go(&top, PH_TAYLOR, 0, 7, y) == PH_OK);
  for (int i = 0; i < 3; i++) {
    const long double a = (long double)sideways[i], r0 = 1 + i, v0 = 4 + i, t = 7;
    const long double w = sqrtl((long double)k[i] / 2), C = cosl(w * t), S = sinl(w * t);
    long double r = r0 + v0 * t + a * t * t / 2, v = v0 + a * t;
    if (w > 0) {
      r = a / (w * w) + (r0 - a / (w * w)) * C + v0 / w * S;
      v = v0 * C - (r0 - a / (w * w)) * w * S;
    }
    ok(fabsl((long double)y[7 + i] - r) <= 1e-14L && fabsl((long double)y[10 + i] - v) <= 1e-13L,
       "spring, component %d", i);
  }
}

/* ---- a free body, seen from an inertial and from a turning frame ---- */

static void seen(void) {
  static const double tensor[6] = {2, 3, 4, 0.3, -0.2, 0.1}, Omega[3] = {0.3, -0.5, 0.8};
  const double x0[PH_STATES] = {0.5, -0.5, 0.5, 0.5, 1, 2, -3, 1, 2, 3, -1, 0.5, 2}, t = 9;
  ph_top top;
  CHECK(ph_top_init_tensor(&top, 5, NULL, tensor) == PH_OK);
  CHECK(ph_top_translation(&top, NONE) == PH_OK);
  double inertial[PH_STATES], turning[PH_STATES];
  memcpy(inertial, x0, sizeof x0);
  memcpy(turning, x0, sizeof x0);
  /* at t = 0 the axes coincide: the inertial velocity is v + Omega x r */
  for (int i = 0; i < 3; i++)
    inertial[10 + i] +=
        Omega[(i + 1) % 3] * x0[7 + (i + 2) % 3] - Omega[(i + 2) % 3] * x0[7 + (i + 1) % 3];
  CHECK(go(&top, PH_TAYLOR, 0, t, inertial) == PH_OK);
  CHECK(ph_top_frame(&top, Omega, NONE, 1) == PH_OK);
  double E0 = 0, E = 0;
  CHECK(ph_top_energy(&top, turning, &E0) == PH_OK);
  CHECK(go(&top, PH_TAYLOR, 0, t, turning) == PH_OK);
  CHECK(ph_top_energy(&top, turning, &E) == PH_OK);
  ok(fabs(E - E0) <= 1e-13 * 200, "Jacobi's integral (%.3g of %.3g)", E - E0, E0);
  /* the frame has turned by Omega t: its quaternion p, q_inertial = p q, r_inertial = p r p* */
  const double n = sqrt(0.98);
  const double half = n * t / 2, p[4] = {cos(half), sin(half) / n * Omega[0],
                                         sin(half) / n * Omega[1], sin(half) / n * Omega[2]};
  double q[4], r[3];
  ph_quat_multiply(p, turning, q);
  CHECK(ph_quat_rotate(p, turning + 7, r) == PH_OK);
  double worst = 0;
  const double sign =
      q[0] * inertial[0] + q[1] * inertial[1] + q[2] * inertial[2] + q[3] * inertial[3] < 0 ? -1
                                                                                            : 1;
  for (int i = 0; i < 4; i++)
    worst = fmax(worst, fabs(sign * q[i] - inertial[i]));
  for (int i = 0; i < 3; i++) {
    worst = fmax(worst, fabs(r[i] - inertial[7 + i]) / 30);
    worst = fmax(worst, fabs(turning[4 + i] - inertial[4 + i]));
  }
  ok(worst <= 4e-15, "a free body is the same from a turning frame (%.2g)", worst);
}

/* ---- order of the fixed-step method with time in the frame's rate ---- */

static void order(void) {
  double error[2];
  for (int k = 0; k < 2; k++) {
    ph_top top;
    double x[PH_STATES] = {1, 0, 0, 0, 0, 0, 0, 1, 0.5, 0, 0.1, 0.2, 0};
    table_top("free_particle_euler_force", &top);
    CHECK(go(&top, PH_RK4, k ? 1.0 / 64 : 1.0 / 32, 1, x) == PH_OK);
    error[k] = fabs(x[7] - 1.2888644796397624854);
  }
  ok(error[0] > 1e-10 && error[1] < error[0] / 14, "fourth order (%.3g, %.3g)", error[0], error[1]);
}

static void refusals(void) {
  static const double tensor[6] = {2, 3, 4, 0, 0, 0}, com[3] = {0.1, 0, 0}, wild[3] = {0, NAN, 0};
  ph_top top;
  CHECK(ph_top_init_tensor(&top, 5, com, tensor) == PH_OK);
  ok(ph_top_translation(&top, NONE) == PH_EBOUND, "a moving body turns about its centre of mass");
  CHECK(ph_top_init_tensor(&top, 5, NULL, tensor) == PH_OK);
  ok(ph_top_translation(&top, wild) == PH_EFINITE && ph_top_restoring(&top, wild) == PH_EFINITE &&
         ph_top_frame(&top, wild, NONE, 1) == PH_EFINITE &&
         ph_top_frame(&top, NONE, wild, 1) == PH_EFINITE,
     "NaN is refused");
  ok(ph_top_drag(&top, -1, 0) == PH_EPOSITIVE && ph_top_drag(&top, 0, -1) == PH_EPOSITIVE,
     "drag has a sign");
  ok(top.effects == 0 && ph_top_states(&top) == 7, "what was refused is not switched on");
  CHECK(ph_top_translation(&top, NONE) == PH_OK);
  ok(ph_top_states(&top) == 13, "a body that moves has 13 states");
}

int main(void) {
  reference();
  falling();
  linear();
  seen();
  order();
  refusals();
  return tap_done();
}
