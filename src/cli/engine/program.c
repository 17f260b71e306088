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
    break;
  }
  return (sized){y, fabsl(y) + fabsl(slope) * a.size};
}

/* How many functions change sign where it has corners or jumps. */
static int sides_of(enum program_op op) {
  return op == CLAMP ? 2 : op >= ABS || op == ATAN2 ? 1 : 0;
}

/* Which piece of a program runs, and where the values of its sides go; NULL each. */
struct piece {
  const signed char *branch;
  long double *side;
};

/* The sign of side i, that of a - b; b NULL: of a. */
static int sign(const struct piece *p, int i, sized a, const sized *b) {
  const long double g = b ? a.value - b->value : a.value, size = b ? a.size + b->size : a.size;
  if (p->side)
    p->side[i] = fabsl(g) > 4 * LDBL_EPSILON * size ? g : 0;
  return p->branch && p->branch[i] ? p->branch[i] : (g > 0) - (g < 0);
}

/* What has corners or jumps, of the operands a[0] on. */
static sized choose(const struct program_instruction *c, const sized a[], const struct piece *p) {
  const sized minus = {-a[0].value, a[0].size};
  sized x;
  int s;
  switch (c->op) {
  case SIGN:
    s = sign(p, c->side, a[0], NULL);
    return (sized){s, s != 0};
  case MIN:
    return sign(p, c->side, a[0], &a[1]) > 0 ? a[1] : a[0];
  case MAX:
    return sign(p, c->side, a[0], &a[1]) < 0 ? a[1] : a[0];
  case CLAMP: /* x, low, high; NaN counts as 0 */
    x = isnan(a[0].value) ? (sized){0, 0} : a[0];
    s = sign(p, c->side + 1, x, &a[2]);
    return sign(p, c->side, x, &a[1]) < 0 ? a[1] : s > 0 ? a[2] : x;
  default: /* ABS */
    return sign(p, c->side, a[0], NULL) < 0 ? minus : a[0];
  }
}

/* The angle, beyond a half turn where the branch goes on there. */
static sized angle(const struct program_instruction *c, const sized a[], const struct piece *p) {
  static const long double TURN = 6.28318530717958647692528676655900577L;
  sized r = call(ATAN2, a[0], a[1]);
  const int s = sign(p, c->side, a[0], NULL);
  if (p->branch && a[1].value < 0 && s * r.value < 0)
    r.value += s * TURN;
  return r;
}

static sized run(const struct engine_program *p, long double t, const long double x[],
                 struct piece piece) {
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
      r.value =
          p->input->base[c->n] + p->input->slope[c->n] * (t - (long double)p->input->since[c->n]);
      r.size = fabsl(r.value);
    } else if (sides_of(c->op) > 0) {
      top -= c->n;
      r = (c->op == ATAN2 ? angle : choose)(c, stack + top, &piece);
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
  return run(program, t, x, (struct piece){0}).value;
}

static long double value_on(void *program, long double t, const long double x[],
                            const signed char branch[], long double side[]) {
  return run(program, t, x, (struct piece){branch, side}).value;
}

double engine_program_size(const ph_varying *v, double t, const double x[], int n) {
  long double y[PH_STATES];
  if (v->f != engine_program_value)
    return 0;
  for (int i = 0; i < n; i++)
    y[i] = x[i];
  return (double)run(v->context, t, y, (struct piece){0}).size;
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
  p->length = p->sides = 0;
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
    c->side = p->sides;
    p->sides += sides_of(c->op);
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
  *out =
      (ph_varying){.f = engine_program_value, .context = p, .sides = p->sides, .piece = value_on};
}
