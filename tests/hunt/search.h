/* search.h - a search for the states that a piece of code computes worst.
   SPDX-License-Identifier: GPL-3.0-or-later

   A state is a list of numbers, its genes; a target draws states, measures the errors of one by a
   fast oracle and judges it by a slow one of many digits. Each error is an objective of its own:
   an island with climbers that are mutated one after the other, restarted where they stay, and with
   the three worst states of different descent that were ever judged. The law is in search.c, the
   mutations are in mutate.c. Everything follows from seed and count: no clock. */
#ifndef HUNT_SEARCH_H
#define HUNT_SEARCH_H

#include <stdint.h>

enum { HUNT_GENES = 24, HUNT_ERRORS = 16 };

/* What mutations may do with a gene. */
enum hunt_kind {
  HUNT_POSITIVE, /* > 0 */
  HUNT_SIGNED,   /* any sign, and 0 */
  HUNT_WHOLE,    /* a whole number */
  HUNT_CHOICE    /* 0 or 1 */
};

typedef struct hunt_gene {
  const char *name;
  int kind, group; /* genes of one group are of one dimension */
} hunt_gene;

typedef struct hunt_error {
  const char *name;
  double bound; /* what is promised, in the error's unit */
  int judged;   /* known by judge() alone: looked at where another error is large */
} hunt_error;

typedef struct hunt_random {
  uint64_t state;
} hunt_random;

typedef struct hunt_target {
  const char *name;
  int single; /* genes are floats */
  int genes;
  int late; /* so many genes at the end change without prepare() */
  const hunt_gene *gene;
  int errors;
  const hunt_error *error;
  int burst; /* states measured after one prepare() */
  void (*draw)(hunt_random *r, double *g);
  /* 0: genes outside the range of the search, or refused by the code */
  int (*prepare)(const double *g);
  /* 0 likewise; errors in their units, those of `judged` untouched */
  int (*measure)(const double *g, double *error);
  int (*judge)(const double *g, double *error);
} hunt_target;

/* ---- random numbers and patterns (mutate.c) ---- */

uint64_t hunt_bits(hunt_random *r);
uint64_t hunt_below(hunt_random *r, uint64_t n);
double hunt_uniform(hunt_random *r); /* in (0, 1) */
int hunt_chance(hunt_random *r, double p);
/* In [1, 2): any digits, few digits, or next to 1 or 2 by a power of two. */
double hunt_mantissa(hunt_random *r, int single);
/* 1 +- 2^-k or 1 +- some units of the last place, or 1. */
double hunt_near_one(hunt_random *r, int single);
/* 2^e, e evenly in [low, high] */
double hunt_size(hunt_random *r, double low, double high);
double hunt_sign(hunt_random *r);

/* Genes made to what they may be. */
void hunt_snap(const hunt_target *t, double *g);
/* Changes genes first .. of g a little or much; a and b: two other states, for differences. */
void hunt_mutate(hunt_random *r, const hunt_target *t, double *g, int first, const double *a,
                 const double *b);

/* ---- the search ---- */

/* --seed N --count N: searches and prints; --replay: judges the states read from the input. */
int hunt_main(const hunt_target *t, int argc, char **argv);

#endif
