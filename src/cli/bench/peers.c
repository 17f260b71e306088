/* peers.c - other integrators on the emitted right-hand side: GSL's, and the one that a user
 * writes himself.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * All of them call the same function of the same plugin, in double, on their own arrays.  Settings
 * are those of a user who has read the manual: one number as absolute and relative tolerance, a
 * first step that is small against what the motion needs, no limit on the number of steps but
 * patience.  What they allocate is not timed; to begin anew from the initial state is.
 */
#include "bench.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Between two looks at the clock. */
#define AT_A_TIME 20000

/* ---- RK4 by hand: templates/host/peers.c ---- */

static void *hand_open(const struct peer *self, const struct peer_problem *p) {
  (void)self;
  return (void *)p; /* which outlives the integrator */
}

static void hand_close(void *it) {
  (void)it;
}

static int hand_start(void *it, double t, const double x[]) {
  (void)it;
  (void)t;
  (void)x;
  return 0;
}

static int hand_march(void *it, double t, double x[], double h, long n) {
  const struct peer_problem *p = it;
  p->code->hand_rk4(p->place, t, x, h, n);
  return 0;
}

/* ---- GSL ---- */

/* With a tolerance GSL's driver, with a fixed step the bare stepping function, whose rates at the
   end of a step begin the next: the driver would weigh errors that nobody asks for. */
struct gsl {
  gsl_odeiv2_system system; /* the others refer to it */
  gsl_odeiv2_driver *driver;
  gsl_odeiv2_step *step;
  double longest;              /* first step of the driver */
  double rates[2][MAX_STATES]; /* before and after a step */
  double uncertainty[MAX_STATES];
};

static void gsl_close(void *it) {
  struct gsl *g = it;
  if (g->driver != NULL)
    gsl_odeiv2_driver_free(g->driver);
  if (g->step != NULL)
    gsl_odeiv2_step_free(g->step);
  free(g);
}

static void *gsl_open(const struct peer *self, const struct peer_problem *p) {
  const gsl_odeiv2_step_type *type = *(const gsl_odeiv2_step_type *const *)self->kind;
  struct gsl *g = calloc(1, sizeof *g);
  if (g == NULL)
    return NULL;
  g->system.function = p->code->peer_rhs;
  g->system.dimension = (size_t)p->code->nx;
  g->system.params = p->place;
  g->longest = 1e-6 * p->span;
  if (self->march != NULL)
    g->step = gsl_odeiv2_step_alloc(type, g->system.dimension);
  else
    g->driver = gsl_odeiv2_driver_alloc_y_new(&g->system, type, g->longest, p->setting, p->setting);
  if (g->step != NULL || g->driver != NULL)
    return g;
  gsl_close(g);
  return NULL;
}

/* The time in which the state changes by a thousandth of itself, as Hairer, Norsett, Wanner I, II.4
   begin; GSL takes whatever it is given, even a step that ends in infinity. */
static double first_step(struct gsl *g, double t, const double x[]) {
  double size = 0, rate = 0;
  g->system.function(t, x, g->rates[0], g->system.params);
  for (size_t i = 0; i < g->system.dimension; i++) {
    size = fmax(size, fabs(x[i]));
    rate = fmax(rate, fabs(g->rates[0][i]));
  }
  const double h = 1e-3 * size / rate;
  return h > 0 && h < g->longest ? h : g->longest;
}

static int gsl_start(void *it, double t, const double x[]) {
  struct gsl *g = it;
  return g->step != NULL ? gsl_odeiv2_step_reset(g->step)
                         : gsl_odeiv2_driver_reset_hstart(g->driver, first_step(g, t, x));
}

static int gsl_march(void *it, double t, double x[], double h, long n) {
  struct gsl *g = it;
  const int takes = g->step->type->can_use_dydt_in && g->step->type->gives_exact_dydt_out;
  int status = g->system.function(t, x, g->rates[0], g->system.params);
  for (long i = 0; i < n && status == GSL_SUCCESS; i++)
    status = gsl_odeiv2_step_apply(g->step, t + (double)i * h, h, x, g->uncertainty,
                                   takes ? g->rates[i % 2] : NULL, g->rates[1 - i % 2], &g->system);
  return status;
}

static int gsl_go(void *it, double *t, double x[], double t1, long most) {
  const struct gsl *g = it;
  gsl_odeiv2_driver_set_nmax(g->driver, (unsigned long)most);
  const int status = gsl_odeiv2_driver_apply(g->driver, t, t1, x);
  return status == GSL_SUCCESS ? PEER_DONE : status == GSL_EMAXITER ? PEER_MORE : PEER_FAILED;
}

static long gsl_steps(void *it) {
  const struct gsl *g = it;
  return (long)g->driver->e->count;
}

/* ---- the list ---- */

#define HAND(NAME)                                                                                 \
  { NAME, NULL, hand_open, hand_close, hand_start, hand_march, NULL, NULL }
#define GSL_FIXED(NAME, TYPE)                                                                      \
  { NAME, &gsl_odeiv2_step_##TYPE, gsl_open, gsl_close, gsl_start, gsl_march, NULL, NULL }
#define GSL(NAME, TYPE)                                                                            \
  { NAME, &gsl_odeiv2_step_##TYPE, gsl_open, gsl_close, gsl_start, NULL, gsl_go, gsl_steps }

static const struct peer own[] = {
    HAND("hand RK4"),
    GSL_FIXED("GSL rk4", rk4),
    GSL_FIXED("GSL rk8pd fixed", rk8pd),
    GSL("GSL rkf45", rkf45),
    GSL("GSL rk8pd", rk8pd),
    GSL("GSL msadams", msadams),
    {NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL},
};

static const struct peer *const lists[] = {own, bench_sundials};
enum { LISTS = sizeof lists / sizeof lists[0] };

/* peers() -> {{name =, setting = "step" or "tolerance"}, ...} */
int host_peers(lua_State *L) {
  int count = 0;
  lua_newtable(L);
  for (int i = 0; i < LISTS; i++)
    for (const struct peer *p = lists[i]; p->name != NULL; p++) {
      lua_createtable(L, 0, 2);
      lua_pushstring(L, p->name);
      lua_setfield(L, -2, "name");
      lua_pushstring(L, p->march != NULL ? "step" : "tolerance");
      lua_setfield(L, -2, "setting");
      lua_rawseti(L, -2, ++count);
    }
  return 1;
}

static const struct peer *find(lua_State *L, const char *name) {
  for (int i = 0; i < LISTS; i++)
    for (const struct peer *p = lists[i]; p->name != NULL; p++)
      if (strcmp(p->name, name) == 0)
        return p;
  luaL_error(L, "there is no peer %s", name);
  return NULL;
}

/* ---- running ---- */

struct race {
  const struct peer *peer;
  struct peer_problem problem;
  struct polhode_place place;
  struct bench_request r;
  void *it;
  gsl_error_handler_t *handler; /* that GSL had */
  double x[MAX_STATES], h;
  long steps;
};

enum { FINE, NO_MEMORY, GIVES_UP, TOO_LONG };

static const char *const phrase[] = {"", "not enough memory", "the integrator gives up",
                                     "not done within the limit"};

/* Between open and close nothing of Lua is called, so that nothing is left behind. */
static int open_race(struct race *r) {
  r->handler = gsl_set_error_handler_off();
  r->it = r->peer->open(r->peer, &r->problem);
  return r->it == NULL ? NO_MEMORY : FINE;
}

static void close_race(struct race *r) {
  if (r->it != NULL)
    r->peer->close(r->it);
  gsl_set_error_handler(r->handler);
}

/* From t0 to t1 = t0 + span before the clock says `end`. */
static int cover(struct race *r, double t0, double t1, double end) {
  const double n = r->peer->march != NULL ? plugin_steps(t1 - t0, r->problem.setting) : 0;
  double t = t0;
  int status = PEER_MORE;
  for (double i = 0; i < n; i += AT_A_TIME) {
    if (interrupt_pending() || bench_now() > end)
      return TOO_LONG;
    const double some = fmin(AT_A_TIME, n - i);
    if (r->peer->march(r->it, t0 + (t1 - t0) * (i / n), r->x, (t1 - t0) / n, (long)some) != 0)
      return GIVES_UP;
  }
  while (r->peer->march == NULL && status == PEER_MORE) {
    if (interrupt_pending() || bench_now() > end)
      return TOO_LONG;
    status = r->peer->go(r->it, &t, r->x, t1, AT_A_TIME);
  }
  return status == PEER_FAILED ? GIVES_UP : FINE;
}

static int fail(lua_State *L, const char *why) {
  interrupt_check(L);
  lua_pushnil(L);
  lua_pushstring(L, why);
  return 2;
}

/* What both functions below need; a plugin without peers: 0. */
static int prepare(const struct plugin *p, struct race *r) {
  r->place.m = p->model;
  r->place.u = r->r.u;
  r->problem.code = p->code;
  r->problem.place = &r->place;
  r->problem.span = r->r.to;
  return p->code->peer_rhs != NULL && p->code->hand_rk4 != NULL;
}

static const char *const none = "the plugin was made without peers (or is not in double)";

/* peer(name, setting, x0, times[, u[, limit = 60 s]]) -> {{t, x...}, ...} | nil, message; from t =
   0 to times that ascend, each met */
int plugin_peer(lua_State *L) {
  const struct plugin *p = plugin_ready(L);
  const int nx = p->code->nx;
  struct race r = {.peer = find(L, luaL_checkstring(L, 2))};
  r.problem.setting = luaL_checknumber(L, 3);
  luaL_argcheck(L, r.problem.setting > 0 && r.problem.setting < HUGE_VAL, 3,
                "step or tolerance must be positive");
  fields_list(L, 4, nx, r.x);
  luaL_checktype(L, 5, LUA_TTABLE);
  fields_optional(L, 6, p->code->nu, r.r.u);
  const double end = bench_now() + luaL_optnumber(L, 7, 60);
  const int n = (int)lua_rawlen(L, 5);
  /* times, then states */
  double *times = lua_newuserdatauv(L, ((size_t)n + 1) * (size_t)(nx + 1) * sizeof *times, 0);
  double *row = times + n, t = 0;
  fields_list(L, 5, n, times);
  for (int i = 0; i < n; i++)
    if (!(times[i] >= (i > 0 ? times[i - 1] : 0) && times[i] < HUGE_VAL))
      return luaL_argerror(L, 5, "times must ascend from 0");
  r.r.to = n > 0 && times[n - 1] > 0 ? times[n - 1] : 1;
  if (!prepare(p, &r))
    return fail(L, none);
  int status = open_race(&r);
  if (status == FINE && r.peer->start(r.it, 0, r.x) != 0)
    status = GIVES_UP;
  for (int i = 0; i < n && status == FINE; i++, row += nx) {
    if (times[i] > t)
      status = cover(&r, t, times[i], end);
    t = times[i];
    memcpy(row, r.x, (size_t)nx * sizeof *row);
  }
  close_race(&r);
  if (status != FINE)
    return fail(L, phrase[status]);
  lua_createtable(L, n, 0);
  for (int i = 0; i < n; i++) {
    double full[1 + MAX_STATES] = {times[i]};
    memcpy(full + 1, times + n + i * nx, (size_t)nx * sizeof full[0]);
    fields_push(L, 1 + nx, full);
    lua_rawseti(L, -2, i + 1);
  }
  return 1;
}

static int march_some(void *what, long steps) {
  struct race *r = what;
  memcpy(r->x, r->r.x0, sizeof r->x);
  if (r->peer->start(r->it, 0, r->x) != 0)
    return GIVES_UP;
  return r->peer->march(r->it, 0, r->x, r->h, steps) != 0 ? GIVES_UP : FINE;
}

static int march_often(void *what, long n) {
  const struct race *r = what;
  int status = FINE;
  for (long i = 0; i < n && status == FINE; i++)
    status = march_some(what, r->steps);
  return status;
}

/* Once it has reached the end, it will again. */
static int go_often(void *what, long n) {
  struct race *r = what;
  int status = FINE;
  for (long i = 0; i < n && status == FINE; i++) {
    memcpy(r->x, r->r.x0, sizeof r->x);
    status = r->peer->start(r->it, 0, r->x) != 0 ? GIVES_UP : cover(r, 0, r->r.to, HUGE_VAL);
  }
  return status;
}

/* time_peer{name =, setting =, x0 =, to =[, u =, repeats = 9, limit = 1]} -> as time */
int plugin_time_peer(lua_State *L) {
  const struct plugin *p = plugin_ready(L);
  struct race r = {0};
  struct bench_result result;
  bench_read(L, p, &r.r);
  lua_getfield(L, 2, "name");
  r.peer = find(L, luaL_checkstring(L, -1));
  r.problem.setting = fields_positive(L, 2, "setting", 0);
  const int fixed = r.peer->march != NULL;
  const long whole = fixed ? bench_steps(L, r.r.to, r.problem.setting) : 0;
  if (!prepare(p, &r))
    return fail(L, none);
  r.h = r.r.to / (double)whole;
  int status = open_race(&r);
  if (status == FINE && fixed) {
    status = bench_part(march_some, &r, whole, r.r.limit, &r.steps);
    if (status == FINE)
      status = bench_measure(march_often, &r, r.r.repeats, r.r.limit, &result);
  } else if (status == FINE) {
    memcpy(r.x, r.r.x0, sizeof r.x);
    status =
        r.peer->start(r.it, 0, r.x) != 0 ? GIVES_UP : cover(&r, 0, r.r.to, bench_now() + r.r.limit);
    r.steps = status == FINE ? r.peer->steps(r.it) : 0;
    if (status == FINE)
      status = bench_measure(go_often, &r, r.r.repeats, r.r.limit, &result);
  }
  close_race(&r);
  if (status != FINE)
    return fail(L, phrase[status > 0 ? status : FINE]);
  const double part = fixed ? (double)r.steps / (double)whole : 1;
  bench_push(L, &result, part);
  fields_set_count(L, "steps", fixed ? whole : r.steps);
  fields_set_number(L, "part", part);
  return 1;
}
