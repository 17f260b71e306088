/* engine_body.c - a tree of shapes and placements, as Lua tables, into a body of the library.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Recursion follows the tree; its depth is bounded because a scene decides it.
 */
#include "engine.h"

#include <stdlib.h>
#include <string.h>

#define MAX_DEPTH 1000

static const double zero[3] = {0, 0, 0};

void engine_list(lua_State *L, int index, int n, double out[]) {
  luaL_checktype(L, index, LUA_TTABLE);
  index = lua_absindex(L, index);
  for (int i = 0; i < n; i++) {
    lua_geti(L, index, i + 1);
    if (lua_type(L, -1) != LUA_TNUMBER)
      luaL_error(L, "a list of %d numbers expected; entry %d is a %s", n, i + 1,
                 luaL_typename(L, -1));
    out[i] = lua_tonumber(L, -1);
    lua_pop(L, 1);
  }
}

void engine_get(lua_State *L, int index, const char *key, int n, double out[],
                const double standard[]) {
  if (lua_getfield(L, index, key) == LUA_TNIL && standard != NULL)
    memcpy(out, standard, (size_t)n * sizeof out[0]);
  else if (lua_istable(L, -1))
    engine_list(L, -1, n, out);
  else
    luaL_error(L, "field '%s': %d numbers expected, got %s", key, n, luaL_typename(L, -1));
  lua_pop(L, 1);
}

void engine_push(lua_State *L, int n, const double v[]) {
  lua_createtable(L, n, 0);
  for (int i = 0; i < n; i++) {
    lua_pushnumber(L, v[i]);
    lua_rawseti(L, -2, i + 1);
  }
}

int engine_fail(const struct engine_scene *s, int status) {
  lua_pushnil(s->L);
  lua_pushfstring(s->L, "%s: %s", s->where, ph_status_phrase(status));
  return 2;
}

/* A number from a field of the table on top. */
static double number(lua_State *L, const char *key) {
  if (lua_getfield(L, -1, key) != LUA_TNUMBER)
    luaL_error(L, "field '%s': number expected, got %s", key, luaL_typename(L, -1));
  const double x = lua_tonumber(L, -1);
  lua_pop(L, 1);
  return x;
}

static int has(lua_State *L, const char *key) {
  const int type = lua_getfield(L, -1, key);
  lua_pop(L, 1);
  return type != LUA_TNIL;
}

/* ---- shapes ---- */

/* The arguments' names of a shape in the library's catalogue, NULL when it has none of that name.
 */
static const char *arguments_of(const char *name) {
  for (int i = 0; ph_shape_name(i) != NULL; i++)
    if (strcmp(ph_shape_name(i), name) == 0)
      return ph_shape_arguments(i);
  return NULL;
}

static int read_catalogued(struct engine_scene *s, const char *name, ph_body *out) {
  lua_State *L = s->L;
  const char *names = arguments_of(name);
  double argument[16];
  int count = 0;
  if (names == NULL)
    return PH_ENAME;
  const ph_amount amount = has(L, "density") ? ph_amount_density(number(L, "density"))
                                             : ph_amount_mass(number(L, "mass"));
  if (strcmp(name, "rod.between") == 0) {
    engine_get(L, -1, "from", 3, argument, NULL);
    engine_get(L, -1, "to", 3, argument + 3, NULL);
    count = 6;
    names = "";
  }
  while (*names != '\0' && count < 16) {
    const size_t n = strcspn(names, " ");
    const char *key = lua_pushlstring(L, names, n);
    lua_insert(L, -2);
    argument[count++] = number(L, key);
    lua_remove(L, -2);
    names += n + strspn(names + n, " ");
  }
  return ph_shape_make(out, name, amount, argument, count);
}

static int read_points(struct engine_scene *s, ph_body *out) {
  lua_State *L = s->L;
  if (lua_getfield(L, -1, "list") != LUA_TTABLE)
    luaL_error(L, "points: field 'list' is missing");
  const int n = (int)lua_rawlen(L, -1);
  /* one block of Lua's, so that an error in the list leaks nothing: n masses, then n places */
  double *m = lua_newuserdatauv(L, ((size_t)n * 4 + 1) * sizeof(double), 0);
  double *r = m + n;
  for (int i = 0; i < n; i++) {
    double row[4];
    lua_rawgeti(L, -2, i + 1);
    engine_list(L, -1, 4, row);
    lua_pop(L, 1);
    m[i] = row[0];
    memcpy(r + 3 * i, row + 1, 3 * sizeof row[0]);
  }
  const int status = ph_body_points(out, n, m, r);
  lua_pop(L, 2);
  return status;
}

static int read_tensor(struct engine_scene *s, ph_body *out) {
  static const char *const entry[6] = {"xx", "yy", "zz", "xy", "xz", "yz"};
  lua_State *L = s->L;
  double com[3], tensor[6];
  const double mass = number(L, "mass");
  engine_get(L, -1, "com", 3, com, zero);
  for (int i = 0; i < 6; i++)
    tensor[i] = i < 3 || has(L, entry[i]) ? number(L, entry[i]) : 0.0;
  lua_getfield(L, -1, "about");
  const int origin = strcmp(luaL_optstring(L, -1, "com"), "origin") == 0;
  lua_pop(L, 1);
  return origin ? ph_body_tensor_origin(out, mass, com, tensor)
                : ph_body_tensor(out, mass, com, tensor);
}

static int read_shape(struct engine_scene *s, const char *name, ph_body *out) {
  s->where = name;
  if (strcmp(name, "points") == 0)
    return read_points(s, out);
  if (strcmp(name, "tensor") == 0)
    return read_tensor(s, out);
  return read_catalogued(s, name, out);
}

/* ---- operations ---- */

static int read_tree(struct engine_scene *s, ph_body *out, int depth);

static int read_placed(struct engine_scene *s, const char *op, ph_body *out, int depth) {
  lua_State *L = s->L;
  double v[4];
  lua_getfield(L, -1, "of");
  const int status = read_tree(s, out, depth);
  lua_pop(L, 1);
  if (status != PH_OK)
    return status;
  s->where = op;
  if (strcmp(op, "at") == 0) {
    engine_get(L, -1, "r", 3, v, NULL);
    return ph_body_at(out, out, v);
  }
  if (strcmp(op, "turned") == 0) {
    engine_get(L, -1, "q", 4, v, NULL);
    return ph_body_turned(out, out, v);
  }
  engine_get(L, -1, "k", 3, v, NULL);
  return ph_body_scaled(out, out, v);
}

static int read_combined(struct engine_scene *s, const char *op, ph_body *out, int depth) {
  lua_State *L = s->L;
  const int minus = strcmp(op, "minus") == 0, n = (int)lua_rawlen(L, -1);
  if (n < 1 || (minus && n != 2))
    luaL_error(L, "%s: wrong number of operands", op);
  for (int i = 1; i <= n; i++) {
    ph_body part;
    lua_rawgeti(L, -1, i);
    int status = read_tree(s, i == 1 ? out : &part, depth);
    lua_pop(L, 1);
    if (status == PH_OK && i > 1) {
      s->where = op;
      status = minus ? ph_body_subtract(out, out, &part) : ph_body_add(out, out, &part);
    }
    if (status != PH_OK)
      return status;
  }
  return PH_OK;
}

/* The tree on the stack's top, which stays. */
static int read_tree(struct engine_scene *s, ph_body *out, int depth) {
  static const char *const operations[] = {"at", "turned", "scaled", "sum", "minus", NULL};
  lua_State *L = s->L;
  int status = PH_OK;
  luaL_checkstack(L, 12, "body tree");
  if (depth > MAX_DEPTH || !lua_istable(L, -1))
    luaL_error(L,
               depth > MAX_DEPTH ? "body tree: deeper than %d" : "body tree: no table at depth %d",
               depth > MAX_DEPTH ? MAX_DEPTH : depth);
  if (lua_getfield(L, -1, "shape") == LUA_TSTRING) {
    const char *name = lua_tostring(L, -1); /* stays alive in the tree */
    lua_pop(L, 1);
    return read_shape(s, name, out);
  }
  lua_pop(L, 1);
  lua_getfield(L, -1, "op");
  const int op = luaL_checkoption(L, -1, NULL, operations);
  lua_pop(L, 1);
  if (op < 3)
    status = read_placed(s, operations[op], out, depth + 1);
  else
    status = read_combined(s, operations[op], out, depth + 1);
  return status;
}

int engine_read_body(struct engine_scene *s, ph_body *out) {
  const int status = read_tree(s, out, 0);
  lua_pop(s->L, 1);
  return status;
}
