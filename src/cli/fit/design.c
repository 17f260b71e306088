/* design.c - what a log would tell of the unknowns, before anything is measured.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * design(path, {as for fit, with logs = {false}; rows =, spacing = of the log; places = of what the
 *     candidates set (k: parameter k, -k: initial state k), candidates = {their numbers, one
 *     candidate after the other}, of = {unknowns whose errors count}, size = {of each unknown, what
 *     its error is compared with}})
 * -> {of each candidate: {refused = 0, the check of the parameters that failed, or -1: the motion
 *     is not finite, settled = is the step short enough?, unknowns, rank, theta, covariance,
 *     singular, vectors, scale, mean, root, largest}} | nil, message
 *
 * The log is that of the model itself, so a pass (pass.c) leaves Fisher's information F = J'J of
 * its noise, and C = F^-1 is the bound of Cramer and Rao.  Of V = S^-1 C S^-1 over the unknowns
 * that count, S = diag(size), three numbers are given, all of them relative standard errors:
 *     mean    det(V)^(1/2p)     the geometric mean over the axes of the ellipsoid (D)
 *     root    sqrt(tr V/p)      the root of the mean square (A)
 *     largest sqrt(max eigenvalue of V)                      (E)
 * (F. Pukelsheim: Optimal Design of Experiments, SIAM 2006, chapter 6.)
 */
#include "fit.h"
#include "host/fields.h"
#include "host/host.h"

#include <dlfcn.h>
#include <gsl/gsl_eigen.h>
#include <math.h>
#include <string.h>

/* By how much halving the step may move a standard error, relative to it. */
#define SETTLED 1e-6

struct design {
  struct fit_problem f;
  struct fit_sums sums;
  struct fit_result result;
  double start[FIT_MOST], fixed[64], size[FIT_MOST], step;
  int place[FIT_MOST], places, of[FIT_MOST], count;
  double mean, root, largest;
};

/* A log of the model's own values, at equal times. */
static void make_log(lua_State *L, struct design *d) {
  const int columns = (int)fields_number(L, 2, "columns");
  const size_t rows = (size_t)fields_number(L, 2, "rows");
  const double spacing = fields_number(L, 2, "spacing");
  struct fit_log *log = d->f.log;
  *log = (struct fit_log){.rows = rows, .columns = columns, .spacing = spacing};
  log->t = fit_room(L, rows * sizeof *log->t);
  log->y = fit_room(L, rows * (size_t)columns * sizeof *log->y);
  for (size_t i = 0; i < rows; i++)
    log->t[i] = (double)i * spacing;
}

/* One pass at a step: the covariance; 1: no motion. */
static int covariance(struct design *d, const double theta[]) {
  struct fit_result *r = &d->result;
  memcpy(r->theta, theta, FIT_MOST * sizeof theta[0]);
  if (fit_simulate(&d->f, theta, 0) || fit_pass(&d->f, theta, &d->sums))
    return 1;
  fit_decompose(&d->f, d->sums.whole, theta, r);
  fit_inverse(r, d->f.n, r->covariance);
  return 0;
}

/* The step is halved until the standard errors stay, by the law of a method of order 4.  1: they
 * do; 0: not after 14 halvings, or the parameters are refused; -1: the motion is not finite. */
static int settle(struct design *d, const double theta[]) {
  double before[FIT_MOST];
  int rank = -1;
  d->f.h = d->step;
  for (int i = 0; i < 14 && !interrupt_pending(); i++, d->f.h /= 2) {
    if (covariance(d, theta)) {
      rank = -1; /* a step that is too long may leave the range of numbers */
      if (d->f.refused != 0)
        return 0;
      continue;
    }
    double moved = rank == d->result.rank ? 0 : 1;
    for (int k = 0; k < d->f.n; k++) {
      const double now = sqrt(d->result.covariance[k * d->f.n + k]);
      if (rank >= 0 && now > 0)
        moved = fmax(moved, fabs(now - before[k]) / now);
      before[k] = now;
    }
    rank = d->result.rank;
    if (moved < 15 * SETTLED)
      return 1;
  }
  return rank < 0 ? -1 : 0;
}

static void criteria(struct design *d) {
  const size_t p = (size_t)d->count;
  const int n = d->f.n;
  gsl_matrix *v = gsl_matrix_alloc(p, p);
  gsl_vector *e = gsl_vector_alloc(p);
  gsl_eigen_symm_workspace *w = gsl_eigen_symm_alloc(p);
  for (size_t i = 0; i < p; i++)
    for (size_t k = 0; k < p; k++) {
      const int a = d->of[i], b = d->of[k];
      gsl_matrix_set(v, i, k, d->result.covariance[a * n + b] / (d->size[a] * d->size[b]));
    }
  gsl_eigen_symm(v, e, w);
  double sum = 0, logs = 0, most = 0;
  for (size_t i = 0; i < p; i++) {
    const double x = fmax(gsl_vector_get(e, i), 0);
    sum += x;
    logs += log(x);
    most = fmax(most, x);
  }
  d->mean = exp(logs / (double)(2 * p));
  d->root = sqrt(sum / (double)p);
  d->largest = sqrt(most);
  gsl_eigen_symm_free(w);
  gsl_vector_free(e);
  gsl_matrix_free(v);
}

/* Where the unknown of an initial state stands, or -1: it is none, or the attitude's. */
static int own_place(const struct fit_problem *f, int state) {
  const int at = f->code->attitude;
  if (f->own == 0 || (at >= 0 && state >= at && state < at + 4))
    return -1;
  return f->free + state - (at >= 0 && state >= at + 4);
}

/* A candidate's values to their places: parameters, initial states that are unknowns, and those
 * that are not. */
static void take(struct design *d, const double candidate[], double theta[]) {
  memcpy(theta, d->start, FIT_MOST * sizeof theta[0]);
  for (int i = 0; i < d->places; i++) {
    const int place = d->place[i];
    if (place > 0) {
      d->f.p[place - 1] = candidate[i];
      for (int k = 0; k < d->f.free; k++)
        if (d->f.free_index[k] == place - 1)
          theta[k] = candidate[i];
    } else {
      const int own = own_place(&d->f, -place - 1);
      if (own >= 0)
        theta[own] = candidate[i];
      else
        d->fixed[-place - 1] = candidate[i];
    }
  }
}

static void push_told(lua_State *L, struct design *d, int settled) {
  const struct fit_result *r = &d->result;
  const int n = d->f.n, bad = d->f.refused != 0 ? d->f.refused : settled < 0 ? -1 : 0;
  lua_createtable(L, 0, 14);
  fields_set_number(L, "refused", bad);
  fields_set_number(L, "unknowns", n);
  fields_set_number(L, "step", d->f.h);
  fields_set_flag(L, "settled", settled > 0);
  if (bad)
    return;
  criteria(d);
  fields_set_number(L, "rank", r->rank);
  fields_set_number(L, "mean", d->mean);
  fields_set_number(L, "root", d->root);
  fields_set_number(L, "largest", d->largest);
  fields_set_list(L, "theta", r->theta, n);
  fields_set_list(L, "covariance", r->covariance, n * n);
  if (r->rank == n)
    return;
  fields_set_list(L, "singular", r->singular, n);
  fields_set_list(L, "vectors", r->vectors, n * n);
  fields_set_list(L, "scale", r->scale, n);
  fields_set_list(L, "size", r->size, n);
}

static void read_design(lua_State *L, struct design *d) {
  double list[FIT_MOST];
  fit_read(L, &d->f);
  make_log(L, d);
  d->step = d->f.h;
  d->places = fields_some(L, 2, "places", list, FIT_MOST);
  for (int i = 0; i < d->places; i++)
    d->place[i] = (int)list[i];
  d->count = fields_some(L, 2, "of", list, FIT_MOST);
  for (int i = 0; i < d->count; i++)
    d->of[i] = (int)list[i] - 1;
  fields_some(L, 2, "size", d->size, FIT_MOST);
  for (int i = 0; i < 64; i++)
    d->fixed[i] = (double)NAN;
  d->f.fixed = d->fixed;
  d->sums.whole = fit_room(L, sizeof *d->sums.whole);
  fit_begin(L, &d->f, d->start);
}

int host_design(lua_State *L) {
  const char *path = luaL_checkstring(L, 1);
  luaL_checktype(L, 2, LUA_TTABLE);
  void *library;
  struct design *d = fit_room(L, sizeof *d);
  d->f.code = fit_load(L, path, &library);
  if (d->f.code == NULL)
    return 2;
  read_design(L, d);
  lua_getfield(L, 2, "candidates");
  const int all = lua_gettop(L);
  const lua_Integer count = (lua_Integer)fields_number(L, 2, "count");
  lua_createtable(L, (int)count, 0);
  for (lua_Integer c = 0; c < count; c++) {
    double candidate[FIT_MOST], theta[FIT_MOST];
    for (int i = 0; i < d->places; i++) {
      lua_rawgeti(L, all, c * d->places + i + 1);
      candidate[i] = lua_tonumber(L, -1);
      lua_pop(L, 1);
    }
    take(d, candidate, theta);
    const int settled = settle(d, theta);
    interrupt_check(L);
    push_told(L, d, settled);
    lua_rawseti(L, -2, c + 1);
  }
  dlclose(library);
  return 1;
}
