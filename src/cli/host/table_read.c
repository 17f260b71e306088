/* table_read.c - columns of numbers from a CSV file, which may be large.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The first line names the columns.  Lines go by one at a time; a table ends at an empty line, as
 * `polhode sweep --stats` writes several of them.
 */
#define _GNU_SOURCE /* getline */
#include "host.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

enum { MAX_COLUMNS = 64, MAX_ROWS = 4000000 };

/* The next cell of a line, which is cut up; NULL behind the last. */
static char *cell(char **rest) {
  char *from = *rest, *to = from;
  if (from == NULL)
    return NULL;
  if (*from == '"') {
    char *out = ++from;
    for (to = from; *to != '\0' && (*to != '"' || to[1] == '"'); to++) {
      to += *to == '"';
      *out++ = *to;
    }
    if (*to == '"')
      to++;
    *out = '\0';
  }
  to = to + strcspn(to, ",\r\n");
  *rest = *to == ',' ? to + 1 : NULL;
  *to = '\0';
  return from;
}

/* Push a list of the names in the line; place[i]: the column of wanted name i, counted from 0, or
 * -1. */
static void heading(lua_State *L, char *line, int wanted, int count, int place[]) {
  int at = 0;
  for (int i = 0; i < count; i++)
    place[i] = -1;
  lua_newtable(L);
  for (char *name; (name = cell(&line)) != NULL; at++) {
    lua_pushstring(L, name);
    lua_rawseti(L, -2, at + 1);
    for (int i = 0; i < count; i++) {
      lua_rawgeti(L, wanted, i + 1);
      if (strcmp(lua_tostring(L, -1), name) == 0)
        place[i] = at;
      lua_pop(L, 1);
    }
  }
}

/* One row into the lists of columns at `lists`, each a table; what is no number becomes none. */
static void row(lua_State *L, char *line, int lists, int count, const int place[], lua_Integer n) {
  int at = 0;
  for (char *text; (text = cell(&line)) != NULL; at++) {
    for (int i = 0; i < count; i++) {
      if (place[i] != at)
        continue;
      char *end;
      const double x = strtod(text, &end);
      lua_rawgeti(L, lists, i + 1);
      lua_pushnumber(L, end != text && *end == '\0' ? x : (double)NAN);
      lua_rawseti(L, -2, n);
      lua_pop(L, 1);
    }
  }
}

int host_columns(lua_State *L) {
  const char *path = luaL_checkstring(L, 1);
  luaL_checktype(L, 2, LUA_TTABLE);
  lua_settop(L, 2);
  const int count = (int)lua_rawlen(L, 2);
  luaL_argcheck(L, count <= MAX_COLUMNS, 2, "too many columns");
  struct stat info;
  FILE *f = fopen(path, "r");
  if (f == NULL || fstat(fileno(f), &info) != 0 || !S_ISREG(info.st_mode)) {
    const int error = f == NULL ? errno : EINVAL;
    if (f != NULL)
      fclose(f);
    lua_pushnil(L);
    lua_pushfstring(L, "cannot read %s: %s", path,
                    f == NULL ? strerror(error) : "not a regular file");
    return 2;
  }
  char *line = NULL;
  size_t room = 0;
  int place[MAX_COLUMNS];
  lua_Integer n = 0;
  lua_newtable(L); /* 3: the lists */
  for (int i = 0; i < count; i++) {
    lua_newtable(L);
    lua_rawseti(L, 3, i + 1);
  }
  if (getline(&line, &room, f) > 0)
    heading(L, line, 2, count, place);
  else
    lua_newtable(L); /* 4: the names */
  while (n < MAX_ROWS && lua_rawlen(L, 4) > 0 && getline(&line, &room, f) > 0 && line[0] != '\n' &&
         line[0] != '\r')
    row(L, line, 3, count, place, ++n);
  const int failed = ferror(f) || n == MAX_ROWS;
  free(line);
  fclose(f);
  if (failed) {
    lua_pushnil(L);
    lua_pushfstring(L, "%s: %s", path,
                    n == MAX_ROWS ? "has more than 4000000 rows" : "cannot be read");
    return 2;
  }
  lua_settop(L, 4);
  return 2;
}
