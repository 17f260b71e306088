/* hook.c - which lines of the generator ran.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Linked into the program (see hook.h), and a module of its own for tests under plain lua5.4.
 * POLHODE_COVERAGE names a folder; without it nothing is recorded.  POLHODE_COVERED is the tree
 * whose scripts count; both are absolute, because tests work elsewhere.  For each script there is
 * one file of MAX_LINES bytes, byte n is 1 once line n has run.  Every process maps these files
 * shared and stores nothing but ones: so processes side by side cannot spoil each other's, nothing
 * is to be merged, and what a process saw before it was killed is kept.
 */
#define POLHODE_COVERAGE_ITSELF
#include "hook.h"

#include <fcntl.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

#define MAX_LINES 4096 /* a page; tests/layers.t allows 400 */
#define MAX_FILES 1024 /* a power of two, several times what there are */

/* Scripts by the address of their chunk's name, checked against the name: an address may be used
   again. */
static struct script_lines {
  char name[96];
  unsigned char *lines; /* NULL: not ours */
} table[MAX_FILES];

static const char *folder; /* where to record; NULL: nowhere */
static const char *root;   /* the tree */
static lua_Hook inner;
static int inner_mask;

/* The folder is a test's or the build's; a failure must not look like lines that never ran. */
static void stop(const char *what, const char *name) {
  fprintf(stderr, "coverage: cannot %s %s\n", what, name);
  abort();
}

static unsigned char *map(const char *name) {
  char path[PATH_MAX];
  const int n = snprintf(path, sizeof path, "%s/%s", folder, name);
  if (n < 0 || n >= (int)sizeof path)
    stop("name the file of", name);
  for (char *c = path + strlen(folder) + 1; *c != '\0'; c++)
    if (*c == '/')
      *c = '%';
  const int fd = open(path, O_RDWR | O_CREAT, 0600);
  if (fd < 0 || ftruncate(fd, MAX_LINES) != 0)
    stop("write", path);
  void *lines = mmap(NULL, MAX_LINES, PROT_READ | PROT_WRITE, MAP_SHARED, fd, 0);
  if (lines == MAP_FAILED)
    stop("map", path);
  close(fd);
  return lines;
}

/* A test may give the program another tree, where a file of the same name can be the test's own. */
static int is_ours(const char *name) {
  const char *tree = getenv("POLHODE_SOURCE");
  char there[PATH_MAX], path[PATH_MAX], here[PATH_MAX];
  if (tree == NULL || *tree == '\0' || strncmp(name, "generator/", 10) != 0)
    return 1;
  int n = snprintf(path, sizeof path, "%s/%s", tree, name);
  if (n < 0 || n >= (int)sizeof path || realpath(path, there) == NULL)
    return 0;
  n = snprintf(path, sizeof path, "%s/%s", root, name);
  return n > 0 && n < (int)sizeof path && realpath(path, here) != NULL && strcmp(here, there) == 0;
}

/* "@generator/x.lua", "@./generator/x.lua" and what has the tree's path before it ->
   "generator/x.lua"; NULL for what is not ours. */
static const char *script_name(const char *source) {
  const size_t n = strlen(root);
  if (*source++ != '@')
    return NULL;
  if (strncmp(source, "./", 2) == 0)
    source += 2;
  else if (strncmp(source, root, n) == 0 && source[n] == '/')
    source += n + 1;
  const int ours = strncmp(source, "generator/", 10) == 0 || strncmp(source, "src/cli/", 8) == 0 ||
                   strncmp(source, "templates/", 10) == 0;
  return ours ? source : NULL;
}

static unsigned char *lines_of(const char *source) {
  const char *name = script_name(source);
  if (name == NULL)
    return NULL;
  size_t i = ((size_t)source >> 4) % MAX_FILES;
  for (size_t tries = 0; tries < MAX_FILES; tries++, i = (i + 1) % MAX_FILES) {
    struct script_lines *s = &table[i];
    if (s->name[0] == '\0') {
      if (strlen(name) >= sizeof s->name)
        stop("keep the name of", name);
      strcpy(s->name, name);
      s->lines = is_ours(name) ? map(name) : NULL;
    }
    if (strcmp(s->name, name) == 0)
      return s->lines;
  }
  stop("keep", name);
  return NULL;
}

static void hook(lua_State *L, lua_Debug *ar) {
  if (ar->event == LUA_HOOKLINE) {
    const int line = ar->currentline;
    lua_getinfo(L, "S", ar);
    unsigned char *lines = lines_of(ar->source);
    if (lines != NULL && line > 0 && line < MAX_LINES && lines[line] == 0)
      lines[line] = 1;
    if (!(inner_mask & LUA_MASKLINE))
      return;
  }
  if (inner != NULL)
    inner(L, ar);
}

void coverage_sethook(lua_State *L, lua_Hook wanted, int mask, int count) {
  inner = mask != 0 ? wanted : NULL;
  inner_mask = inner != NULL ? mask : 0;
  if (folder != NULL)
    lua_sethook(L, hook, inner_mask | LUA_MASKLINE, count);
  else
    lua_sethook(L, wanted, mask, count);
}

lua_State *coverage_state(lua_State *L) {
  folder = getenv("POLHODE_COVERAGE");
  root = getenv("POLHODE_COVERED");
  if (folder != NULL && root == NULL)
    stop("do without the variable", "POLHODE_COVERED");
  if (L != NULL)
    coverage_sethook(L, NULL, 0, 0);
  return L;
}

int luaopen_polhode_coverage(lua_State *L);
int luaopen_polhode_coverage(lua_State *L) {
  coverage_state(L);
  return 0;
}
