/* program.c - expressions of a scene, evaluated for the library in long double.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A program is the list of generator/dynamics/postfix.lua, checked once when it is read, so that
 * running it needs no checks.  Beside each value goes its size: the value with every term of every
 * sum made positive, which is what two honest roundings can be compared by.
 */
#include "program.h"

#include <math.h>
#include <string.h>

/* In the order of program_op.  Behind its word an instruction has, in the list: n its number as a
 * head and a tail, v and u which one, + and * how many operands, ^ numerator and denominator. */
static const char *const names[] = {"n",    "v",    "u",    "+",    "*",     "^",   "sin",   "cos",
                                    "tan",  "asin", "acos", "atan", "atan2", "exp", "log",   "sinh",
                                    "cosh", "tanh", "abs",  "sign", "min",   "max", "clamp", NULL};

typedef struct sized {
  long double value, size;
} sized;

/* Of f(x) the size is |f| + |f'| times that of x: what the roundings of x and of f come to. */
static sized call(enum program_op op, sized a, sized b) {
  const long double x = a.value;
  long double y = 0, slope = 0; /* |f'(x)| */
  switch (op) {
  case SIN:
    y = sinl(x), slope = cosl(x);
    break;
  case COS:
    y = cosl(x), slope = sinl(x);
    break;
  case TAN:
    y = tanl(x), slope = 1 + y * y;
    break;
  case ASIN:
    y = asinl(x), slope = 1 / sqrtl(1 - x * x);
    break;
  case ACOS:
    y = acosl(x), slope = 1 / sqrtl(1 - x * x);
    break;
  case ATAN:
    y = atanl(x), slope = 1 / (1 + x * x);
    break;
  case ATAN2: /* relative errors of both turn it by at most half of their sum */
    y = atan2l(x, b.value);
    return (sized){y, fabsl(y) + (x != 0 ? a.size / fabsl(x) : 0) +
                          (b.value != 0 ? b.size / fabsl(b.value) : 0)};
  case EXP:
    y = expl(x), slope = y;
    break;
  case LOG:
    y = logl(x), slope = 1 / x;
    break;
  case SINH:
    y = sinhl(x), slope = coshl(x);
    break;
  case COSH:
    y = coshl(x), slope = sinhl(x);
    break;
  case TANH:
    y = tanhl(x), slope = 1 - y * y;
    break;
  case SIGN:
    return (sized){(x > 0) - (x < 0), x != 0};
  case MIN:
    return b.value < x ? b : a;
  case MAX:
    return x < b.value ? b : a;
  default:
    return (sized){fabsl(x), a.size};
  }
  return (sized){y, fabsl(y) + fabsl(slope) * a.size};
}

static sized run(const struct engine_program *p, long double t, const long double x[]) {
  sized stack[PROGRAM_DEPTH];
  stack[0] = (sized){0, 0}; /* an empty program has the value 0 */
  int top = 0;
  for (int i = 0; i < p->length; i++) {
    const struct program_instruction *c = &p->code[i];
    sized r;
    if (c->op == NUMBER || c->op == VARIABLE) {
      r.value = c->op == NUMBER ? c->value : c->n == 0 ? t : x[c->n - 1];
      r.size = fabsl(r.value);
    } else if (c->op == INPUT) {
      r.value = p->input->base[c->n] + p->input->slope[c->n] * (t - (long double)p->input->since);
      r.size = fabsl(r.value);
    } else if (c->op == CLAMP) { /* x, low, high */
      top -= 3;
      const sized x0 = stack[top], low = stack[top + 1], high = stack[top + 2];
      r = x0.value < low.value ? low : x0.value > high.value ? high : x0;
    } else if (c->op == ADD || c->op == MUL) {
      r = stack[top -= c->n];
      for (int k = 1; k < c->n; k++) {
        const sized s = stack[top + k];
        r.value = c->op == ADD ? r.value + s.value : r.value * s.value;
        r.size = c->op == ADD ? r.size + s.size : r.size * s.size;
      }
    } else if (c->op == POW) {
      const sized s = stack[--top];
      const long double e = c->value / c->q;
      r.value = e == 0.5L ? sqrtl(s.value) : powl(s.value, e);
      r.size = s.value != 0 ? fabsl(r.value) * (s.size / fabsl(s.value)) * fmaxl(fabsl(e), 1)
                            : fabsl(r.value);
    } else {
      top -= c->n;
      r = call(c->op, stack[top], stack[top + c->n - 1]);
    }
    stack[top++] = r;
  }
  return stack[0];
}

long double engine_program_value(void *program, long double t, const long double x[]) {
  return run(program, t, x).value;
}

double engine_program_size(const ph_varying *v, double t, const double x[], int n) {
  long double y[PH_STATES];
  if (v->f != engine_program_value)
    return 0;
  for (int i = 0; i < n; i++)
    y[i] = x[i];
  return (double)run(v->context, t, y).size;
}

static long double item(lua_State *L, int *i) {
  lua_rawgeti(L, -1, ++*i);
  if (lua_type(L, -1) != LUA_TNUMBER)
    luaL_error(L, "program: a number expected at %d", *i);
  const long double x = lua_tonumber(L, -1);
  lua_pop(L, 1);
  return x;
}

void engine_read_program(struct engine_scene *s, ph_varying *out) {
  lua_State *L = s->L;
  const int n = (int)lua_rawlen(L, -1);
  if (n < 1 || n > PROGRAM_CODE)
    luaL_error(L, "program: from 1 to %d items", PROGRAM_CODE);
  struct engine_program *p = engine_aligned(
      lua_newuserdatauv(L, sizeof *p + (size_t)n * sizeof p->code[0] + ENGINE_ALIGNMENT, 0));
  lua_insert(L, -2);
  p->length = 0;
  p->input = s->input;
  int depth = 0;
  for (int i = 0; i < n;) {
    struct program_instruction *c = &p->code[p->length++];
    lua_rawgeti(L, -1, ++i);
    const char *name = luaL_checkstring(L, -1);
    int op = 0;
    while (names[op] && strcmp(names[op], name) != 0)
      op++;
    if (!names[op])
      luaL_error(L, "program: the library knows no function '%s'", name);
    lua_pop(L, 1);
    c->op = (enum program_op)op;
    c->n = op == CLAMP ? 3 : op == ATAN2 || op == MIN || op == MAX ? 2 : op >= POW ? 1 : 0;
    if (op == NUMBER) {
      c->value = item(L, &i);
      c->value += item(L, &i);
    } else if (op == POW) {
      c->value = item(L, &i);
      c->q = item(L, &i);
    } else if (op <= MUL) {
      c->n = (int)item(L, &i);
    }
    const int takes = op <= INPUT ? 0 : c->n;
    if ((op > INPUT && (takes < 1 || takes > depth)) ||
        (op == VARIABLE && (c->n < 0 || c->n > PH_STATES)) ||
        (op == INPUT && (c->n < 0 || c->n >= s->inputs)) || depth - takes + 1 > PROGRAM_DEPTH)
      luaL_error(L, "program: malformed or too deep at %d", i);
    depth += 1 - takes;
  }
  if (depth != 1)
    luaL_error(L, "program: leaves %d values", depth);
  lua_pop(L, 1);
  engine_keep(s);
  *out = (ph_varying){.f = engine_program_value, .context = p};
}
