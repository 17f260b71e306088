/* sweep_hdf5.c -- the result as HDF5 (-DSWEEP_HDF5), by the HDF Group's library.
 * template: templates/sweep/sweep_hdf5.c.  SPDX-License-Identifier: MIT-0
 *
 * A dataset a column, over the dimension scales `member` and, of states at times, `time`: h5py and xarray open it by
 * these.  Attributes say what the file was made from; no clock stands in it: the same sweep gives the same bytes. */
#include "sweep.h"

#ifndef SWEEP_HDF5

int sweep_hdf5_there(void) { return 0; }

int sweep_hdf5_write(const sweep_study *s, sweep_log *l, const char *path)
{
  (void)s, (void)l, (void)path;
  return -1;
}

int sweep_hdf5_stats(const sweep_study *s, const sweep_stats *all, const char *path)
{
  (void)s, (void)all, (void)path;
  return -1;
}

#else

#include <errno.h>
#include <fcntl.h>
#include <hdf5.h>
#include <hdf5_hl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { NAME = 4096, CHUNK = 8192 /* members in a chunk: 64 kB of doubles */ };

int sweep_hdf5_there(void) { return 1; }

/* Of variable length, which h5py reads as a string and not as bytes. */
static void text(hid_t at, const char *name, const char *value)
{
  const hid_t type = H5Tcopy(H5T_C_S1), space = H5Screate(H5S_SCALAR);
  hid_t a;

  H5Tset_size(type, H5T_VARIABLE);
  H5Tset_cset(type, H5T_CSET_UTF8);
  a = H5Acreate2(at, name, type, space, H5P_DEFAULT, H5P_DEFAULT);
  H5Awrite(a, type, &value);
  H5Aclose(a);
  H5Sclose(space);
  H5Tclose(type);
}

static void whole(hid_t at, const char *name, uint64_t value)
{
  const hid_t space = H5Screate(H5S_SCALAR), a = H5Acreate2(at, name, H5T_STD_U64LE, space, H5P_DEFAULT, H5P_DEFAULT);

  H5Awrite(a, H5T_NATIVE_UINT64, &value);
  H5Aclose(a);
  H5Sclose(space);
}

/* A dataset without times of its own; chunk 0: in one piece. */
static hid_t dataset(hid_t file, const char *name, hid_t type, int rank, const hsize_t size[], hsize_t chunk)
{
  const hid_t space = H5Screate_simple(rank, size, NULL), how = H5Pcreate(H5P_DATASET_CREATE);
  const double none = 0.0/0.0;
  hsize_t piece[2];
  hid_t d;

  H5Pset_obj_track_times(how, 0);
  if (chunk > 0) {
    piece[0] = chunk < size[0] ? chunk : size[0];
    piece[1] = rank > 1 ? size[1] : 1;
    H5Pset_chunk(how, rank, piece);
    if (H5Tget_class(type) == H5T_FLOAT) H5Pset_fill_value(how, H5T_NATIVE_DOUBLE, &none);
  }
  d = H5Dcreate2(file, name, type, space, H5P_DEFAULT, how, H5P_DEFAULT);
  H5Pclose(how);
  H5Sclose(space);
  return d;
}

/* Part first .. first + count - 1 of the first dimension. */
static int put(hid_t d, hid_t type, hsize_t first, hsize_t count, const void *data)
{
  const hid_t space = H5Dget_space(d);
  hsize_t size[2] = {1, 1}, from[2] = {0, 0};
  const int rank = H5Sget_simple_extent_dims(space, size, NULL);
  hid_t memory;
  int wrong;

  from[0] = first;
  size[0] = count;
  H5Sselect_hyperslab(space, H5S_SELECT_SET, from, NULL, size, NULL);
  memory = H5Screate_simple(rank, size, NULL);
  wrong = H5Dwrite(d, type, memory, space, H5P_DEFAULT, data) < 0;
  H5Sclose(memory);
  H5Sclose(space);
  return wrong;
}

static void described(hid_t d, const char *unit, const char *about)
{
  text(d, "units", unit);
  text(d, "long_name", about);
}

static void scene(hid_t at, const sweep_study *s)
{
  size_t size = 1;
  char *whole_text;
  int i;

  for (i = 0; s->text[i] != NULL; i++) size += strlen(s->text[i]);
  whole_text = malloc(size);
  if (whole_text == NULL) return;
  whole_text[0] = 0;
  for (size = 0, i = 0; s->text[i] != NULL; i++) {
    strcpy(whole_text + size, s->text[i]);
    size += strlen(s->text[i]);
  }
  text(at, "scene", whole_text);
  free(whole_text);
}

/* The file under its temporary name. */
static hid_t begin(const sweep_study *s, const char *path, char draft[NAME])
{
  hid_t how, access, file, root;

  H5dont_atexit(); /* what a full disk did not take cannot be written there either */
  how = H5Pcreate(H5P_FILE_CREATE);
  access = H5Pcreate(H5P_FILE_ACCESS);
  H5Pset_obj_track_times(how, 0);
  H5Eset_auto2(H5E_DEFAULT, NULL, NULL); /* we say ourselves what fails */
  snprintf(draft, NAME, "%s.new", path);
  file = H5Fcreate(draft, H5F_ACC_TRUNC, how, access);
  H5Pclose(how);
  H5Pclose(access);
  if (file < 0) {
    sweep_say("%s: cannot be made", draft);
    return file;
  }
  root = H5Gopen2(file, "/", H5P_DEFAULT);
  text(root, "Conventions", "CF-1.10");
  text(root, "title", s->scene);
  text(root, "source", s->version);
  text(root, "history", s->command);
  scene(root, s);
  text(root, "fingerprint", s->fingerprint);
  whole(root, "seed", s->seed);
  whole(root, "members", s->members);
  H5Gclose(root);
  return file;
}

static int end(hid_t file, const char *draft, const char *path, int wrong)
{
  if (H5Fflush(file, H5F_SCOPE_GLOBAL) < 0) wrong = 1;
  if (H5Fclose(file) < 0) wrong = 1;
  if (!wrong) { /* on the disk before it has its name */
    const int fd = open(draft, O_RDONLY);

    if (fd >= 0) {
      fsync(fd);
      close(fd);
    }
    wrong = rename(draft, path) != 0;
  }
  if (wrong) {
    sweep_say("%s: cannot be written (is the disk full?)", path);
    remove(draft);
  }
  return wrong ? -1 : 0;
}

/* flag_values and flag_meanings, as CF section 3.5 has them: words without blanks. */
static void flags(const sweep_study *s, hid_t d)
{
  const hsize_t n = (hsize_t)s->reason_count;
  const hid_t space = H5Screate_simple(1, &n, NULL);
  const hid_t a = H5Acreate2(d, "flag_values", H5T_STD_I32LE, space, H5P_DEFAULT, H5P_DEFAULT);
  int32_t *values = malloc((size_t)n*sizeof *values);
  size_t length = 1;
  char *meanings, *p;
  int i;

  for (i = 0; i < s->reason_count; i++) length += strlen(s->reasons[i]) + 1;
  p = meanings = malloc(length);
  for (i = 0; values != NULL && meanings != NULL && i < s->reason_count; i++) {
    const char *c;

    values[i] = i;
    if (i > 0) *p++ = ' ';
    for (c = s->reasons[i]; *c != 0; c++) *p++ = *c == ' ' ? '_' : *c;
  }
  if (values != NULL && meanings != NULL) {
    *p = 0;
    H5Awrite(a, H5T_NATIVE_INT32, values);
    text(d, "flag_meanings", meanings);
  }
  free(values);
  free(meanings);
  H5Aclose(a);
  H5Sclose(space);
}

/* All datasets of a table of members, open. */
typedef struct table {
  hid_t member, time, status, *column;
} table;

static int make(const sweep_study *s, hid_t file, table *t)
{
  hsize_t size[2];
  int i;

  size[0] = (hsize_t)s->members;
  t->member = dataset(file, "member", H5T_STD_I64LE, 1, size, CHUNK);
  described(t->member, "1", "number of the member");
  H5DSset_scale(t->member, "member");
  t->time = -1;
  for (i = 0; i < s->column_count; i++) {
    const sweep_column *c = &s->columns[i];

    size[0] = (hsize_t)s->members;
    size[1] = (hsize_t)c->times;
    if (c->times > 1 && t->time < 0) {
      const hsize_t n = (hsize_t)s->time_count;

      t->time = dataset(file, "time", H5T_IEEE_F64LE, 1, &n, 0);
      described(t->time, "s", "time");
      H5DSset_scale(t->time, "time");
      if (put(t->time, H5T_NATIVE_DOUBLE, 0, n, s->times)) return 1;
    }
    t->column[i] = dataset(file, c->name, H5T_IEEE_F64LE, c->times > 1 ? 2 : 1, size,
      c->times > 1 ? (CHUNK + (hsize_t)c->times - 1)/(hsize_t)c->times : CHUNK);
    if (t->column[i] < 0) return 1;
    described(t->column[i], c->unit, c->about);
    H5DSattach_scale(t->column[i], t->member, 0);
    if (c->times > 1) H5DSattach_scale(t->column[i], t->time, 1);
  }
  size[0] = (hsize_t)s->members;
  t->status = dataset(file, "status", H5T_STD_I32LE, 1, size, CHUNK);
  described(t->status, "1", "what became of the member");
  flags(s, t->status);
  H5DSattach_scale(t->status, t->member, 0);
  return t->member < 0 || t->status < 0;
}

int sweep_hdf5_write(const sweep_study *s, sweep_log *l, const char *path)
{
  const sweep_layout *d = sweep_log_layout(l);
  const size_t width = (size_t)s->width, most = (size_t)d->most;
  double *rows = malloc(most*width*sizeof *rows), *one = malloc(most*width*sizeof *one);
  int32_t *status = malloc(most*sizeof *status);
  int64_t *numbers = malloc(most*sizeof *numbers);
  char draft[NAME];
  table t;
  hid_t file;
  uint64_t b, k, first;
  int wrong, i, j;

  t.column = malloc((size_t)s->column_count*sizeof *t.column);
  file = rows && one && status && numbers && t.column ? begin(s, path, draft) : -1;
  if (file < 0) {
    free(rows), free(one), free(status), free(numbers), free(t.column);
    return -1;
  }
  for (i = 0; i < s->column_count; i++) t.column[i] = -1;
  t.member = t.status = -1;
  wrong = make(s, file, &t);
  for (b = 0; b < d->blocks && !wrong; b++) {
    const uint64_t n = sweep_block(d, b, &first);
    size_t at = 0;

    wrong = sweep_log_read(l, b, rows, status) != 0;
    for (k = 0; k < n; k++) numbers[k] = (int64_t)(first + k);
    wrong = wrong || put(t.member, H5T_NATIVE_INT64, first, n, numbers) ||
            put(t.status, H5T_NATIVE_INT32, first, n, status);
    for (i = 0; i < s->column_count && !wrong; i++) {
      const size_t times = (size_t)s->columns[i].times;

      for (k = 0; k < n; k++) {
        for (j = 0; j < s->columns[i].times; j++) one[k*times + (size_t)j] = rows[k*width + at + (size_t)j];
      }
      at += times;
      wrong = put(t.column[i], H5T_NATIVE_DOUBLE, first, n, one);
    }
  }
  for (i = 0; i < s->column_count; i++) {
    if (t.column[i] >= 0 && H5Dclose(t.column[i]) < 0) wrong = 1;
  }
  if (t.time >= 0) H5Dclose(t.time);
  if (t.status >= 0) H5Dclose(t.status);
  if (t.member >= 0) H5Dclose(t.member);
  free(rows), free(one), free(status), free(numbers), free(t.column);
  return end(file, draft, path, wrong);
}

/* A dataset that is written at once, over the scales `along`, and closed; over itself it is a scale. */
static int put_whole(hid_t file, const char *name, hid_t stored, hid_t given, int rank, const char *const along[],
  const hsize_t size[], const void *data, const char *about)
{
  const hid_t d = dataset(file, name, stored, rank, size, 0);
  int wrong, k;

  if (d < 0) return 1;
  text(d, "long_name", about);
  wrong = put(d, given, 0, size[0], data);
  for (k = 0; k < rank; k++) {
    if (strcmp(along[k], name) == 0) {
      wrong |= H5DSset_scale(d, name) < 0;
    } else {
      const hid_t scale = H5Dopen2(file, along[k], H5P_DEFAULT);

      wrong |= scale < 0 || H5DSattach_scale(d, scale, (unsigned)k) < 0;
      H5Dclose(scale);
    }
  }
  H5Dclose(d);
  return wrong;
}

/* A scale of words; text: n of them, LONGEST bytes each. */
enum { LONGEST = 128 };
static int put_words(hid_t file, const char *name, hsize_t n, const char *words, const char *about)
{
  const hid_t type = H5Tcopy(H5T_C_S1);
  int wrong;

  H5Tset_size(type, LONGEST);
  wrong = put_whole(file, name, type, type, 1, &name, &n, words, about);
  H5Tclose(type);
  return wrong;
}

static int put_indices(hid_t file, const char *name, hsize_t n, const char *about)
{
  int64_t list[SWEEP_BINS];
  hsize_t i;

  for (i = 0; i < n; i++) list[i] = (int64_t)i;
  return put_whole(file, name, H5T_STD_I64LE, H5T_NATIVE_INT64, 1, &name, &n, list, about);
}

/* What the statistics stand over: quantities (twice, for covariances), bins and their ends, probabilities, statuses. */
static int put_scales(const sweep_study *s, hid_t file)
{
  static const char *const probability[] = {"probability"};
  const hsize_t w = (hsize_t)s->width, n = (hsize_t)s->reason_count, quantiles = SWEEP_QUANTILES;
  char *words = calloc((size_t)(w > n ? w : n), LONGEST);
  int i, k, at = 0, wrong = words == NULL;

  for (i = 0; i < s->column_count && !wrong; i++) {
    for (k = 0; k < s->columns[i].times; k++) {
      const sweep_column *c = &s->columns[i];

      if (c->times > 1) snprintf(words + LONGEST*at++, LONGEST, "%s@%.15g", c->name, s->times[k]);
      else snprintf(words + LONGEST*at++, LONGEST, "%s", c->name);
    }
  }
  wrong = wrong || put_words(file, "quantity", w, words, "name of the quantity");
  wrong = wrong || put_words(file, "other", w, words, "name of the other quantity");
  for (i = 0; i < s->reason_count && !wrong; i++) {
    memset(words + LONGEST*i, 0, LONGEST);
    snprintf(words + LONGEST*i, LONGEST, "%s", s->reasons[i]);
  }
  wrong = wrong || put_words(file, "reason", n, words, "what becomes of a member");
  wrong = wrong || put_indices(file, "bin", SWEEP_BINS, "number of the bin");
  wrong = wrong || put_indices(file, "side", 2, "0: low, 1: high");
  wrong = wrong || put_whole(file, "probability", H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, 1, probability, &quantiles,
    sweep_quantile, "of the quantiles");
  free(words);
  return wrong;
}

int sweep_hdf5_stats(const sweep_study *s, const sweep_stats *all, const char *path)
{
  static const char *const reason[] = {"reason"};
  const size_t w = (size_t)s->width;
  double *column = malloc(w*sizeof *column), *square = malloc(w*w*sizeof *square);
  double *quantiles = malloc(w*SWEEP_QUANTILES*sizeof *quantiles), *edges = malloc(2*w*sizeof *edges);
  uint64_t *counts = malloc(w*SWEEP_BINS*sizeof *counts);
  sweep_summary *m = malloc(w*sizeof *m);
  const hsize_t reasons = (hsize_t)s->reason_count;
  const char *along[2] = {"quantity", NULL};
  hsize_t size[2];
  char draft[NAME];
  hid_t file;
  size_t i, j;
  int wrong;

  file = column && square && quantiles && edges && counts && m ? begin(s, path, draft) : -1;
  if (file < 0) {
    free(column), free(square), free(quantiles), free(edges), free(counts), free(m);
    return -1;
  }
  for (i = 0; i < w; i++) {
    sweep_stats_summary(all, (int)i, &m[i]);
    sweep_stats_histogram(all, (int)i, &edges[2*i], &edges[2*i + 1], counts + i*SWEEP_BINS);
    for (j = 0; j < SWEEP_QUANTILES; j++) quantiles[i*SWEEP_QUANTILES + j] = m[i].quantile[j];
    for (j = 0; j < w; j++) square[i*w + j] = sweep_stats_covariance(all, (int)i, (int)j);
  }
  wrong = put_scales(s, file);
#define PUT(name, second, n, stored, given, data, about) \
  (along[1] = second, size[0] = (hsize_t)w, size[1] = n, \
   wrong |= put_whole(file, name, stored, given, n > 0 ? 2 : 1, along, size, data, about))
  PUT("histogram", "bin", SWEEP_BINS, H5T_STD_U64LE, H5T_NATIVE_UINT64, counts, "members in equal bins");
  PUT("edges", "side", 2, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, edges, "ends of the histogram");
  PUT("quantiles", "probability", SWEEP_QUANTILES, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, quantiles, "quantiles");
  PUT("covariance", "other", (hsize_t)w, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, square, "covariance");
  for (i = 0; i < w; i++) counts[i] = m[i].count;
  PUT("count", NULL, 0, H5T_STD_U64LE, H5T_NATIVE_UINT64, counts, "members with a number");
  for (i = 0; i < w; i++) counts[i] = m[i].missing;
  PUT("missing", NULL, 0, H5T_STD_U64LE, H5T_NATIVE_UINT64, counts, "members without one");
  for (i = 0; i < w; i++) column[i] = m[i].mean;
  PUT("mean", NULL, 0, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, column, "mean");
  for (i = 0; i < w; i++) column[i] = m[i].deviation;
  PUT("deviation", NULL, 0, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, column, "standard deviation");
  for (i = 0; i < w; i++) column[i] = m[i].least;
  PUT("least", NULL, 0, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, column, "least value");
  for (i = 0; i < w; i++) column[i] = m[i].most;
  PUT("most", NULL, 0, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, column, "greatest value");
#undef PUT
  wrong |= put_whole(file, "status", H5T_STD_U64LE, H5T_NATIVE_UINT64, 1, reason, &reasons, sweep_stats_statuses(all),
    "members by what became of them");
  free(column), free(square), free(quantiles), free(edges), free(counts), free(m);
  return end(file, draft, path, wrong);
}

#endif
