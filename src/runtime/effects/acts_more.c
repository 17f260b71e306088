/* acts_more.c - gravity gradient, sunlight, moving support, moving parts, energy sink.
   SPDX-License-Identifier: GPL-3.0-or-later

   What v[] of an act holds: PH_GRADIENT mu, radius or half axis, eccentricity (flag: elliptic, the
   true anomaly is its state); PH_SOLAR pressure, unit vector to the sun; PH_PIVOT amplitude, rate,
   unit axis (flag), or torque[] holds the acceleration; PH_PARTS nothing: rate[0..5] are the
   entries D, rate[6..11] their rates, its state is the time; PH_DISSIPATION k. */
#include "acts.h"

#include <string.h>

/* ---- torques ---- */

/* With S = tr(I)/2 - I the second moments, o x I o = -o x S o: what all moments share is not there
   to cancel. */
static void gradient(const ph_top *top, int k, ph_wide t, const ph_wide x[], ph_wide N[3],
                     ph_wide *size) {
  const ph_act *a = &top->acts.list[k];
  const ph_wide mu = (ph_wide)a->v[0];
  ph_wide r = (ph_wide)a->v[1], angle, S[6], part[3], turn[3];
  if (a->flag) {
    const ph_wide e = (ph_wide)a->v[2];
    angle = x[acts_place(top, k)];
    r *= (1 - e) * (1 + e) / (1 + e * cosl(angle));
  } else {
    angle = sqrtl(mu / r) / r * t;
  }
  ph_wide o[3] = {cosl(angle), sinl(angle), 0};
  wide_sandwich(x, o, 0, o);
  for (int i = 0; i < 6; i++)
    S[i] = top->wide_second[i];
  wide_apply(S, o, part);
  wide_cross(part, o, turn);
  ph_wide D[6], Do[3];
  if (acts_locked(top, x, D)) {
    wide_apply(D, o, Do);
    wide_cross(o, Do, part);
    for (int i = 0; i < 3; i++)
      turn[i] += part[i];
  }
  const ph_wide factor = 3 * mu / (r * r * r);
  for (int i = 0; i < 3; i++)
    N[i] = factor * turn[i];
  *size += factor * (fabsl(S[0]) + fabsl(S[1]) + fabsl(S[2]));
}

/* One plate of the table: area, reflectivity, normal, centre. Force in body axes; 0 in the dark. */
static int plate(const ph_act *a, int i, const ph_wide sun[3], ph_wide F[3], ph_wide centre[3]) {
  const double *row = a->table + 8 * i;
  ph_wide n[3];
  wide_load(3, row + 2, n);
  wide_load(3, row + 5, centre);
  const ph_wide length = wide_norm(n), c = wide_dot(n, sun) / length;
  if (c <= 0)
    return 0;
  const ph_wide push = (ph_wide)a->v[0] * (ph_wide)row[0] * c, mirror = (ph_wide)row[1];
  for (int k = 0; k < 3; k++)
    F[k] = -push * ((1 - mirror) * sun[k] + 2 * mirror * c * n[k] / length);
  return 1;
}

int acts_side(const ph_top *top, const ph_wide x[], int number, ph_wide *side) {
  for (int k = 0; k < top->acts.n && top->effects & PH_SOLAR; k++) {
    const ph_act *a = &top->acts.list[k];
    if (a->kind != PH_SOLAR)
      continue;
    if (number < a->rows) {
      ph_wide sun[3], n[3];
      wide_load(3, a->v + 1, sun);
      wide_sandwich(x, sun, 0, sun);
      wide_load(3, a->table + 8 * number + 2, n);
      *side = wide_dot(n, sun);
      return 1;
    }
    number -= a->rows;
  }
  return 0;
}

/* Sums over the plates. */
static void sunlight(const ph_act *a, const ph_wide x[], ph_wide N[3], ph_wide F[3],
                     ph_wide *size) {
  ph_wide sun[3];
  wide_load(3, a->v + 1, sun);
  wide_sandwich(x, sun, 0, sun);
  for (int i = 0; i < a->rows; i++) {
    ph_wide f[3], centre[3], part[3];
    if (!plate(a, i, sun, f, centre))
      continue;
    wide_cross(centre, f, part);
    for (int k = 0; k < 3; k++) {
      N[k] += part[k];
      F[k] += f[k];
    }
    *size += wide_norm(centre) * wide_norm(f);
  }
}

static void support(const ph_top *top, const ph_act *a, ph_wide t, const ph_wide x[], ph_wide N[3],
                    ph_wide *size) {
  ph_wide push[3];
  const ph_wide rate = (ph_wide)a->v[1];
  for (int i = 0; i < 3; i++)
    push[i] = (ph_wide)top->mass *
              (a->flag ? (ph_wide)a->v[0] * rate * rate * cosl(rate * t) * (ph_wide)a->v[2 + i]
                       : -acts_value(&a->torque[i], t, x));
  wide_sandwich(x, push, 0, push);
  wide_cross(top->wide_com, push, N);
  *size += wide_norm(top->wide_com) * wide_norm(push);
}

/* -D' w; the rest of the moving parts is acts_solve's. */
static void parts(const ph_act *a, const ph_wide x[], ph_wide N[3], ph_wide *size) {
  ph_wide rate[6];
  for (int i = 0; i < 6; i++)
    rate[i] = -acts_value(&a->rate[6 + i], 0, x);
  wide_apply(rate, x + 4, N);
  *size += wide_norm(N);
}

void acts_slip(const ph_top *top, const ph_wide x[], ph_wide slip[3]) {
  for (int i = 0; i < 3; i++)
    slip[i] = 0;
  for (int k = 0; k < top->acts.n && top->effects & PH_DISSIPATION; k++)
    if (top->acts.list[k].kind == PH_DISSIPATION) {
      ph_wide L[3], part[3];
      acts_whole(top, x, L);
      wide_cross(L, x + 4, part);
      for (int i = 0; i < 3; i++)
        slip[i] += (ph_wide)top->acts.list[k].v[0] * part[i];
    }
}

void acts_torque_more(const ph_top *top, int k, ph_wide t, const ph_wide x[], ph_wide N[3],
                      ph_wide *size) {
  const ph_act *a = &top->acts.list[k];
  ph_wide F[3] = {0}, L[3];
  for (int i = 0; i < 3; i++)
    N[i] = 0;
  switch (a->kind) {
  case PH_GRADIENT:
    gradient(top, k, t, x, N, size);
    break;
  case PH_SOLAR:
    sunlight(a, x, N, F, size);
    break;
  case PH_PIVOT:
    support(top, a, t, x, N, size);
    break;
  case PH_PARTS:
    parts(a, x, N, size);
    break;
  default: /* the double bracket as (L.w) L - L^2 w, but for its cancellation */
    acts_whole(top, x, L);
    wide_cross(L, x + 4, F);
    wide_cross(L, F, N);
    for (int i = 0; i < 3; i++)
      N[i] *= (ph_wide)a->v[0];
    *size += wide_norm(N);
  }
}

/* ---- forces, states, tensor ---- */

void acts_force_more(const ph_top *top, const ph_wide x[], ph_wide F[3]) {
  for (int k = 0; k < top->acts.n && top->effects & PH_SOLAR; k++)
    if (top->acts.list[k].kind == PH_SOLAR) {
      ph_wide N[3] = {0}, f[3] = {0}, size = 0;
      sunlight(&top->acts.list[k], x, N, f, &size);
      wide_sandwich(x, f, 1, f);
      for (int i = 0; i < 3; i++)
        F[i] += f[i];
    }
}

/* Kepler's second law r^2 f' = sqrt(mu p), r = p/(1 + e cos f). */
void acts_rates_more(const ph_top *top, const ph_wide x[], ph_wide dx[]) {
  for (int k = 0; k < top->acts.n; k++) {
    const ph_act *a = &top->acts.list[k];
    if (!(top->effects & a->kind) || a->states == 0)
      continue;
    const int place = acts_place(top, k);
    if (a->kind == PH_GRADIENT) {
      const ph_wide e = (ph_wide)a->v[2], p = (ph_wide)a->v[1] * (1 - e) * (1 + e);
      const ph_wide r = p / (1 + e * cosl(x[place]));
      dx[place] = sqrtl((ph_wide)a->v[0] * p) / (r * r);
    } else if (a->kind == PH_PARTS) {
      dx[place] = 1;
    }
  }
}

int acts_tensor(const ph_top *top, const ph_wide x[], ph_wide D[6]) {
  int any = 0;
  for (int i = 0; i < 6; i++)
    D[i] = 0;
  for (int k = 0; k < top->acts.n && top->effects & PH_PARTS; k++)
    if (top->acts.list[k].kind == PH_PARTS) {
      any = 1;
      for (int i = 0; i < 6; i++)
        D[i] += acts_value(&top->acts.list[k].rate[i], 0, x);
    }
  return any;
}

/* ---- the calls ---- */

static int numbers(ph_top *top, enum ph_act_kind kind, int states, int n, const double v[],
                   ph_act **act) {
  if (!wide_finite(n, v))
    return PH_EFINITE;
  const int status = acts_new(top, kind, states, 0, NULL, act);
  if (status)
    return status;
  memcpy((*act)->v, v, (size_t)n * sizeof v[0]);
  top->effects |= kind;
  return PH_OK;
}

static int unit(const double v[3], double out[3]) {
  ph_wide a[3];
  if (!wide_finite(3, v))
    return PH_EFINITE;
  wide_load(3, v, a);
  const ph_wide n = wide_norm(a);
  if (!(n > 0))
    return PH_EDIRECTION;
  for (int i = 0; i < 3; i++)
    out[i] = (double)(a[i] / n);
  return PH_OK;
}

int ph_top_gravity_gradient(ph_top *top, double mu, double radius) {
  const double v[2] = {mu, radius};
  ph_act *act;
  return mu < 0 || radius <= 0 ? PH_EBOUND : numbers(top, PH_GRADIENT, 0, 2, v, &act);
}

int ph_top_gravity_gradient_orbit(ph_top *top, double mu, double a, double e) {
  const double v[3] = {mu, a, e};
  ph_act *act;
  if (mu < 0 || a <= 0 || e < 0 || e >= 1)
    return PH_EBOUND;
  const int status = numbers(top, PH_GRADIENT, 1, 3, v, &act);
  if (!status)
    act->flag = 1;
  return status;
}

int ph_top_solar(ph_top *top, double flux, const double sun[3], int n, const double plates[]) {
  static const double light = 299792458; /* m/s */
  double v[4] = {flux / light};
  ph_act *act;
  if (n < 1)
    return PH_ECOUNT;
  if (!wide_finite(8 * n, plates))
    return PH_EFINITE;
  for (int i = 0; i < n; i++) {
    double normal[3];
    const double *row = plates + 8 * i;
    const int status = unit(row + 2, normal);
    if (status)
      return status;
    if (row[0] < 0 || row[1] < 0 || row[1] > 1)
      return PH_EBOUND;
  }
  int status = flux < 0 ? PH_EBOUND : unit(sun, v + 1);
  if (!status)
    status = numbers(top, PH_SOLAR, 0, 4, v, &act);
  if (status)
    return status;
  act->table = plates;
  act->rows = n;
  return PH_OK;
}

int ph_top_vibration(ph_top *top, double amplitude, double rate, const double axis[3]) {
  double v[5] = {amplitude, rate};
  ph_act *act;
  int status = unit(axis, v + 2);
  if (!status)
    status = numbers(top, PH_PIVOT, 0, 5, v, &act);
  if (!status)
    act->flag = 1;
  return status;
}

int ph_top_pivot(ph_top *top, const ph_varying acceleration[3]) {
  ph_act *act;
  const int status = acts_new(top, PH_PIVOT, 0, 3, acceleration, &act);
  if (status)
    return status;
  memcpy(act->torque, acceleration, sizeof act->torque);
  top->effects |= PH_PIVOT;
  return PH_OK;
}

int ph_top_parts(ph_top *top, const ph_varying tensor[6], const ph_varying rate[6]) {
  ph_varying all[12];
  ph_act *act;
  memcpy(all, tensor, 6 * sizeof all[0]);
  memcpy(all + 6, rate, 6 * sizeof all[0]);
  const int status = acts_new(top, PH_PARTS, 1, 12, all, &act);
  if (status)
    return status;
  memcpy(act->rate, all, sizeof all);
  top->effects |= PH_PARTS;
  return PH_OK;
}

int ph_top_dissipation(ph_top *top, double k) {
  ph_act *act;
  return k < 0 ? PH_EBOUND : numbers(top, PH_DISSIPATION, 0, 1, &k, &act);
}
