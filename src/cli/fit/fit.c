/* fit.c - `polhode fit` for Lua: the compiled scene, the logs and what is free, to estimates.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * fit(path, {free = {place among the parameters, from 1}, initial = bool, logs = {of csv()},
 *     channels = of each log {{value =, column =, sigma =,
 *     attitude = bool, state = which one it is as it stands, or nil, wrapped = bool, low, high =
 * limits of the sensor or NaN}}, knots = {t}, loss =
 * "squares", "huber" or "cauchy", corner = k, sizes = of the free parameters, step = h, known = are
 * the sigmas known?, states = {initial values, if initial}, parameters = {all, SI units}, inputs =
 * nil or of each log those over time (host/course.h), starts, low, high = ranges of the free
 * parameters, linear = nil or of each log {column, scale, bias, initial, own = lists of 3, place,
 * constant = 6 numbers, slope = 6 rows, in one list}})
 * -> {theta, covariance, outer, singular, vectors, scale, size (lists), rank, chi2, loss, n,
 * converged, way = "scene", "lengthened", "linear", "starts" or "nodes", tried, same, iterations,
 * passes, decrement, step_error, step, refused, seconds, counts = {of each log: {of each residual:
 * {n, chi2, worst, worst_t, sums, pairs}}}} Places of values and columns count from 1, lists of
 * matrices are by rows.
 */
#define _GNU_SOURCE
#include "fit.h"
#include "host/csv.h"
#include "host/fields.h"
#include "host/host.h"

#include <dlfcn.h>
#include <gsl/gsl_cdf.h>
#include <math.h>
#include <string.h>

void *fit_room(lua_State *L, size_t size) {
  void *p = lua_newuserdatauv(L, size > 0 ? size : 1, 0);
  memset(p, 0, size > 0 ? size : 1);
  return p;
}

const struct polhode_fitted *fit_load(lua_State *L, const char *path, void **library) {
  *library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
  void *symbol = *library != NULL ? dlsym(*library, "polhode_fitted") : NULL;
  if (symbol == NULL) {
    lua_pushnil(L);
    lua_pushfstring(L, "cannot load %s: %s", path, dlerror());
    return NULL;
  }
  /* POSIX: an object's address may be a function's */
  union {
    void *object;
    const struct polhode_fitted *(*function)(void);
  } table = {symbol};
  const struct polhode_fitted *code = table.function();
  if (code->abi != POLHODE_FITTED_ABI || code->states > 64 || code->values > FIT_CHANNELS ||
      code->inputs > COURSE_INPUTS)
    luaL_error(L, "fit: what was compiled is no scene of this program");
  return code;
}

static void read_channels(lua_State *L, struct fit_problem *f, int log) {
  lua_getfield(L, 2, "channels");
  lua_rawgeti(L, -1, log + 1);
  const int list = lua_gettop(L);
  if (f->channel == NULL) {
    f->channels = (int)lua_rawlen(L, list);
    if (f->channels > FIT_CHANNELS)
      luaL_error(L, "fit: too many channels");
    f->channel = fit_room(L, (size_t)(f->channels * f->logs) * sizeof *f->channel);
  }
  for (int i = 0; i < f->channels; i++) {
    struct fit_channel *c = &f->channel[log * f->channels + i];
    lua_rawgeti(L, list, i + 1);
    const int at = lua_gettop(L);
    c->attitude = fields_flag(L, at, "attitude");
    c->value = (int)fields_number(L, at, "value") - 1;
    c->column = (int)fields_number(L, at, "column") - 1;
    c->state = (int)fields_option(L, at, "state", 0) - 1;
    fields_some(L, at, "sigma", c->sigma, 3);
    c->wrapped = fields_flag(L, at, "wrapped");
    c->low = fields_option(L, at, "low", (double)NAN);
    c->high = fields_option(L, at, "high", (double)NAN);
    lua_settop(L, at - 1);
  }
}

static void read_inputs(lua_State *L, struct fit_problem *f) {
  lua_getfield(L, 2, "inputs");
  if (lua_istable(L, -1) && f->code->inputs > 0)
    f->course = fit_room(L, (size_t)f->logs * sizeof *f->course);
  for (int i = 0; f->course != NULL && i < f->logs; i++) {
    lua_rawgeti(L, -2, i + 1);
    f->course[i] = course_at(L, -1, f->code->inputs, NULL);
    lua_pop(L, 1);
  }
}

static void read_places(lua_State *L, int at, const char *key, int out[], int n) {
  double list[FIT_MOST];
  fields_some(L, at, key, list, n);
  for (int i = 0; i < n; i++)
    out[i] = (int)list[i] - 1;
}

static void read_linear(lua_State *L, struct fit_problem *f) {
  lua_getfield(L, 2, "linear");
  const int all = lua_gettop(L), given = lua_istable(L, all);
  if (given)
    f->linear = fit_room(L, (size_t)f->logs * sizeof *f->linear);
  for (int log = 0; given && log < f->logs; log++) {
    struct fit_linear *a = &f->linear[log];
    double slope[6 * FIT_MOST];
    lua_rawgeti(L, all, log + 1);
    const int at = lua_gettop(L);
    lua_getfield(L, at, "place");
    a->count = (int)lua_rawlen(L, -1);
    read_places(L, at, "place", a->place, a->count);
    read_places(L, at, "column", a->column, 3);
    read_places(L, at, "initial", a->initial, 3);
    read_places(L, at, "own", a->own, 3);
    fields_some(L, at, "scale", a->scale, 3);
    fields_some(L, at, "bias", a->bias, 3);
    fields_some(L, at, "constant", a->constant, 6);
    fields_some(L, at, "slope", slope, 6 * FIT_MOST);
    for (int i = 0; i < 6 * a->count; i++)
      a->slope[i / a->count][i % a->count] = slope[i];
    lua_settop(L, at - 1);
  }
}

static struct fit_log log_of(const struct csv *c) {
  return (struct fit_log){.rows = c->rows,
                          .columns = c->columns,
                          .t = c->t,
                          .y = c->y,
                          .line = c->line,
                          .spacing = csv_spacing(c)};
}

void fit_read(lua_State *L, struct fit_problem *f) {
  double places[FIT_MOST], knots[1000];
  luaL_checkstack(L, 40, "fit");
  f->free = fields_some(L, 2, "free", places, FIT_MOST);
  for (int i = 0; i < f->free; i++)
    f->free_index[i] = (int)places[i] - 1;
  static const char *const losses[] = {"squares", "huber", "cauchy", NULL};
  lua_getfield(L, 2, "loss");
  f->loss = luaL_checkoption(L, -1, "squares", losses);
  lua_pop(L, 1);
  f->corner = fields_number(L, 2, "corner");
  f->h = fields_number(L, 2, "step");
  f->until = (double)INFINITY;
  f->knot_count = fields_some(L, 2, "knots", knots, 1000);
  f->knots = fit_room(L, sizeof knots);
  memcpy(f->knots, knots, sizeof knots);
  f->p = fit_room(L, (size_t)(f->code->params + 1) * sizeof *f->p);
  fields_some(L, 2, "parameters", f->p, f->code->params);
  f->model = fit_room(L, f->code->model_size);
  f->k0 = fit_room(L, (size_t)(f->code->constants * f->code->lanes + 1) * sizeof *f->k0);
  lua_getfield(L, 2, "logs");
  const int list = lua_gettop(L);
  f->logs = (int)lua_rawlen(L, list);
  f->log = fit_room(L, (size_t)f->logs * sizeof *f->log);
  for (int i = 0; i < f->logs; i++) {
    lua_rawgeti(L, list, i + 1);
    if (lua_isuserdata(L, -1)) /* design.c makes its own */
      f->log[i] = log_of(csv_at(L, -1));
    read_channels(L, f, i);
  }
  read_inputs(L, f);
  read_linear(L, f);
  fields_some(L, 2, "sizes", f->size, FIT_MOST);
  f->starts = (int)fields_option(L, 2, "starts", 0);
  fields_some(L, 2, "low", f->low, FIT_MOST);
  fields_some(L, 2, "high", f->high, FIT_MOST);
  f->pieces = (int)fields_option(L, 2, "pieces", 0);
  f->near = fields_flag(L, 2, "near");
  f->active = f->logs;
  if (f->pieces > 1)
    fit_pieces_cut(f);
  f->reference = fit_room(L, (size_t)(4 * f->logs) * sizeof *f->reference);
  f->former = fit_room(L, (size_t)(4 * f->logs) * sizeof *f->former);
  if (fields_flag(L, 2, "initial"))
    f->own = f->code->states - (f->code->attitude >= 0);
  f->n = f->free + f->logs * f->own;
  if (f->n > FIT_MOST)
    luaL_error(L, "fit: more than %d unknowns", FIT_MOST);
}

/* Where the search begins: the parameters' values, and of each log the scene's initial state. */
void fit_begin(lua_State *L, struct fit_problem *f, double theta[]) {
  double x[FIT_MOST] = {0};
  for (int i = 0; i < f->free; i++)
    theta[i] = f->p[f->free_index[i]];
  if (f->own == 0)
    return;
  if (fields_some(L, 2, "theta", theta, FIT_MOST) == f->n) {
    fields_some(L, 2, "reference", f->reference, 4 * f->logs);
    return;
  }
  fields_some(L, 2, "states", x, FIT_MOST);
  for (int log = 0; log < f->logs; log++) {
    int at = f->free + log * f->own;
    for (int i = 0; i < f->code->states; i++) {
      if (i == f->code->attitude) {
        fit_refer(f, log, x + i);
        at += 3;
        i += 3;
      } else {
        theta[at++] = x[i];
      }
    }
  }
}

static void push_counts(lua_State *L, const struct fit_problem *f,
                        const struct fit_count counts[]) {
  const int n = fit_residuals(f);
  lua_createtable(L, f->logs, 0);
  for (int i = 0; i < f->logs; i++) {
    lua_createtable(L, n, 0);
    for (int k = 0; k < n; k++) {
      const struct fit_count *c = &counts[i * n + k];
      double pairs[FIT_LAGS];
      for (int j = 0; j < FIT_LAGS; j++)
        pairs[j] = (double)c->pairs[j];
      lua_createtable(L, 0, 6);
      fields_set_number(L, "n", (double)c->n);
      fields_set_number(L, "chi2", c->chi2);
      fields_set_number(L, "worst", c->worst);
      fields_set_number(L, "worst_t", c->worst_t);
      fields_set_list(L, "sums", c->sum, FIT_LAGS);
      fields_set_list(L, "pairs", pairs, FIT_LAGS);
      lua_rawseti(L, -2, k + 1);
    }
    lua_rawseti(L, -2, i + 1);
  }
  lua_setfield(L, -2, "counts");
}

static void push_outliers(lua_State *L, const struct fit_problem *f, const struct fit_outliers *a) {
  lua_createtable(L, a->kept, 0);
  for (int i = 0; i < a->kept; i++) {
    const struct fit_outlier *o = &a->worst[i];
    lua_createtable(L, 0, 5);
    fields_set_number(L, "log", o->log + 1);
    fields_set_number(L, "residual", o->residual + 1);
    fields_set_number(L, "line", f->log[o->log].line[o->row]);
    fields_set_number(L, "t", f->log[o->log].t[o->row]);
    fields_set_number(L, "z", o->z);
    lua_rawseti(L, -2, i + 1);
  }
  lua_setfield(L, -2, "outliers");
  fields_set_number(L, "outlier_count", (double)a->count);
  fields_set_number(L, "outlier_limit", a->limit);
}

static void push_traces(lua_State *L, const struct fit_problem *f, const struct fit_trace a[]) {
  const int n = fit_residuals(f);
  lua_createtable(L, f->logs, 0);
  for (int i = 0; a != NULL && i < f->logs; i++) {
    lua_createtable(L, n, 0);
    for (int k = 0; k < n; k++) {
      const struct fit_trace *t = &a[i * n + k];
      const int plain = t->n > 0 && !isnan(t->y[0]);
      lua_createtable(L, 0, 4);
      fields_set_list(L, "t", t->t, t->n);
      fields_set_list(L, "z", t->z, t->n);
      fields_set_list(L, "y", t->y, plain ? t->n : 0);
      fields_set_list(L, "model", t->model, plain ? t->n : 0);
      lua_rawseti(L, -2, k + 1);
    }
    lua_rawseti(L, -2, i + 1);
  }
  lua_setfield(L, -2, "traces");
}

/* H^-1 B H^-1 with H^-1 = covariance and B = R'R of the outer triangle. */
static void sandwich(const struct fit_triangle *b, double C[], double work[]) {
  const int n = b->n;
  for (int i = 0; i < n; i++)
    for (int k = 0; k < n; k++) {
      work[i * n + k] = 0;
      for (int j = 0; j < n; j++)
        work[i * n + k] += j >= i ? triangle_at(b, i, j) * C[j * n + k] : 0;
    }
  for (int i = 0; i < n; i++)
    for (int k = 0; k < n; k++) {
      C[i * n + k] = 0;
      for (int j = 0; j < n; j++)
        C[i * n + k] += work[j * n + i] * work[j * n + k];
    }
}

static void push_result(lua_State *L, struct fit_problem *f, struct fit_result *r,
                        const struct fit_sums *s, double work[]) {
  static const char *const ways[] = {"scene", "lengthened", "linear", "starts", "nodes"};
  const int n = f->n;
  if (f->loss != FIT_SQUARES)
    sandwich(s->outer, r->covariance, work);
  lua_createtable(L, 0, 24);
  fields_set_list(L, "theta", r->theta, n);
  fields_set_list(L, "reference", f->reference, 4 * f->logs);
  fields_set_list(L, "covariance", r->covariance, n * n);
  fields_set_list(L, "singular", r->singular, n);
  fields_set_list(L, "vectors", r->vectors, n * n);
  fields_set_list(L, "scale", r->scale, n);
  fields_set_list(L, "size", r->size, n);
  fields_set_number(L, "rank", r->rank);
  fields_set_number(L, "chi2", r->chi2);
  fields_set_number(L, "loss", r->loss);
  fields_set_number(L, "n", (double)r->n);
  fields_set_number(L, "iterations", r->iterations);
  fields_set_number(L, "passes", (double)f->passes);
  fields_set_number(L, "refusals", (double)f->refusals);
  fields_set_number(L, "decrement", r->decrement);
  fields_set_number(L, "step_error", r->step_shift);
  fields_set_number(L, "step", f->h);
  fields_set_number(L, "refused", f->refused);
  fields_set_number(L, "unknowns", n);
  fields_set_flag(L, "converged", r->converged);
  lua_pushstring(L, ways[r->way]);
  lua_setfield(L, -2, "way");
  fields_set_number(L, "tried", r->tried);
  fields_set_number(L, "same", r->same);
  push_counts(L, f, s->counts);
  push_outliers(L, f, s->outliers);
  fields_set_list(L, "growth", s->growth, f->logs);
  push_traces(L, f, s->traces);
}

int host_fit(lua_State *L) {
  const char *path = luaL_checkstring(L, 1);
  luaL_checktype(L, 2, LUA_TTABLE);
  void *library;
  struct fit_problem *f = fit_room(L, sizeof *f);
  f->code = fit_load(L, path, &library);
  if (f->code == NULL)
    return 2;
  fit_read(L, f);
  double *theta = fit_room(L, FIT_MOST * sizeof *theta);
  /* one fit at a time; as Lua's memory, numbers as many as these would start its collector */
  static struct fit_triangle triangle[4];
  static struct fit_result result;
  static double work[FIT_MOST * FIT_MOST];
  struct fit_result *r = &result;
  struct fit_sums s = {.whole = triangle, triangle + 1, triangle + 2, triangle + 3};
  s.outliers = fit_room(L, sizeof *s.outliers);
  if (fields_flag(L, 2, "traces"))
    s.traces = fit_room(L, (size_t)(f->logs * fit_residuals(f)) * sizeof *s.traces);
  s.growth = fit_room(L, (size_t)f->logs * sizeof *s.growth);
  s.counts = fit_room(L, (size_t)(f->logs * fit_residuals(f)) * sizeof *s.counts);
  fit_begin(L, f, theta);
  fit_solve(f, theta, fields_flag(L, 2, "known"), r, &s);
  interrupt_check(L);
  push_result(L, f, r, &s, work);
  dlclose(library);
  return 1;
}

int host_tail(lua_State *L) {
  const double chi2 = luaL_checknumber(L, 1), dof = luaL_checknumber(L, 2);
  lua_pushnumber(L, dof > 0 && chi2 >= 0 ? gsl_cdf_chisq_Q(chi2, dof) : 1);
  return 1;
}
