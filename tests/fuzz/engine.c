/* engine.c - fuzz target: bytes through the program's own Lua, in this process.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * What main.c does for one run, done for many: one Lua state with the embedded generator and the
 * host's functions; tests/fuzz/engine.lua says what a case is (-DFUZZ_MODE: scene, table, robot,
 * command) and what of the outcome is a finding.  A finding is printed and ends in abort(), as do
 * an error nobody caught (the program's status 70) and a case of more than CPU seconds.
 *
 * Lua's own code is not instrumented, so a hook counts into libFuzzer's extra counters
 * (-DFUZZ_COVERAGE) what the generator executes: lines while a scene is read, in the sandbox, and
 * functions in the algebra that follows, which is most of the time.
 */
#include "../../src/cli/host/host.h"
#include "../../src/cli/rational/rational.h"
#include "../../src/cli/host/script.h"
#include "fuzz.h"

#include <lualib.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/time.h>
#include <unistd.h>

#define CASES 500                 /* then a new Lua state: what one case leaves shall not pile up */
#define LIVE  ((size_t)200 << 20) /* or earlier, with so much alive */
#define CPU   20                  /* s of processor time for one case, sanitizers included */

static struct account account;
static lua_State *state;
static int cases;

/* ---- hooks: the sandbox's own and the counter of lines ---- */

static lua_Hook inner;

#ifdef FUZZ_COVERAGE
__attribute__((section("__libfuzzer_extra_counters"))) static uint8_t lines[1 << 15];

static void count_place(lua_State *L, lua_Debug *ar) {
  uint32_t hash = 2166136261u;
  lua_getinfo(L, "S", ar);
  if (strncmp(ar->short_src, "generator/", 10) != 0)
    return;
  for (const char *s = ar->short_src + 10; *s != '\0'; s++)
    hash = (hash ^ (unsigned char)*s) * 16777619u;
  const int line = ar->event == LUA_HOOKLINE ? ar->currentline : ar->linedefined;
  hash = (hash + (uint32_t)line) * 2654435761u;
  uint8_t *c = &lines[hash >> 17];
  *c = (uint8_t)(*c + (*c < 255));
}

static void outer(lua_State *L, lua_Debug *ar) {
  if (ar->event != LUA_HOOKCOUNT)
    count_place(L, ar);
  else if (inner != NULL)
    inner(L, ar);
}
#endif

void fuzz_sethook(lua_State *L, lua_Hook hook, int mask, int count) {
  inner = hook;
#ifdef FUZZ_COVERAGE
  lua_sethook(L, outer, mask | (hook != NULL ? LUA_MASKLINE : LUA_MASKCALL), count);
#else
  lua_sethook(L, hook, mask, count);
#endif
}

/* ---- the state ---- */

static const luaL_Reg libraries[] = {
    {LUA_GNAME, luaopen_base},       {LUA_COLIBNAME, luaopen_coroutine},
    {LUA_TABLIBNAME, luaopen_table}, {LUA_STRLIBNAME, luaopen_string},
    {LUA_MATHLIBNAME, luaopen_math}, {LUA_UTF8LIBNAME, luaopen_utf8},
    {LUA_DBLIBNAME, luaopen_debug},  {LUA_LOADLIBNAME, luaopen_package},
};

static int traceback(lua_State *L) {
  luaL_traceback(L, L, luaL_tolstring(L, 1, NULL), 1);
  return 1;
}

/* Protected: leaves engine.lua's function as the registry's "case". */
static int open_state(lua_State *L) {
  for (size_t i = 0; i < sizeof libraries / sizeof libraries[0]; i++) {
    luaL_requiref(L, libraries[i].name, libraries[i].func, 1);
    lua_pop(L, 1);
  }
  lua_getglobal(L, LUA_LOADLIBNAME);
  script_open(L);
  lua_getfield(L, -1, "preload");
  lua_pushcfunction(L, luaopen_polhode_rational);
  lua_setfield(L, -2, "polhode_rational");
  lua_settop(L, 0);
  if (luaL_loadfile(L, fuzz_path("engine.lua")) != LUA_OK)
    return lua_error(L);
  host_push(L);
  lua_pushliteral(L, FUZZ_MODE);
  lua_pushstring(L, getenv("FUZZ_PLANT"));
  lua_call(L, 3, 1);
  lua_setfield(L, LUA_REGISTRYINDEX, "case");
  return 0;
}

static void renew(void) {
  if (state != NULL)
    lua_close(state);
  account = (struct account){0, ACCOUNT_LIMIT};
  account_open(&account);
  state = lua_newstate(account_allocate, &account);
  if (state == NULL)
    fuzz_finding("no Lua state");
  lua_pushcfunction(state, traceback);
  lua_pushcfunction(state, open_state);
  if (lua_pcall(state, 0, 0, 1) != LUA_OK)
    fuzz_finding("%s", lua_tostring(state, -1));
  lua_settop(state, 0);
  cases = 0;
}

/* ---- a case ---- */

static void too_long(int number) {
  (void)number;
  static const char text[] = "FINDING: more processor time than a case may take\n";
  ssize_t ignored = write(STDERR_FILENO, text, sizeof text - 1);
  (void)ignored;
  abort();
}

static void guard(int seconds) {
  struct itimerval timer = {.it_value.tv_sec = seconds};
  signal(SIGPROF, too_long);
  setitimer(ITIMER_PROF, &timer, NULL);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  if (state == NULL || cases++ >= CASES || account.used > LIVE)
    renew();
  lua_State *L = state;
  guard(CPU);
  fuzz_sethook(L, NULL, 0, 0);
  lua_pushcfunction(L, traceback);
  lua_getfield(L, LUA_REGISTRYINDEX, "case");
  lua_pushlstring(L, (const char *)data, size);
  if (lua_pcall(L, 1, 1, 1) != LUA_OK)
    fuzz_finding("internal error: %s", lua_tostring(L, -1));
  if (!lua_isnil(L, -1))
    fuzz_finding("%s", lua_tostring(L, -1));
  lua_settop(L, 0);
  lua_sethook(L, NULL, 0, 0);
  if (account.used > LIVE / 4)
    lua_gc(L, LUA_GCCOLLECT);
  guard(0);
  return 0;
}
