/* mutate.c - the search's random numbers, and how one state is made of another.
   SPDX-License-Identifier: GPL-3.0-or-later */
#include "search.h"

#include <math.h>
#include <string.h>

/* splitmix64 (Steele, Lea, Flood 2014) */
uint64_t hunt_bits(hunt_random *r) {
  uint64_t z = r->state += 0x9e3779b97f4a7c15U;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31);
}

uint64_t hunt_below(hunt_random *r, uint64_t n) {
  return (hunt_bits(r) >> 11) % n; /* n is small: the bias is below 2^-40 */
}

double hunt_uniform(hunt_random *r) {
  return ((double)(hunt_bits(r) >> 12) + 0.5) * 0x1p-52;
}

int hunt_chance(hunt_random *r, double p) {
  return hunt_uniform(r) < p;
}

double hunt_sign(hunt_random *r) {
  return hunt_bits(r) & 1024 ? 1 : -1;
}

double hunt_size(hunt_random *r, double low, double high) {
  return exp2(low + (high - low) * hunt_uniform(r));
}

double hunt_mantissa(hunt_random *r, int single) {
  const int digits = single ? 24 : 53, k = (int)hunt_below(r, (uint64_t)digits);
  switch (hunt_below(r, 6)) {
  case 0: /* few digits */
    return 1 + floor(ldexp(hunt_uniform(r), k)) * ldexp(1, -k);
  case 1:
    return 1 + ldexp(1, -k);
  case 2:
    return 2 - ldexp(1, -k);
  default:
    return 1 + hunt_uniform(r);
  }
}

double hunt_near_one(hunt_random *r, int single) {
  const int digits = single ? 24 : 53;
  switch (hunt_below(r, 4)) {
  case 0:
    return 1;
  case 1: /* -4 to 4 units of the last place */
    return 1 + ldexp((double)hunt_below(r, 9) - 4, 1 - digits);
  default:
    return 1 + hunt_sign(r) * ldexp(hunt_mantissa(r, single), -1 - (int)hunt_below(r, 60));
  }
}

void hunt_snap(const hunt_target *t, double *g) {
  for (int i = 0; i < t->genes; i++) {
    if (t->gene[i].kind == HUNT_POSITIVE)
      g[i] = fabs(g[i]);
    if (t->gene[i].kind == HUNT_WHOLE)
      g[i] = trunc(g[i]);
    if (t->gene[i].kind == HUNT_CHOICE)
      g[i] = g[i] != 0;
    if (t->single)
      g[i] = (double)(float)g[i];
  }
}

static double step(double x, double units, int single) {
  int e;
  frexp(x, &e);
  return x + ldexp(units, e - (single ? 24 : 53));
}

/* Another gene of i's group among first .., or i. */
static int fellow(hunt_random *r, const hunt_target *t, int i, int first) {
  int list[HUNT_GENES], n = 0;
  for (int k = first; k < t->genes; k++)
    if (k != i && t->gene[k].group == t->gene[i].group)
      list[n++] = k;
  return n ? list[hunt_below(r, (uint64_t)n)] : i;
}

static void change(hunt_random *r, const hunt_target *t, double *g, int first, const double *a,
                   const double *b) {
  const int i = first + (int)hunt_below(r, (uint64_t)(t->genes - first)),
            k = fellow(r, t, i, first);
  const int digits = t->single ? 24 : 53;
  const double keep = g[i];
  if (t->gene[i].kind == HUNT_CHOICE) {
    g[i] = 1 - g[i];
    return;
  }
  switch (hunt_below(r, 14)) {
  case 0: /* some units of the last place */
  case 1:
    g[i] = step(g[i], hunt_sign(r) * (double)(1 + hunt_below(r, 4)), t->single);
    break;
  case 2: /* at any digit */
  case 3:
  case 4:
    g[i] = step(g[i],
                hunt_sign(r) *
                    ldexp(hunt_mantissa(r, t->single), (int)hunt_below(r, (uint64_t)digits)),
                t->single);
    break;
  case 5:
    g[i] *= ldexp(1, (int)hunt_below(r, 17) - 8);
    break;
  case 6:
    g[i] = -g[i];
    break;
  case 7: /* equal, and almost */
    g[i] = g[k] * hunt_near_one(r, t->single);
    break;
  case 8:
    g[i] = g[k], g[k] = keep;
    break;
  case 9:
    g[i] = hunt_chance(r, 0.3) ? 0 : g[i] * hunt_near_one(r, t->single);
    break;
  case 10: { /* the whole group */
    const double factor =
        hunt_chance(r, 0.5) ? ldexp(1, (int)hunt_below(r, 9) - 4) : hunt_mantissa(r, t->single);
    for (int n = first; n < t->genes; n++)
      if (t->gene[n].group == t->gene[i].group)
        g[n] *= factor;
    break;
  }
  case 11: /* another size, any digits */
    g[i] *= hunt_size(r, -3, 3) * (g[i] == 0 ? 0 : hunt_mantissa(r, t->single));
    if (g[i] == 0)
      g[i] = g[k] * hunt_size(r, -60, 1);
    break;
  case 12: { /* differential evolution (Storn and Price 1997) */
    const double factor = hunt_size(r, -6, 0.5);
    for (int n = first; n < t->genes; n++)
      if (t->gene[n].group == t->gene[i].group)
        g[n] += factor * (a[n] - b[n]);
    break;
  }
  default: { /* few digits */
    int e;
    const double m = frexp(g[i], &e);
    const int bits = 1 + (int)hunt_below(r, (uint64_t)digits);
    g[i] = ldexp(nearbyint(ldexp(m, bits)), e - bits);
  }
  }
}

void hunt_mutate(hunt_random *r, const hunt_target *t, double *g, int first, const double *a,
                 const double *b) {
  do
    change(r, t, g, first, a, b);
  while (hunt_chance(r, 0.4));
  hunt_snap(t, g);
}
