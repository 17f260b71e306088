/* acts.c - the effects of polhode_acts.h: from Lua to the library, and their largest terms.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Tables and programs live as long as the scene's Lua table, which keeps them in its field
 * "memory".
 */
#include "engine.h"

#include <math.h>
#include <string.h>

/* A number, {rows = {t, v, ...}} or {code = {...}} at the stack's top, which is popped. */
static void read_varying(struct engine_scene *s, ph_varying *out) {
  lua_State *L = s->L;
  *out = (ph_varying){0};
  if (lua_type(L, -1) == LUA_TNUMBER) {
    out->value = lua_tonumber(L, -1);
  } else if (engine_has(L, "rows")) {
    lua_getfield(L, -1, "rows");
    const int n = (int)lua_rawlen(L, -1);
    double *table = lua_newuserdatauv(L, (size_t)n * sizeof *table, 0);
    lua_insert(L, -2);
    engine_list(L, -1, n, table);
    lua_pop(L, 1);
    engine_keep(s);
    out->rows = n / 2;
    out->table = table;
  } else {
    lua_getfield(L, -1, "code");
    engine_read_program(s, out);
  }
  lua_pop(L, 1);
}

/* Each entry of the list in a field of the table on top: at most n of them; how many. */
static int read_list(struct engine_scene *s, const char *key, int n, int programs,
                     ph_varying out[]) {
  lua_State *L = s->L;
  lua_getfield(L, -1, key);
  const int length = (int)lua_rawlen(L, -1);
  for (int i = 0; i < n && i < length; i++) {
    lua_rawgeti(L, -1, i + 1);
    if (programs)
      engine_read_program(s, &out[i]);
    else
      read_varying(s, &out[i]);
  }
  lua_pop(L, 1);
  return length;
}

static int flag(lua_State *L, const char *key) {
  lua_getfield(L, -1, key);
  const int set = lua_toboolean(L, -1);
  lua_pop(L, 1);
  return set;
}

static int read_spring(struct engine_scene *s) {
  lua_State *L = s->L;
  double k[3], rest[4], axis[3];
  engine_get(L, -1, "stiffness", 3, k, NULL);
  engine_get(L, -1, "rest", 4, rest, NULL);
  if (!engine_has(L, "axis"))
    return ph_top_spring(&s->top, k, rest);
  engine_get(L, -1, "axis", 3, axis, NULL);
  return ph_top_spring_axis(&s->top, k[0], axis, rest);
}

static int read_magnetic(struct engine_scene *s) {
  double moment[3], field[3];
  engine_get(s->L, -1, "moment", 3, moment, NULL);
  engine_get(s->L, -1, "field", 3, field, NULL);
  return ph_top_magnetic(&s->top, moment, field, flag(s->L, "rotating"),
                         engine_number(s->L, "rate"));
}

static int read_wheel(struct engine_scene *s) {
  ph_varying torque;
  double axis[3];
  engine_get(s->L, -1, "axis", 3, axis, NULL);
  lua_getfield(s->L, -1, "torque");
  read_varying(s, &torque);
  return ph_top_wheel(&s->top, axis, engine_number(s->L, "inertia"), torque,
                      flag(s->L, "included"));
}

static int read_custom(struct engine_scene *s) {
  lua_State *L = s->L;
  ph_varying torque[3] = {{0}}, force[3] = {{0}}, potential = {0}, rate[PH_OWN_STATES] = {{0}};
  read_list(s, "torque", 3, 1, torque);
  read_list(s, "force", 3, 1, force);
  lua_getfield(L, -1, "potential");
  engine_read_program(s, &potential);
  const int n = read_list(s, "states", PH_OWN_STATES, 1, rate);
  return ph_top_custom(&s->top, torque, force, &potential, n, rate);
}

/* 8 n numbers, which live as long as the scene's table. */
static int read_solar(struct engine_scene *s) {
  lua_State *L = s->L;
  double sun[3];
  engine_get(L, -1, "sun", 3, sun, NULL);
  lua_getfield(L, -1, "plates");
  const int n = (int)lua_rawlen(L, -1);
  double *plates = lua_newuserdatauv(L, (size_t)(n > 0 ? n : 1) * sizeof *plates, 0);
  lua_insert(L, -2);
  engine_list(L, -1, n, plates);
  lua_pop(L, 1);
  engine_keep(s);
  return ph_top_solar(&s->top, engine_number(L, "flux"), sun, n / 8, plates);
}

static int read_pivot(struct engine_scene *s) {
  double axis[3];
  ph_varying a[3] = {{0}};
  if (engine_has(s->L, "acceleration")) {
    read_list(s, "acceleration", 3, 0, a);
    return ph_top_pivot(&s->top, a);
  }
  engine_get(s->L, -1, "axis", 3, axis, NULL);
  return ph_top_vibration(&s->top, engine_number(s->L, "amplitude"), engine_number(s->L, "rate"),
                          axis);
}

static int read_parts(struct engine_scene *s) {
  ph_varying tensor[6] = {{0}}, rate[6] = {{0}};
  read_list(s, "tensor", 6, 1, tensor);
  read_list(s, "rate", 6, 1, rate);
  return ph_top_parts(&s->top, tensor, rate);
}

static int read_gradient(struct engine_scene *s) {
  const double mu = engine_number(s->L, "mu"), radius = engine_number(s->L, "radius");
  if (flag(s->L, "elliptic"))
    return ph_top_gravity_gradient_orbit(&s->top, mu, radius, engine_number(s->L, "e"));
  return ph_top_gravity_gradient(&s->top, mu, radius);
}

void engine_read_own(lua_State *L, int index, const ph_top *top, double x[]) {
  int n = 0;
  for (int k = 0; k < top->acts.n; k++)
    n += top->acts.list[k].states;
  if (n > 0)
    engine_get(L, index, "own", n, x + ph_top_states(top) - n, NULL);
}

int engine_read_act(struct engine_scene *s, const char *kind, int *status) {
  lua_State *L = s->L;
  if (strcmp(kind, "drag") == 0) {
    *status = ph_top_quadratic(&s->top, engine_number(L, "c"));
  } else if (strcmp(kind, "friction") == 0) {
    *status = ph_top_friction(&s->top, engine_number(L, "torque"), engine_number(L, "smoothing"));
  } else if (strcmp(kind, "spring") == 0) {
    *status = read_spring(s);
  } else if (strcmp(kind, "magnetic") == 0) {
    *status = read_magnetic(s);
  } else if (strcmp(kind, "wheel") == 0) {
    *status = read_wheel(s);
  } else if (strcmp(kind, "varying") == 0) {
    ph_varying torque[3] = {{0}};
    read_list(s, "parts", 3, 0, torque);
    *status = ph_top_varying(&s->top, flag(L, "inertial"), torque);
  } else if (strcmp(kind, "custom") == 0) {
    *status = read_custom(s);
  } else if (strcmp(kind, "gradient") == 0) {
    *status = read_gradient(s);
  } else if (strcmp(kind, "solar") == 0) {
    *status = read_solar(s);
  } else if (strcmp(kind, "pivot") == 0) {
    *status = read_pivot(s);
  } else if (strcmp(kind, "parts") == 0) {
    *status = read_parts(s);
  } else if (strcmp(kind, "dissipation") == 0) {
    *status = ph_top_dissipation(&s->top, engine_number(L, "k"));
  } else {
    return 0;
  }
  s->where = *status ? kind : s->where; /* the name lives in the scene's table */
  return 1;
}

/* ---- largest terms ---- */

static double larger(double a, double b) {
  return a > b ? a : b; /* NaN in b is passed over: the rates themselves show it */
}

static double norm(const double v[3]) {
  return hypot(hypot(v[0], v[1]), v[2]);
}

/* Of a value that varies: of a table as a sum of ramps, slope times distance to each row. */
double engine_varying_size(const ph_top *top, const ph_varying *v, double t, const double x[]) {
  double most = fabs(v->value);
  if (v->f)
    return engine_program_size(v, t, x, ph_top_states(top));
  for (int i = 0; i < v->rows; i++) {
    const double *row = v->table + 2 * i;
    most = larger(most, fabs(row[1]));
    if (i > 0) {
      const double slope = fabs((row[1] - row[-1]) / (row[0] - row[-2]));
      most = larger(most, slope * larger(larger(fabs(row[0]), fabs(row[-2])), fabs(t)));
    }
  }
  return most;
}

void engine_acts_torque(const ph_top *top, double t, const double x[], double term[3]) {
  const double *w = x + 4, q2 = x[0] * x[0] + x[1] * x[1] + x[2] * x[2] + x[3] * x[3];
  for (int k = 0; k < top->acts.n; k++) {
    const ph_act *a = &top->acts.list[k];
    double factor = 0, all = 0, part[3] = {0, 0, 0};
    int i;
    if (!(top->effects & a->kind))
      continue;
    switch (a->kind) {
    case PH_QUADRATIC:
      factor = a->v[0] * norm(w);
      break;
    case PH_FRICTION:
      factor = a->v[0] / hypot(norm(w), a->v[1]);
      break;
    case PH_SPRING: /* each of p0 and u is a sum of four products */
      all = 4 * q2 * (a->flag ? a->v[0] : larger(a->v[0], larger(a->v[1], a->v[2])));
      break;
    case PH_MAGNETIC:
      all = norm(a->v) * norm(a->v + 3) * q2;
      break;
    case PH_WHEEL: {
      double speed = fabs(x[engine_own_place(top, k)]);
      for (i = 0; i < 3; i++)
        speed = larger(speed, fabs(a->v[i] * w[i]));
      all = larger(a->v[3] * speed * norm(w), engine_varying_size(top, &a->torque[0], t, x));
      break;
    }
    case PH_GRADIENT:
    case PH_SOLAR:
    case PH_PIVOT:
    case PH_PARTS:
    case PH_DISSIPATION:
      all = engine_acts_more(top, k, t, x);
      break;
    default:
      for (i = 0; i < 3; i++)
        part[i] = engine_varying_size(top, &a->torque[i], t, x);
      if (a->kind == PH_VARYING && a->flag)
        all = norm(part) * q2;
    }
    for (i = 0; i < 3; i++)
      term[i] = larger(term[i], larger(all, larger(part[i], factor * fabs(w[i]))));
  }
}

int engine_own_place(const ph_top *top, int act) {
  int n = 0;
  for (int k = act; k < top->acts.n; k++)
    if (top->effects & top->acts.list[k].kind)
      n += top->acts.list[k].states;
  return ph_top_states(top) - n;
}

/* scale has those of w already. */
void engine_acts_scale(const ph_top *top, double t, const double x[], double scale[]) {
  engine_acts_more_scale(top, t, x, scale);
  for (int k = 0; k < top->acts.n; k++) {
    const ph_act *a = &top->acts.list[k];
    if (!(top->effects & a->kind))
      continue;
    for (int i = 0; i < 3 && a->kind == PH_CUSTOM && top->effects & PH_TRANSLATION; i++)
      scale[10 + i] =
          larger(scale[10 + i], engine_varying_size(top, &a->force[i], t, x) / top->mass);
    double *own = scale + engine_own_place(top, k);
    for (int i = 0; i < a->states && a->kind == PH_CUSTOM; i++)
      own[i] = engine_varying_size(top, &a->rate[i], t, x);
    if (a->kind == PH_WHEEL) {
      own[0] = engine_varying_size(top, &a->torque[0], t, x) / a->v[3];
      for (int i = 0; i < 3; i++)
        own[0] = larger(own[0], fabs(a->v[i]) * scale[4 + i]);
    }
  }
}

double engine_acts_energy(const ph_top *top, const double x[]) {
  const double *w = x + 4;
  double scale = 0;
  for (int k = 0; k < top->acts.n; k++) {
    const ph_act *a = &top->acts.list[k];
    double term = 0;
    if (!(top->effects & a->kind))
      continue;
    if (a->kind == PH_SPRING)
      term = 2 * (a->flag ? a->v[0] : larger(a->v[0], larger(a->v[1], a->v[2])));
    else if (a->kind == PH_MAGNETIC && !a->flag)
      term = norm(a->v) * norm(a->v + 3);
    else if (a->kind == PH_WHEEL)
      term = a->v[3] * pow(larger(fabs(x[engine_own_place(top, k)]), norm(w)), 2) / 2;
    else if (a->kind == PH_CUSTOM)
      term = engine_varying_size(top, &a->potential, 0, x);
    else if (a->kind == PH_PARTS)
      for (int i = 0; i < 6; i++)
        term = larger(term, engine_varying_size(top, &a->rate[i], 0, x) * pow(norm(w), 2) / 2);
    scale = larger(scale, term);
  }
  return scale;
}

double engine_acts_momentum(const ph_top *top, const double x[]) {
  double scale = 0;
  for (int k = 0; k < top->acts.n && top->effects & PH_PARTS; k++)
    for (int i = 0; i < 6 && top->acts.list[k].kind == PH_PARTS; i++)
      scale =
          larger(scale, engine_varying_size(top, &top->acts.list[k].rate[i], 0, x) * norm(x + 4));
  for (int k = 0; k < top->acts.n; k++)
    if (top->effects & PH_WHEEL && top->acts.list[k].kind == PH_WHEEL)
      scale = larger(scale, top->acts.list[k].v[3] *
                                larger(fabs(x[engine_own_place(top, k)]), norm(x + 4)));
  return scale;
}
