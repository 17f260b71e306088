/* emitted.c - how long the emitted code takes for a horizon.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The loops are the plugin's own, in the scene's real type; the functions that they call are
 * in another object file, so that no compiler leaves one out because its result is not used.
 */
#include "bench.h"

#include <math.h>
#include <string.h>

#define MOST_STEPS 100000000 /* of one run with a tolerance */

/* ---- steppers ---- */

struct motion {
  const struct plugin *p;
  const struct polhode_stepper *s;
  struct bench_request r;
  double h, tolerance, x[MAX_STATES]; /* x: where the last run ended */
  long steps;
  int most; /* steps of a run with a tolerance */
};

static int march(void *what, long steps) {
  struct motion *m = what;
  memcpy(m->x, m->r.x0, sizeof m->x);
  m->s->march(m->p->model, 0, m->x, m->r.u, m->h, steps);
  return 0;
}

static int march_often(void *what, long n) {
  const struct motion *m = what;
  for (long i = 0; i < n; i++)
    march(what, m->steps);
  return 0;
}

static int run_often(void *what, long n) {
  struct motion *m = what;
  int steps = 0;
  for (long i = 0; i < n && steps >= 0; i++) {
    memcpy(m->x, m->r.x0, sizeof m->x);
    steps = m->s->run(m->p->model, 0, m->x, m->r.u, m->r.to, m->tolerance, m->most);
  }
  m->steps = steps;
  return steps < 0;
}

/* The run once, by allowing it more and more steps as long as there is time for them: NULL, or why
   it does not end. */
static const char *probe(struct motion *m) {
  const double start = bench_now();
  for (double most = 1000;;) {
    const double begin = bench_now();
    m->most = (int)most;
    if (run_often(m, 1) == 0)
      return NULL;
    const double now = bench_now(), rate = most / fmax(now - begin, 1e-9);
    if (most >= MOST_STEPS)
      return "no steps lead to the end";
    if (interrupt_pending() || now - start > m->r.limit / 3)
      return "not done within the limit";
    most = fmin(fmin(most * 100, most + rate * (m->r.limit - (now - start))), MOST_STEPS);
  }
}

/* march(t0, x, u, h, n[, method]) -> x after n steps of h, all in the plugin */
int plugin_march(lua_State *L) {
  const struct plugin *p = plugin_ready(L);
  double x[MAX_STATES], u[MAX_STATES];
  const double t0 = luaL_checknumber(L, 2), h = luaL_checknumber(L, 5);
  const lua_Integer n = luaL_checkinteger(L, 6);
  const struct polhode_stepper *s = plugin_stepper(L, p, 7);
  fields_list(L, 3, p->code->nx, x);
  fields_optional(L, 4, p->code->nu, u);
  luaL_argcheck(L, n >= 0 && n <= MOST_STEPS, 6, "between 0 and 1e8 steps");
  s->march(p->model, t0, x, u, h, (long)n);
  interrupt_check(L);
  fields_push(L, p->code->nx, x);
  return 1;
}

/* The result of bench_measure as Lua has it. part: of the work that was measured. */
static int finish(lua_State *L, int status, const struct bench_result *r, double part,
                  const struct motion *m) {
  interrupt_check(L);
  if (status != 0) {
    lua_pushnil(L);
    lua_pushliteral(L, "no steps lead to the end");
    return 2;
  }
  bench_push(L, r, part);
  fields_set_count(L, "steps", m->steps);
  fields_set_number(L, "part", part);
  return 1;
}

/* time{x0 =, to =, step = or tolerance =[, method =, u =, repeats = 9, limit = 1 (seconds)]} ->
   {median =, least =, most =: seconds from 0 to `to`, steps =, repeats =: samples, part =} | nil,
   message.  A fixed step is cut as integrate does it; where all its steps would take longer than
   the limit, a part of them is timed and the times are scaled up. */
int plugin_time(lua_State *L) {
  const struct plugin *p = plugin_ready(L);
  struct motion m = {.p = p};
  struct bench_result result;
  bench_read(L, p, &m.r);
  const int fixed = fields_has(L, 2, "step"), adaptive = fields_has(L, 2, "tolerance");
  m.h = fields_positive(L, 2, "step", 1);
  m.tolerance = fields_positive(L, 2, "tolerance", 1);
  if (fixed == adaptive)
    return luaL_error(L, "time: a step or a tolerance is needed, one of them");
  lua_getfield(L, 2, "method");
  m.s = plugin_stepper(L, p, lua_gettop(L));
  if (adaptive) {
    if (m.s->run == NULL)
      return luaL_error(L, "tolerance: the stepper %s has a fixed step", m.s->name);
    const char *why = probe(&m);
    interrupt_check(L);
    if (why != NULL) {
      lua_pushnil(L);
      lua_pushstring(L, why);
      return 2;
    }
    return finish(L, bench_measure(run_often, &m, m.r.repeats, m.r.limit, &result), &result, 1, &m);
  }
  const long whole = bench_steps(L, m.r.to, m.h);
  m.h = m.r.to / (double)whole;
  int status = bench_part(march, &m, whole, m.r.limit, &m.steps);
  if (status == 0)
    status = bench_measure(march_often, &m, m.r.repeats, m.r.limit, &result);
  const double part = (double)m.steps / (double)whole;
  m.steps = whole;
  return finish(L, status, &result, part, &m);
}

/* ---- closed forms ---- */

/* An orbit of its own: the plugin's stays what solve() made it. */
struct orbit {
  const struct plugin *p;
  void (*loop)(const void *o, double t0, double h, double *x, long n);
  void *place;
  double x0[MAX_STATES], x[MAX_STATES], to;
};

static int solve_often(void *what, long n) {
  struct orbit *o = what;
  return o->p->code->solve_loop(o->place, o->p->model, o->x0, n);
}

/* The same times evenly over the horizon, again and again: no branch is always taken alike. */
static int at_often(void *what, long n) {
  enum { TIMES = 640 };
  struct orbit *o = what;
  for (long i = 0; i < n; i += TIMES)
    o->loop(o->place, 0, o->to / TIMES, o->x, n - i < TIMES ? n - i : TIMES);
  return 0;
}

/* time_closed{x0 =, to =[, repeats = 9, limit = 1]} -> {setup = {median =, least =, most =}:
   seconds to make the orbit, at = {...}: for one state on it, many = {...}: for one of many at a
   time, nil if the emitted code has no such function} | nil, message */
int plugin_time_closed(lua_State *L) {
  const struct plugin *p = plugin_ready(L);
  struct bench_request r;
  struct bench_result setup, at, many;
  bench_read(L, p, &r);
  if (p->code->solve_loop == NULL || p->code->at_loop == NULL) {
    lua_pushnil(L);
    lua_pushliteral(L, "the emitted code has no closed form");
    return 2;
  }
  struct orbit o = {.p = p, .to = r.to, .loop = p->code->at_loop};
  memcpy(o.x0, r.x0, sizeof o.x0);
  o.place = engine_aligned(lua_newuserdatauv(L, p->code->orbit_size + ENGINE_ALIGNMENT, 0));
  int status = bench_measure(solve_often, &o, r.repeats, r.limit / 3, &setup);
  if (status == 0)
    status = bench_measure(at_often, &o, r.repeats, r.limit / 3, &at);
  o.loop = p->code->many_loop;
  if (status == 0 && o.loop != NULL)
    status = bench_measure(at_often, &o, r.repeats, r.limit / 3, &many);
  interrupt_check(L);
  if (status != 0) {
    lua_pushnil(L);
    lua_pushfstring(L, "the closed form refuses the initial state (%d)", status);
    return 2;
  }
  lua_createtable(L, 0, 2);
  bench_push(L, &setup, 1);
  lua_setfield(L, -2, "setup");
  bench_push(L, &at, 1);
  lua_setfield(L, -2, "at");
  if (o.loop != NULL) {
    bench_push(L, &many, 1);
    lua_setfield(L, -2, "many");
  }
  return 1;
}
