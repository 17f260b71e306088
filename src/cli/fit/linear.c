/* linear.c - a start without a guess for a body that nothing acts on: its momentum is constant.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * I w = W(w) e is linear in the six entries e = (xx, yy, zz, xy, xz, yz) of the tensor, so Euler's
 * equation, integrated over a window from a to b, is
 *     [W(w_b) - W(w_a) + int w x W(w) dt] e = 0,
 * linear equations for the free parameters, where e = c + A p; no motion is computed.  The
 * integral is taken by trapezoids over the logged rates; windows do not cross gaps.  Noise in short
 * windows pulls the moments towards each other, long ones gather it: several lengths are tried, and
 * the one whose motion is nearest to the log is taken.
 * (The integrated form of the regressor of C. G. Atkeson, C. H. An, J. M. Hollerbach, Int. J.
 * Robotics Research 5 (1986).)
 */
#include "fit.h"
#include "host/host.h"

#include <math.h>
#include <string.h>

enum { POINTS = 20000, ENTRIES = 6 };

/* The momentum's change since the beginning, at some rows: W(w) + int w x W(w) dt, 3 x 6. */
struct point {
  double m[3][ENTRIES];
  int piece; /* between gaps */
};

static struct point point[POINTS];
static struct fit_triangle triangle;

static void momentum(const double w[3], double W[3][ENTRIES]) {
  const double rows[3][ENTRIES] = {
      {w[0], 0, 0, w[1], w[2], 0}, {0, w[1], 0, w[0], 0, w[2]}, {0, 0, w[2], 0, w[0], w[1]}};
  memcpy(W, rows, sizeof rows);
}

static void crossed(const double w[3], double W[3][ENTRIES], double out[3][ENTRIES]) {
  for (int k = 0; k < ENTRIES; k++)
    for (int i = 0; i < 3; i++)
      out[i][k] = w[(i + 1) % 3] * W[(i + 2) % 3][k] - w[(i + 2) % 3] * W[(i + 1) % 3][k];
}

/* The rates of a row, as the scene's own values of scale and bias have them; 0: one is missing. */
static int rates(const struct fit_linear *a, const struct fit_log *log, size_t row, double w[3]) {
  for (int i = 0; i < 3; i++) {
    const double y = log->y[row * (size_t)log->columns + (size_t)a->column[i]];
    if (isnan(y))
      return 0;
    w[i] = (y - a->bias[i]) / a->scale[i];
  }
  return 1;
}

/* The points of a log, every stride-th row; how many. */
static int points_of(const struct fit_linear *a, const struct fit_log *log) {
  const size_t stride = log->rows / POINTS + 1;
  double integral[3][ENTRIES] = {{0}}, before[3][ENTRIES] = {{0}}, last = 0;
  int n = 0, piece = 0, begun = 0;
  for (size_t row = 0; row < log->rows; row++) {
    double w[3], W[3][ENTRIES], now[3][ENTRIES];
    if (!rates(a, log, row, w))
      continue;
    momentum(w, W);
    crossed(w, W, now);
    const double dt = log->t[row] - last;
    piece += begun && dt > 3 * log->spacing;
    for (int i = 0; begun && i < 3; i++)
      for (int k = 0; k < ENTRIES; k++)
        integral[i][k] += dt * (before[i][k] + now[i][k]) / 2;
    memcpy(before, now, sizeof before);
    last = log->t[row];
    begun = 1;
    if (row % stride != 0 || n == POINTS)
      continue;
    for (int i = 0; i < 3; i++)
      for (int k = 0; k < ENTRIES; k++)
        point[n].m[i][k] = W[i][k] + integral[i][k];
    point[n++].piece = piece;
  }
  return n;
}

/* The equations of the windows from i to i + step. */
static void windows(const struct fit_linear *a, int n, int step) {
  for (int i = 0; i + step < n; i++) {
    if (point[i].piece != point[i + step].piece)
      continue;
    for (int j = 0; j < 3; j++) {
      double row[FIT_MOST + 1] = {0};
      for (int e = 0; e < ENTRIES; e++) {
        const double d = point[i + step].m[j][e] - point[i].m[j][e];
        for (int k = 0; k < a->count; k++)
          row[k] += d * a->slope[e][k];
        row[a->count] -= d * a->constant[e];
      }
      triangle_row(&triangle, row);
    }
  }
}

/* p of the triangle by substitution; 0: it is singular. */
static int substituted(int n, double p[]) {
  for (int i = n - 1; i >= 0; i--) {
    double sum = triangle_at(&triangle, i, n);
    for (int k = i + 1; k < n; k++)
      sum -= triangle_at(&triangle, i, k) * p[k];
    p[i] = sum / triangle_at(&triangle, i, i);
    if (!isfinite(p[i]))
      return 0;
  }
  return 1;
}

/* Where all entries are free, no equation knows their scale: the trace is that of the start. */
static void fixed_trace(const struct fit_linear *a, const double theta[]) {
  double row[FIT_MOST + 1] = {0}, size = 0;
  for (int e = 0; e < ENTRIES; e++)
    if (a->constant[e] != 0)
      return;
  for (int i = 0; i < a->count; i++)
    for (int k = i; k < a->count; k++)
      size = fmax(size, fabs(triangle_at(&triangle, i, k)));
  for (int k = 0; k < a->count; k++) {
    row[k] = size * (a->slope[0][k] + a->slope[1][k] + a->slope[2][k]);
    row[a->count] += row[k] * theta[a->place[k]];
  }
  triangle_row(&triangle, row);
}

/* The rates with which a log begins, where they are free. */
static void first_rates(const struct fit_problem *f, const struct fit_linear *a, int log,
                        double theta[]) {
  double w[3];
  for (size_t row = 0; row < f->log[log].rows; row++)
    if (rates(a, &f->log[log], row, w)) {
      for (int i = 0; i < 3; i++)
        if (f->own > 0)
          theta[f->free + log * f->own + a->own[i]] = w[i];
        else if (a->initial[i] >= 0 && log == 0)
          theta[a->initial[i]] = w[i];
      return;
    }
}

int fit_linear(struct fit_problem *f, double theta[]) {
  double best[FIT_MOST], p[FIT_MOST] = {0}, begun[FIT_MOST], least = (double)INFINITY;
  memcpy(begun, theta, (size_t)f->n * sizeof theta[0]);
  int most = 1;
  for (int log = 0; log < f->logs; log++)
    first_rates(f, &f->linear[log], log, theta);
  for (int step = 1; step <= most && !interrupt_pending(); step *= 2) {
    struct fit_sums only = {.whole = NULL};
    const struct fit_linear *a = f->linear;
    triangle_open(&triangle, a->count);
    for (int log = 0; log < f->logs; log++) {
      const int n = points_of(&f->linear[log], &f->log[log]);
      most = n / 4 > most ? n / 4 : most;
      windows(&f->linear[log], n, step);
    }
    triangle_close(&triangle);
    fixed_trace(a, theta);
    triangle_close(&triangle);
    if (!substituted(a->count, p))
      continue;
    double way[FIT_MOST] = {0}, to[FIT_MOST];
    for (int k = 0; k < a->count; k++)
      way[a->place[k]] = p[k] - begun[a->place[k]];
    int rule; /* as it stands if that is a body */
    if (fit_border(f, begun, way, &rule) >= 1) {
      fit_inside(f, begun, way, to);
      for (int k = 0; k < a->count; k++)
        p[k] = to[a->place[k]];
    }
    for (int k = 0; k < a->count; k++)
      theta[a->place[k]] = p[k];
    if (!fit_pass(f, theta, &only) && only.chi2 < least) {
      least = only.chi2;
      memcpy(best, theta, (size_t)f->n * sizeof best[0]);
    }
  }
  if (isfinite(least))
    memcpy(theta, best, (size_t)f->n * sizeof best[0]);
  return isfinite(least);
}
