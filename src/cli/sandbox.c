/* sandbox.c - running a scene, which is data that someone may have sent.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A scene sees the environment that it is given and nothing else; it is bounded in three ways:
 *   memory   the allocator refuses beyond a limit above what is in use at the start;
 *   steps    a count hook every PERIOD virtual instructions, and
 *   seconds  an alarm, whose handler arms that hook.
 * Once a bound is passed the hook fires at every instruction and raises each time, so that no
 * protected call on the way (the DSL's own) can swallow it.  Code stuck inside one C function runs
 * no hook: GRACE seconds later the alarm comes again and ends the process with a message.  The
 * environment (safe.lua) holds no C function that could be stuck, so that is a second lock, not the
 * first.
 */
#include "host.h"

#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/time.h>
#include <unistd.h>

#define PERIOD          1000
#define GRACE           1 /* s */
#define DEFAULT_BYTES   ((lua_Integer)64 << 20)
#define DEFAULT_STEPS   100000000
#define DEFAULT_SECONDS 10.0

enum bound { NONE, MEMORY, STEPS, TIME };

/* The one sandbox that runs; the signal handler must find it. */
static struct sandbox {
  lua_State *L;
  lua_Integer bytes, steps, steps_left;
  double seconds;
  volatile sig_atomic_t passed; /* enum bound */
  volatile sig_atomic_t active, unwinding;
  int loading;
  char last_words[512]; /* what the second alarm says */
  size_t last_length;
  const char *chunk;       /* the scene's chunk name, and */
  char source[LUA_IDSIZE]; /* how messages show it */
} box;

/* What a passed bound is called. */
static void push_bound(lua_State *L) {
  char text[96];
  if (box.passed == STEPS)
    snprintf(text, sizeof text, "the scene ran longer than %lld instructions",
             (long long)box.steps);
  else
    snprintf(text, sizeof text, "the scene ran longer than %g s", box.seconds);
  lua_pushstring(L, text);
}

static void hook(lua_State *L, lua_Debug *ar) {
  (void)ar;
  if (box.unwinding)
    return;
  interrupt_check(L);
  if (box.passed == NONE) {
    box.steps_left -= PERIOD;
    if (box.steps_left > 0)
      return;
    box.passed = STEPS;
  }
  lua_sethook(L, hook, LUA_MASKCOUNT, 1);
  push_bound(L);
  lua_error(L);
}

static void on_alarm(int number) {
  (void)number;
  if (box.passed != TIME) {
    box.passed = TIME;
    lua_sethook(box.L, hook, LUA_MASKCOUNT, 1);
    return;
  }
  ssize_t ignored = write(STDERR_FILENO, box.last_words, box.last_length);
  (void)ignored;
  _exit(1);
}

static void set_alarm(double seconds, long again) {
  struct itimerval timer = {0};
  timer.it_value.tv_sec = (time_t)seconds;
  timer.it_value.tv_usec = (suseconds_t)((seconds - (double)timer.it_value.tv_sec) * 1e6);
  if (seconds > 0 && timer.it_value.tv_sec == 0 && timer.it_value.tv_usec == 0)
    timer.it_value.tv_usec = 1; /* 0 would switch it off */
  timer.it_interval.tv_sec = again;
  setitimer(ITIMER_REAL, &timer, NULL);
}

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

/* Fields "message" and, when the text begins with a place in the scene, "line" of the table on top.
 */
static void describe_text(lua_State *L, const char *text) {
  const int line = skip_place(&text, box.source);
  if (line > 0) {
    lua_pushinteger(L, line);
    lua_setfield(L, -2, "line");
  } else {
    skip_place(&text, "src/cli/safe.lua"); /* to the scene it is a library function, not a place */
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

/* Message handler: the error's value -> its table. Nothing of the scene runs any more from here on.
 */
static int handler(lua_State *L) {
  if (box.unwinding) /* the parser's error on its way through load_and_call: it has its table */
    return 1;
  box.unwinding = 1;
  account_of(L)->limit = ACCOUNT_LIMIT;
  describe(L, 1,
           box.passed == STEPS  ? "steps"
           : box.passed == TIME ? "time"
           : box.loading        ? "syntax"
                                : "runtime");
  luaL_traceback(L, L, NULL, 1);
  lua_setfield(L, -2, "traceback");
  return 1;
}

/* ---- running ---- */

static double field(lua_State *L, int index, const char *name, double standard) {
  double value = standard;
  if (lua_istable(L, index)) {
    if (lua_getfield(L, index, name) != LUA_TNIL)
      value = luaL_checknumber(L, -1);
    lua_pop(L, 1);
  }
  if (!(value > 0 && value < 1e15))
    luaL_error(L, "sandbox: limit '%s' out of range", name);
  return value;
}

/* box.source = how messages show a chunk of this name. */
static void name_chunk(lua_State *L, const char *chunk) {
  lua_Debug ar;
  if (luaL_loadbufferx(L, "", 0, chunk, "t") != LUA_OK)
    lua_error(L);
  lua_getinfo(L, ">S", &ar);
  memcpy(box.source, ar.short_src, sizeof box.source);
}

static void prepare(lua_State *L, const char *chunk, int limits) {
  box.L = L;
  box.bytes = (lua_Integer)field(L, limits, "bytes", (double)DEFAULT_BYTES);
  box.steps = (lua_Integer)field(L, limits, "steps", DEFAULT_STEPS);
  box.seconds = field(L, limits, "seconds", DEFAULT_SECONDS);
  box.steps_left = box.steps;
  box.chunk = chunk;
  name_chunk(L, chunk);
  const int n = snprintf(box.last_words, sizeof box.last_words,
                         "polhode: %s: the scene ran longer than %g s\n", box.source, box.seconds);
  box.last_length = n < (int)sizeof box.last_words ? (size_t)n : sizeof box.last_words - 1;
  box.passed = NONE;
  box.unwinding = 0;
  box.loading = 0;
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
static int run_bounded(lua_State *L) {
  struct account *account = account_of(L);
  struct sigaction action = {0}, old_action;
  action.sa_handler = on_alarm;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  lua_pushcfunction(L, handler);
  lua_pushcfunction(L, load_and_call);
  for (int i = 1; i <= 3; i++)
    lua_pushvalue(L, i);
  box.active = 1;
  account->limit = account->used + (size_t)box.bytes;
  if (account->limit > ACCOUNT_LIMIT)
    account->limit = ACCOUNT_LIMIT;
  sigaction(SIGALRM, &action, &old_action);
  lua_sethook(L, hook, LUA_MASKCOUNT, PERIOD);
  set_alarm(box.seconds, GRACE);
  const int status = lua_pcall(L, 3, LUA_MULTRET, 5);
  set_alarm(0, 0);
  lua_sethook(L, NULL, 0, 0);
  sigaction(SIGALRM, &old_action, NULL);
  account->limit = ACCOUNT_LIMIT;
  box.active = 0;
  lua_remove(L, 5);
  return status;
}

/* The table for a failure that the handler has not described: what it is instead of. */
static void describe_late(lua_State *L, int status) {
  const int value = lua_gettop(L);
  if (status == LUA_ERRMEM) {
    lua_gc(L, LUA_GCCOLLECT);
    describe(L, value, "memory");
    lua_pushfstring(L, "the scene needs more than %I MiB of memory",
                    (LUAI_UACINT)(box.bytes >> 20));
    lua_setfield(L, -2, "message");
  } else if (box.passed != NONE) {
    push_bound(L);
    describe(L, lua_gettop(L), box.passed == STEPS ? "steps" : "time");
  } else {
    describe(L, value, box.loading ? "syntax" : "runtime");
  }
  lua_pushnil(L);
  lua_setfield(L, -2, "source"); /* the stack that describe_stack saw is our caller's */
}

int host_sandbox(lua_State *L) {
  luaL_checktype(L, 1, LUA_TSTRING);
  const char *chunk = luaL_checkstring(L, 2);
  luaL_checktype(L, 3, LUA_TTABLE);
  lua_settop(L, 4);
  if (box.active)
    return luaL_error(L, "sandbox: one scene at a time");
  prepare(L, chunk, 4);
  copy_libraries(L, 3);
  make_visible(L, 3);
  const int status = run_bounded(L);
  interrupt_check(L);
  if (status == LUA_OK && box.passed == NONE) {
    lua_pushboolean(L, 1);
    lua_insert(L, 5);
    return lua_gettop(L) - 4;
  }
  if (status == LUA_OK || !lua_istable(L, -1) || !box.unwinding)
    describe_late(L, status);
  lua_pushboolean(L, 0);
  lua_insert(L, -2);
  return 2;
}
