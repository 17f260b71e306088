/* body.c - bodies stored, placed, joined, bored and checked.
   SPDX-License-Identifier: GPL-3.0-or-later

   Everything is the pseudo-inertia (mass, first and second moments) under affine maps and sums,
   kept about the centre of mass: a shift changes only com, so a body 1e9 m away is as exact as one
   at the origin. The centre is a pair com + com_tail, for the same reason: two parts at 1e9 m know
   their distance to 1e-20 m, not 1e-7 m. Joining masses m1, m2 whose centres differ by d adds the
   second moment mu d d^T with the reduced mass mu = m1 m2/(m1 + m2); a hole is the same with m2
   negative. */
#include "body.h"

#include "geometry/geometry.h"

int body_store(ph_body *b, ph_wide mass, const double at[3], const ph_wide off[3],
               const ph_wide second[6], const ph_wide tensor[6]) {
  ph_wide own[6], centre[3];
  if (!tensor) {
    wide_inertia(second, own);
    tensor = own;
  }
  for (int i = 0; i < 3; i++)
    centre[i] = (ph_wide)at[i] + off[i];
  if (!wide_fits(1, &mass) || !wide_fits(3, centre) || !wide_fits(6, second) ||
      !wide_fits(6, tensor))
    return PH_ERANGE;
  if (!((double)mass > 0))
    return PH_EMASS;
  b->mass = (double)mass;
  for (int i = 0; i < 3; i++) {
    const double head = (double)centre[i];
    /* at and head are neighbours or equal, so the difference is exact and the tail keeps off's
     * digits */
    b->com_tail[i] = (double)(((ph_wide)at[i] - (ph_wide)head) + off[i]);
    b->com[i] = head;
  }
  for (int i = 0; i < 6; i++) {
    b->second[i] = (double)second[i];
    b->tensor[i] = (double)tensor[i];
  }
  b->formal = 0;
  return PH_OK;
}

/* The status of making out from bodies one of which is formal, or not. */
static int inherit(ph_body *out, int status, int formal) {
  if (status == PH_OK)
    out->formal = formal;
  return status;
}

/* Relative to the first particle everything is small: its difference to another one is exact in
   long double unless their distance is 2^11 times less than their coordinates' last bit. */
int ph_body_points(ph_body *b, int n, const double m[], const double r[]) {
  const int status = particles_check(n, m, r);
  if (status)
    return status;
  ph_wide mass = 0, centre[3] = {0}, second[6] = {0};
  for (int k = 0; k < n; k++) {
    mass += (ph_wide)m[k];
    for (int i = 0; i < 3; i++)
      centre[i] += (ph_wide)m[k] * ((ph_wide)r[3 * k + i] - (ph_wide)r[i]);
  }
  for (int i = 0; i < 3; i++)
    centre[i] /= mass;
  for (int k = 0; k < n; k++) {
    ph_wide s[3];
    for (int i = 0; i < 3; i++)
      s[i] = ((ph_wide)r[3 * k + i] - (ph_wide)r[i]) - centre[i];
    wide_add_outer(second, (ph_wide)m[k], s);
  }
  return body_store(b, mass, r, centre, second, NULL);
}

/* Set second moments that rounding made negative to zero: the nearest body that can exist. */
static void clear_negative(ph_wide second[6]) {
  ph_wide moment[3], axis[3][3];
  wide_eigen(second, moment, axis);
  for (int k = 0; k < 3; k++)
    if (moment[k] < 0)
      wide_add_outer(second, -moment[k], axis[k]);
}

/* A > 0: all that is asked of a formal tensor, which no mass need have. */
static int definite(const ph_wide tensor[6]) {
  ph_wide moment[3], axis[3][3];
  wide_eigen(tensor, moment, axis);
  return moment[0] > 0;
}

/* A tensor about the centre of mass, or about the origin: Steiner's term m (R^2 1 - R R^T) is then
   taken off, and `size`, the largest entry before, says what rounding may have left of it. */
static int from_tensor(ph_body *b, double mass, const double com[3], const double tensor[6],
                       int about_origin) {
  if (!wide_finite(1, &mass) || !wide_finite(3, com) || !wide_finite(6, tensor))
    return PH_EFINITE;
  if (!(mass > 0))
    return PH_EMASS;
  ph_wide I[6], second[6], size = 0;
  const ph_wide zero[3] = {0, 0, 0};
  wide_load(6, tensor, I);
  if (about_origin) {
    ph_wide R[3], first[6] = {0}, steiner[6];
    wide_load(3, com, R);
    wide_add_outer(first, (ph_wide)mass, R);
    wide_inertia(first, steiner);
    for (int i = 0; i < 6; i++) {
      size = fmaxl(size, fabsl(I[i]));
      I[i] -= steiner[i];
    }
  }
  const int status = wide_tensor_check(I, size);
  if (status)
    return status;
  wide_second(I, second);
  if (about_origin) /* the difference carries the rounding of the tensor that was given */
    clear_negative(second);
  return body_store(b, (ph_wide)mass, com, zero, second, about_origin ? NULL : I);
}

int ph_body_tensor(ph_body *b, double mass, const double com[3], const double tensor[6]) {
  return from_tensor(b, mass, com, tensor, 0);
}

int ph_body_tensor_origin(ph_body *b, double mass, const double com[3], const double tensor[6]) {
  return from_tensor(b, mass, com, tensor, 1);
}

int ph_body_formal(ph_body *b, double mass, const double com[3], const double tensor[6]) {
  if (!wide_finite(1, &mass) || !wide_finite(3, com) || !wide_finite(6, tensor))
    return PH_EFINITE;
  const ph_wide zero[3] = {0, 0, 0};
  ph_wide I[6], second[6];
  wide_load(6, tensor, I);
  if (!definite(I))
    return PH_EPOSITIVE;
  wide_second(I, second);
  return inherit(b, body_store(b, (ph_wide)mass, com, zero, second, I), 1);
}

int ph_body_moments(ph_body *b, double mass, const double com[3], const double sigma[6]) {
  if (!wide_finite(1, &mass) || !wide_finite(3, com) || !wide_finite(6, sigma))
    return PH_EFINITE;
  if (!(mass > 0))
    return PH_EMASS;
  const ph_wide zero[3] = {0, 0, 0};
  ph_wide second[6], moment[3], axis[3][3];
  wide_load(6, sigma, second);
  wide_eigen(second, moment, axis);
  if (moment[0] < -8 * (ph_wide)DBL_EPSILON * fabsl(moment[2])) /* each is rounded */
    return PH_EPOSITIVE;
  for (int i = 0; i < 6; i++)
    second[i] *= (ph_wide)mass;
  return body_store(b, (ph_wide)mass, com, zero, second, NULL);
}

int ph_body_at(ph_body *out, const ph_body *in, const double d[3]) {
  if (!wide_finite(3, d))
    return PH_EFINITE;
  double head[3];
  ph_wide off[3], second[6], tensor[6];
  for (int i = 0; i < 3; i++) {
    const pair sum = pair_sum((ph_wide)in->com[i], (ph_wide)d[i]); /* exactly */
    head[i] = (double)sum.hi;
    if (!isfinite(head[i]))
      return PH_ERANGE;
    off[i] = (sum.hi - (ph_wide)head[i]) + (sum.lo + (ph_wide)in->com_tail[i]);
  }
  wide_load(6, in->second, second);
  wide_load(6, in->tensor, tensor);
  return inherit(out, body_store(out, (ph_wide)in->mass, head, off, second, tensor), in->formal);
}

/* Both tensors are turned, though one follows from the other: see ph_body on which of them is
 * exact. */
int ph_body_turned(ph_body *out, const ph_body *in, const double q[4]) {
  ph_wide unit[4], R[9], centre[3], second[6], tensor[6];
  const double origin[3] = {0, 0, 0};
  const int status = wide_load_unit(q, unit);
  if (status)
    return status;
  wide_quat_matrix(unit, R);
  for (int i = 0; i < 3; i++)
    centre[i] = (ph_wide)in->com[i] + (ph_wide)in->com_tail[i];
  wide_sandwich(unit, centre, 1, centre);
  wide_load(6, in->second, second);
  wide_load(6, in->tensor, tensor);
  wide_congruence(R, second, second);
  wide_congruence(R, tensor, tensor);
  return inherit(out, body_store(out, (ph_wide)in->mass, origin, centre, second, tensor),
                 in->formal);
}

/* A deformation acts on second moments (A S A^T), not on the tensor, which then follows by sums. */
int ph_body_scaled(ph_body *out, const ph_body *in, const double k[3]) {
  if (!wide_finite(3, k))
    return PH_EFINITE;
  ph_wide A[9] = {0}, centre[3], second[6];
  const double origin[3] = {0, 0, 0};
  for (int i = 0; i < 3; i++) {
    if (k[i] == 0)
      return PH_ELENGTH;
    A[4 * i] = (ph_wide)k[i];
    centre[i] = (ph_wide)k[i] * ((ph_wide)in->com[i] + (ph_wide)in->com_tail[i]);
  }
  wide_load(6, in->second, second);
  wide_congruence(A, second, second);
  return inherit(out, body_store(out, (ph_wide)in->mass, origin, centre, second, NULL), in->formal);
}

/* The centre's coordinates are products of doubles and may cancel: a shear can bring a far body
   near. */
int ph_body_affine(ph_body *out, const ph_body *in, const double A[9]) {
  if (!wide_finite(9, A))
    return PH_EFINITE;
  if (!(geometry_determinant(A) > 0))
    return PH_EFLAT;
  ph_wide map[9], off[3], second[6];
  double head[3];
  for (int i = 0; i < 3; i++) {
    pair sum = {0, 0};
    for (int j = 0; j < 3; j++) {
      const ph_wide a = (ph_wide)A[3 * i + j];
      sum = pair_add(sum, pair_product(a, (ph_wide)in->com[j]));
      sum = pair_add(sum, pair_product(a, (ph_wide)in->com_tail[j]));
    }
    head[i] = (double)sum.hi;
    if (!isfinite(head[i]))
      return PH_ERANGE;
    off[i] = (sum.hi - (ph_wide)head[i]) + sum.lo;
  }
  wide_load(9, A, map);
  wide_load(6, in->second, second);
  wide_congruence(map, second, second);
  return inherit(out, body_store(out, (ph_wide)in->mass, head, off, second, NULL), in->formal);
}

/* out = a + sign b. Parallel axes for both at once: (ma mb/M) d d^T is Steiner's term of a and of b
   about the common centre, a sum of positive terms for a union. */
static int join(ph_body *out, const ph_body *a, const ph_body *b, int sign) {
  const ph_wide ma = (ph_wide)a->mass, mb = sign * (ph_wide)b->mass, mass = ma + mb;
  if (!(mass > 0))
    return PH_EHOLE;
  ph_wide d[3], off[3], second[6], apart[6] = {0}, tensor[6];
  for (int i = 0; i < 3; i++) {
    d[i] = ((ph_wide)b->com[i] - (ph_wide)a->com[i]) +
           ((ph_wide)b->com_tail[i] - (ph_wide)a->com_tail[i]);
    off[i] = (ph_wide)a->com_tail[i] + mb / mass * d[i];
  }
  wide_add_outer(apart, ma / mass * mb, d);
  wide_inertia(apart, tensor);
  for (int i = 0; i < 6; i++) {
    second[i] = ((ph_wide)a->second[i] + sign * (ph_wide)b->second[i]) + apart[i];
    tensor[i] += (ph_wide)a->tensor[i] + sign * (ph_wide)b->tensor[i];
  }
  /* A hole within a leaves non-negative second moments, up to the rounding of a's. Those that are
     zero for both (plates, rods) are zero in the difference, exactly. */
  const int formal = a->formal || b->formal;
  if (sign < 0 && !formal) {
    ph_wide moment[3], axis[3][3];
    wide_eigen(second, moment, axis);
    const ph_wide size = (ph_wide)a->second[XX] + (ph_wide)a->second[YY] + (ph_wide)a->second[ZZ];
    if (moment[0] < -8 * (ph_wide)DBL_EPSILON * size)
      return PH_EHOLE;
  }
  return inherit(out, body_store(out, mass, a->com, off, second, tensor), formal);
}

int ph_body_add(ph_body *out, const ph_body *a, const ph_body *b) {
  return join(out, a, b, 1);
}

int ph_body_subtract(ph_body *out, const ph_body *a, const ph_body *hole) {
  return join(out, a, hole, -1);
}

int ph_body_check(const ph_body *b) {
  if (!wide_finite(1, &b->mass) || !wide_finite(3, b->com) || !wide_finite(3, b->com_tail) ||
      !wide_finite(6, b->second) || !wide_finite(6, b->tensor))
    return PH_EFINITE;
  if (!(b->mass > 0))
    return PH_EMASS;
  if (!b->formal)
    return ph_tensor_check(b->tensor);
  ph_wide I[6];
  wide_load(6, b->tensor, I);
  return definite(I) ? PH_OK : PH_EPOSITIVE;
}
