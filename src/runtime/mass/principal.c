/* principal.c - principal moments and axes of an inertia tensor.
   SPDX-License-Identifier: GPL-3.0-or-later

   The work is wide_eigen's (numbers/eigen.c); here it is rounded to double. Rounding three
   orthonormal vectors component by component leaves |e_i . e_j - d_ij| <= 2 * 2^-53 = 2.2e-16,
   within the 4e-16 promised. */
#include "numbers/wide.h"

int ph_principal(const double tensor[6], ph_axes *out) {
  if (!wide_finite(6, tensor))
    return PH_EFINITE;
  ph_wide s[6], moment[3], axis[3][3];
  wide_load(6, tensor, s);
  wide_eigen(s, moment, axis);
  if (!wide_fits(3, moment))
    return PH_ERANGE;
  for (int k = 0; k < 3; k++) {
    out->moment[k] = (double)moment[k];
    for (int i = 0; i < 3; i++)
      out->axis[k][i] = (double)axis[k][i];
  }
  return PH_OK;
}
