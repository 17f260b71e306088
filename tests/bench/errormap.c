/* errormap.c - states of an emitted free top over all bodies and motions, for the oracle to judge.
   SPDX-License-Identifier: GPL-3.0-or-later

   Prints, for each point of a sweep, tensor, w0, q0, t and the emitted code's rates and attitude,
   all in hexadecimal, as tests/oracle/free_top -e reads them. The file named first gets the point's
   place in the sweep: body (column, row), motion (side, depth), time, and 0 for a state by
   errormap_at, 1 for one by errormap_at_tick. Inputs are numbers of the emitted type.
   Moments: C = 1, B in (1/2, 1), A in (1 - B, B), on a grid; the ends are a lamina's edge and a
   symmetric top, approached to 1e-6. Motion: G^2/2T between A and C, at distances from B of 10^0 to
   10^-14 of what is possible, either side. Phase: the golden angle's multiples. Time: 1, 10^2,
   10^4, 10^6 periods of the rates, 16.18 ticks each: the tick has 24 bits, so that n h is a double;
   errormap_at gets that rounded to its type. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "errormap.h"

enum { GRID = 9, SIDES = 2, DEPTHS = 8, TIMES = 4 };

static const double depth[DEPTHS] = {0.999999, 0.9, 0.5, 0.1, 1e-3, 1e-6, 1e-10, 1e-14};
static const double revolutions[TIMES] = {1, 1e2, 1e4, 1e6};

static double quarter(double kc) { /* K = pi / (2 M(1, k')) */
  double a = 1, b = kc;
  for (int n = 0; n < 40 && fabs(a - b) > 1e-15 * a; n++) {
    const double g = sqrt(a * b);
    a = (a + b) / 2;
    b = g;
  }
  return 1.5707963267948966 / a;
}

/* Rates of a motion with 2T = 1, G^2 = h, at amplitude psi, and its period. */
static double motion(const double I[3], int side, double part, double psi, double w[3]) {
  const int c = side ? 2 : 0, a = 2 - c;
  const double h = I[1] + (I[c] - I[1]) * part, gap = I[c] - I[1], wide = I[c] - I[a];
  const double B1 = sqrt(I[a] * (I[c] - h) / wide), B2 = sqrt(I[1] * (I[c] - h) / gap);
  const double lambda = sqrt(gap * (h - I[a]) / (I[0] * I[1] * I[2]));
  const double kc = sqrt(wide * gap * part / (gap * (h - I[a])));
  const double L1 = B1 * cos(psi), L2 = B2 * sin(psi);
  w[a] = L1 / I[a];
  w[1] = L2 / I[1];
  w[c] = sqrt(fmax(0, h - L1 * L1 - L2 * L2)) / I[c];
  return 4 * quarter(kc) / lambda;
}

/* One state as the oracle reads it. */
static void print_state(const double I[3], const errormap_real x0[7], double t,
                        const errormap_real x[7]) {
  printf("%a %a %a 0 0 0", I[0], I[1], I[2]);
  for (int i = 0; i < 7; i++)
    printf(" %a", (double)x0[i < 3 ? 4 + i : i - 3]);
  printf(" %a", t);
  for (int i = 0; i < 7; i++)
    printf(" %a", (double)x[i < 3 ? 4 + i : i - 3]);
  printf("\n");
}

int main(int argc, char **argv) {
  FILE *places = argc == 2 ? fopen(argv[1], "w") : NULL;
  if (!places) {
    fprintf(stderr, "usage: errormap PLACES > LINES\n");
    return 2;
  }
  int point = 0;
  for (int row = 0; row < GRID; row++)
    for (int column = 0; column < GRID; column++) {
      const double u = fmin(1 - 1e-6, fmax(1e-6, (double)row / (GRID - 1)));
      const double v = fmin(1 - 1e-6, fmax(1e-6, (double)column / (GRID - 1)));
      const double b = 0.5 + u / 2, a = (1 - b) + (2 * b - 1) * v;
      errormap_real p[ERRORMAP_NP] = {0},
                    x0[7] = {(errormap_real)0.5, (errormap_real)-0.25, (errormap_real)0.75,
                             (errormap_real)0.125},
                    x[7];
      p[ERRORMAP_A] = (errormap_real)a;
      p[ERRORMAP_B] = (errormap_real)b;
      p[ERRORMAP_C] = 1;
      const double I[3] = {(double)p[ERRORMAP_A], (double)p[ERRORMAP_B], 1};
      if (I[0] == I[1]) /* in float the corner of the grid is a symmetric top */
        continue;
      errormap_model m;
      if (errormap_init(&m, p)) {
        fprintf(stderr, "errormap: refused: %a %a 1\n", I[0], I[1]);
        continue;
      }
      for (int side = 0; side < SIDES; side++)
        for (int d = 0; d < DEPTHS; d++) {
          double w[3];
          const double period = motion(I, side, depth[d], 2.399963 * ++point, w);
          for (int i = 0; i < 3; i++)
            x0[4 + i] = (errormap_real)w[i];
          errormap_orbit o;
          if (errormap_solve(&o, &m, x0)) {
            fprintf(stderr, "errormap: no solution: %a %a 1, %a %a %a\n", I[0], I[1], w[0], w[1],
                    w[2]);
            continue;
          }
          const float h = (float)(period / 16.18);
          if (errormap_set_tick(&o, (errormap_real)h))
            fprintf(stderr, "errormap: no tick: %a\n", (double)h);
          for (int k = 0; k < TIMES; k++) {
            const int64_t n = (int64_t)floor(16.18 * revolutions[k]);
            const double t = (double)h * (double)n;
            fprintf(places, "%d %d %d %d %d 0\n%d %d %d %d %d 1\n", column, row, side, d, k, column,
                    row, side, d, k);
            errormap_at(&o, (errormap_real)t, x);
            print_state(I, x0, (double)(errormap_real)t, x);
            errormap_at_tick(&o, n, x);
            print_state(I, x0, t, x);
          }
        }
    }
  return fclose(places) != 0;
}
