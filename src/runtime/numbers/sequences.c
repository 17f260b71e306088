/* sequences.c - Euler angles of the twelve sequences, read from the rotation matrix.
   SPDX-License-Identifier: GPL-3.0-or-later

   Letters i, j and a third axis k with e_i x e_j = s e_k. With R = R_i(first) R_j(second)
   R_c(third):
   - c = i: the column R e_i is (cos second, sin second sin first, -s sin second cos first) on i, j,
     k, and the row of i is (cos second, sin second sin third, s sin second cos third).
   - c = k: the column R e_k is (s sin second, -s cos second sin first, cos second cos first), and
     the row of i is (cos second cos third, -s cos second sin third, s sin second).
   R e_j = R_i(first) e_j where the third angle is 0. */
#include "wide.h"

/* The angles' axes 0, 1, 2: i, j, k. Returns s, or 0 if there is no such sequence. */
static int axes_of(const char *sequence, int *i, int *j, int *k, int *proper) {
  for (int n = 0; n < 3; n++)
    if (sequence[n] < 'x' || sequence[n] > 'z')
      return 0;
  *i = sequence[0] - 'x';
  *j = sequence[1] - 'x';
  *k = 3 - *i - *j;
  *proper = sequence[2] == sequence[0];
  if (sequence[3] != 0 || *i == *j || sequence[2] == sequence[1])
    return 0;
  return (*j - *i + 3) % 3 == 1 ? 1 : -1;
}

int ph_quat_to_euler(const double q[4], const char *sequence, double angles[3]) {
  int i, j, k, proper;
  const int s = axes_of(sequence, &i, &j, &k, &proper);
  if (s == 0)
    return PH_ESEQUENCE;
  ph_wide unit[4], R[9];
  const int status = wide_load_unit(q, unit);
  if (status)
    return status;
  wide_quat_matrix(unit, R);
  const ph_wide first_sin = proper ? R[3 * j + i] : -s * R[3 * j + k];
  const ph_wide first_cos = proper ? -s * R[3 * k + i] : R[3 * k + k];
  const ph_wide third_sin = proper ? R[3 * i + j] : -s * R[3 * i + j];
  const ph_wide third_cos = proper ? s * R[3 * i + k] : R[3 * i + i];
  const ph_wide length = sqrtl(first_sin * first_sin + first_cos * first_cos);
  angles[1] = (double)(proper ? atan2l(length, R[4 * i]) : atan2l(s * R[3 * i + k], length));
  if (length < 0x1p-49L) { /* the rounding of a unit quaternion in double: no direction */
    angles[0] = (double)atan2l(s * R[3 * k + j], R[4 * j]);
    angles[2] = 0;
  } else {
    angles[0] = (double)atan2l(first_sin, first_cos);
    angles[2] = (double)atan2l(third_sin, third_cos);
  }
  return PH_OK;
}

int ph_quat_from_euler(const double angles[3], const char *sequence, double q[4]) {
  int i, j, k, proper;
  if (axes_of(sequence, &i, &j, &k, &proper) == 0)
    return PH_ESEQUENCE;
  if (!wide_finite(3, angles))
    return PH_EFINITE;
  const int axis[3] = {i, j, proper ? i : k};
  ph_wide p[4] = {1, 0, 0, 0};
  for (int n = 0; n < 3; n++) {
    const ph_wide half = (ph_wide)angles[n] / 2;
    ph_wide step[4] = {cosl(half), 0, 0, 0};
    step[1 + axis[n]] = sinl(half);
    wide_quat_multiply(p, step, p);
  }
  return wide_store(4, p, q);
}

int ph_quat_to_vector(const double q[4], double v[3]) {
  ph_wide unit[4];
  const int status = wide_load_unit(q, unit);
  if (status)
    return status;
  const ph_wide sine = wide_norm(unit + 1), angle = 2 * atan2l(sine, fabsl(unit[0]));
  for (int i = 0; i < 3; i++)
    v[i] = sine > 0 ? (double)((unit[0] < 0 ? -angle : angle) * (unit[1 + i] / sine)) : 0;
  return PH_OK;
}
