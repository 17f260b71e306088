/* main.c - the program polhode: a Lua state, the generator inside it, an exit status.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * All logic of the command line is generator/main.lua, a function main(host, args) that returns the
 * exit status.  Here are only the state with the libraries that a generator of text needs (no io,
 * no os, no bytecode, no C modules from outside) and the promise that an error nobody caught ends
 * in a traceback and status 70, and that a failed write never ends in status 0.
 */
#include "host/host.h"
#include "rational/rational.h"
#include "host/script.h"

#include <fcntl.h>
#include <lualib.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

static void open_libraries(lua_State *L) {
  static const luaL_Reg libraries[] = {
      {LUA_GNAME, luaopen_base},       {LUA_COLIBNAME, luaopen_coroutine},
      {LUA_TABLIBNAME, luaopen_table}, {LUA_STRLIBNAME, luaopen_string},
      {LUA_MATHLIBNAME, luaopen_math}, {LUA_UTF8LIBNAME, luaopen_utf8},
      {LUA_DBLIBNAME, luaopen_debug},  {LUA_LOADLIBNAME, luaopen_package},
  };
  for (size_t i = 0; i < sizeof libraries / sizeof libraries[0]; i++) {
    luaL_requiref(L, libraries[i].name, libraries[i].func, 1);
    lua_pop(L, 1);
  }
  lua_getglobal(L, LUA_LOADLIBNAME);
  script_open(L);
  lua_getfield(L, -1, "preload");
  lua_pushcfunction(L, luaopen_polhode_rational);
  lua_setfield(L, -2, "polhode_rational");
  lua_pop(L, 2);
  /* what opens files, and what writes past host.out */
  static const char *const gone[] = {"dofile", "loadfile", "print"};
  for (size_t i = 0; i < sizeof gone / sizeof gone[0]; i++) {
    lua_pushnil(L);
    lua_setglobal(L, gone[i]);
  }
}

/* Random points of the equality oracle must be the same in every run: Lua 5.4 seeds from the
 * clock. */
static void fix_random_seed(lua_State *L) {
  lua_getglobal(L, "math");
  lua_getfield(L, -1, "randomseed");
  lua_pushinteger(L, 1758); /* Euler, on the motion of rigid bodies */
  lua_call(L, 1, 0);
  lua_pop(L, 1);
}

static int traceback(lua_State *L) {
  const char *message = lua_tostring(L, 1);
  if (message == NULL && luaL_callmeta(L, 1, "__tostring") && lua_isstring(L, -1))
    message = lua_tostring(L, -1);
  if (message == NULL)
    message = lua_pushfstring(L, "error object is a %s value", luaL_typename(L, 1));
  luaL_traceback(L, L, message, 1);
  return 1;
}

/* Protected: (argc, argv) -> exit status of the generator. */
static int run(lua_State *L) {
  const int argc = (int)lua_tointeger(L, 1);
  char **argv = lua_touserdata(L, 2);
  open_libraries(L);
  fix_random_seed(L);
  lua_getglobal(L, "require");
  lua_pushliteral(L, "generator.main");
  lua_call(L, 1, 1);
  host_push(L);
  lua_createtable(L, argc, 0);
  for (int i = 1; i < argc; i++) {
    lua_pushstring(L, argv[i]);
    lua_rawseti(L, -2, i);
  }
  lua_call(L, 2, 1);
  if (!lua_isinteger(L, -1))
    return luaL_error(L, "generator.main returned no exit status");
  return 1;
}

/* A descriptor that the caller has closed must not become that of a file: what is meant for the
   terminal would be written there. Nothing can be written to what stands in its place. */
static void fill_descriptors(void) {
  for (int fd = STDIN_FILENO; fd <= STDERR_FILENO; fd++)
    if (fcntl(fd, F_GETFD) < 0 && open("/dev/null", O_RDONLY) != fd)
      _exit(HOST_EXIT_OUTPUT);
}

int main(int argc, char **argv) {
  fill_descriptors();
  struct account account = {.limit = ACCOUNT_LIMIT};
  account_open(&account);
  lua_State *L = lua_newstate(account_allocate, &account);
  if (L == NULL) {
    fputs("polhode: not enough memory\n", stderr);
    return HOST_EXIT_BUG;
  }
  /* a run lasts a tenth of a second and keeps most of what it makes: collect rarely, and not before
     the first 24 MiB: a negative step puts off the next collection */
  lua_gc(L, LUA_GCINC, 1000, 100, 0);
  lua_gc(L, LUA_GCSTEP, -(24 << 10));
  interrupt_watch(L);
  lua_pushcfunction(L, traceback);
  lua_pushcfunction(L, run);
  lua_pushinteger(L, argc);
  lua_pushlightuserdata(L, argv);
  int status = HOST_EXIT_BUG;
  if (lua_pcall(L, 2, 1, 1) == LUA_OK)
    status = (int)lua_tointeger(L, -1);
  else if (!interrupt_pending())
    fprintf(stderr, "polhode: internal error: %s\n", lua_tostring(L, -1));
  lua_sethook(L, NULL, 0, 0); /* an interrupt's hook must not stop finalizers */
  /* giving a pool back block by block is a tenth of a run; where a tool looks for leaks there is no
     pool */
  if (account.pooled == 0)
    lua_close(L);
  tempdir_remove_all();
  const int output = output_finish();
  interrupt_resume();
  return status != 0 ? status : output;
}
