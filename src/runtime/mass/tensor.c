/* tensor.c - inertia tensors: about any point, moved, turned, applied, checked.
   SPDX-License-Identifier: GPL-3.0-or-later

   Two roads move the origin. ph_tensor_about starts from the second moments about the centre of
   mass and only adds; ph_tensor_shift is the general formula from one arbitrary point to another,
   whose terms in the centre of mass may cancel (corner to centroid): the sums are formed in long
   double, so what is left is the rounding of the tensor that was given. */
#include "numbers/wide.h"

int ph_tensor_about(const ph_body *b, const double p[3], double tensor[6]) {
  if (!wide_finite(3, p))
    return PH_EFINITE;
  ph_wide d[3], second[6] = {0}, steiner[6];
  for (int i = 0; i < 3; i++)
    d[i] = ((ph_wide)b->com[i] - (ph_wide)p[i]) + (ph_wide)b->com_tail[i];
  wide_add_outer(second, (ph_wide)b->mass, d);
  wide_inertia(second, steiner);
  for (int i = 0; i < 6; i++)
    steiner[i] += (ph_wide)b->tensor[i];
  return wide_store(6, steiner, tensor);
}

/* About the point a, R the centre of mass, both from the old origin:
     I + M (a^2 1 - a a^T) - M (2 a.R 1 - a R^T - R a^T) */
int ph_tensor_shift(const double tensor[6], double mass, const double R[3], const double a[3],
                    double out[6]) {
  if (!wide_finite(6, tensor) || !wide_finite(1, &mass) || !wide_finite(3, R) || !wide_finite(3, a))
    return PH_EFINITE;
  /* row and column of the six entries */
  static const int row[6] = {0, 1, 2, 0, 0, 1}, col[6] = {0, 1, 2, 1, 2, 2};
  ph_wide I[6], wa[3], wR[3];
  wide_load(6, tensor, I);
  wide_load(3, a, wa);
  wide_load(3, R, wR);
  const ph_wide M = (ph_wide)mass, aa = wide_dot(wa, wa), aR = wide_dot(wa, wR);
  for (int k = 0; k < 6; k++) {
    const int i = row[k], j = col[k];
    const ph_wide delta = i == j;
    I[k] += M * (aa * delta - wa[i] * wa[j]);
    I[k] -= M * (2 * aR * delta - wa[i] * wR[j] - wa[j] * wR[i]);
  }
  return wide_store(6, I, out);
}

/* A I A^T: the components of the same tensor in other axes, or of the turned body in the old
   ones. */
int ph_tensor_turn(const double tensor[6], const double q[4], double out[6]) {
  ph_wide s[6], unit[4], A[9];
  if (!wide_finite(6, tensor))
    return PH_EFINITE;
  const int status = wide_load_unit(q, unit);
  if (status)
    return status;
  wide_load(6, tensor, s);
  wide_quat_matrix(unit, A);
  wide_congruence(A, s, s);
  return wide_store(6, s, out);
}

int ph_tensor_momentum(const double tensor[6], const double w[3], double L[3]) {
  if (!wide_finite(6, tensor) || !wide_finite(3, w))
    return PH_EFINITE;
  ph_wide s[6], v[3];
  wide_load(6, tensor, s);
  wide_load(3, w, v);
  wide_apply(s, v, v);
  return wide_store(3, v, L);
}

int ph_tensor_energy(const double tensor[6], const double w[3], double *T) {
  if (!wide_finite(6, tensor) || !wide_finite(3, w))
    return PH_EFINITE;
  ph_wide s[6], v[3], L[3];
  wide_load(6, tensor, s);
  wide_load(3, w, v);
  wide_apply(s, v, L);
  const ph_wide energy = wide_dot(v, L) / 2;
  return wide_store(1, &energy, T);
}

/* Moments A <= B <= C are a body's if A >= 0 and C <= A + B: each is a sum of two of the three
   second moments, which are not negative. size: of what the tensor is the difference of, or 0. */
int wide_tensor_check(const ph_wide tensor[6], ph_wide size) {
  ph_wide moment[3], axis[3][3];
  wide_eigen(tensor, moment, axis);
  /* The entries are doubles that some program computed: each is off by 2^-52 of the trace, which is
     twice the largest moment at most, so the sum of two moments by 9 of that
     (generator/mass/law.lua). */
  const ph_wide slack = 18 * (ph_wide)DBL_EPSILON * fmaxl(fabsl(moment[2]), size);
  if (moment[0] < -slack)
    return PH_EPOSITIVE;
  if (moment[2] > moment[0] + moment[1] + slack)
    return PH_ETRIANGLE;
  return PH_OK;
}

int ph_tensor_check(const double tensor[6]) {
  if (!wide_finite(6, tensor))
    return PH_EFINITE;
  ph_wide s[6];
  wide_load(6, tensor, s);
  return wide_tensor_check(s, 0);
}
