/* principal.c - the hunt's target: principal moments and axes of any symmetric tensor.
   SPDX-License-Identifier: GPL-3.0-or-later

   The emitted NAME_principal_of (SINGLE: float) and the library's ph_principal. Moments are in
   units of the last place of the largest, skewness |e_i . e_k - d_ik| and residue |I e - m e|, the
   latter over the largest moment, in units of 2^-52 or 2^-23. The last two need no oracle, only
   digits; the fast road is long double, the slow one Jacobi's method in MPFR. Errors of the library
   are in the units of double. */
#include "search.h"
#include "tensor.h"
#include "numbers/wide.h"

#define main free_top_main
#include "../oracle/free_top.c"
#undef main

typedef tensor_real real_type;

#ifdef SINGLE
enum { DIGITS = 24, SCALE = 15 };
#else
enum { DIGITS = 53, SCALE = 60 };
#endif

enum { MOMENTS, SKEW, RESIDUE, LIBRARY_MOMENTS, LIBRARY_SKEW, LIBRARY_RESIDUE, ERRORS };

static const hunt_gene genes[] = {{"xx", HUNT_SIGNED, 0}, {"yy", HUNT_SIGNED, 0},
                                  {"zz", HUNT_SIGNED, 0}, {"xy", HUNT_SIGNED, 0},
                                  {"xz", HUNT_SIGNED, 0}, {"yz", HUNT_SIGNED, 0}};

/* What tests/emit/principal.t promises, and why. */
static const hunt_error errors[] = {
    {"moments", 1, 0},         {"skew", 1.000001, 0},         {"residue", 1.004, 0},
    {"library_moments", 1, 1}, {"library_skew", 1.000001, 1}, {"library_residue", 1.004, 1}};

static const int place[3][3] = {{0, 3, 4}, {3, 1, 5}, {4, 5, 2}};

static void draw(hunt_random *r, double *g) {
  const int single = DIGITS == 24;
  const double size = hunt_size(r, -SCALE, SCALE);
  for (int i = 0; i < 6; i++) {
    g[i] = hunt_sign(r) * hunt_mantissa(r, single);
    if (hunt_chance(r, 0.15))
      g[i] = 0;
    else if (hunt_chance(r, 0.3))
      g[i] *= hunt_size(r, -DIGITS - 10, 0);
  }
  if (hunt_chance(r, 0.3)) /* nearly equal, a body's */
    for (int i = 1; i < 3; i++)
      g[i] = g[0] * hunt_near_one(r, single);
  if (hunt_chance(r, 0.2)) { /* graded: D H D */
    const double d[3] = {1, hunt_size(r, -DIGITS / 2, 0), hunt_size(r, -DIGITS / 2, 0)};
    for (int i = 0; i < 3; i++)
      for (int k = i; k < 3; k++)
        g[place[i][k]] *= d[i] * d[k];
  }
  for (int i = 0; i < 6; i++)
    g[i] *= size;
}

static int prepare(const double *g) {
  double most = 0;
  for (int i = 0; i < 6; i++) {
    if (g[i] != 0 && fabs(g[i]) < exp2(-3 * SCALE))
      return 0;
    most = fmax(most, fabs(g[i]));
  }
  return most > exp2(-SCALE - 4) && most < exp2(SCALE + 4);
}

static int emitted(const double *g, double moment[3], double axis[3][3]) {
  real_type I[6], m[3], e[9];
  for (int i = 0; i < 6; i++)
    I[i] = (real_type)g[i];
  if (tensor_principal_of(I, m, e) != 0)
    return 0;
  for (int i = 0; i < 9; i++)
    axis[i / 3][i % 3] = (double)e[i];
  for (int i = 0; i < 3; i++)
    moment[i] = (double)m[i];
  return 1;
}

static double ulp_of(double norm, int digits) {
  int e;
  frexp(norm, &e);
  return ldexp(1, e - digits);
}

/* error[0..2] of moments and axes: SKEW and RESIDUE in long double. */
static void measured(const double *g, const double moment[3], double axis[3][3], int digits,
                     double *error) {
  const double eps = ldexp(1, 1 - digits);
  ph_wide skew = 0, residue = 0, most = 0;
  for (int i = 0; i < 3; i++)
    most = fmaxl(most, fabsl((ph_wide)moment[i]));
  for (int i = 0; i < 3; i++) {
    ph_wide length = 0;
    for (int k = 0; k <= i; k++) {
      ph_wide dot = i == k ? -1 : 0;
      for (int n = 0; n < 3; n++)
        dot += (ph_wide)axis[i][n] * axis[k][n];
      skew = fmaxl(skew, fabsl(dot));
    }
    for (int k = 0; k < 3; k++) {
      ph_wide rest = -(ph_wide)moment[i] * axis[i][k];
      for (int n = 0; n < 3; n++)
        rest += (ph_wide)g[place[k][n]] * axis[i][n];
      length += rest * rest;
    }
    residue = fmaxl(residue, sqrtl(length));
  }
  error[SKEW] = (double)(skew / eps);
  error[RESIDUE] = most > 0 ? (double)(residue / most / eps) : 0;
}

static int measure(const double *g, double *error) {
  ph_wide tensor[6], moment[3], axis[3][3], off = 0, most = 0;
  double m[3], e[3][3];
  if (!emitted(g, m, e))
    return 0;
  wide_load(6, g, tensor);
  wide_eigen(tensor, moment, axis);
  for (int i = 0; i < 3; i++) {
    off = fmaxl(off, fabsl(m[i] - moment[i]));
    most = fmaxl(most, fabsl(moment[i]));
  }
  error[MOMENTS] = (double)off / ulp_of((double)most, DIGITS);
  measured(g, m, e, DIGITS, error);
  return 1;
}

static double moments_off(num a[3][3], const double moment[3], int digits) {
  num v[3] = {a[0][0], a[1][1], a[2][2]}, off = real(0), most = real(0);
  for (int i = 0; i < 3; i++)
    for (int k = i; k > 0 && mpfr_cmp(v[k], v[k - 1]) < 0; k--) {
      num keep = v[k];
      v[k] = v[k - 1], v[k - 1] = keep;
    }
  for (int i = 0; i < 3; i++) {
    off = larger(size(sub(real(moment[i]), v[i])), off);
    most = larger(size(v[i]), most);
  }
  return mpfr_get_d(off, MPFR_RNDN) / ulp_of(mpfr_get_d(most, MPFR_RNDN), digits);
}

static int judge(const double *g, double *error) {
  double m[3], e[3][3];
  ph_axes library;
  num a[3][3], axis[3][3];
  used = 0;
  for (int i = 0; i < 3; i++)
    for (int k = 0; k < 3; k++)
      a[i][k] = real(g[place[i][k]]);
  principal(a, axis);
  if (!emitted(g, m, e) || ph_principal(g, &library) != 0)
    return 0;
  error[MOMENTS] = moments_off(a, m, DIGITS);
  measured(g, m, e, DIGITS, error);
  error[LIBRARY_MOMENTS] = moments_off(a, library.moment, 53);
  measured(g, library.moment, library.axis, 53, error + LIBRARY_MOMENTS);
  return 1;
}

int main(int argc, char **argv) {
  static const hunt_target target = {
      "principal", DIGITS == 24, 6, 1, genes, ERRORS, errors, 1, draw, prepare, measure, judge};
  bits = 320;
  pool = malloc(POOL * sizeof *pool);
  return pool ? hunt_main(&target, argc, argv) : 2;
}
