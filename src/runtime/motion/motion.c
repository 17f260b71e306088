/* motion.c - torque, equations of motion, energy and angular momentum of the general top.
   SPDX-License-Identifier: GPL-3.0-or-later

   I w' = N - w x I w about the fixed origin, body axes (Euler 1758; Goldstein, Classical
   Mechanics, 5.5), with the full tensor: no principal axes are assumed, and the system is solved
   through the principal system that ph_top_init found. With the second moments S, I = tr(S) 1 - S,
   the gyroscopic term is -w x I w = w x S w: what all moments have in common is not there to
   cancel, so a needle of 1e-30 keeps its digits. q' = q (0, w)/2 for the attitude. Vectors fixed in
   inertial axes come to body axes by the polynomial q* v q. A rotor of constant relative momentum h
   (gyrostat; Volterra 1899) adds -w x h to N and h to L. */
#include "motion.h"

#include "acts/acts.h"
#include "move.h"

void motion_load(const ph_top *top, const double u[3], motion_loads *loads) {
  *loads = (motion_loads){0};
  acts_load(top, u, loads);
}

/* N, and a size against which a torque along a rod is rounding: it bounds the terms of I w' = N - w
   x I w, product by product, so that a weight which turns the rod hard, but not about itself, or a
   rate along it, leaves no residue that counts. */
static void torque_of(const ph_top *top, const motion_loads *loads, ph_wide t, const ph_wide x[],
                      ph_wide N[3], ph_wide *size) {
  const ph_wide *q = x, *w = x + 4;
  ph_wide weight[3], inertial[3], L[3], gravity[3], turning[3], D[6], Dw[3], sum = 0;
  wide_sandwich(q, loads->weight, 0, weight);
  wide_sandwich(q, loads->inertial, 0, inertial);
  wide_apply(top->wide_inertia, w, L);
  if (loads->decay != 0 && acts_locked(top, x, D)) {
    wide_apply(D, w, Dw);
    for (int i = 0; i < 3; i++)
      L[i] += Dw[i];
  }
  wide_cross(top->wide_com, weight, gravity);
  wide_cross(loads->rotor, w, turning);
  for (int i = 0; i < 3; i++) {
    const ph_wide drag = wide_dot(loads->damping + 3 * i, w);
    N[i] = gravity[i] + inertial[i] + loads->body[i] + turning[i] - drag - loads->decay * L[i];
    sum += fabsl(inertial[i]) + fabsl(loads->body[i]);
    for (int k = 0; k < 3; k++)
      sum += fabsl(loads->damping[3 * i + k] * w[k]);
  }
  *size = sum + wide_norm(top->wide_com) * wide_norm(weight) + wide_norm(w) * wide_norm(L) +
          (wide_norm(loads->rotor) + fabsl(loads->decay) * top->wide_moment[2]) * wide_norm(w);
  acts_torque(top, t, x, N, size);
}

ph_wide motion_torque_size(const ph_top *top, const motion_loads *loads, ph_wide t,
                           const ph_wide x[]) {
  ph_wide N[3], size;
  torque_of(top, loads, t, x, N, &size);
  return size;
}

/* w' = sum over principal axes of e (e.b)/I: for a rod the pseudo-inverse, since an axis without
   moment takes no part. For a torque along it there is no motion at all that Newton's law
   allows. */
int motion_solve(const ph_top *top, const ph_wide b[3], ph_wide size, ph_wide w_rate[3]) {
  ph_wide sum[3] = {0, 0, 0};
  for (int k = 0; k < 3; k++) {
    const ph_wide along = wide_dot(top->wide_axis[k], b);
    if (top->wide_moment[k] > 0)
      for (int i = 0; i < 3; i++)
        sum[i] += along / top->wide_moment[k] * top->wide_axis[k][i];
    else if (size >= 0 && fabsl(along) > 32 * (ph_wide)DBL_EPSILON * size)
      return PH_EROD;
  }
  for (int i = 0; i < 3; i++)
    w_rate[i] = sum[i];
  return PH_OK;
}

int motion_rates(const ph_top *top, const motion_loads *loads, ph_wide t, const ph_wide x[],
                 ph_wide dx[]) {
  const ph_wide *w = x + 4;
  ph_wide pure[4] = {0, 0, 0, 0}; /* the rate at which the axes turn */
  ph_wide b[3], S[3], size;
  torque_of(top, loads, t, x, b, &size);
  wide_apply(top->wide_second, w, S);
  wide_cross(w, S, S);
  for (int i = 0; i < 3; i++)
    b[i] += S[i];
  ph_wide rate[PH_STATES];
  const effect_at bound = acts_constraint(top, t, x);
  int status = PH_OK;
  if (bound.act)
    status = bound.act->effect->constrain(&bound, b, rate);
  else if (acts_coupled(top))
    status = acts_solve(top, t, x, b, rate);
  else
    status = motion_solve(top, b, size, rate + 4);
  if (status)
    return status;
  acts_rates(top, t, x, rate);
  acts_slip(top, x, pure + 1);
  for (int i = 0; i < 3; i++)
    pure[1 + i] += w[i];
  wide_quat_multiply(x, pure, rate);
  for (int i = 0; i < 4; i++)
    rate[i] /= 2;
  move_rates(top, t, x, rate);
  for (int i = 0; i < ph_top_states(top); i++)
    dx[i] = rate[i];
  return PH_OK;
}

/* ---- public ---- */

/* Control counts only when it is on: then it must be finite. */
static int inputs_finite(const ph_top *top, const double x[], const double u[3]) {
  return wide_finite(ph_top_states(top), x) &&
         (!u || !(top->effects & PH_CONTROL) || wide_finite(3, u));
}

int ph_top_torque(const ph_top *top, double t, const double x[], const double u[3], double N[3]) {
  if (!isfinite(t) || !inputs_finite(top, x, u))
    return PH_EFINITE;
  motion_loads loads;
  ph_wide state[PH_STATES], torque[3], size;
  wide_load(ph_top_states(top), x, state);
  motion_load(top, u, &loads);
  torque_of(top, &loads, (ph_wide)t, state, torque, &size);
  return wide_store(3, torque, N);
}

int ph_top_rates(const ph_top *top, double t, const double x[], const double u[3], double dx[]) {
  if (!isfinite(t) || !inputs_finite(top, x, u))
    return PH_EFINITE;
  motion_loads loads;
  ph_wide state[PH_STATES], rate[PH_STATES];
  wide_load(ph_top_states(top), x, state);
  motion_load(top, u, &loads);
  const int status = motion_rates(top, &loads, (ph_wide)t, state, rate);
  return status ? status : wide_store(ph_top_states(top), rate, dx);
}

int ph_top_contact(const ph_top *top, double t, const double x[], const double u[3],
                   ph_contact *out) {
  if (!isfinite(t) || !inputs_finite(top, x, u))
    return PH_EFINITE;
  motion_loads loads;
  ph_wide state[PH_STATES], rate[PH_STATES];
  wide_load(ph_top_states(top), x, state);
  const effect_at e = acts_constraint(top, (ph_wide)t, state);
  if (!e.act)
    return PH_EMETHOD;
  motion_load(top, u, &loads);
  const int status = motion_rates(top, &loads, (ph_wide)t, state, rate);
  return status ? status : e.act->effect->contact(&e, rate, out);
}

int ph_top_inverse_at(const ph_top *top, double t, const double x[], const double w_rate[3],
                      double N[3]) {
  ph_wide state[PH_STATES], rate[3], torque[3];
  if (!isfinite(t) || !wide_finite(ph_top_states(top), x) || !wide_finite(3, w_rate))
    return PH_EFINITE;
  wide_load(ph_top_states(top), x, state);
  wide_load(3, w_rate, rate);
  acts_inverse(top, (ph_wide)t, state, rate, torque);
  return wide_store(3, torque, N);
}

int ph_top_inverse(const ph_top *top, const double w[3], const double w_rate[3], double N[3]) {
  if (!wide_finite(3, w) || !wide_finite(3, w_rate))
    return PH_EFINITE;
  ph_wide omega[3], S[3], turning[3], rate[3];
  wide_load(3, w, omega);
  wide_load(3, w_rate, rate);
  wide_apply(top->wide_second, omega, S);
  wide_cross(omega, S, turning);
  wide_apply(top->wide_inertia, rate, rate);
  for (int i = 0; i < 3; i++)
    rate[i] -= turning[i];
  return wide_store(3, rate, N);
}

static ph_wide kinetic(const ph_top *top, const ph_wide x[]) {
  ph_wide L[3];
  wide_apply(top->wide_inertia, x + 4, L);
  return wide_dot(x + 4, L) / 2 + move_kinetic(top, x) + acts_kinetic(top, x);
}

static ph_wide potential(const ph_top *top, const ph_wide x[]) {
  return acts_add_potential(top, x, move_potential(top, x) + acts_potential(top, x));
}

int ph_top_kinetic(const ph_top *top, const double x[], double *T) {
  ph_wide state[PH_STATES];
  if (!wide_finite(ph_top_states(top), x))
    return PH_EFINITE;
  wide_load(ph_top_states(top), x, state);
  const ph_wide value = kinetic(top, state);
  return wide_store(1, &value, T);
}

int ph_top_potential(const ph_top *top, const double x[], double *V) {
  ph_wide state[PH_STATES];
  if (!wide_finite(ph_top_states(top), x))
    return PH_EFINITE;
  wide_load(ph_top_states(top), x, state);
  const ph_wide value = potential(top, state);
  return wide_store(1, &value, V);
}

int ph_top_energy(const ph_top *top, const double x[], double *E) {
  ph_wide state[PH_STATES];
  if (!wide_finite(ph_top_states(top), x))
    return PH_EFINITE;
  wide_load(ph_top_states(top), x, state);
  const ph_wide value = kinetic(top, state) + potential(top, state);
  return wide_store(1, &value, E);
}

static int momentum(const ph_top *top, const double x[], int to_inertial, double L[3]) {
  ph_wide state[PH_STATES], v[3];
  if (!wide_finite(ph_top_states(top), x))
    return PH_EFINITE;
  wide_load(ph_top_states(top), x, state);
  acts_whole(top, state, v);
  if (to_inertial)
    wide_sandwich(state, v, 1, v);
  return wide_store(3, v, L);
}

int ph_top_momentum_body(const ph_top *top, const double x[], double L[3]) {
  return momentum(top, x, 0, L);
}

int ph_top_momentum(const ph_top *top, const double x[], double L[3]) {
  return momentum(top, x, 1, L);
}
