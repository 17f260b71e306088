/* input.c - inputs over time: rows of a file, held from one to the next or joined by lines.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Both engines go from break to break: within a segment the inputs are constant or straight lines,
 * so no method meets a corner inside a step. Before the first row its values hold, after the last
 * one that one's.
 */
#include "engine.h"

#include <string.h>

/* Number k of row i, 0 the time. */
static double entry(const struct engine_course *c, int i, int k) {
  return c->row[(size_t)i * (size_t)(c->n + 1) + (size_t)k];
}

void engine_course_read(lua_State *L, int index, int n, struct engine_course *c) {
  *c = (struct engine_course){.n = n};
  luaL_argcheck(L, n <= ENGINE_INPUTS, index, "too many inputs");
  if (n == 0 || lua_isnoneornil(L, index)) {
    lua_pushnil(L);
    return;
  }
  luaL_checktype(L, index, LUA_TTABLE);
  if (lua_getfield(L, index, "rows") == LUA_TNIL) { /* one value each, or none */
    if (lua_rawlen(L, index) > 0)
      engine_list(L, index, n, c->constant);
    return;
  }
  const size_t length = lua_rawlen(L, -1);
  luaL_argcheck(L, length > 0 && length <= 100000000 && length % (size_t)(n + 1) == 0, index,
                "rows of the wrong length");
  double *row = lua_newuserdatauv(L, length * sizeof *row, 0);
  for (size_t i = 0; i < length; i++) {
    lua_rawgeti(L, -2, (lua_Integer)i + 1);
    row[i] = luaL_checknumber(L, -1);
    lua_pop(L, 1);
  }
  lua_remove(L, -2);
  lua_getfield(L, index, "linear");
  c->linear = lua_toboolean(L, -1);
  lua_pop(L, 1);
  c->row = row;
  c->rows = (int)(length / (size_t)(n + 1));
}

/* The last row at or before t, -1 if there is none: by halving. */
static int row_before(const struct engine_course *c, double t) {
  int low = -1, high = c->rows;
  while (high - low > 1) {
    const int middle = low + (high - low) / 2;
    if (entry(c, middle, 0) <= t)
      low = middle;
    else
      high = middle;
  }
  return low;
}

double engine_course_next(const struct engine_course *c, double t, double end) {
  if (c->rows == 0)
    return end;
  int i = row_before(c, t);
  if (end >= t) {
    i++;
    return i < c->rows && entry(c, i, 0) < end ? entry(c, i, 0) : end;
  }
  if (i >= 0 && entry(c, i, 0) == t)
    i--;
  return i >= 0 && entry(c, i, 0) > end ? entry(c, i, 0) : end;
}

void engine_course_segment(const struct engine_course *c, double from, double to,
                           struct engine_inputs *in) {
  memset(in, 0, sizeof *in);
  const int i = c->rows > 0 ? row_before(c, from + (to - from) / 2) : -1;
  const int first = i < 0 ? 0 : i;
  in->since = c->rows > 0 ? entry(c, first, 0) : 0;
  for (int k = 0; k < c->n; k++) {
    in->base[k] = c->rows > 0 ? entry(c, first, 1 + k) : c->constant[k];
    if (c->linear && i >= 0 && i + 1 < c->rows)
      in->slope[k] = (entry(c, i + 1, 1 + k) - in->base[k]) / (entry(c, i + 1, 0) - in->since);
  }
}

void engine_inputs_at(const struct engine_inputs *in, int n, double t, double u[]) {
  for (int k = 0; k < n; k++)
    u[k] = in->base[k] + in->slope[k] * (t - in->since);
}
