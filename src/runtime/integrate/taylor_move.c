/* taylor_move.c - the series of position and velocity, and of a turning frame.
   SPDX-License-Identifier: GPL-3.0-or-later

   Omega is linear in time, so its series has two terms. The speed s = |v| follows from s s = v.v:
     2 s_0 s_n = (v.v)_n - sum over 0 < k < n of s_k s_{n-k}.
   At rest |v| is no power series, and close to rest its series says nothing of what is further off
   than the rest is: there the step is the extrapolation's, which asks for no derivatives. On a
   straight way the series of |v| goes on through zero as that of v: a step that turns the velocity
   round ends where it does. */
#include "motion/move.h"
#include "taylor.h"

ph_wide taylor_reach(int n, const ph_wide term[], int k, ph_wide bound) {
  const ph_wide size = step_size(n, term);
  return size > 0 ? powl(bound / size, 1.0L / k) : HUGE_VALL;
}

int taylor_drags(const stepper *s) {
  return s->top->effects & PH_TRANSLATION && s->top->effects & PH_DRAG && s->top->move.drag > 0;
}

/* n-th coefficient of Omega x a. */
static void turned(const ph_wide Omega[3], const ph_wide change[3], ph_wide H, ph_wide a[][3],
                   int n, ph_wide out[3]) {
  wide_cross(Omega, a[n], out);
  if (n > 0) {
    ph_wide more[3];
    wide_cross(change, a[n - 1], more);
    for (int i = 0; i < 3; i++)
      out[i] += H * more[i];
  }
}

void taylor_frame(const stepper *s, const series *c, int n, ph_wide H, ph_wide dq[4]) {
  ph_wide Omega[3], change[3], term[4];
  if (!(s->top->effects & PH_FRAME))
    return;
  move_frame(s->top, s->t, Omega, change);
  for (int k = 0; k <= n && k <= 1; k++) {
    const ph_wide *o = k == 0 ? Omega : change, f = k == 0 ? 1 : H;
    const ph_wide pure[4] = {0, f * o[0], f * o[1], f * o[2]};
    wide_quat_multiply(pure, c->q[n - k], term);
    for (int i = 0; i < 4; i++)
      dq[i] -= term[i];
  }
}

/* Coefficient n of the speed from those of v up to n and its own below. */
static void extend_speed(series *c, int n) {
  ph_wide sum = 0;
  for (int k = 0; k <= n; k++)
    sum += wide_dot(c->v[k], c->v[n - k]);
  for (int k = 1; k < n; k++)
    sum -= c->speed[k] * c->speed[n - k];
  if (n == 0)
    c->speed[0] = sqrtl(sum);
  else
    c->speed[n] = c->speed[0] > 0 ? sum / (2 * c->speed[0]) : 0;
}

void taylor_move(const stepper *s, series *c, int n, ph_wide H) {
  ph_wide Omega[3], change[3], a[3], term[3];
  move_loads loads;
  move_load(s->top, &loads);
  move_frame(s->top, s->t, Omega, change);
  for (int i = 0; i < 3; i++)
    a[i] = (n == 0 ? loads.gravity[i] : 0) - loads.stiffness[i] * c->r[n][i] -
           loads.linear * c->v[n][i];
  if (loads.drag > 0) {
    extend_speed(c, n);
    for (int k = 0; k <= n; k++)
      for (int i = 0; i < 3; i++)
        a[i] -= loads.drag * c->speed[k] * c->v[n - k][i];
  }
  if (s->top->effects & PH_FRAME) {
    turned(Omega, change, H, c->v, n, term);
    for (int i = 0; i < 3; i++)
      a[i] -= 2 * term[i];
    wide_cross(change, c->r[n], term);
    for (int i = 0; i < 3; i++)
      a[i] -= term[i];
    ph_wide u[TAYLOR_MAX + 1][3]; /* Omega x r, coefficients n - 1 and n */
    for (int k = n > 0 ? n - 1 : 0; k <= n; k++)
      turned(Omega, change, H, c->r, k, u[k]);
    turned(Omega, change, H, u, n, term);
    for (int i = 0; i < 3 && s->top->move.centrifugal; i++)
      a[i] -= term[i];
  }
  for (int i = 0; i < 3; i++) {
    c->r[n + 1][i] = H / (n + 1) * c->v[n][i];
    c->v[n + 1][i] = H / (n + 1) * a[i];
  }
}

/* Largest term of the series at sigma. */
static ph_wide largest_term(ph_wide a[][3], int order, ph_wide sigma) {
  ph_wide size = 0, power = 1;
  for (int n = 0; n <= order; n++, power *= sigma)
    size = fmaxl(size, step_size(3, a[n]) * power);
  return size;
}

/* What r and v are measured by is their size within the step, which shrinks with it: so the step is
   shortened until it holds. A few rounds do, as the bound falls with a high root of the size. The
   speed's own terms count too: what is rounding in them may hide in the sums that v is made of. */
ph_wide taylor_move_reach(const stepper *s, series *c, int order, ph_wide tolerance,
                          ph_wide longest) {
  const int drags = taylor_drags(s);
  ph_wide sigma = longest;
  for (int round = 0; round < 100; round++) {
    const ph_wide size_r = largest_term(c->r, order, sigma), before = sigma;
    const ph_wide size_v = largest_term(c->v, order, sigma);
    for (int k = order - 2; k <= order; k++) {
      sigma = fminl(sigma, taylor_reach(3, c->r[k], k, tolerance * size_r));
      sigma = fminl(sigma, taylor_reach(3, c->v[k], k, tolerance * size_v));
      if (drags && k < order)
        sigma = fminl(sigma, taylor_reach(1, &c->speed[k], k, tolerance * size_v));
    }
    if (sigma > 0.99L * before)
      break;
  }
  return sigma;
}

/* v(0).v(sigma). */
static ph_wide along(const series *c, int order, ph_wide sigma) {
  ph_wide s = 0;
  for (int n = order; n >= 0; n--)
    s = s * sigma + wide_dot(c->v[0], c->v[n]);
  return s;
}

ph_wide taylor_turn(const stepper *s, const series *c, int order, ph_wide sigma) {
  enum { PARTS = 32, HALVINGS = 70 };
  ph_wide low = 0, high = 0;
  if (!taylor_drags(s))
    return sigma;
  for (int k = 1; k <= PARTS && high == 0; k++) {
    const ph_wide at = sigma * k / PARTS;
    *(along(c, order, at) < 0 ? &high : &low) = at;
  }
  for (int k = 0; k < HALVINGS && high > 0; k++) {
    const ph_wide middle = (low + high) / 2;
    *(along(c, order, middle) < 0 ? &high : &low) = middle;
  }
  return high > 0 ? high : sigma;
}

ph_wide taylor_rest(const stepper *s, const series *c, ph_wide H, ph_wide rate) {
  static const ph_wide NEAR = 0.1L, FIRST = 0.1L, STRIDE = 8;
  if (!taylor_drags(s))
    return 0;
  move_loads loads;
  move_load(s->top, &loads);
  const ph_wide a = step_size(3, c->v[1]) / fabsl(H), v = step_size(3, c->v[0]);
  const ph_wide own = fmaxl(rate, sqrtl(loads.drag * a));
  if (!(a > 0) || v * own > NEAR * a)
    return 0;
  return v > 0 ? fminl(STRIDE * (v / a + LDBL_EPSILON * fabsl(s->t)), FIRST / own) : FIRST / own;
}
