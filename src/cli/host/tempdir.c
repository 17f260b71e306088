/* tempdir.c - private temporary directories that vanish with the program.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Made with mkdtemp (mode 0700) in TMPDIR or /tmp, and removed with all they hold at the end of
 * main, after the Lua state is closed and every plugin in them unloaded; a signal to stop comes
 * that way too.
 */
#include "host.h"

#include <errno.h>
#include <ftw.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define MAX_DIRECTORIES 1024

static char *made[MAX_DIRECTORIES];
static int count;

int host_tempdir(lua_State *L) {
  const char *base = getenv("TMPDIR");
  if (base == NULL || *base == '\0')
    base = "/tmp";
  if (count == MAX_DIRECTORIES)
    return luaL_error(L, "tempdir: more than %d directories", MAX_DIRECTORIES);
  lua_pushfstring(L, "%s/polhode-XXXXXX", base);
  char *path = strdup(lua_tostring(L, -1));
  if (path == NULL || mkdtemp(path) == NULL) {
    const int error = errno;
    free(path);
    lua_pushnil(L);
    lua_pushfstring(L, "cannot make a temporary directory in %s: %s", base, strerror(error));
    return 2;
  }
  made[count++] = path;
  lua_pushstring(L, path);
  return 1;
}

int tempdir_holds(const char *path) {
  for (int i = 0; i < count; i++) {
    const size_t n = strlen(made[i]);
    if (strncmp(path, made[i], n) == 0 && (path[n] == '\0' || path[n] == '/'))
      return 1;
  }
  return 0;
}

static int remove_one(const char *path, const struct stat *info, int type, struct FTW *where) {
  (void)info;
  (void)type;
  (void)where;
  remove(path); /* what cannot go stays; the rest goes on */
  return 0;
}

void tempdir_remove_all(void) {
  while (count > 0) {
    nftw(made[--count], remove_one, 16, FTW_DEPTH | FTW_PHYS);
    free(made[count]);
  }
}
