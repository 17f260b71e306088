/* shim.c - loaded before the C library (LD_PRELOAD): lets the n-th call of the file system fail.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 *     FAULT="call n what"    call: mkstemp, write, fchmod, close, mkdir, rename, link, unlink or
 * any; what: the number of an errno, "short" (one byte is written), or "signal N", raised before
 * the call.  n = 0: at every one. FAULT_COUNT=FILE       at the end, the number of calls of that
 * kind is written there.
 */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static char wanted[16], what[16];
static int at, number, ready, calls;

static void prepare(void) {
  const char *text = getenv("FAULT");
  ready = 1;
  if (text == NULL || sscanf(text, "%15s %d %15s %d", wanted, &at, what, &number) < 3)
    wanted[0] = '\0';
  unsetenv("LD_PRELOAD"); /* compilers are not meant */
}

/* Is this the call?  A signal is raised on the spot. */
static int hit(const char *name) {
  if (!ready)
    prepare();
  if (wanted[0] == '\0' || (strcmp(wanted, name) != 0 && strcmp(wanted, "any") != 0))
    return 0;
  calls++;
  if (at != 0 && calls != at)
    return 0;
  if (strcmp(what, "signal") == 0) {
    raise(number);
    return 0;
  }
  errno = atoi(what);
  return 1;
}

__attribute__((destructor)) static void count(void) {
  const char *path = getenv("FAULT_COUNT");
  FILE *f = path != NULL ? fopen(path, "w") : NULL;
  wanted[0] = '\0';
  if (f != NULL) {
    fprintf(f, "%d\n", calls);
    fclose(f);
  }
}

#define NEXT(NAME) ((__typeof__(&NAME))dlsym(RTLD_NEXT, #NAME))

int mkstemp(char *name) {
  return hit("mkstemp") ? -1 : NEXT(mkstemp)(name);
}

ssize_t write(int fd, const void *text, size_t size) {
  if (hit("write")) {
    if (strcmp(what, "short") != 0)
      return -1;
    size = size > 0;
  }
  return NEXT(write)(fd, text, size);
}

int fchmod(int fd, mode_t mode) {
  return hit("fchmod") ? -1 : NEXT(fchmod)(fd, mode);
}

/* Whatever close says, the descriptor is gone (Linux). */
int close(int fd) {
  const int failed = hit("close"), error = errno;
  const int status = NEXT(close)(fd);
  if (failed)
    errno = error;
  return failed ? -1 : status;
}

int mkdir(const char *path, mode_t mode) {
  return hit("mkdir") ? -1 : NEXT(mkdir)(path, mode);
}

int rename(const char *from, const char *to) {
  return hit("rename") ? -1 : NEXT(rename)(from, to);
}

int link(const char *from, const char *to) {
  return hit("link") ? -1 : NEXT(link)(from, to);
}

int unlink(const char *path) {
  return hit("unlink") ? -1 : NEXT(unlink)(path);
}
