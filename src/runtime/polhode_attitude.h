/* polhode_attitude.h - attitudes as quaternion, matrix, rotation vector and angles; polhode.h
   includes it.
   SPDX-License-Identifier: GPL-3.0-or-later

   The conventions are those of polhode.h: scalar first, body to inertial. */
#ifndef POLHODE_ATTITUDE_H
#define POLHODE_ATTITUDE_H

#ifdef __cplusplus
extern "C" {
#endif

/* ---- quaternions ---- */

/* Product a b (Hamilton). */
void ph_quat_multiply(const double a[4], const double b[4], double out[4]);
void ph_quat_conjugate(const double q[4], double out[4]);
/* q/|q| without overflow or underflow; PH_EQUATERNION if q = 0, PH_EFINITE. */
int ph_quat_normalize(const double q[4], double out[4]);
/* v_inertial = q v_body q* / |q|^2, and back. PH_EQUATERNION, PH_EFINITE, PH_ERANGE. */
int ph_quat_rotate(const double q[4], const double body[3], double inertial[3]);
int ph_quat_unrotate(const double q[4], const double inertial[3], double body[3]);
/* Rotation by angle (rad, right-handed) about axis (any length but 0): PH_EDIRECTION. */
int ph_quat_from_axis(const double axis[3], double angle, double q[4]);

/* ---- in other numbers ---- */

/* Matrix R (row major), v_inertial = R v_body; the result of ph_quat_from_matrix has its first
   non-zero component positive. PH_EMATRIX unless R R^T = 1 to 1e-6 and det R > 0; the nearest
   rotation is taken to first order. */
int ph_quat_to_matrix(const double q[4], double R[9]);
int ph_quat_from_matrix(const double R[9], double q[4]);
/* Yaw, pitch, roll (rad): turns about z, then the new y, then the new x (3-2-1), from inertial to
   body axes: q = qz(yaw) qy(pitch) qx(roll). Out: yaw and roll in (-pi, pi], pitch in [-pi/2,
   pi/2]; at pitch = +-pi/2 only yaw -+ roll is determined, the other combination is taken as 0. */
int ph_quat_from_ypr(const double ypr[3], double q[4]);
int ph_quat_to_ypr(const double q[4], double ypr[3]);
/* Euler angles (rad) of a sequence of three body axes, "zxz" or "zyx" for example: q = q_a(first)
   q_b(second) q_c(third), each turn about the body's axis as it then stands. Out: first and third
   in
   [-pi, pi], second in [0, pi] where the first and last letter are equal, else in [-pi/2, pi/2];
   where the second is at an end of that to 2^-49, the third is 0. PH_ESEQUENCE, PH_EQUATERNION,
   PH_EFINITE. */
int ph_quat_to_euler(const double q[4], const char *sequence, double angles[3]);
int ph_quat_from_euler(const double angles[3], const char *sequence, double q[4]);
/* The rotation vector: axis times angle (rad), the angle in [0, pi]. PH_EQUATERNION, PH_EFINITE. */
int ph_quat_to_vector(const double q[4], double v[3]);

#ifdef __cplusplus
}
#endif

#endif
