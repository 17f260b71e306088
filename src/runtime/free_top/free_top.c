/* free_top.c - the free rigid body in closed form, by Jacobi's functions and Carlson's integrals.
   SPDX-License-Identifier: GPL-3.0-or-later

   Principal axes are renamed so that 2 is the middle moment and L circulates about 3, and turned so
   that L1 >= 0, L3 > 0. With s = sign(I3 - I1), D = I3 (I3 - I2) w3^2 - I1 (I2 - I1) w1^2 and its
   companions (which are sums of positive terms)
       L = (B1 cn u, s B2 sn u, B3 dn u),    u = lambda t + u0,
       k'^2 = |I3 - I1| |D2| / (|I3 - I2| |D1|),    D1 = L^2 - 2 T I1, ...
   (Landau and Lifshitz, Mechanics, 37). The attitude is Rz(phi) Rx(theta) Rz(psi) in a frame with z
   along L: cos theta = L3 / L, psi = atan2(L1, L2), and the angle that is left is an integral:
       phi' = L (w1 L1 + w2 L2) / (L1^2 + L2^2) = L / I2 + s kappa lambda cn^2 / (1 + nu sn^2),
       kappa = L |I2 - I1| / (I1 I2 lambda),    nu = I3 (I2 - I1) / (I1 (I3 - I2)) >= 0.
   Written about L / I2 the integral Y(u) of the second term stays within pi in a half-turn for
   every body and state (kappa^2 <= nu, with equality on the separatrix), so no two large phases are
   ever subtracted. By DLMF 19.21.12 it is
       Y = kappa [sn cn R_C(dn^2, dn^2 + d sn^2 cn^2)
                  + k'^2 sn^3 / (3 (1 + nu)) R_J(cn^2, dn^2, 1, cn^2 + k'^2 sn^2 / (1 + nu))],
       d = nu (nu + k^2) / (1 + nu):
   positive terms, regular from kappa = nu = 0 (the symmetric top) to k' = 0 (the separatrix, where
   the second is absent). Over half a period it is a complete integral, in pairs, and whole half
   periods are counted in pairs: the error does not grow with t until 10^18 rad. */
#include "special/elliptic.h"
#include "free_top.h"

#include <string.h>

static const ph_wide PI = 3.14159265358979323846264338327950288L;

static void keep(pair a, long double out[2]) {
  out[0] = a.hi, out[1] = a.lo;
}

static pair kept(const long double v[2]) {
  return (pair){v[0], v[1]};
}

static pair size_of(pair a) {
  return a.hi < 0 ? pair_negative(a) : a;
}

static pair square(pair a) {
  return pair_multiply(a, a);
}

/* Unit quaternion of v_body -> columns of a rotation: the largest of four squares first
   (Shepperd 1978). axis[k] are the images of the coordinate axes. */
static void quat_of_axes(long double axis[3][3], ph_wide q[4]) {
  const ph_wide d[3] = {axis[0][0], axis[1][1], axis[2][2]};
  const ph_wide four[4] = {1 + d[0] + d[1] + d[2], 1 + d[0] - d[1] - d[2], 1 - d[0] + d[1] - d[2],
                           1 - d[0] - d[1] + d[2]};
  int best = 0;
  for (int i = 1; i < 4; i++)
    if (four[i] > four[best])
      best = i;
  const ph_wide x = axis[1][2] - axis[2][1], y = axis[2][0] - axis[0][2],
                z = axis[0][1] - axis[1][0];
  const ph_wide xy = axis[0][1] + axis[1][0], xz = axis[0][2] + axis[2][0],
                yz = axis[1][2] + axis[2][1];
  const ph_wide row[4][4] = {
      {four[0], x, y, z}, {x, four[1], xy, xz}, {y, xy, four[2], yz}, {z, xz, yz, four[3]}};
  const ph_wide n = wide_quat_norm(row[best]);
  for (int i = 0; i < 4; i++)
    q[i] = row[best][i] / n;
}

static void conjugate_of(const ph_wide q[4], ph_wide out[4]) {
  out[0] = q[0], out[1] = -q[1], out[2] = -q[2], out[3] = -q[3];
}

/* ---- at a time ---- */

/* Y(u) of the head of this file, for the functions of u. */
static ph_wide precession(const ph_free_top *f, ph_wide sn, ph_wide cn, ph_wide dn) {
  const ph_wide s2 = sn * sn, c2 = cn * cn, d2 = dn * dn, mc = f->kc * f->kc;
  /* R_C(dn^2, ...) = R_C(1, ...)/dn: cn = dn on the separatrix, where both vanish in the end */
  const ph_wide r = f->kc > 0 ? cn / dn : 1;
  const ph_wide d = f->nu * (f->nu + f->m_wide) / (1 + f->nu), q = mc / (1 + f->nu);
  if (f->kappa == 0)
    return 0;
  ph_wide y = sn * r * carlson_rc(1, 1 + d * s2 * r * r);
  if (f->kc > 0)
    y += q / 3 * sn * s2 * carlson_rj(c2, d2, 1, c2 + q * s2);
  return f->kappa * y;
}

/* The attitude in the frame of L from Euler's angles: q = (cos(theta/2) e^(i(phi+psi)/2),
   sin(theta/2) e^(i(phi-psi)/2)) as (w + i z, x + i y). L3 >= 0, so cos(theta/2) is no
   difference. */
static void euler_quat(const ph_wide L[3], ph_wide half_phi, ph_wide half_psi, ph_wide q[4]) {
  const ph_wide across = hypotl(L[0], L[1]), size = hypotl(across, L[2]);
  const ph_wide c = sqrtl((1 + L[2] / size) / 2), s = across / size / (2 * c);
  q[0] = c * cosl(half_phi + half_psi), q[3] = c * sinl(half_phi + half_psi);
  q[1] = s * cosl(half_phi - half_psi), q[2] = s * sinl(half_phi - half_psi);
}

/* State of the periodic motion and of the separatrix: q from the frame of L to the axes 1, 2, 3,
   and L in them. */
static void elliptic_at(const ph_free_top *f, pair t, ph_wide q[4], ph_wide L[3]) {
  ph_wide n = 0, skip, u = f->u0, sn, cn, dn;
  pair half_phi = pair_fraction(pair_multiply(kept(f->turn_rate), t), &skip);
  if (f->kind == PH_FREE_PERIODIC) {
    const pair rest = pair_fraction(pair_multiply(kept(f->half_rate), t), &n);
    u += 2 * f->K * pair_value(rest);
    if (fabsl(u) > f->K) {
      const ph_wide more = u > 0 ? 1 : -1;
      u -= more * 2 * f->K;
      n += more;
    }
    const pair turned = pair_fraction(pair_times(kept(f->half_turn), n), &skip);
    half_phi = pair_add(half_phi, f->sign > 0 ? turned : pair_negative(turned));
  } else {
    u += f->lambda * pair_value(t);
  }
  elliptic_sncndn(pair_of(u), pair_of(f->K), f->kc, &sn, &cn, &dn);
  const ph_wide half = 2 * PI * pair_value(half_phi) + f->sign * precession(f, sn, cn, dn) / 2;
  const ph_wide L1 = f->B[0] * cn, L2 = f->sign * f->B[1] * sn;
  const ph_wide quarter = fmodl(n, 4) * PI / 2;
  L[0] = L1, L[1] = L2, L[2] = f->B[2] * dn;
  euler_quat(L, half, atan2l(L1, L2) / 2 - f->sign * quarter, q);
  if (fmodl(n, 2) != 0)
    L[0] = -L1, L[1] = -L2;
}

/* Turn by 2 pi 2 half about e. */
static void turn_of(const ph_wide e[3], pair half, ph_wide q[4]) {
  const ph_wide a = 2 * PI * pair_value(half);
  q[0] = cosl(a);
  for (int i = 0; i < 3; i++)
    q[1 + i] = sinl(a) * e[i];
}

/* One turn about L, and for the rod another about its own axis (motion/euler.c has the symmetric
 * top). */
static void turned_at(const ph_free_top *f, pair t, ph_wide x[7]) {
  ph_wide outer[4], inner[4], skip;
  turn_of(f->Ls, pair_fraction(pair_multiply(kept(f->turn_rate), t), &skip), outer);
  wide_quat_multiply(outer, f->q, x);
  for (int i = 0; i < 3; i++)
    x[4 + i] = f->w[i];
  if (f->kind != PH_FREE_ROD)
    return;
  const pair half = pair_fraction(pair_multiply(kept(f->half_rate), t), &skip);
  turn_of(f->axis[2], half, inner);
  wide_quat_multiply(x, inner, x);
  /* the rates turn the other way, seen from the body */
  wide_sandwich(inner, f->w, 0, x + 4);
}

void free_top_at_wide(const ph_free_top *f, pair t, ph_wide v[7]) {
  if (f->kind == PH_FREE_CONSTANT || f->kind == PH_FREE_ROD) {
    turned_at(f, t, v);
  } else {
    ph_wide p[4], L[3];
    elliptic_at(f, t, p, L);
    wide_quat_multiply(f->q, p, p);
    wide_quat_multiply(p, f->p, v);
    for (int i = 0; i < 3; i++) {
      v[4 + i] = 0;
      for (int k = 0; k < 3; k++)
        v[4 + i] += L[k] / f->moment[k] * f->axis[k][i];
    }
  }
  const ph_wide n = wide_quat_norm(v);
  for (int i = 0; i < 4; i++)
    v[i] /= n;
}

int free_top_at(const ph_free_top *f, pair t, double x[7]) {
  ph_wide v[7];
  free_top_at_wide(f, t, v);
  return wide_store(7, v, x);
}

int ph_free_top_at(const ph_free_top *f, double t, double x[7]) {
  return isfinite(t) ? free_top_at(f, pair_of((ph_wide)t), x) : PH_EFINITE;
}

/* ---- set-up ---- */

/* Rates that do not change: turn about w. */
static void constant(ph_free_top *f, const ph_wide q[4]) {
  pair sum = pair_of(0);
  for (int i = 0; i < 3; i++)
    sum = pair_add(sum, pair_product(f->w[i], f->w[i]));
  const pair rate = pair_sqrt(sum);
  f->kind = PH_FREE_CONSTANT;
  memcpy(f->q, q, sizeof f->q);
  for (int i = 0; i < 3; i++)
    f->Ls[i] = rate.hi > 0 ? f->w[i] / rate.hi : 0;
  wide_sandwich(q, f->Ls, 1, f->Ls);
  keep(pair_divide(rate, pair_times(pair_pi(), 4)), f->turn_rate);
  f->period_wide = HUGE_VALL;
  f->precession_wide = rate.hi;
}

/* No moment about axis a, the same about the others: L = I (w across the axis), which turns with
   L/I about L, while w turns back about the axis with w_a. */
static void rod(ph_free_top *f, const ph_wide q[4], const pair a[3], const pair w[3]) {
  const pair rate = pair_sqrt(pair_add(square(w[1]), square(w[2])));
  const pair cycle = pair_times(pair_pi(), 4);
  f->kind = PH_FREE_ROD;
  memcpy(f->q, q, sizeof f->q);
  for (int i = 0; i < 3; i++) {
    f->axis[2][i] = pair_value(a[i]);
    f->Ls[i] = 0;
  }
  for (int i = 0; i < 3; i++)
    f->Ls[i] = (f->w[i] - w[0].hi * f->axis[2][i]) / rate.hi;
  const ph_wide n = wide_norm(f->Ls);
  for (int i = 0; i < 3; i++)
    f->Ls[i] /= n;
  wide_sandwich(q, f->Ls, 1, f->Ls);
  keep(pair_divide(rate, cycle), f->turn_rate);
  keep(pair_divide(w[0], cycle), f->half_rate);
  f->period_wide = 2 * PI / fabsl(w[0].hi);
  f->precession_wide = rate.hi;
}

/* Axes 1, 2, 3 and signs of the head of this file; w and I follow. */
static void arrange(pair I[3], pair axis[3][3], pair w[3], int smallest_is_3) {
  if (smallest_is_3) { /* 1 <-> 3, and 2 backward so that the axes stay right-handed */
    pair keep_i = I[0], keep_w = w[0];
    I[0] = I[2], I[2] = keep_i;
    w[0] = w[2], w[2] = keep_w;
    w[1] = pair_negative(w[1]);
    for (int i = 0; i < 3; i++) {
      const pair k = axis[0][i];
      axis[0][i] = axis[2][i], axis[2][i] = k;
      axis[1][i] = pair_negative(axis[1][i]);
    }
  }
  const int flip3 = w[2].hi < 0, flip1 = w[0].hi < 0;
  const int flip[3] = {flip1, flip1 != flip3, flip3};
  for (int k = 0; k < 3; k++)
    if (flip[k]) {
      w[k] = pair_negative(w[k]);
      for (int i = 0; i < 3; i++)
        axis[k][i] = pair_negative(axis[k][i]);
    }
}

/* What the motion keeps: L, g_ij = |I_i - I_j|, D_i = |L^2 - 2 T I_i|. D1 and D3 are sums of
   positive terms; D2 is what free_top_side says, for there it would be a difference. */
struct invariants {
  pair L, g12, g13, g23, D1, D2, D3;
};

static struct invariants invariants_of(const pair I[3], const pair w[3], const pair L[3],
                                       pair side) {
  struct invariants c;
  c.L = pair_sqrt(pair_add(pair_add(square(L[0]), square(L[1])), square(L[2])));
  c.g12 = size_of(pair_subtract(I[1], I[0]));
  c.g13 = size_of(pair_subtract(I[2], I[0]));
  c.g23 = size_of(pair_subtract(I[2], I[1]));
  c.D1 = pair_add(pair_multiply(pair_multiply(I[1], c.g12), square(w[1])),
                  pair_multiply(pair_multiply(I[2], c.g13), square(w[2])));
  c.D2 = size_of(side);
  c.D3 = pair_add(pair_multiply(pair_multiply(I[0], c.g13), square(w[0])),
                  pair_multiply(pair_multiply(I[1], c.g23), square(w[1])));
  return c;
}

/* k', lambda, kappa and 1 + nu of the head, which the periods need in pairs; f gets them as
 * numbers. */
struct moduli {
  pair kc, lambda, kappa, one_nu;
};

static struct moduli moduli_of(ph_free_top *f, const pair I[3], const struct invariants *c) {
  struct moduli k;
  const pair bottom = pair_multiply(c->g23, c->D1);
  const pair m = pair_divide(pair_multiply(c->g12, c->D3), bottom);
  k.kc = pair_sqrt(pair_divide(pair_multiply(c->g13, c->D2), bottom));
  k.lambda =
      pair_divide(pair_sqrt(pair_divide(pair_multiply(pair_divide(c->g23, I[1]), c->D1), I[0])),
                  pair_sqrt(I[2]));
  k.one_nu = pair_divide(pair_multiply(pair_divide(I[1], I[0]), c->g13), c->g23);
  k.kappa =
      pair_divide(pair_divide(pair_multiply(pair_divide(c->L, I[0]), c->g12), I[1]), k.lambda);
  f->m_wide = f->kind == PH_FREE_SEPARATRIX ? 1 : pair_value(m);
  f->kc = pair_value(k.kc);
  f->lambda = pair_value(k.lambda);
  f->kappa = pair_value(k.kappa);
  f->nu = pair_value(pair_divide(pair_multiply(pair_divide(I[2], I[0]), c->g12), c->g23));
  return k;
}

/* B1, B2, B3, and u0 by the values that cn, sn and dn have at the start. */
static void amplitudes(ph_free_top *f, const pair I[3], const pair L[3],
                       const struct invariants *c) {
  const ph_wide B[3] = {pair_value(pair_sqrt(pair_multiply(pair_divide(I[0], c->g13), c->D3))),
                        pair_value(pair_sqrt(pair_multiply(pair_divide(I[1], c->g23), c->D3))),
                        pair_value(pair_sqrt(pair_multiply(pair_divide(I[2], c->g13), c->D1)))};
  for (int k = 0; k < 3; k++)
    f->B[k] = B[k];
  const ph_wide cn = pair_value(L[0]) / B[0], sn = f->sign * pair_value(L[1]) / B[1];
  const ph_wide dn = pair_value(L[2]) / B[2];
  f->u0 = f->kind == PH_FREE_SEPARATRIX ? asinhl(sn / cn) /* the Gudermannian's inverse */
                                        : sn * carlson_rf(cn * cn, dn * dn, 1);
}

/* Periods and rates per turn; quarter: phi'/2 of the first term, L / I2. On the separatrix there is
   no period, and the second term of phi' ends at a constant. */
static void periods(ph_free_top *f, const struct moduli *k, pair quarter) {
  keep(pair_divide(quarter, pair_times(pair_pi(), 2)), f->turn_rate);
  f->precession_wide = 2 * pair_value(quarter);
  f->period_wide = HUGE_VALL;
  if (f->kind == PH_FREE_SEPARATRIX)
    return;
  const pair K = elliptic_k(k->kc);
  const pair Y = pair_multiply(k->kappa, elliptic_cel(k->kc, k->one_nu, pair_of(1), pair_of(0)));
  f->K = pair_value(K);
  keep(pair_divide(k->lambda, pair_times(K, 2)), f->half_rate);
  keep(pair_divide(Y, pair_times(pair_pi(), 2)), f->half_turn); /* 2 Y / 2 in turns */
  f->period_wide = 4 * pair_value(pair_divide(K, k->lambda));
  f->turn_wide = f->period_wide * 2 * pair_value(quarter) + f->sign * 4 * pair_value(Y);
  f->precession_wide = f->turn_wide / f->period_wide;
}

/* The frame of L: q0 = q p0 e*, e from axes 1, 2, 3 to the body's. */
static void frame_of_momentum(ph_free_top *f, const ph_wide q0[4]) {
  ph_wide e[4], p0[4], L0[3], back[4];
  quat_of_axes(f->axis, e);
  elliptic_at(f, pair_of(0), p0, L0);
  conjugate_of(p0, back);
  wide_quat_multiply(q0, e, f->q);
  wide_quat_multiply(f->q, back, f->q);
  conjugate_of(e, f->p);
}

static void general(ph_free_top *f, const ph_wide q0[4], pair I[3], pair axis[3][3], pair w[3],
                    pair side) {
  arrange(I, axis, w, side.hi < 0);
  f->kind = side.hi == 0 ? PH_FREE_SEPARATRIX : PH_FREE_PERIODIC;
  f->sign = side.hi < 0 ? -1 : 1;
  for (int k = 0; k < 3; k++) {
    f->moment[k] = pair_value(I[k]);
    for (int i = 0; i < 3; i++)
      f->axis[k][i] = pair_value(axis[k][i]);
  }
  const pair L[3] = {pair_multiply(I[0], w[0]), pair_multiply(I[1], w[1]),
                     pair_multiply(I[2], w[2])};
  const struct invariants c = invariants_of(I, w, L, side);
  const struct moduli k = moduli_of(f, I, &c);
  amplitudes(f, I, L, &c);
  periods(f, &k, pair_divide(c.L, pair_times(I[1], 2)));
  frame_of_momentum(f, q0);
}

/* Euler's equations have nothing on the right. */
static int at_rest(const pair I[3], const pair w[3]) {
  for (int k = 0; k < 3; k++) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    if (pair_subtract(I[i], I[j]).hi != 0 && w[i].hi != 0 && w[j].hi != 0)
      return 0;
  }
  return 1;
}

int ph_free_top_solve(ph_free_top *out, const ph_top *top, const double x0[7]) {
  if (top->effects)
    return PH_EMETHOD;
  if (!wide_finite(7, x0))
    return PH_EFINITE;
  ph_wide q0[4];
  const int status = wide_load_unit(x0, q0);
  if (status)
    return status;
  ph_free_top f;
  memset(&f, 0, sizeof f);
  pair I[3], axis[3][3], w[3];
  wide_load(3, x0 + 4, f.w);
  if (top->wide_moment[0] > 0) {
    free_top_axes(top->wide_inertia, I, axis);
  } else { /* a rod: by the triangle inequality the other two are one, up to rounding */
    const ph_wide mean = (top->wide_moment[1] + top->wide_moment[2]) / 2;
    for (int k = 0; k < 3; k++) {
      I[k] = pair_of(k ? mean : 0);
      for (int i = 0; i < 3; i++)
        axis[k][i] = pair_of(top->wide_axis[k][i]);
    }
  }
  pair T = pair_of(0), G = pair_of(0);
  for (int k = 0; k < 3; k++) {
    w[k] = pair_of(0);
    for (int i = 0; i < 3; i++)
      w[k] = pair_add(w[k], pair_times(axis[k][i], f.w[i]));
    T = pair_add(T, pair_multiply(I[k], square(w[k])));
    G = pair_add(G, square(pair_multiply(I[k], w[k])));
  }
  if (at_rest(I, w))
    constant(&f, q0);
  else if (I[0].hi == 0)
    rod(&f, q0, axis[0], w);
  else
    general(&f, q0, I, axis, w, free_top_side(I, w));
  const ph_wide mc = f.kc * f.kc;
  const ph_wide v[5] = {pair_value(T) / 2, pair_value(pair_sqrt(G)), f.m_wide,
                        f.kind == PH_FREE_PERIODIC ? mc : 1 - f.m_wide, f.precession_wide};
  if (!wide_fits(5, v))
    return PH_ERANGE;
  f.T = (double)v[0], f.L = (double)v[1], f.m = (double)v[2], f.mc = (double)v[3];
  f.precession = (double)v[4];
  f.period = (double)f.period_wide;
  f.turn = isfinite(f.period) ? (double)f.turn_wide : 0;
  *out = f;
  return PH_OK;
}

/* u = 0 modulo 2 K. */
int ph_free_top_flip(const ph_free_top *f, double t, double *when) {
  if (!isfinite(t))
    return PH_EFINITE;
  if (f->kind == PH_FREE_PERIODIC) {
    ph_wide n;
    const pair x =
        pair_add(pair_times(kept(f->half_rate), (ph_wide)t), pair_of(f->u0 / (2 * f->K)));
    const pair rest = pair_fraction(x, &n);
    const ph_wide left = pair_value(rest) < 0 ? -pair_value(rest) : 1 - pair_value(rest);
    const ph_wide next = (ph_wide)t + left * f->period_wide / 2;
    return wide_store(1, &next, when);
  }
  const ph_wide once = f->kind == PH_FREE_SEPARATRIX ? -f->u0 / f->lambda : HUGE_VALL;
  *when = once > (ph_wide)t ? (double)once : HUGE_VAL;
  return PH_OK;
}
