/* landing.c - a body in the air above a plane: how far it is from it, and their impact.
   SPDX-License-Identifier: GPL-3.0-or-later

   In inertial axes, with d from the centre of mass to the lowest point and the impulse P: changes A
   of the velocity and a of the rates with
     m A - P = 0      I a - d x P = 0      A + a x d = what the point's velocity changes by
   one linear system, solved twice: for the impulse without friction that takes the normal velocity,
   and for the one that takes all of it. Between and beyond them lies that of Chatterjee and Ruina
   (J. Appl. Mech. 65, 1998, 939), on the cone of friction by a quadratic equation. */
#include "acts/acts.h"

#include <string.h>

typedef struct meeting {
  const ph_plane *plane;
  ph_wide q[4], n[3], w[3], v[3], com[3]; /* inertial axes; q unit */
  ph_wide d[3], speed[3];                 /* of the lowest point against the plane's */
  ph_wide gap;
} meeting;

/* The state at the lowest point. PH_EMETHOD: the top has no plane; PH_ECONTACT: no single point of
   the surface is lowest. The plane goes through the origin and turns with `rate` about n there. */
static int meet(const ph_top *top, const double x[13], meeting *c) {
  ph_wide full[PH_STATES] = {0}, g[3], none[3] = {0}, r[3], rate[3], point[3], under[3];
  wide_load(13, x, full);
  const ph_wide length = wide_quat_norm(full);
  if (!(length > 0) || !isfinite(length))
    return PH_EQUATERNION;
  const ph_act *act = acts_constraint(top, 0, full).act;
  if (!act)
    return PH_EMETHOD;
  c->plane = &act->of.plane;
  wide_load(3, c->plane->normal, c->n);
  const ph_wide n = wide_norm(c->n);
  for (int i = 0; i < 4; i++)
    c->q[i] = full[i] / length;
  for (int i = 0; i < 3; i++) {
    c->n[i] /= n;
    c->com[i] = full[7 + i];
    c->v[i] = full[10 + i];
  }
  wide_sandwich(c->q, full + 4, 1, c->w);
  wide_sandwich(c->q, c->n, 0, g);
  if (!acts_surface(c->plane, g, none, r, rate))
    return PH_ECONTACT;
  wide_sandwich(c->q, r, 1, c->d);
  wide_cross(c->w, c->d, c->speed);
  for (int i = 0; i < 3; i++)
    point[i] = c->com[i] + c->d[i];
  wide_cross(c->n, point, under);
  for (int i = 0; i < 3; i++)
    c->speed[i] += c->v[i] - (ph_wide)c->plane->rate * under[i];
  c->gap = wide_dot(c->n, point);
  return PH_OK;
}

/* y: A, a, P. The impulse changes the velocity of the point by `change`, all of it, or with
   `along` its part along n by an impulse along n. 0: of a rod. Three rows for each equation of the
   head; with `along` the last three are n.(A + a x d) = n.change, e1.P = 0, e2.P = 0. */
static int impulse(const ph_top *top, const meeting *c, const ph_wide change[3], int along,
                   ph_wide y[ACTS_ROWS]) {
  static const int at[3][3] = {{XX, XY, XZ}, {XY, YY, YZ}, {XZ, YZ, ZZ}};
  ph_wide M[ACTS_ROWS][ACTS_ROWS] = {{0}}, R[9], I[6], column[3], e1[3], e2[3];
  wide_quat_matrix(c->q, R);
  wide_congruence(R, top->wide_inertia, I);
  for (int j = 0; j < 9; j++)
    y[j] = j < 6 ? 0 : change[j - 6];
  for (int j = 0; j < 3; j++) {
    const ph_wide unit[3] = {j == 0, j == 1, j == 2};
    wide_cross(c->d, unit, column);
    for (int i = 0; i < 3; i++) {
      M[3 + i][3 + j] = I[at[i][j]];
      M[3 + i][6 + j] = -column[i];
      M[6 + i][3 + j] = -column[i]; /* a x d */
    }
    M[j][j] = (ph_wide)top->mass;
    M[j][6 + j] = -1;
    M[6 + j][j] = 1;
  }
  if (along) {
    /* an axis that is far from n */
    const ph_wide least[3] = {fabsl(c->n[0]) < 0.6L, fabsl(c->n[0]) >= 0.6L, 0};
    wide_cross(c->n, least, e1);
    wide_cross(c->n, e1, e2);
    ph_wide row[6] = {0}, sum = 0;
    for (int i = 0; i < 3; i++) {
      for (int j = 0; j < 6; j++)
        row[j] += c->n[i] * M[6 + i][j];
      sum += c->n[i] * y[6 + i];
    }
    memset(M[6], 0, 3 * sizeof M[6]);
    for (int j = 0; j < 6; j++)
      M[6][j] = row[j];
    for (int j = 0; j < 3; j++) {
      M[7][6 + j] = e1[j];
      M[8][6 + j] = e2[j];
    }
    y[6] = sum;
    y[7] = y[8] = 0;
  }
  return acts_eliminate(9, M, y);
}

/* How far along more = p2 - p1 the cone |P_t| <= mu P_n lets P = first n + kappa more go: 1, or the
   positive root of kappa^2 t^2 = mu^2 (first + kappa along)^2, in the form without a difference. */
static ph_wide reach(const ph_wide n[3], ph_wide first, const ph_wide more[3], ph_wide mu) {
  const ph_wide along = wide_dot(n, more);
  ph_wide across[3];
  for (int i = 0; i < 3; i++)
    across[i] = more[i] - along * n[i];
  const ph_wide t = wide_norm(across), up = first + along;
  if (t <= mu * up || t == 0)
    return 1;
  const ph_wide a = (t - mu * along) * (t + mu * along), b = -2 * mu * mu * first * along;
  const ph_wide c = -mu * mu * first * first;
  return c == 0 ? 0 : -2 * c / (b + sqrtl(b * b - 4 * a * c));
}

static int sound(const ph_impact *law) {
  return law->restitution >= 0 && law->restitution <= 1 && law->friction >= 0 &&
         fabs(law->tangential) <= 1;
}

int ph_top_gap(const ph_top *top, const double x[13], ph_gap *out) {
  meeting c;
  const int status = wide_finite(13, x) ? meet(top, x, &c) : PH_EFINITE;
  if (status)
    return status;
  out->gap = (double)c.gap;
  out->rate = (double)wide_dot(c.n, c.speed);
  for (int i = 0; i < 3; i++) {
    out->point[i] = (double)(c.com[i] + c.d[i]);
    out->slip[i] = (double)c.speed[i];
  }
  return PH_OK;
}

int ph_top_impact(const ph_top *top, const ph_impact *law, double x[13], double *normal) {
  meeting c;
  ph_wide one[ACTS_ROWS], two[ACTS_ROWS], change[3], more[3], turn[3];
  if (!sound(law))
    return PH_EPOSITIVE;
  const int status = wide_finite(13, x) ? meet(top, x, &c) : PH_EFINITE;
  if (status)
    return status;
  *normal = 0;
  const ph_wide speed = wide_dot(c.n, c.speed), e = (ph_wide)law->restitution;
  if (!(speed < 0))
    return PH_OK;
  for (int i = 0; i < 3; i++)
    change[i] = -c.speed[i];
  if (!impulse(top, &c, change, 1, one) || !impulse(top, &c, change, 0, two))
    return PH_EROD;
  const ph_wide et = (ph_wide)law->tangential, first = (1 + e) * wide_dot(c.n, one + 6);
  for (int i = 0; i < 3; i++)
    more[i] = (1 + et) * (two[6 + i] - one[6 + i]);
  const ph_wide kappa = isinf(law->friction) ? 1 : reach(c.n, first, more, (ph_wide)law->friction);
  for (int i = 0; i < 6; i++)
    one[i] = (1 + e) * one[i] + kappa * (1 + et) * (two[i] - one[i]);
  wide_sandwich(c.q, one + 3, 0, turn);
  for (int i = 0; i < 3; i++) {
    x[4 + i] = (double)((ph_wide)x[4 + i] + turn[i]);
    x[10 + i] = (double)(c.v[i] + one[i]);
  }
  *normal = (double)(first + kappa * wide_dot(c.n, more));
  return PH_OK;
}
