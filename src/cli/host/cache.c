/* cache.c - small texts that save work the next time, in the user's cache folder.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The folder is polhode in XDG_CACHE_HOME, or in .cache of HOME (XDG Base Directory Specification);
 * relative names there count as unset.  A text is written to a temporary file beside its place and
 * renamed, so that nobody reads half of one.  Whatever fails here is as if nothing had been kept.
 */
#include "host.h"
#include "script.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define MAX_TEXT ((size_t)1 << 20)

/* The folder's path, made if `make`; 0 when there is none. */
static int folder(char path[PATH_MAX], int make) {
  const char *base = getenv("XDG_CACHE_HOME"), *rest = "";
  if (base == NULL || base[0] != '/') {
    base = getenv("HOME");
    rest = "/.cache";
  }
  if (base == NULL || base[0] != '/')
    return 0;
  const int n = snprintf(path, PATH_MAX, "%s%s", base, rest);
  if (n < 0 || n >= PATH_MAX - 64)
    return 0;
  if (make && mkdir(path, 0700) != 0 && errno != EEXIST)
    return 0;
  strcat(path, "/polhode");
  return !make || mkdir(path, 0700) == 0 || errno == EEXIST;
}

/* The file of a name of hexadecimal digits; 0 when there can be none. */
static int file_of(lua_State *L, char path[PATH_MAX], int make) {
  size_t n;
  const char *name = luaL_checklstring(L, 1, &n);
  luaL_argcheck(L, n > 0 && n <= 40 && strspn(name, "0123456789abcdef") == n, 1,
                "hexadecimal digits expected");
  if (!folder(path, make))
    return 0;
  strcat(path, "/");
  strcat(path, name);
  return 1;
}

int host_cache_read(lua_State *L) {
  char path[PATH_MAX];
  struct stat info;
  if (!file_of(L, path, 0) || stat(path, &info) != 0 || !S_ISREG(info.st_mode) ||
      info.st_size > (off_t)MAX_TEXT) {
    lua_pushnil(L);
    return 1;
  }
  return host_read_file(L, path);
}

static int whole(int fd, const char *text, size_t size) {
  while (size > 0) {
    const ssize_t n = write(fd, text, size);
    if (n < 0 && errno != EINTR)
      return 0;
    if (n > 0) {
      text += n;
      size -= (size_t)n;
    }
  }
  return 1;
}

int host_cache_write(lua_State *L) {
  char path[PATH_MAX], temporary[PATH_MAX];
  size_t size;
  const char *text = luaL_checklstring(L, 2, &size);
  int good = size <= MAX_TEXT && file_of(L, path, 1);
  if (good) {
    strcpy(temporary, path);
    strcpy(strrchr(temporary, '/'), "/.polhode-XXXXXX");
    const int fd = mkstemp(temporary);
    good = fd >= 0;
    if (good) {
      good = whole(fd, text, size);
      good = close(fd) == 0 && good && rename(temporary, path) == 0;
      if (!good)
        unlink(temporary);
    }
  }
  lua_pushboolean(L, good);
  return 1;
}

/* Fowler, Noll and Vo's hash of all scripts, FNV-1a with 64 bits. */
int host_fingerprint(lua_State *L) {
  const char *dir = getenv("POLHODE_SOURCE");
  uint64_t hash = 0xcbf29ce484222325u;
  char text[17];
  if (dir != NULL && *dir != '\0') {
    lua_pushnil(L);
    return 1;
  }
  for (const struct script *s = script_embedded; s->name != NULL; s++)
    for (size_t i = 0; i < s->size; i++)
      hash = (hash ^ (unsigned char)s->text[i]) * 0x100000001b3u;
  snprintf(text, sizeof text, "%016llx", (unsigned long long)hash);
  lua_pushstring(L, text);
  return 1;
}
