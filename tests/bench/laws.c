/* laws.c - how the errors of a stepper grow with the number of steps, over an ensemble of states.
   SPDX-License-Identifier: GPL-3.0-or-later

     laws ROW H STEPS MEMBERS

   ROW: the number of a row of rows.h, which tests/bench/laws.lua writes with the scenes top (the
   emitted code under test) and ref (the same body in double, for its closed form). At STEPS, and
   before that at 10^(k/3) from 100 steps on, a line: n, then for each of the quantities
     energy      (E - E0)/T0
     momentum    (|L| - |L0|)/|L0| of a free body; else (Lz - Lz0)/|L0|
     direction   the angle between L and L0 in space, free body
     norm        |q| - 1
     phase       the angle between the attitude and the true one
   nine numbers: the mean over all members, and the mean square of each of GROUPS groups of them.
   Last a line "time", ns a step. What is conserved is formed here, in long double, from the moments
   and the weight HEAVY (M g r, gravity along -z, r along the body's z). The true attitude of a free
   body is libpolhode's closed form, that of a heavy top ref's, whose oracle is
   tests/oracle/heavy_top.c. */
#include "top.h"

#include "polhode.h"
#include "ref.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

enum { GROUPS = 8, QUANTITIES = 5, MEMBERS_MOST = 256 };

typedef void step_function(const top_model *, top_real, top_real *, const top_real *, top_real);
typedef void low_function(const top_model *, top_real, top_real *, const top_real *, top_real,
                          top_real *);
enum kind { STEP, LOW, CLOSED, LIBRARY_RK4, WHOLE };

#ifdef Q31
#include "top_q31.h"
#endif

static const struct row {
  enum kind kind;
  step_function *step;
  low_function *low;
} rows[] = {
#include "rows.h"
};

static top_model model;
static ref_model reference;
static ph_top body;
static double moment[6]; /* about the origin; x, y, z are principal axes */
static double middle;

static unsigned long long seed = 1;

/* uniform in (-1, 1): Knuth's MMIX generator */
static double uniform(void) {
  seed = seed * 6364136223846793005ULL + 1442695040888963407ULL;
  return ((double)(seed >> 11) + 0.5) * 0x1p-52 - 1;
}

/* A free body turns at 1 rad/s, not near its separatrix, where a rounding decides about a flip; a
   heavy top spins at 2.5 to 3.5 rad/s with a tilt of 0.3 to 1.2 rad. */
static void start(top_real x[7]) {
  double w[3], q[4], size;

  if (HEAVY != 0) {
    const double tilt = 0.75 + 0.45 * uniform(), turn = 3.14 * uniform();

    q[0] = cos(tilt / 2) * cos(turn / 2);
    q[1] = sin(tilt / 2) * cos(turn / 2);
    q[2] = sin(tilt / 2) * sin(turn / 2);
    q[3] = cos(tilt / 2) * sin(turn / 2);
    w[0] = 0.3 * uniform();
    w[1] = 0.3 * uniform();
    w[2] = 3 + 0.5 * uniform();
  } else {
    double G, T;

    do {
      for (int i = 0; i < 4; i++)
        q[i] = uniform();
      size = sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    } while (!(size > 0.1 && size < 1));
    for (int i = 0; i < 4; i++)
      q[i] /= size;
    do {
      for (int i = 0; i < 3; i++)
        w[i] = uniform();
      size = sqrt(w[0] * w[0] + w[1] * w[1] + w[2] * w[2]);
      for (int i = 0; i < 3; i++)
        w[i] /= size;
      T = G = 0;
      for (int i = 0; i < 3; i++) {
        T += moment[i] * w[i] * w[i];
        G += moment[i] * moment[i] * w[i] * w[i];
      }
    } while (!(size < 1 && fabs(G / T - middle) > 0.1 * middle));
  }
  for (int i = 0; i < 4; i++)
    x[i] = (top_real)q[i];
  for (int i = 0; i < 3; i++)
    x[4 + i] = (top_real)w[i];
}

/* {E, T, Lx, Ly, Lz, |q|} of a state */
static void invariants(const long double x[7], long double out[6]) {
  const long double n = sqrtl(x[0] * x[0] + x[1] * x[1] + x[2] * x[2] + x[3] * x[3]);
  const long double a = x[0] / n, b = x[1] / n, c = x[2] / n, d = x[3] / n;
  const long double l[3] = {moment[0] * x[4], moment[1] * x[5], moment[2] * x[6]};

  out[1] = (l[0] * x[4] + l[1] * x[5] + l[2] * x[6]) / 2;
  out[0] = out[1] + HEAVY * (1 - 2 * (b * b + c * c));
  out[2] =
      (1 - 2 * (c * c + d * d)) * l[0] + 2 * (b * c - a * d) * l[1] + 2 * (b * d + a * c) * l[2];
  out[3] =
      2 * (b * c + a * d) * l[0] + (1 - 2 * (b * b + d * d)) * l[1] + 2 * (c * d - a * b) * l[2];
  out[4] =
      2 * (b * d - a * c) * l[0] + 2 * (c * d + a * b) * l[1] + (1 - 2 * (b * b + c * c)) * l[2];
  out[5] = n;
}

static long double length(const long double v[3]) {
  return sqrtl(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

/* angle between two attitudes, either sign of q */
static long double apart(const long double x[], const double y[]) {
  long double n = 0, m = 0, plus = 0, minus = 0;

  for (int i = 0; i < 4; i++) {
    n += x[i] * x[i];
    m += (long double)y[i] * y[i];
  }
  n = sqrtl(n);
  m = sqrtl(m);
  for (int i = 0; i < 4; i++) {
    plus += (x[i] / n + y[i] / m) * (x[i] / n + y[i] / m);
    minus += (x[i] / n - y[i] / m) * (x[i] / n - y[i] / m);
  }
  return 2 * sqrtl(plus < minus ? plus : minus);
}

/* ---- one member of the ensemble: from its state at n steps to that at `to` ---- */

struct member {
  top_real x[7], low[7];
  double x0[7];
  long double first[6];
  ph_free_top free;
  ref_orbit orbit;
  ph_run *run;
#ifdef Q31
  int32_t word[TOP_Q31_NX];
#endif
#ifdef TICKS
  top_orbit tick;
#endif
};

static int prepare(struct member *m, const struct row *r, top_real h) {
  ph_options options = ph_options_default();

  start(m->x);
#ifdef Q31
  for (int i = 0; i < 7; i++)
    m->x0[i] = (double)m->x[i];
  (void)top_q31_from_real(m->x0, m->word);
  top_q31_to_real(m->word, m->x0);
  for (int i = 0; i < 7; i++)
    m->x[i] = (top_real)m->x0[i];
#endif
  for (int i = 0; i < 7; i++) {
    m->x0[i] = (double)m->x[i];
    m->low[i] = 0;
  }
  if (HEAVY != 0 ? ref_solve(&m->orbit, &reference, m->x0)
                 : ph_free_top_solve(&m->free, &body, m->x0))
    return 1;
#ifdef TICKS
  if (r->kind == CLOSED && (top_solve(&m->tick, &model, m->x) || top_set_tick(&m->tick, h)))
    return 1;
#endif
  options.method = PH_RK4;
  options.step = (double)h;
  m->run = NULL;
  return r->kind == LIBRARY_RK4 && ph_run_new(&m->run, &body, &options, 0, m->x0);
}

static int advance(struct member *m, const struct row *r, top_real h, long n, long to,
                   long double y[7]) {
  double z[7];

  for (long k = n; k < to && r->kind == STEP; k++)
    r->step(&model, (top_real)k * h, m->x, NULL, h);
  for (long k = n; k < to && r->kind == LOW; k++)
    r->low(&model, (top_real)k * h, m->x, NULL, h, m->low);
  for (int i = 0; i < 7; i++)
    y[i] = (long double)m->x[i] + m->low[i];
#ifdef TICKS
  if (r->kind == CLOSED) {
    top_at_tick(&m->tick, to, m->x);
    for (int i = 0; i < 7; i++)
      y[i] = m->x[i];
  }
#endif
#ifdef Q31
  for (long k = n; k < to && r->kind == WHOLE; k++)
    if (top_q31_step(m->word, NULL))
      return 1;
  top_q31_to_real(m->word, z);
  for (int i = 0; i < 7; i++)
    y[i] = z[i];
#endif
  if (m->run) {
    if (ph_run_to(m->run, (double)to * (double)h, NULL, z))
      return 1;
    for (int i = 0; i < 7; i++)
      y[i] = z[i];
  }
  return 0;
}

static int errors(struct member *m, const long double y[7], double t, long double e[QUANTITIES]) {
  long double now[6], cross[3];
  const long double *L = now + 2, *L0 = m->first + 2;
  const long double size = length(L0);
  double z[7];

  invariants(y, now);
  if (HEAVY != 0)
    ref_at(&m->orbit, t, z);
  else if (ph_free_top_at(&m->free, t, z))
    return 1;
  for (int i = 0; i < 3; i++)
    cross[i] = L[(i + 1) % 3] * L0[(i + 2) % 3] - L[(i + 2) % 3] * L0[(i + 1) % 3];
  e[0] = (now[0] - m->first[0]) / m->first[1];
  e[1] = HEAVY != 0 ? (L[2] - L0[2]) / size : length(L) / size - 1;
  e[2] = length(cross) / (size * size);
  e[3] = now[5] - 1;
  e[4] = apart(y, z);
  return 0;
}

int main(int argc, char **argv) {
  static struct member member[MEMBERS_MOST];
  const double down[3] = {0, 0, -1};
  double com[3], mass, spent = 0;
  const struct row *r = argc == 5 ? &rows[atoi(argv[1])] : NULL;
  /* 24 bits, so that n h is a double */
  const top_real h = argc == 5 ? (top_real)(float)atof(argv[2]) : 0;
  const long steps = argc == 5 ? atol(argv[3]) : 0;
  const int members = argc == 5 ? atoi(argv[4]) : 0;

  if (steps < 100 || members < GROUPS || members > MEMBERS_MOST || members % GROUPS != 0 ||
      top_init(&model, NULL) || ref_init(&reference, NULL))
    return 2;
  ref_inertia(&reference, moment);
  for (int i = 0; i < 3; i++) {
    const double b = moment[(i + 1) % 3], c = moment[(i + 2) % 3];

    if ((moment[i] - b) * (moment[i] - c) < 0)
      middle = moment[i];
  }
  mass = ref_mass(&reference, com);
  if (ph_top_init_tensor(&body, mass, com, moment))
    return 2;
  if (HEAVY != 0 && ph_top_gravity(&body, HEAVY / (mass * com[2]), down))
    return 2;
  for (int i = 0; i < members; i++)
    if (prepare(&member[i], r, h))
      return 3;
  for (int i = 0; i < members; i++) {
    long double y[7];

    for (int k = 0; k < 7; k++)
      y[k] = member[i].x0[k];
    invariants(y, member[i].first);
  }
  for (long n = 0, to = 100, k = 7; n < steps; n = to, to = lround(pow(10, (double)k++ / 3))) {
    long double mean[QUANTITIES] = {0}, square[QUANTITIES][GROUPS] = {{0}};

    if (to > steps)
      to = steps;
    for (int i = 0; i < members; i++) {
      long double y[7], e[QUANTITIES];
      const clock_t before = clock();

      if (advance(&member[i], r, h, n, to, y))
        return 4;
      spent += (double)(clock() - before);
      if (errors(&member[i], y, (double)((long double)h * to), e))
        return 4;
      for (int q = 0; q < QUANTITIES; q++) {
        mean[q] += e[q] / members;
        square[q][i % GROUPS] += e[q] * e[q] * GROUPS / members;
      }
    }
    printf("%ld", to);
    for (int q = 0; q < QUANTITIES; q++) {
      printf(" %.3Le", mean[q]);
      for (int g = 0; g < GROUPS; g++)
        printf(" %.6Le", square[q][g]);
    }
    printf("\n");
    fflush(stdout);
  }
  printf("time %.1f\n", spent * (1e9 / CLOCKS_PER_SEC) / ((double)steps * members));
  for (int i = 0; i < members; i++)
    ph_run_free(member[i].run);
  return 0;
}
