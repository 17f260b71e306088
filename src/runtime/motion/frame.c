/* frame.c - rates of change seen from the inertial and from the turning frame.
   SPDX-License-Identifier: GPL-3.0-or-later

   The transport theorem and its second application; the four terms are kept apart because that is
   what one wants to see. All vectors are components in the same axes at the same instant, usually
   the body's. */
#include "numbers/wide.h"

static int transport(const double w[3], const double r[3], const double rate[3], int sign,
                     double out[3]) {
  if (!wide_finite(3, w) || !wide_finite(3, r) || !wide_finite(3, rate))
    return PH_EFINITE;
  ph_wide a[3], b[3];
  wide_load(3, w, a);
  wide_load(3, r, b);
  wide_cross(a, b, a);
  for (int i = 0; i < 3; i++)
    a[i] = (ph_wide)rate[i] + sign * a[i];
  return wide_store(3, a, out);
}

int ph_frame_rate_inertial(const double w[3], const double r[3], const double body_rate[3],
                           double inertial_rate[3]) {
  return transport(w, r, body_rate, 1, inertial_rate);
}

int ph_frame_rate_body(const double w[3], const double r[3], const double inertial_rate[3],
                       double body_rate[3]) {
  return transport(w, r, inertial_rate, -1, body_rate);
}

int ph_frame_acceleration(const double w[3], const double w_rate[3], const double r[3],
                          const double r_rate[3], const double r_rate2[3], ph_acceleration *out) {
  const double *const given[5] = {w, w_rate, r, r_rate, r_rate2};
  ph_wide v[5][3], coriolis[3], euler[3], centripetal[3], total[3];
  for (int k = 0; k < 5; k++) {
    if (!wide_finite(3, given[k]))
      return PH_EFINITE;
    wide_load(3, given[k], v[k]);
  }
  wide_cross(v[0], v[3], coriolis);
  wide_cross(v[1], v[2], euler);
  wide_cross(v[0], v[2], centripetal);
  wide_cross(v[0], centripetal, centripetal);
  for (int i = 0; i < 3; i++) {
    coriolis[i] *= 2;
    total[i] = v[4][i] + coriolis[i] + euler[i] + centripetal[i];
  }
  if (!wide_fits(3, coriolis) || !wide_fits(3, euler) || !wide_fits(3, centripetal) ||
      !wide_fits(3, total))
    return PH_ERANGE;
  for (int i = 0; i < 3; i++) {
    out->relative[i] = (double)v[4][i];
    out->coriolis[i] = (double)coriolis[i];
    out->euler[i] = (double)euler[i];
    out->centripetal[i] = (double)centripetal[i];
    out->total[i] = (double)total[i];
  }
  return PH_OK;
}
