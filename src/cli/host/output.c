/* output.c - standard output and error, every write checked.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Results go to standard output through one buffer.  The first failure (a full disk, a reader that
 * went away) is kept; later writes are dropped, and the end of the program says what happened and
 * fails: a truncated table must never pass for a whole one.
 */
#include "host.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static int failure; /* errno of the first failed write, 0 if none */

static int check(lua_State *L) {
  if (failure == 0) {
    lua_pushboolean(L, 1);
    return 1;
  }
  lua_pushnil(L);
  lua_pushfstring(L, "cannot write standard output: %s", strerror(failure));
  return 2;
}

int host_out(lua_State *L) {
  size_t size;
  const char *text = luaL_checklstring(L, 1, &size);
  errno = 0;
  if (failure == 0 && fwrite(text, 1, size, stdout) != size)
    failure = errno != 0 ? errno : EIO;
  return check(L);
}

int host_err(lua_State *L) {
  size_t size;
  const char *text = luaL_checklstring(L, 1, &size);
  fflush(stdout); /* keep the order of what a terminal shows */
  fwrite(text, 1, size, stderr);
  lua_pushboolean(L, 1);
  return 1;
}

int host_isatty(lua_State *L) {
  static const char *const names[] = {"out", "err", NULL};
  lua_pushboolean(L,
                  isatty(luaL_checkoption(L, 1, NULL, names) == 0 ? STDOUT_FILENO : STDERR_FILENO));
  return 1;
}

/* On a terminal that has colours, unless the user wants none: no-color.org. */
int host_coloured(lua_State *L) {
  const char *none = getenv("NO_COLOR"), *kind = getenv("TERM");
  lua_pushboolean(L, isatty(STDERR_FILENO) && (none == NULL || *none == '\0') && kind != NULL &&
                         strcmp(kind, "dumb") != 0);
  return 1;
}

int output_finish(void) {
  errno = 0;
  if (failure == 0 && (fflush(stdout) != 0 || ferror(stdout)))
    failure = errno != 0 ? errno : EIO;
  if (failure == 0)
    return 0;
  if (failure != EPIPE) /* a reader that has seen enough (| head) needs no message */
    fprintf(stderr, "polhode: cannot write standard output: %s\n", strerror(failure));
  return HOST_EXIT_OUTPUT;
}
