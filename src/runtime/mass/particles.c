/* particles.c - the sums over particles that define the inertia tensor, energy and angular
   momentum.
   SPDX-License-Identifier: GPL-3.0-or-later

   Each is the definition itself: velocities are formed, v = w x r, and squared; no tensor is used
   where the lecture has none. So T here and w.I.w/2 of ph_tensor_energy are two roads to one
   number. Not here: the body that the particles make (ph_body_points in body.c). */
#include <limits.h>

#include "body.h"

int particles_check(int n, const double m[], const double r[]) {
  if (n < 1 || n > INT_MAX / 3)
    return PH_ECOUNT;
  if (!wide_finite(n, m) || !wide_finite(3 * n, r))
    return PH_EFINITE;
  for (int k = 0; k < n; k++)
    if (!(m[k] > 0))
      return PH_EMASS;
  return PH_OK;
}

int ph_particles_tensor(int n, const double m[], const double r[], double tensor[6]) {
  const int status = particles_check(n, m, r);
  if (status)
    return status;
  ph_wide second[6] = {0}, s[3];
  for (int k = 0; k < n; k++) {
    wide_load(3, r + 3 * k, s);
    wide_add_outer(second, (ph_wide)m[k], s);
  }
  wide_inertia(second, second);
  return wide_store(6, second, tensor);
}

int ph_particles_energy(int n, const double m[], const double r[], const double w[3], double *T) {
  const int status = particles_check(n, m, r);
  if (status)
    return status;
  if (!wide_finite(3, w))
    return PH_EFINITE;
  ph_wide sum = 0, omega[3], s[3], v[3];
  wide_load(3, w, omega);
  for (int k = 0; k < n; k++) {
    wide_load(3, r + 3 * k, s);
    wide_cross(omega, s, v);
    sum += (ph_wide)m[k] * wide_dot(v, v) / 2;
  }
  return wide_store(1, &sum, T);
}

int ph_particles_momentum(int n, const double m[], const double r[], const double w[3],
                          double L[3]) {
  const int status = particles_check(n, m, r);
  if (status)
    return status;
  if (!wide_finite(3, w))
    return PH_EFINITE;
  ph_wide sum[3] = {0}, omega[3], s[3], v[3];
  wide_load(3, w, omega);
  for (int k = 0; k < n; k++) {
    wide_load(3, r + 3 * k, s);
    wide_cross(omega, s, v);
    wide_cross(s, v, v);
    for (int i = 0; i < 3; i++)
      sum[i] += (ph_wide)m[k] * v[i];
  }
  return wide_store(3, sum, L);
}
