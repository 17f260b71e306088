/* hard_numbers.c - hard cases that are no motions: principal axes, elliptic functions, moments of
   shapes. SPDX-License-Identifier: GPL-3.0-or-later

   Expected values: of matrices that are made of powers of two, by hand; of elliptic functions, by
   the descending Landen transformation with 400 bits (DLMF 22.20); of shapes, formulas in which
   nothing cancels, in long double. */
#include "hard_peers.h"

#include <gsl/gsl_eigen.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_sf_elljac.h>
#include <math.h>
#include <mpfr.h>
#include <stdio.h>

#include "polhode.h"

static void row(const char *what, const char *peer, double theirs, double ours) {
  printf("| %s | %s: ", what, peer);
  printf(isfinite(theirs) ? "%.1e | %.1e |\n" : "no number (%g) | %.1e |\n", theirs, ours);
}

/* Largest relative error of the moments `want`, ascending, by both. */
static void moments(const char *what, const double t[6], const double want[3]) {
  double a[9] = {t[0], t[3], t[4], t[3], t[1], t[5], t[4], t[5], t[2]}, theirs = 0, mine = 0;
  gsl_matrix_view m = gsl_matrix_view_array(a, 3, 3);
  gsl_vector *v = gsl_vector_alloc(3);
  gsl_matrix *e = gsl_matrix_alloc(3, 3);
  gsl_eigen_symmv_workspace *w = gsl_eigen_symmv_alloc(3);
  ph_axes p;
  const int status = ph_principal(t, &p);
  gsl_eigen_symmv(&m.matrix, v, e, w);
  gsl_eigen_symmv_sort(v, e, GSL_EIGEN_SORT_VAL_ASC);
  for (int i = 0; i < 3; i++) {
    theirs = fmax(theirs, fabs(gsl_vector_get(v, (size_t)i) - want[i]) / want[i]);
    mine = fmax(mine, status == 0 ? fabs(p.moment[i] - want[i]) / want[i] : (double)NAN);
  }
  row(what, "gsl_eigen_symmv", theirs, mine);
  gsl_eigen_symmv_free(w);
  gsl_matrix_free(e);
  gsl_vector_free(v);
}

/* sn and cn of u for the complement mc of the parameter. */
static void landen(double u, double mc, double *sn, double *cn) {
  enum { BITS = 400, DEPTH = 40 };
  mpfr_t a[DEPTH], c[DEPTH], b, phi, x;
  int n = 0;
  for (int i = 0; i < DEPTH; i++)
    mpfr_inits2(BITS, a[i], c[i], (mpfr_ptr)NULL);
  mpfr_inits2(BITS, b, phi, x, (mpfr_ptr)NULL);
  mpfr_set_ui(a[0], 1, MPFR_RNDN);
  mpfr_set_d(b, mc, MPFR_RNDN);
  mpfr_sqrt(b, b, MPFR_RNDN);
  for (; n + 1 < DEPTH; n++) {
    mpfr_sub(c[n + 1], a[n], b, MPFR_RNDN);
    mpfr_div_2ui(c[n + 1], c[n + 1], 1, MPFR_RNDN);
    mpfr_add(a[n + 1], a[n], b, MPFR_RNDN);
    mpfr_div_2ui(a[n + 1], a[n + 1], 1, MPFR_RNDN);
    mpfr_mul(b, a[n], b, MPFR_RNDN);
    mpfr_sqrt(b, b, MPFR_RNDN);
  }
  mpfr_mul_d(phi, a[n], u, MPFR_RNDN);
  mpfr_mul_2ui(phi, phi, (unsigned long)n, MPFR_RNDN);
  for (; n > 0; n--) {
    mpfr_sin(x, phi, MPFR_RNDN);
    mpfr_mul(x, x, c[n], MPFR_RNDN);
    mpfr_div(x, x, a[n], MPFR_RNDN);
    mpfr_asin(x, x, MPFR_RNDN);
    mpfr_add(phi, phi, x, MPFR_RNDN);
    mpfr_div_2ui(phi, phi, 1, MPFR_RNDN);
  }
  mpfr_sin(x, phi, MPFR_RNDN);
  *sn = mpfr_get_d(x, MPFR_RNDN);
  mpfr_cos(x, phi, MPFR_RNDN);
  *cn = mpfr_get_d(x, MPFR_RNDN);
  for (int i = 0; i < DEPTH; i++)
    mpfr_clears(a[i], c[i], (mpfr_ptr)NULL);
  mpfr_clears(b, phi, x, (mpfr_ptr)NULL);
}

static void elliptic(const char *what, double u, double mc) {
  double sn, cn, s = NAN, c = NAN, d;
  ph_jacobi j;
  landen(u, mc, &sn, &cn);
  const int status = gsl_sf_elljac_e(u, 1 - mc, &s, &c, &d);
  const int own = ph_elliptic_jacobi(u, ph_modulus_mc(mc), &j);
  row(what, "gsl_sf_elljac_e", status == 0 ? fmax(fabs(s - sn), fabs(c - cn)) : (double)NAN,
      own == 0 ? fmax(fabs(j.sn - sn), fabs(j.cn - cn)) : (double)NAN);
}

static void shapes(void) {
  ph_body b, moved;
  double t[6], back[6];
  const double r = 1, thin = 1 - 0x1p-40;
  /* 2/5 m (R^5 - r^5)/(R^3 - r^3): the quotient by R - r */
  ph_solid_hollow_sphere(&b, ph_amount_density(1000), thin, r);
  ph_tensor_about(&b, (double[3]){0, 0, 0}, t);
  const long double x = thin, five = 1 + x * (1 + x * (1 + x * (1 + x)));
  const double want = (double)(8.0L / 15 * 3.14159265358979323846264L * 1000 * 0x1p-40L * five);
  const double naive = 8.0 / 15 * M_PI * 1000 * (pow(r, 5) - pow(thin, 5));
  row("a shell of 2^-40 of its radius", "r^5 - r_in^5", fabs(naive - want) / want,
      fabs(t[0] - want) / want);
  /* a unit cube 1e9 m away, about its own centre again */
  const double d[3] = {1e9, -1e9, 1e9}, com[3] = {1e9, -1e9, 1e9};
  ph_solid_box(&b, ph_amount_mass(6), 1, 1, 1);
  ph_body_at(&moved, &b, d);
  ph_tensor_about(&moved, com, back);
  const double far = 6 * (1 + 1) / 12.0 + 6 * (1e9 * 1e9 + 1e9 * 1e9),
               near = far - 6 * (1e9 * 1e9 + 1e9 * 1e9);
  row("a cube 1e9 m from the origin, about its centre", "Steiner there and back", fabs(near - 1),
      fabs(back[0] - 1));
}

void hard_numbers(void) {
  const double e = 0x1p-40, k = 0x1p-50;
  printf("| case | theirs | polhode's library |\n|---|---|---|\n");
  gsl_set_error_handler_off();
  moments("moments of a needle, 2^-40, turned by 45 degrees",
          (double[6]){(1 + e) / 2, (1 + e) / 2, 1, (e - 1) / 2, 0, 0}, (double[3]){e, 1, 1});
  moments("moments 1 - 2^-50 and 1 + 2^-50, turned so", (double[6]){1, 1, 0.5, k, 0, 0},
          (double[3]){0.5, 1 - k, 1 + k});
  moments("moments graded, 1e-200 to 1", (double[6]){1e-200, 1, 2, 0, 0, 0},
          (double[3]){1e-200, 1, 2});
  moments("moments of 1e300", (double[6]){1e300, 1e300, 2e300, 0.5e300, 0, 0},
          (double[3]){0.5e300, 1.5e300, 2e300});
  elliptic("sn, cn at u = 12, 1 - m = 1e-10", 12, 1e-10);
  elliptic("sn, cn at u = 30, 1 - m = 1e-20", 30, 1e-20);
  elliptic("sn, cn at u = 1e6, 1 - m = 1e-3", 1e6, 1e-3);
  elliptic("sn, cn at u = 1e15, 1 - m = 1/2", 1e15, 0.5);
  shapes();
}
