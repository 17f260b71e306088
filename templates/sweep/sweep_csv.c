/* sweep_csv.c -- the result as text: a row a member, or tables of statistics.
 * template: templates/sweep/sweep_csv.c.  SPDX-License-Identifier: MIT-0
 *
 * Numbers read back to the same double.  The file has a temporary name until it is whole. */
#define _XOPEN_SOURCE 700
#include "sweep.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { NAME = 4096 };

typedef struct output {
  FILE *f;
  char draft[NAME];
  const char *path; /* NULL: standard output */
} output;

static int begin(output *o, const char *path)
{
  o->path = strcmp(path, "-") == 0 ? NULL : path;
  o->f = stdout;
  if (o->path == NULL) return 0;
  if (snprintf(o->draft, sizeof o->draft, "%s.new", path) >= (int)sizeof o->draft) {
    sweep_say("%s: the name is too long", path);
    return -1;
  }
  o->f = fopen(o->draft, "w");
  if (o->f != NULL) return 0;
  sweep_say("%s: %s", o->draft, strerror(errno));
  return -1;
}

static int end(output *o, int wrong)
{
  const char *name = o->path != NULL ? o->draft : "standard output";
  int error = 0;

  if (!wrong && (fflush(o->f) != 0 || ferror(o->f))) error = errno;
  if (o->path != NULL) {
    if (!wrong && error == 0 && fsync(fileno(o->f)) != 0 && errno != EINVAL && errno != EROFS) error = errno;
    if (fclose(o->f) != 0 && error == 0) error = errno;
    if (!wrong && error == 0 && rename(o->draft, o->path) != 0) error = errno;
    if (wrong || error != 0) remove(o->draft);
  }
  if (error != 0) sweep_say("%s: %s", name, strerror(error));
  return wrong || error != 0 ? -1 : 0;
}

static void number(FILE *f, double x)
{
  char text[40];

  if (x != x) {
    fputs("nan", f);
    return;
  }
  snprintf(text, sizeof text, "%.15g", x);
  if (strtod(text, NULL) != x) snprintf(text, sizeof text, "%.17g", x);
  fputs(text, f);
}

/* Quoted where it has to be. */
static void words(FILE *f, const char *s)
{
  if (strpbrk(s, ",\"\n") == NULL) {
    fputs(s, f);
    return;
  }
  fputc('"', f);
  for (; *s != 0; s++) {
    if (*s == '"') fputc('"', f);
    fputc(*s, f);
  }
  fputc('"', f);
}

/* The names of a row's numbers: NAME, or NAME@T. */
static void name_of(const sweep_study *s, int at, char out[NAME])
{
  int i, k;

  for (i = 0; i < s->column_count; at -= s->columns[i].times, i++) {
    if (at >= s->columns[i].times) continue;
    k = snprintf(out, NAME, "%s", s->columns[i].name);
    if (s->columns[i].times > 1) snprintf(out + k, (size_t)(NAME - k), "@%.15g", s->times[at]);
    return;
  }
}

static void heading(const sweep_study *s, FILE *f)
{
  char name[NAME];
  int i;

  for (i = 0; i < s->width; i++) {
    name_of(s, i, name);
    fputc(',', f);
    words(f, name);
  }
}

int sweep_csv_write(const sweep_study *s, sweep_log *l, const char *path)
{
  const sweep_layout *d = sweep_log_layout(l);
  const size_t width = (size_t)s->width;
  double *rows = malloc((size_t)d->most*width*sizeof *rows);
  int32_t *status = malloc((size_t)d->most*sizeof *status);
  uint64_t b, k, first;
  output o;
  size_t i;
  int wrong = 0;

  if (rows == NULL || status == NULL || begin(&o, path) != 0) {
    free(rows);
    free(status);
    return -1;
  }
  fputs("member", o.f);
  heading(s, o.f);
  fputs(",status\n", o.f);
  for (b = 0; b < d->blocks && !wrong && !ferror(o.f); b++) {
    const uint64_t n = sweep_block(d, b, &first);

    wrong = sweep_log_read(l, b, rows, status) != 0;
    for (k = 0; k < n && !wrong; k++) {
      fprintf(o.f, "%llu", (unsigned long long)(first + k));
      for (i = 0; i < width; i++) {
        fputc(',', o.f);
        number(o.f, rows[k*width + i]);
      }
      fputc(',', o.f);
      words(o.f, s->reasons[status[k]]);
      fputc('\n', o.f);
    }
  }
  free(rows);
  free(status);
  return end(&o, wrong);
}

/* Four tables, an empty line between: the columns one by one, covariances, histograms, statuses. */
int sweep_csv_stats(const sweep_study *s, const sweep_stats *all, const char *path)
{
  output o;
  char name[NAME];
  int i, j;

  if (begin(&o, path) != 0) return -1;
  fputs("quantity,count,missing,mean,deviation,least,most", o.f);
  for (i = 0; i < SWEEP_QUANTILES; i++) fprintf(o.f, ",q%g", sweep_quantile[i]);
  fputc('\n', o.f);
  for (i = 0; i < s->width; i++) {
    sweep_summary m;

    sweep_stats_summary(all, i, &m);
    name_of(s, i, name);
    words(o.f, name);
    fprintf(o.f, ",%llu,%llu,", (unsigned long long)m.count, (unsigned long long)m.missing);
    number(o.f, m.mean);
    fputc(',', o.f);
    number(o.f, m.deviation);
    fputc(',', o.f);
    number(o.f, m.least);
    fputc(',', o.f);
    number(o.f, m.most);
    for (j = 0; j < SWEEP_QUANTILES; j++) {
      fputc(',', o.f);
      number(o.f, m.quantile[j]);
    }
    fputc('\n', o.f);
  }
  fputs("\ncovariance", o.f);
  heading(s, o.f);
  fputc('\n', o.f);
  for (i = 0; i < s->width; i++) {
    name_of(s, i, name);
    words(o.f, name);
    for (j = 0; j < s->width; j++) {
      fputc(',', o.f);
      number(o.f, sweep_stats_covariance(all, i, j));
    }
    fputc('\n', o.f);
  }
  fputs("\nhistogram,low,high", o.f);
  for (j = 0; j < SWEEP_BINS; j++) fprintf(o.f, ",bin%d", j + 1);
  fputc('\n', o.f);
  for (i = 0; i < s->width; i++) {
    uint64_t bins[SWEEP_BINS];
    double low, high;

    sweep_stats_histogram(all, i, &low, &high, bins);
    name_of(s, i, name);
    words(o.f, name);
    fputc(',', o.f);
    number(o.f, low);
    fputc(',', o.f);
    number(o.f, high);
    for (j = 0; j < SWEEP_BINS; j++) fprintf(o.f, ",%llu", (unsigned long long)bins[j]);
    fputc('\n', o.f);
  }
  fputs("\nstatus,members\n", o.f);
  for (i = 0; i < s->reason_count; i++) {
    words(o.f, s->reasons[i]);
    fprintf(o.f, ",%llu\n", (unsigned long long)sweep_stats_statuses(all)[i]);
  }
  return end(&o, 0);
}
