/* odd.c - columns of a log that no sensor measures so: constant, at a limit, wrapped.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A value that is cut off at a limit stays there for some rows, and was moving fast when it came
 * there.  So does a rounded value at the top of a wave, but slowly: the wave is a parabola there,
 * so within another length of the run it falls by about nine times the rounding's step.
 */
#include "fit.h"
#include "host/csv.h"
#include "host/fields.h"
#include "host/host.h"

#include <math.h>

enum { RUN = 5 };         /* rows at a limit */
#define TURN (2.2 * M_PI) /* an angle without its turns is within one, and noise */
#define FAST 50 /* steps of rounding that a value at a limit came by, over the run's length */

/* What is seen of a column. */
struct seen {
  double low, high, least; /* least: the smallest change that is not 0 */
  size_t values, first;    /* how many there are, the first one's row */
  size_t wrap;             /* the row behind a jump of a turn, or 0 */
  double jump;             /* that jump */
};

static double at(const struct csv *log, int column, size_t row) {
  return log->y[row * (size_t)log->columns + (size_t)column];
}

/* An angle without its turns jumps by more than half a turn, and then goes on from there; a gross
 * error comes back.  Only what is nearly a turn may come back: an angle that stays near the jump.
 */
static struct seen look(const struct csv *log, int column) {
  struct seen s = {.low = (double)INFINITY, .high = -(double)INFINITY, .least = (double)INFINITY};
  double last = (double)NAN,
         jump = 0; /* jump: the change before, if it was one and may be a turn */
  size_t row = 0;
  for (size_t i = 0; i < log->rows; i++) {
    const double y = at(log, column, i), change = y - last, size = fabs(change);
    if (isnan(y))
      continue;
    if (s.values++ == 0)
      s.first = i;
    s.low = fmin(s.low, y);
    s.high = fmax(s.high, y);
    if (size > 0)
      s.least = fmin(s.least, size);
    const int large = size > M_PI, turn = size > 1.8 * M_PI && size < 2.2 * M_PI;
    if (s.wrap == 0 && (turn || (jump != 0 && !large))) {
      s.wrap = turn ? i : row;
      s.jump = turn ? change : jump;
    }
    jump = large && jump == 0 ? change : 0;
    row = i;
    last = y;
  }
  return s;
}

/* The longest run of rows at a value, its first row; 0: none that came there fast. */
static size_t run_at(const struct csv *log, int column, double value, double least, size_t *first) {
  size_t most = 0;
  for (size_t i = 0; i < log->rows; i++) {
    size_t n = 0;
    while (i + n < log->rows && at(log, column, i + n) == value)
      n++;
    if (n >= RUN && n > most) {
      double far = 0; /* of the value, within another length of the run */
      for (size_t k = 1; k <= n; k++) {
        far = fmax(far, i >= k ? fabs(at(log, column, i - k) - value) : 0);
        far = fmax(far, i + n + k <= log->rows ? fabs(at(log, column, i + n + k - 1) - value) : 0);
      }
      if (far > FAST * least) {
        most = n;
        *first = i;
      }
    }
    i += n;
  }
  return most;
}

static void say(lua_State *L, const struct csv *log, const char *kind, size_t row, double value,
                size_t rows) {
  lua_pushstring(L, kind);
  lua_setfield(L, -2, "kind");
  fields_set_number(L, "line", log->line[row]);
  fields_set_number(L, "value", value);
  fields_set_number(L, "rows", (double)rows);
}

int host_odd(lua_State *L) {
  const struct csv *log = csv_at(L, 1);
  lua_createtable(L, log->columns, 0);
  for (int column = 0; column < log->columns; column++) {
    const struct seen s = look(log, column);
    size_t first = 0, rows = 0;
    lua_createtable(L, 0, 5);
    fields_set_flag(L, "turn", s.high - s.low < TURN);
    if (s.values >= 2 * RUN && s.low == s.high) {
      say(L, log, "constant", s.first, s.low, s.values);
    } else if (s.wrap > 0 && s.high - s.low < TURN) {
      say(L, log, "wrapped", s.wrap, s.jump, 1);
    } else {
      if ((rows = run_at(log, column, s.low, s.least, &first)) > 0) {
        say(L, log, "limit", first, s.low, rows);
        fields_set_number(L, "low", s.low);
      }
      if ((rows = run_at(log, column, s.high, s.least, &first)) > 0) {
        say(L, log, "limit", first, s.high, rows);
        fields_set_number(L, "high", s.high);
      }
    }
    lua_rawseti(L, -2, column + 1);
  }
  return 1;
}
