/* elliptic.c - elliptic integrals and functions against tables of 32 digits, GSL beside them.
   SPDX-License-Identifier: GPL-3.0-or-later

   Oracle: tests/reference/elliptic.h (mpmath, two methods each). The bar is two units in the last
   place of double at the value for each function that is not near a zero; where a function is
   small because its argument is near a zero, the argument is exact, so the bar stays. GSL is
   measured in the same units where it has the function, and only reported. */
#include <float.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_sf_ellint.h>
#include <gsl/gsl_sf_elljac.h>
#include <math.h>
#include <stdint.h>

#include "polhode.h"
#include "reference/elliptic.h"
#include "tap.h"

#define COUNT(table) (sizeof(table) / sizeof(table)[0])

/* |got - want| in units of the last place of want. */
static double ulps(double got, long double want) {
  if (want == 0)
    return got == 0 ? 0 : HUGE_VAL;
  int e;
  frexpl(want, &e);
  const long double unit = ldexpl(1, e - 53 < -1074 ? -1074 : e - 53);
  const long double d = fabsl((long double)got - want) / unit;
  return d < HUGE_VALL ? (double)d : HUGE_VAL; /* NaN too */
}

enum { SN, CN, DN, AM, F_, E_, PI_, K_, EC, PIC, FUNCTIONS };
static const char *const names[FUNCTIONS] = {"sn",     "cn",         "dn", "am", "F(phi)",
                                             "E(phi)", "Pi(n, phi)", "K",  "E",  "Pi(n)"};

typedef struct worst {
  double ulp;
  size_t row, rows, failed; /* failed: above 2 ulp, or none at all */
} worst;

static void note(worst *w, double ulp, size_t row) {
  w->rows++;
  w->failed += !(ulp <= 2);
  if (!(ulp <= w->ulp))
    w->ulp = ulp, w->row = row;
}

static ph_modulus modulus(size_t i) {
  return elliptic_rows[i].complement ? ph_modulus_mc(elliptic_rows[i].value)
                                     : ph_modulus_m(elliptic_rows[i].value);
}

static double or_nan(int status, double v) {
  return status ? (double)NAN : v;
}

static void ours(size_t i, worst w[FUNCTIONS]) {
  const ph_modulus m = modulus(i);
  double v = 0;
  if (elliptic_rows[i].kind == ELLIPTIC_JACOBI) {
    ph_jacobi j = {0, 0, 0, 0};
    const int s = ph_elliptic_jacobi(elliptic_rows[i].u, m, &j);
    note(&w[SN], ulps(or_nan(s, j.sn), elliptic_rows[i].sn), i);
    note(&w[CN], ulps(or_nan(s, j.cn), elliptic_rows[i].cn), i);
    note(&w[DN], ulps(or_nan(s, j.dn), elliptic_rows[i].dn), i);
    note(&w[AM], ulps(or_nan(s, j.am), elliptic_rows[i].am), i);
  } else if (elliptic_rows[i].kind == ELLIPTIC_INCOMPLETE) {
    const double phi = elliptic_rows[i].phi, n = elliptic_rows[i].n;
    int s = ph_elliptic_f(phi, m, &v);
    note(&w[F_], ulps(or_nan(s, v), elliptic_rows[i].F), i);
    s = ph_elliptic_e(phi, m, &v);
    note(&w[E_], ulps(or_nan(s, v), elliptic_rows[i].E), i);
    if (isfinite(elliptic_rows[i].n)) {
      s = ph_elliptic_pi(n, phi, m, &v);
      note(&w[PI_], ulps(or_nan(s, v), elliptic_rows[i].Pi), i);
    }
  } else {
    int s = ph_elliptic_complete_k(m, &v);
    note(&w[K_], ulps(or_nan(s, v), elliptic_rows[i].F), i);
    s = ph_elliptic_complete_e(m, &v);
    note(&w[EC], ulps(or_nan(s, v), elliptic_rows[i].E), i);
    if (isfinite(elliptic_rows[i].n)) {
      s = ph_elliptic_complete_pi(elliptic_rows[i].n, m, &v);
      note(&w[PIC], ulps(or_nan(s, v), elliptic_rows[i].Pi), i);
    }
  }
}

/* GSL takes m for Jacobi's functions and k for the integrals, and the other sign of n. */
static void gsl(size_t i, worst w[FUNCTIONS]) {
  const double m =
      elliptic_rows[i].complement ? 1 - elliptic_rows[i].value : elliptic_rows[i].value;
  const double k = sqrt(m), phi = elliptic_rows[i].phi, n = elliptic_rows[i].n;
  const gsl_mode_t mode = GSL_PREC_DOUBLE;
  gsl_sf_result r = {0, 0};
  if (elliptic_rows[i].kind == ELLIPTIC_JACOBI) {
    double sn = 0, cn = 0, dn = 0;
    const int s = gsl_sf_elljac_e(elliptic_rows[i].u, m, &sn, &cn, &dn);
    note(&w[SN], ulps(or_nan(s, sn), elliptic_rows[i].sn), i);
    note(&w[CN], ulps(or_nan(s, cn), elliptic_rows[i].cn), i);
    note(&w[DN], ulps(or_nan(s, dn), elliptic_rows[i].dn), i);
  } else if (elliptic_rows[i].kind == ELLIPTIC_INCOMPLETE) {
    int s = gsl_sf_ellint_F_e(phi, k, mode, &r);
    note(&w[F_], ulps(or_nan(s, r.val), elliptic_rows[i].F), i);
    s = gsl_sf_ellint_E_e(phi, k, mode, &r);
    note(&w[E_], ulps(or_nan(s, r.val), elliptic_rows[i].E), i);
    if (isfinite(elliptic_rows[i].n)) {
      s = gsl_sf_ellint_P_e(phi, k, -n, mode, &r);
      note(&w[PI_], ulps(or_nan(s, r.val), elliptic_rows[i].Pi), i);
    }
  } else {
    int s = gsl_sf_ellint_Kcomp_e(k, mode, &r);
    note(&w[K_], ulps(or_nan(s, r.val), elliptic_rows[i].F), i);
    s = gsl_sf_ellint_Ecomp_e(k, mode, &r);
    note(&w[EC], ulps(or_nan(s, r.val), elliptic_rows[i].E), i);
    if (isfinite(elliptic_rows[i].n)) {
      s = gsl_sf_ellint_Pcomp_e(k, -n, mode, &r);
      note(&w[PIC], ulps(or_nan(s, r.val), elliptic_rows[i].Pi), i);
    }
  }
}

/* ---- every argument ---- */

static uint64_t seed = 0x9e3779b97f4a7c15;

static double uniform(void) { /* xorshift64* (Vigna 2016), in [0, 1) */
  seed ^= seed >> 12, seed ^= seed << 25, seed ^= seed >> 27;
  return (double)(seed * 0x2545f4914f6cdd1d >> 11) * 0x1p-53;
}

static double any_size(void) {
  return (uniform() < 0.5 ? -1 : 1) * pow(10, 600 * uniform() - 320);
}

/* 1 - a a - b b of two doubles: each rounded once, so the sum is off by 2^-53 of each square times
   two, 4.5e-16 at most; b may come with a factor m. */
static void identities(void) {
  double circle = 0, delta = 0;
  int failed = 0, finite = 1, ordered = 1;
  for (int i = 0; i < 100000; i++) {
    const double part = uniform() < 0.5 ? uniform() : fmin(1, fabs(any_size()));
    const ph_modulus m = i % 2 ? ph_modulus_m(part) : ph_modulus_mc(part);
    const double u = i % 3 ? 20 * uniform() - 10 : any_size();
    const double n = i % 5 ? 1 - fabs(any_size()) : uniform();
    ph_jacobi j;
    double F = 0, E = 0, Pi = 0;
    failed += ph_elliptic_jacobi(u, m, &j) != PH_OK;
    const long double sn = (long double)j.sn, cn = (long double)j.cn, dn = (long double)j.dn;
    const long double k2 = i % 2 ? (long double)part : 1 - (long double)part;
    circle = fmax(circle, (double)fabsl(sn * sn + cn * cn - 1));
    delta = fmax(delta, (double)fabsl(dn * dn + k2 * sn * sn - 1));
    const int one = ph_elliptic_f(u, m, &F), two = ph_elliptic_e(u, m, &E);
    const int three = n < 1 ? ph_elliptic_pi(n, u, m, &Pi) : PH_OK;
    failed += (one != PH_OK && one != PH_ERANGE) || two != PH_OK ||
              (three != PH_OK && three != PH_ERANGE);
    finite = finite && isfinite(F) && isfinite(E) && isfinite(Pi) && isfinite(j.am);
    /* E <= phi <= F where phi > 0 */
    ordered = ordered && (one != PH_OK || (fabs(E) <= fabs(u) && fabs(u) <= fabs(F)));
  }
  ok(failed == 0 && finite, "no argument gives NaN or a wrong refusal");
  near(circle, 0, 2 * DBL_EPSILON, "sn^2 + cn^2 = 1");
  near(delta, 0, 2 * DBL_EPSILON, "dn^2 + m sn^2 = 1");
  ok(ordered, "|E| <= |phi| <= |F|");
}

static void refusals(void) {
  double v = 7;
  ph_jacobi j = {7, 7, 7, 7};
  const ph_modulus half = ph_modulus_m(0.5),
                   bad[3] = {ph_modulus_m(-0.5), ph_modulus_mc(1.5), ph_modulus_m(1 + DBL_EPSILON)};
  int all = 1;
  for (int i = 0; i < 3; i++)
    all = all && ph_elliptic_jacobi(1, bad[i], &j) == PH_EBOUND &&
          ph_elliptic_f(1, bad[i], &v) == PH_EBOUND &&
          ph_elliptic_complete_e(bad[i], &v) == PH_EBOUND;
  ok(all, "m outside [0, 1] is refused");
  ok(ph_elliptic_pi(1, 0.5, half, &v) == PH_EBOUND &&
         ph_elliptic_complete_pi(2, half, &v) == PH_EBOUND,
     "n >= 1 is refused");
  ok(ph_elliptic_complete_k(ph_modulus_m(1), &v) == PH_ERANGE &&
         ph_elliptic_f(2, ph_modulus_mc(0), &v) == PH_ERANGE,
     "K(1) is infinite");
  ok(ph_elliptic_jacobi((double)NAN, half, &j) == PH_EFINITE &&
         ph_elliptic_f((double)INFINITY, half, &v) == PH_EFINITE &&
         ph_elliptic_complete_pi((double)NAN, half, &v) == PH_EFINITE &&
         ph_elliptic_complete_k(ph_modulus_m((double)NAN), &v) == PH_EFINITE,
     "numbers that are not finite are refused");
  ok(v == 7 && j.sn == 7, "and nothing is written");
  ok(ph_elliptic_e(2, ph_modulus_m(1), &v) == PH_OK && fabs(v - (2 - sin(2))) <= DBL_EPSILON,
     "E(2 | 1) = 2 - sin 2");
}

int main(void) {
  worst mine[FUNCTIONS] = {{0, 0, 0, 0}}, theirs[FUNCTIONS] = {{0, 0, 0, 0}};
  gsl_set_error_handler_off();
  for (size_t i = 0; i < COUNT(elliptic_rows); i++) {
    ours(i, mine);
    gsl(i, theirs);
  }
  for (int f = 0; f < FUNCTIONS; f++) {
    ok(mine[f].rows > 0 && mine[f].failed == 0, "%s is right to 2 ulp in all %zu rows (worst %.3g)",
       names[f], mine[f].rows, mine[f].ulp);
    if (mine[f].failed) {
      const size_t i = mine[f].row;
      diag("  %zu rows; value %.17g complement %d u %.17g phi %.17g n %.17g", mine[f].failed,
           elliptic_rows[i].value, elliptic_rows[i].complement, elliptic_rows[i].u,
           elliptic_rows[i].phi, elliptic_rows[i].n);
    }
    if (theirs[f].rows) {
      const size_t i = theirs[f].row;
      diag("  GSL: %zu of %zu rows above 2 ulp or refused, worst %.3g (value %g complement %d u %g "
           "phi "
           "%g n %g)",
           theirs[f].failed, theirs[f].rows, theirs[f].ulp, elliptic_rows[i].value,
           elliptic_rows[i].complement, elliptic_rows[i].u, elliptic_rows[i].phi,
           elliptic_rows[i].n);
    }
  }
  identities();
  refusals();
  return tap_done();
}
