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
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#define MAX_ARGUMENTS 256
#define MAX_OUTPUT    ((size_t)1 << 20)
#define MAX_RUNNING   64

extern char **environ;

/* What to run and what came of it. `output` is malloc'ed. */
struct child {
  const char *argv[MAX_ARGUMENTS + 1];
  int argc;
  const char *const *others; /* names to try when argv[0] is not there; ended by NULL, NULL: none */
  const char *dir;           /* NULL: the current one */
  double seconds;            /* killed after this long; 0: never */
  int status;                /* exit status, 128 + signal, or -1: see `error` */
  int error;                 /* errno of what failed before the program ran */
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

/* The environment, with a TMPDIR that goes with us if dir does: a compiler that is stopped leaves
 * its files there. NULL: as it is. To be freed. */
static char **surroundings(const char *dir) {
  size_t n = 0, size = strlen("TMPDIR=") + 1;
  if (dir == NULL || !tempdir_holds(dir))
    return NULL;
  while (environ[n] != NULL)
    n++;
  size += strlen(dir);
  char **list = malloc((n + 2) * sizeof *list + size); /* and the text of TMPDIR behind it */
  if (list == NULL)
    return NULL;
  char *own = (char *)(list + n + 2);
  snprintf(own, size, "TMPDIR=%s", dir);
  size_t k = 0;
  for (size_t i = 0; i < n; i++)
    if (strncmp(environ[i], "TMPDIR=", 7) != 0)
      list[k++] = environ[i];
  list[k++] = own;
  list[k] = NULL;
  return list;
}

/* Start the child with `out` as its output; an errno. */
static int start(const struct child *c, int out, pid_t *pid) {
  posix_spawn_file_actions_t files;
  posix_spawnattr_t attributes;
  sigset_t defaults, none;
  sigemptyset(&none);
  sigemptyset(&defaults);
  sigaddset(&defaults, SIGPIPE);
  sigaddset(&defaults, SIGXFSZ);
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
  char **own = surroundings(c->dir);
  const int error =
      posix_spawnp(pid, argv[0], &files, &attributes, argv, own != NULL ? own : environ);
  free(own);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  return error;
}

/* Children that run at the same time, each with the end of a pipe to read. */
struct running {
  struct child *c;
  pid_t pid;
  int in;
  double end; /* when it is killed */
};

/* The program, or the next of the alternatives if there is none of that name. */
static void launch(struct child *c, struct running *r) {
  int ends[2];
  c->status = -1;
  c->output = malloc(MAX_OUTPUT);
  if (c->output == NULL || pipe2(ends, O_CLOEXEC) != 0) {
    c->error = errno;
    return;
  }
  c->error = start(c, ends[1], &r->pid);
  for (; c->error == ENOENT && c->others != NULL && *c->others != NULL; c->others++) {
    c->argv[0] = *c->others;
    c->error = start(c, ends[1], &r->pid);
  }
  close(ends[1]);
  if (c->error != 0) {
    close(ends[0]);
    return;
  }
  r->c = c;
  r->in = ends[0];
  r->end = now() + c->seconds;
}

/* One read; what exceeds MAX_OUTPUT is dropped. 0: the child has closed its end. */
static int take(struct child *c, int in) {
  char block[4096];
  const ssize_t n = read(in, block, sizeof block);
  if (n <= 0)
    return n < 0 && errno == EINTR;
  const size_t room = MAX_OUTPUT - c->size;
  const size_t some = (size_t)n < room ? (size_t)n : room;
  memcpy(c->output + c->size, block, some);
  c->size += some;
  return 1;
}

static void finish(struct running *r) {
  int status;
  while (waitpid(r->pid, &status, 0) < 0 && errno == EINTR)
    ;
  r->c->status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  close(r->in);
  char *fit = realloc(r->c->output, r->c->size + 1); /* a megabyte was set aside */
  r->c->output = fit != NULL ? fit : r->c->output;
}

/* How long to wait for the next that may be killed: milliseconds, -1 for ever. */
static int patience(const struct running r[], int n) {
  double left = -1;
  for (int i = 0; i < n; i++) {
    const double own = r[i].end - now();
    if (r[i].c->seconds > 0 && (left < 0 || own < left))
      left = own > 0 ? own : 0;
  }
  return left < 0 ? -1 : (int)(left * 1000) + 1;
}

/* Wait, take what was written, and put an end to those whose time is up; how many still run. */
static int attend(struct running r[], int n) {
  struct pollfd p[MAX_RUNNING];
  for (int i = 0; i < n; i++)
    p[i] = (struct pollfd){r[i].in, POLLIN, 0};
  const int ready = poll(p, (nfds_t)n, patience(r, n));
  int left = 0;
  for (int i = 0; i < n; i++) {
    int over = 0;
    if (r[i].c->seconds > 0 && now() >= r[i].end) {
      kill(r[i].pid, SIGKILL);
      over = 1;
    } else if (interrupt_pending()) { /* the terminal has told the child too; one that was not told
                                         is told now */
      kill(r[i].pid, SIGTERM);
      over = 1;
    } else if (ready > 0 && p[i].revents != 0) {
      over = !take(r[i].c, r[i].in);
    }
    if (over)
      finish(&r[i]);
    else
      r[left++] = r[i];
  }
  return left;
}

/* All of them, at most `at_once` at a time (1 to MAX_RUNNING). */
static void run_all(struct child c[], int n, int at_once) {
  struct running r[MAX_RUNNING];
  int next = 0, running = 0;
  while (next < n || running > 0) {
    while (next < n && running < at_once) {
      struct child *one = &c[next++];
      one->status = -1;
      one->error = EINTR;
      if (interrupt_pending())
        continue;
      launch(one, &r[running]);
      running += one->error == 0;
    }
    if (running > 0)
      running = attend(r, running);
  }
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

/* The blank-separated words of text ("ccache gcc"), which may hold no quotes. They must live until
   the child has run: the table at `keeper` holds them. */
static void add_words(lua_State *L, struct child *c, const char *text, int keeper) {
  while (*(text += strspn(text, " \t")) != '\0') {
    const size_t n = strcspn(text, " \t");
    lua_pushlstring(L, text, n);
    add(L, c, lua_tostring(L, -1));
    lua_rawseti(L, keeper, (lua_Integer)lua_rawlen(L, keeper) + 1);
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
  run_all(&c, 1, 1);
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

/* The program in a child that does not outlive us.  A kill -9 cannot be passed on: so the child
 * asks Linux for SIGTERM when we are gone; elsewhere it runs on.  0, or an errno. */
static int start_bound(char *const argv[], pid_t *pid) {
#ifdef __linux__
  int ends[2], error = 0;
  const pid_t self = getpid();
  if (pipe2(ends, O_CLOEXEC) != 0)
    return errno;
  *pid = fork();
  if (*pid < 0)
    error = errno;
  if (*pid == 0) {
    if (prctl(PR_SET_PDEATHSIG, SIGTERM) == 0 && getppid() != self)
      _exit(128 + SIGTERM); /* we went before it could ask */
    execv(argv[0], argv);
    error = errno;
    _exit(write(ends[1], &error, sizeof error) == sizeof error ? 127 : 126);
  }
  close(ends[1]);
  /* closed by execv without a word, else its errno comes */
  if (*pid > 0 && read(ends[0], &error, sizeof error) == sizeof error)
    waitpid(*pid, NULL, 0);
  close(ends[0]);
  return error;
#else
  return posix_spawn(pid, argv[0], NULL, NULL, argv, environ);
#endif
}

/* The terminal and all of standard output and error are the child's until it ends; a signal that
 * comes is passed on. */
int host_hand_over(lua_State *L) {
  struct child c = {0};
  lua_settop(L, 1);
  add_list(L, &c, 1);
  luaL_argcheck(L, c.argc > 0, 1, "nothing to run");
  pid_t pid = 0;
  int status, told = 0;
  char *argv[MAX_ARGUMENTS + 1];
  memcpy(argv, c.argv, sizeof argv);
  fflush(stdout); /* what we said comes before what it says */
  const int error = start_bound(argv, &pid);
  if (error != 0) {
    lua_pushnil(L);
    lua_pushfstring(L, "cannot run %s: %s", argv[0], strerror(error));
    return 2;
  }
  while (waitpid(pid, &status, 0) < 0 && errno == EINTR)
    if (interrupt_pending() && !told)
      told = kill(pid, interrupt_pending()) == 0;
  lua_pushinteger(L, WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status));
  return 1;
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
      lua_pushfstring(
          L, "cannot run the C compiler %s: %s (set CC, or install the packages gcc and libc6-dev)",
          c->argv[0], strerror(c->error));
    else
      lua_pushlstring(L, c->output, c->size);
  }
  free(c->output);
  return 2;
}

/* The compiler's command line, from the values at index, index + 1, ...: directory, sources,
   output, options. Its strings live in those and in the table at `keeper`. */
static void prepare(lua_State *L, struct child *c, int index, int keeper) {
  static const char *const usual[] = {"gcc", "clang", NULL};
  const char *cc = getenv("CC");
  c->dir = luaL_checkstring(L, index);
  const char *output = luaL_checkstring(L, index + 2);
  const int top = lua_gettop(L), options = lua_istable(L, index + 3);
  for (int i = 0; i < 3; i++) {
    static const char *const key[] = {"cc", "flags", "libs"};
    if (options)
      lua_getfield(L, index + 3, key[i]);
    else
      lua_pushnil(L);
  }
  cc = luaL_optstring(L, top + 1, cc != NULL && *cc != '\0' ? cc : NULL);
  c->others = cc == NULL ? usual : NULL;
  add_words(L, c, cc != NULL ? cc : "cc", keeper);
  luaL_argcheck(L, c->argc > 0, index + 3, "empty compiler name");
  add_list(L, c, top + 2);
  add(L, c, "-o");
  add(L, c, output);
  add_list(L, c, index + 1);
  add_list(L, c, top + 3);
  lua_settop(L, top);
}

int host_compile(lua_State *L) {
  struct child c = {0};
  lua_settop(L, 4);
  lua_newtable(L);
  prepare(L, &c, 1, 5);
  run_all(&c, 1, 1);
  return push_compiled(L, &c);
}

int host_compile_many(lua_State *L) {
  luaL_checktype(L, 1, LUA_TTABLE);
  const int n = (int)lua_rawlen(L, 1);
  lua_Integer at_once = luaL_optinteger(L, 2, 0);
  if (at_once < 1) {
    host_processors(L);
    at_once = lua_tointeger(L, -1);
  }
  lua_settop(L, 1);
  lua_newtable(L);
  struct child *c = lua_newuserdatauv(L, (size_t)n * sizeof *c + 1, 0);
  memset(c, 0, (size_t)n * sizeof *c);
  for (int i = 0; i < n; i++) {
    luaL_checktype(L, (lua_rawgeti(L, 1, i + 1), -1), LUA_TTABLE);
    for (int k = 1; k <= 4; k++)
      lua_rawgeti(L, 4, k);
    prepare(L, &c[i], 5, 2);
    lua_settop(L, 3);
  }
  run_all(c, n, (int)(at_once < MAX_RUNNING ? at_once : MAX_RUNNING));
  interrupt_check(L);
  lua_createtable(L, n, 0);
  for (int i = 0; i < n; i++) {
    const int good = c[i].status == 0;
    push_compiled(L, &c[i]);
    lua_createtable(L, 0, 1);
    lua_insert(L, -2);
    lua_setfield(L, -2, good ? "command" : "message");
    lua_remove(L, -2);
    lua_rawseti(L, 4, i + 1);
  }
  return 1;
}
