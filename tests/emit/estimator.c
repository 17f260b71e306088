/* estimator.c - the emitted estimator of the tensor of inertia (gen --with estimator): part of
   estimator.t, which judges. SPDX-License-Identifier: GPL-3.0-or-later

   Compiled for double and float: -DNAME=the scene's name, -include of its header.
     log WINDOW DT SIGMA3 ERROR6 < rows of w1 w2 w3 N1 N2 N3 h1 h2 h3
                 prints the tensor, its standard errors, the covariance in (kg m^2)^2, chi2, rows
     cover LOGS WINDOW SIGMA      prints the mean of d'C^-1 d over synthetic logs of a free body, d
                 the five errors with xx held, and the share of logs where it is below 11.0705 (the
                 95 % point of chi-square with 5 degrees)
     order       prints the largest error for windows of 32, 64 and 128 samples of the same length,
                 rates of a known torque without noise
     bad         prints how many wrong arguments and samples are answered rightly, and how many
                 there are */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define JOIN_NAMES(a, b) a##b
#define JOIN(a, b)       JOIN_NAMES(a, b)
#define OF(function)     JOIN(NAME, function)

typedef OF(_real) real;
static OF(_model) model;

/* ---- noise and motion, in double ---- */

static uint64_t seed = 88172645463325252u;
static double uniform(void) { /* in (0, 1): xorshift64, Marsaglia 2003 */
  seed ^= seed << 13;
  seed ^= seed >> 7;
  seed ^= seed << 17;
  return ((double)(seed >> 11) + 0.5) * 0x1p-53;
}

static double normal(void) {
  return sqrt(-2 * log(uniform())) * cos(6.283185307179586 * uniform());
}

static void times(const double I[6], const double w[3], double out[3]) {
  out[0] = I[0] * w[0] + I[3] * w[1] + I[4] * w[2];
  out[1] = I[3] * w[0] + I[1] * w[1] + I[5] * w[2];
  out[2] = I[4] * w[0] + I[5] * w[1] + I[2] * w[2];
}

static void cross(const double a[3], const double b[3], double out[3]) {
  out[0] = a[1] * b[2] - a[2] * b[1];
  out[1] = a[2] * b[0] - a[0] * b[2];
  out[2] = a[0] * b[1] - a[1] * b[0];
}

/* w' = I^-1 (I w x w), by Cramer's rule */
static void rates(const double I[6], const double w[3], double out[3]) {
  const double c[3][3] = {{I[0], I[3], I[4]}, {I[3], I[1], I[5]}, {I[4], I[5], I[2]}};
  double L[3], n[3], x[3][3], det;
  times(I, w, L);
  cross(L, w, n);
  cross(c[1], c[2], x[0]);
  cross(c[2], c[0], x[1]);
  cross(c[0], c[1], x[2]);
  det = c[0][0] * x[0][0] + c[0][1] * x[0][1] + c[0][2] * x[0][2];
  for (int i = 0; i < 3; i++)
    out[i] = (x[0][i] * n[0] + x[1][i] * n[1] + x[2][i] * n[2]) / det;
}

static void step(const double I[6], double w[3], double h) {
  double k[4][3], y[3];
  rates(I, w, k[0]);
  for (int s = 1; s < 4; s++) {
    for (int i = 0; i < 3; i++)
      y[i] = w[i] + h * (s < 3 ? 0.5 : 1) * k[s - 1][i];
    rates(I, y, k[s]);
  }
  for (int i = 0; i < 3; i++)
    w[i] += h / 6 * (k[0][i] + 2 * k[1][i] + 2 * k[2][i] + k[3][i]);
}

/* d' C^-1 d of n numbers, by Gauss */
static double distance(int n, double C[][6], double d[]) {
  double sum = 0, y[6];
  memcpy(y, d, sizeof y);
  for (int i = 0; i < n; i++)
    for (int k = i + 1; k < n; k++) {
      const double f = C[k][i] / C[i][i];
      for (int j = i; j < n; j++)
        C[k][j] -= f * C[i][j];
      y[k] -= f * y[i];
    }
  for (int i = n - 1; i >= 0; i--) {
    for (int k = i + 1; k < n; k++)
      y[i] -= C[i][k] * y[k];
    y[i] /= C[i][i];
    sum += y[i] * d[i];
  }
  return sum;
}

/* ---- the tests ---- */

static int cover(int logs, int window, double sigma) {
  const double I[6] = {1, 1.35, 0.82, 0.11, -0.07, 0.16}, dt = 0.02;
  const real s = (real)sigma, sigmas[3] = {s, s, s},
             error[6] = {0, (real)0.2, (real)0.2, (real)0.2, (real)0.2, (real)0.2};
  double mean = 0;
  int inside = 0, bad = 0;
  for (int n = 0; n < logs; n++) {
    OF(_estimator) e;
    double w[3] = {0.8, -0.6, 1.1}, d[6], C[6][6];
    real c[36];
    bad += OF(_estimator_open)(&e, &model, (real)dt, window, sigmas, error);
    for (int i = 0; i < 3000; i++) {
      real y[3];
      for (int k = 0; k < 3; k++)
        y[k] = (real)(w[k] + sigma * normal());
      if (OF(_estimator_add)(&e, y, NULL, NULL) == 1)
        bad += OF(_estimator_solve)(&e);
      step(I, w, dt / 2);
      step(I, w, dt / 2);
    }
    OF(_estimator_covariance)(&e, c);
    for (int i = 0; i < 5; i++) {
      d[i] = (double)e.theta[i + 1] - I[i + 1] / (double)e.moment;
      for (int k = 0; k < 5; k++)
        C[i][k] = (double)c[6 * (i + 1) + k + 1];
    }
    const double m = distance(5, C, d);
    mean += m / logs;
    inside += m < 11.0705;
  }
  printf("%.17g %.17g %d\n", mean, (double)inside / logs, bad);
  return 0;
}

/* Rates and the wheels' momentum are polynomials of the time in each window, with the torque that
   they need. */
static double known_torque(int window) {
  const double I[6] = {1, 1.35, 0.82, 0.11, -0.07, 0.16}, T = 1;
  const real sigmas[3] = {(real)1e-3, (real)1e-3, (real)1e-3}, error[6] = {1, 1, 1, 1, 1, 1};
  OF(_estimator) e;
  real out[6], errors[6];
  double worst = 0;
  seed = 88172645463325252u;
  OF(_estimator_open)(&e, &model, (real)(T / window), window, sigmas, error);
  for (int n = 0; n < 40; n++) {
    double a[3], b[3], c[3], p[3], q[3];
    for (int k = 0; k < 3; k++) {
      a[k] = 2 * uniform() - 1;
      b[k] = 2 * uniform() - 1;
      c[k] = 2 * uniform() - 1;
      p[k] = 2 * uniform() - 1;
      q[k] = 2 * uniform() - 1;
    }
    for (int i = 0; i < window; i++) {
      const double t = T * (i + 0.5) / window;
      double w[3], rise[3], L[3], turned[3], push[3];
      real y[3], N[3], h[3];
      for (int k = 0; k < 3; k++) {
        w[k] = a[k] + b[k] * t + c[k] * t * t;
        rise[k] = b[k] + 2 * c[k] * t;
      }
      times(I, w, L);
      for (int k = 0; k < 3; k++)
        L[k] += p[k] + q[k] * t;
      cross(w, L, turned);
      times(I, rise, push);
      for (int k = 0; k < 3; k++) {
        y[k] = (real)w[k];
        h[k] = (real)(p[k] + q[k] * t);
        N[k] = (real)(push[k] + q[k] + turned[k]);
      }
      OF(_estimator_add)(&e, y, N, h);
    }
    OF(_estimator_solve)(&e);
  }
  OF(_estimator_inertia)(&e, out, errors);
  for (int i = 0; i < 6; i++)
    worst = fmax(worst, fabs((double)out[i] - I[i]));
  return worst;
}

static int read_log(char **argv) {
  real sigma[3], error[6], w[9], I[6], errors[6], c[36], ratio[2], ratio_error[2];
  double row[9];
  OF(_estimator) e;
  for (int i = 0; i < 3; i++)
    sigma[i] = (real)atof(argv[4 + i]);
  for (int i = 0; i < 6; i++)
    error[i] = (real)atof(argv[7 + i]);
  int bad = OF(_estimator_open)(&e, &model, (real)atof(argv[3]), atoi(argv[2]), sigma, error);
  while (scanf("%lf%lf%lf%lf%lf%lf%lf%lf%lf", row, row + 1, row + 2, row + 3, row + 4, row + 5,
               row + 6, row + 7, row + 8) == 9) {
    for (int i = 0; i < 9; i++)
      w[i] = (real)row[i];
    if (OF(_estimator_add)(&e, w, w + 3, w + 6) == 1)
      bad += OF(_estimator_solve)(&e);
  }
  OF(_estimator_inertia)(&e, I, errors);
  OF(_estimator_covariance)(&e, c);
  bad += OF(_estimator_ratios)(&e, ratio, ratio_error);
  for (int i = 0; i < 6; i++)
    printf("%.17g %.17g\n", (double)I[i], (double)errors[i]);
  printf("%.17g %.17g\n%.17g %.17g\n", (double)ratio[0], (double)ratio_error[0], (double)ratio[1],
         (double)ratio_error[1]);
  printf("%.17g %ld\n%d\n", (double)e.chi2, (long)e.rows, bad);
  return 0;
}

static int refusals(void) {
  const real fine[3] = {1, 1, 1}, zero[3] = {1, 0, 1}, none[6] = {0}, minus[6] = {0, 0, -1};
  const real nan[3] = {1, (real)NAN, 1}, huge[3] = {(real)1e30, (real)2e30, (real)-3e30};
  OF(_estimator) e, before;
  int right = 0, n = 0;
#define HERE(condition) (right += (condition) ? 1 : 0, n++)
  HERE(OF(_estimator_open)(&e, &model, 0, 8, fine, none) == 1);
  HERE(OF(_estimator_open)(&e, &model, (real)NAN, 8, fine, none) == 1);
  HERE(OF(_estimator_open)(&e, &model, 1, 3, fine, none) == 1);
  HERE(OF(_estimator_open)(&e, &model, 1, 8, zero, none) == 1);
  HERE(OF(_estimator_open)(&e, &model, 1, 8, nan, none) == 1);
  HERE(OF(_estimator_open)(&e, &model, 1, 8, fine, minus) == 1);
  HERE(OF(_estimator_open)(&e, &model, 1, 4, fine, none) == 0);
  HERE(OF(_estimator_add)(&e, fine, NULL, NULL) == 0);
  HERE(OF(_estimator_add)(&e, nan, NULL, NULL) == 2);
  HERE(OF(_estimator_add)(&e, fine, nan, NULL) == 2);
  HERE(OF(_estimator_solve)(&e) == 1);
  for (int i = 0; i < 3; i++)
    HERE(OF(_estimator_add)(&e, fine, NULL, NULL) == 0);
  HERE(OF(_estimator_add)(&e, fine, NULL, NULL) == 1);
  before = e;
  HERE(OF(_estimator_add)(&e, huge, NULL, NULL) == 1);
  HERE(memcmp(&before, &e, sizeof e) == 0);
  HERE(OF(_estimator_solve)(&e) == 0);
  HERE(memcmp(before.theta, e.theta, sizeof e.theta) == 0); /* all is held */
  for (int i = 0; i < 4; i++)
    (void)OF(_estimator_add)(&e, huge, NULL, NULL);
  if (sizeof(real) == 4) { /* its squares are out of range */
    HERE(OF(_estimator_solve)(&e) == 2);
    HERE(memcmp(before.theta, e.theta, sizeof e.theta) == 0);
  }
  printf("%d %d\n", right, n);
  return 0;
}

int main(int argc, char **argv) {
  real p[16];
  OF(_defaults)(p);
  if (OF(_init)(&model, p) != 0 || argc < 2)
    return 2;
  if (strcmp(argv[1], "cover") == 0 && argc == 5)
    return cover(atoi(argv[2]), atoi(argv[3]), atof(argv[4]));
  if (strcmp(argv[1], "log") == 0 && argc == 13)
    return read_log(argv);
  if (strcmp(argv[1], "order") == 0) {
    printf("%.17g %.17g %.17g\n", known_torque(32), known_torque(64), known_torque(128));
    return 0;
  }
  return strcmp(argv[1], "bad") == 0 ? refusals() : 2;
}
