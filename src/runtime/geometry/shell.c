/* shell.c - the ellipsoid's surface with uniform areal density.
   SPDX-License-Identifier: GPL-3.0-or-later

   With the unit sphere's point n, r = (a n1, b n2, c n3), the surface element is
       dS = sqrt(b^2 c^2 n1^2 + a^2 c^2 n2^2 + a^2 b^2 n3^2) dOmega,   a >= b >= c.
   Longitude: complete elliptic integrals by Landen's transformation. Latitude: tan = e^v and the
   trapezoidal rule in v. There the integrand is analytic for |Im v| < pi/2 whatever the axes are
   (1 + e^2v and c^2 + e^2v (a^2 sin^2 + b^2 cos^2)-like forms vanish for negative e^2v only), so
   the rule's error is exp(-pi^2/h) times a small power of 1/h. All terms are positive, nothing
   depends on how near the axes are to each other: sphere, disc and needle are alike. */
#include "geometry.h"

/* Means over a quarter turn, times its length: of cos^2/D and sin^2/D, D = sqrt(cos^2 + k^2 sin^2),
   0 < k <= 1 (Bulirsch, Numer. Math. 7, 1965, the function cel with p = 1). */
static void landen(ph_wide k, ph_wide *cosine, ph_wide *sine) {
  const ph_wide close = sqrtl(LDBL_EPSILON);
  ph_wide m = 1, a[2] = {1, 1}, b[2] = {0, 1}, c[2] = {1, 0};
  for (;;) {
    const ph_wide before = m;
    m += k;
    for (int i = 0; i < 2; i++) {
      b[i] = 2 * (c[i] * k + b[i]);
      c[i] = a[i];
      a[i] += b[i] / m;
    }
    if (fabsl(before - k) <= close * before)
      break;
    k = 2 * sqrtl(k * before);
  }
  *cosine = PI / 4 * a[0] / m;
  *sine = PI / 4 * a[1] / m;
}

int geometry_shell_ellipsoid(const ph_wide p[], geometry *g) {
  int order[3] = {0, 1, 2}; /* axes, the longest first */
  for (int i = 1; i < 3; i++)
    for (int j = i; j > 0 && p[order[j]] > p[order[j - 1]]; j--) {
      const int k = order[j];
      order[j] = order[j - 1], order[j - 1] = k;
    }
  const ph_wide a = p[order[0]], b = p[order[1]], c = p[order[2]];
  /* exp(-pi^2 6) = 2e-26. The ends: the integrand falls as e^v below and as e^-2v above. */
  enum { PER_UNIT = 6, FROM = -48 * PER_UNIT, TO = 24 * PER_UNIT };
  ph_wide area = 0, x = 0, y = 0, z = 0;
  for (int n = FROM; n <= TO; n++) {
    const ph_wide t = expl((ph_wide)n / PER_UNIT), near = 1 / (1 + t * t), far = t * t * near;
    /* dS = near sqrt(A cos^2 + B sin^2) dn3 dphi, dn3 = t near^3/2 dv */
    const ph_wide A = b * hypotl(c, t * a), B = a * hypotl(c, t * b), k = A / B;
    ph_wide sine, cosine; /* B >= A: cosine belongs to sin phi here */
    landen(k, &cosine, &sine);
    /* integrals of D sin^2 and D cos^2 with D = sqrt(k^2 cos^2 + sin^2) */
    const ph_wide on_y = (2 * cosine + k * k * sine) / 3, on_x = (cosine + 2 * k * k * sine) / 3;
    const ph_wide weight = 8 * t * near * near * B / PER_UNIT;
    area += weight * (on_x + on_y);
    x += weight * near * on_x;
    y += weight * near * on_y;
    z += weight * far * (on_x + on_y);
  }
  g->measure = area;
  g->second[order[0]] = a * a * x / area;
  g->second[order[1]] = b * b * y / area;
  g->second[order[2]] = c * c * z / area;
  return PH_OK;
}
