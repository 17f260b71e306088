/* bounds.c - how much memory and work a scene may take.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Four bounds:
 *   memory    the allocator refuses beyond a limit above what is in use at the start;
 *   steps     a count hook every PERIOD virtual instructions: for the scene's own run, which may be
 *             a loop that allocates nothing;
 *   turnover  bytes allocated in all: for the generator's work on a scene, which allocates 2 to 6
 *             bytes an instruction, and which a count hook would slow down;
 *   seconds   of processor time, so that a busy machine refuses no more than an idle one: a timer,
 *             whose handler arms the hook.
 * Steps and turnover are the same on every machine.  Once a bound is passed the hook fires at every
 * instruction and raises each time, so that no protected call on the way can swallow it.  Code
 * stuck inside one C function runs no hook: GRACE seconds later the timer comes again and ends the
 * process with a message.
 */
#include "bounds.h"
#include "rational/rational.h"

#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/time.h>
#include <unistd.h>

#define PERIOD      1000
#define TURN        ((size_t)1 << 20) /* turnover after which the hook has a look */
#define INSTRUCTION 4                 /* turnover that takes about as long as one does */
#define GRACE       0.4               /* s */

/* Below this nobody minds garbage. */
#define SOFT ((size_t)24 << 20)

/* Sanitizers make everything slower; steps are the same. */
#if defined __SANITIZE_ADDRESS__
#define SLOWNESS 10
#else
#define SLOWNESS 1
#endif

/* The one set that is in force; the signal handler must find it. */
static struct {
  lua_State *L;
  struct bounds b;
  lua_Integer steps_left;
  size_t begin, end;            /* turnover: the account's total at the start, at the bound */
  size_t soft;                  /* in use: time to collect */
  volatile sig_atomic_t passed; /* enum bound */
  volatile sig_atomic_t active, unwinding;
  const char *last_words;
  struct sigaction old_action;
} box;

void bounds_push(lua_State *L, enum bound which) {
  char text[128];
  if (which == BOUND_MEMORY)
    snprintf(text, sizeof text, "%s needs more than %lld MiB of memory", box.b.what,
             (long long)(box.b.bytes >> 20));
  else if (which == BOUND_STEPS)
    snprintf(text, sizeof text, "%s ran longer than %lld instructions", box.b.what,
             (long long)box.b.steps);
  else if (which == BOUND_TURNOVER)
    snprintf(text, sizeof text, "%s makes more than %lld MiB of terms", box.b.what,
             (long long)(box.b.turnover >> 20));
  else
    snprintf(text, sizeof text, "%s ran longer than %g s", box.b.what, box.b.seconds);
  lua_pushstring(L, text);
}

/* The collector is lazy, for most runs are short; here it must not be. */
static void tidy(lua_State *L) {
  struct account *a = account_of(L);
  if (a->used <= box.soft)
    return;
  box.steps_left -= (lua_Integer)(a->used / 32); /* what it takes to visit all of it */
  a->total += a->used / 32 * INSTRUCTION;
  lua_gc(L, LUA_GCCOLLECT);
  if (box.soft < 2 * a->used)
    box.soft = 2 * a->used;
}

/* After PERIOD instructions. */
static void look_at_steps(lua_State *L) {
  box.steps_left -= PERIOD;
  tidy(L);
  if (box.steps_left <= 0)
    box.passed = BOUND_STEPS;
}

/* After a TURN; the hook sleeps till the next. */
static void look_at_turnover(lua_State *L) {
  struct account *a = account_of(L);
  lua_sethook(L, NULL, 0, 0);
  tidy(L);
  if (a->total >= box.end)
    box.passed = BOUND_TURNOVER;
  a->mark = a->total + TURN < box.end ? a->total + TURN : box.end;
}

static void hook(lua_State *L, lua_Debug *ar) {
  (void)ar;
  if (box.unwinding)
    return;
  interrupt_check(L);
  if (box.passed == BOUND_NONE) {
    if (box.b.steps > 0)
      look_at_steps(L);
    else
      look_at_turnover(L);
  }
  if (box.passed == BOUND_NONE)
    return;
  lua_sethook(L, hook, LUA_MASKCOUNT, 1);
  bounds_push(L, box.passed);
  lua_error(L);
}

/* The allocator has refused for good: nothing that catches this may go on as if it were small. */
static void refused(void) {
  if (box.active && !box.unwinding && box.passed == BOUND_NONE) {
    box.passed = BOUND_MEMORY;
    lua_sethook(box.L, hook, LUA_MASKCOUNT, 1);
  }
}

/* The account's total has reached its mark. */
static void turned(void) {
  if (box.active && !box.unwinding)
    lua_sethook(box.L, hook, LUA_MASKCOUNT, 1);
}

/* Exact arithmetic on huge numbers: few instructions, much work. */
static void charge(double instructions) {
  if (!box.active || box.unwinding || box.passed != BOUND_NONE)
    return;
  const lua_Integer n = (lua_Integer)fmin(instructions, 1e15);
  box.steps_left -= n;
  account_of(box.L)->total += (size_t)n * INSTRUCTION; /* seen at the next allocation */
  if (box.b.steps > 0 && box.steps_left <= 0) {
    box.passed = BOUND_STEPS;
    lua_sethook(box.L, hook, LUA_MASKCOUNT, 1);
  }
}

static void on_timer(int number) {
  (void)number;
  if (box.passed != BOUND_TIME) {
    box.passed = BOUND_TIME;
    lua_sethook(box.L, hook, LUA_MASKCOUNT, 1);
    return;
  }
  ssize_t ignored = write(STDERR_FILENO, box.last_words, strlen(box.last_words));
  (void)ignored;
  _exit(1);
}

static struct timeval interval(double seconds) {
  struct timeval t = {(time_t)seconds, 0};
  t.tv_usec = (suseconds_t)((seconds - (double)t.tv_sec) * 1e6);
  if (seconds > 0 && t.tv_sec == 0 && t.tv_usec == 0)
    t.tv_usec = 1; /* 0 would switch it off */
  return t;
}

static void set_timer(double seconds) {
  const struct itimerval timer = {interval(seconds > 0 ? GRACE * SLOWNESS : 0),
                                  interval(seconds * SLOWNESS)};
  setitimer(ITIMER_PROF, &timer, NULL);
}

static double field(lua_State *L, int index, const char *name, double standard) {
  if (!lua_istable(L, index))
    return standard;
  double value = standard;
  if (lua_getfield(L, index, name) != LUA_TNIL) {
    value = luaL_checknumber(L, -1);
    if (!(value > 0 && value < 1e15))
      luaL_error(L, "limit '%s' out of range", name);
  }
  lua_pop(L, 1);
  return value;
}

void bounds_read(lua_State *L, int index, struct bounds *b) {
  b->bytes = (lua_Integer)field(L, index, "bytes", (double)b->bytes);
  b->steps = (lua_Integer)field(L, index, "steps", (double)b->steps);
  b->turnover = (lua_Integer)field(L, index, "turnover", (double)b->turnover);
  b->seconds = field(L, index, "seconds", b->seconds);
}

/* What the user says who trusts the scene, or whose machine is slow: every bound is as many times
   as large. */
static double patience(void) {
  const char *text = getenv("POLHODE_PATIENCE");
  const double factor = text != NULL ? strtod(text, NULL) : 1;
  return factor >= 1 && factor <= 1e6 ? factor : 1;
}

void bounds_begin(lua_State *L, const struct bounds *b, const char *last_words) {
  struct account *account = account_of(L);
  struct sigaction action = {0};
  action.sa_handler = on_timer;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  box.L = L;
  const double factor = patience();
  box.b = *b;
  box.b.bytes = (lua_Integer)((double)b->bytes * factor);
  box.b.steps = (lua_Integer)((double)b->steps * factor);
  box.b.turnover = (lua_Integer)((double)b->turnover * factor);
  box.b.seconds = b->seconds * factor;
  box.steps_left = box.b.steps;
  box.last_words = last_words;
  box.passed = BOUND_NONE;
  box.unwinding = 0;
  box.active = 1;
  account->refused = refused;
  rational_charge = charge;
  account->limit = account->used + (size_t)box.b.bytes;
  if (account->limit > ACCOUNT_LIMIT)
    account->limit = ACCOUNT_LIMIT;
  box.soft = account->used + (size_t)box.b.bytes / 4;
  if (box.soft > SOFT)
    box.soft = SOFT;
  sigaction(SIGPROF, &action, &box.old_action);
  box.begin = account->total;
  box.end = box.begin + (size_t)box.b.turnover;
  if (box.b.steps > 0) {
    lua_sethook(L, hook, LUA_MASKCOUNT, PERIOD);
  } else {
    account->mark = box.begin;
    account->passed = turned;
  }
  set_timer(box.b.seconds);
}

void bounds_end(lua_State *L) {
  set_timer(0);
  lua_sethook(L, NULL, 0, 0);
  sigaction(SIGPROF, &box.old_action, NULL);
  account_of(L)->limit = ACCOUNT_LIMIT;
  account_of(L)->passed = NULL;
  box.active = 0;
  interrupt_check(L);
}

int bounds_active(void) {
  return box.active;
}

void bounds_unwind(lua_State *L) {
  box.unwinding = 1;
  account_of(L)->limit = ACCOUNT_LIMIT;
}

int bounds_unwinding(void) {
  return box.unwinding;
}

enum bound bounds_passed(void) {
  return (enum bound)box.passed;
}

/* ---- for the generator: what follows from a scene ---- */

/* What honest scenes do not come to, and what is said of it: NULL if the error is another. */
static const char *excess(const char *error) {
  static const char *const list[][2] = {
      {"number too large", "grows a number beyond 1000000 bits"},
      {"stack overflow", "is nested too deeply"},
  };
  for (size_t i = 0; i < sizeof list / sizeof list[0]; i++)
    if (error != NULL && strstr(error, list[i][0]) != NULL)
      return list[i][1];
  return NULL;
}

/* Message handler: a text gets its traceback, for whoever must look for the bug. */
static int handler(lua_State *L) {
  if (box.unwinding)
    return 1;
  bounds_unwind(L);
  if (box.passed == BOUND_NONE && lua_type(L, 1) == LUA_TSTRING && !excess(lua_tostring(L, 1)))
    luaL_traceback(L, L, lua_tostring(L, 1), 1);
  return 1;
}

/* Field "used" of the table at 2: turnover of all calls with it. */
static lua_Integer used(lua_State *L) {
  lua_getfield(L, 2, "used");
  const lua_Integer n = lua_tointeger(L, -1);
  lua_pop(L, 1);
  return n;
}

int host_bounded(lua_State *L) {
  struct bounds b = {(lua_Integer)1 << 29, 0, (lua_Integer)1 << 32, 100, "the scene's algebra"};
  luaL_checktype(L, 1, LUA_TFUNCTION);
  luaL_checktype(L, 2, LUA_TTABLE);
  if (box.active)
    return luaL_error(L, "bounded: one at a time");
  bounds_read(L, 2, &b);
  const int arguments = lua_gettop(L) - 2;
  lua_pushcfunction(L, handler);
  lua_insert(L, 3);
  lua_pushvalue(L, 1);
  lua_insert(L, 4);
  const lua_Integer before = used(L);
  bounds_begin(L, &b, "polhode: the scene's algebra does not end\n");
  box.end = before < box.b.turnover ? box.end - (size_t)before : box.begin;
  const int status = lua_pcall(L, arguments, LUA_MULTRET, 3);
  const enum bound passed = status == LUA_ERRMEM ? BOUND_MEMORY : bounds_passed();
  bounds_end(L);
  lua_pushinteger(L, before + (lua_Integer)(account_of(L)->total - box.begin));
  lua_setfield(L, 2, "used");
  if (passed != BOUND_NONE) {
    lua_settop(L, 0);
    lua_gc(L, LUA_GCCOLLECT);
    lua_pushboolean(L, 0);
    bounds_push(L, passed);
    return 2;
  }
  const char *why = status != LUA_OK ? excess(lua_tostring(L, -1)) : NULL;
  if (why != NULL) {
    lua_pushboolean(L, 0);
    lua_pushfstring(L, "%s %s", b.what, why);
    return 2;
  }
  if (status != LUA_OK)
    return lua_error(L);
  lua_pushboolean(L, 1);
  lua_replace(L, 3);
  return lua_gettop(L) - 2;
}
