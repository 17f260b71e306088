/* corners.c - runs whose equations have corners or jumps, against closed forms.
   SPDX-License-Identifier: GPL-3.0-or-later

   A ball of moment 1 under a torque f(t) about z: wz is the integral of f, in closed form. f is a
   function of the caller's, which the library cannot see into: the error control alone finds its
   corners. Straight throws with quadratic drag: tan up, tanh down. Each motion is asked for in one
   piece and with a row on the way. Tolerances: near rounding a run of some hundred steps leaves
   1e-15 of the size of the numbers; at a tolerance t each step may leave t. */
#include <float.h>
#include <math.h>

#include "polhode.h"
#include "tap.h"

#define COUNT(table) (sizeof(table) / sizeof(table)[0])

static const long double PI = 3.14159265358979323846264338327950288L;

/* ---- torques over time ---- */

/* |t - c|, its sign, (t - c)|t - c|, and the sign and the modulus of sin 3t */
enum torque { KINK, JUMP, BEND, SQUARE, ARCHES, TORQUES };
static const char *const names[TORQUES] = {"a corner", "a jump", "a jump of the second derivative",
                                           "a square wave", "|sin 3t|"};
typedef struct law {
  enum torque kind;
  long double c;
} law;

static long double torque(void *context, long double t, const long double x[]) {
  const law *l = context;
  const long double d = t - l->c;
  (void)x;
  switch (l->kind) {
  case KINK:
    return fabsl(d);
  case JUMP:
    return d < 0 ? -1 : 1;
  case BEND:
    return d * fabsl(d);
  case SQUARE:
    return sinl(3 * t) < 0 ? -1 : 1;
  default:
    return fabsl(sinl(3 * t));
  }
}

/* Its integral from 0, c >= 0. */
static long double integral(const law *l, long double t) {
  const long double c = l->c, d = t - c, half = PI / 3;
  const long double n = floorl(t / half), rest = t - n * half;
  switch (l->kind) {
  case KINK:
    return (c * c + d * fabsl(d)) / 2;
  case JUMP:
    return fabsl(d) - c;
  case BEND:
    return (powl(fabsl(d), 3) - c * c * c) / 3;
  case SQUARE:
    return fmodl(n, 2) == 0 ? rest : half - rest;
  default:
    return 2 * n / 3 + (1 - cosl(3 * rest)) / 3;
  }
}

static int run(const ph_top *top, ph_options options, double row, double end, double x[]) {
  ph_run *r = NULL;
  int status = ph_run_new(&r, top, &options, 0, x);
  if (!status && row > 0)
    status = ph_run_to(r, row, NULL, x);
  if (!status)
    status = ph_run_to(r, end, NULL, x);
  ph_run_free(r);
  return status;
}

/* The worst error of wz over places c of the corner, a third of them where rows are. */
static double worst(enum torque kind, double tolerance) {
  static const double tensor[6] = {1, 1, 1, 0, 0, 0};
  enum { PLACES = 30 };
  double most = 0;
  for (int i = 0; i < PLACES; i++) {
    const double place = i % 3 == 0 ? (i % 7) * 0.5 : fmod(i * 0.6180339887498949, 1) * 3;
    law l = {kind, (long double)place};
    ph_varying about_z[3] = {{0}};
    ph_top top;
    ph_options options = ph_options_default();
    double x[7] = {1, 0, 0, 0, 0, 0, 4};
    about_z[2].f = torque;
    about_z[2].context = &l;
    options.tolerance = tolerance;
    const double end = i % 2 == 0 ? 3 : 7.25;
    const int status = ph_top_init_tensor(&top, 1, NULL, tensor) ||
                       ph_top_custom(&top, about_z, NULL, NULL, 0, NULL) ||
                       run(&top, options, i % 5 == 0 ? 1.5 : 0, end, x);
    const long double error = status ? HUGE_VALL : (long double)x[6] - 4 - integral(&l, end);
    most = fmax(most, fabs((double)error));
  }
  return most;
}

static void unseen(void) {
  for (int kind = 0; kind < TORQUES; kind++) {
    const double near = worst(kind, 1e-18), loose = worst(kind, 1e-9);
    ok(near <= 64 * DBL_EPSILON, "%s that nobody tells of: near rounding (%.2g)", names[kind],
       near);
    ok(loose <= 1e-6, "%s that nobody tells of: at 1e-9 (%.2g)", names[kind], loose);
  }
}

/* ---- thrown up with quadratic drag ---- */

static int throw(double g, double c, double v0, double row, double t, double aside, double x[]) {
  static const double tensor[6] = {1, 1.2, 1.5, 0, 0, 0};
  const double down[3] = {0, 0, -g};
  ph_top top;
  for (int i = 0; i < 13; i++)
    x[i] = i == 0;
  x[10] = aside;
  x[12] = v0;
  return ph_top_init_tensor(&top, 1, NULL, tensor) || ph_top_translation(&top, down) ||
         ph_top_drag(&top, 0, c) || run(&top, ph_options_default(), row, t, x);
}

/* v = vt tan(b - s t) until the top, then -vt tanh(s t - b). A row may be anywhere, at the top too.
 */
static void apex(void) {
  enum { THROWS = 80 };
  long double most = 0, beside = 0;
  for (int i = 0; i < THROWS; i++) {
    const double a = fmod(i * 0.6180339887498949, 1), b = fmod(i * 0.7548776662466927, 1);
    const double g = 1 + 19 * a, c = 0.01 + 2 * b, v0 = 0.01 + 30 * fmod(a + b, 1),
                 t = 0.1 + 6 * a * b;
    const long double vt = sqrtl((long double)g / (long double)c), s = (long double)g / vt;
    const long double high = atanl((long double)v0 / vt), d = s * (long double)t - high;
    const long double v = d < 0 ? -vt * tanl(d) : -vt * tanhl(d);
    const long double z =
        vt * vt / (long double)g * ((d < 0 ? logl(cosl(d)) : -logl(coshl(d))) - logl(cosl(high)));
    const double row = i % 3 == 0 ? 0 : i % 3 == 1 ? t * b : (double)(high / s);
    double x[13], y[13];
    const int status =
        throw(g, c, v0, row < t ? row : 0, t, 0, x) || throw(g, c, v0, 0, t, 1e-13, y);
    const long double size = fmaxl(1, fmaxl(fabsl(z), (long double)v0));
    most = fmaxl(most, status ? HUGE_VALL
                              : fmaxl(fabsl((long double)x[9] - z), fabsl((long double)x[12] - v)) /
                                    size);
    for (int k = 7; k < 13 && !status; k++)
      beside = fmaxl(beside, fabsl((long double)x[k] - (long double)y[k]) / size);
  }
  ok(most <= 16 * (long double)DBL_EPSILON, "%d straight throws with drag (%.2Lg)", THROWS, most);
  /* sideways 1e-13 m/s, the way moves by that times some seconds, and no more */
  ok(beside <= 1e-12L, "thrown sideways by 1e-13 m/s they are the same (%.2Lg)", beside);
}

int main(void) {
  unseen();
  apex();
  return tap_done();
}
