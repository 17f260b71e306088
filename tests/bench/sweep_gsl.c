/* sweep_gsl.c - the peer of `polhode sweep`: the same members, one after the other, with GSL's
 * rk8pd. SPDX-License-Identifier: GPL-3.0-or-later
 *
 *     sweep_gsl FILE.csv COMMAND UNTIL BOUND      (make bench-sweep)
 *
 * COMMAND sweeps bodies/tumbling_box.lua over wx into FILE.csv; the best of three runs counts, with
 * its start and the writing of the file.  GSL's tolerance is the largest of a row of factors
 * 10^(1/4) with which the first members end within BOUND of a run at 1e-14; those of the sweep must
 * be within BOUND of that run, too.  Then GSL computes some of the members, in a loop. */
#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/resource.h>

enum { NX = 7, SOME = 32, TIMED = 1024, ROOM = 1 << 20 };

struct member {
  double wx, final[NX];
};

/* q' = q (0, w)/2 and Euler's equations of the box 0.2 x 0.1 x 0.0333 m; its mass cancels. */
static int rates(double t, const double x[], double f[], void *given) {
  const double *c = given;
  (void)t;
  f[0] = 0.5 * (-x[1] * x[4] - x[2] * x[5] - x[3] * x[6]);
  f[1] = 0.5 * (x[0] * x[4] + x[2] * x[6] - x[3] * x[5]);
  f[2] = 0.5 * (x[0] * x[5] + x[3] * x[4] - x[1] * x[6]);
  f[3] = 0.5 * (x[0] * x[6] + x[1] * x[5] - x[2] * x[4]);
  f[4] = c[0] * x[5] * x[6];
  f[5] = c[1] * x[6] * x[4];
  f[6] = c[2] * x[4] * x[5];
  return GSL_SUCCESS;
}

static void run(double wx, double until, double tolerance, double x[NX]) {
  const double a = 0.2 * 0.2, b = 0.1 * 0.1, c = 0.0333 * 0.0333;
  double k[3] = {(c - b) / (b + c), (a - c) / (a + c), (b - a) / (a + b)}, t = 0;
  gsl_odeiv2_system system = {rates, NULL, NX, k};
  gsl_odeiv2_driver *d =
      gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, 1e-2, tolerance, tolerance);
  const double begin[NX] = {1, 0, 0, 0, wx, 6.5, 1};
  for (int i = 0; i < NX; i++)
    x[i] = begin[i];
  if (gsl_odeiv2_driver_apply(d, &t, until, x) != GSL_SUCCESS)
    x[0] = NAN;
  gsl_odeiv2_driver_free(d);
}

/* The largest difference: of the quaternion as it is, of the rates in parts of their size. */
static double apart(const double x[NX], const double y[NX]) {
  const double size = sqrt(y[4] * y[4] + y[5] * y[5] + y[6] * y[6]);
  double most = 0;
  for (int i = 0; i < NX; i++) {
    const double e = fabs(x[i] - y[i]) / (i < 4 ? 1 : size);
    if (!(e <= most))
      most = e;
  }
  return most;
}

/* Processor time, which other users of the machine hardly change: of this process, or of those it
 * has waited for. */
static double spent(int who) {
  struct rusage u;
  getrusage(who, &u);
  return (double)(u.ru_utime.tv_sec + u.ru_stime.tv_sec) +
         1e-6 * (double)(u.ru_utime.tv_usec + u.ru_stime.tv_usec);
}

static int members_of(const char *path, struct member m[ROOM]) {
  FILE *f = fopen(path, "r");
  int n = 0;
  if (f == NULL || fscanf(f, "%*[^\n]") != 0)
    return 0;
  for (; n < ROOM; n++) {
    double *x = m[n].final;
    if (fscanf(f, " %*d,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,ok", &m[n].wx, x, x + 1, x + 2, x + 3,
               x + 4, x + 5, x + 6) != 8)
      break;
  }
  fclose(f);
  return n;
}

int main(int argc, char **argv) {
  static struct member m[ROOM];
  static double truth[SOME][NX];
  if (argc != 5)
    return 2;
  const double until = atof(argv[3]), bound = atof(argv[4]);
  double seconds = INFINITY;
  for (int i = 0; i < 3; i++) {
    const double begin = spent(RUSAGE_CHILDREN);
    if (system(argv[2]) != 0)
      return 2;
    seconds = fmin(seconds, spent(RUSAGE_CHILDREN) - begin);
  }
  const int n = members_of(argv[1], m), some = n < TIMED ? n : TIMED;
  double own = 0, worst = INFINITY, tolerance = 1e-7, x[NX];
  if (n < SOME) {
    fprintf(stderr, "sweep_gsl: %s has %d members, at least %d are needed\n", argv[1], n, SOME);
    return 2;
  }
  for (int i = 0; i < SOME; i++) {
    run(m[i].wx, until, 1e-14, truth[i]);
    own = fmax(own, apart(m[i].final, truth[i]));
  }
  while (worst > bound && tolerance > 1e-14) {
    tolerance /= pow(10, 0.25);
    worst = 0;
    for (int i = 0; i < SOME; i++) {
      run(m[i].wx, until, tolerance, x);
      worst = fmax(worst, apart(x, truth[i]));
    }
  }
  if (!(own <= bound && worst <= bound)) {
    fprintf(stderr, "sweep_gsl: not the same accuracy: %.2g and %.2g, allowed %g\n", own, worst,
            bound);
    return 3;
  }
  double took = INFINITY;
  for (int k = 0; k < 3; k++) {
    const double begin = spent(RUSAGE_SELF);
    for (int i = 0; i < some; i++)
      run(m[i].wx, until, tolerance, x);
    took = fmin(took, spent(RUSAGE_SELF) - begin);
  }
  printf("%d members, %g s of motion, errors within %g\n", n, until, bound);
  printf("polhode sweep   %9.1f us a member   error %.1e\n", seconds / n * 1e6, own);
  printf("GSL rk8pd       %9.1f us a member   error %.1e   tolerance %.1e   %.1f times\n",
         took / some * 1e6, worst, tolerance, took / some / (seconds / n));
  return 0;
}
