/* csv.h - a file of comma separated values: the one reader of all commands.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The law of such a file, whatever command reads it (docs/csv.md):
 *     # units: s, rad/s, rad/s            a line that begins with # is a comment; these two words
 *     # sigma: , 0.004, 0.2               of one are read, of each column, up to a semicolon
 *     t,"wx",wy [deg/s]                   the first line that is no comment names the columns
 *     0.00,0.9063,nan                     an empty cell or nan is a value that is missing
 * A line ends with LF, CR LF or CR; lines of blanks and a byte order mark are passed over. A cell
 * may stand in double quotes, where "" is one of them; blanks around a cell do not count. A row has
 * as many cells as there are names. What is taken as a number is finite. Times ascend, and none is
 * missing. All else is answered with file, line, column and what stands there.
 */
#ifndef POLHODE_CSV_H
#define POLHODE_CSV_H

#include <lua.h>
#include <stddef.h>
#include <stdio.h>

struct csv {
  char *path, *text; /* text: the line that is read */
  FILE *file;
  unsigned number; /* of the line, from 1 on */
  int cut, bad;    /* does the file end inside it? the column that is wrong, from 1 on, or 0 */
  const char *why; /* what is wrong with the line */
  int width;       /* cells of each row */
  /* what was taken: `columns` values a row, NaN where there is none; t: NULL without times */
  size_t rows, room;
  int columns;
  double *t, *y;
  unsigned *line; /* of each row in the file */
};

/* csv(path) -> object | nil, message; "-" is standard input
   object:head() -> {names}, {units} | nil, {sigmas} | nil, line | nil, message
   object:read({{column, factor, needed}, ...}, timed) -> rows, {values of each} | nil, message.
   timed: the first column is the time; needed: no value may be missing
   object:texts() -> {{line =, cell, ...}, ...} | nil, message: instead of read, where cells are no
   numbers
   object:values(column) -> {numbers}, NaN where there is none; column 0: the time
   object:spacing() -> the usual distance of two rows, times of the first and the last; line of the
   first
   object:zero(column, count) -> line of the first row in which all of them are 0, or nil */
int host_csv(lua_State *L);
struct csv *csv_at(lua_State *L, int index);
/* The usual distance of two rows in time. */
double csv_spacing(const struct csv *f);

#endif
