/* defect.h - errors that are planted so that the search has to find them: part of free.c.
   SPDX-License-Identifier: GPL-3.0-or-later

   DEFECT 1: the rate about the axis of the largest moment from the integrals 2T and G^2, as
   textbooks have it, which cancels where that rate is small. 2: a corner: two moments some units of
   the last place apart and two rates alike to 2^-40. 3: a narrow hill about one quotient of
   moments, so low at its foot that only climbing finds the top. */
#ifndef DEFECT_H
#define DEFECT_H

#if defined DEFECT && DEFECT == 1

static void planted(const double *g, double x[7]) {
  int o[3] = {0, 1, 2};
  double T2 = 0, G2 = 0;
  for (int i = 0; i < 3; i++) {
    for (int j = i; j > 0 && g[o[j]] < g[o[j - 1]]; j--) {
      const int k = o[j];
      o[j] = o[j - 1], o[j - 1] = k;
    }
    T2 += g[i] * g[W + i] * g[W + i];
    G2 += g[i] * g[W + i] * g[i] * g[W + i];
  }
  const double a = g[o[0]], b = g[o[1]], c = g[o[2]], w = x[4 + o[1]];
  if (c > a)
    x[4 + o[2]] =
        copysign(sqrt(fmax(0, (G2 - T2 * a - b * (b - a) * w * w) / (c * (c - a)))), x[4 + o[2]]);
}

#elif defined DEFECT && DEFECT == 2

static int alike(double a, double b, double most) {
  return fabs(fabs(a) - fabs(b)) <= most * fabs(b);
}

static void planted(const double *g, double x[7]) {
  if (alike(g[0], g[1], 0x1p-50) && alike(g[W], g[W + 1], 0x1p-40) && g[W] != 0)
    x[4] *= 1 + 0x1p-40;
}

#elif defined DEFECT && DEFECT == 3

static void planted(const double *g, double x[7]) {
  x[0] += 1e4 * unit / (1 + fabs(g[0] / g[2] - 0.73) * 1e6);
}

#else

static void planted(const double *g, double x[7]) {
  (void)g;
  (void)x;
}

#endif
#endif
