/* wide.h - small vectors, symmetric tensors and quaternions in long double.
   SPDX-License-Identifier: GPL-3.0-or-later

   Every public function loads its doubles into ph_wide, computes there, and rounds once on the way
   out. With a mantissa of 64 bits or more a sum of a dozen products is then good to an ulp of
   double at the size of its largest term; with 15 bits of exponent no product of two or three
   doubles overflows or underflows, so nothing is scaled. A result is stored only when it fits a
   double: ph_wide_store reports PH_ERANGE or PH_EFINITE and leaves the output as it was. Not here:
   anything with a physical meaning. Aliasing: outputs may be inputs. */
#ifndef WIDE_H
#define WIDE_H

#include <float.h>
#include <math.h>

#include "polhode.h"

_Static_assert(LDBL_MANT_DIG >= 64, "libpolhode needs a long double of 64 bits or more");
_Static_assert(LDBL_MAX_EXP >= 16384, "libpolhode needs a long double with a wide exponent");

typedef long double ph_wide;

/* Positions in a tensor of six. */
enum { XX, YY, ZZ, XY, XZ, YZ };

static inline void wide_load(int n, const double in[], ph_wide out[]) {
  for (int i = 0; i < n; i++)
    out[i] = (ph_wide)in[i];
}

/* Are all n numbers finite? Public functions ask this first, so that no NaN travels. */
static inline int wide_finite(int n, const double v[]) {
  for (int i = 0; i < n; i++)
    if (!isfinite(v[i]))
      return 0;
  return 1;
}

/* Will v round to a finite double? (NaN never does.) */
static inline int wide_fits(int n, const ph_wide v[]) {
  for (int i = 0; i < n; i++)
    if (!isfinite((double)v[i]))
      return 0;
  return 1;
}

static inline int wide_store(int n, const ph_wide v[], double out[]) {
  if (!wide_fits(n, v))
    return PH_ERANGE;
  for (int i = 0; i < n; i++)
    out[i] = (double)v[i];
  return PH_OK;
}

static inline ph_wide wide_dot(const ph_wide a[3], const ph_wide b[3]) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline ph_wide wide_norm(const ph_wide a[3]) {
  return sqrtl(wide_dot(a, a));
}

static inline void wide_cross(const ph_wide a[3], const ph_wide b[3], ph_wide out[3]) {
  const ph_wide x = a[1] * b[2] - a[2] * b[1];
  const ph_wide y = a[2] * b[0] - a[0] * b[2];
  const ph_wide z = a[0] * b[1] - a[1] * b[0];
  out[0] = x, out[1] = y, out[2] = z;
}

/* Symmetric matrix times vector. */
static inline void wide_apply(const ph_wide s[6], const ph_wide v[3], ph_wide out[3]) {
  const ph_wide x = s[XX] * v[0] + s[XY] * v[1] + s[XZ] * v[2];
  const ph_wide y = s[XY] * v[0] + s[YY] * v[1] + s[YZ] * v[2];
  const ph_wide z = s[XZ] * v[0] + s[YZ] * v[1] + s[ZZ] * v[2];
  out[0] = x, out[1] = y, out[2] = z;
}

/* s += m v v^T: the second moment of mass m at v. */
static inline void wide_add_outer(ph_wide s[6], ph_wide m, const ph_wide v[3]) {
  s[XX] += m * v[0] * v[0], s[YY] += m * v[1] * v[1], s[ZZ] += m * v[2] * v[2];
  s[XY] += m * v[0] * v[1], s[XZ] += m * v[0] * v[2], s[YZ] += m * v[1] * v[2];
}

/* tr(s) 1 - s: inertia from second moments. Sums only on the diagonal, so nothing cancels. */
static inline void wide_inertia(const ph_wide s[6], ph_wide out[6]) {
  const ph_wide xx = s[YY] + s[ZZ], yy = s[XX] + s[ZZ], zz = s[XX] + s[YY];
  out[XX] = xx, out[YY] = yy, out[ZZ] = zz;
  out[XY] = -s[XY], out[XZ] = -s[XZ], out[YZ] = -s[YZ];
}

/* tr(i)/2 1 - i: second moments from inertia. This cancels for slender bodies; see ph_body. */
static inline void wide_second(const ph_wide i[6], ph_wide out[6]) {
  const ph_wide xx = (i[YY] - i[XX] + i[ZZ]) / 2, yy = (i[XX] - i[YY] + i[ZZ]) / 2;
  const ph_wide zz = (i[XX] - i[ZZ] + i[YY]) / 2;
  out[XX] = xx, out[YY] = yy, out[ZZ] = zz;
  out[XY] = -i[XY], out[XZ] = -i[XZ], out[YZ] = -i[YZ];
}

/* A s A^T for a 3x3 matrix A (row major): row by row, as bilinear forms of the rows. */
static inline void wide_congruence(const ph_wide A[9], const ph_wide s[6], ph_wide out[6]) {
  ph_wide sx[3], sy[3], sz[3];
  wide_apply(s, A, sx);
  wide_apply(s, A + 3, sy);
  wide_apply(s, A + 6, sz);
  out[XX] = wide_dot(A, sx), out[YY] = wide_dot(A + 3, sy), out[ZZ] = wide_dot(A + 6, sz);
  out[XY] = wide_dot(A, sy), out[XZ] = wide_dot(A, sz), out[YZ] = wide_dot(A + 3, sz);
}

static inline void wide_quat_multiply(const ph_wide a[4], const ph_wide b[4], ph_wide out[4]) {
  const ph_wide w = a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3];
  const ph_wide x = a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2];
  const ph_wide y = a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1];
  const ph_wide z = a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0];
  out[0] = w, out[1] = x, out[2] = y, out[3] = z;
}

/* The vector part of q v q* (to_inertial) or q* v q, without division by |q|^2. */
static inline void wide_sandwich(const ph_wide q[4], const ph_wide v[3], int to_inertial,
                                 ph_wide out[3]) {
  const ph_wide s = to_inertial ? 1 : -1;
  const ph_wide p[4] = {q[0], s * q[1], s * q[2], s * q[3]};
  const ph_wide c[4] = {q[0], -s * q[1], -s * q[2], -s * q[3]};
  const ph_wide pure[4] = {0, v[0], v[1], v[2]};
  ph_wide t[4];
  wide_quat_multiply(p, pure, t);
  wide_quat_multiply(t, c, t);
  out[0] = t[1], out[1] = t[2], out[2] = t[3];
}

static inline ph_wide wide_quat_norm(const ph_wide q[4]) {
  return sqrtl(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
}

/* Load q as a unit quaternion: PH_EFINITE, PH_EQUATERNION. */
static inline int wide_load_unit(const double q[4], ph_wide out[4]) {
  if (!wide_finite(4, q))
    return PH_EFINITE;
  ph_wide w[4];
  wide_load(4, q, w);
  const ph_wide n = wide_quat_norm(w);
  if (!(n > 0))
    return PH_EQUATERNION;
  for (int i = 0; i < 4; i++)
    out[i] = w[i] / n;
  return PH_OK;
}

/* Rotation matrix of a unit quaternion: the columns are the turned coordinate axes. */
static inline void wide_quat_matrix(const ph_wide q[4], ph_wide R[9]) {
  for (int k = 0; k < 3; k++) {
    const ph_wide e[3] = {k == 0, k == 1, k == 2};
    ph_wide c[3];
    wide_sandwich(q, e, 1, c);
    R[k] = c[0], R[3 + k] = c[1], R[6 + k] = c[2];
  }
}

/* Eigensystem of a symmetric matrix, moments ascending (eigen.c). */
void wide_eigen(const ph_wide s[6], ph_wide moment[3], ph_wide axis[3][3]);

/* Validity of an inertia tensor (mass/tensor.c): PH_OK, PH_EPOSITIVE, PH_ETRIANGLE. The slack is 18
   ulp of the largest moment or of size, the largest number that the tensor was made from. */
int wide_tensor_check(const ph_wide tensor[6], ph_wide size);

/* How many of the moments are zero as far as the data can tell (eigen.c). */
int wide_nullity(const ph_wide tensor[6]);

#endif
