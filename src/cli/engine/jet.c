/* jet.c - a program of three variables with its first and second derivatives.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Every value carries its gradient and its six second derivatives through each instruction by the
 * chain rule (Griewank and Walther, Evaluating Derivatives, 13): no expression is differentiated,
 * which makes it another road than the generator's.
 */
#include "program.h"

#include <math.h>

enum { SIZE = 10 };

/* Places of the second derivatives: xx, yy, zz, xy, xz, yz by two first ones. */
static const int first[6] = {1, 2, 3, 1, 1, 2}, second[6] = {1, 2, 3, 2, 3, 3};

/* f(a) from f, f' and f'' at a's value. */
static void chain(long double f, long double slope, long double bend, long double a[SIZE]) {
  for (int k = 0; k < 6; k++)
    a[4 + k] = slope * a[4 + k] + bend * a[first[k]] * a[second[k]];
  for (int i = 1; i < 4; i++)
    a[i] *= slope;
  a[0] = f;
}

static void multiply(long double a[SIZE], const long double b[SIZE]) {
  for (int k = 0; k < 6; k++)
    a[4 + k] =
        a[0] * b[4 + k] + b[0] * a[4 + k] + a[first[k]] * b[second[k]] + a[second[k]] * b[first[k]];
  for (int i = 1; i < 4; i++)
    a[i] = a[0] * b[i] + b[0] * a[i];
  a[0] *= b[0];
}

/* A derivative of a power has the factor 0 where it ends: 0 times an infinite power is none. */
static long double term(long double factor, long double x, long double e) {
  return factor == 0 ? 0 : factor * powl(x, e);
}

static void power(long double e, long double a[SIZE]) {
  const long double x = a[0];
  chain(e == 0.5L ? sqrtl(x) : powl(x, e), term(e, x, e - 1), term(e * (e - 1), x, e - 2), a);
}

/* The angle of (x, y): its gradient is (x grad y - y grad x)/r^2. */
static void angle(long double y[SIZE], const long double x[SIZE]) {
  const long double r2 = x[0] * x[0] + y[0] * y[0];
  long double out[SIZE];
  out[0] = atan2l(y[0], x[0]);
  for (int i = 1; i < 4; i++)
    out[i] = (x[0] * y[i] - y[0] * x[i]) / r2;
  for (int k = 0; k < 6; k++) {
    const int i = first[k], j = second[k];
    out[4 + k] = (x[0] * y[4 + k] - y[0] * x[4 + k] + x[j] * y[i] - y[j] * x[i]) / r2 -
                 out[i] * 2 * (x[0] * x[j] + y[0] * y[j]) / r2;
  }
  for (int i = 0; i < SIZE; i++)
    y[i] = out[i];
}

static void call(enum program_op op, long double a[SIZE]) {
  const long double x = a[0], s = sinl(x), c = cosl(x);
  long double f, g;
  switch (op) {
  case SIN:
    chain(s, c, -s, a);
    break;
  case COS:
    chain(c, -s, -c, a);
    break;
  case TAN:
    f = tanl(x);
    chain(f, 1 + f * f, 2 * f * (1 + f * f), a);
    break;
  case ASIN:
    g = 1 / sqrtl((1 - x) * (1 + x));
    chain(asinl(x), g, x * g * g * g, a);
    break;
  case ACOS:
    g = 1 / sqrtl((1 - x) * (1 + x));
    chain(acosl(x), -g, -x * g * g * g, a);
    break;
  case ATAN:
    g = 1 / (1 + x * x);
    chain(atanl(x), g, -2 * x * g * g, a);
    break;
  case EXP:
    f = expl(x);
    chain(f, f, f, a);
    break;
  case LOG:
    chain(logl(x), 1 / x, -1 / (x * x), a);
    break;
  case SINH:
    chain(sinhl(x), coshl(x), sinhl(x), a);
    break;
  case COSH:
    chain(coshl(x), sinhl(x), coshl(x), a);
    break;
  case TANH:
    f = tanhl(x);
    chain(f, 1 - f * f, -2 * f * (1 - f * f), a);
    break;
  case SIGN:
    chain((x > 0) - (x < 0), 0, 0, a);
    break;
  default: /* ABS */
    chain(fabsl(x), x < 0 ? -1 : 1, 0, a);
  }
}

static void copy(long double a[SIZE], const long double b[SIZE]) {
  for (int i = 0; i < SIZE; i++)
    a[i] = b[i];
}

void engine_program_jet(void *program, const long double n[3], long double out[10]) {
  const struct engine_program *p = program;
  long double stack[PROGRAM_DEPTH][SIZE];
  int top = 0;
  for (int i = 0; i < p->length; i++) {
    const struct program_instruction *c = &p->code[i];
    if (c->op == NUMBER || c->op == VARIABLE || c->op == INPUT) {
      /* the reader of scenes lets no time and no input into such a program */
      for (int k = 0; k < SIZE; k++)
        stack[top][k] = 0;
      const int known = c->op == VARIABLE && c->n >= 1 && c->n <= 3;
      stack[top][0] = known ? n[c->n - 1] : c->value;
      if (known)
        stack[top][c->n] = 1;
      top++;
      continue;
    }
    top -= c->n;
    long double(*a)[SIZE] = stack + top++;
    if (c->op == ADD || c->op == MUL) {
      for (int k = 1; k < c->n; k++)
        if (c->op == MUL)
          multiply(a[0], a[k]);
        else
          for (int j = 0; j < SIZE; j++)
            a[0][j] += a[k][j];
    } else if (c->op == POW) {
      power(c->value / c->q, a[0]);
    } else if (c->op == ATAN2) {
      angle(a[0], a[1]);
    } else if (c->op == MIN || c->op == MAX) {
      if (c->op == MIN ? a[1][0] < a[0][0] : a[0][0] < a[1][0])
        copy(a[0], a[1]);
    } else if (c->op == CLAMP) { /* x, low, high */
      if (a[0][0] < a[1][0])
        copy(a[0], a[1]);
      else if (a[0][0] > a[2][0])
        copy(a[0], a[2]);
    } else {
      call(c->op, a[0]);
    }
  }
  copy(out, stack[0]);
}
