/* interrupt.c - a signal to stop becomes a Lua error, so that temporary files go and nothing is
 * half done.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * lua_sethook may be called from a signal handler (Lua manual, 4.7): the handler arms a hook that
 * raises at the next instruction, and stays armed, so that no pcall can swallow it.  A second
 * signal finds the default action and ends the program at once.  The program dies of the signal, as
 * a shell expects.
 */
#include "host/host.h"

#include <signal.h>
#include <unistd.h>

static lua_State *watched;
static volatile sig_atomic_t pending;

static void raise_error(lua_State *L, lua_Debug *ar) {
  (void)ar;
  luaL_error(L, "interrupted");
}

static void on_signal(int number) {
  pending = number;
  lua_sethook(watched, raise_error, LUA_MASKCOUNT, 1);
}

void interrupt_watch(lua_State *L) {
  static const int signals[] = {SIGINT, SIGTERM, SIGHUP};
  watched = L;
  for (size_t i = 0; i < sizeof signals / sizeof signals[0]; i++) {
    struct sigaction action = {0}, old;
    sigaction(signals[i], NULL, &old);
    if (old.sa_handler == SIG_IGN)
      continue; /* nohup */
    action.sa_handler = on_signal;
    action.sa_flags = (int)SA_RESETHAND;
    sigemptyset(&action.sa_mask);
    sigaction(signals[i], &action, NULL);
  }
  signal(SIGPIPE, SIG_IGN); /* a closed pipe is a failed write, with a message */
  signal(SIGXFSZ, SIG_IGN); /* and so is a file that may not be as large */
}

int interrupt_pending(void) {
  return pending;
}

void interrupt_check(lua_State *L) {
  if (pending != 0) {
    lua_sethook(L, raise_error, LUA_MASKCOUNT, 1);
    luaL_error(L, "interrupted");
  }
}

void interrupt_resume(void) {
  if (pending != 0) {
    signal(pending, SIG_DFL);
    raise(pending);
  }
}
