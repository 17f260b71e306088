/* csv.c - a file of comma separated values, read line by line into columns of numbers.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#define _GNU_SOURCE /* getc_unlocked */
#include "csv.h"
#include "fields.h"
#include "host.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#define CSV_TYPE "polhode.csv"
#define MOST     1e8 /* numbers */

enum { LONGEST = 1 << 20, SAID = 120 }; /* bytes of a line, of a message */

/* A column that is taken. */
struct taken {
  int place, needed; /* needed: no value may be missing */
  double factor;
  lua_Integer values;
};

struct csv *csv_at(lua_State *L, int index) {
  return luaL_checkudata(L, index, CSV_TYPE);
}

/* ---- lines and cells ---- */

/* The next line, without its end.  0: there is none, or f->why says what is wrong. */
static int next(struct csv *f) {
  size_t n = 0;
  int c;
  f->number++;
  while ((c = getc_unlocked(f->file)) != EOF && c != '\n' && c != '\r') {
    if (c == '\0' || n == LONGEST - 1) {
      f->why = c == '\0' ? "must be text in UTF-8, got a byte of 0" : "is longer than 1 MiB";
      return 0;
    }
    f->text[n++] = (char)c;
  }
  f->cut = c == EOF;
  if (c == '\r' && (c = getc_unlocked(f->file)) != '\n')
    ungetc(c, f->file);
  f->text[n] = '\0';
  if (f->number == 1 && strncmp(f->text, "\357\273\277", 3) == 0)
    memmove(f->text, f->text + 3, n - 2);
  if (ferror(f->file))
    f->why = "cannot be read";
  return f->why == NULL && (n > 0 || !f->cut);
}

static char *line_begin(const struct csv *f) {
  return f->text + strspn(f->text, " \t");
}

static int next_row(struct csv *f) {
  while (next(f))
    if (*line_begin(f) != '\0' && *line_begin(f) != '#')
      return 1;
  return 0;
}

/* The next cell of a line, which is cut up; NULL behind the last one.  A quote without its end is
 * said in f->why. */
static char *cell(struct csv *f, char **rest) {
  char *from = *rest, *to;
  if (from == NULL)
    return NULL;
  from += strspn(from, " \t");
  char *end = from;
  if (*from == '"') {
    for (to = ++from, end = from; *to != '\0' && (*to != '"' || to[1] == '"'); *end++ = *to++)
      to += *to == '"';
    const int open = *to == '\0';
    to += !open;
    to += strspn(to, " \t");
    if (open || (*to != ',' && *to != '\0'))
      f->why = "a cell that begins with a quote must end with one";
  } else {
    to = end = from + strcspn(from, ",");
    while (end > from && (end[-1] == ' ' || end[-1] == '\t'))
      end--;
  }
  *rest = *to == ',' ? to + 1 : NULL;
  *end = '\0';
  return from;
}

/* Push the cells of a text as a list. */
static void push_cells(lua_State *L, struct csv *f, char *text) {
  lua_newtable(L);
  int n = 0;
  for (char *name; (name = cell(f, &text)) != NULL;) {
    lua_pushstring(L, name);
    lua_rawseti(L, -2, ++n);
  }
}

/* nil and f->why with file, line and column: 2. */
static int fail(lua_State *L, const struct csv *f) {
  lua_pushnil(L);
  lua_pushfstring(L, "%s:%d: ", f->path, (int)f->number);
  if (f->bad > 0) {
    lua_getiuservalue(L, 1, 1);
    lua_rawgeti(L, -1, f->bad);
    lua_pushfstring(L, "column %s ", lua_tostring(L, -1));
    lua_replace(L, -3);
    lua_pop(L, 1);
    lua_concat(L, 2);
  }
  lua_pushstring(L, f->why);
  lua_concat(L, 2);
  return 2;
}

/* ---- the head ---- */

/* The list behind a word of a comment, as the value at `index`, if it is there. */
static void noted(lua_State *L, struct csv *f, const char *word, int index) {
  char *list = strstr(f->text, word);
  if (list == NULL)
    return;
  list += strlen(word);
  char *remark = strchr(list, ';'), *copy = f->text + strlen(f->text) + 1;
  const size_t n = remark != NULL ? (size_t)(remark - list) : strlen(list);
  memcpy(copy, list, n); /* there is room for a line twice */
  copy[n] = '\0';
  push_cells(L, f, copy);
  lua_replace(L, index);
}

static int head(lua_State *L) {
  struct csv *f = csv_at(L, 1);
  lua_settop(L, 1);
  lua_pushnil(L); /* 2: units */
  lua_pushnil(L); /* 3: sigmas */
  while (f->why == NULL && next(f)) {
    if (*line_begin(f) == '#') {
      noted(L, f, "units:", 2);
      noted(L, f, "sigma:", 3);
    } else if (*line_begin(f) != '\0') {
      push_cells(L, f, f->text);
      if (f->why != NULL)
        break;
      f->width = (int)lua_rawlen(L, -1);
      lua_pushvalue(L, -1);
      lua_setiuservalue(L, 1, 1);
      lua_insert(L, 2);
      lua_pushinteger(L, f->number);
      return 4;
    }
  }
  if (f->why != NULL)
    return fail(L, f);
  lua_pushnil(L);
  lua_pushfstring(L, "%s: has no line that names its columns", f->path);
  return 2;
}

/* ---- rows ---- */

static int is_missing(const char *s) {
  return *s == '\0' || strcasecmp(s + (*s == '-'), "nan") == 0;
}

/* The cells of a row, as many as the head has; 0: f->why. */
static int cells_of(struct csv *f, char *cells[], char said[SAID]) {
  int n = 0;
  char *rest = f->text;
  for (char *c; (c = cell(f, &rest)) != NULL; n++)
    if (n < f->width)
      cells[n] = c;
  if (f->why == NULL && n != f->width) {
    snprintf(said, SAID, "%d cells expected, got %d%s", f->width, n,
             f->cut ? ", where the file ends" : "");
    f->why = said;
  }
  return f->why == NULL;
}

static int grow(struct csv *f, int timed) {
  if (f->rows < f->room)
    return 1;
  const size_t room = f->room + f->room / 4 + 1024; /* little is left over */
  double *t = timed ? realloc(f->t, room * sizeof *t) : NULL;
  if (t != NULL)
    f->t = t;
  double *y = realloc(f->y, room * ((size_t)f->columns + 1) * sizeof *y);
  if (y != NULL)
    f->y = y;
  unsigned *line = realloc(f->line, room * sizeof *line);
  if (line != NULL)
    f->line = line;
  f->room = room;
  return (t != NULL || !timed) && y != NULL && line != NULL;
}

/* The number of a cell; 0: f->why. */
static int number(struct csv *f, const char *s, int place, double *x, char said[SAID]) {
  char *end;
  *x = strtod(s, &end);
  if (end != s && *end == '\0' && isfinite(*x))
    return 1;
  snprintf(said, SAID, "must be a number, got \"%.40s\"", s);
  f->why = said;
  f->bad = place + 1;
  return 0;
}

/* Does the row's time follow the one before? */
static int ascends(struct csv *f, double t, char said[SAID]) {
  if (f->rows == 0 || t > f->t[f->rows - 1])
    return 1;
  snprintf(said, SAID, "times must ascend, got %.15g s after %.15g s", t, f->t[f->rows - 1]);
  f->why = said;
  return 0;
}

/* The values of a line; 0: f->why. */
static int row(struct csv *f, struct taken *taken, int timed, char *cells[], char said[SAID]) {
  if (!cells_of(f, cells, said))
    return 0;
  if (!grow(f, timed) || (double)(f->rows + 1) * (f->columns + timed) > MOST) {
    f->why = "there must be at most 1e8 numbers, and memory for them";
    return 0;
  }
  double *y = f->y + f->rows * (size_t)f->columns;
  for (int i = 0; i < f->columns + timed; i++) {
    struct taken *c = &taken[i];
    const char *text = cells[c->place];
    const int is_time = timed && i == 0;
    double x = (double)NAN;
    if ((c->needed || !is_missing(text)) && !number(f, text, c->place, &x, said))
      return 0;
    x *= c->factor;
    c->values += x == x;
    if (is_time && !ascends(f, x, said))
      return 0;
    *(is_time ? f->t + f->rows : y + i - timed) = x;
  }
  f->line[f->rows++] = f->number;
  return 1;
}

static int read_rows(lua_State *L) {
  struct csv *f = csv_at(L, 1);
  const int n = (int)lua_rawlen(L, 2), timed = lua_toboolean(L, 3);
  char said[SAID];
  f->columns = n - timed;
  struct taken *taken = lua_newuserdatauv(L, ((size_t)n + 1) * sizeof *taken, 0);
  for (int i = 0; i < n; i++) {
    lua_rawgeti(L, 2, i + 1);
    lua_rawgeti(L, -1, 1);
    lua_rawgeti(L, -2, 2);
    lua_rawgeti(L, -3, 3);
    taken[i] =
        (struct taken){(int)lua_tointeger(L, -3) - 1, lua_toboolean(L, -1), lua_tonumber(L, -2), 0};
    luaL_argcheck(L, taken[i].place >= 0 && taken[i].place < f->width, 2, "no such column");
    lua_pop(L, 4);
  }
  char **cells = lua_newuserdatauv(L, (size_t)f->width * sizeof *cells, 0);
  while (next_row(f) && row(f, taken, timed, cells, said))
    ;
  if (f->why != NULL)
    return fail(L, f);
  lua_pushinteger(L, (lua_Integer)f->rows);
  lua_createtable(L, n, 0);
  for (int i = timed; i < n; i++) {
    lua_pushinteger(L, taken[i].values);
    lua_rawseti(L, -2, i + 1 - timed);
  }
  return 2;
}

static int texts(lua_State *L) {
  struct csv *f = csv_at(L, 1);
  char said[SAID];
  char **cells = lua_newuserdatauv(L, (size_t)f->width * sizeof *cells, 0);
  lua_newtable(L);
  for (lua_Integer n = 1; next_row(f) && cells_of(f, cells, said); n++) {
    lua_createtable(L, f->width, 1);
    for (int i = 0; i < f->width; i++) {
      lua_pushstring(L, cells[i]);
      lua_rawseti(L, -2, i + 1);
    }
    fields_set_count(L, "line", f->number);
    lua_rawseti(L, -2, n);
  }
  return f->why != NULL ? fail(L, f) : 1;
}

/* ---- what was read ---- */

static int values(lua_State *L) {
  const struct csv *f = csv_at(L, 1);
  const lua_Integer column = luaL_checkinteger(L, 2);
  luaL_argcheck(L, column >= (f->t != NULL ? 0 : 1) && column <= f->columns, 2, "no such column");
  lua_createtable(L, (int)f->rows, 0);
  for (size_t i = 0; i < f->rows; i++) {
    lua_pushnumber(L, column == 0 ? f->t[i] : f->y[i * (size_t)f->columns + (size_t)column - 1]);
    lua_rawseti(L, -2, (lua_Integer)i + 1);
  }
  return 1;
}

static int ascending(const void *a, const void *b) {
  const double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

/* The median of the first thousand distances. */
double csv_spacing(const struct csv *f) {
  double d[1000] = {0};
  size_t n = 0;
  for (size_t i = 1; i < f->rows && n < 1000; i++)
    d[n++] = f->t[i] - f->t[i - 1];
  qsort(d, n, sizeof d[0], ascending);
  return n > 0 ? d[n / 2] : 1;
}

static int spacing(lua_State *L) {
  const struct csv *f = csv_at(L, 1);
  luaL_argcheck(L, f->rows > 0 && f->t != NULL, 1, "no times");
  lua_pushnumber(L, csv_spacing(f));
  lua_pushnumber(L, f->t[0]);
  lua_pushnumber(L, f->t[f->rows - 1]);
  lua_pushinteger(L, f->line[0]);
  return 4;
}

static int zero(lua_State *L) {
  const struct csv *f = csv_at(L, 1);
  const size_t first = (size_t)luaL_checkinteger(L, 2) - 1;
  const lua_Integer count = luaL_checkinteger(L, 3);
  for (size_t i = 0; i < f->rows; i++) {
    const double *y = f->y + i * (size_t)f->columns + first;
    lua_Integer k = 0;
    while (k < count && y[k] == 0)
      k++;
    if (k == count) {
      lua_pushinteger(L, f->line[i]);
      return 1;
    }
  }
  return 0;
}

static int collect(lua_State *L) {
  struct csv *f = csv_at(L, 1);
  if (f->file != NULL && f->file != stdin)
    fclose(f->file);
  free(f->path);
  free(f->text);
  free(f->t);
  free(f->y);
  free(f->line);
  memset(f, 0, sizeof *f);
  return 0;
}

int host_csv(lua_State *L) {
  static const luaL_Reg methods[] = {{"head", head},     {"read", read_rows},  {"texts", texts},
                                     {"values", values}, {"spacing", spacing}, {"zero", zero},
                                     {NULL, NULL}};
  const char *path = luaL_checkstring(L, 1), *why = NULL;
  const int input = strcmp(path, "-") == 0;
  struct csv *f = lua_newuserdatauv(L, sizeof *f, 1);
  memset(f, 0, sizeof *f);
  if (luaL_newmetatable(L, CSV_TYPE)) {
    lua_pushcfunction(L, collect);
    lua_setfield(L, -2, "__gc");
    luaL_newlib(L, methods);
    lua_setfield(L, -2, "__index");
  }
  lua_setmetatable(L, -2);
  f->path = strdup(input ? "standard input" : path);
  f->text = malloc(2 * (size_t)LONGEST);
  if (f->path == NULL || f->text == NULL)
    return luaL_error(L, "out of memory");
  off_t size;
  const int fd = input ? -1 : host_open_file(path, &size, &why);
  f->file = input ? stdin : fd < 0 ? NULL : fdopen(fd, "r");
  if (f->file != NULL)
    return 1;
  lua_pushnil(L);
  lua_pushfstring(L, "cannot read %s: %s", path, why);
  return 2;
}
