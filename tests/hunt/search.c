/* search.c - climbers on islands, one island for each error of a target; see search.h.
   SPDX-License-Identifier: GPL-3.0-or-later

     PROGRAM --seed N --count N   searches so many states; the lines below
     PROGRAM --replay             lines of genes -> lines of judged errors, or "refused"

     search NAME double|float SEED TRIED REFUSED JUDGED DOUBTED
     history ERROR TRIED VALUE       the worst judged so far, at powers of ten and at the end
     worst ERROR RANK VALUE BOUND G..    genes as hexadecimal numbers

   A quarter of the states is drawn, the others are mutations of a climber: an island's climbers
   have different ancestors, each gives way only to a worse child of its own or, if it is the best
   of its island, to a worse stranger. One that has had PATIENCE children in vain gives its place
   to whoever comes. Each new state is offered to all islands. What would enter the list of the
   three worst, by MARGIN or at the end, is judged by the slow oracle first, and counts with that
   value; where the fast one had said clearly more it is doubted and its climber is dropped. */
#include "search.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { CLIMBERS = 6, HALL = 3, PATIENCE = 5000 };
#define MARGIN 1.03

typedef struct entry {
  double g[HUNT_GENES], value;
  uint64_t lineage, vain;
} entry;

typedef struct island {
  entry climber[CLIMBERS], hall[HALL];
} island;

typedef struct search {
  const hunt_target *t;
  hunt_random r;
  island at[HUNT_ERRORS];
  uint64_t tried, refused, judged, doubted, lineages;
} search;

static int by_value(const void *a, const void *b) {
  const entry *x = a, *y = b;
  return x->value < y->value ? 1 : x->value > y->value ? -1 : 0;
}

/* The place of a lineage, else that of the least value. */
static entry *place(entry *list, int n, uint64_t lineage) {
  entry *least = list;
  for (int i = 0; i < n; i++) {
    if (list[i].lineage == lineage && list[i].value > 0)
      return list + i;
    if (list[i].value < least->value)
      least = list + i;
  }
  return least;
}

static void put(search *s, entry *e, const double *g, double value, uint64_t lineage) {
  memcpy(e->g, g, (size_t)s->t->genes * sizeof *g);
  e->value = value, e->lineage = lineage, e->vain = 0;
}

/* A NaN is the worst of all. */
static void tidy(const hunt_target *t, double *error) {
  for (int j = 0; j < t->errors; j++)
    if (!(error[j] >= 0))
      error[j] = HUGE_VAL;
}

static void judge(search *s, const double *g, const double *fast, uint64_t lineage) {
  double error[HUNT_ERRORS] = {0};
  s->judged++;
  if (!s->t->judge(g, error))
    return;
  tidy(s->t, error);
  for (int j = 0; j < s->t->errors; j++) {
    entry *e = place(s->at[j].hall, HALL, lineage);
    if (error[j] > e->value)
      put(s, e, g, error[j], lineage);
    if (!s->t->error[j].judged && fast[j] > 1.05 * error[j] + 0.5) {
      entry *c = place(s->at[j].climber, CLIMBERS, lineage);
      s->doubted++;
      if (c->lineage == lineage)
        c->value = 0;
    }
  }
}

static void offer(search *s, const double *g, const double *error, uint64_t lineage) {
  int worth = 0;
  for (int j = 0; j < s->t->errors; j++) {
    if (s->t->error[j].judged)
      continue;
    entry *c = place(s->at[j].climber, CLIMBERS, lineage);
    if (error[j] > c->value)
      put(s, c, g, error[j], lineage);
    worth |= error[j] > MARGIN * place(s->at[j].hall, HALL, lineage)->value;
  }
  if (worth)
    judge(s, g, error, lineage);
}

static const entry *any(search *s) {
  const hunt_target *t = s->t;
  int j;
  do
    j = (int)hunt_below(&s->r, (uint64_t)t->errors);
  while (t->error[j].judged);
  return s->at[j].climber + hunt_below(&s->r, CLIMBERS);
}

static void history(const search *s) {
  for (int j = 0; j < s->t->errors; j++) {
    double most = 0;
    for (int k = 0; k < HALL; k++)
      most = fmax(most, s->at[j].hall[k].value);
    printf("history %s %llu %.4g\n", s->t->error[j].name, (unsigned long long)s->tried, most);
    fprintf(stderr, " %s %.3g", s->t->error[j].name, most);
  }
  fprintf(stderr, "  after %llu\n", (unsigned long long)s->tried);
}

static void run(search *s, uint64_t count) {
  const hunt_target *t = s->t;
  uint64_t next = 1000;
  while (s->tried < count && s->refused < 30 * count + 1000) {
    double g[HUNT_GENES], error[HUNT_ERRORS];
    const entry *parent = any(s), *a = any(s), *b = any(s);
    uint64_t lineage = ++s->lineages;
    if (parent->value > 0 && hunt_chance(&s->r, 0.75)) {
      memcpy(g, parent->g, sizeof g);
      lineage = parent->lineage;
      entry *own = (entry *)parent; /* of s, which is not constant */
      if (++own->vain > PATIENCE)
        own->value = 0;
      /* a mutation of the late genes alone is another state of the same set-up */
      if (t->late < t->genes)
        hunt_mutate(&s->r, t, g, hunt_chance(&s->r, 0.9) ? 0 : t->genes - t->late, a->g, b->g);
      else
        hunt_mutate(&s->r, t, g, 0, a->g, b->g);
    } else {
      memset(g, 0, sizeof g);
      t->draw(&s->r, g);
      hunt_snap(t, g);
    }
    if (!t->prepare(g)) {
      s->refused++;
      continue;
    }
    for (int n = 0; n < t->burst && s->tried < count; n++) {
      double later[HUNT_GENES];
      memcpy(later, g, sizeof later);
      if (n > 0)
        hunt_mutate(&s->r, t, later, t->genes - t->late, a->g, b->g);
      memset(error, 0, sizeof error);
      if (!t->measure(later, error)) {
        s->refused++;
        continue;
      }
      s->tried++;
      tidy(t, error);
      offer(s, later, error, lineage);
      if (s->tried == next) {
        history(s);
        next *= 10;
      }
    }
  }
}

/* Climbers within MARGIN of the list, which nobody has judged. */
static void last(search *s) {
  for (int j = 0; j < s->t->errors; j++)
    for (int k = 0; k < CLIMBERS; k++) {
      const entry *c = s->at[j].climber + k;
      double fast[HUNT_ERRORS] = {0};
      if (c->value > place(s->at[j].hall, HALL, c->lineage)->value)
        judge(s, c->g, fast, c->lineage);
    }
}

static void print(search *s, uint64_t seed) {
  const hunt_target *t = s->t;
  history(s);
  printf("search %s %s %llu %llu %llu %llu %llu\n", t->name, t->single ? "float" : "double",
         (unsigned long long)seed, (unsigned long long)s->tried, (unsigned long long)s->refused,
         (unsigned long long)s->judged, (unsigned long long)s->doubted);
  for (int j = 0; j < t->errors; j++) {
    qsort(s->at[j].hall, HALL, sizeof(entry), by_value);
    for (int k = 0; k < HALL && s->at[j].hall[k].value > 0; k++) {
      printf("worst %s %d %.4g %g", t->error[j].name, k + 1, s->at[j].hall[k].value,
             t->error[j].bound);
      for (int i = 0; i < t->genes; i++)
        printf(" %a", s->at[j].hall[k].g[i]);
      printf("\n");
    }
  }
}

static int replay(const hunt_target *t) {
  static char line[4096];
  while (fgets(line, sizeof line, stdin)) {
    double g[HUNT_GENES] = {0}, error[HUNT_ERRORS] = {0};
    char *p = line, *end;
    for (int i = 0; i < t->genes; i++, p = end) {
      g[i] = strtod(p, &end);
      if (end == p) {
        fprintf(stderr, "%s: gene %s of a line is missing\n", t->name, t->gene[i].name);
        return 2;
      }
    }
    if (!t->prepare(g) || !t->judge(g, error)) {
      printf("refused\n");
      continue;
    }
    tidy(t, error);
    for (int j = 0; j < t->errors; j++)
      printf(j < t->errors - 1 ? "%.4g " : "%.4g\n", error[j]);
  }
  return 0;
}

int hunt_main(const hunt_target *t, int argc, char **argv) {
  static search s;
  uint64_t seed = 1, count = 1000000;
  int again = 0;
  for (int i = 1; i < argc; i++) {
    if (strcmp(argv[i], "--replay") == 0) {
      again = 1;
    } else if (strcmp(argv[i], "--seed") == 0 && i + 1 < argc) {
      seed = strtoull(argv[++i], NULL, 10);
    } else if (strcmp(argv[i], "--count") == 0 && i + 1 < argc) {
      count = (uint64_t)strtod(argv[++i], NULL);
    } else {
      fprintf(stderr, "usage: %s [--seed N] [--count N] | --replay < states\n", t->name);
      return 2;
    }
  }
  if (again)
    return replay(t);
  s.t = t;
  s.r.state = seed;
  fprintf(stderr, "%s, %s: seed %llu, %llu states\n", t->name, t->single ? "float" : "double",
          (unsigned long long)seed, (unsigned long long)count);
  run(&s, count);
  last(&s);
  print(&s, seed);
  return 0;
}
