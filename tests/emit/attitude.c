/* attitude.c - the emitted attitude in other numbers beside the library's: part of attitude.t,
   which judges. SPDX-License-Identifier: GPL-3.0-or-later

   Compiled for double and float: -DNAME=the scene's name, -include of its header. Prints lines
   "what value": the worst errors in units of the type's epsilon. The library computes in long
   double, and reads angles from the matrix. */
#include "polhode.h"

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>

#define JOIN_NAMES(a, b) a##b
#define JOIN(a, b)       JOIN_NAMES(a, b)
#define OF(function)     JOIN(NAME, function)

typedef OF(_real) real;
static const double EPS = sizeof(real) == 4 ? FLT_EPSILON : DBL_EPSILON;
static const double PI = 3.14159265358979323846;

static const char *const SEQUENCES[12] = {"xyx", "xzx", "yxy", "yzy", "zxz", "zyz",
                                          "xyz", "xzy", "yxz", "yzx", "zxy", "zyx"};

static uint64_t seed = 88172645463325252u;
static double uniform(void) { /* in (0, 1): xorshift64, Marsaglia 2003 */
  seed ^= seed << 13;
  seed ^= seed >> 7;
  seed ^= seed << 17;
  return ((double)(seed >> 11) + 0.5) * 0x1p-53;
}

static void worst(double *most, double value) {
  if (!(value <= *most))
    *most = value;
}

/* A unit quaternion in the type's precision, by the library in x and as double in q. */
static void unit(const double any[4], real x[], double q[4]) {
  double u[4];
  ph_quat_normalize(any, u);
  for (int i = 0; i < 4; i++) {
    x[i] = (real)u[i];
    q[i] = (double)x[i];
  }
}

static double apart(double a, double b) { /* of two angles */
  return fabs(remainder(a - b, 2 * PI));
}

static double errors[8]; /* matrix, rotate, back, vector, euler, turned, set, range */
static int singular, twice;

static void pose(const double any[4]) {
  real x[16] = {0}, R[9], v[3], out[3], back[3], e[3];
  double q[4], want[9], dv[3], turned[3];

  unit(any, x, q);
  OF(_matrix)(x, R);
  ph_quat_to_matrix(q, want);
  for (int i = 0; i < 9; i++)
    worst(&errors[0], fabs((double)R[i] - want[i]) / EPS);
  for (int i = 0; i < 3; i++)
    dv[i] = (double)(v[i] = (real)(2 * uniform() - 1));
  const double length = sqrt(dv[0] * dv[0] + dv[1] * dv[1] + dv[2] * dv[2]);
  OF(_rotate)(x, v, out);
  ph_quat_rotate(q, dv, turned);
  for (int i = 0; i < 3; i++)
    worst(&errors[1], fabs((double)out[i] - turned[i]) / EPS / length);
  OF(_unrotate)(x, out, back);
  for (int i = 0; i < 3; i++)
    worst(&errors[2], fabs((double)back[i] - dv[i]) / EPS / length);
  OF(_rotation_vector)(x, out);
  ph_quat_to_vector(q, turned);
  for (int i = 0; i < 3; i++)
    worst(&errors[3], fabs((double)out[i] - turned[i]) / EPS / PI);
  for (int k = 0; k < 12; k++) {
    const int status = OF(_euler)(x, SEQUENCES[k], e);
    double angles[3], own[3], again[4];
    ph_quat_to_euler(q, SEQUENCES[k], angles);
    const double sine = k < 6 ? sin(angles[1]) : cos(angles[1]);
    for (int i = 0; i < 3; i++) {
      own[i] = (double)e[i];
      worst(&errors[7], fabs(own[i]) / ((i != 1 || k < 6 ? PI : PI / 2) * (1 + EPS)));
    }
    worst(&errors[7], k < 6 && own[1] < 0 ? 2 : 0);
    singular += status == 1;
    twice += status == 1 && e[2] != 0;
    if (status == 0 && fabs(sine) > 16 * EPS) {
      worst(&errors[4], apart(own[1], angles[1]) / EPS);
      for (int i = 0; i < 3; i += 2)
        worst(&errors[4], apart(own[i], angles[i]) / EPS * fmin(1, fabs(sine)));
    }
    ph_quat_from_euler(own, SEQUENCES[k], again);
    double sum = 0, difference = 0;
    for (int i = 0; i < 4; i++) {
      worst(&sum, fabs(again[i] + q[i]));
      worst(&difference, fabs(again[i] - q[i]));
    }
    worst(&errors[5], fmin(sum, difference) / EPS);
    OF(_set_euler)(x, SEQUENCES[k], e);
    for (int i = 0; i < 4; i++)
      worst(&errors[6], fabs((double)x[i] - again[i]) / EPS);
    for (int i = 0; i < 4; i++)
      x[i] = (real)q[i];
  }
}

int main(void) {
  static const char *const names[8] = {"matrix", "rotate", "back", "vector",
                                       "euler",  "turned", "set",  "range"};
  static const char *const none[] = {"xxz", "zx", "zxzx", "ZXZ", "", "zz", "ab", "zyy"};
  real x[16] = {1}, e[3] = {7, 8, 9};
  int wrong = 0;

  for (int n = 0; n < 20000; n++) {
    double any[4];
    for (int i = 0; i < 4; i++)
      any[i] = (2 * uniform() - 1) * (n % 4 ? 1 : pow(10, -12 * uniform()));
    pose(any);
  }
  for (int n = 0; n < 625; n++) { /* turns of quarters and thirds, and half way to nothing */
    static const double part[5] = {0, 1, -1, 0.5, 1e-30};
    const double any[4] = {part[n % 5], part[n / 5 % 5], part[n / 25 % 5], part[n / 125]};
    if (any[0] != 0 || any[1] != 0 || any[2] != 0 || any[3] != 0)
      pose(any);
  }
  for (int k = 0; k < 12; k++) /* at the ends of the second angle, and beside them */
    for (int n = 0; n < 200; n++) {
      const double off = n % 5 == 0 ? 0 : pow(10, -16 * uniform());
      const double angles[3] = {6 * uniform() - 3,
                                (k < 6 ? (n % 2 ? PI : 0) : (n % 2 ? PI : -PI) / 2) + off,
                                6 * uniform() - 3};
      double q[4];
      ph_quat_from_euler(angles, SEQUENCES[k], q);
      pose(q);
    }
  for (int i = 0; i < 8; i++)
    printf("%s %.3f\n", names[i], errors[i]);
  for (int i = 0; i < 8; i++)
    wrong += OF(_euler)(x, none[i], e) != 2 || OF(_set_euler)(x, none[i], e) != 2;
  wrong += e[0] != 7 || e[1] != 8 || e[2] != 9 || x[0] != 1;
  e[1] = (real)NAN;
  wrong += OF(_set_euler)(x, "zxz", e) != 3;
  e[1] = (real)INFINITY;
  wrong += OF(_set_euler)(x, "zyx", e) != 3 || x[0] != 1;
  printf("refused %d\nsingular %d\nthird %d\n", wrong, singular, twice);
  return 0;
}
