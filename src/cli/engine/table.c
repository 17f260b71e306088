/* table.c - fields of Lua tables as numbers, and blocks that live as long as the scene's table.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "engine.h"

#include <string.h>

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

double engine_number(lua_State *L, const char *key) {
  if (lua_getfield(L, -1, key) != LUA_TNUMBER)
    luaL_error(L, "field '%s': number expected, got %s", key, luaL_typename(L, -1));
  const double x = lua_tonumber(L, -1);
  lua_pop(L, 1);
  return x;
}

int engine_has(lua_State *L, const char *key) {
  const int type = lua_getfield(L, -1, key);
  lua_pop(L, 1);
  return type != LUA_TNIL;
}

void engine_keep(struct engine_scene *s) {
  lua_State *L = s->L;
  if (lua_getfield(L, s->index, "memory") == LUA_TNIL) {
    lua_pop(L, 1);
    lua_newtable(L);
    lua_pushvalue(L, -1);
    lua_setfield(L, s->index, "memory");
  }
  lua_insert(L, -2);
  lua_rawseti(L, -2, (lua_Integer)lua_rawlen(L, -2) + 1);
  lua_pop(L, 1);
}
