/* acts_space.c - gravity gradient, sunlight, moving support, moving parts, energy sink against
   closed forms. SPDX-License-Identifier: GPL-3.0-or-later

   gravity gradient  a body along the vertical that turns with a circular orbit stays so; pitch from
   the vertical at the rate n is a pendulum of rate n sqrt(3 (I2 - I1)/I3) in twice its angle:
   a'' = -(3/2) n^2 (I2 - I1)/I3 sin 2a, so (a'^2 - c cos 2a) is constant, c = 3/2 n^2 (I2 - I1)/I3
   anomaly           the time of the eccentric anomaly E is E - e sin E (Kepler), a = mu = 1
   sunlight          forces by hand on a plate in the light, on its edge and in the dark
   support           in free fall (a = g) nothing acts
   moving parts      about a principal axis w = L/(I + D(t))
   energy sink       of a symmetric body: with s = cos of the angle between L and the axis,
   s' = k L^2 (1/I1 - 1/I3) s (1 - s^2), so ln(s/sqrt(1 - s^2)) grows linearly
   Tolerances: states are rounded to double once, 2^-53, and runs add 1e-18 in each of some hundred
   steps; 1e-14 leaves room for the roundings of the expected values themselves. */
#include <math.h>
#include <string.h>

#include "polhode.h"
#include "tap.h"

#define CHECK(condition) ((condition) ? (void)0 : (void)ok(0, "%s", #condition))

#define OFF                                                                                        \
  { .value = 0 }

static ph_top body(double xx, double yy, double zz) {
  const double tensor[6] = {xx, yy, zz, 0, 0, 0};
  ph_top top;
  CHECK(ph_top_init_tensor(&top, 1, NULL, tensor) == PH_OK);
  return top;
}

static void claim(int condition, const char *what) {
  ok(condition, "%s", what);
}

static int go(const ph_top *top, double t, double x[]) {
  ph_options options = ph_options_default();
  ph_run *run = NULL;
  int status = ph_run_new(&run, top, &options, 0, x);
  if (status == PH_OK)
    status = ph_run_to(run, t, NULL, x);
  ph_run_free(run);
  return status;
}

static int within(double got, double want, double tolerance) {
  return fabs(got - want) <= tolerance; /* false for NaN */
}

static void gradient(void) {
  ph_top top = body(1, 2.5, 3);
  CHECK(ph_top_gravity_gradient(&top, 8, 2) == PH_OK); /* n = 1 */
  double x[7] = {1, 0, 0, 0, 0, 0, 1};
  CHECK(go(&top, 10, x) == PH_OK);
  claim(within(x[0], cos(5), 1e-14) && within(x[3], sin(5), 1e-14) && within(x[6], 1, 1e-14),
        "gravity gradient: along the vertical it stays");
  double y[7] = {cos(0.2), 0, 0, sin(0.2), 0, 0, 1}; /* 0.4 rad off the vertical */
  CHECK(go(&top, 3, y) == PH_OK);
  const double c = 1.5 * 1.5 / 3, a = 2 * atan2(y[3], y[0]) - 3, rate = y[6] - 1;
  claim(within(rate * rate - c * cos(2 * a), -c * cos(0.8), 1e-14) && fabs(a) < 0.4,
        "gravity gradient: pitch is a pendulum in twice the angle");
  claim(ph_top_gravity_gradient(&top, -1, 2) == PH_EBOUND &&
            ph_top_gravity_gradient(&top, 1, 0) == PH_EBOUND &&
            ph_top_gravity_gradient_orbit(&top, 1, 1, 1) == PH_EBOUND &&
            ph_top_gravity_gradient(&top, NAN, 1) == PH_EFINITE,
        "gravity gradient: what no orbit has is refused");
}

static void anomaly(void) {
  static const double E[4] = {0.5, 1.5, 3, 6};
  for (int i = 0; i < 4; i++) {
    const double e = 0.7;
    ph_top top = body(1, 2.5, 3);
    CHECK(ph_top_gravity_gradient_orbit(&top, 1, 1, e) == PH_OK);
    double x[8] = {1, 0, 0, 0, 0.1, 0, 1, 0};
    CHECK(ph_top_states(&top) == 8);
    CHECK(go(&top, E[i] - e * sin(E[i]), x) == PH_OK);
    const double want = 2 * atan2(sqrt((1 + e) / (1 - e)) * sin(E[i] / 2), cos(E[i] / 2));
    /* the time is rounded, and f' is at most sqrt(mu/p^3) (1 + e)^2 = 8 */
    ok(within(x[7], want, 4e-14), "true anomaly at E = %g by Kepler's equation", E[i]);
  }
}

static void sunlight(void) {
  /* area, reflectivity, normal, centre */
  static const double lit[8] = {2, 0.25, 3, 0, 0, 0, 0, 1}, edge[8] = {2, 0.25, 0, 0, 5, 0, 1, 0};
  static const double dark[8] = {2, 0.25, -1, 0, 0, 0, 1, 1}, sun[3] = {4, 3, 0};
  const double P = 299792458.0 / 299792458.0, x[7] = {1, 0, 0, 0, 0, 0, 0};
  const double c = 0.8, Fx = -P * 2 * c * (0.75 * 0.8 + 0.5 * c), Fy = -P * 2 * c * 0.75 * 0.6;
  double N[3];
  ph_top top = body(1, 2, 2.5);
  CHECK(ph_top_solar(&top, 299792458, sun, 1, lit) == PH_OK);
  CHECK(ph_top_torque(&top, 0, x, NULL, N) == PH_OK);
  claim(within(N[0], -Fy, 1e-15) && within(N[1], Fx, 1e-15) && N[2] == 0, "sunlight on a plate");
  top = body(1, 2, 2.5);
  CHECK(ph_top_solar(&top, 299792458, sun, 1, edge) == PH_OK);
  CHECK(ph_top_torque(&top, 0, x, NULL, N) == PH_OK);
  claim(N[0] == 0 && N[1] == 0 && N[2] == 0, "none on an edge");
  top = body(1, 2, 2.5);
  CHECK(ph_top_solar(&top, 299792458, sun, 1, dark) == PH_OK);
  CHECK(ph_top_torque(&top, 0, x, NULL, N) == PH_OK);
  claim(N[0] == 0 && N[1] == 0 && N[2] == 0, "none in the dark");
  const double none[8] = {1, 0, 0, 0, 0, 1, 1, 1}, bright[8] = {1, 2, 1, 0, 0, 1, 1, 1};
  claim(ph_top_solar(&top, 1, sun, 1, none) == PH_EDIRECTION &&
            ph_top_solar(&top, 1, sun, 1, bright) == PH_EBOUND &&
            ph_top_solar(&top, -1, sun, 1, lit) == PH_EBOUND &&
            ph_top_solar(&top, 1, sun, 0, lit) == PH_ECOUNT,
        "sunlight: what no plate has is refused");
}

static void support(void) {
  static const double com[3] = {0, 0.1, 0.5}, tensor[6] = {2, 2, 1, 0, 0, 0}, down[3] = {0, 0, -1};
  ph_top top;
  CHECK(ph_top_init_tensor(&top, 2, com, tensor) == PH_OK);
  CHECK(ph_top_gravity(&top, 8, down) == PH_OK);
  const ph_varying fall[3] = {OFF, OFF, {.value = -8}};
  CHECK(ph_top_pivot(&top, fall) == PH_OK);
  const double x[7] = {0.8, 0.6, 0, 0, 1, 2, 3};
  double N[3];
  CHECK(ph_top_torque(&top, 1, x, NULL, N) == PH_OK);
  claim(within(N[0], 0, 1e-15) && within(N[1], 0, 1e-15) && within(N[2], 0, 1e-15),
        "a support in free fall: nothing acts");
  CHECK(ph_top_init_tensor(&top, 2, com, tensor) == PH_OK);
  CHECK(ph_top_vibration(&top, 0.5, 4, down) == PH_OK); /* a = +8 cos 4t upwards at t = 0 */
  const double upright[7] = {1, 0, 0, 0, 0, 0, 0};
  CHECK(ph_top_torque(&top, 0, upright, NULL, N) == PH_OK);
  claim(within(N[0], -1.6, 1e-15), "a vibrating support pushes by -m a at the centre of mass");
}

static long double ramp(void *context, long double t, const long double x[]) {
  (void)t;
  return *(const double *)context * x[7];
}

static long double slope(void *context, long double t, const long double x[]) {
  (void)t;
  (void)x;
  return *(const double *)context;
}

static void parts(void) {
  static double speed = 0.25;
  ph_top top = body(1, 2, 2.5);
  const ph_varying tensor[6] = {OFF, OFF, {.f = ramp, .context = &speed}, OFF, OFF, OFF};
  const ph_varying rate[6] = {OFF, OFF, {.f = slope, .context = &speed}, OFF, OFF, OFF};
  CHECK(ph_top_parts(&top, tensor, rate) == PH_OK);
  double x[8] = {1, 0, 0, 0, 0, 0, 2, 0}, L[3], T;
  CHECK(ph_top_states(&top) == 8);
  CHECK(go(&top, 6, x) == PH_OK);
  claim(within(x[6], 5 / (2.5 + 1.5), 1e-14) && x[7] == 6, "moving parts: w = L/I(t)");
  CHECK(ph_top_momentum(&top, x, L) == PH_OK && ph_top_energy(&top, x, &T) == PH_OK);
  claim(within(L[2], 5, 1e-14) && within(T, 25.0 / 8, 1e-14), "moving parts: L and T with them");
  /* w integrated: 5/0.25 ln(1 + 0.25 t/2.5) */
  const double angle = 20 * log(1.6);
  claim(within(x[0], cos(angle / 2), 4e-14) && within(x[3], sin(angle / 2), 4e-14),
        "moving parts: the angle");
}

static void sink(void) {
  const double k = 0.3, I1 = 2, I3 = 1;
  ph_top top = body(I1, I1, I3);
  CHECK(ph_top_dissipation(&top, k) == PH_OK);
  double x[7] = {0.5, 0.5, 0.5, 0.5, 0.25, 0.5, 2}, L[3], after[3];
  CHECK(ph_top_momentum(&top, x, L) == PH_OK);
  const double across = I1 * hypot(x[4], x[5]), along = I3 * x[6];
  const double L2 = across * across + along * along;
  CHECK(go(&top, 3, x) == PH_OK && ph_top_momentum(&top, x, after) == PH_OK);
  int same = 1;
  for (int i = 0; i < 3; i++)
    same = same && within(after[i], L[i], 1e-14);
  claim(same, "energy sink: L in space stays");
  const double growth = k * L2 * (1 / I1 - 1 / I3) * 3;
  claim(within(log(I3 * x[6] / (I1 * hypot(x[4], x[5]))), log(along / across) + growth, 2e-14),
        "energy sink: the angle to the axis in closed form");
  claim(ph_top_dissipation(&top, -1) == PH_EBOUND, "energy sink: k < 0 is refused");
}

int main(void) {
  gradient();
  anomaly();
  sunlight();
  support();
  parts();
  sink();
  return tap_done();
}
