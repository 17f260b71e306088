/* sweep_main.c -- the program: its command line, and the way from the study to the file.
 * template: templates/sweep/sweep_main.c.  SPDX-License-Identifier: MIT-0
 *
 *     NAME_sweep [-o FILE.csv|FILE.h5] [--threads N] [--block N] [--resume] [--about]
 *
 * What is computed is decided in NAME_members.c; these options decide where and how.  Exit status: 0; 2 the command line
 * is wrong, or a file; 128 + n a signal stopped it, and --resume goes on. */
#define _XOPEN_SOURCE 700
#include "sweep.h"

#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

typedef struct options {
  const char *file;
  uint64_t threads, block;
  int resume, about;
} options;

void sweep_say(const char *format, ...)
{
  va_list list;

  fflush(stdout);
  fprintf(stderr, "%s: ", "sweep");
  va_start(list, format);
  vfprintf(stderr, format, list);
  va_end(list);
  fputc('\n', stderr);
}

static int ends(const char *s, const char *tail)
{
  const size_t n = strlen(s), k = strlen(tail);

  return n > k && strcmp(s + n - k, tail) == 0;
}

/* A whole number from 1 on. */
static int whole(const char *name, const char *text, uint64_t *out)
{
  char *end;
  unsigned long long n;

  errno = 0;
  n = strtoull(text, &end, 10);
  if (text[0] < '0' || text[0] > '9' || *end != 0 || errno != 0 || n < 1 || n > 4294967295U) {
    sweep_say("%s must be a whole number from 1 on, got %s", name, text);
    return -1;
  }
  *out = (uint64_t)n;
  return 0;
}

static int parse(int argc, char **argv, options *o)
{
  int i, wrong = 0;

  for (i = 1; i < argc; i++) {
    const char *a = argv[i], *value = i + 1 < argc ? argv[i + 1] : NULL;
    const int takes = strcmp(a, "-o") == 0 || strcmp(a, "--threads") == 0 || strcmp(a, "--block") == 0;

    if (takes && value == NULL) {
      sweep_say("%s needs a value", a);
      return -1;
    }
    i += takes;
    if (strcmp(a, "-o") == 0) o->file = value;
    else if (strcmp(a, "--threads") == 0) wrong |= whole(a, value, &o->threads);
    else if (strcmp(a, "--block") == 0) wrong |= whole(a, value, &o->block);
    else if (strcmp(a, "--resume") == 0) o->resume = 1;
    else if (strcmp(a, "--about") == 0) o->about = 1;
    else {
      sweep_say("no option %s (-o FILE, --threads N, --block N, --resume, --about)", a);
      wrong = -1;
    }
  }
  if (o->file == NULL) o->file = "-";
  if (strcmp(o->file, "-") != 0 && !ends(o->file, ".csv") && !ends(o->file, ".h5")) {
    sweep_say("-o must end in .csv or .h5, or be -, got %s", o->file);
    wrong = -1;
  } else if (ends(o->file, ".h5") && !sweep_hdf5_there()) {
    sweep_say("%s: this program was built without HDF5 (Debian package libhdf5-dev); "
      "-o FILE.csv needs nothing", o->file);
    wrong = -1;
  }
  if (o->resume && strcmp(o->file, "-") == 0) {
    sweep_say("--resume: it needs the -o FILE of the run that was stopped");
    wrong = -1;
  }
  return wrong;
}

static void about(const sweep_study *s, int ranks)
{
  int i;

  printf("scene        %s\nprogram      %s\nmade by      %s\nmembers      %llu\n"
    "fingerprint  %s\nbuilt with   %s, %s\n", s->scene, s->version, s->command, (unsigned long long)s->members, s->fingerprint, sweep_ranks_about(),
    sweep_hdf5_there() ? "HDF5" : "no HDF5");
  printf("ranks        %d\ncolumns      member", ranks);
  for (i = 0; i < s->column_count; i++) printf(", %s", s->columns[i].name);
  printf(", status\n");
}

/* What the members' statuses are, where they are not all fine: one line each. */
static void told(const sweep_study *s, const uint64_t counts[])
{
  int i;

  for (i = 1; i < s->reason_count; i++) {
    if (counts[i] > 0) {
      sweep_say("%llu of %llu members: %s", (unsigned long long)counts[i], (unsigned long long)s->members, s->reasons[i]);
    }
  }
}

static int count_statuses(const sweep_study *s, sweep_log *l)
{
  const sweep_layout *d = sweep_log_layout(l);
  double *rows = malloc((size_t)d->most*(size_t)s->width*sizeof *rows);
  int32_t *status = malloc((size_t)d->most*sizeof *status);
  uint64_t *counts = calloc((size_t)s->reason_count, sizeof *counts), b, k, first;
  int wrong = rows == NULL || status == NULL || counts == NULL;

  for (b = 0; b < d->blocks && !wrong; b++) {
    wrong = sweep_log_read(l, b, rows, status) != 0;
    for (k = 0; k < sweep_block(d, b, &first) && !wrong; k++) counts[status[k]]++;
  }
  if (!wrong) told(s, counts);
  free(rows);
  free(status);
  free(counts);
  return wrong ? -1 : 0;
}

/* The result, made of the logs.  With statistics the logs hold states, else rows. */
static int finish(const sweep_study *s, sweep_log *l, const char *file)
{
  sweep_stats *all = s->stats ? sweep_stats_new(s) : NULL;
  const uint64_t missing = sweep_log_scan(l, all);
  int wrong = -1;

  if (missing == UINT64_MAX) return -1;
  if (missing > 0) {
    sweep_say("%llu of %llu blocks are missing from the logs: --resume computes them", (unsigned long long)missing,
      (unsigned long long)sweep_log_layout(l)->blocks);
  } else if (all != NULL) {
    wrong = ends(file, ".h5") ? sweep_hdf5_stats(s, all, file) : sweep_csv_stats(s, all, file);
    if (wrong == 0) told(s, sweep_stats_statuses(all));
  } else {
    wrong = ends(file, ".h5") ? sweep_hdf5_write(s, l, file) : sweep_csv_write(s, l, file);
    if (wrong == 0) wrong = count_statuses(s, l);
  }
  if (all != NULL) sweep_stats_free(all);
  return wrong;
}

/* The folder of the logs: beside the file, or a temporary one. */
static int folder_of(const options *o, int rank, char out[4096])
{
  const char *base = getenv("TMPDIR");
  int n;

  if (strcmp(o->file, "-") != 0) {
    n = snprintf(out, 4096, "%s.blocks", o->file);
    return n > 0 && n < 4096 ? 0 : -1;
  }
  n = snprintf(out, 4096, "%s/sweep-XXXXXX", base != NULL && *base != 0 ? base : "/tmp");
  if (n > 0 && n < 4096 && rank == 0 && mkdtemp(out) != NULL) return 0;
  sweep_say("%s: %s", out, rank == 0 ? strerror(errno) : "with several ranks -o FILE is needed");
  return -1;
}

static int run(const options *o, int rank, int ranks)
{
  const sweep_study *s = &sweep_this;
  char folder[4096];
  sweep_log *log = NULL;
  sweep_work work;
  uint64_t workers;
  int wrong;

  work.threads = (int)(o->threads > 0 ? o->threads : 1);
  if (o->threads == 0 && ranks == 1) work.threads = (int)sysconf(_SC_NPROCESSORS_ONLN);
  workers = (uint64_t)work.threads*(uint64_t)ranks;
  if (ranks > 1 && strcmp(o->file, "-") == 0) {
    if (rank == 0) sweep_say("with several ranks -o FILE is needed");
    return 2;
  }
  if (folder_of(o, rank, folder) != 0) return 2;
  /* rank 0 makes the folder, the others find it */
  if (rank == 0 && o->resume && access(folder, F_OK) != 0 && access(o->file, F_OK) == 0) {
    wrong = sweep_seal_check(s, o->file) == 0 ? -1 : 1;
    if (wrong < 0) sweep_say("%s is there, and nothing is left to resume", o->file);
  } else {
    if (rank == 0) log = sweep_log_open(s, folder, rank, o->resume, o->block, workers);
    wrong = rank == 0 && log == NULL;
  }
  wrong = sweep_ranks_tell(wrong);
  if (wrong != 0) return wrong < 0 ? 0 : 2;
  if (rank != 0) log = sweep_log_open(s, folder, rank, 1, o->block, workers);
  if (log == NULL || sweep_log_scan(log, NULL) == UINT64_MAX) {
    sweep_ranks_abort(2);
    return 2;
  }
  sweep_ranks_wait(); /* all have seen the same logs before one is written to */
  if (sweep_log_begin(log) != 0) {
    sweep_ranks_abort(2);
    return 2;
  }
  work.study = s;
  work.log = log;
  work.progress = rank == 0 && isatty(2);
  wrong = sweep_team_run(&work);
  if (wrong > 0 && rank == 0) sweep_say("stopped by signal %d; --resume goes on from %s", wrong, folder);
  if (wrong != 0) {
    sweep_ranks_abort(wrong > 0 ? 128 + wrong : 2);
    sweep_log_close(log, strcmp(o->file, "-") == 0);
    return wrong > 0 ? 128 + wrong : 2;
  }
  sweep_ranks_wait();
  wrong = 0;
  if (rank == 0) {
    wrong = finish(s, log, o->file) != 0;
    if (!wrong && strcmp(o->file, "-") != 0) wrong = sweep_seal_write(s, o->file) != 0;
  }
  wrong = sweep_ranks_tell(wrong);
  sweep_log_close(log, rank == 0 && (!wrong || strcmp(o->file, "-") == 0));
  return wrong ? 2 : 0;
}

int main(int argc, char **argv)
{
  options o = {NULL, 0, 0, 0, 0};
  int rank, ranks, status;

  sweep_ranks_open(&argc, &argv, &rank, &ranks);
  if (rank == 0) status = parse(argc, argv, &o) != 0 ? 2 : 0;
  else status = 0;
  status = sweep_ranks_tell(status);
  if (status == 0 && rank != 0) status = parse(argc, argv, &o) != 0 ? 2 : 0;
  if (status == 0 && o.about) {
    if (rank == 0) about(&sweep_this, ranks);
  } else if (status == 0) {
    status = run(&o, rank, ranks);
  }
  sweep_ranks_close();
  return status;
}
