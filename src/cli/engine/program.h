/* program.h - the instructions of a program: program.c reads and runs them, jet.c differentiates.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef POLHODE_PROGRAM_H
#define POLHODE_PROGRAM_H

#include "engine.h"

#define PROGRAM_DEPTH 64
#define PROGRAM_CODE  20000

enum program_op {
  NUMBER,
  VARIABLE,
  INPUT,
  ADD,
  MUL,
  POW,
  SIN,
  COS,
  TAN,
  ASIN,
  ACOS,
  ATAN,
  ATAN2,
  EXP,
  LOG,
  SINH,
  COSH,
  TANH,
  ABS,
  SIGN,
  MIN,
  MAX,
  CLAMP
};

struct program_instruction {
  enum program_op op;
  int n;    /* operands, or the variable */
  int side; /* number of its first side */
  long double value, q;
};

struct engine_program {
  int length, sides;
  const struct course_segment *input;
  struct program_instruction code[];
};

#endif
