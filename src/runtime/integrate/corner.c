/* corner.c - steps that end where the equations have corners or jumps.
   SPDX-License-Identifier: GPL-3.0-or-later

   |g|, sign(g), a limit and a plate that turns its edge to the light each have a function g whose
   sign says which piece of the equations holds (acts_side). Within a step every piece goes on as it
   began, whatever the sign (ph_top.branch): so what a method integrates is smooth, and where g
   passes zero is well defined. A step that has passed zeros is taken again to the first of them,
   and there the piece changes (Hairer, Norsett, Wanner, Solving ODEs I, II.6).

   Zeros are looked for at PATH + 1 points of the step, by classical Runge-Kutta from point to
   point. If their differences say that g is not resolved by so many, the step was too long. Two
   zeros between neighbours leave a minimum: where the parabola through three points comes near
   zero, it is looked for. */
#include "corner.h"

#include <stdlib.h>

#include "acts/acts.h"

enum { PATH = 8 };

/* As g touches zero, its error is the square of the time's: 1e-8 of the step is enough. */
static const ph_wide TOUCH = 1e-8L;
/* The eighth difference over the largest value: a sine is resolved by 8 points a period. */
static const ph_wide ROUGH = 0.1L;

int corners_new(corners *c, const ph_top *top) {
  *c = (corners){.n = acts_sides(top)};
  const size_t n = (size_t)c->n;
  if (n == 0)
    return PH_OK;
  c->side = malloc(n * (PATH + 2) * sizeof *c->side);
  c->branch = calloc(n, 1);
  return c->side && c->branch ? PH_OK : PH_EMEMORY;
}

void corners_free(corners *c) {
  free(c->side);
  free(c->branch);
}

static int sign(ph_wide g) {
  return (g > 0) - (g < 0);
}

void corners_begin(corners *c, const stepper *s, ph_wide span, const ph_wide x[]) {
  c->crowded = 0;
  c->span = fabsl(span);
  for (int i = 0; i < c->n; i++)
    c->branch[i] = 0;
  acts_side(s->top, s->t, x, c->side);
  for (int i = 0; i < c->n; i++)
    c->branch[i] = (signed char)sign(c->side[i]);
}

int corners_settle(corners *c, stepper *s, ph_wide h, const ph_wide x[]) {
  ph_wide f[PH_STATES], y[PH_STATES], *later = c->side;
  int open = 0;
  for (int i = 0; i < c->n; i++)
    open = open || c->branch[i] == 0;
  if (!open)
    return PH_OK;
  const int status = motion_rates(s->top, &s->loads, s->t, x, f);
  s->evaluations++;
  for (int part = 0; part < 2 && !status; part++) { /* where it is, or a little later on its way */
    const ph_wide step = part * h / 1024;
    for (int i = 0; i < ph_top_states(s->top); i++)
      y[i] = x[i] + step * f[i];
    acts_side(s->top, s->t + step, y, later);
    for (int i = 0; i < c->n; i++)
      if (c->branch[i] == 0)
        c->branch[i] = (signed char)sign(later[i]);
  }
  return status;
}

/* A few roundings of the times of a step to h. */
static ph_wide rounding(const corners *c, const stepper *s, ph_wide h) {
  return 4 * LDBL_EPSILON * fmaxl(c->span / 1024, fmaxl(fabsl(s->t), fabsl(s->t + h)));
}

/* The sides at the points of a step from x to y. */
static int follow(corners *c, stepper *s, const ph_wide x[], ph_wide h, const ph_wide y[]) {
  const ph_wide start = s->t;
  const int n = ph_top_states(s->top);
  ph_wide z[PATH + 1][PH_STATES];
  int status = PH_OK;
  for (int i = 0; i < n; i++)
    z[0][i] = x[i];
  for (int k = 0; k < PATH && !status; k++) {
    s->t = start + h * k / PATH;
    status = step_rk4(s, z[k], h / PATH, z[k + 1]);
  }
  s->t = start;
  for (int k = 0; k <= PATH && !status; k++) {
    ph_wide at[PH_STATES]; /* the method's own end, and what is missing to it on the way */
    for (int i = 0; i < n; i++)
      at[i] = k == PATH ? y[i] : z[k][i] + (y[i] - z[PATH][i]) * k / PATH;
    acts_side(s->top, start + h * k / PATH, at, c->side + k * c->n);
  }
  return status;
}

/* Side i at point k, positive as long as its piece goes on. */
static ph_wide inside(const corners *c, int k, int i) {
  return c->branch[i] * c->side[k * c->n + i];
}

/* The first point at which a side has changed, PATH + 1: none. */
static int first_change(const corners *c) {
  for (int k = 1; k <= PATH; k++)
    for (int i = 0; i < c->n; i++)
      if (inside(c, k, i) < 0)
        return k;
  return PATH + 1;
}

/* Do the points resolve all sides? */
static int resolved(const corners *c) {
  static const int binomial[PATH + 1] = {1, -8, 28, -56, 70, -56, 28, -8, 1};
  for (int i = 0; i < c->n; i++) {
    ph_wide rough = 0, size = 0;
    for (int k = 0; k <= PATH; k++) {
      rough += binomial[k] * inside(c, k, i);
      size = fmaxl(size, fabsl(inside(c, k, i)));
    }
    if (fabsl(rough) > ROUGH * size)
      return 0;
  }
  return 1;
}

/* May side i have touched zero between the points k - 1 and k + 1? */
static int touches(const corners *c, int k, int i) {
  const ph_wide a = inside(c, k - 1, i), b = inside(c, k, i), d = inside(c, k + 1, i);
  const ph_wide bend = a - 2 * b + d, slope = (d - a) / 2;
  const ph_wide third =
      k > 1 ? d - 3 * b + 3 * a - inside(c, k - 2, i) : inside(c, k + 2, i) - 3 * d + 3 * b - a;
  return bend > 0 && fabsl(slope) <= bend &&
         b - slope * slope / (2 * bend) <= 0.1L * bend + fabsl(third);
}

/* Steps of other lengths from the same start. */
typedef struct probe {
  corners *c;
  stepper *s;
  corner_stepper *again;
  void *of;
  const ph_wide *x;
  int only;      /* the side that is watched, -1: all */
  ph_wide taken; /* what the method made of the step */
} probe;

/* A step to h. *least: of the sides that are watched at its end, in parts of their sizes; < 0: one
   has changed. */
static int look(probe *p, ph_wide h, ph_wide y[], ph_wide *least) {
  corners *c = p->c;
  ph_wide *end = c->side + (PATH + 1) * c->n;
  p->taken = h;
  const int status = p->again(p->of, p->x, &p->taken, y);
  if (status)
    return status;
  acts_side(p->s->top, p->s->t + p->taken, y, end);
  *least = HUGE_VALL;
  for (int i = 0; i < c->n; i++) {
    ph_wide size = 0;
    for (int k = 0; k <= PATH; k++)
      size = fmaxl(size, fabsl(inside(c, k, i)));
    if (c->branch[i] != 0 && size > 0 && (p->only < 0 || p->only == i))
      *least = fminl(*least, c->branch[i] * end[i] / size);
  }
  return PH_OK;
}

static void copy(const stepper *s, const ph_wide from[], ph_wide to[]) {
  for (int i = 0; i < ph_top_states(s->top); i++)
    to[i] = from[i];
}

/* By golden section the least of side `only` between low and *high; *high < 0 comes back where it
   has changed, with the state there, else 0. */
static int deepest(probe *p, ph_wide low, ph_wide *high, ph_wide y[]) {
  static const ph_wide RATIO = 0.61803398874989484820L;
  const ph_wide span = *high;
  ph_wide b = *high, left = b - RATIO * (b - low), right = low + RATIO * (b - low), gl, gr;
  *high = 0;
  int status = look(p, left, y, &gl);
  if (!status && gl < 0) {
    *high = p->taken;
    return PH_OK;
  }
  if (!status)
    status = look(p, right, y, &gr);
  while (!status) {
    if (gr < 0) {
      *high = p->taken;
      return PH_OK;
    }
    if (fabsl(b - low) <= TOUCH * fabsl(span))
      return PH_OK;
    if (gl < gr) {
      b = right, right = left, gr = gl;
      left = b - RATIO * (b - low);
      status = look(p, left, y, &gl);
      if (!status && gl < 0) {
        *high = p->taken;
        return PH_OK;
      }
    } else {
      low = left, left = right, gl = gr;
      right = low + RATIO * (b - low);
      status = look(p, right, y, &gr);
    }
  }
  return status;
}

/* Between low, where all is as it began, and *h, where y has changed, the first change: the false
   position with halved weights (Illinois: Dowell and Jarratt, BIT 11 (1971) 168). */
static int narrow(probe *p, ph_wide low, ph_wide *h, ph_wide y[]) {
  enum { MOST = 200 };
  ph_wide high = *h, g_low = 0, g_high = 0, z[PH_STATES], g;
  int last = 0;
  p->only = -1;
  for (int i = 0; i < MOST; i++) {
    const ph_wide close = rounding(p->c, p->s, high);
    if (fabsl(high - low) <= close)
      break;
    ph_wide at = low + (high - low) / 2;
    if (i % 3 != 2 && g_high < g_low) {
      const ph_wide chord = low + (high - low) * (g_low / (g_low - g_high));
      if (fabsl(chord - low) >= close / 2 && fabsl(high - chord) >= close / 2)
        at = chord;
    }
    const int status = look(p, at, z, &g);
    if (status)
      return status;
    if (g < 0) {
      high = p->taken, g_high = g;
      g_low = last > 0 ? g_low / 2 : g_low;
      last = 1;
      copy(p->s, z, y);
    } else {
      low = p->taken, g_low = g;
      g_high = last < 0 ? g_high / 2 : g_high;
      last = -1;
    }
  }
  *h = high;
  return PH_OK;
}

/* The piece changes at the end of a step: of all sides that y is beyond. */
static int change(corners *c, const stepper *s, ph_wide h, const ph_wide y[]) {
  enum { CROWD = 40 };
  acts_side(s->top, s->t + h, y, c->side);
  for (int i = 0; i < c->n; i++)
    if (inside(c, 0, i) < 0)
      c->branch[i] = (signed char)-c->branch[i];
  c->crowded = fabsl(h) <= 16 * rounding(c, s, h) ? c->crowded + 1 : 0;
  return c->crowded > CROWD + 2 * c->n ? PH_ECHATTER : PH_OK;
}

/* The last point before a change, and the change with its state; 0: there is none. */
static int bracket(probe *p, ph_wide h, ph_wide *low, ph_wide *high, ph_wide y[]) {
  corners *c = p->c;
  const int first = first_change(c);
  *high = 0;
  for (int k = 1; k < PATH && k < first; k++)
    for (int i = 0; i < c->n; i++) {
      if (!touches(c, k, i))
        continue;
      *low = h * (k - 1) / PATH;
      *high = h * (k + 1) / PATH;
      p->only = i;
      const int status = deepest(p, *low, high, y);
      if (status || *high != 0)
        return status;
    }
  if (first > PATH)
    return PH_OK;
  *low = h * (first - 1) / PATH;
  *high = h * first / PATH;
  ph_wide g;
  p->only = -1;
  const int status = look(p, *high, y, &g);
  *high = p->taken;
  if (!status && g >= 0) { /* the points said more than is so: the change comes later */
    *low = *high;
    const int later = look(p, h, y, &g);
    *high = g < 0 ? p->taken : 0;
    return later;
  }
  return status;
}

int corners_cut(corners *c, stepper *s, corner_stepper *again, void *of, const ph_wide x[],
                ph_wide *h, ph_wide *next, ph_wide y[]) {
  probe p = {c, s, again, of, x, -1, *h};
  for (;;) {
    int status = follow(c, s, x, *h, y);
    if (status && status != PH_ERANGE)
      return status;
    if (!status && resolved(c))
      break;
    *h /= 2;
    if (s->t + *h == s->t)
      return PH_ESTEP;
    status = again(of, x, h, y);
    if (status)
      return status;
    *next = fabsl(*h);
  }
  ph_wide low = 0, high = 0, z[PH_STATES];
  int status = bracket(&p, *h, &low, &high, z);
  if (!status && high != 0) {
    status = narrow(&p, low, &high, z);
    copy(s, z, y);
    *h = high;
  }
  return status ? status : change(c, s, *h, y);
}
