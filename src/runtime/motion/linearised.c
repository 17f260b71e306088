/* linearised.c - small oscillations of the free top as a motion: rates and attitude of first order.
   SPDX-License-Identifier: GPL-3.0-or-later

   The spin w about the principal axis k that it is nearest to is kept; the transverse rates obey
       w_i' = -a w_j,  w_j' = b w_i,  a = (Ik - Ij)/Ii w,  b = (Ik - Ii)/Ij w  (i, j, k cyclic).
   The attitude is what these rates and L = I w, fixed in space, ask for, by finite rotations: with
   the polar angles theta, chi of L in the body and n its direction at the start
       (about n by phi) (about k x n by theta0 - theta) (about k by chi0 - chi),
       phi' cos(theta) = w + chi'
   which is solved without dividing by either sine or cosine: with s the sign of w
       phi = s (w t + chi - chi0) + J/(|L| + |Lk|),  J = integral of Ii w_i^2 + Ij w_j^2.
   |L| is taken as constant in the last term alone, which is of second order, and where the
   transverse moments are equal it is: there, and for a pure spin, the motion is exact. chi, the
   polar angle of (Ii w_i, Ij w_j), turns with the oscillation but for a part within +-pi/2; where
   the spin is not stable it stays within half a turn. */
#include <string.h>

#include "numbers/wide.h"

/* The problem in the frame i, j, k. */
typedef struct spin {
  ph_wide axis[3][3], moment[3], w[3];
} spin;

/* The frame: k is the principal axis nearest to w; in the plane of two equal moments every axis is
   principal, and the one of w's own part is taken. Moments are equal when their doubles are. */
static void frame(const ph_top *top, const ph_wide w[3], spin *s) {
  ph_wide v[3], e[3][3];
  int k = 0, equal[3];
  memcpy(e, top->wide_axis, sizeof e);
  for (int n = 0; n < 3; n++)
    equal[n] = (double)top->wide_moment[n] == (double)top->wide_moment[(n + 1) % 3];
  if (equal[0] && equal[1]) { /* a sphere: k is w's direction */
    const ph_wide size = wide_norm(w);
    for (int i = 0; i < 3 && size > 0; i++)
      e[0][i] = w[i] / size;
    if (size > 0) {                          /* any direction across */
      const int far = fabsl(e[0][0]) < 0.6L; /* of the x axis, else of the y axis */
      const ph_wide unit[3] = {far, !far, 0};
      wide_cross(e[0], unit, e[1]);
      const ph_wide n = wide_norm(e[1]);
      for (int i = 0; i < 3; i++)
        e[1][i] /= n;
    }
  } else
    for (int p = 0; p < 2; p++) {
      const ph_wide x = wide_dot(w, e[p]), y = wide_dot(w, e[p + 1]), r = hypotl(x, y);
      if (!equal[p] || r == 0)
        continue;
      for (int i = 0; i < 3; i++) {
        const ph_wide along = (x * e[p][i] + y * e[p + 1][i]) / r;
        e[p + 1][i] = (x * e[p + 1][i] - y * e[p][i]) / r;
        e[p][i] = along;
      }
    }
  wide_cross(e[0], e[1], e[2]);
  for (int n = 0; n < 3; n++)
    v[n] = wide_dot(w, e[n]);
  for (int n = 1; n < 3; n++)
    if (fabsl(v[n]) > fabsl(v[k]))
      k = n;
  for (int n = 0; n < 3; n++) {
    const int from = (k + 1 + n) % 3;
    memcpy(s->axis[n], e[from], sizeof e[from]);
    s->moment[n] = (ph_wide)(double)top->wide_moment[from];
    s->w[n] = v[from];
  }
}

/* 0 stays 0, however large c has become: a pure spin is kept for ever. */
static ph_wide times(ph_wide c, ph_wide w) {
  return w == 0 ? 0 : c * w;
}

/* sin(x t)/x, which is t at x = 0. */
static ph_wide sine(ph_wide x, ph_wide t) {
  return x * t == 0 ? t : sinl(x * t) / x;
}

/* The transverse part of a motion: rates and angular momentum at the start and at t, and what lies
   between. */
typedef struct transverse {
  ph_wide w0[2], w[2], L0[2], L[2];
  ph_wide turn;     /* chi - chi0 */
  ph_wide integral; /* J */
} transverse;

/* Of the oscillation's ellipse (Ii w_i, Ij w_j): the polar angle less the phase. A, B > 0: the
   squares of its axes. */
static ph_wide ahead(ph_wide A, ph_wide B, ph_wide li, ph_wide lj) {
  return atan2l((sqrtl(B) - sqrtl(A)) * li * lj, sqrtl(B) * li * li + sqrtl(A) * lj * lj);
}

static transverse solve(ph_wide Ii, ph_wide Ij, ph_wide Ik, const ph_wide v0[3], ph_wide t) {
  const ph_wide w = v0[2];
  const ph_wide a = Ii > 0 ? (Ik - Ij) / Ii * w : 0, b = Ij > 0 ? (Ik - Ii) / Ij * w : 0;
  const ph_wide square = a * b, rate = sqrtl(fabsl(a)) * sqrtl(fabsl(b));
  ph_wide c = 1, s = t; /* cos(rate t), sin(rate t)/rate, or hyperbolic */
  if (square > 0) {
    c = cosl(rate * t);
    s = sine(rate, t);
  } else if (square < 0) {
    c = coshl(rate * t);
    s = sinhl(rate * t) / rate;
  }
  const ph_wide x = v0[0], y = v0[1];
  transverse m = {.w0 = {x, y}};
  m.w[0] = times(c, x) - times(a * s, y);
  m.w[1] = times(c, y) + times(b * s, x);
  if (x == 0 && y == 0)
    return m;
  /* a rod's line is that of a very thin body, so that L has a direction across k */
  const ph_wide least = Ik * LDBL_EPSILON * LDBL_EPSILON;
  const ph_wide moment[2] = {fmaxl(Ii, least), fmaxl(Ij, least)};
  for (int i = 0; i < 2; i++) {
    m.L0[i] = moment[i] * m.w0[i];
    m.L[i] = moment[i] * m.w[i];
  }
  if (square > 0) {
    const ph_wide A = fabsl(a) * Ii / Ij, B = fabsl(b) * Ij / Ii;
    m.turn = copysignl(rate, a) * t + ahead(A, B, m.L[0], m.L[1]) - ahead(A, B, m.L0[0], m.L0[1]);
  } else
    m.turn = atan2l(m.L0[0] * m.L[1] - m.L0[1] * m.L[0], m.L0[0] * m.L[0] + m.L0[1] * m.L[1]);
  /* integrals of c^2, c s, s^2; the last from c^2 + square s^2 = 1 or, for a short time, by its
     series */
  const ph_wide z = square * t * t, cc = (t + c * s) / 2, cs = s * s / 2;
  const ph_wide ss = fabsl(z) < 1e-4L ? t * t * t * (1.0L / 3 - z / 15 + 2 * z * z / 315)
                                      : (t - c * s) / 2 / square;
  m.integral = Ii * (x * x * cc - 2 * a * x * y * cs + a * a * y * y * ss) +
               Ij * (y * y * cc + 2 * b * x * y * cs + b * b * x * x * ss);
  return m;
}

/* The rotation by `angle` about the vector v of any length; v = 0: none. */
static void rotation(ph_wide angle, const ph_wide v[3], ph_wide q[4]) {
  const ph_wide size = wide_norm(v), f = size > 0 ? sinl(angle / 2) / size : 0;
  q[0] = size > 0 ? cosl(angle / 2) : 1;
  for (int i = 0; i < 3; i++)
    q[1 + i] = f * v[i];
}

/* The attitude at t in the frame i, j, k of the start. */
static void attitude(const spin *s, const transverse *m, ph_wide t, ph_wide out[4]) {
  const ph_wide w = s->w[2], L[3] = {m->L0[0], m->L0[1], s->moment[2] * w}, size = wide_norm(L);
  const ph_wide both = size + fabsl(L[2]), axial = w * t + m->turn;
  const ph_wide phi = (w < 0 ? -axial : axial) + (both > 0 ? m->integral / both : 0);
  const ph_wide tilt = atan2l(hypotl(L[0], L[1]), L[2]) - /* theta0 - theta */
                       atan2l(hypotl(m->L[0], m->L[1]), L[2]);
  const ph_wide across[3] = {-L[1], L[0], 0}, along[3] = {0, 0, 1};
  ph_wide r[4];
  rotation(phi, L, out);
  rotation(tilt, across, r);
  wide_quat_multiply(out, r, out);
  rotation(-m->turn, along, r);
  wide_quat_multiply(out, r, out);
}

int ph_top_linearised(const ph_top *top, const double x0[7], double t, double x[7]) {
  ph_wide q0[4], w0[3];
  if (!isfinite(t) || !wide_finite(3, x0 + 4))
    return PH_EFINITE;
  const int status = wide_load_unit(x0, q0);
  if (status)
    return status;
  if (top->effects)
    return PH_EMETHOD;
  wide_load(3, x0 + 4, w0);
  spin s = {0};
  frame(top, w0, &s);
  const transverse m = solve(s.moment[0], s.moment[1], s.moment[2], s.w, (ph_wide)t);
  ph_wide local[4], body[4] = {0}, out[7];
  attitude(&s, &m, (ph_wide)t, local);
  body[0] = local[0];
  for (int n = 0; n < 3; n++)
    for (int i = 0; i < 3; i++)
      body[1 + i] += local[1 + n] * s.axis[n][i];
  wide_quat_multiply(q0, body, out);
  for (int i = 0; i < 3; i++)
    out[4 + i] = m.w[0] * s.axis[0][i] + m.w[1] * s.axis[1][i] + s.w[2] * s.axis[2][i];
  return wide_store(7, out, x);
}
