/* linearised.c - small oscillations of the free top as a motion: rates and attitude of first order.
   SPDX-License-Identifier: GPL-3.0-or-later

   The spin w about the principal axis k that it is nearest to is kept; the transverse rates obey
       w_i' = -a w w_j,  w_j' = b w w_i,  a = (Ik - Ij)/Ii,  b = (Ik - Ii)/Ij  (i, j, k cyclic).
   The attitude is q0, a turn w t about k, and a small rotation p (body axes, across k). To first
   order in p and in the transverse rates, w = w k + p' + w k x p; the same follows without an
   integral from L being fixed in space: R(-w t) L0 - L(t) = Ik w p x k for the transverse parts of
   L = I w. Where Ik is small that is a quotient of small numbers, so with Omega^2 = a b w^2 > 0 the
   differences of the two frequencies are formed by
       w^2 - Omega^2 = w^2 Ik (Ii + Ij - Ik)/(Ii Ij)
   and Ik cancels: a rod about its own line (Ik = 0) is exact. Where Omega^2 <= 0 the axis is the
   middle one or one of two equal, and Ik is at least half of the largest moment. */
#include <string.h>

#include "wide.h"

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
  const ph_wide Ii = s.moment[0], Ij = s.moment[1], Ik = s.moment[2], T = (ph_wide)t;
  const ph_wide wi = s.w[0], wj = s.w[1], w = s.w[2];
  const ph_wide a = Ii > 0 ? (Ik - Ij) / Ii * w : 0, b = Ij > 0 ? (Ik - Ii) / Ij * w : 0;
  const ph_wide rate = sqrtl(fabsl(a)) * sqrtl(fabsl(b));
  ph_wide c = 1, sn = T; /* cos(rate t), sin(rate t)/rate */
  if (a * b > 0) {
    c = cosl(rate * T);
    sn = sine(rate, T);
  } else if (a * b < 0) {
    c = coshl(rate * T);
    sn = sinhl(rate * T) / rate;
  }
  const ph_wide v[3] = {times(c, wi) - times(a * sn, wj), times(c, wj) + times(b * sn, wi), w};
  /* R(-w t) L0 - L(t), divided by Ik w */
  const ph_wide cw = cosl(w * T), sw = sinl(w * T);
  ph_wide di = 0, dj = 0;
  if (a * b > 0) {
    /* |w| - rate = Ik g;  (cos wt - cos rate t)/Ik = -2 sin((|w| + rate) t/2) sin(Ik g t/2)/Ik */
    const ph_wide u = fabsl(w), sign = w > 0 ? 1 : -1;
    const ph_wide g = u * u * (Ii + Ij - Ik) / Ii / Ij / (u + rate), half = (u + rate) * T / 2;
    const ph_wide lag = g * sine(Ik * g / 2, T); /* 2 sin(Ik g t/2)/Ik */
    const ph_wide dc = -sinl(half) * lag;
    const ph_wide ds = sign * (cosl(half) * lag - g * sn); /* (sin wt - w sin(rate t)/rate)/Ik */
    di = (Ii * wi * dc + wj * (Ij * ds + w * sn)) / w;
    dj = (Ij * wj * dc - wi * (Ii * ds + w * sn)) / w;
  } else if (w != 0) {
    di = (cw * Ii * wi + sw * Ij * wj - Ii * v[0]) / Ik / w;
    dj = (cw * Ij * wj - sw * Ii * wi - Ij * v[1]) / Ik / w;
  }
  /* p x k = (p_j, -p_i) = (di, dj) */
  const ph_wide p[3] = {-dj, di, 0}, angle = hypotl(p[0], p[1]);
  const ph_wide turn[4] = {cosl(w * T / 2), 0, 0, sinl(w * T / 2)};
  const ph_wide f = angle > 0 ? sinl(angle / 2) / angle : 0;
  const ph_wide tilt[4] = {cosl(angle / 2), f * p[0], f * p[1], 0};
  ph_wide local[4], body[4] = {0}, out[7];
  wide_quat_multiply(turn, tilt, local);
  body[0] = local[0];
  for (int n = 0; n < 3; n++)
    for (int i = 0; i < 3; i++)
      body[1 + i] += local[1 + n] * s.axis[n][i];
  wide_quat_multiply(q0, body, out);
  for (int i = 0; i < 3; i++)
    out[4 + i] = v[0] * s.axis[0][i] + v[1] * s.axis[1][i] + v[2] * s.axis[2][i];
  return wide_store(7, out, x);
}
