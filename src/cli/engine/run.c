/* run.c - motion by the general library: trajectories, and rates of change with their scale.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * run() integrates.  rates() gives what the emitted equations are compared with: beside each number
 * the largest term that was added to make it, because only relative to that can two honest
 * roundings agree (a difference that cancels has no correct digits of its own).
 */
#include "engine.h"

#include <float.h>
#include <math.h>
#include <string.h>
#include <time.h>

/* Between two rows: so many steps, and a minute of processor time. */
#define MAX_STEPS   5000000
#define MAX_SECONDS 60

static const double no_control[3] = {0, 0, 0};

static const struct {
  const char *name;
  ph_method method;
  double tolerance; /* where none is asked for */
} methods[] = {
    {"adaptive", PH_TAYLOR, 0}, {"taylor", PH_TAYLOR, 0},     {"rk4", PH_RK4, 0},
    {"gsl-rk4", PH_RK4_GSL, 0}, {"rkf45", PH_RKF45, 1e-10},   {"rk8pd", PH_RK8PD, 1e-13},
    {"exact", PH_EXACT, 0},     {"implicit", PH_IMPLICIT, 0},
};

/* A signal to stop, or the end of the row's time. */
static int stop(void *since) {
  return interrupt_pending() ||
         (double)(clock() - *(const clock_t *)since) / CLOCKS_PER_SEC > MAX_SECONDS;
}

static int read_options(lua_State *L, int index, clock_t *since, ph_options *o) {
  *o = ph_options_default();
  o->max_steps = MAX_STEPS;
  o->stop = stop;
  o->context = since;
  lua_getfield(L, index, "method");
  const char *name = luaL_optstring(L, -1, "adaptive");
  size_t i = 0;
  while (i < sizeof methods / sizeof methods[0] && strcmp(methods[i].name, name) != 0)
    i++;
  lua_pop(L, 1);
  if (i == sizeof methods / sizeof methods[0])
    return PH_EMETHOD;
  o->method = methods[i].method;
  if (methods[i].tolerance > 0)
    o->tolerance = methods[i].tolerance;
  o->step = fields_option(L, index, "step", o->step);
  o->tolerance = fields_option(L, index, "tol", o->tolerance);
  o->order = (int)fields_option(L, index, "order", o->order);
  o->max_steps = (long)fmin(fields_option(L, index, "most", MAX_STEPS), MAX_STEPS);
  return PH_OK;
}

static int push_row(lua_State *L, const ph_top *top, double t, const double x[]) {
  const int n = ph_top_states(top);
  double row[PH_STATES + 5] = {t};
  memcpy(row + 1, x, (size_t)n * sizeof x[0]);
  int status = ph_top_energy(top, x, &row[n + 1]);
  if (status == PH_OK)
    status = ph_top_momentum(top, x, &row[n + 2]);
  if (status == PH_OK)
    fields_push(L, n + 5, row);
  return status;
}

/* Holds the ph_run so that an error in Lua frees it. */
static int run_free(lua_State *L) {
  ph_run **run = lua_touserdata(L, 1);
  ph_run_free(*run);
  *run = NULL;
  return 0;
}

static ph_run **new_run_holder(lua_State *L) {
  ph_run **run = lua_newuserdatauv(L, sizeof *run, 0);
  *run = NULL;
  if (luaL_newmetatable(L, "polhode.run")) {
    lua_pushcfunction(L, run_free);
    lua_setfield(L, -2, "__gc");
  }
  lua_setmetatable(L, -2);
  return run;
}

/* nil, message, kind, t: "refused" what was asked for, before the first step, or "numbers". */
static int fail_at(lua_State *L, double t, int status, int started) {
  lua_pushnil(L);
  lua_pushfstring(L, "at t = %f s: %s", (LUAI_UACNUMBER)t, ph_status_phrase(status));
  lua_pushstring(L, started || status == PH_ERANGE ? "numbers" : "refused");
  lua_pushnumber(L, t);
  return 4;
}

/* Where rows come from: a run, or x0 and the linearised motion. */
struct motion {
  const struct engine_scene *s;
  ph_run *run;
  const struct course *course;
  double x0[7], t0;
  double step;   /* 0: the method chooses */
  clock_t since; /* processor time at which the row began */
};

/* From where the run is to `end`, from break to break of the inputs' course. */
static int go(const struct motion *m, double end, double x[]) {
  const struct engine_scene *s = m->s;
  if (m->run == NULL)
    return ph_top_linearised(&s->top, m->x0, end - m->t0, x);
  double t = ph_run_time(m->run);
  int status;
  do {
    const double next = course_next(m->course, t, end);
    course_segment(m->course, t, next, s->input);
    status = ph_run_to(m->run, next, s->input->base, x);
    t = next;
  } while (status == PH_OK && t != end);
  return status;
}

static int reach(struct motion *m, double t, double x[]) {
  m->since = clock();
  const int status = go(m, t, x);
  interrupt_check(m->s->L);
  return status;
}

/* A time between `from`, which was reached, and `end`, which was not: with steps of their own
   length the end of the first that fails, else where the motion ends, by halving. */
static double first_failure(struct motion *m, double from, double end) {
  double x[PH_STATES];
  if (m->run != NULL) /* a failure leaves it where it was: at a break, maybe */
    from = ph_run_time(m->run);
  double t = course_next(m->course, from, end);
  if (m->step > 0) {
    const double span = t - from, ends = fabs(from) + fabs(t);
    const double rounding = DBL_EPSILON * (8 * fabs(span) + 2 * ends); /* as the library has it */
    const double n = ceil((fabs(span) - rounding) / m->step);
    for (double i = 1; i < n; i++)
      if (reach(m, from + span * (i / n), x) != PH_OK)
        return from + span * (i / n);
    return t;
  }
  for (int i = 0; i < 50 && t != from; i++) {
    const double middle = from + (t - from) / 2;
    if (reach(m, middle, x) == PH_OK)
      from = middle;
    else
      t = middle;
  }
  return t;
}

/* Tells the function `seen` of the options, if there is one, that t is reached. */
static void tell(lua_State *L, double t) {
  lua_getfield(L, 2, "seen");
  if (lua_isfunction(L, -1)) {
    lua_pushnumber(L, t);
    lua_call(L, 1, 0);
  } else {
    lua_pop(L, 1);
  }
}

/* Does it fail at a time of its own? Not so PH_ESTEPS, which takes long. */
static int ends_inside(int status) {
  return status == PH_ERANGE || status == PH_ESTEP || status == PH_ECHATTER;
}

/* run(scene, {method=, step=, tol=, order=, most=, times={...}, t0=, u=course, seen=}) -> {{t, q4,
   w3, energy, L3},
   ...} (with r3, v3 after w3 where the body moves) | nil, message, "refused" or "numbers", the time
   at which they failed; after the rows how many steps were implicit.  Method: adaptive (default)
   and taylor (long double Taylor series), rk4, gsl-rk4, rkf45, rk8pd, implicit, exact and
   linearised (a free top only). */
int host_run(lua_State *L) {
  struct engine_scene s;
  ph_options options = {0};
  struct course constant;
  double x[PH_STATES];
  luaL_checktype(L, 2, LUA_TTABLE);
  lua_settop(L, 2);
  int status = engine_read(&s, L, 1);
  if (status != PH_OK) {
    engine_fail(&s, status);
    lua_pushstring(L, status == PH_ERANGE ? "numbers" : "refused");
    return 3;
  }
  struct motion m = {.s = &s};
  fields_get(L, 1, "q", 4, x, NULL);
  fields_get(L, 1, "w", 3, x + 4, NULL);
  fields_get(L, 1, "r", 3, x + 7, no_control);
  fields_get(L, 1, "v", 3, x + 10, no_control);
  engine_read_own(L, 1, &s.top, x);
  lua_getfield(L, 2, "u");
  m.course = course_at(L, -1, s.inputs, &constant);
  double t = m.t0 = fields_option(L, 2, "t0", 0);
  memcpy(m.x0, x, sizeof m.x0);
  lua_getfield(L, 2, "method");
  const int linearised = strcmp(luaL_optstring(L, -1, ""), "linearised") == 0; /* from x0 */
  lua_pop(L, 1);
  ph_run **run = new_run_holder(L);
  if (!linearised) {
    status = read_options(L, 2, &m.since, &options);
    if (status == PH_OK)
      status = ph_run_new(run, &s.top, &options, t, x);
  }
  if (status != PH_OK)
    return fail_at(L, t, status, 0);
  m.run = *run;
  m.step = options.step;
  lua_getfield(L, 2, "times");
  luaL_checktype(L, -1, LUA_TTABLE);
  const int n = (int)lua_rawlen(L, -1), times = lua_gettop(L);
  lua_createtable(L, n, 0);
  for (int i = 1; i <= n; i++) {
    lua_rawgeti(L, times, i);
    double end = luaL_checknumber(L, -1);
    lua_pop(L, 1);
    status = reach(&m, end, x);
    if (ends_inside(status))
      end = first_failure(&m, t, end);
    t = end;
    if (status == PH_OK)
      status = push_row(L, &s.top, t, x);
    if (status != PH_OK)
      return fail_at(L, t, status, status != PH_EMETHOD);
    lua_rawseti(L, times + 1, i);
    tell(L, t);
  }
  lua_pushinteger(L, *run ? ph_run_implicit_steps(*run) : 0);
  ph_run_free(*run);
  *run = NULL;
  return 2;
}

#define RATES_TYPE "polhode.rates"

struct rates {
  ph_top top;
  int inputs;
  struct course_segment *input;
  double inverse[9]; /* |components| of the pseudo-inverse of the inertia tensor; see bound() */
  double spread[9];  /* |components| of the tensor, as a matrix; likewise */
};

/* A component off the diagonal that is not 0 by symmetry is a sum of terms of both signs and may
 * pass through zero.  It is as good as the sum of their moduli, of which this is a bound: sqrt(m_i
 * m_j), by Cauchy and Schwarz, for the squares m on the diagonal. */
static double bound(double component, double mi, double mj) {
  if (component == 0 || !(mi > 0) || !(mj > 0))
    return fabs(component);
  return effect_larger(fabs(component), sqrt(mi) * sqrt(mj));
}

/* D: what moving parts add to the tensor, or NULL.
 * Sum of a_k a_k^T / I_k over the axes that have a moment, entrywise absolute values. */
static int prepare(struct rates *r, const double D[6]) {
  static const int at[9] = {0, 3, 4, 3, 1, 5, 4, 5, 2};
  ph_axes p;
  double carried[6]; /* by the rates: without the wheels that the tensor includes */
  for (int i = 0; i < 6; i++)
    carried[i] = r->top.inertia[i] + (D ? D[i] : 0);
  effect_carried(&r->top, carried);
  const int status = ph_principal(carried, &p);
  if (status != PH_OK)
    return status;
  double inverse[9];
  for (int i = 0; i < 9; i++) {
    inverse[i] = 0;
    for (int k = 0; k < 3; k++)
      if (p.moment[k] > 16 * DBL_EPSILON * p.moment[2]) /* else a rod's own axis */
        inverse[i] += p.axis[k][i / 3] * p.axis[k][i % 3] / p.moment[k];
  }
  const double *I = r->top.inertia, half = (I[0] + I[1] + I[2]) / 2; /* half - I_ii: of x_i^2 */
  for (int i = 0; i < 9; i++) {
    const int a = i / 3, b = i % 3;
    r->inverse[i] = fabs(inverse[i]);
    r->spread[i] = fabs(I[at[i]]);
    if (a != b) {
      r->inverse[i] = bound(inverse[i], inverse[4 * a], inverse[4 * b]);
      r->spread[i] = bound(I[at[i]], half - I[a], half - I[b]);
    }
  }
  return PH_OK;
}

static effect_terms terms_of(const struct rates *r, double t, const double x[], const double u[]) {
  return (effect_terms){
      .top = &r->top, .t = t, .x = x, .u = u, .spread = r->spread, .size = engine_program_size};
}

/* Of all rates of change; of w' by the largest term of each component of N - w x I w, every product
   of the formula on its own. */
static void scales(const struct rates *r, double t, const double x[], const double u[],
                   const double dx[], double scale[]) {
  /* which q multiplies wx, wy, wz in row i of q' = q (0, w) / 2 */
  static const int row[4][3] = {{1, 2, 3}, {0, 3, 2}, {3, 0, 1}, {2, 1, 0}};
  effect_terms terms = terms_of(r, t, x, u);
  const double *w = x + 4;
  double term[3] = {0};
  terms.dx = dx;
  memset(scale, 0, (size_t)ph_top_states(&r->top) * sizeof scale[0]);
  for (int j = 0; j < 3; j++) {
    const int a = (j + 1) % 3, b = (j + 2) % 3;
    for (int k = 0; k < 3; k++) {
      effect_raise(&term[j], fabs(w[a]) * r->spread[3 * b + k] * fabs(w[k]));
      effect_raise(&term[j], fabs(w[b]) * r->spread[3 * a + k] * fabs(w[k]));
    }
  }
  effect_term_torque(&terms, term);
  for (int i = 0; i < 4; i++)
    for (int k = 0; k < 3; k++)
      effect_raise(&scale[i], fabs(0.5 * x[row[i][k]] * x[4 + k]));
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++)
      effect_raise(&scale[4 + i], r->inverse[3 * i + j] * term[j]);
  effect_term_rates(&terms, scale);
}

static struct rates *self(lua_State *L) {
  return engine_aligned(luaL_checkudata(L, 1, RATES_TYPE));
}

static int fail(lua_State *L, int status) {
  lua_pushnil(L);
  lua_pushstring(L, ph_status_phrase(status));
  return 2;
}

/* object:rates(t, x[, u]) -> dx, scale | nil, message */
static int rates_rates(lua_State *L) {
  const struct rates *r = self(L);
  double x[PH_STATES], dx[PH_STATES], scale[PH_STATES];
  struct course constant;
  const int n = ph_top_states(&r->top);
  const double t = luaL_checknumber(L, 2);
  fields_list(L, 3, n, x);
  course_segment(course_at(L, 4, r->inputs, &constant), t, t, r->input);
  const double *u = r->input->base;
  const int status = ph_top_rates(&r->top, t, x, u, dx);
  if (status != PH_OK)
    return fail(L, status);
  struct rates now = *r; /* with moving parts as they are */
  double D[6];
  const effect_terms terms = terms_of(r, t, x, u);
  if (effect_tensor(&terms, D) && prepare(&now, D) != PH_OK)
    return fail(L, PH_EPOSITIVE);
  scales(&now, t, x, u, dx, scale);
  fields_push(L, n, dx);
  fields_push(L, n, scale);
  return 2;
}

/* object:energy(x) -> E, largest term | nil, message */
static int rates_energy(lua_State *L) {
  const struct rates *r = self(L);
  double x[PH_STATES], energy, scale = 0;
  fields_list(L, 2, ph_top_states(&r->top), x);
  const int status = ph_top_energy(&r->top, x, &energy);
  if (status != PH_OK)
    return fail(L, status);
  /* w.I w/2: off the diagonal two halves make one term */
  for (int i = 0; i < 9; i++)
    scale = effect_larger(scale, (i / 3 == i % 3 ? 0.5 : 1) * fabs(x[4 + i / 3] * x[4 + i % 3]) *
                                     r->spread[i]);
  const effect_terms terms = terms_of(r, 0, x, NULL);
  effect_term_energy(&terms, &scale);
  lua_pushnumber(L, energy);
  lua_pushnumber(L, scale);
  return 2;
}

/* object:momentum(x) -> {L3}, largest term of any component | nil, message */
static int rates_momentum(lua_State *L) {
  const struct rates *r = self(L);
  double x[PH_STATES], momentum[3], scale = 0;
  fields_list(L, 2, ph_top_states(&r->top), x);
  const int status = ph_top_momentum(&r->top, x, momentum);
  if (status != PH_OK)
    return fail(L, status);
  for (int i = 0; i < 9; i++)
    scale = effect_larger(scale, r->spread[i] * fabs(x[4 + i % 3]));
  const effect_terms terms = terms_of(r, 0, x, NULL);
  effect_term_momentum(&terms, &scale);
  fields_push(L, 3, momentum);
  lua_pushnumber(L, scale);
  return 2;
}

/* object:contact(t, x[, u]) -> {N, com3, velocity3, force3, point3, slip3} | nil, message */
static int rates_contact(lua_State *L) {
  const struct rates *r = self(L);
  double x[PH_STATES], list[16];
  struct course constant;
  ph_contact c;
  const double t = luaL_checknumber(L, 2);
  fields_list(L, 3, ph_top_states(&r->top), x);
  course_segment(course_at(L, 4, r->inputs, &constant), t, t, r->input);
  const int status = ph_top_contact(&r->top, t, x, r->input->base, &c);
  if (status != PH_OK)
    return fail(L, status);
  list[0] = c.reaction;
  for (int i = 0; i < 3; i++) {
    list[1 + i] = c.com[i];
    list[4 + i] = c.velocity[i];
    list[7 + i] = c.force[i];
    list[10 + i] = c.point[i];
    list[13 + i] = c.slip[i];
  }
  fields_push(L, 16, list);
  return 1;
}

/* object:gap(x) -> {gap, rate, point3, slip3} | nil, message: of x = q, w, r, v in the air */
static int rates_gap(lua_State *L) {
  const struct rates *r = self(L);
  double x[13], list[8];
  ph_gap gap;
  fields_list(L, 2, 13, x);
  const int status = ph_top_gap(&r->top, x, &gap);
  if (status != PH_OK)
    return fail(L, status);
  list[0] = gap.gap;
  list[1] = gap.rate;
  for (int i = 0; i < 3; i++) {
    list[2 + i] = gap.point[i];
    list[5 + i] = gap.slip[i];
  }
  fields_push(L, 8, list);
  return 1;
}

/* object:impact({e, mu, e_t}, x) -> x after it, impulse | nil, message */
static int rates_impact(lua_State *L) {
  const struct rates *r = self(L);
  double x[13], law[3], normal;
  fields_list(L, 2, 3, law);
  fields_list(L, 3, 13, x);
  const ph_impact impact = {law[0], law[1], law[2]};
  const int status = ph_top_impact(&r->top, &impact, x, &normal);
  if (status != PH_OK)
    return fail(L, status);
  fields_push(L, 13, x);
  lua_pushnumber(L, normal);
  return 2;
}

/* rates(scene) -> object with the methods above | nil, message */
int host_rates(lua_State *L) {
  static const luaL_Reg functions[] = {{"rates", rates_rates},
                                       {"energy", rates_energy},
                                       {"momentum", rates_momentum},
                                       {"contact", rates_contact},
                                       {"gap", rates_gap},
                                       {"impact", rates_impact},
                                       {NULL, NULL}};
  struct engine_scene s;
  int status = engine_read(&s, L, 1);
  if (status != PH_OK)
    return engine_fail(&s, status);
  struct rates *r = engine_aligned(lua_newuserdatauv(L, sizeof *r + ENGINE_ALIGNMENT, 1));
  lua_pushvalue(L, 1); /* which keeps tables and programs */
  lua_setiuservalue(L, -2, 1);
  r->top = s.top;
  r->inputs = s.inputs;
  r->input = s.input;
  status = prepare(r, NULL);
  if (status != PH_OK)
    return fail(L, status);
  if (luaL_newmetatable(L, RATES_TYPE)) {
    luaL_newlib(L, functions);
    lua_setfield(L, -2, "__index");
  }
  lua_setmetatable(L, -2);
  return 1;
}
