/* course.c - inputs over time: rows of files, held from one to the next or joined by lines.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "course.h"
#include "csv.h"
#include "fields.h"

#include <lauxlib.h>
#include <math.h>

#define COURSE_TYPE "polhode.course"

/* ---- from Lua ---- */

/* The memory of an input: times, then values. */
struct values {
  size_t near;
  double number[];
};

/* The values that a column has and their times, in memory that is pushed. */
static void read_values(lua_State *L, const struct csv *f, size_t column, struct course_input *in) {
  struct values *v = lua_newuserdatauv(L, sizeof *v + 2 * f->rows * sizeof v->number[0], 0);
  double *t = v->number, *u = t + f->rows;
  v->near = 0;
  for (size_t i = 0; i < f->rows; i++) {
    t[in->rows] = f->t[i];
    u[in->rows] = f->y[i * (size_t)f->columns + column];
    in->rows += u[in->rows] == u[in->rows];
  }
  in->t = t;
  in->u = u;
  in->near = &v->near;
}

/* The input of the table on the top, which is replaced by what holds its values. */
static void read_input(lua_State *L, struct course_input *in) {
  static const char *const kinds[] = {"held", "linear", "slope", NULL};
  const int at = lua_gettop(L);
  lua_getfield(L, at, "kind");
  in->kind = luaL_checkoption(L, -1, NULL, kinds);
  in->low = fields_number(L, at, "low");
  in->high = fields_number(L, at, "high");
  lua_getfield(L, at, "csv");
  const struct csv *f = csv_at(L, -1);
  const int column = (int)fields_number(L, at, "column") - 1;
  luaL_argcheck(L, f->t != NULL && column >= 0 && column < f->columns, 1, "no such column");
  read_values(L, f, (size_t)column, in);
  lua_replace(L, at);
  lua_settop(L, at);
}

static int linear(lua_State *L) {
  lua_pushboolean(L, course_linear(luaL_checkudata(L, 1, COURSE_TYPE)));
  return 1;
}

int host_course(lua_State *L) {
  static const luaL_Reg methods[] = {{"linear", linear}, {NULL, NULL}};
  luaL_checktype(L, 1, LUA_TTABLE);
  const int n = (int)lua_rawlen(L, 1);
  luaL_argcheck(L, n <= COURSE_INPUTS, 1, "too many inputs");
  struct course *c = lua_newuserdatauv(L, sizeof *c, n);
  *c = (struct course){.n = n};
  if (luaL_newmetatable(L, COURSE_TYPE)) {
    luaL_newlib(L, methods);
    lua_setfield(L, -2, "__index");
  }
  lua_setmetatable(L, -2);
  for (int i = 0; i < n; i++) {
    if (lua_rawgeti(L, 1, i + 1) == LUA_TTABLE)
      read_input(L, &c->input[i]);
    lua_setiuservalue(L, -2, i + 1);
  }
  return 1;
}

const struct course *course_at(lua_State *L, int index, int n, struct course *own) {
  const struct course *c = luaL_testudata(L, index, COURSE_TYPE);
  luaL_argcheck(L, n <= COURSE_INPUTS && (c == NULL || c->n == n), index,
                "another number of inputs");
  if (c != NULL)
    return c;
  double u[COURSE_INPUTS];
  fields_optional(L, index, n, u);
  own->n = n;
  for (int i = 0; i < n; i++)
    own->input[i] = (struct course_input){.constant = u[i]};
  return own;
}

/* ---- over time ---- */

int course_linear(const struct course *c) {
  int any = 0;
  for (int i = 0; i < c->n; i++)
    any |= c->input[i].kind == COURSE_LINEAR;
  return any;
}

/* How many values there are up to t (`strictly`: before t): near the last answer, or by halving. */
static size_t values_to(const struct course_input *in, double t, int strictly) {
  size_t low = 0, high = in->rows;
  for (size_t tried = 0; low < high; tried++) {
    const size_t i = *in->near - 1 + tried; /* behind all values where it is 0 - 1 */
    const size_t at = tried < 3 && i >= low && i < high ? i : low + (high - low) / 2;
    if (strictly ? in->t[at] < t : in->t[at] <= t)
      low = at + 1;
    else
      high = at;
  }
  if (in->rows > 0)
    *in->near = low;
  return low;
}

/* The slope of the line from the value before number i to that value. */
static double slope(const struct course_input *in, size_t i) {
  return (in->u[i] - in->u[i - 1]) / (in->t[i] - in->t[i - 1]);
}

/* The break of an input that is next after t, or next before it; infinite: there is none. */
static double break_of(const struct course_input *in, double t, int back) {
  const size_t i = values_to(in, t, back);
  const double none = (double)INFINITY;
  double found = back ? (i > 0 ? in->t[i - 1] : -none) : i < in->rows ? in->t[i] : none;
  if (in->kind != COURSE_LINEAR || i == 0 || i == in->rows)
    return found;
  const double limit[2] = {in->low, in->high}, rise = slope(in, i);
  for (int k = 0; k < 2 && rise != 0; k++) {
    const double at = in->t[i - 1] + (limit[k] - in->u[i - 1]) / rise;
    if (back ? at < t && at > found : at > t && at < found)
      found = at;
  }
  return found;
}

double course_next(const struct course *c, double t, double end) {
  const int back = end < t;
  for (int i = 0; i < c->n; i++) {
    const double at = break_of(&c->input[i], t, back);
    end = back ? fmax(end, at) : fmin(end, at);
  }
  return end;
}

void course_segment(const struct course *c, double from, double to, struct course_segment *s) {
  const double middle = from + (to - from) / 2;
  for (int k = 0; k < c->n; k++) {
    const struct course_input *in = &c->input[k];
    const size_t i = values_to(in, middle, 0), first = i > 0 ? i - 1 : 0;
    const double rise = in->kind != COURSE_HELD && i > 0 && i < in->rows ? slope(in, i) : 0;
    s->since[k] = in->rows > 0 ? in->t[first] : 0;
    s->base[k] = in->kind == COURSE_SLOPE ? rise : in->rows > 0 ? in->u[first] : in->constant;
    s->slope[k] = in->kind == COURSE_SLOPE ? 0 : rise;
  }
}

void course_value(const struct course_segment *s, int n, double t, double u[]) {
  for (int k = 0; k < n; k++)
    u[k] = s->base[k] + s->slope[k] * (t - s->since[k]);
}
