/* query.c - measures the inverse questions about the free top: part of query.t, which judges.
   SPDX-License-Identifier: GPL-3.0-or-later

   Two compiled scenes, top (double) and small (float), of a tensor whose six entries are
   parameters, against the library's free top, whose road is another. Prints
     "TYPE WHAT worst count"    differences in units of the type's last place, or how many were
   wrong "known NAME period precession number"    days, days, turns "flip MIDDLE line" / "period
   NUMBER line"    motions at a time, for the oracle */
#include "polhode.h"
#include "small.h"
#include "top.h"

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

static uint64_t seed = 88172645463325252u;
static double uniform(void) { /* in (0, 1): xorshift64, Marsaglia 2003 */
  seed ^= seed << 13;
  seed ^= seed >> 7;
  seed ^= seed << 17;
  return ((double)(seed >> 11) + 0.5) * 0x1p-53;
}

/* Both emitted types behind one set of functions; numbers cross as double. */
typedef struct asked {
  double period, rate, precession, number;
} asked;
static top_orbit wide;
static small_orbit narrow;
static int single;
static double eps;

static double held(double x) {
  return single ? (double)(float)x : x;
}

static int solve(const double I[6], const double x0[7]) {
  if (single) {
    small_model m;
    float p[SMALL_NP], x[7];
    for (int i = 0; i < 7; i++) {
      x[i] = (float)x0[i];
      if (i < 6)
        p[i] = (float)I[i];
    }
    return small_init(&m, p) || small_solve(&narrow, &m, x);
  }
  top_model m;
  return top_init(&m, I) || top_solve(&wide, &m, x0);
}

static asked ask(void) {
  if (single)
    return (asked){(double)small_polhode_period(&narrow), (double)small_precession_rate(&narrow),
                   (double)small_precession_period(&narrow),
                   (double)small_rotation_number(&narrow)};
  return (asked){top_polhode_period(&wide), top_precession_rate(&wide),
                 top_precession_period(&wide), top_rotation_number(&wide)};
}

static double flip(double t) {
  return single ? (double)small_next_flip(&narrow, (float)t) : top_next_flip(&wide, t);
}

static double worse(double a, double b) {
  return b <= a ? a : b; /* a NaN stays */
}

static double off(double got, double want) {
  return got == want ? 0 : fabs(got - want) / (fabs(want) * eps);
}

static void tell(const char *what, double worst, int count) {
  printf("%s %s %.3g %d\n", single ? "float" : "double", what, worst, count);
}

/* A body and a state, numbers of the type: wide apart, nearly symmetric, or within 2^-k of the
   separatrix; every third in oblique axes; scales that are no matter. */
static void draw(int n, double I[6], double x[7]) {
  double s[3] = {0.05 + uniform(), 0.05 + uniform(), 0.05 + uniform()}, turn[4], m[6] = {0};
  if (n % 4 == 1)
    s[1] = s[0] * (1 + pow(2, -18 * uniform()) * 0.5);
  for (int i = 0; i < 3; i++)
    m[i] = held(s[(i + 1) % 3] + s[(i + 2) % 3]);
  for (int i = 0; i < 7; i++)
    x[i] = held(2 * uniform() - 1);
  if (n % 4 == 2) {
    int o[3] = {0, 1, 2};
    for (int i = 0; i < 3; i++)
      for (int j = i + 1; j < 3; j++)
        if (m[o[j]] < m[o[i]]) {
          const int k = o[i];
          o[i] = o[j];
          o[j] = k;
        }
    const double a = m[o[0]], b = m[o[1]], c = m[o[2]];
    x[4 + o[2]] = held(x[4 + o[0]] * sqrt(a * (b - a) / (c * (c - b))) *
                       (1 + pow(2, -(single ? 20 : 45) * uniform()) * (uniform() < 0.5 ? -1 : 1)));
  }
  memcpy(I, m, sizeof m);
  for (int i = 0; i < 4; i++)
    turn[i] = 2 * uniform() - 1;
  if (n % 3 == 0)
    ph_tensor_turn(m, turn, I);
  const int size = (int)(60 * uniform()) - 30, speed = (int)(60 * uniform()) - 30;
  for (int i = 0; i < 6; i++)
    I[i] = ldexp(held(I[i]), size);
  for (int i = 4; i < 7; i++)
    x[i] = ldexp(x[i], speed);
}

static void random_motions(int count) {
  double period = 0, rate = 0, number = 0, inverse = 0, next = 0;
  int solved = 0, flips = 0;
  for (int n = 0; n < count; n++) {
    double I[6], x[7];
    ph_top top;
    ph_free_top f;
    draw(n, I, x);
    if (ph_top_init_tensor(&top, 1, NULL, I) || ph_free_top_solve(&f, &top, x) ||
        f.kind != PH_FREE_PERIODIC)
      continue; /* rounding has broken the triangle inequality */
    if (solve(I, x)) {
      solved = -count;
      continue;
    }
    solved++;
    const asked a = ask();
    period = worse(period, off(a.period, f.period));
    rate = worse(rate, off(a.rate, f.precession));
    number = worse(number, off(a.number, f.turn / 6.283185307179586477));
    inverse = worse(inverse, off(a.precession * a.rate, 6.283185307179586477));
    for (int k = 0; k < (single ? 5 : 12); k++) { /* 10^11 periods, float: 10^4 */
      const double t = k ? held((2 * uniform() - 1) * f.period * pow(10, k - 1)) : 0;
      double want;
      if (ph_free_top_flip(&f, t, &want))
        continue;
      /* the library knows a phase to 2^-64 */
      const double got = flip(t), room = eps * fabs(want) + 0x1p-60 * f.period;
      next = worse(next, !(got > t) ? HUGE_VAL : fabs(got - want) / room);
      flips++;
    }
  }
  tell("period", period, solved);
  tell("rate", rate, solved);
  tell("number", number, solved);
  tell("inverse", inverse, solved);
  tell("next", next, flips);
}

/* t = next_flip(t) from afar: every one greater, half a period apart, and the middle rate of
   another sign between each two. */
static void chain(double periods, int judged) {
  const double I[6] = {1, 2, 2.5, 0, 0, 0}, x[7] = {0.5, 0.5, -0.5, 0.5, 0.25, 1, -0.125};
  ph_top top;
  ph_free_top f;
  if (solve(I, x) || ph_top_init_tensor(&top, 1, NULL, I) || ph_free_top_solve(&f, &top, x))
    return;
  double t = held(periods * f.period), before = 0, y[7];
  int wrong = 0;
  for (int n = 0; n < 1000; n++) {
    const double next = flip(t);
    wrong += !(next > t);
    if (judged && n) {
      wrong += !(fabs(next - t - f.period / 2) <= eps * fabs(next) + 4 * eps * f.period);
      ph_free_top_at(&f, (t + next) / 2, y);
      wrong += n > 1 && y[5] * before >= 0;
      before = y[5];
    }
    t = next;
  }
  tell("chain", wrong, 1000);
}

/* Where there is no period; what must hold exactly is counted if it does not. */
static void limits(void) {
  const double zero[7] = {1, 0, 0, 0, 0, 0, 0}, pi2 = 6.283185307179586477;
  double x[7];
  int wrong = 0, count = 0;
  for (int k = 0; k < 16; k++) { /* rest; spins; a sphere; at huge and tiny scales */
    const double size = ldexp(1, k % 4 == 0 ? 0 : k % 4 == 1 ? -80 : 80);
    const double sphere = k >= 12;
    const double I[6] = {1, sphere != 0 ? 1 : 2, sphere != 0 ? 1 : 2.5, 0, 0, 0};
    memcpy(x, zero, sizeof x);
    if (k % 4 != 3)
      x[4 + k / 4 % 3] = size;
    const int status = solve(I, x);
    const asked a = ask();
    wrong += status != 0 || a.period != 0 || a.number != 0 || flip(0) != HUGE_VAL ||
             flip(-1) != HUGE_VAL;
    wrong += k % 4 == 3 ? a.rate != 0 || a.precession != HUGE_VAL
                        : !(off(a.rate, size) <= 1 && off(a.precession, pi2 / size) <= 1);
    count++;
  }
  tell("constant", wrong, count);

  wrong = count = 0; /* exactly on the separatrix: G = sqrt(12^2 + 2.5^2 + 9^2), precession G/I2 */
  for (int k = 0; k < 8; k++) {
    const double I[6] = {4, 5, 9, 0, 0, 0},
                 w[3] = {k & 1 ? 3 : -3, k & 2 ? 0.5 : -0.5, k & 4 ? 1 : -1};
    double before, after;
    ph_top top;
    ph_free_top f;
    memcpy(x, zero, sizeof x);
    memcpy(x + 4, w, sizeof w);
    int status =
        solve(I, x) || ph_top_init_tensor(&top, 1, NULL, I) || ph_free_top_solve(&f, &top, x);
    const asked a = ask();
    status = status || ph_free_top_flip(&f, -100, &before) || ph_free_top_flip(&f, 0, &after);
    const double once = isfinite(before) ? before : after;
    wrong += status || a.period != HUGE_VAL || a.number != HUGE_VAL ||
             !(off(a.rate, sqrt(231.25) / 5) <= 2) || !(off(flip(-100), once) <= 1) ||
             flip(flip(-100)) != HUGE_VAL || (flip(0) == HUGE_VAL) != (once < 0);
    count++;
  }
  tell("separatrix", wrong, count);

  wrong = count = 0; /* rates by a power of two faster: times shorter by it, to the bit */
  const double I[6] = {1, 2, 2.5, 0.25, 0, 0}, w[3] = {0.25, 1, -0.125};
  const int far = single ? 100 : 900;
  memcpy(x, zero, sizeof x);
  memcpy(x + 4, w, sizeof w);
  wrong += solve(I, x);
  const asked one = ask();
  const double first = flip(0), later = flip(1000);
  for (int k = -far; k <= far; k += far / 4) {
    for (int i = 0; i < 3; i++)
      x[4 + i] = ldexp(w[i], k);
    wrong += solve(I, x);
    const asked a = ask();
    wrong += a.period != ldexp(one.period, -k) || a.rate != ldexp(one.rate, k) ||
             a.precession != ldexp(one.precession, -k) || a.number != one.number ||
             flip(0) != ldexp(first, -k) || flip(ldexp(1000, -k)) != ldexp(later, -k);
    count++;
  }
  tell("scaled", wrong, count);

  /* the symmetric top: Omega = (I3 - I1)/I1 w3, precession G/I1 (Landau and Lifshitz, 33, 36) */
  const double S[6] = {2, 2, 3, 0, 0, 0}, v[3] = {0.75, -0.5, 1};
  memcpy(x + 4, v, sizeof v);
  wrong = solve(S, x);
  const asked s = ask();
  wrong += !(off(s.period, pi2 / 0.5) <= 2) || !(off(s.rate, sqrt(1.5 * 1.5 + 1 + 9) / 2) <= 2);
  wrong += !(fabs(flip(flip(0)) - flip(0) - s.period / 2) <= 4 * eps * s.period);
  tell("symmetric", wrong, 1);
}

/* At any time that is a number the state is one: a unit quaternion, and T as it was, although after
   2^40 turns (float: 2^20) nobody knows where in its motion the top is. Both sides of the
   separatrix, on it, near it, a fast spin. */
static void any_time(void) {
  static const double w[5][3] = {
      {0.25, 1, -0.125}, {3, 0.5, 1}, {2.9999, 0.5, 1}, {3.0001, 0.5, 1}, {1e-3, 0, 1}};
  const double I[6] = {4, 5, 9, 0, 0, 0};
  double norm = 0, energy = 0;
  int count = 0;
  for (int n = 0; n < 5; n++)
    for (double size = 1; size < (single ? 1e38 : 1e300); size *= 31.7)
      for (int back = 0; back < 2; back++) {
        const double t = back ? -size : size;
        double x[7] = {1, 0, 0, 0, w[n][0], w[n][1], w[n][2]}, T0 = 0, T = 0;
        float y[7];
        if (solve(I, x))
          continue;
        for (int i = 0; i < 3; i++)
          T0 += I[i] * x[4 + i] * x[4 + i];
        if (single)
          small_at(&narrow, (float)t, y);
        else
          top_at(&wide, t, x);
        for (int i = 0; single && i < 7; i++)
          x[i] = (double)y[i];
        for (int i = 0; i < 3; i++)
          T += I[i] * x[4 + i] * x[4 + i];
        norm = worse(norm, off(x[0] * x[0] + x[1] * x[1] + x[2] * x[2] + x[3] * x[3], 1));
        energy = worse(energy, off(T, T0));
        count++;
      }
  tell("norm", norm, count);
  tell("energy", energy, count);
}

static void known(const char *name, const double I[6], const double x[7], double day) {
  if (solve(I, x))
    return;
  const asked a = ask();
  printf("known %s %.9g %.9g %.9g\n", name, a.period / day, a.precession / day, a.number);
}

static void print_line(const double I[6], const double x[7], double t) {
  printf("%.17g %.17g %.17g 0 0 0 %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g\n", I[0], I[1],
         I[2], x[4], x[5], x[6], x[0], x[1], x[2], x[3], t);
}

/* Diagonal bodies, for the oracle: just before and after some flips, and after a period. */
static void for_oracle(void) {
  for (int n = 1; n < 18; n++) {
    double I[6], x[7], t;
    int middle = 0;
    if (n % 3 == 0)
      continue;
    draw(n, I, x);
    for (int i = 0; i < 3; i++)
      if ((I[i] - I[(i + 1) % 3]) * (I[i] - I[(i + 2) % 3]) < 0)
        middle = i;
    if (solve(I, x))
      continue;
    const asked a = ask();
    for (int k = 0; k < 6; k++) {
      t = flip((k - 2) * a.period * pow(7, k));
      /* what t rounds is half a unit off at most */
      printf("flip %d ", middle);
      print_line(I, x, nextafter(t, -HUGE_VAL));
      printf("flip %d ", middle);
      print_line(I, x, nextafter(t, HUGE_VAL));
    }
    printf("period %.17g ", a.number);
    print_line(I, x, a.period);
  }
}

int main(void) {
  for (single = 0; single < 2; single++) {
    eps = single ? (double)FLT_EPSILON : DBL_EPSILON;
    random_motions(3000);
    chain(-5, 1);
    chain(single ? 1e3 : 1e9, 1);
    chain(-1e30, 0);
    chain(1e7, 0);
    limits();
    any_time();
  }
  single = 0;
  eps = DBL_EPSILON;
  /* Toutatis, days and degrees: ratios of moments and rates as estimated from five encounters by
     radar (Takahashi, Busch, Scheeres 2013, Astron. J. 146, 95), to three digits */
  const double degree = 3.14159265358979324 / 180;
  known("toutatis", (const double[]){3.08, 3.24, 1, 0, 0, 0},
        (const double[]){1, 0, 0, 0, 14.5 * degree, 33.5 * degree, -98.7 * degree}, 1);
  known("earth", (const double[]){8.0101, 8.0103, 8.0365, 0, 0, 0},
        (const double[]){1, 0, 0, 0, 7.292115e-11, 0, 7.292115e-5}, 86400);
  for_oracle();
  return 0;
}
