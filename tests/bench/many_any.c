/* many_any.c - a step of any scene: many bodies at once beside one body alone.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Compiled for each scene with -DNAME=its name, -DNX=its number of states, and -include of its
 * headers. Both rows run in turn, ROUNDS rounds, and the medians are printed, in ns for a body and
 * a step. The results are compared, too: a body among many has the bits that it has alone.
 */
#include "clock.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define JOIN_NAMES(a, b) a##b
#define JOIN(a, b)       JOIN_NAMES(a, b)
#define OF(function)     JOIN(NAME, function)
#define TEXT_OF(name)    #name
#define TEXT(name)       TEXT_OF(name)

enum { ROUNDS = 11, BODIES = 512, STEPS = 100, INPUTS = 16 };

typedef OF(_real) real;

static OF(_model) model;
static real first[NX], start[NX * BODIES], one_by_one[NX * BODIES], all[NX * BODIES];
static real input[INPUTS * BODIES];
static const real h = (real)1e-4;

static double alone(void) {
  const double t = now();
  for (int k = 0; k < BODIES; k++) {
    real x[NX];
    for (int i = 0; i < NX; i++)
      x[i] = start[i * BODIES + k];
    for (int j = 0; j < STEPS; j++)
      OF(_step)(&model, (real)j * h, x, input, h);
    for (int i = 0; i < NX; i++)
      one_by_one[i * BODIES + k] = x[i];
  }
  return (now() - t) / BODIES / STEPS * 1e9;
}

static double together(void) {
  memcpy(all, start, sizeof all);
  const double t = now();
  OF(_advance_many)(&model, 0, all, input, h, STEPS, BODIES);
  return (now() - t) / BODIES / STEPS * 1e9;
}

int main(void) {
  double a[ROUNDS], b[ROUNDS];

  if (OF(_init)(&model, NULL) != 0)
    return 1;
  OF(_initial)(&model, first);
  for (int i = 0; i < NX; i++)
    for (int k = 0; k < BODIES; k++)
      start[i * BODIES + k] = first[i] * (i == NX - 1 ? 1 + (real)1e-5 * (real)k : 1);
  for (int r = 0; r < ROUNDS; r++) {
    a[r] = alone();
    b[r] = together();
  }
  qsort(a, ROUNDS, sizeof a[0], ascending);
  qsort(b, ROUNDS, sizeof b[0], ascending);
  const double x = a[ROUNDS / 2], y = b[ROUNDS / 2];
  const int unequal = memcmp(all, one_by_one, sizeof all) != 0;
  printf("%-20s %8.2f %8.2f %8.2f%s\n", TEXT(NAME), x, y, x / y,
         unequal ? "  the bits differ" : "");
  return unequal;
}
