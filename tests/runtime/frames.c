/* frames.c - rotations, frames and the transport theorem.
   SPDX-License-Identifier: GPL-3.0-or-later

   Oracles: rotations that are known exactly (thirds of a turn permute the axes, 3-4-5 triangles),
   matrices multiplied out here, and derivatives of a moving point taken by differences of its
   inertial path. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "polhode.h"
#include "tap.h"

/* Results are rounded once from long double; inputs that are themselves rounded (cos, sin) add one
 * ulp. */
static const double TOL = 2 * DBL_EPSILON;
static const double PI = 3.141592653589793;

static void quaternions(void) {
  const double i[] = {0, 1, 0, 0}, j[] = {0, 0, 1, 0}, k[] = {0, 0, 0, 1};
  double p[4], v[3];
  ph_quat_multiply(i, j, p);
  near_all(4, p, k, 0, "i j = k");
  ph_quat_multiply(j, i, p);
  near_all(4, p, ((const double[]){0, 0, 0, -1}), 0, "j i = -k");
  const double third[] = {0.5, 0.5, 0.5, 0.5}, a[] = {1, 2, 3};
  ok(ph_quat_rotate(third, a, v) == 0, "a third of a turn about (1, 1, 1) turns");
  near_all(3, v, ((const double[]){3, 1, 2}), 0,
           "body (1, 2, 3) is inertial (3, 1, 2): x goes to y");
  ph_quat_unrotate(third, v, v);
  near_all(3, v, a, 0, "and back, in place");
  /* 3-4-5: w = 2, z = 1 of any length turns by 2 atan(1/2): cos 3/5, sin 4/5 */
  ph_quat_rotate((const double[]){2e200, 0, 0, 1e200}, (const double[]){5, 0, 1}, v);
  near_all(3, v, ((const double[]){3, 4, 1}), 5 * TOL,
           "a quaternion of length 2e200 turns, and does not stretch");
  ph_quat_rotate((const double[]){2e-200, 0, 0, 1e-200}, (const double[]){5, 0, 1}, v);
  near_all(3, v, ((const double[]){3, 4, 1}), 5 * TOL, "so does one of length 2e-200");
  ok(ph_quat_normalize((const double[]){3e300, 0, 4e300, 0}, p) == 0,
     "a huge quaternion is normalised");
  near_all(4, p, ((const double[]){0.6, 0, 0.8, 0}), TOL, "to 3/5, 4/5");
  ph_quat_conjugate(third, p);
  near_all(4, p, ((const double[]){0.5, -0.5, -0.5, -0.5}), 0, "the conjugate turns back");
  ok(ph_quat_from_axis((const double[]){0, 0, 7}, PI / 3, p) == 0, "60 degrees about (0, 0, 7)");
  near_all(4, p, ((const double[]){sqrt(0.75), 0, 0, 0.5}), TOL, "is (sqrt 3/2, 0, 0, 1/2)");
}

static void matrices(void) {
  double R[9], q[4], v[3];
  double worst_cycle = 0, worst_vector = 0;
  /* a net of quaternions that includes each component zero, and each the largest */
  for (int n = 1; n < 625; n++) {
    const double c[4] = {n % 5 - 2, n / 5 % 5 - 2, n / 25 % 5 - 2, n / 125 - 2};
    double unit[4];
    if (ph_quat_normalize(c, unit) || ph_quat_to_matrix(c, R) || ph_quat_from_matrix(R, q))
      continue;
    const double sign =
        unit[0] * q[0] + unit[1] * q[1] + unit[2] * q[2] + unit[3] * q[3] < 0 ? -1 : 1;
    for (int i = 0; i < 4; i++)
      worst_cycle = fmax(worst_cycle, fabs(sign * q[i] - unit[i]));
    const double a[3] = {1, -2, 3};
    ph_quat_rotate(c, a, v);
    for (int i = 0; i < 3; i++)
      worst_vector =
          fmax(worst_vector, fabs(R[3 * i] - 2 * R[3 * i + 1] + 3 * R[3 * i + 2] - v[i]));
  }
  near(worst_cycle, 0, TOL, "quaternion -> matrix -> quaternion, 624 of them");
  near(worst_vector, 0, 6 * TOL, "R v = q v q*");
  ok(ph_quat_from_matrix((const double[]){-1, 0, 0, 0, -1, 0, 0, 0, 1}, q) == 0,
     "half a turn about z has a quaternion");
  near_all(4, q, ((const double[]){0, 0, 0, 1}), 0, "(0, 0, 0, 1)");
  ok(ph_quat_from_matrix((const double[]){1, 0, 0, 0, 1, 0, 0, 0, -1}, q) == PH_EMATRIX,
     "a mirror is no rotation");
  ok(ph_quat_from_matrix((const double[]){1, 0.001, 0, 0, 1, 0, 0, 0, 1}, q) == PH_EMATRIX,
     "nor is a shear");
}

static void angles(void) {
  double q[4], e[3], v[3];
  ph_quat_from_ypr((const double[]){PI / 2, 0, 0}, q);
  ph_quat_rotate(q, (const double[]){1, 0, 0}, v);
  near_all(3, v, ((const double[]){0, 1, 0}), TOL, "yaw 90: the nose points along inertial y");
  ph_quat_from_ypr((const double[]){0, PI / 2, 0}, q);
  ph_quat_rotate(q, (const double[]){1, 0, 0}, v);
  near_all(3, v, ((const double[]){0, 0, -1}), TOL,
           "pitch 90: the nose points along -z (up, if z is down)");
  double worst = 0;
  for (int n = 0; n < 7 * 5 * 7; n++) {
    const double want[3] = {(n % 7 - 3) * 1.04, (n / 7 % 5 - 2) * 0.78, (n / 35 - 3) * 1.04};
    ph_quat_from_ypr(want, q);
    ph_quat_to_ypr(q, e);
    for (int i = 0; i < 3; i++)
      worst = fmax(worst, fabs(e[i] - want[i]) * cos(want[1]));
  }
  near(worst, 0, 8 * TOL,
       "angles -> quaternion -> angles, with the error that 1/cos(pitch) makes taken off");
  ph_quat_from_ypr((const double[]){3, 0.5, 1}, q);
  for (int i = 0; i < 4; i++)
    q[i] = -q[i];
  ph_quat_to_ypr(q, e);
  near_all(3, e, ((const double[]){3, 0.5, 1}), 8 * TOL,
           "-q has the angles of q, within (-pi, pi]");
  double dcm[9];
  ph_quat_from_ypr((const double[]){0.3, -0.7, 1.1}, q);
  ph_quat_to_matrix(q, dcm);
  near(e[1] = atan2(-dcm[6], hypot(dcm[0], dcm[3])), -0.7, TOL, "pitch is -asin R31");
  near(e[0] = atan2(dcm[3], dcm[0]), 0.3, TOL, "yaw is atan2(R21, R11)");
  near(e[2] = atan2(dcm[7], dcm[8]), 1.1, 2 * TOL, "roll is atan2(R32, R33)");
  /* gimbal lock: (1, 0, 1, 0) is pitch 90 exactly; then with a yaw of 0.4 before it */
  ph_quat_to_ypr((const double[]){1, 0, 1, 0}, e);
  near_all(3, e, ((const double[]){0, PI / 2, 0}), TOL, "pitch 90 degrees exactly: yaw and roll 0");
  ph_quat_from_ypr((const double[]){0.4, PI / 2 - 1e-9, 0.1}, q);
  ph_quat_to_ypr(q, e);
  near(e[0] - e[2], 0.3, 8 * TOL, "1e-9 rad from the lock yaw - roll is as exact as ever");
  near(e[1], PI / 2 - 1e-9, 8 * TOL, "and so is pitch");
}

/* Each turn by the axis and angle that the convention names, multiplied: another way than the
 * matrix. */
static void sequences(void) {
  static const char *const all[12] = {"xyx", "xzx", "yxy", "yzy", "zxz", "zyz",
                                      "xyz", "xzy", "yxz", "yzx", "zxy", "zyx"};
  double worst = 0, built = 0, q[4], e[3];
  for (int k = 0; k < 12; k++)
    for (int n = 0; n < 7 * 5 * 7; n++) {
      const double want[3] = {(n % 7 - 3) * 1.04, (n / 7 % 5 - 2) * 0.6 + (k < 6 ? PI / 2 : 0),
                              (n / 35 - 3) * 1.04};
      double product[4] = {1, 0, 0, 0}, step[4];
      for (int i = 0; i < 3; i++) {
        double axis[3] = {0, 0, 0};
        axis[all[k][i] - 'x'] = 1;
        ph_quat_from_axis(axis, want[i], step);
        ph_quat_multiply(product, step, product);
      }
      ph_quat_from_euler(want, all[k], q);
      for (int i = 0; i < 4; i++)
        built = fmax(built, fabs(q[i] - product[i]));
      ph_quat_to_euler(product, all[k], e);
      for (int i = 0; i < 3; i++)
        worst = fmax(worst, fabs(e[i] - want[i]) * fabs(k < 6 ? sin(want[1]) : cos(want[1])));
    }
  near(built, 0, 2 * TOL, "twelve sequences: the product of three turns");
  near(worst, 0, 8 * TOL, "and its angles, with the error that the second one makes taken off");
  double ypr[3];
  ph_quat_from_ypr((const double[]){0.4, -1.2, 2.5}, q);
  ph_quat_to_euler(q, "zyx", e);
  ph_quat_to_ypr(q, ypr);
  near_all(3, e, ypr, 4 * TOL, "yaw, pitch, roll are zyx");
  ph_quat_from_euler((const double[]){1, 0, 0.5}, "zxz", q);
  ph_quat_to_euler(q, "zxz", e);
  near_all(3, e, ((const double[]){1.5, 0, 0}), 2 * TOL, "zxz upright: the sum in the first angle");
  ph_quat_from_euler((const double[]){1, PI, 0.25}, "zxz", q);
  ph_quat_to_euler(q, "zxz", e);
  near_all(3, e, ((const double[]){0.75, PI, 0}), 2 * TOL, "hanging: the difference");
  ph_quat_from_axis((const double[]){2, -1, 2}, 3, q);
  ph_quat_to_vector(q, e);
  near_all(3, e, ((const double[]){2, -1, 2}), 4 * TOL, "the vector of 3 rad about (2, -1, 2)");
  for (int i = 0; i < 4; i++)
    q[i] = -q[i];
  ph_quat_to_vector(q, e);
  near_all(3, e, ((const double[]){2, -1, 2}), 4 * TOL, "and of -q");
}

/* A point that moves in the body frame, r(t), seen from a body that turns about (2, -1, 2)/3 at
 * rate(t). */
static const double AXIS[3] = {2.0 / 3, -1.0 / 3, 2.0 / 3};

static void path(long double t, long double r[3]) {
  r[0] = 1 + 0.5L * t, r[1] = -0.25L * t * t, r[2] = 0.75L + t * t * t / 6;
}

/* Inertial position: Rodrigues' formula with the angle t + t^2/4. */
static void inertial(long double t, long double R[3]) {
  long double r[3], dot = 0;
  path(t, r);
  const long double angle = t + t * t / 4, c = cosl(angle), s = sinl(angle);
  const long double e[3] = {2 / 3.0L, -1 / 3.0L, 2 / 3.0L};
  for (int i = 0; i < 3; i++)
    dot += e[i] * r[i];
  for (int i = 0; i < 3; i++) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    R[i] = c * r[i] + s * (e[j] * r[k] - e[k] * r[j]) + (1 - c) * dot * e[i];
  }
}

static void transport(void) {
  /* At t = 0 body and inertial axes coincide: w = AXIS, w' = AXIS / 2. Derivatives of the inertial
     path by central differences of step h, error h^2 R'''/6: with h = 2^-14 about 1e-8. */
  const long double h = 0x1p-14L;
  const double tol = 4e-8;
  long double past[3], now[3], next[3];
  double rate[3], second[3];
  inertial(-h, past);
  inertial(0, now);
  inertial(h, next);
  for (int i = 0; i < 3; i++) {
    rate[i] = (double)((next[i] - past[i]) / (2 * h));
    second[i] = (double)((next[i] - 2 * now[i] + past[i]) / (h * h));
  }
  const double r[3] = {1, 0, 0.75}, v[3] = {0.5, 0, 0}, a[3] = {0, -0.5, 0};
  const double w_rate[3] = {AXIS[0] / 2, AXIS[1] / 2, AXIS[2] / 2};
  double got[3], back[3];
  ok(ph_frame_rate_inertial(AXIS, r, v, got) == 0, "the transport theorem applies");
  near_all(3, got, rate, tol, "dr/dt inertial = dr/dt body + w x r, by differences");
  ph_frame_rate_body(AXIS, r, got, back);
  near_all(3, back, v, TOL, "and back to the body frame");
  ph_acceleration acc;
  ok(ph_frame_acceleration(AXIS, w_rate, r, v, a, &acc) == 0,
     "the second derivative has four terms");
  near_all(3, acc.total, second, tol, "their sum is the inertial acceleration, by differences");
  double sum[3];
  for (int i = 0; i < 3; i++)
    sum[i] = acc.relative[i] + acc.coriolis[i] + acc.euler[i] + acc.centripetal[i];
  near_all(3, sum, acc.total, 4 * TOL, "the four terms add up");

  const double z[3] = {0, 0, 2}, x[3] = {1, 0, 0}, y[3] = {0, 3, 0}, none[3] = {0, 0, 0},
               dz[3] = {0, 0, 5};
  ph_frame_acceleration(z, none, x, none, none, &acc);
  near_all(3, acc.centripetal, ((const double[]){-4, 0, 0}), 0,
           "at rest in the frame: w x (w x r) = -w^2 r alone");
  near_all(3, acc.total, acc.centripetal, 0, "with nothing else");
  ph_frame_acceleration(z, none, none, y, none, &acc);
  near_all(3, acc.coriolis, ((const double[]){-12, 0, 0}), 0, "moving along y: 2 w x v = -2 w v x");
  ph_frame_acceleration(z, dz, x, none, none, &acc);
  near_all(3, acc.euler, ((const double[]){0, 5, 0}), 0, "spinning up: w' x r along y");
  ph_frame_acceleration(none, none, x, y, z, &acc);
  near_all(3, acc.total, z, 0, "a frame that does not turn adds nothing");
}

int main(void) {
  quaternions();
  matrices();
  angles();
  sequences();
  transport();
  return tap_done();
}
