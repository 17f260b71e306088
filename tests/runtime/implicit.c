/* implicit.c - stiff motions, and motions that come to rest, against closed forms.
   SPDX-License-Identifier: GPL-3.0-or-later

   A ball on viscous friction, F = -c N s: the slip s = v + w x d obeys s' = -(c g/k) s with
   k = I/(I + m R^2) = 2/7, so with E = exp(-c g t/k)
     v = v0 - k s0 (1 - E),   p = (v0 - k s0) t + k^2 s0/(c g) (1 - E),   R w_y = v_x - s_x
   and after a fast start the ball turns at a constant rate: q is the turn of the start by
   (w0 - w) k/(c g), then that by w t, but for (|w| k/(c g))^2. A sphere with the moment 1 under the
   torque -c(t) w has w = w0 exp(-int c). Tolerances: 1e-12 is what the implicit method is asked
   for here, some hundred steps of it 1e-14 of the largest speed; see each. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "polhode.h"
#include "tap.h"

static const double R = 0.03, G = 9.81;
static const double still[3] = {0, 0, 0};

/* A ball of 0.2 kg on a level plane. */
static ph_top ball(int law, double friction, double smoothing) {
  const double I = 0.4 * 0.2 * R * R, tensor[6] = {I, I, I, 0, 0, 0};
  const ph_plane plane = {.law = law,
                          .axes = {1, 0, 0, 0},
                          .rim = R,
                          .normal = {0, 0, 1},
                          .e1 = {1, 0, 0},
                          .gravity = {0, 0, -G},
                          .friction = friction,
                          .smoothing = smoothing};
  ph_top top;
  ok(ph_top_init_tensor(&top, 0.2, still, tensor) == PH_OK && ph_top_plane(&top, &plane) == PH_OK,
     "a ball on a plane");
  return top;
}

/* The state at t, the steps, and how many of them were implicit. */
static int go(const ph_top *top, ph_method method, double tolerance, double t, double x[],
              long *steps, long *implicit) {
  ph_options options = ph_options_default();
  ph_run *run = NULL;
  options.method = method;
  options.tolerance = tolerance;
  options.max_steps = 20000; /* what is to end in a second */
  int status = ph_run_new(&run, top, &options, 0, x);
  if (!status)
    status = ph_run_to(run, t, NULL, x);
  *steps = status ? 0 : ph_run_steps(run);
  *implicit = status ? 0 : ph_run_implicit_steps(run);
  ph_run_free(run);
  return status;
}

static void viscous(ph_method method, double tolerance, double c, double t, double bound) {
  const double k = 2.0 / 7, v0[2] = {1, 0.3}, w0[3] = {2, -10, 5};
  const double s0[2] = {v0[0] - R * w0[1], v0[1] + R * w0[0]};
  const ph_top top = ball(PH_VISCOUS, c, 0);
  double x[11] = {1, 0, 0, 0, w0[0], w0[1], w0[2], 0, 0, v0[0], v0[1]};
  long steps, implicit;
  const int status = go(&top, method, tolerance, t, x, &steps, &implicit);
  if (!ok(status == PH_OK, "c = %g s/m: runs to %g s (%s)", c, t, ph_status_phrase(status)))
    return;
  ok(implicit > 0 && implicit <= steps && steps < 2000, "by %ld steps, %ld implicit", steps,
     implicit);
  const long double rate = (long double)c * G / k, gone = -expm1l(-rate * t);
  long double turned = w0[2] * (long double)w0[2];
  for (int i = 0; i < 2; i++) {
    const long double v = v0[i] - k * s0[i] * gone, s = s0[i] * (1 - gone);
    near(x[9 + i], v, bound, "velocity %d", i);
    near(x[7 + i], (v0[i] - k * s0[i]) * (long double)t + k * s0[i] / rate * gone, bound,
         "place %d", i);
    turned += (v - s) * (v - s) / (R * (long double)R);
  }
  near(sqrt(x[4] * x[4] + x[5] * x[5] + x[6] * x[6]), sqrtl(turned), bound / R,
       "the rates' size; the plane keeps the spin about its normal");
}

/* q after the start, at the largest friction alone. */
static void attitude(void) {
  const double c = 1e8, tau = 2.0 / 7 / (c * G), t = 1, w0[3] = {0, -10, 0};
  const double w = -(1 - 2.0 / 7 * (1 + R * 10)) / -R; /* v = R w_y: about y alone */
  const ph_top top = ball(PH_VISCOUS, c, 0);
  double x[11] = {1, 0, 0, 0, w0[0], w0[1], w0[2], 0, 0, 1, 0};
  long steps, implicit;
  ok(go(&top, PH_IMPLICIT, 1e-14, t, x, &steps, &implicit) == PH_OK, "c = 1e8 s/m: an attitude");
  const double half = (w * t + (w0[1] - w) * tau) / 2;
  near(x[0], cos(half), 1e-12, "the turn about y, cosine");
  near(x[2], sin(half), 1e-12, "and sine");
}

/* A ball whose backspin takes all of its speed: v = (2/5) R w at the start. */
static void stop_shot(double smoothing, double t) {
  const ph_top top = ball(PH_COULOMB, 0.2, smoothing);
  double x[11] = {1, 0, 0, 0, 0, -100, 0, 0, 0, 1.2, 0};
  long steps, implicit;
  const int status = go(&top, PH_TAYLOR, 1e-18, t, x, &steps, &implicit);
  ok(status == PH_OK && steps < 4000, "smoothing %g: the stop shot reaches %g s in %ld steps (%s)",
     smoothing, t, steps, ph_status_phrase(status));
  /* the smoothed law decays with (2/7) s/(mu g); 1e-14 of 100 rad/s and 1.2 m/s is rounding */
  near(x[5], 0, 1e-12, "it does not turn");
  near(x[9], 0, 1.2e-14, "nor move");
  if (smoothing < 1e-4) /* it slips to the end, with -mu g; the rest is the smoothing's creep */
    near(x[7], 1.2 * 1.2 / (2 * 0.2 * G), 1e-6, "after v^2/(2 mu g)");
}

static long double falling(void *context, long double t, const long double x[]) {
  (void)context;
  return (t - 20) * x[7];
}

static long double braking(void *context, long double t, const long double x[]) {
  return (t - 20) * x[4 + *(int *)context];
}

/* What has decayed to e^-200 and grows again is followed from there: no error is measured by a size
   that is gone. */
static void grown(void) {
  static int axis[3] = {0, 1, 2};
  const double unit[6] = {1, 1, 1, 0, 0, 0};
  const ph_varying rate = {.f = falling};
  ph_varying torque[3];
  ph_top top;
  for (int i = 0; i < 3; i++)
    torque[i] = (ph_varying){.f = braking, .context = &axis[i]};
  ok(ph_top_init_tensor(&top, 1, still, unit) == PH_OK &&
         ph_top_custom(&top, torque, NULL, NULL, 1, &rate) == PH_OK,
     "a sphere whose damping turns its sign after 20 s, and a state of its own");
  double x[8] = {1, 0, 0, 0, 0.01, 0.02, -0.02, 1};
  long steps, implicit;
  ok(go(&top, PH_TAYLOR, 1e-18, 20, x, &steps, &implicit) == PH_OK, "it runs");
  near(x[7] * exp(200), 1, 1e-12, "y = e^-200 after 20 s: the exponential's rounding is 200 ulp");
  double y[8] = {1, 0, 0, 0, 0.01, 0.02, -0.02, 1};
  ok(go(&top, PH_TAYLOR, 1e-18, 40, y, &steps, &implicit) == PH_OK, "and on");
  near(y[7], 1, 1e-13, "y is 1 again at 40 s");
  near(y[4], 0.01, 1e-15, "and w what it was");
}

/* A damped spring: the torque that is left at rest is a difference of large terms. */
static void at_rest(double scale) {
  const double I = scale, tensor[6] = {I, 1.2 * I, 1.5 * I, 0, 0, 0},
               k[3] = {40 * I, 40 * I, 40 * I};
  const double turned[4] = {0.8, 0.36, 0.48, 0}, C[9] = {6 * I, 0, 0, 0, 6 * I, 0, 0, 0, 6 * I};
  ph_top top;
  ok(ph_top_init_tensor(&top, scale, still, tensor) == PH_OK &&
         ph_top_spring(&top, k, turned) == PH_OK && ph_top_damping(&top, C) == PH_OK,
     "a damped spring, moments of %g", scale);
  double x[7] = {1, 0, 0, 0, 0.1, 0.2, 0.3};
  long steps, implicit;
  const int status = go(&top, PH_TAYLOR, 1e-18, 200, x, &steps, &implicit);
  ok(status == PH_OK && steps < 4000, "comes to rest in %ld steps (%s)", steps,
     ph_status_phrase(status));
  for (int i = 0; i < 4; i++)
    near(x[i], turned[i], 4 * DBL_EPSILON, "where the spring wants it, %d", i);
}

/* Rolling and spinning resistance to the end: w falls by mu_r m g/J, J = I + m R^2, to 0. */
static void rolls_out(void) {
  const double I = 0.4 * 0.2 * R * R, tensor[6] = {I, I, I, 0, 0, 0}, a = 3e-4, w0 = 30;
  const ph_plane plane = {.law = PH_ROLLING,
                          .placed = 1,
                          .axes = {1, 0, 0, 0},
                          .rim = R,
                          .normal = {0, 0, 1},
                          .e1 = {1, 0, 0},
                          .gravity = {0, 0, -G},
                          .spinning = {1e-3, 1e-6},
                          .rolling = {a, 1e-6}};
  ph_top top;
  ok(ph_top_init_tensor(&top, 0.2, still, tensor) == PH_OK && ph_top_plane(&top, &plane) == PH_OK,
     "a ball with resistance");
  double x[9] = {1, 0, 0, 0, 0, w0, 8, 0, 0};
  long steps, implicit;
  const int status = go(&top, PH_TAYLOR, 1e-18, 20, x, &steps, &implicit);
  ok(status == PH_OK && steps < 4000, "rolls out in %ld steps (%s)", steps,
     ph_status_phrase(status));
  near(sqrt(x[4] * x[4] + x[5] * x[5] + x[6] * x[6]), 0, 1e-12, "it does not turn");
  /* R w0^2/(2 w'), w' = a g m/J with J = 7/5 m R^2; the smoothing adds e^2/(2 w') ln(w0/e), 1e-13
   */
  near(x[7], 1.4 * R * R * R * w0 * w0 / (2 * a * G), 1e-9, "after the way of the true law");
}

int main(void) {
  for (double c = 1e4; c < 2e8; c *= 100) {
    viscous(PH_IMPLICIT, 1e-12, c, 1, 1e-11);
    viscous(PH_IMPLICIT, 1e-12, c, 2.0 / 7 / (c * G), 1e-12);
    viscous(PH_IMPLICIT, 1e-16, c, 1, 1e-14);
    viscous(PH_TAYLOR, 1e-18, c, 1, 1e-14);
  }
  attitude();
  stop_shot(0.1, 2);
  stop_shot(1e-2, 2);
  stop_shot(1e-5, 2);
  grown();
  at_rest(1);
  at_rest(1e-30);
  at_rest(1e30);
  rolls_out();
  return tap_done();
}
