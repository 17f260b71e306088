/* file_read.c - reading files and directories.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Regular files only and of bounded size: a scene named /dev/zero or a fifo must end in a message,
 * not in a hang.  Directory listings are sorted by byte, because what is listed ends up in output.
 */
#include "host.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static int fail(lua_State *L, const char *path, const char *why) {
  lua_pushnil(L);
  lua_pushfstring(L, "cannot read %s: %s", path, why);
  return 2;
}

int host_open_file(const char *path, off_t *size, const char **why) {
  const int fd = open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC); /* a fifo must not block the open */
  struct stat info;
  *why = NULL;
  if (fd < 0 || fstat(fd, &info) != 0)
    *why = strerror(errno);
  else if (S_ISDIR(info.st_mode))
    *why = "it is a directory";
  else if (!S_ISREG(info.st_mode))
    *why = "it is not a regular file";
  else
    *size = info.st_size;
  if (*why == NULL || fd < 0)
    return fd;
  close(fd);
  return -1;
}

/* Read up to `size` bytes; the number read, or -1. */
static ssize_t read_all(int fd, char *text, size_t size) {
  size_t got = 0;
  while (got < size) {
    const ssize_t n = read(fd, text + got, size - got);
    if (n < 0 && errno == EINTR)
      continue;
    if (n < 0)
      return -1;
    if (n == 0)
      break;
    got += (size_t)n;
  }
  return (ssize_t)got;
}

int host_read_file(lua_State *L, const char *path) {
  off_t bytes = 0;
  const char *why;
  const int fd = host_open_file(path, &bytes, &why);
  if (fd < 0)
    return fail(L, path, why);
  const size_t size = (size_t)bytes;
  if (bytes < 0 || size > HOST_MAX_FILE) {
    close(fd);
    return fail(L, path, "it is larger than 4 MiB");
  }
  /* malloc, not a Lua buffer: no error may be raised while fd is open */
  char *text = malloc(size + 1);
  const ssize_t got = text != NULL ? read_all(fd, text, size) : -1;
  const int error = errno;
  close(fd);
  if (got < 0) {
    free(text);
    return fail(L, path, strerror(error));
  }
  luaL_Buffer buffer;
  char *copy = luaL_buffinitsize(L, &buffer, (size_t)got);
  memcpy(copy, text, (size_t)got);
  free(text);
  luaL_pushresultsize(&buffer, (size_t)got);
  return 1;
}

/* Standard input as it was when it was first asked for: it can be read only once. */
static int read_input(lua_State *L) {
  static const char key[] = "polhode.stdin";
  luaL_Buffer buffer;
  size_t size = 0;
  ssize_t n = 1;
  if (lua_getfield(L, LUA_REGISTRYINDEX, key) == LUA_TSTRING)
    return 1;
  luaL_buffinit(L, &buffer);
  while (n > 0 && size <= HOST_MAX_FILE) {
    char *room = luaL_prepbuffer(&buffer);
    do
      n = read(STDIN_FILENO, room, LUAL_BUFFERSIZE);
    while (n < 0 && errno == EINTR && interrupt_pending() == 0);
    if (n < 0)
      return fail(L, "standard input", strerror(errno));
    luaL_addsize(&buffer, (size_t)n);
    size += (size_t)n;
  }
  luaL_pushresult(&buffer);
  if (size > HOST_MAX_FILE)
    return fail(L, "standard input", "it is larger than 4 MiB");
  lua_pushvalue(L, -1);
  lua_setfield(L, LUA_REGISTRYINDEX, key);
  return 1;
}

int host_read(lua_State *L) {
  const char *path = luaL_checkstring(L, 1);
  return strcmp(path, "-") == 0 ? read_input(L) : host_read_file(L, path);
}

/* The folder of this program's file, with `tail` behind it; 0 where nobody knows it. */
static int beside_program(char out[PATH_MAX], const char *tail) {
  const ssize_t n = readlink("/proc/self/exe", out, PATH_MAX - 1);
  if (n <= 0)
    return 0;
  out[n] = '\0';
  char *slash = strrchr(out, '/');
  const size_t folder = slash != NULL ? (size_t)(slash - out) : 0;
  if (slash == NULL || folder + strlen(tail) >= PATH_MAX)
    return 0;
  strcpy(slash, tail);
  return 1;
}

int host_bodies(lua_State *L) {
  static const char *const tails[] = {"/../share/polhode/bodies", "/../bodies"};
  char path[PATH_MAX], real[PATH_MAX];
  struct stat info;
  const char *own = getenv("POLHODE_BODIES");
  if (own != NULL && *own != '\0') {
    lua_pushstring(L, own);
    return 1;
  }
  for (size_t i = 0; i < sizeof tails / sizeof tails[0]; i++) {
    if (beside_program(path, tails[i]) && realpath(path, real) != NULL && stat(real, &info) == 0 &&
        S_ISDIR(info.st_mode)) {
      lua_pushstring(L, real);
      return 1;
    }
  }
  if (stat("bodies", &info) == 0 && S_ISDIR(info.st_mode))
    lua_pushliteral(L, "bodies");
  else
    lua_pushnil(L);
  return 1;
}

/* Does the real path begin with that of the folder?  What does not exist leads nowhere. */
int host_within(lua_State *L) {
  const char *folder_name = luaL_checkstring(L, 1), *name = luaL_checkstring(L, 2);
  char folder[PATH_MAX], path[PATH_MAX];
  int inside = 1;
  if (realpath(folder_name, folder) != NULL && realpath(name, path) != NULL) {
    const size_t n = strlen(folder);
    inside = strncmp(path, folder, n) == 0 && (path[n] == '/' || path[n] == '\0' || n == 1);
  }
  lua_pushboolean(L, inside);
  return 1;
}

static int chosen(const char *name, const char *suffix) {
  const size_t n = strlen(name), s = strlen(suffix);
  return name[0] != '.' && n >= s && strcmp(name + n - s, suffix) == 0;
}

/* By byte; scandir's alphasort follows the locale. */
static int by_byte(const struct dirent **a, const struct dirent **b) {
  return strcmp((*a)->d_name, (*b)->d_name);
}

int host_list_directory(lua_State *L, const char *path, const char *suffix) {
  struct dirent **entry;
  const int n = scandir(path, &entry, NULL, by_byte);
  if (n < 0)
    return fail(L, path, strerror(errno));
  lua_newtable(L);
  for (int i = 0, kept = 0; i < n; i++) {
    if (chosen(entry[i]->d_name, suffix)) {
      lua_pushstring(L, entry[i]->d_name);
      lua_rawseti(L, -2, ++kept);
    }
    free(entry[i]);
  }
  free(entry);
  return 1;
}

int host_list_dir(lua_State *L) {
  return host_list_directory(L, luaL_checkstring(L, 1), luaL_optstring(L, 2, ""));
}
