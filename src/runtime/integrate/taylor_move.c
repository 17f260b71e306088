/* taylor_move.c - the series of position and velocity, and of a turning frame.
   SPDX-License-Identifier: GPL-3.0-or-later

   Omega is linear in time, so its series has two terms. The speed s = |v| follows from s s = v.v:
     2 s_0 s_n = (v.v)_n - sum over 0 < k < n of s_k s_{n-k},
   and where v starts with its m-th coefficient, m > 0, |v| is H^m times such a series of v/H^m. On
   the way of a stone thrown straight up |v| v is not analytic at the top: the radius of convergence
   shrinks to nothing there. Steps shorter than 1e-7 of sqrt(m/(drag |a|)), the time in which drag
   changes anything, are therefore left to the classical method of order 4, which errs by (1e-7)^3
   of the speed that belongs to that time when it steps over the top. On an exactly straight way the
   series of |v| goes on through zero as that of v: such a step ends at the zero. */
#include "motion/move.h"
#include "taylor.h"

ph_wide taylor_reach(int n, const ph_wide term[], int k, ph_wide bound) {
  const ph_wide size = step_size(n, term);
  return size > 0 ? powl(bound / size, 1.0L / k) : HUGE_VALL;
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
  int m = 0;
  while (m <= n && step_size(3, c->v[m]) == 0)
    m++;
  c->speed[n] = 0;
  if (m > n)
    return;
  ph_wide sum = 0;
  for (int k = m; k <= n; k++)
    sum += wide_dot(c->v[k], c->v[n + m - k]);
  if (n == m) {
    c->speed[n] = sqrtl(sum);
    return;
  }
  for (int k = m + 1; k < n; k++)
    sum -= c->speed[k] * c->speed[n + m - k];
  c->speed[n] = sum / (2 * c->speed[m]);
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
   shortened until it holds. A few rounds do, as the bound falls with a high root of the size. */
ph_wide taylor_move_reach(series *c, int order, ph_wide tolerance, ph_wide longest) {
  ph_wide sigma = longest;
  for (int round = 0; round < 100; round++) {
    const ph_wide size_r = largest_term(c->r, order, sigma), before = sigma;
    const ph_wide size_v = largest_term(c->v, order, sigma);
    for (int k = order - 2; k <= order; k++) {
      sigma = fminl(sigma, taylor_reach(3, c->r[k], k, tolerance * size_r));
      sigma = fminl(sigma, taylor_reach(3, c->v[k], k, tolerance * size_v));
    }
    if (sigma > 0.99L * before)
      break;
  }
  return sigma;
}

static ph_wide speed_at(const series *c, int order, ph_wide sigma) {
  ph_wide s = 0;
  for (int n = order - 1; n >= 0; n--) /* the speed has one coefficient less than v */
    s = s * sigma + c->speed[n];
  return s;
}

ph_wide taylor_turn(const stepper *s, const series *c, int order, ph_wide sigma) {
  if (!(s->top->effects & PH_DRAG) || !(s->top->move.drag > 0) || !(c->speed[0] > 0))
    return sigma;
  ph_wide low = 0, high = 0;
  for (int k = 1; k <= 32 && high == 0; k++) {
    if (speed_at(c, order, sigma * k / 32) <= 0)
      high = sigma * k / 32;
    else
      low = sigma * k / 32;
  }
  if (high == 0)
    return sigma;
  for (int k = 0; k < 70; k++) {
    const ph_wide middle = (low + high) / 2;
    if (speed_at(c, order, middle) <= 0)
      high = middle;
    else
      low = middle;
  }
  return high;
}

ph_wide taylor_least(const stepper *s, const series *c, ph_wide H) {
  move_loads loads;
  move_load(s->top, &loads);
  const ph_wide a = step_size(3, c->v[1]) / fabsl(H);
  return loads.drag > 0 && a > 0 ? 1e-7L / sqrtl(loads.drag * a) : 0;
}
