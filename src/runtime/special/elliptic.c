/* elliptic.c - Legendre's integrals and Jacobi's functions for the user.
   SPDX-License-Identifier: GPL-3.0-or-later

   Arguments are reduced to a quarter period with twice the digits of long double, the rest is
   Carlson's integrals in forms without differences (DLMF 19.25), rounded to double at the end. */
#include "elliptic.h"

ph_modulus ph_modulus_m(double m) {
  return (ph_modulus){0, m};
}

ph_modulus ph_modulus_mc(double mc) {
  return (ph_modulus){1, mc};
}

/* m, 1 - m and sqrt(1 - m), from that of the first two which was given: if small it keeps its
   digits. */
typedef struct modulus {
  ph_wide m, mc;
  pair kc;
} modulus;

static int modulus_read(ph_modulus in, modulus *out) {
  if (!isfinite(in.value))
    return PH_EFINITE;
  if (in.value < 0 || in.value > 1)
    return PH_EBOUND;
  const pair given = pair_of((ph_wide)in.value), other = pair_subtract(pair_of(1), given);
  const pair mc = in.complement ? given : other;
  out->m = pair_value(in.complement ? other : given);
  out->mc = pair_value(mc);
  out->kc = pair_sqrt(mc);
  return PH_OK;
}

static int give(ph_wide value, double *out) {
  return wide_store(1, &value, out);
}

/* ---- the integrals over an angle within [-pi/2, pi/2], by its sine and cosine ---- */

/* F = s R_F(c^2, 1 - m s^2, 1), DLMF 19.25.5; 1 - m s^2 is formed as c^2 + (1 - m) s^2. */
static ph_wide f_of(const modulus *k, ph_wide s, ph_wide c) {
  return s * carlson_rf(c * c, c * c + k->mc * s * s, 1);
}

/* DLMF 19.25.9, and for the larger m 19.25.10: sums of terms of one sign. m s s < 1/2 makes the
   difference in the former harmless. */
static ph_wide e_of(const modulus *k, ph_wide s, ph_wide c) {
  const ph_wide s2 = s * s, c2 = c * c, d2 = c2 + k->mc * s2;
  if (k->m * s2 < 0.5L)
    return s * (carlson_rf(c2, d2, 1) - k->m * s2 / 3 * carlson_rd(c2, d2, 1));
  const ph_wide tail = k->m * s * fabsl(c) / sqrtl(d2);
  if (k->mc == 0)
    return s;
  return k->mc * s * (carlson_rf(c2, d2, 1) + k->m * s2 / 3 * carlson_rd(c2, 1, d2)) + tail;
}

/* integral of cos^2 / ((1 + nu sin^2) Delta), nu >= 0: R_J with its parameter exchanged (DLMF
   19.21.12 with x = cos^2), so that nothing cancels however large nu is. */
static ph_wide y_of(const modulus *k, ph_wide nu, ph_wide s, ph_wide c) {
  const ph_wide s2 = s * s, c2 = c * c, d2 = c2 + k->mc * s2;
  const ph_wide D = nu * (nu + k->m) / (1 + nu), q = k->mc / (1 + nu);
  ph_wide y = s * fabsl(c) * carlson_rc(d2, d2 + D * s2 * c2);
  if (k->mc > 0)
    y += q / 3 * s * s2 * carlson_rj(c2, d2, 1, c2 + q * s2);
  return y;
}

/* DLMF 19.25.14; for n < 0 its terms have two signs, and with nu = -n
     1/(1 + nu s^2) = (1 + nu c^2/(1 + nu s^2))/(1 + nu)   leads to sums of one. */
static ph_wide pi_of(const modulus *k, ph_wide n, ph_wide s, ph_wide c) {
  const ph_wide s2 = s * s, c2 = c * c, d2 = c2 + k->mc * s2, F = f_of(k, s, c);
  if (n < 0)
    return F / (1 - n) - n / (1 - n) * y_of(k, -n, s, c);
  return F + n / 3 * s * s2 * carlson_rj(c2, d2, 1, c2 + (1 - n) * s2);
}

/* ---- any angle ---- */

/* phi = n pi + rest, |rest| <= pi/2. */
static ph_wide reduce(double phi, ph_wide *s, ph_wide *c) {
  ph_wide n;
  const pair turns = pair_divide(pair_of((ph_wide)phi), pair_pi());
  pair_fraction(turns, &n);
  const pair rest = pair_subtract(pair_of((ph_wide)phi), pair_times(pair_pi(), n));
  *s = sinl(rest.hi) + rest.lo * cosl(rest.hi);
  *c = fabsl(cosl(rest.hi) - rest.lo * sinl(rest.hi));
  return n;
}

enum { FIRST, SECOND, THIRD };

static pair complete(int which, const modulus *k, double n) {
  const pair one = pair_of(1), mc = pair_multiply(k->kc, k->kc);
  if (which == FIRST)
    return elliptic_k(k->kc);
  if (which == SECOND) /* DLMF 19.2.11: cel(k', 1, 1, k'^2) */
    return k->mc > 0 ? elliptic_cel(k->kc, one, one, mc) : one;
  return elliptic_cel(k->kc, pair_subtract(one, pair_of((ph_wide)n)), one, one);
}

static int integral(int which, double n, double phi, ph_modulus m, double *out) {
  modulus k;
  const int status = modulus_read(m, &k);
  if (status)
    return status;
  if (!isfinite(phi) || !isfinite(n))
    return PH_EFINITE;
  if (n >= 1)
    return PH_EBOUND;
  ph_wide s, c;
  const ph_wide halves = reduce(phi, &s, &c);
  if (k.mc == 0 && which != SECOND && (halves != 0 || c == 0))
    return PH_ERANGE;
  const ph_wide part = which == FIRST    ? f_of(&k, s, c)
                       : which == SECOND ? e_of(&k, s, c)
                                         : pi_of(&k, (ph_wide)n, s, c);
  if (halves == 0)
    return give(part, out);
  return give(pair_value(pair_add(pair_times(complete(which, &k, n), 2 * halves), pair_of(part))),
              out);
}

int ph_elliptic_f(double phi, ph_modulus m, double *F) {
  return integral(FIRST, 0, phi, m, F);
}

int ph_elliptic_e(double phi, ph_modulus m, double *E) {
  return integral(SECOND, 0, phi, m, E);
}

int ph_elliptic_pi(double n, double phi, ph_modulus m, double *Pi) {
  return integral(THIRD, n, phi, m, Pi);
}

static int whole(int which, double n, ph_modulus m, double *out) {
  modulus k;
  const int status = modulus_read(m, &k);
  if (status)
    return status;
  if (!isfinite(n))
    return PH_EFINITE;
  if (n >= 1)
    return PH_EBOUND;
  if (k.mc == 0 && which != SECOND)
    return PH_ERANGE;
  return give(pair_value(complete(which, &k, n)), out);
}

int ph_elliptic_complete_k(ph_modulus m, double *K) {
  return whole(FIRST, 0, m, K);
}

int ph_elliptic_complete_e(ph_modulus m, double *E) {
  return whole(SECOND, 0, m, E);
}

int ph_elliptic_complete_pi(double n, ph_modulus m, double *Pi) {
  return whole(THIRD, n, m, Pi);
}

/* u = 2 K n + rest: sn and cn change sign with n, am grows by pi. */
int ph_elliptic_jacobi(double u, ph_modulus m, ph_jacobi *out) {
  modulus k;
  const int status = modulus_read(m, &k);
  if (status)
    return status;
  if (!isfinite(u))
    return PH_EFINITE;
  ph_wide n = 0, sn, cn, dn;
  pair rest = pair_of((ph_wide)u), K = pair_of(0);
  if (k.mc > 0) {
    const pair half = pair_times(elliptic_k(k.kc), 2);
    pair_fraction(pair_divide(rest, half), &n);
    rest = pair_subtract(rest, pair_times(half, n));
    K = pair_times(half, 0.5L);
  }
  elliptic_sncndn(rest, K, pair_value(k.kc), &sn, &cn, &dn);
  const ph_wide am = pair_value(pair_add(pair_times(pair_pi(), n), pair_of(atan2l(sn, cn))));
  const ph_wide sign = fmodl(n, 2) == 0 ? 1 : -1;
  const ph_wide v[4] = {sign * sn, sign * cn, dn, am};
  double d[4];
  const int stored = wide_store(4, v, d);
  if (!stored)
    *out = (ph_jacobi){d[0], d[1], d[2], d[3]};
  return stored;
}
