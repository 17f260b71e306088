/* log.c - a file of measurements, read line by line into columns of numbers.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 *     # units: s, rad/s, rad/s            a comment; with `units:` the units of the columns
 *     # sigma: , 0.004, 0.2                  standard deviations of the columns, in their units
 *     t,wx,wy [deg/s]                     the names, each with its unit in brackets if not above
 *     0.00,0.9063,1.1047
 * An empty cell or nan is a value that is missing.  Everything else that is no number, a row with
 * another number of cells, and times that do not ascend are answered with file and line.
 */
#define _GNU_SOURCE /* getline */
#include "fit.h"
#include "host/host.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>

struct reader {
  FILE *file;
  char *line;
  size_t room;
  long number; /* of the line, from 1 on */
};

static char *trimmed(char *s) {
  s += strspn(s, " \t");
  size_t n = strlen(s);
  while (n > 0 && strchr(" \t\r\n", s[n - 1]) != NULL)
    s[--n] = '\0';
  return s;
}

/* The next cell of a line, which is cut up; NULL behind the last. */
static char *cell(char **rest) {
  char *from = *rest;
  if (from == NULL)
    return NULL;
  char *to = strchr(from, ',');
  *rest = to != NULL ? to + 1 : NULL;
  if (to != NULL)
    *to = '\0';
  return trimmed(from);
}

static int next(struct reader *r) {
  if (getline(&r->line, &r->room, r->file) < 0)
    return 0;
  r->number++;
  return 1;
}

static int reader_open(struct reader *r, const char *path) {
  struct stat info;
  *r = (struct reader){.file = fopen(path, "r")};
  if (r->file == NULL)
    return errno;
  if (fstat(fileno(r->file), &info) != 0 || !S_ISREG(info.st_mode)) {
    fclose(r->file);
    return EINVAL;
  }
  return 0;
}

static void reader_close(struct reader *r) {
  free(r->line);
  fclose(r->file);
}

/* Push the cells of a text as a list. */
static void push_cells(lua_State *L, char *text) {
  lua_newtable(L);
  int n = 0;
  for (char *name; (name = cell(&text)) != NULL;) {
    lua_pushstring(L, name);
    lua_rawseti(L, -2, ++n);
  }
}

struct fit_log *fit_log_at(lua_State *L, int index) {
  return luaL_checkudata(L, index, FIT_LOG_TYPE);
}

static int cannot(lua_State *L, const char *path, int error) {
  lua_pushnil(L);
  lua_pushfstring(L, "cannot read %s: %s", path,
                  error == EINVAL ? "not a regular file" : strerror(error));
  return 2;
}

/* The list behind a word of a comment, as the value at `index`, if it is there. */
static void noted(lua_State *L, char *text, const char *word, int index) {
  char *list = *text == '#' ? strstr(text, word) : NULL;
  if (list == NULL)
    return;
  list += strlen(word);
  list[strcspn(list, ";")] = '\0'; /* a remark follows */
  push_cells(L, list);
  lua_replace(L, index);
}

/* Leaves the reader behind the line with the names, which it pushes, with units and sigmas; 0:
 * there is none. */
static int heading(lua_State *L, struct reader *r) {
  const int at = lua_gettop(L) + 1;
  for (int i = 0; i < 3; i++)
    lua_newtable(L);
  while (next(r)) {
    char *text = trimmed(r->line);
    if (r->number == 1 && strncmp(text, "\357\273\277", 3) == 0)
      text += 3;
    noted(L, text, "units:", at + 1);
    noted(L, text, "sigma:", at + 2);
    if (*text != '#' && *text != '\0') {
      push_cells(L, text);
      lua_replace(L, at);
      return 1;
    }
  }
  lua_settop(L, at - 1);
  return 0;
}

static int head(lua_State *L) {
  struct fit_log *log = fit_log_at(L, 1);
  struct reader r;
  const int error = reader_open(&r, log->path);
  if (error != 0)
    return cannot(L, log->path, error);
  const int there = heading(L, &r);
  if (there)
    lua_pushinteger(L, r.number);
  reader_close(&r);
  if (there)
    return 4;
  lua_pushnil(L);
  lua_pushfstring(L, "%s: has no line that names its columns", log->path);
  return 2;
}

static int is_missing(const char *s) {
  return *s == '\0' || strcasecmp(s, "nan") == 0;
}

/* The number of a cell; 0: it is none. */
static int number(const char *s, double *x) {
  char *end;
  *x = strtod(s, &end);
  return end != s && *end == '\0' && isfinite(*x);
}

static int grow(struct fit_log *log) {
  if (log->rows < log->room)
    return 1;
  const size_t room = log->room + log->room / 4 + 1024; /* little is left over */
  double *t = realloc(log->t, room * sizeof *t);
  if (t == NULL)
    return 0;
  log->t = t;
  double *y = realloc(log->y, room * (size_t)log->columns * sizeof *y);
  if (y == NULL)
    return 0;
  log->y = y;
  unsigned *line = realloc(log->line, room * sizeof *line);
  if (line == NULL)
    return 0;
  log->line = line;
  log->room = room;
  return 1;
}

/* What is wrong with a row, or NULL. `column`, `factor`: of the time and the values; counts: how
   many of each. The message may point into `said`. */
static const char *row(struct fit_log *log, struct reader *r, int width, const int column[],
                       const double factor[], long counts[], char said[], size_t size) {
  static char *cells[FIT_COLUMNS * 4];
  int n = 0;
  char *rest = trimmed(r->line);
  for (char *c; (c = cell(&rest)) != NULL; n++)
    if (n < width)
      cells[n] = c;
  if (n != width) {
    snprintf(said, size, "%d cells expected, got %d", width, n);
    return said;
  }
  if (!grow(log))
    return "out of memory";
  double *y = log->y + log->rows * (size_t)log->columns;
  for (int i = 0; i <= log->columns; i++) {
    const char *text = cells[column[i]];
    double x = (double)NAN;
    if (i == 0 && is_missing(text))
      return "the time is missing";
    if (!is_missing(text) && !number(text, &x)) {
      snprintf(said, size, "must be a number, got \"%.40s\"", text);
      return said;
    }
    x *= factor[i];
    if (i > 0) {
      y[i - 1] = x;
      counts[i - 1] += x == x;
      continue;
    }
    const double last = log->rows > 0 ? log->t[log->rows - 1] : 0;
    if (log->rows == 0 ? x < 0 : x <= last) {
      if (log->rows == 0)
        snprintf(said, size, "times must not be negative (the motion begins at t = 0), got %.17g",
                 x);
      else
        snprintf(said, size, "times must ascend, got %.15g s after %.15g s", x, last);
      return said;
    }
    log->t[log->rows] = x;
  }
  log->line[log->rows++] = (unsigned)r->number;
  return NULL;
}

static int ascending(const void *a, const void *b) {
  const double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

/* The median of the first thousand distances. */
static void find_spacing(struct fit_log *log) {
  double d[1000] = {0};
  size_t n = 0;
  for (size_t i = 1; i < log->rows && n < 1000; i++)
    d[n++] = log->t[i] - log->t[i - 1];
  qsort(d, n, sizeof d[0], ascending);
  log->spacing = n > 0 ? d[n / 2] : 1;
}

static int read_rows(lua_State *L) {
  struct fit_log *log = fit_log_at(L, 1);
  int column[FIT_COLUMNS + 1];
  double factor[FIT_COLUMNS + 1];
  long counts[FIT_COLUMNS] = {0};
  log->columns = (int)lua_rawlen(L, 2) - 1;
  luaL_argcheck(L, log->columns > 0 && log->columns <= FIT_COLUMNS, 2, "columns");
  for (int i = 0; i <= log->columns; i++) {
    lua_rawgeti(L, 2, i + 1);
    lua_rawgeti(L, -1, 1);
    lua_rawgeti(L, -2, 2);
    column[i] = (int)lua_tointeger(L, -2) - 1;
    factor[i] = lua_tonumber(L, -1);
    lua_pop(L, 3);
  }
  struct reader r;
  const int error = reader_open(&r, log->path);
  if (error != 0)
    return cannot(L, log->path, error);
  heading(L, &r);
  const int width = (int)lua_rawlen(L, -3);
  const char *why = width > FIT_COLUMNS * 4 ? "has too many columns" : NULL;
  char said[120];
  while (why == NULL && next(&r)) {
    const char *text = r.line + strspn(r.line, " \t\r\n");
    if (*text != '\0' && *text != '#')
      why = row(log, &r, width, column, factor, counts, said, sizeof said);
  }
  const long line = r.number;
  reader_close(&r);
  if (why != NULL) {
    lua_pushnil(L);
    lua_pushfstring(L, "%s:%d: %s", log->path, (int)line, why);
    return 2;
  }
  find_spacing(log);
  lua_pushinteger(L, (lua_Integer)log->rows);
  lua_newtable(L);
  for (int i = 0; i < log->columns; i++) {
    lua_pushinteger(L, counts[i]);
    lua_rawseti(L, -2, i + 1);
  }
  return 2;
}

/* spacing() -> seconds between two rows, usually, times of the first and the last row */
static int spacing(lua_State *L) {
  const struct fit_log *log = fit_log_at(L, 1);
  lua_pushnumber(L, log->spacing);
  lua_pushnumber(L, log->rows > 0 ? log->t[0] : 0);
  lua_pushnumber(L, log->rows > 0 ? log->t[log->rows - 1] : 0);
  return 3;
}

/* zero(column, count) -> line of the first row in which all of them are 0, or nil */
static int zero(lua_State *L) {
  const struct fit_log *log = fit_log_at(L, 1);
  const size_t first = (size_t)luaL_checkinteger(L, 2) - 1;
  const lua_Integer count = luaL_checkinteger(L, 3);
  for (size_t i = 0; i < log->rows; i++) {
    const double *y = log->y + i * (size_t)log->columns + first;
    lua_Integer k = 0;
    while (k < count && y[k] == 0)
      k++;
    if (k == count) {
      lua_pushinteger(L, log->line[i]);
      return 1;
    }
  }
  return 0;
}

static int collect(lua_State *L) {
  struct fit_log *log = fit_log_at(L, 1);
  free(log->path);
  free(log->t);
  free(log->y);
  free(log->line);
  memset(log, 0, sizeof *log);
  return 0;
}

int host_log(lua_State *L) {
  static const luaL_Reg methods[] = {
      {"head", head}, {"read", read_rows}, {"spacing", spacing}, {"zero", zero}, {NULL, NULL}};
  const char *path = luaL_checkstring(L, 1);
  struct fit_log *log = lua_newuserdatauv(L, sizeof *log, 0);
  memset(log, 0, sizeof *log);
  if (luaL_newmetatable(L, FIT_LOG_TYPE)) {
    lua_pushcfunction(L, collect);
    lua_setfield(L, -2, "__gc");
    luaL_newlib(L, methods);
    lua_setfield(L, -2, "__index");
  }
  lua_setmetatable(L, -2);
  log->path = strdup(path);
  if (log->path == NULL)
    return luaL_error(L, "out of memory");
  return 1;
}
