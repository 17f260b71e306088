/* eigen.c - eigenvalues and axes of a symmetric 3x3 matrix by Jacobi's method, in long double.
   SPDX-License-Identifier: GPL-3.0-or-later

   Why Jacobi and not QR (gsl_eigen_symmv) or the cubic: a rod, a plate or a far origin gives a
   graded tensor, and QR loses the small moments at 1 ulp of the largest. Jacobi's rotations,
   stopped by the RELATIVE size a_pq against sqrt(a_pp a_qq), give each eigenvalue of a positive
   definite matrix to a few ulp times the condition of the matrix scaled to unit diagonal (Demmel,
   Veselic: Jacobi's method is more accurate than QR, SIAM J. Matrix Anal. Appl. 13, 1992,
   theorem 2.3). The axes come out orthogonal by construction, equal eigenvalues included, and a
   diagonal matrix is left as it is. Rotation: Rutishauser's form (Wilkinson and Reinsch, Handbook
   II/1), the smaller of the two angles. */
#include "wide.h"

/* With one product of inertia zero, a rotation multiplies the smaller of the other two by a sine of
 * at most sqrt(1/2), and the row-cyclic order takes the larger one next: 180 rotations bring any
 * matrix below 2^-88 of its norm, whatever its eigenvalues. As a rule convergence is quadratic,
 * in 4 to 6 sweeps. */
enum { MAX_SWEEPS = 60 };

/* Zero a[p][q] by a rotation in the plane (p, q); the columns of v turn along. */
static void rotate(ph_wide a[3][3], ph_wide v[3][3], int p, int q) {
  const int r = 3 - p - q;
  const ph_wide apq = a[p][q];
  const ph_wide theta = (a[q][q] - a[p][p]) / (2 * apq);
  const ph_wide t = (theta < 0 ? -1 : 1) / (fabsl(theta) + sqrtl(theta * theta + 1));
  const ph_wide c = 1 / sqrtl(t * t + 1), s = t * c;
  a[p][p] -= t * apq;
  a[q][q] += t * apq;
  a[p][q] = a[q][p] = 0;
  const ph_wide arp = a[r][p], arq = a[r][q];
  a[r][p] = a[p][r] = c * arp - s * arq;
  a[r][q] = a[q][r] = s * arp + c * arq;
  for (int i = 0; i < 3; i++) {
    const ph_wide vip = v[i][p], viq = v[i][q];
    v[i][p] = c * vip - s * viq;
    v[i][q] = s * vip + c * viq;
  }
}

/* The sign of an axis: the first component within 1/16 of the largest one is made positive, so that
   rounding decides nothing when two components are equal in size, as in (1, -1, 0). */
static void fix_sign(ph_wide e[3]) {
  ph_wide largest = 0;
  for (int i = 0; i < 3; i++)
    largest = fmaxl(largest, fabsl(e[i]));
  int first = 0;
  while (fabsl(e[first]) < largest * 15 / 16)
    first++;
  if (e[first] < 0)
    for (int i = 0; i < 3; i++)
      e[i] = -e[i];
}

void wide_eigen(const ph_wide s[6], ph_wide moment[3], ph_wide axis[3][3]) {
  ph_wide a[3][3] = {{s[XX], s[XY], s[XZ]}, {s[XY], s[YY], s[YZ]}, {s[XZ], s[YZ], s[ZZ]}};
  ph_wide v[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int sweep = 0, turned = 1; turned && sweep < MAX_SWEEPS; sweep++) {
    turned = 0;
    for (int p = 0; p < 2; p++)
      for (int q = p + 1; q < 3; q++) {
        const ph_wide small = LDBL_EPSILON / 4 * sqrtl(fabsl(a[p][p])) * sqrtl(fabsl(a[q][q]));
        if (fabsl(a[p][q]) > small) {
          rotate(a, v, p, q);
          turned = 1;
        }
      }
  }
  int order[3] = {0, 1,
                  2}; /* insertion sort: stable, so equal moments keep the order of the axes */
  for (int i = 1; i < 3; i++)
    for (int j = i; j > 0 && a[order[j]][order[j]] < a[order[j - 1]][order[j - 1]]; j--) {
      const int k = order[j];
      order[j] = order[j - 1], order[j - 1] = k;
    }
  ph_wide e[3][3];
  for (int k = 0; k < 3; k++) {
    for (int i = 0; i < 3; i++)
      e[k][i] = v[i][order[k]];
    const ph_wide n = wide_norm(e[k]);
    for (int i = 0; i < 3; i++)
      e[k][i] /= n;
  }
  fix_sign(e[0]);
  fix_sign(e[1]);
  wide_cross(e[0], e[1], e[2]);
  for (int k = 0; k < 3; k++) {
    moment[k] = a[order[k]][order[k]];
    for (int i = 0; i < 3; i++)
      axis[k][i] = e[k][i];
  }
}

int wide_nullity(const ph_wide tensor[6]) {
  /* Six doubles, each right to a few ulp, do not tell I from a singular tensor if I scaled to unit
     diagonal, D^-1/2 I D^-1/2, has an eigenvalue of a few ulp. Scaling makes the test
     componentwise: a diagonal tensor with moments 1e-40, 1, 1 is regular, a rod askew whose rounded
     tensor has a third moment of 1e-17 is not. 8 ulp: three entries meet in a row, each off by one
     or two. */
  ph_wide d[3], unit[3][3];
  for (int i = 0; i < 3; i++)
    d[i] = tensor[i] > 0 ? 1 / sqrtl(tensor[i]) : 0;
  const ph_wide scaled[6] = {d[0] * tensor[XX] * d[0], d[1] * tensor[YY] * d[1],
                             d[2] * tensor[ZZ] * d[2], d[0] * tensor[XY] * d[1],
                             d[0] * tensor[XZ] * d[2], d[1] * tensor[YZ] * d[2]};
  ph_wide value[3];
  wide_eigen(scaled, value, unit);
  int zeros = 0;
  for (int i = 0; i < 3; i++)
    zeros += value[i] <= 8 * (ph_wide)DBL_EPSILON;
  return zeros;
}
