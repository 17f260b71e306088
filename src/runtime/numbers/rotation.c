/* rotation.c - quaternions, matrices, axis and angle, yaw-pitch-roll.
   SPDX-License-Identifier: GPL-3.0-or-later

   A quaternion stands for the direction of the 4-vector: every function that turns something
   divides by |q|^2, so it is a rotation to the last digit whatever the length of q. No function has
   a case that is "nearly singular": the matrix inverse picks the largest of four sums, and yaw and
   roll come from the half-sum and half-difference, each well defined on its own. */
#include "wide.h"

void ph_quat_multiply(const double a[4], const double b[4], double out[4]) {
  ph_wide p[4], q[4];
  wide_load(4, a, p);
  wide_load(4, b, q);
  wide_quat_multiply(p, q, p);
  for (int i = 0; i < 4; i++)
    out[i] = (double)p[i];
}

void ph_quat_conjugate(const double q[4], double out[4]) {
  out[0] = q[0];
  for (int i = 1; i < 4; i++)
    out[i] = -q[i];
}

int ph_quat_normalize(const double q[4], double out[4]) {
  ph_wide unit[4];
  const int status = wide_load_unit(q, unit);
  return status ? status : wide_store(4, unit, out);
}

static int turn(const double q[4], const double in[3], int to_inertial, double out[3]) {
  ph_wide unit[4], v[3];
  if (!wide_finite(3, in))
    return PH_EFINITE;
  const int status = wide_load_unit(q, unit);
  if (status)
    return status;
  wide_load(3, in, v);
  wide_sandwich(unit, v, to_inertial, v);
  return wide_store(3, v, out);
}

int ph_quat_rotate(const double q[4], const double body[3], double inertial[3]) {
  return turn(q, body, 1, inertial);
}

int ph_quat_unrotate(const double q[4], const double inertial[3], double body[3]) {
  return turn(q, inertial, 0, body);
}

int ph_quat_from_axis(const double axis[3], double angle, double q[4]) {
  if (!wide_finite(3, axis) || !isfinite(angle))
    return PH_EFINITE;
  ph_wide e[3];
  wide_load(3, axis, e);
  const ph_wide n = wide_norm(e), half = (ph_wide)angle / 2;
  if (!(n > 0))
    return PH_EDIRECTION;
  q[0] = (double)cosl(half);
  for (int i = 0; i < 3; i++)
    q[1 + i] = (double)(sinl(half) * e[i] / n);
  return PH_OK;
}

int ph_quat_to_matrix(const double q[4], double R[9]) {
  ph_wide unit[4], m[9];
  const int status = wide_load_unit(q, unit);
  if (status)
    return status;
  wide_quat_matrix(unit, m);
  return wide_store(9, m, R);
}

/* 1e-6 is not a precision but a misunderstanding's threshold: a matrix that is off by more is a
   mirror, a shear or a transposed something, not a rounded rotation. Within it the row used below
   is off in second order only. */
int ph_quat_from_matrix(const double R[9], double q[4]) {
  if (!wide_finite(9, R))
    return PH_EFINITE;
  ph_wide m[9], x[3];
  wide_load(9, R, m);
  for (int i = 0; i < 3; i++)
    for (int j = 0; j <= i; j++)
      if (fabsl(wide_dot(m + 3 * i, m + 3 * j) - (i == j)) > 1e-6L)
        return PH_EMATRIX;
  wide_cross(m, m + 3, x);
  if (wide_dot(x, m + 6) < 0)
    return PH_EMATRIX;
  /* The rows of 4 q q^T, of which the diagonal sums to 4: the largest diagonal entry is 1 or more,
     and its row divided by its root is 2 q without cancellation. */
  const ph_wide xx = m[0], yy = m[4], zz = m[8];
  const ph_wide k[4][4] = {
      {1 + xx + yy + zz, m[7] - m[5], m[2] - m[6], m[3] - m[1]},
      {m[7] - m[5], 1 + xx - yy - zz, m[1] + m[3], m[2] + m[6]},
      {m[2] - m[6], m[1] + m[3], 1 - xx + yy - zz, m[5] + m[7]},
      {m[3] - m[1], m[2] + m[6], m[5] + m[7], 1 - xx - yy + zz},
  };
  int largest = 0;
  for (int i = 1; i < 4; i++)
    if (k[i][i] > k[largest][largest])
      largest = i;
  const ph_wide *row = k[largest], n = wide_quat_norm(row);
  int first = 0;
  while (row[first] == 0)
    first++;
  for (int i = 0; i < 4; i++)
    q[i] = (double)(row[first] < 0 ? -row[i] / n : row[i] / n);
  return PH_OK;
}

int ph_quat_from_ypr(const double ypr[3], double q[4]) {
  if (!wide_finite(3, ypr))
    return PH_EFINITE;
  ph_wide p[4] = {1, 0, 0, 0};
  for (int i = 0; i < 3; i++) { /* about z, then y, then x, each in the axes turned so far */
    const ph_wide half = (ph_wide)ypr[i] / 2;
    ph_wide step[4] = {cosl(half), 0, 0, 0};
    step[3 - i] = sinl(half);
    wide_quat_multiply(p, step, p);
  }
  return wide_store(4, p, q);
}

/* Into (-pi, pi]. */
static double wrap(ph_wide angle) {
  const ph_wide pi = 3.14159265358979323846264338327950288L;
  if (angle > pi)
    angle -= 2 * pi;
  if (angle <= -pi)
    angle += 2 * pi;
  return (double)angle;
}

int ph_quat_to_ypr(const double q[4], double ypr[3]) {
  ph_wide u[4];
  const int status = wide_load_unit(q, u);
  if (status)
    return status;
  /* Multiplying out qz(yaw) qy(pitch) qx(roll), with s = sin(pitch/2), c = cos(pitch/2):
       (w + y, z - x) = (c + s) (cos, sin)((yaw - roll)/2),  (w - y, z + x) = (c - s) (cos,
     sin)((yaw + roll)/2), so half-difference and half-sum are two arctangents, one of which loses
     its meaning only at pitch +-90 deg; (c + s)(c - s) = cos pitch, 2 (w y - x z) = sin pitch. */
  const ph_wide dc = u[0] + u[2], ds = u[3] - u[1], sc = u[0] - u[2], ss = u[3] + u[1];
  const ph_wide difference = atan2l(ds, dc), sum = atan2l(ss, sc);
  const ph_wide plus = sqrtl(dc * dc + ds * ds), minus = sqrtl(sc * sc + ss * ss);
  ypr[1] = (double)atan2l(2 * (u[0] * u[2] - u[1] * u[3]), plus * minus);
  ypr[0] = wrap(sum + difference);
  ypr[2] = wrap(sum - difference);
  return PH_OK;
}
