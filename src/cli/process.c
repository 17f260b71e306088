/* process.c - running other programs: the C compiler above all.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * posix_spawn, no shell: a directory with blanks or quotes in its name is just a name.  Standard
 * output and error of the child come back as one text; its standard input is empty.  The compiler
 * is what the caller says, else $CC, else the first of cc, gcc, clang that exists.
 */
#define _GNU_SOURCE /* posix_spawn_file_actions_addchdir_np */
#include "host.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#define MAX_ARGUMENTS 256
#define MAX_OUTPUT    ((size_t)1 << 20)

extern char **environ;

/* What to run and what came of it. `output` is malloc'ed. */
struct child {
  const char *argv[MAX_ARGUMENTS + 1];
  int argc;
  const char *dir; /* NULL: the current one */
  double seconds;  /* killed after this long; 0: never */
  int status;      /* exit status, 128 + signal, or -1: see `error` */
  int error;       /* errno of what failed before the program ran */
  char *output;
  size_t size;
};

static double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

int host_clock(lua_State *L) {
  lua_pushnumber(L, now());
  return 1;
}

/* Start the child with `out` as its output; an errno. */
static int start(const struct child *c, int out, pid_t *pid) {
  posix_spawn_file_actions_t files;
  posix_spawnattr_t attributes;
  sigset_t defaults, none;
  sigemptyset(&none);
  sigemptyset(&defaults);
  sigaddset(&defaults, SIGPIPE);
  posix_spawn_file_actions_init(&files);
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setsigdefault(&attributes, &defaults);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK);
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&files, out, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&files, out, STDERR_FILENO);
  if (c->dir != NULL)
    posix_spawn_file_actions_addchdir_np(&files, c->dir);
  /* POSIX: argv is not modified, the type is a tribute to old code */
  char *argv[MAX_ARGUMENTS + 1];
  memcpy(argv, c->argv, sizeof argv);
  const int error = posix_spawnp(pid, argv[0], &files, &attributes, argv, environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  return error;
}

/* Take what the child writes until it closes its end; what exceeds MAX_OUTPUT is read and dropped.
 */
static void collect(struct child *c, int in, pid_t pid) {
  const double end = now() + c->seconds;
  char block[4096];
  for (;;) {
    struct pollfd p = {in, POLLIN, 0};
    const double left = end - now();
    if (c->seconds > 0 && left <= 0) {
      kill(pid, SIGKILL);
      break;
    }
    const int ready = poll(&p, 1, c->seconds > 0 ? (int)(left * 1000) + 1 : -1);
    if (interrupt_pending()) { /* the terminal has told the child too; one that was not told is told
                                  now */
      kill(pid, SIGTERM);
      break;
    }
    if (ready <= 0)
      continue;
    const ssize_t n = read(in, block, sizeof block);
    if (n < 0 && errno == EINTR)
      continue;
    if (n <= 0)
      break;
    const size_t room = MAX_OUTPUT - c->size;
    const size_t take = (size_t)n < room ? (size_t)n : room;
    memcpy(c->output + c->size, block, take);
    c->size += take;
  }
}

static void run(struct child *c) {
  int ends[2];
  pid_t pid;
  c->status = -1;
  c->output = malloc(MAX_OUTPUT);
  if (c->output == NULL || pipe2(ends, O_CLOEXEC) != 0) {
    c->error = errno;
    return;
  }
  c->error = start(c, ends[1], &pid);
  close(ends[1]);
  if (c->error == 0) {
    int status;
    collect(c, ends[0], pid);
    while (waitpid(pid, &status, 0) < 0 && errno == EINTR)
      ;
    c->status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }
  close(ends[0]);
}

/* ---- arguments ---- */

static void add(lua_State *L, struct child *c, const char *argument) {
  if (c->argc == MAX_ARGUMENTS)
    luaL_error(L, "more than %d arguments", MAX_ARGUMENTS);
  c->argv[c->argc++] = argument;
}

/* Every string of the list at `index` (nil: none). The strings stay in that list. */
static void add_list(lua_State *L, struct child *c, int index) {
  if (lua_isnoneornil(L, index))
    return;
  luaL_checktype(L, index, LUA_TTABLE);
  const int n = (int)lua_rawlen(L, index);
  for (int i = 1; i <= n; i++) {
    if (lua_rawgeti(L, index, i) != LUA_TSTRING)
      luaL_error(L, "argument %d is not a string", i);
    add(L, c, lua_tostring(L, -1));
    lua_pop(L, 1);
  }
}

/* The blank-separated words of text ("ccache gcc"), which may hold no quotes. */
static void add_words(lua_State *L, struct child *c, const char *text) {
  while (*(text += strspn(text, " \t")) != '\0') {
    const size_t n = strcspn(text, " \t");
    lua_pushlstring(L, text, n);
    add(L, c, lua_tostring(L, -1)); /* left on the stack: it must live until the child has run */
    luaL_checkstack(L, 1, NULL);
    text += n;
  }
}

int host_execute(lua_State *L) {
  struct child c = {0};
  lua_settop(L, 2);
  add_list(L, &c, 1);
  luaL_argcheck(L, c.argc > 0, 1, "nothing to run");
  if (lua_istable(L, 2)) {
    lua_getfield(L, 2, "dir");
    lua_getfield(L, 2, "seconds");
    c.dir = luaL_optstring(L, -2, NULL);
    c.seconds = luaL_optnumber(L, -1, 0);
  }
  run(&c);
  if (c.status < 0) {
    free(c.output);
    lua_pushnil(L);
    lua_pushfstring(L, "cannot run %s: %s", c.argv[0], strerror(c.error));
    return 2;
  }
  lua_pushinteger(L, c.status);
  lua_pushlstring(L, c.output, c.size);
  free(c.output);
  return 2;
}

/* compile's result: true and the command line, or nil and what the compiler said. */
static int push_compiled(lua_State *L, struct child *c) {
  luaL_Buffer command;
  if (c->status == 0) {
    lua_pushboolean(L, 1);
    luaL_buffinit(L, &command);
    for (int i = 0; i < c->argc; i++) {
      if (i > 0)
        luaL_addchar(&command, ' ');
      luaL_addstring(&command, c->argv[i]);
    }
    luaL_pushresult(&command);
  } else {
    lua_pushnil(L);
    if (c->status < 0)
      lua_pushfstring(L, "cannot run the C compiler %s: %s (set CC, or install the package gcc)",
                      c->argv[0], strerror(c->error));
    else
      lua_pushlstring(L, c->output, c->size);
  }
  free(c->output);
  return 2;
}

int host_compile(lua_State *L) {
  static const char *const usual[] = {"cc", "gcc", "clang"};
  lua_settop(L, 4);
  struct child c = {0};
  c.dir = luaL_checkstring(L, 1);
  const char *output = luaL_checkstring(L, 3);
  const char *cc = getenv("CC");
  if (lua_isnil(L, 4)) {
    lua_newtable(L);
    lua_replace(L, 4);
  }
  lua_getfield(L, 4, "cc");
  lua_getfield(L, 4, "flags");
  lua_getfield(L, 4, "libs");
  cc = luaL_optstring(L, 5, cc != NULL && *cc != '\0' ? cc : NULL);
  add_words(L, &c, cc != NULL ? cc : usual[0]);
  luaL_argcheck(L, c.argc > 0, 4, "empty compiler name");
  add_list(L, &c, 6);
  add(L, &c, "-o");
  add(L, &c, output);
  add_list(L, &c, 2);
  add_list(L, &c, 7);
  run(&c);
  for (size_t i = 1; cc == NULL && c.status < 0 && c.error == ENOENT && i < 3; i++) {
    free(c.output);
    c.argv[0] = usual[i];
    run(&c);
  }
  return push_compiled(L, &c);
}
