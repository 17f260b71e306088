/* body.c - a tree of placements and sums, as Lua tables, into a body of the library.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Recursion follows the tree; its depth is bounded because a scene decides it.
 */
#include "engine.h"

#include <string.h>

#define MAX_DEPTH 1000

static int read_tree(struct engine_scene *s, ph_body *out, int depth);

static int read_placed(struct engine_scene *s, const char *op, ph_body *out, int depth) {
  lua_State *L = s->L;
  double v[9];
  lua_getfield(L, -1, "of");
  const int status = read_tree(s, out, depth);
  lua_pop(L, 1);
  if (status != PH_OK)
    return status;
  s->where = op;
  if (strcmp(op, "at") == 0) {
    fields_get(L, -1, "r", 3, v, NULL);
    return ph_body_at(out, out, v);
  }
  if (strcmp(op, "turned") == 0) {
    fields_get(L, -1, "q", 4, v, NULL);
    return ph_body_turned(out, out, v);
  }
  if (strcmp(op, "affine") == 0) {
    fields_get(L, -1, "A", 9, v, NULL);
    return ph_body_affine(out, out, v);
  }
  fields_get(L, -1, "k", 3, v, NULL);
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
  static const char *const operations[] = {"at",  "turned", "scaled", "affine",
                                           "sum", "minus",  NULL};
  enum { PLACEMENTS = 4 };
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
    s->where = name;
    return engine_read_shape(s, name, out);
  }
  lua_pop(L, 1);
  lua_getfield(L, -1, "op");
  const int op = luaL_checkoption(L, -1, NULL, operations);
  lua_pop(L, 1);
  if (op < PLACEMENTS)
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
