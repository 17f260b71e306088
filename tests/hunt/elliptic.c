/* elliptic.c - the hunt's target: the library's elliptic integrals and functions against MPFR.
   SPDX-License-Identifier: GPL-3.0-or-later

   The oracle's formulas are those of tests/oracle/free_top.c: Carlson's duplication, the descending
   Landen transformation. There is no faster road to these digits, so it measures as well. Errors
   are in units of the last place of the value, however small it is. |phi| and |u| are at most 1e15,
   0 < m < 1, and 1 - m at least 2^-120, where cn and dn are 2^-60 and the oracle's bits do. */
#include "polhode.h"
#include "search.h"

#define main free_top_main
#include "../oracle/free_top.c"
#undef main

#include <math.h>

enum { VALUE, COMPLEMENT, CHARACTERISTIC, PHI, U, GENES };
enum { K_, E_, PI_, F_PHI, E_PHI, PI_PHI, SN, CN, DN, AM, ERRORS };

static const hunt_gene genes[] = {{"m", HUNT_POSITIVE, 0},
                                  {"complement", HUNT_CHOICE, 1},
                                  {"n", HUNT_SIGNED, 2},
                                  {"phi", HUNT_SIGNED, 3},
                                  {"u", HUNT_SIGNED, 3}};

/* polhode_exact.h promises 1 ulp of the integrals; of the functions tests/runtime/elliptic.c
   requires 2. */
static const hunt_error errors[] = {
    {"K", 1, 0},      {"E", 1, 0},  {"Pi", 1, 0}, {"F_phi", 1, 0}, {"E_phi", 1, 0},
    {"Pi_phi", 1, 0}, {"sn", 2, 0}, {"cn", 2, 0}, {"dn", 2, 0},    {"am", 2, 0}};

static void draw(hunt_random *r, double *g) {
  g[VALUE] = hunt_chance(r, 0.5) ? hunt_mantissa(r, 0) * hunt_size(r, -60, -1) : hunt_uniform(r);
  if (hunt_chance(r, 0.1))
    g[VALUE] *= hunt_size(r, -600, 0);
  g[COMPLEMENT] = (double)hunt_below(r, 2);
  g[CHARACTERISTIC] = hunt_chance(r, 0.5)
                          ? 1 - hunt_mantissa(r, 0) * hunt_size(r, -50, 60)
                          : hunt_sign(r) * hunt_mantissa(r, 0) * hunt_size(r, -60, -1);
  for (int i = PHI; i <= U; i++) {
    g[i] = hunt_sign(r) * hunt_mantissa(r, 0) * hunt_size(r, -20, 5);
    if (hunt_chance(r, 0.3)) /* next to a multiple of pi/2, or of K below */
      g[i] = nearbyint(hunt_size(r, 0, 40)) * 1.5707963267948966 * hunt_near_one(r, 0);
  }
  double K;
  if (hunt_chance(r, 0.5) &&
      ph_elliptic_complete_k(g[COMPLEMENT] != 0 ? ph_modulus_mc(g[VALUE]) : ph_modulus_m(g[VALUE]),
                             &K) == 0)
    g[U] = hunt_sign(r) * nearbyint(hunt_size(r, 0, 30)) * K * hunt_near_one(r, 0);
}

static int prepare(const double *g) {
  return g[VALUE] > (g[COMPLEMENT] != 0 ? 0x1p-120 : 0x1p-900) && g[VALUE] < 1 &&
         g[CHARACTERISTIC] < 1 && fabs(g[CHARACTERISTIC]) < 0x1p100 && fabs(g[PHI]) <= 1e15 &&
         fabs(g[U]) <= 1e15;
}

static double ulps(double have, num want) {
  if (sign(want) == 0)
    return have == 0 ? 0 : HUGE_VAL;
  const long e = mpfr_get_exp(want) - 53;
  const double d = mpfr_get_d(size(sub(real(have), want)), MPFR_RNDN);
  return ldexp(d, e < -1074 ? 1074 : (int)-e);
}

/* E = F - m/3 s^3 R_D(c^2, c^2 + mc s^2, 1) */
static num second(num s, num c, num m, num mc) {
  num s2 = square(s), c2 = square(c), rd;
  num rf = rf_rj(c2, add(c2, mul(mc, s2)), real(1), real(1), &rd);
  return sub(mul(s, rf), mul(over(m, real(3)), mul(mul(s, s2), rd)));
}

static int judge(const double *g, double *error) {
  double have;
  ph_jacobi jacobi;
  const ph_modulus k = g[COMPLEMENT] != 0 ? ph_modulus_mc(g[VALUE]) : ph_modulus_m(g[VALUE]);
  used = 0;
  num v = real(g[VALUE]), rest = sub(real(1), v), m = g[COMPLEMENT] != 0 ? rest : v;
  num mc = g[COMPLEMENT] != 0 ? v : rest, nu = real(-g[CHARACTERISTIC]), third, part;
  num K = legendre(real(1), real(0), mc, nu, &third), E = second(real(1), real(0), m, mc);
  error[K_] = ph_elliptic_complete_k(k, &have) ? HUGE_VAL : ulps(have, K);
  error[E_] = ph_elliptic_complete_e(k, &have) ? HUGE_VAL : ulps(have, E);
  error[PI_] = ph_elliptic_complete_pi(g[CHARACTERISTIC], k, &have) ? HUGE_VAL : ulps(have, third);
  num phi = real(g[PHI]), turns = fresh();
  mpfr_rint(turns, over(phi, pi_times(1)), MPFR_RNDN);
  num r = sub(phi, mul(turns, pi_times(1))), s = sine(r), c = cosine(r), twice = times(2, turns);
  num F = add(legendre(s, c, mc, nu, &part), mul(twice, K));
  error[F_PHI] = ph_elliptic_f(g[PHI], k, &have) ? HUGE_VAL : ulps(have, F);
  error[E_PHI] = ph_elliptic_e(g[PHI], k, &have)
                     ? HUGE_VAL
                     : ulps(have, add(second(s, c, m, mc), mul(twice, E)));
  error[PI_PHI] = ph_elliptic_pi(g[CHARACTERISTIC], g[PHI], k, &have)
                      ? HUGE_VAL
                      : ulps(have, add(part, mul(twice, third)));
  num am = amplitude(real(g[U]), root(mc)), sn = sine(am), cn = cosine(am);
  num dn = root(add(square(cn), mul(mc, square(sn))));
  if (ph_elliptic_jacobi(g[U], k, &jacobi) != 0) {
    error[SN] = error[CN] = error[DN] = error[AM] = HUGE_VAL;
    return 1;
  }
  error[SN] = ulps(jacobi.sn, sn), error[CN] = ulps(jacobi.cn, cn);
  error[DN] = ulps(jacobi.dn, dn), error[AM] = ulps(jacobi.am, am);
  return 1;
}

int main(int argc, char **argv) {
  static const hunt_target target = {"elliptic", 0, GENES, 1,       genes, ERRORS,
                                     errors,     1, draw,  prepare, judge, judge};
  bits = 320; /* of u = 1e15 in multiples of K 50 are lost, of cn next to its zero another 60 */
  pool = malloc(POOL * sizeof *pool);
  return pool ? hunt_main(&target, argc, argv) : 2;
}
