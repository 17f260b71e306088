/* file_write.c - writing a set of files: all of them or none.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Every file that differs from what is on disk is first written whole to a temporary beside its
 * place; only when all are there are they renamed, and the old ones kept under a second name until
 * the last rename has succeeded.  A failure at any point puts everything back, directories that
 * were made included.  Signals wait meanwhile.  Files that did not change are not touched, so make
 * stays quiet. A file that is to go is renamed with the others and unlinked after the last of them.
 * Memory: the job list is one Lua userdata, so nothing leaks when an error is raised.
 */
#include "host.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* One file. Paths are "" until the thing they name exists on disk. */
struct item {
  const char *name, *text; /* Lua strings that stay on the caller's table; text NULL: to go */
  size_t size;
  char path[PATH_MAX], temporary[PATH_MAX], backup[PATH_MAX];
  int changed, renamed;
};

struct job {
  int items;
  int made; /* directories created, in order */
  char (*directory)[PATH_MAX];
  char why[PATH_MAX + 256]; /* message of the failure */
  int status;               /* and the exit status that it calls for */
  struct item item[];
};

static int fail(struct job *job, const char *path, const char *why) {
  snprintf(job->why, sizeof job->why, "cannot write %s: %s", path, why);
  return 0;
}

/* A disk that is full or broken is no mistake of the user's: the exit status tells them apart. */
static int fail_as(struct job *job, const char *path, int error) {
  if (error == ENOSPC || error == EDQUOT || error == EFBIG || error == EIO)
    job->status = HOST_EXIT_OUTPUT;
  return fail(job, path, strerror(error));
}

static int write_all(int fd, const char *text, size_t size) {
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

/* mkdir -p; remembers what it made. */
static int make_directories(struct job *job, const char *path) {
  char part[PATH_MAX];
  const size_t n = strlen(path);
  for (size_t i = 1; i <= n; i++) {
    if (path[i] != '/' && path[i] != '\0')
      continue;
    memcpy(part, path, i);
    part[i] = '\0';
    if (mkdir(part, 0777) == 0) {
      char(*more)[PATH_MAX] = realloc(job->directory, (size_t)(job->made + 1) * sizeof *more);
      if (more == NULL) {
        rmdir(part);
        return fail_as(job, path, ENOMEM);
      }
      job->directory = more;
      memcpy(job->directory[job->made++], part, i + 1);
    } else if (errno != EEXIST && errno != EISDIR) {
      return fail_as(job, part, errno);
    }
  }
  return 1;
}

/* Does the file at path hold exactly this text? */
static int same(const char *path, const char *text, size_t size) {
  struct stat info;
  if (lstat(path, &info) != 0 || !S_ISREG(info.st_mode) || (size_t)info.st_size != size)
    return 0;
  FILE *f = fopen(path, "rb");
  if (f == NULL)
    return 0;
  char block[4096];
  size_t done = 0, n;
  while ((n = fread(block, 1, sizeof block, f)) > 0 && done + n <= size &&
         memcmp(block, text + done, n) == 0)
    done += n;
  fclose(f);
  return n == 0 && done == size;
}

/* A name in the directory of `path` that is free now: ".polhode-XXXXXX". */
static int beside(const char *path, char out[PATH_MAX]) {
  const char *slash = strrchr(path, '/');
  const size_t n = slash != NULL ? (size_t)(slash - path) + 1 : 0;
  if (n + sizeof ".polhode-XXXXXX" > PATH_MAX) {
    errno = ENAMETOOLONG;
    return 0;
  }
  memcpy(out, path, n);
  memcpy(out + n, ".polhode-XXXXXX", sizeof ".polhode-XXXXXX");
  return 1;
}

/* The mode that open(2) would have given, or the old file's. */
static mode_t mode_for(const char *path) {
  struct stat info;
  if (stat(path, &info) == 0)
    return info.st_mode & 07777;
  const mode_t mask = umask(0);
  umask(mask);
  return 0666 & ~mask;
}

/* A link's target is replaced, not the link: item->path becomes its real path. */
static int follow(struct job *job, struct item *item) {
  struct stat info;
  if (lstat(item->path, &info) != 0 || !S_ISLNK(info.st_mode))
    return 1;
  char *real = realpath(item->path, NULL);
  if (real == NULL)
    return errno == ENOENT ? fail(job, item->path, "it is a link to nothing")
                           : fail_as(job, item->path, errno);
  const int fits = snprintf(item->path, PATH_MAX, "%s", real) < PATH_MAX;
  free(real);
  return fits || fail_as(job, item->path, ENAMETOOLONG);
}

static int prepare(struct job *job, struct item *item) {
  struct stat info;
  if (item->text == NULL) {
    item->changed = lstat(item->path, &info) == 0 && S_ISREG(info.st_mode);
    return 1;
  }
  if (!follow(job, item))
    return 0;
  if (lstat(item->path, &info) == 0 && !S_ISREG(info.st_mode))
    return fail(job, item->path,
                S_ISDIR(info.st_mode) ? "it is a directory" : "it is not a regular file");
  item->changed = !same(item->path, item->text, item->size);
  if (!item->changed)
    return 1;
  char name[PATH_MAX];
  if (!beside(item->path, name))
    return fail_as(job, item->path, errno);
  const int fd = mkstemp(name);
  if (fd < 0)
    return fail_as(job, item->path, errno);
  memcpy(item->temporary, name, sizeof name);
  int good = write_all(fd, item->text, item->size) && fchmod(fd, mode_for(item->path)) == 0;
  const int error = errno;
  if (close(fd) != 0 && good)
    return fail_as(job, item->path, errno);
  return good || fail_as(job, item->path, error);
}

/* A file that is to go becomes its own backup. */
static int retire(struct job *job, struct item *item) {
  char name[PATH_MAX];
  if (!beside(item->path, name))
    return fail_as(job, item->path, errno);
  const int fd = mkstemp(name);
  if (fd < 0)
    return fail_as(job, item->path, errno);
  close(fd);
  if (rename(item->path, name) != 0) {
    const int error = errno;
    unlink(name);
    return fail_as(job, item->path, error);
  }
  memcpy(item->backup, name, sizeof name);
  item->renamed = 1;
  return 1;
}

static int commit(struct job *job, struct item *item) {
  char name[PATH_MAX];
  if (!item->changed)
    return 1;
  if (item->text == NULL)
    return retire(job, item);
  if (access(item->path, F_OK) == 0 && beside(item->path, name)) {
    /* mktemp's race is harmless: link() refuses a name that exists */
    const int fd = mkstemp(name);
    if (fd >= 0) {
      close(fd);
      unlink(name);
      if (link(item->path, name) == 0) /* a file system without links: no way back, but no harm */
        memcpy(item->backup, name, sizeof name);
    }
  }
  if (rename(item->temporary, item->path) != 0)
    return fail_as(job, item->path, errno);
  item->temporary[0] = '\0';
  item->renamed = 1;
  return 1;
}

static void undo(struct job *job) {
  for (int i = job->items; i-- > 0;) {
    struct item *item = &job->item[i];
    if (item->backup[0] != '\0' && item->renamed)
      rename(item->backup, item->path);
    else if (item->renamed)
      unlink(item->path);
    if (item->backup[0] != '\0')
      unlink(item->backup);
    if (item->temporary[0] != '\0')
      unlink(item->temporary);
  }
  while (job->made > 0)
    rmdir(job->directory[--job->made]);
}

/* The old file goes, and with one that is gone for good the folders below dir that it leaves
 * empty. */
static void finish(struct item *item, size_t dir) {
  if (item->backup[0] != '\0')
    unlink(item->backup);
  for (char *slash; item->text == NULL && item->changed;) {
    slash = strrchr(item->path, '/');
    if (slash == NULL || (size_t)(slash - item->path) <= dir)
      break;
    *slash = '\0';
    if (rmdir(item->path) != 0)
      break;
  }
}

/* All of it; on failure everything is as before and job->why says why. */
static int perform(struct job *job, const char *dir) {
  int good = make_directories(job, dir);
  for (int i = 0; good && i < job->items; i++) {
    struct item *item = &job->item[i];
    const char *slash = strrchr(item->name, '/');
    if (slash != NULL && item->text != NULL) {
      char sub[PATH_MAX];
      snprintf(sub, sizeof sub, "%.*s", (int)(strlen(item->path) - strlen(slash)), item->path);
      good = make_directories(job, sub);
    }
    good = good && prepare(job, item);
  }
  for (int i = 0; good && i < job->items; i++)
    good = commit(job, &job->item[i]);
  if (!good)
    undo(job);
  for (int i = 0; good && i < job->items; i++)
    finish(&job->item[i], strlen(dir));
  free(job->directory);
  job->directory = NULL;
  return good;
}

static int perform_undisturbed(struct job *job, const char *dir) {
  sigset_t stop, old;
  sigemptyset(&stop);
  sigaddset(&stop, SIGINT);
  sigaddset(&stop, SIGTERM);
  sigaddset(&stop, SIGHUP);
  sigprocmask(SIG_BLOCK, &stop, &old);
  const int good = perform(job, dir);
  sigprocmask(SIG_SETMASK, &old, NULL);
  return good;
}

/* "a.c", "sub/further/a.c" or ".github/a.yml": relative, no "..", and not as temporary files are
   called here. */
static int good_name(const char *name) {
  for (;;) {
    const char first = name[0] == '.' ? name[1] : name[0];
    if (first == '.' || first == '\0' || first == '/' || strncmp(name, ".polhode", 8) == 0)
      return 0;
    name = strchr(name, '/');
    if (name == NULL)
      return 1;
    name++;
  }
}

static struct job *new_job(lua_State *L, int items) {
  const size_t size = sizeof(struct job) + (size_t)items * sizeof(struct item);
  struct job *job = lua_newuserdatauv(L, size, 0);
  memset(job, 0, size);
  job->items = items;
  job->status = 2;
  return job;
}

/* item i from {name=, text=} at the stack's top, popped; text false: it is to go. The strings live
 * on in that table. 0: its path is too long. */
static int take_item(lua_State *L, struct job *job, int i, const char *dir) {
  struct item *item = &job->item[i];
  luaL_checktype(L, -1, LUA_TTABLE);
  lua_getfield(L, -1, "name");
  lua_getfield(L, -2, "text");
  item->name = lua_tostring(L, -2);
  item->text = lua_tolstring(L, -1, &item->size);
  const int gone = lua_isboolean(L, -1) && !lua_toboolean(L, -1);
  if (lua_type(L, -2) != LUA_TSTRING || !(gone || lua_type(L, -1) == LUA_TSTRING) ||
      !good_name(item->name))
    luaL_error(L, "write_files: entry %d is no {name=, text=} with a plain relative name", i + 1);
  for (int j = 0; j < i; j++)
    if (strcmp(job->item[j].name, item->name) == 0)
      luaL_error(L, "write_files: '%s' is given twice", item->name);
  const int fits = snprintf(item->path, PATH_MAX, "%s/%s", dir, item->name) < PATH_MAX;
  lua_pop(L, 3);
  return fits;
}

int host_write_files(lua_State *L) {
  const char *dir = luaL_checkstring(L, 1);
  luaL_checktype(L, 2, LUA_TTABLE);
  luaL_argcheck(L, *dir != '\0', 1, "empty directory name");
  const int n = (int)lua_rawlen(L, 2);
  struct job *job = new_job(L, n);
  for (int i = 0; i < n; i++) {
    lua_rawgeti(L, 2, i + 1);
    if (!take_item(L, job, i, dir)) {
      lua_pushnil(L);
      lua_pushfstring(L, "a path of %d bytes: %s", (int)strlen(dir), strerror(ENAMETOOLONG));
      return 2;
    }
  }
  if (!perform_undisturbed(job, dir)) {
    lua_pushnil(L);
    lua_pushstring(L, job->why);
    lua_pushinteger(L, job->status);
    return 3;
  }
  lua_pushboolean(L, 1);
  lua_newtable(L);
  for (int i = 0, written = 0; i < n; i++) {
    if (job->item[i].changed) {
      lua_pushstring(L, job->item[i].name);
      lua_rawseti(L, -2, ++written);
    }
  }
  return 2;
}

/* A device or a fifo is written to, as `> path` would: /dev/stdout, /dev/null. */
static int write_through(struct job *job, const char *path) {
  const int fd = open(path, O_WRONLY | O_CLOEXEC);
  if (fd < 0)
    return fail_as(job, path, errno);
  const int good = write_all(fd, job->item[0].text, job->item[0].size);
  const int error = errno;
  if (close(fd) != 0 && good)
    return fail_as(job, path, errno);
  return good || fail_as(job, path, error);
}

int host_write_file(lua_State *L) {
  const char *path = luaL_checkstring(L, 1);
  struct job *job = new_job(L, 1);
  struct item *item = &job->item[0];
  item->text = luaL_checklstring(L, 2, &item->size);
  item->name = "";
  struct stat info;
  int good = strlen(path) < PATH_MAX && *path != '\0';
  if (!good) {
    fail_as(job, path, *path == '\0' ? ENOENT : ENAMETOOLONG);
  } else if (stat(path, &info) == 0 && !S_ISREG(info.st_mode) && !S_ISDIR(info.st_mode)) {
    good = write_through(job, path);
  } else {
    strcpy(item->path, path);
    const char *slash = strrchr(path, '/');
    lua_pushlstring(L, path, slash != NULL ? (size_t)(slash - path) : 0);
    good = perform_undisturbed(job, lua_tostring(L, -1));
  }
  if (good) {
    lua_pushboolean(L, 1);
    return 1;
  }
  lua_pushnil(L);
  lua_pushstring(L, job->why);
  lua_pushinteger(L, job->status);
  return 3;
}
