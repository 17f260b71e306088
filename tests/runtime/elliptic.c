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
  return tap_done();
}
