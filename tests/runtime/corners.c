/* corners.c - runs whose equations have corners or jumps, against closed forms.
   SPDX-License-Identifier: GPL-3.0-or-later

   A ball of moment 1 under a torque f(t) about z: wz is the integral of f, in closed form. f is a
   function of the caller's that says where its corners are, or one that does not: then the error
   control alone finds them. A torque against w is dry friction. Straight throws with quadratic
   drag: tan up, tanh down. Each motion is asked for in one piece and with a row on the way.
   Tolerances: near rounding a run of some hundred steps leaves 1e-15 of the size of the numbers; at
   a tolerance t each step may leave t. */
#include <float.h>
#include <math.h>

#include "polhode.h"
#include "tap.h"

#define COUNT(table) (sizeof(table) / sizeof(table)[0])

static const long double PI = 3.14159265358979323846264338327950288L;

/* ---- torques over time ---- */

/* Of g = t - c: |g|, its sign, g |g|; of sin 3t: its sign, its modulus; |(t - c)^2 - d^2|, whose
   two zeros are 2 d apart; |(t - c)^2| */
enum torque { KINK, JUMP, BEND, SQUARE, ARCHES, PAIR, TOUCH, TORQUES };
static const char *const names[TORQUES] = {
    "a corner", "a jump",    "a jump of the second derivative", "a square wave",
    "|sin 3t|", "two zeros", "a zero that is touched"};
static const long double APART = 1e-3L;

typedef struct law {
  enum torque kind;
  long double c;
} law;

static long double piece(void *context, long double t, const long double x[],
                         const signed char branch[], long double side[]) {
  const law *l = context;
  const long double d = t - l->c;
  const long double g = l->kind < SQUARE ? d
                        : l->kind < PAIR ? sinl(3 * t)
                                         : d * d - (l->kind == PAIR ? APART * APART : 0);
  const int s = branch && branch[0] ? branch[0] : (g > 0) - (g < 0);
  (void)x;
  if (side)
    side[0] = fabsl(g) > 1e-18L ? g : 0;
  return l->kind == JUMP || l->kind == SQUARE ? s : l->kind == BEND ? s * g * g : s * g;
}

static long double torque(void *context, long double t, const long double x[]) {
  return piece(context, t, x, NULL, NULL);
}

/* Its integral from 0, c >= 0. */
static long double integral(const law *l, long double t) {
  const long double c = l->c, d = t - c, half = PI / 3, a = APART;
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
  case ARCHES:
    return 2 * n / 3 + (1 - cosl(3 * rest)) / 3;
  case PAIR: /* between the zeros the integral of a^2 - d^2 is 4/3 a^3, counted with both signs */
    return (d * d * d + c * c * c) / 3 - a * a * t + (d > a && c > a ? 8 * a * a * a / 3 : 0);
  default:
    return (d * d * d + c * c * c) / 3;
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
static double worst(enum torque kind, int seen, ph_method method, double tolerance) {
  static const double tensor[6] = {1, 1, 1, 0, 0, 0};
  enum { PLACES = 15 };
  double most = 0;
  for (int i = 0; i < PLACES; i++) {
    const double place = i % 3 == 0 ? (i % 7) * 0.5 : fmod(i * 0.6180339887498949, 1) * 3;
    law l = {kind, (long double)place + (kind >= PAIR ? 0.01L : 0)};
    ph_varying about_z[3] = {{0}};
    double x[7] = {1, 0, 0, 0, 0, 0, 4};
    about_z[2].f = torque;
    about_z[2].context = &l;
    if (seen) {
      about_z[2].piece = piece;
      about_z[2].sides = 1;
    }
    ph_top top;
    ph_options options = ph_options_default();
    options.method = method;
    options.tolerance = tolerance;
    const double end = i % 2 == 0 ? 3.5 : 7.25;
    const int status = ph_top_init_tensor(&top, 1, NULL, tensor) ||
                       ph_top_custom(&top, about_z, NULL, NULL, 0, NULL) ||
                       run(&top, options, i % 5 == 0 ? 1.5 : 0, end, x);
    const long double error = status ? HUGE_VALL : (long double)x[6] - 4 - integral(&l, end);
    most = fmax(most, fabs((double)error));
  }
  return most;
}

static void over_time(void) {
  for (int kind = 0; kind < TORQUES; kind++) {
    for (int seen = kind < PAIR ? 0 : 1; seen < 2; seen++) {
      const char *how = seen ? "that is told of" : "that nobody tells of";
      const double near = worst(kind, seen, PH_TAYLOR, 1e-18);
      const double loose = worst(kind, seen, PH_TAYLOR, 1e-9);
      /* some 30 steps, each wrong by 1e-9 of up to 25 rad/s; what is told of is hit */
      ok(near <= 64 * DBL_EPSILON, "%s %s: near rounding (%.2g)", names[kind], how, near);
      ok(loose <= (seen ? 1e-8 : 1e-6), "%s %s: at 1e-9 (%.2g)", names[kind], how, loose);
    }
    const double prince = worst(kind, 1, PH_RK8PD, 1e-13);
    const double fehlberg = worst(kind, 1, PH_RKF45, 1e-10);
    ok(prince <= 1e-11, "%s that is told of: rk8pd at 1e-13 (%.2g)", names[kind], prince);
    ok(fehlberg <= 1e-8, "%s that is told of: rkf45 at 1e-10 (%.2g)", names[kind], fehlberg);
  }
}

/* ---- dry friction ---- */

/* The torque a - b sign(wz); sides of the two: wz, and wz again. */
typedef struct dry {
  long double a, b;
} dry;

static long double dry_piece(void *context, long double t, const long double x[],
                             const signed char branch[], long double side[]) {
  const dry *d = context;
  (void)t;
  for (int i = 0; side && i < 2; i++)
    side[i] = x[6] * (i + 1);
  const int s = branch && branch[0] ? branch[0] : (x[6] > 0) - (x[6] < 0);
  return d->a - d->b * s;
}

static long double dry_torque(void *context, long double t, const long double x[]) {
  return dry_piece(context, t, x, NULL, NULL);
}

static void reversed(void) {
  static const double tensor[6] = {1, 1, 1, 0, 0, 0};
  static const struct {
    double a, b, w0;
    int status;
  } cases[] = {{-1, 0.5, 1.3, PH_OK},    {-1, 0.5, 0, PH_OK},        {2, 1.5, -0.7, PH_OK},
               {0, 1, 1.3, PH_ECHATTER}, {0.5, 1, 1.3, PH_ECHATTER}, {0.5, 1, 0, PH_ECHATTER}};
  static const ph_method methods[] = {PH_TAYLOR, PH_RKF45, PH_RK8PD};
  for (size_t i = 0; i < COUNT(cases); i++)
    for (size_t m = 0; m < COUNT(methods); m++) {
      const double a = cases[i].a, b = cases[i].b, w0 = cases[i].w0, t = 3;
      dry d = {(long double)a, (long double)b};
      ph_varying about_z[3] = {{0}};
      about_z[2] = (ph_varying){.f = dry_torque, .context = &d, .sides = 2, .piece = dry_piece};
      ph_top top;
      ph_options options = ph_options_default();
      options.method = methods[m];
      options.tolerance = m == 0 ? 1e-18 : 1e-12;
      double x[7] = {1, 0, 0, 0, 0, 0, w0};
      const int status = ph_top_init_tensor(&top, 1, NULL, tensor) ||
                                 ph_top_custom(&top, about_z, NULL, NULL, 0, NULL)
                             ? -1
                             : run(&top, options, 0, t, x);
      /* it slows by a - b sign(w0) until it rests, then the torque wins */
      const double first = w0 > 0 ? a - b : a + b, rest = w0 == 0 ? 0 : -w0 / first;
      const double want = (a > 0 ? a - b : a + b) * (t - rest);
      ok(status == cases[i].status && (status || fabs(x[6] - want) <= (m == 0 ? 1e-15 : 1e-11)),
         "a torque %g with dry friction %g at %g rad/s by method %d: %s", a, b, w0, (int)methods[m],
         status < 0 ? "not made" : ph_status_phrase(status));
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
  enum { THROWS = 60 };
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
  over_time();
  reversed();
  apex();
  return tap_done();
}
