/* course.h - inputs over time: columns of files, held or on lines, the same for every engine.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Between two breaks each input is constant or a straight line, so an engine that ends a step at
 * every break meets no corner inside one. Breaks are the times of the values, and where a line
 * crosses a limit of its input. Before the first value and after the last one these stay. Values
 * that are missing are passed over.
 */
#ifndef POLHODE_COURSE_H
#define POLHODE_COURSE_H

#include <lua.h>
#include <stddef.h>

enum { COURSE_INPUTS = 64 };

struct course_input {
  size_t rows; /* 0: it is `constant` */
  const double *t, *u;
  size_t *near; /* values up to the time that was asked for last */
  enum { COURSE_HELD, COURSE_LINEAR, COURSE_SLOPE } kind; /* COURSE_SLOPE: of the lines */
  double constant, low, high;                             /* its limits, or NaN */
};

struct course {
  int n;
  struct course_input input[COURSE_INPUTS];
};

/* Between two breaks input k is base[k] + slope[k] (t - since[k]). */
struct course_segment {
  double since[COURSE_INPUTS], base[COURSE_INPUTS], slope[COURSE_INPUTS];
};

/* course({false (it is 0) or {csv =, column =, kind = "held", "linear" or "slope", low, high =
 * limits or NaN}, ...}) -> object
 * object:linear() -> is any of them on lines? */
int host_course(lua_State *L);
/* The course of n inputs at `index`: such an object, {u1, ..., un}, or nil (all 0); into `own`
 * where it is no object. */
const struct course *course_at(lua_State *L, int index, int n, struct course *own);

int course_linear(const struct course *c);
/* The next break after t on the way to `end`, or `end`; both directions. */
double course_next(const struct course *c, double t, double end);
/* The inputs between two times without a break between them, and at one time. */
void course_segment(const struct course *c, double from, double to, struct course_segment *s);
void course_value(const struct course_segment *s, int n, double t, double u[]);

#endif
