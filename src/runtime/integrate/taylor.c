/* taylor.c - one step by the Taylor series of q and w, of any order, in long double.
   SPDX-License-Identifier: GPL-3.0-or-later

   Every term of the equations is a polynomial in q and w, so the coefficients follow from each
   other by Cauchy products (Jorba and Zou, A software package for the numerical integration of ODEs
   by means of high-order Taylor methods, Exp. Math. 14, 2005):
     (n+1) q_{n+1} = sum q_k (0, w_{n-k}) / 2,
     (n+1) I w_{n+1} = N_n - sum w_k x L_{n-k},   L_n = I w_n.
   Coefficients are kept in units of a time H near the motion's own, x_n H^n, so that neither
   1e30 rad/s nor 1e-30 rad/s leaves the range. The step is the longest for which the last three
   terms stay below the tolerance, |q| being 1 and each component of w measured by its own size: a
   spin about the unstable axis with 1e-100 rad/s across it leaves that axis when its 1e-100 have
   grown, not when a truncation error of 1e-18 has. */
#include "taylor.h"

#include <string.h>

/* n-th coefficient of q* v q for a constant inertial v. */
static void turned(const series *c, int n, const ph_wide v[3], ph_wide out[3]) {
  const ph_wide pure[4] = {0, v[0], v[1], v[2]};
  out[0] = out[1] = out[2] = 0;
  if (step_size(3, v) == 0)
    return;
  for (int k = 0; k <= n; k++) {
    const ph_wide conjugate[4] = {c->q[k][0], -c->q[k][1], -c->q[k][2], -c->q[k][3]};
    ph_wide p[4];
    wide_quat_multiply(conjugate, pure, p);
    wide_quat_multiply(p, c->q[n - k], p);
    for (int i = 0; i < 3; i++)
      out[i] += p[1 + i];
  }
}

/* Coefficients n + 1 of q and w from those up to n, in units of H. */
static int extend(const stepper *s, series *c, int n, ph_wide H) {
  const ph_wide scale = H / (n + 1);
  ph_wide weight[3], inertial[3], b[3], L[3], term[4], dq[4] = {0}, rate[3], gyro[3];
  wide_apply(s->top->wide_second, c->w[n], c->S[n]);
  wide_apply(s->top->wide_inertia, c->w[n], L);
  turned(c, n, s->loads.weight, weight);
  turned(c, n, s->loads.inertial, inertial);
  wide_cross(s->top->wide_com, weight, b);
  wide_cross(s->loads.rotor, c->w[n], gyro);
  for (int i = 0; i < 3; i++) {
    b[i] +=
        inertial[i] + gyro[i] - wide_dot(s->loads.damping + 3 * i, c->w[n]) - s->loads.decay * L[i];
    if (n == 0)
      b[i] += s->loads.body[i];
  }
  for (int k = 0; k <= n; k++) {
    const ph_wide pure[4] = {0, c->w[n - k][0], c->w[n - k][1], c->w[n - k][2]};
    wide_quat_multiply(c->q[k], pure, term);
    for (int i = 0; i < 4; i++)
      dq[i] += term[i];
    wide_cross(c->w[k], c->S[n - k], term); /* - w x I w = w x S w, see motion/motion.c */
    for (int i = 0; i < 3; i++)
      b[i] += term[i];
  }
  /* a rod's torque along itself is looked for by step_rate at the start of each step */
  const int status = motion_solve(s->top, b, -1, rate);
  taylor_frame(s, c, n, H, dq);
  for (int i = 0; i < 4; i++)
    c->q[n + 1][i] = scale * dq[i] / 2;
  for (int i = 0; i < 3; i++)
    c->w[n + 1][i] = scale * rate[i];
  if (s->top->effects & PH_TRANSLATION)
    taylor_move(s, c, n, H);
  return status;
}

int step_taylor(stepper *s, const ph_wide x[], int order, ph_wide tolerance, ph_wide *h,
                ph_wide out[]) {
  const int states = ph_top_states(s->top);
  series c;
  ph_wide rate;
  int status = step_rate(s, x, &rate);
  if (status)
    return status;
  const ph_wide H = tolerance > 0 && rate > 0 ? copysignl(1 / rate, *h) : *h;
  for (int i = 0; i < 4; i++)
    c.q[0][i] = x[i];
  for (int i = 0; i < 3; i++)
    c.w[0][i] = x[4 + i];
  for (int i = 0; i < 3 && states > 7; i++) {
    c.r[0][i] = x[7 + i];
    c.v[0][i] = x[10 + i];
  }
  for (int n = 0; n < order && !status; n++) {
    status = extend(s, &c, n, H);
    const ph_wide near = n == 0 && !status ? taylor_rest(s, &c, H, rate) : 0;
    if (near > 0) { /* fixed steps stay what they are */
      ph_wide next;
      if (tolerance > 0)
        *h = copysignl(fminl(near, fabsl(*h)), *h);
      return step_extrapolate(s, x, tolerance, h, &next, out);
    }
  }
  if (status)
    return status;
  ph_wide sigma = *h / H;
  if (tolerance > 0) {
    ph_wide size[3] = {0, 0,
                       0}; /* of w: the largest coefficient, so that a zero crossing is no zero */
    for (int n = 0; n <= order; n++)
      for (int i = 0; i < 3; i++)
        size[i] = fmaxl(size[i], fabsl(c.w[n][i]));
    for (int k = order - 2; k <= order; k++) {
      sigma = fminl(sigma, taylor_reach(4, c.q[k], k, tolerance));
      for (int i = 0; i < 3; i++)
        sigma = fminl(sigma, taylor_reach(1, &c.w[k][i], k, tolerance * size[i]));
    }
    if (states > 7)
      sigma = taylor_turn(s, &c, order, taylor_move_reach(s, &c, order, tolerance, sigma));
    if (sigma < *h / H)
      *h = sigma * H;
  }
  ph_wide y[PH_STATES];
  for (int i = 0; i < states; i++) {
    y[i] = 0;
    for (int n = order; n >= 0; n--)
      y[i] = y[i] * sigma + (i < 4    ? c.q[n][i]
                             : i < 7  ? c.w[n][i - 4]
                             : i < 10 ? c.r[n][i - 7]
                                      : c.v[n][i - 10]);
  }
  if (!wide_fits(states, y))
    return PH_ERANGE;
  memcpy(out, y, (size_t)states * sizeof y[0]);
  return PH_OK;
}
