/* sandbox.c - running a scene, which is data that someone may have sent.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A scene sees the environment that it is given and nothing else, and runs within bounds
 * (bounds.c). The environment (safe.lua) holds no C function that could be stuck, so that the
 * watchdog there is a second lock, not the first.
 */
#include "bounds.h"

#include <stdio.h>
#include <string.h>

/* Honest scenes run for some milliseconds. */
static const struct bounds usual = {(lua_Integer)24 << 20, 50000000, 0, 1.0, "the scene"};

/* The scene that runs. */
static struct {
  int loading;
  char last_words[512];    /* what is said when nothing else can be */
  const char *chunk;       /* the scene's chunk name, and */
  char source[LUA_IDSIZE]; /* how messages show it */
} box;

/* ---- describing what went wrong ---- */

/* Field "line" of the table on top: the innermost line of the scene that is running. And "source":
   where the error was raised, which tells a wrong scene from a bug in the generator. */
static void describe_stack(lua_State *L) {
  lua_Debug ar;
  int have_source = 0, have_line = 0;
  for (int level = 1; !(have_source && have_line) && lua_getstack(L, level, &ar); level++) {
    lua_getinfo(L, "Sl", &ar);
    if (ar.currentline < 0)
      continue; /* a C function */
    if (!have_source) {
      lua_pushstring(L, ar.short_src);
      lua_setfield(L, -2, "source");
      have_source = 1;
    }
    if (strcmp(ar.source, box.chunk) == 0) {
      lua_pushinteger(L, ar.currentline);
      lua_setfield(L, -2, "line");
      have_line = 1;
    }
  }
}

/* Skip "source:12: " at the head of text; 0 when it does not begin so, else the line. */
static int skip_place(const char **text, const char *source) {
  const size_t n = strlen(source);
  int line = 0, used = 0;
  if (strncmp(*text, source, n) != 0 || sscanf(*text + n, ":%9d: %n", &line, &used) != 1 ||
      used == 0)
    return 0;
  *text += n + (size_t)used;
  return line;
}

/* Fields "message" and, when the text begins with a place in the scene, "line" of the table on
 * top. */
static void describe_text(lua_State *L, const char *text) {
  const int line = skip_place(&text, box.source);
  if (line > 0) {
    lua_pushinteger(L, line);
    lua_setfield(L, -2, "line");
  } else {
    skip_place(&text,
               "src/cli/sandbox/safe.lua"); /* to the scene it is a library function, not a place */
  }
  lua_pushstring(L, text);
  lua_setfield(L, -2, "message");
}

/* Push the table for the error value at `index`. */
static void describe(lua_State *L, int index, const char *kind) {
  lua_newtable(L);
  lua_pushstring(L, kind);
  lua_setfield(L, -2, "kind");
  lua_pushvalue(L, index);
  lua_setfield(L, -2, "value");
  describe_stack(L);
  if (lua_type(L, index) == LUA_TSTRING || lua_type(L, index) == LUA_TNUMBER) {
    lua_pushvalue(L, index); /* a copy: lua_tostring changes a number in place */
    lua_insert(L, -2);
    describe_text(L, lua_tostring(L, -2));
    lua_remove(L, -2);
  } else {
    lua_pushfstring(L, "error object is a %s value", luaL_typename(L, index));
    lua_setfield(L, -2, "message");
  }
}

/* By enum bound. */
static const char *const kinds[] = {"runtime", "memory", "steps", "turnover", "time"};

/* Message handler: the error's value -> its table. Nothing of the scene runs any more from here
 * on. */
static int handler(lua_State *L) {
  if (bounds_unwinding()) /* the parser's error, on its way through load_and_call: has its table */
    return 1;
  bounds_unwind(L);
  const enum bound passed = bounds_passed();
  describe(L, 1, passed == BOUND_NONE && box.loading ? "syntax" : kinds[passed]);
  luaL_traceback(L, L, NULL, 1);
  lua_setfield(L, -2, "traceback");
  return 1;
}

/* ---- running ---- */

/* box.source = how messages show a chunk of this name. */
static void name_chunk(lua_State *L, const char *chunk) {
  lua_Debug ar;
  if (luaL_loadbufferx(L, "", 0, chunk, "t") != LUA_OK)
    lua_error(L);
  lua_getinfo(L, ">S", &ar);
  memcpy(box.source, ar.short_src, sizeof box.source);
}

static void prepare(lua_State *L, const char *chunk, const struct bounds *b) {
  box.chunk = chunk;
  box.loading = 0;
  name_chunk(L, chunk);
  snprintf(box.last_words, sizeof box.last_words, "polhode: %s: the scene ran longer than %g s\n",
           box.source, b->seconds);
}

/* A scene may write into string, math, table: give it copies of those of `safe` (upvalue 1). */
static void copy_libraries(lua_State *L, int env) {
  static const char *const names[] = {"string", "math", "table"};
  for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
    lua_pushstring(L, names[i]);
    lua_rawget(L, env);
    lua_getfield(L, lua_upvalueindex(1), names[i]);
    if (lua_istable(L, -1) && lua_rawequal(L, -1, -2)) {
      lua_newtable(L);
      for (lua_pushnil(L); lua_next(L, -3); lua_pop(L, 1)) {
        lua_pushvalue(L, -2);
        lua_pushvalue(L, -2);
        lua_rawset(L, -5);
      }
      lua_pushstring(L, names[i]);
      lua_insert(L, -2);
      lua_rawset(L, env);
    }
    lua_pop(L, 2);
  }
}

static int call_upvalue(lua_State *L) {
  lua_pushvalue(L, lua_upvalueindex(1));
  lua_insert(L, 1);
  lua_call(L, lua_gettop(L) - 1, LUA_MULTRET);
  return lua_gettop(L);
}

int sandbox_visible(lua_State *L) {
  luaL_checktype(L, 1, LUA_TFUNCTION);
  lua_settop(L, 1);
  if (!lua_iscfunction(L, 1))
    lua_pushcclosure(L, call_upvalue, 1);
  return 1;
}

/* The functions that the scene language put into env. */
static void make_visible(lua_State *L, int env) {
  for (lua_pushnil(L); lua_next(L, env);) {
    if (lua_isfunction(L, -1) && !lua_iscfunction(L, -1)) {
      lua_pushvalue(L, -2);
      lua_insert(L, -2);
      lua_pushcclosure(L, call_upvalue, 1);
      lua_rawset(L, env); /* an existing field: allowed while traversing */
    } else {
      lua_pop(L, 1);
    }
  }
}

/* Protected: (text, chunk name, env) -> the scene's results. */
static int load_and_call(lua_State *L) {
  size_t size;
  const char *text = lua_tolstring(L, 1, &size);
  box.loading = 1;
  if (luaL_loadbufferx(L, text, size, lua_tostring(L, 2), "t") != LUA_OK)
    return lua_error(L);
  box.loading = 0;
  lua_pushvalue(L, 3);
  lua_setupvalue(L, -2, 1); /* the only upvalue of a main chunk is _ENV */
  lua_call(L, 0, LUA_MULTRET);
  return lua_gettop(L) - 3;
}

/* Load and call under the bounds; the stack holds (text, chunk name, env, limits). Afterwards the
   results, or the error's table, are above them. A status of Lua's. */
static int run_bounded(lua_State *L, const struct bounds *b) {
  lua_pushcfunction(L, handler);
  lua_pushcfunction(L, load_and_call);
  for (int i = 1; i <= 3; i++)
    lua_pushvalue(L, i);
  bounds_begin(L, b, box.last_words);
  const int status = lua_pcall(L, 3, LUA_MULTRET, 5);
  bounds_end(L);
  lua_remove(L, 5);
  return status;
}

/* The table for a failure that the handler has not described: what it is instead of. */
static void describe_late(lua_State *L, int status) {
  const int value = lua_gettop(L);
  const enum bound passed = status == LUA_ERRMEM ? BOUND_MEMORY : bounds_passed();
  if (passed == BOUND_MEMORY)
    lua_gc(L, LUA_GCCOLLECT);
  if (passed != BOUND_NONE) {
    bounds_push(L, passed);
    describe(L, lua_gettop(L), kinds[passed]);
  } else {
    describe(L, value, box.loading ? "syntax" : "runtime");
  }
  lua_pushnil(L);
  lua_setfield(L, -2, "source"); /* the stack that describe_stack saw is our caller's */
}

int host_sandbox(lua_State *L) {
  struct bounds b = usual;
  luaL_checktype(L, 1, LUA_TSTRING);
  const char *chunk = luaL_checkstring(L, 2);
  luaL_checktype(L, 3, LUA_TTABLE);
  lua_settop(L, 4);
  if (bounds_active())
    return luaL_error(L, "sandbox: one scene at a time");
  bounds_read(L, 4, &b);
  prepare(L, chunk, &b);
  copy_libraries(L, 3);
  make_visible(L, 3);
  const int status = run_bounded(L, &b);
  if (status == LUA_OK && bounds_passed() == BOUND_NONE) {
    lua_pushboolean(L, 1);
    lua_insert(L, 5);
    return lua_gettop(L) - 4;
  }
  if (status == LUA_OK || !lua_istable(L, -1) || !bounds_unwinding())
    describe_late(L, status);
  lua_pushboolean(L, 0);
  lua_insert(L, -2);
  return 2;
}
