/* surface.c - the point of a body's surface that touches a plane.
   SPDX-License-Identifier: GPL-3.0-or-later

   In the axes of the surface, with the plane's normal g and the outward normal n = -g of the point
   x sought, from the surface's centre:
   - ellipsoid: x is the image of the point -z of the unit sphere: x = -C z, z = C g/|C g|, C the
     half axes.
   - paraboloid: z = x^2/(2 a) + y^2/(2 b) has the normal (x/a, y/b, -1), so that x = -a g1/g3 and
     y = -b g2/g3.
   - support h: x = G + (h - n.G) n (Bonnesen and Fenchel, Theory of Convex Bodies, 15), G the
     gradient. Its rate is H n' + (h - n.G) n' - (n.H n') n with the second derivatives H.
   Each with the rate that g' gives. */
#include "acts/acts.h"

static int of_ellipsoid(const ph_plane *p, const ph_wide g[3], const ph_wide g_rate[3],
                        ph_wide x[3], ph_wide rate[3]) {
  ph_wide a[3], b[3], along = 0;
  for (int i = 0; i < 3; i++) {
    a[i] = g[i] * (ph_wide)p->half_axes[i];
    b[i] = g_rate[i] * (ph_wide)p->half_axes[i];
    x[i] = rate[i] = 0;
  }
  if (p->half_axes[0] == 0 && p->half_axes[1] == 0 && p->half_axes[2] == 0)
    return 1;
  const ph_wide length = wide_norm(a);
  if (!(length > 0))
    return 0;
  for (int i = 0; i < 3; i++)
    along += a[i] / length * b[i];
  for (int i = 0; i < 3; i++) {
    const ph_wide z = a[i] / length, half = (ph_wide)p->half_axes[i];
    x[i] = -half * z;
    rate[i] = -half * ((b[i] - z * along) / length);
  }
  return 1;
}

static int of_paraboloid(const ph_plane *p, const ph_wide g[3], const ph_wide g_rate[3],
                         ph_wide x[3], ph_wide rate[3]) {
  if (!(g[2] > 0))
    return 0;
  x[2] = rate[2] = 0;
  for (int i = 0; i < 2; i++) {
    const ph_wide radius = (ph_wide)p->half_axes[i];
    x[i] = -radius * g[i] / g[2];
    rate[i] = -radius * (g_rate[i] * g[2] - g[i] * g_rate[2]) / (g[2] * g[2]);
    x[2] += x[i] * x[i] / (2 * radius);
    rate[2] += x[i] * rate[i] / radius;
  }
  return 1;
}

static int of_support(const ph_plane *p, const ph_wide g[3], const ph_wide g_rate[3], ph_wide x[3],
                      ph_wide rate[3]) {
  static const int at[3][3] = {{4, 7, 8}, {7, 5, 9}, {8, 9, 6}};
  ph_wide jet[10], n[3], d[3], along = 0;
  for (int i = 0; i < 3; i++) {
    n[i] = -g[i];
    d[i] = -g_rate[i];
  }
  p->support.jet(p->support.context, n, jet);
  const ph_wide rest = jet[0] - wide_dot(n, jet + 1);
  for (int i = 0; i < 3; i++) {
    x[i] = jet[1 + i] + rest * n[i];
    rate[i] = 0;
    for (int j = 0; j < 3; j++)
      rate[i] += jet[at[i][j]] * d[j];
    along += n[i] * rate[i];
  }
  for (int i = 0; i < 3; i++)
    rate[i] += rest * d[i] - along * n[i];
  return isfinite(wide_norm(x)) && isfinite(wide_norm(rate));
}

int acts_surface(const ph_plane *p, const ph_wide g[3], const ph_wide g_rate[3], ph_wide r[3],
                 ph_wide rate[3]) {
  ph_wide S[4], a[3], b[3], x[3], x_rate[3];
  wide_load_unit(p->axes, S);
  wide_sandwich(S, g, 0, a);
  wide_sandwich(S, g_rate, 0, b);
  if (!(p->surface == PH_SUPPORT      ? of_support(p, a, b, x, x_rate)
        : p->surface == PH_PARABOLOID ? of_paraboloid(p, a, b, x, x_rate)
                                      : of_ellipsoid(p, a, b, x, x_rate)))
    return 0;
  wide_sandwich(S, x, 1, r);
  wide_sandwich(S, x_rate, 1, rate);
  for (int i = 0; i < 3; i++) {
    r[i] += (ph_wide)p->centre[i] - (ph_wide)p->rim * g[i];
    rate[i] -= (ph_wide)p->rim * g_rate[i];
  }
  return 1;
}
