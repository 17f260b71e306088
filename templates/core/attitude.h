%% -- attitude.h -- the attitude in other numbers.  Part of scene.h.  SPDX-License-Identifier: MIT-0
/* ---- the attitude in other numbers ----
 * q = x[${upper}_QW ..] must be a unit quaternion (${name}_normalise). */

/* The rotation matrix of q, row by row: v_inertial = R v_body, so its columns are the body's axes in inertial ones.
 * Each entry has an error of at most 4 epsilon. */
void ${name}_matrix(const ${name}_real x[], ${name}_real R[9]);

/* A vector of the body in inertial axes: q v q*.  The two may be the same array.  Its error is at most 16 epsilon |v|. */
void ${name}_rotate(const ${name}_real x[], const ${name}_real body[3], ${name}_real inertial[3]);

/* A vector of inertial axes in those of the body: q* v q.  The two may be the same array.  Error as ${name}_rotate. */
void ${name}_unrotate(const ${name}_real x[], const ${name}_real inertial[3], ${name}_real body[3]);

/* The rotation vector: the axis of the turn times its angle in rad, which is in [0, pi]. */
void ${name}_rotation_vector(const ${name}_real x[], ${name}_real v[3]);

/* Euler angles of a sequence of three axes, "zxz" or "zyx" for example: a turn by angles[0] about the body's first axis,
 * then by angles[1] about its second as it then stands, then by angles[2] about its third.  Angles in rad; the first and
 * the third are in (-pi, pi], the second is in [0, pi] where the first and last letter are equal, and in [-pi/2, pi/2]
 * where they differ.
 * Returns 0; 1 where the second angle is at an end of its range, to rounding: only the sum or the difference of the
 * others is determined there, and angles[2] is 0; 2 if the sequence is none of the twelve, and angles are untouched. */
int ${name}_euler(const ${name}_real x[], const char sequence[], ${name}_real angles[3]);

/* Puts the attitude of these Euler angles into x; the rest of x stays.  Returns 0; 2 if the sequence is none of the
 * twelve, 3 if an angle is not finite: x is untouched then. */
int ${name}_set_euler(${name}_real x[], const char sequence[], const ${name}_real angles[3]);
