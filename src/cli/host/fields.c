/* fields.c - fields of Lua tables as numbers, truths and lists, and the way back.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "fields.h"

#include <lauxlib.h>
#include <math.h>
#include <string.h>

/* Raises: field 'mass': number expected, got nil. */
static void wrong(lua_State *L, const char *key, const char *what) {
  luaL_error(L, "field '%s': %s expected, got %s", key, what, luaL_typename(L, -1));
}

int fields_has(lua_State *L, int index, const char *key) {
  const int type = lua_getfield(L, index, key);
  lua_pop(L, 1);
  return type != LUA_TNIL;
}

double fields_number(lua_State *L, int index, const char *key) {
  if (lua_getfield(L, index, key) != LUA_TNUMBER)
    wrong(L, key, "number");
  const double x = lua_tonumber(L, -1);
  lua_pop(L, 1);
  return x;
}

double fields_option(lua_State *L, int index, const char *key, double standard) {
  return fields_has(L, index, key) ? fields_number(L, index, key) : standard;
}

double fields_positive(lua_State *L, int index, const char *key, double standard) {
  const double x = fields_option(L, index, key, standard);
  if (!(x > 0) || x == HUGE_VAL)
    luaL_error(L, "%s: a positive number is needed", key);
  return x;
}

int fields_flag(lua_State *L, int index, const char *key) {
  const int type = lua_getfield(L, index, key), yes = lua_toboolean(L, -1);
  if (type != LUA_TNIL && type != LUA_TBOOLEAN)
    wrong(L, key, "boolean");
  lua_pop(L, 1);
  return yes;
}

void fields_list(lua_State *L, int index, int n, double out[]) {
  luaL_checktype(L, index, LUA_TTABLE);
  index = lua_absindex(L, index);
  for (int i = 0; i < n; i++) {
    if (lua_geti(L, index, i + 1) != LUA_TNUMBER)
      luaL_error(L, "a list of %d numbers expected; entry %d is a %s", n, i + 1,
                 luaL_typename(L, -1));
    out[i] = lua_tonumber(L, -1);
    lua_pop(L, 1);
  }
}

void fields_get(lua_State *L, int index, const char *key, int n, double out[],
                const double standard[]) {
  if (lua_getfield(L, index, key) == LUA_TNIL && standard != NULL)
    memcpy(out, standard, (size_t)n * sizeof out[0]);
  else if (lua_istable(L, -1))
    fields_list(L, -1, n, out);
  else
    wrong(L, key, "list of numbers");
  lua_pop(L, 1);
}

int fields_some(lua_State *L, int index, const char *key, double out[], int most) {
  const int there = lua_getfield(L, index, key) != LUA_TNIL;
  if (there && !lua_istable(L, -1))
    wrong(L, key, "list of numbers");
  const lua_Unsigned n = there ? lua_rawlen(L, -1) : 0;
  if (n > (lua_Unsigned)most)
    luaL_error(L, "field '%s': more than %d numbers", key, most);
  if (there)
    fields_list(L, -1, (int)n, out);
  lua_pop(L, 1);
  return (int)n;
}

void fields_optional(lua_State *L, int index, int n, double out[]) {
  memset(out, 0, (size_t)n * sizeof out[0]);
  if (n > 0 && !lua_isnoneornil(L, index) && lua_rawlen(L, index) > 0)
    fields_list(L, index, n, out);
}

void fields_push(lua_State *L, int n, const double v[]) {
  lua_createtable(L, n, 0);
  for (int i = 0; i < n; i++) {
    lua_pushnumber(L, v[i]);
    lua_rawseti(L, -2, i + 1);
  }
}

void fields_set_number(lua_State *L, const char *key, double x) {
  lua_pushnumber(L, x);
  lua_setfield(L, -2, key);
}

void fields_set_count(lua_State *L, const char *key, lua_Integer n) {
  lua_pushinteger(L, n);
  lua_setfield(L, -2, key);
}

void fields_set_flag(lua_State *L, const char *key, int yes) {
  lua_pushboolean(L, yes);
  lua_setfield(L, -2, key);
}

void fields_set_list(lua_State *L, const char *key, const double v[], int n) {
  fields_push(L, n, v);
  lua_setfield(L, -2, key);
}
