/* principal.c - principal moments and axes against references of 32 digits, and what is promised of
   the axes. SPDX-License-Identifier: GPL-3.0-or-later

   All rows of the eigenvalue set: equal and nearly equal moments, graded tensors of up to 600
   decades, rank one, indefinite, subnormal and nearly overflowing ones. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "polhode.h"
#include "reference/eigen.h"
#include "tap.h"

/* Moments are rounded once: half an ulp each; the requirement is 2 ulp of the largest, and 1e-14 of
   itself where the tensor is positive definite and well scaled. */
static const long double TOL_NORM = 2 * (long double)DBL_EPSILON, TOL_GRADED = 1e-14L;
/* Three rounded unit vectors: |e_i . e_j - d_ij| <= 2 * 2^-53. */
static const double TOL_ORTHONORMAL = 4e-16;

static long double worst_norm, worst_relative;

static void check_axes(const char *id, const double I[6], const ph_axes *p) {
  long double worst = 0, cross[3], size = 0, residual = 0;
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++) {
      long double dot = 0;
      for (int k = 0; k < 3; k++)
        dot += (long double)p->axis[i][k] * (long double)p->axis[j][k];
      worst = fmaxl(worst, fabsl(dot - (i == j)));
    }
  near((double)worst, 0, TOL_ORTHONORMAL, "%s: axes are orthonormal", id);
  long double handed = 0;
  for (int k = 0; k < 3; k++) {
    const int a = (k + 1) % 3, b = (k + 2) % 3;
    cross[k] = (long double)p->axis[0][a] * (long double)p->axis[1][b] -
               (long double)p->axis[0][b] * (long double)p->axis[1][a];
    handed += cross[k] * (long double)p->axis[2][k];
  }
  ok(handed > 0.9L && p->moment[0] <= p->moment[1] && p->moment[1] <= p->moment[2],
     "%s: axes are right-handed, moments ascending", id);
  for (int k = 0; k < 3; k++) { /* I e = moment e */
    size = fmaxl(size, fabsl((long double)p->moment[k]));
    const double *e = p->axis[k];
    const long double m[3][3] = {{(long double)I[0], (long double)I[3], (long double)I[4]},
                                 {(long double)I[3], (long double)I[1], (long double)I[5]},
                                 {(long double)I[4], (long double)I[5], (long double)I[2]}};
    for (int i = 0; i < 3; i++)
      residual = fmaxl(residual, fabsl(m[i][0] * (long double)e[0] + m[i][1] * (long double)e[1] +
                                       m[i][2] * (long double)e[2] -
                                       (long double)p->moment[k] * (long double)e[i]));
  }
  /* axis off by half an ulp times the norm, moment by half an ulp; subnormal moments by their
   * spacing */
  near((double)(residual / size), 0, 4 * DBL_EPSILON + DBL_TRUE_MIN / (double)size,
       "%s: I e = moment e", id);
}

static void reference_rows(void) {
  for (size_t r = 0; r < sizeof eigen_rows / sizeof eigen_rows[0]; r++) {
    const char *id = eigen_rows[r].id;
    const long double *want = eigen_rows[r].value;
    const long double norm = fmaxl(fabsl(want[0]), fabsl(want[2]));
    const long double spacing = (long double)DBL_TRUE_MIN; /* of subnormal results */
    ph_axes p;
    if (!ok(ph_principal(eigen_rows[r].tensor, &p) == PH_OK, "%s has principal axes", id))
      continue;
    near_all_wide(3, p.moment, want, TOL_NORM * norm + spacing,
                  "%s: moments to 2 ulp of the largest", id);
    for (int k = 0; k < 3; k++) {
      const long double error = fabsl((long double)p.moment[k] - want[k]);
      if (norm > (long double)DBL_MIN)
        worst_norm = fmaxl(worst_norm, error / norm);
      if (want[0] > 0 && norm > (long double)DBL_MIN) {
        worst_relative = fmaxl(worst_relative, error / want[k]);
        near(p.moment[k], want[k], TOL_GRADED * want[k] + spacing,
             "%s: moment %d to 1e-14 of itself", id, k);
      }
      if (eigen_rows[r].simple[k]) {
        /* an axis turns by (rounding of the result) + (rounding in long double) * norm / gap */
        long double gap = HUGE_VALL, dot = 0, off = 0;
        for (int j = 0; j < 3; j++)
          if (j != k)
            gap = fminl(gap, fabsl(want[j] - want[k]));
        for (int i = 0; i < 3; i++)
          dot += (long double)p.axis[k][i] * eigen_rows[r].axis[k][i];
        for (int i = 0; i < 3; i++)
          off = fmaxl(
              off, fabsl((long double)p.axis[k][i] - copysignl(1, dot) * eigen_rows[r].axis[k][i]));
        near((double)off, 0, DBL_EPSILON + (double)(8 * LDBL_EPSILON * norm / gap), "%s: axis %d",
             id, k);
      }
    }
    check_axes(id, eigen_rows[r].tensor, &p);
  }
}

static void choices(void) {
  ph_axes p;
  const double one[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  ph_principal((const double[]){2, 2, 2, 0, 0, 0}, &p);
  ok(memcmp(p.axis, one, sizeof one) == 0, "a sphere's axes are the coordinate axes");
  ph_principal((const double[]){1, 2, 3, 0, 0, 0}, &p);
  ok(memcmp(p.axis, one, sizeof one) == 0, "a diagonal ascending tensor keeps its axes");
  ph_principal((const double[]){2, 2, 1, 0, 0, 0}, &p);
  near_all(
      9, &p.axis[0][0], ((const double[]){0, 0, 1, 1, 0, 0, 0, 1, 0}), 0,
      "an upright rod's axes are z, x, y: right-handed, equal moments in the order of the axes");
  /* (1, -1, 0): equal components decide by position, not by rounding */
  for (int k = 0; k < 5; k++) {
    const double shake = k * DBL_EPSILON;
    ph_principal((const double[]){2 + shake, 2 - shake, 5, 1, 0, 0}, &p);
    ok(p.axis[0][0] > 0.7 && p.axis[1][0] > 0.7,
       "equal components: the first is positive, %d ulp of noise do not flip it", k);
  }
  double shrunk[6], I[6] = {3, 2, 2.5, 0.5, -0.25, 0.125};
  ph_axes q;
  for (int i = 0; i < 6; i++)
    shrunk[i] = I[i] * 0x1p-900;
  ph_principal(I, &p);
  ph_principal(shrunk, &q);
  ok(memcmp(p.axis, q.axis, sizeof p.axis) == 0 && q.moment[1] == p.moment[1] * 0x1p-900,
     "a tensor 2^-900 times smaller has the same axes, bit by bit");
}

int main(void) {
  reference_rows();
  choices();
  diag("worst error of a moment: %.2Lf ulp of the largest, %.3Lg of itself where positive definite",
       worst_norm / (long double)DBL_EPSILON, worst_relative);
  return tap_done();
}
