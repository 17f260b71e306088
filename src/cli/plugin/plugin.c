/* plugin.c - the emitted code of a scene, compiled and loaded, as an object of Lua.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The shared object's table (templates/host/plugin.h) becomes methods; its sizes are checked once
 * and every list from Lua against them, so that emitted code never reads past an array of ours. The
 * object owns the model, the orbit and the loaded code, and gives all three back when it is
 * collected.
 */
#include "bench/bench.h"

#include <dlfcn.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static int absent(lua_State *L, const char *what) {
  lua_pushnil(L);
  lua_pushfstring(L, "the emitted code has no %s", what);
  return 2;
}

/* ---- methods ---- */

/* {{name=, order=, adaptive=}, ...}, the scene's own first; order 0: unknown */
static void push_steppers(lua_State *L, const struct polhode_stepper *s) {
  lua_newtable(L);
  for (int i = 1; s != NULL && s->name != NULL; i++, s++) {
    lua_createtable(L, 0, 3);
    lua_pushstring(L, s->name);
    lua_setfield(L, -2, "name");
    fields_set_count(L, "order", s->order);
    fields_set_flag(L, "adaptive", s->run != NULL);
    lua_rawseti(L, -2, i);
  }
}

/* info() -> {name=, real=, epsilon=, nx=, nu=, np=, params={defaults}, steppers={...},
   has={rhs=true,
   ...}} */
static int info(lua_State *L) {
  const struct polhode_plugin *c = plugin_self(L)->code;
  const struct {
    const char *name;
    int there;
  } functions[] = {
      {"inertia", c->inertia != NULL},   {"principal", c->principal != NULL},
      {"rhs", c->rhs != NULL},           {"step", c->steppers != NULL},
      {"jacobian", c->jacobian != NULL}, {"energy", c->energy != NULL},
      {"momentum", c->momentum != NULL}, {"solve", c->solve != NULL && c->at != NULL},
      {"peers", c->peer_rhs != NULL},
  };
  double p[MAX_PARAMS] = {0};
  lua_newtable(L);
  push_steppers(L, c->steppers);
  lua_setfield(L, -2, "steppers");
  lua_pushstring(L, c->name);
  lua_setfield(L, -2, "name");
  lua_pushstring(L, c->real);
  lua_setfield(L, -2, "real");
  fields_set_number(L, "epsilon", c->epsilon);
  fields_set_count(L, "nx", c->nx);
  fields_set_count(L, "nu", c->nu);
  fields_set_count(L, "np", c->np);
  if (c->params != NULL)
    c->params(p);
  fields_set_list(L, "params", p, c->np);
  lua_newtable(L);
  for (size_t i = 0; i < sizeof functions / sizeof functions[0]; i++) {
    lua_pushboolean(L, functions[i].there);
    lua_setfield(L, -2, functions[i].name);
  }
  lua_setfield(L, -2, "has");
  return 1;
}

/* init([params]) -> status, 0 when the parameters are good */
static int init(lua_State *L) {
  struct plugin *p = plugin_self(L);
  double values[MAX_PARAMS];
  const int own = lua_isnoneornil(L, 2);
  if (!own)
    fields_list(L, 2, p->code->np, values);
  const int status = p->code->init(p->model, own ? NULL : values);
  p->ready = status == 0;
  p->solved = 0;
  lua_pushinteger(L, status);
  return 1;
}

/* inertia() -> {6} */
static int inertia(lua_State *L) {
  const struct plugin *p = plugin_ready(L);
  double I[6];
  if (p->code->inertia == NULL)
    return absent(L, "inertia");
  p->code->inertia(p->model, I);
  fields_push(L, 6, I);
  return 1;
}

/* principal() -> {3 moments}, {9 components of axes} */
static int principal(lua_State *L) {
  const struct plugin *p = plugin_ready(L);
  double moments[3], axes[9];
  if (p->code->principal == NULL)
    return absent(L, "principal axes");
  if (p->code->principal(p->model, moments, axes))
    return luaL_error(L, "plugin: a principal moment is beyond the range of the type");
  fields_push(L, 3, moments);
  fields_push(L, 9, axes);
  return 2;
}

/* rhs(t, x[, u]) -> dx */
static int rhs(lua_State *L) {
  const struct plugin *p = plugin_ready(L);
  double x[MAX_STATES], u[MAX_STATES], dx[MAX_STATES];
  if (p->code->rhs == NULL)
    return absent(L, "equations of motion");
  fields_list(L, 3, p->code->nx, x);
  fields_optional(L, 4, p->code->nu, u);
  p->code->rhs(p->model, luaL_checknumber(L, 2), x, u, dx);
  fields_push(L, p->code->nx, dx);
  return 1;
}

/* jacobian(t, x[, u]) -> {nx * nx}, row i: derivatives of dx[i] */
static int jacobian(lua_State *L) {
  const struct plugin *p = plugin_ready(L);
  double x[MAX_STATES], u[MAX_STATES], J[MAX_STATES * MAX_STATES];
  if (p->code->jacobian == NULL)
    return absent(L, "Jacobian");
  fields_list(L, 3, p->code->nx, x);
  fields_optional(L, 4, p->code->nu, u);
  p->code->jacobian(p->model, luaL_checknumber(L, 2), x, u, J);
  fields_push(L, p->code->nx * p->code->nx, J);
  return 1;
}

/* step(t, x, u, h[, method]) -> x at t + h */
static int step(lua_State *L) {
  const struct plugin *p = plugin_ready(L);
  double x[MAX_STATES], u[MAX_STATES];
  fields_list(L, 3, p->code->nx, x);
  fields_optional(L, 4, p->code->nu, u);
  plugin_stepper(L, p, 6)->step(p->model, luaL_checknumber(L, 2), x, u, luaL_checknumber(L, 5));
  fields_push(L, p->code->nx, x);
  return 1;
}

static int finite(int n, const double x[]) {
  for (int i = 0; i < n; i++)
    if (!isfinite(x[i]))
      return 0;
  return 1;
}

/* From *t to `end`, from break to break of the inputs' course, in equal steps no longer than h;
 * both directions; how many. A step holds its inputs: on a line they are those of its middle.
 * bad: NULL, or the state is looked at after every step, and the first that is not finite ends
 * there. */
static double advance(const struct plugin *p, const struct polhode_stepper *s, double *t,
                      double end, double h, double x[], const struct course *c, double *bad) {
  struct course_segment in;
  double u[COURSE_INPUTS], all = 0;
  do {
    const double start = *t, next = course_next(c, start, end), span = next - start;
    const double n = plugin_steps(span, h);
    course_segment(c, start, next, &in);
    for (double i = 0; i < n && !interrupt_pending(); i++) {
      course_value(&in, c->n, start + span * ((i + 0.5) / n), u);
      s->step(p->model, start + span * (i / n), x, u, span / n);
      if (bad != NULL && !finite(p->code->nx, x)) {
        *bad = i + 1 < n ? start + span * ((i + 1) / n) : next;
        return all + i + 1;
      }
    }
    *t = next;
    all += n;
  } while (*t != end);
  return all;
}

/* From *t to `end` in steps of the tolerance's choice; how many, -1 if the state became infinite or
 * the steps vanish. */
static double adapt(const struct plugin *p, const struct polhode_stepper *s, double *t, double end,
                    double tolerance, int most, double x[], const struct course *c) {
  struct course_segment in;
  double all = 0;
  do {
    const double next = course_next(c, *t, end);
    course_segment(c, *t, next, &in);
    const int steps = s->run(p->model, *t, x, in.base, next, tolerance, most);
    *t = next;
    all = steps < 0 ? -1 : all + steps;
  } while (all >= 0 && *t != end);
  return all;
}

/* integrate(x0, course, h, times[, t0, method]) -> {{t, x...}, ...}, number of steps; by steps of h
 * or a little less so that times are hit; h = {tolerance, most}: by steps that the method chooses,
 * at most so many (1e8 if not given) between two times; if it cannot, nil and the last of the times
 * that it reached. Where a state is not finite, there is a
 * third result, the end of the first step that led to one. */
static int integrate(lua_State *L) {
  const struct plugin *p = plugin_ready(L);
  const int nx = p->code->nx;
  double row[1 + MAX_STATES], before[1 + MAX_STATES], *x = row + 1, h, bad = NAN;
  struct course constant;
  const struct polhode_stepper *s = plugin_stepper(L, p, 7);
  fields_list(L, 2, nx, x);
  const struct course *course = course_at(L, 3, p->code->nu, &constant);
  const int adaptive = lua_istable(L, 4);
  int most = 100000000;
  if (adaptive) {
    if (lua_rawgeti(L, 4, 2) != LUA_TNIL)
      most = (int)luaL_checkinteger(L, -1);
    lua_pop(L, 1);
    lua_rawgeti(L, 4, 1);
  } else {
    lua_pushvalue(L, 4);
  }
  h = luaL_checknumber(L, -1);
  lua_pop(L, 1);
  luaL_argcheck(L, h > 0, 4, "step or tolerance must be positive");
  luaL_argcheck(L, !adaptive || s->run != NULL, 4, "this stepper has a fixed step");
  luaL_argcheck(L, !adaptive || !course_linear(course), 3,
                "a step of its own choice holds its inputs");
  luaL_checktype(L, 5, LUA_TTABLE);
  row[0] = luaL_optnumber(L, 6, 0);
  const int n = (int)lua_rawlen(L, 5);
  lua_createtable(L, n, 0);
  double all = 0;
  for (int i = 1; i <= n; i++) {
    lua_rawgeti(L, 5, i);
    const double end = luaL_checknumber(L, -1);
    memcpy(before, row, sizeof row);
    const double steps = adaptive ? adapt(p, s, &row[0], end, h, most, x, course)
                                  : advance(p, s, &row[0], end, h, x, course, NULL);
    lua_pop(L, 1);
    interrupt_check(L);
    all += steps;
    if (steps < 0) {
      lua_pushnil(L);
      lua_pushnumber(L, before[0]);
      return 2;
    }
    if (isnan(bad) && !finite(nx, x)) {
      bad = end;
      if (!adaptive)
        advance(p, s, &before[0], end, h, before + 1, course, &bad);
    }
    fields_push(L, 1 + nx, row);
    lua_rawseti(L, -2, i);
  }
  lua_pushnumber(L, all);
  if (isnan(bad))
    return 2;
  lua_pushnumber(L, bad);
  return 3;
}

/* energy(x) -> E */
static int energy(lua_State *L) {
  const struct plugin *p = plugin_ready(L);
  double x[MAX_STATES];
  if (p->code->energy == NULL)
    return absent(L, "energy");
  fields_list(L, 2, p->code->nx, x);
  lua_pushnumber(L, p->code->energy(p->model, x));
  return 1;
}

/* integral(t, x) -> Jacobi's */
static int integral(lua_State *L) {
  const struct plugin *p = plugin_ready(L);
  double x[MAX_STATES];
  if (p->code->integral == NULL)
    return absent(L, "Jacobi's integral");
  fields_list(L, 3, p->code->nx, x);
  lua_pushnumber(L, p->code->integral(p->model, luaL_checknumber(L, 2), x));
  return 1;
}

/* momentum(x) -> {3} */
static int momentum(lua_State *L) {
  const struct plugin *p = plugin_ready(L);
  double x[MAX_STATES], out[3];
  if (p->code->momentum == NULL)
    return absent(L, "angular momentum");
  fields_list(L, 2, p->code->nx, x);
  p->code->momentum(p->model, x, out);
  fields_push(L, 3, out);
  return 1;
}

/* solve(x0) -> status, 0 when there is a closed form through x0 */
static int solve(lua_State *L) {
  struct plugin *p = plugin_self(L);
  double x[MAX_STATES];
  plugin_ready(L);
  if (p->code->solve == NULL)
    return absent(L, "closed form");
  fields_list(L, 2, p->code->nx, x);
  const int status = p->code->solve(p->orbit, p->model, x);
  p->solved = status == 0;
  lua_pushinteger(L, status);
  return 1;
}

/* at(t) -> x, after solve */
static int at(lua_State *L) {
  const struct plugin *p = plugin_ready(L);
  double x[MAX_STATES];
  if (!p->solved || p->code->at == NULL)
    return luaL_error(L, "plugin: solve first");
  p->code->at(p->orbit, luaL_checknumber(L, 2), x);
  fields_push(L, p->code->nx, x);
  return 1;
}

/* ---- loading ---- */

static int collect(lua_State *L) {
  struct plugin *p = plugin_self(L);
  free(p->model);
  free(p->orbit);
  if (p->library != NULL)
    dlclose(p->library);
  memset(p, 0, sizeof *p);
  return 0;
}

/* Why the table cannot be used, or NULL. */
static const char *refuse(const struct polhode_plugin *c) {
  if (c == NULL || c->abi != POLHODE_PLUGIN_ABI)
    return "it was made for another version of polhode";
  if (c->nx < 1 || c->nx > MAX_STATES || c->nu < 0 || c->nu > MAX_STATES || c->np < 0 ||
      c->np > MAX_PARAMS || c->init == NULL || c->name == NULL || c->real == NULL)
    return "its table is not filled in properly";
  for (const struct polhode_stepper *s = c->steppers; s != NULL && s->name != NULL; s++)
    if (s->step == NULL || s->march == NULL)
      return "one of its steppers is not whole";
  return NULL;
}

static const char *load(struct plugin *p, const char *path) {
  typedef const struct polhode_plugin *entry(void);
  p->library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
  if (p->library == NULL)
    return dlerror();
  entry *get;
  /* POSIX's way around ISO C, which has no cast from void * to a function */
  *(void **)&get = dlsym(p->library, "polhode_plugin");
  if (get == NULL)
    return "it has no function polhode_plugin";
  p->code = get();
  const char *why = refuse(p->code);
  if (why != NULL)
    return why;
  p->model = calloc(1, p->code->model_size + 1);
  p->orbit = calloc(1, p->code->orbit_size + 1);
  return p->model == NULL || p->orbit == NULL ? "not enough memory" : NULL;
}

static const luaL_Reg methods[] = {
    {"info", info},
    {"init", init},
    {"inertia", inertia},
    {"principal", principal},
    {"rhs", rhs},
    {"jacobian", jacobian},
    {"step", step},
    {"integrate", integrate},
    {"energy", energy},
    {"momentum", momentum},
    {"integral", integral},
    {"solve", solve},
    {"at", at},
    {"march", plugin_march},
    {"time", plugin_time},
    {"time_closed", plugin_time_closed},
    {"peer", plugin_peer},
    {"time_peer", plugin_time_peer},
    {NULL, NULL},
};

/* plugin(path) -> object with the methods above | nil, message. The path needs a slash to be a
 * path. */
int host_plugin(lua_State *L) {
  const char *path = luaL_checkstring(L, 1);
  struct plugin *p = lua_newuserdatauv(L, sizeof *p, 0);
  memset(p, 0, sizeof *p);
  if (luaL_newmetatable(L, PLUGIN_TYPE)) {
    lua_pushcfunction(L, collect);
    lua_setfield(L, -2, "__gc");
    luaL_newlib(L, methods);
    lua_setfield(L, -2, "__index");
  }
  lua_setmetatable(L, -2);
  const char *why = load(p, path);
  if (why == NULL)
    return 1;
  lua_pushnil(L);
  lua_pushfstring(L, "cannot load %s: %s", path, why);
  return 2;
}
