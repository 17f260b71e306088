/* sweep_log.c -- logs of what was computed, from which a sweep goes on after it was stopped in whatever way.
 * template: templates/sweep/sweep_log.c.  SPDX-License-Identifier: MIT-0
 *
 * The folder FILE.blocks has `settings` (whose blocks these are), `lock`, and a log for each rank.  A log is a row of
 * records, only ever appended to:
 *
 *     magic, blocks, size of the data in bytes, checksum, numbers of the blocks, data          words of 64 bits
 *
 * What a process wrote survives its being killed; a record that it was writing has a wrong checksum and is cut off. */
#define _XOPEN_SOURCE 700
#include "sweep.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#define MAGIC UINT64_C(0x314B4C425057534F) /* also tells the order of bytes */
enum { NAME = 4096, HEAD = 4, USUAL = 1024 /* members: enough work for each request, little enough to lose */ };

struct sweep_log {
  const sweep_study *study;
  char folder[NAME], own[NAME];
  char (*files)[NAME];
  int *open;
  int file_count, fd, lock;
  uint64_t block, blocks, workers; /* workers: when the folder was made */
  sweep_layout layout;
  uint32_t *file; /* of each block: number of the file from 1, 0: missing */
  int64_t *place; /* and where its data begins */
  int64_t end;    /* of this rank's log: behind the last whole record */
  time_t synced;
};

const sweep_layout *sweep_log_layout(const sweep_log *l) { return &l->layout; }

uint64_t sweep_checksum(uint64_t h, const void *data, size_t size)
{
  const unsigned char *p = data;

  while (size > 0) {
    uint64_t word = 0;
    const size_t n = size < sizeof word ? size : sizeof word;

    memcpy(&word, p, n);
    h = (h ^ word)*UINT64_C(0x9E3779B97F4A7C15);
    h ^= h >> 32;
    p += n;
    size -= n;
  }
  return h;
}

static int failed(const char *path)
{
  sweep_say("%s: %s", path, strerror(errno));
  return -1;
}

static int path_of(char out[NAME], const char *folder, const char *name)
{
  const int n = snprintf(out, NAME, "%s/%s", folder, name);

  if (n > 0 && n < NAME) return 0;
  errno = ENAMETOOLONG;
  return failed(folder);
}

/* All of it, at a place; 0, or an errno. */
static int write_all(int fd, const void *data, size_t size, int64_t at)
{
  const unsigned char *p = data;

  while (size > 0) {
    const ssize_t n = pwrite(fd, p, size, (off_t)at);

    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return n < 0 ? errno : ENOSPC;
    p += n;
    at += n;
    size -= (size_t)n;
  }
  return 0;
}

static int read_all(int fd, void *data, size_t size, int64_t at)
{
  unsigned char *p = data;

  while (size > 0) {
    const ssize_t n = pread(fd, p, size, (off_t)at);

    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return -1;
    p += n;
    at += n;
    size -= (size_t)n;
  }
  return 0;
}

/* ---- settings ---- */

static int settings_write(const sweep_log *l)
{
  char path[NAME], text[NAME], draft[NAME];
  int fd, n, wrong;

  if (path_of(path, l->folder, "settings") || path_of(draft, l->folder, "settings.new")) return -1;
  n = snprintf(text, sizeof text, "sweep of %s\nfingerprint %s\nmembers %llu\nblock %llu\nworkers %llu\nby %s\n"
    "command %s\n", l->study->scene, l->study->fingerprint, (unsigned long long)l->study->members,
    (unsigned long long)l->block, (unsigned long long)l->workers, l->study->version, l->study->command);
  if (n >= (int)sizeof text) n = (int)sizeof text - 1; /* of a command that long the end is missing */
  fd = open(draft, O_WRONLY | O_CREAT | O_TRUNC, 0666);
  if (fd < 0) return failed(draft);
  wrong = write_all(fd, text, (size_t)n, 0);
  if (wrong == 0 && fsync(fd) != 0) wrong = errno;
  if (close(fd) != 0 && wrong == 0) wrong = errno;
  if (wrong == 0 && rename(draft, path) != 0) wrong = errno;
  errno = wrong;
  return wrong == 0 ? 0 : failed(draft);
}

/* 1: the folder's settings are those of the study, 0: it has none, -1 after a message. */
static int settings_read(sweep_log *l, uint64_t block)
{
  char path[NAME], print[NAME];
  unsigned long long own = 0, workers = 0;
  FILE *f;
  int n, other;

  if (path_of(path, l->folder, "settings")) return -1;
  f = fopen(path, "r");
  if (f == NULL) return errno == ENOENT ? 0 : failed(path);
  n = fscanf(f, "%*[^\n] fingerprint %4095s members %*s block %llu workers %llu", print, &own, &workers);
  other = n == 3 && strcmp(print, l->study->fingerprint) != 0;
  if (other) sweep_another(l->study, l->folder, f);
  fclose(f);
  if (n != 3 || own == 0 || workers == 0) {
    sweep_say("%s is not whole: remove the folder, and the sweep begins anew", path);
    return -1;
  }
  if (other) return -1;
  if (block != 0 && block != own) {
    sweep_say("--block: %s has blocks of %llu members, got %llu", l->folder, own, (unsigned long long)block);
    return -1;
  }
  l->block = (uint64_t)own;
  l->workers = (uint64_t)workers;
  return 1;
}

/* ---- opening ---- */

static int folder_lock(sweep_log *l)
{
  char path[NAME];
  struct flock whole = {0};

  if (path_of(path, l->folder, "lock")) return -1;
  l->lock = open(path, O_RDWR | O_CREAT, 0666);
  if (l->lock < 0) return failed(path);
  whole.l_type = F_WRLCK;
  whole.l_whence = SEEK_SET;
  if (fcntl(l->lock, F_SETLK, &whole) == 0) return 0;
  if (errno == EACCES || errno == EAGAIN) {
    sweep_say("another process works in %s", l->folder);
    return -1;
  }
  return 0; /* a file system without locks */
}

static int prepare(sweep_log *l, int rank, int resume, uint64_t block)
{
  int known;

  if (rank == 0 && mkdir(l->folder, 0777) != 0 && errno != EEXIST) return failed(l->folder);
  if (rank == 0 && folder_lock(l)) return -1;
  known = settings_read(l, block);
  if (known < 0) return -1;
  if (known == 1 && !resume && rank == 0) {
    sweep_say("%s has what an earlier run computed: --resume goes on with it (or remove the folder)", l->folder);
    return -1;
  }
  if (known == 0) l->block = block != 0 ? block : USUAL;
  sweep_divide(&l->layout, l->study->members, l->block, l->workers, l->study->lanes);
  return known == 0 && rank == 0 ? settings_write(l) : 0;
}

sweep_log *sweep_log_open(const sweep_study *s, const char *folder, int rank, int resume, uint64_t block,
  uint64_t workers)
{
  sweep_log *l = calloc(1, sizeof *l);
  char name[32];

  if (l == NULL) {
    failed(folder);
    return NULL;
  }
  l->study = s;
  l->fd = l->lock = -1;
  l->workers = workers;
  snprintf(l->folder, sizeof l->folder, "%s", folder);
  snprintf(name, sizeof name, "rank-%05d.log", rank);
  if (path_of(l->own, folder, name) == 0 && prepare(l, rank, resume, block) == 0) {
    l->blocks = l->layout.blocks;
    l->file = calloc((size_t)l->blocks, sizeof *l->file);
    l->place = calloc((size_t)l->blocks, sizeof *l->place);
    if (l->file != NULL && l->place != NULL) return l;
    failed(folder);
  }
  sweep_log_close(l, 0);
  return NULL;
}

/* ---- reading ---- */

static int order(const void *a, const void *b) { return strcmp((const char *)a, (const char *)b); }

/* The logs of the folder in the order of their names. */
static int list(sweep_log *l)
{
  DIR *d = opendir(l->folder);
  struct dirent *e;
  int i;

  if (d == NULL) return failed(l->folder);
  for (i = 0; i < l->file_count; i++) close(l->open[i]);
  l->file_count = 0;
  while ((e = readdir(d)) != NULL) {
    const size_t n = strlen(e->d_name);
    char (*files)[NAME];

    if (strncmp(e->d_name, "rank-", 5) != 0 || n < 4 || strcmp(e->d_name + n - 4, ".log") != 0) continue;
    files = realloc(l->files, (size_t)(l->file_count + 1)*sizeof *files);
    if (files == NULL) break;
    l->files = files;
    if (path_of(l->files[l->file_count], l->folder, e->d_name) == 0) l->file_count++;
  }
  closedir(d);
  if (l->file_count > 0) qsort(l->files, (size_t)l->file_count, sizeof *l->files, order);
  free(l->open);
  l->open = calloc((size_t)l->file_count + 1, sizeof *l->open);
  if (l->open == NULL) return failed(l->folder);
  for (i = 0; i < l->file_count; i++) {
    l->open[i] = open(l->files[i], O_RDONLY);
    if (l->open[i] < 0) {
      failed(l->files[i]);
      l->file_count = i;
      return -1;
    }
  }
  return 0;
}

/* The whole records of file i; *end: behind the last of them. */
static int scan(sweep_log *l, int i, sweep_stats *all, int64_t *end)
{
  const off_t size = lseek(l->open[i], 0, SEEK_END);
  unsigned char *data = NULL;
  int64_t at = 0;
  int wrong = 0;

  while (!wrong) {
    uint64_t head[HEAD], k, ids;
    size_t whole;
    unsigned char *more;

    if (read_all(l->open[i], head, sizeof head, at) != 0 || head[0] != MAGIC || head[1] > l->blocks) break;
    ids = head[1]*sizeof(uint64_t);
    if (head[2] > (uint64_t)size || ids + head[2] > (uint64_t)(size - at) - sizeof head) break;
    whole = (size_t)(ids + head[2]);
    more = realloc(data, whole + 1);
    if (more == NULL) {
      wrong = failed(l->files[i]);
      break;
    }
    data = more;
    if (read_all(l->open[i], data, whole, at + (int64_t)sizeof head) != 0) break;
    if (sweep_checksum(head[1] ^ head[2] << 32, data, whole) != head[3]) break;
    for (k = 0; k < head[1]; k++) {
      uint64_t b;

      memcpy(&b, data + k*sizeof b, sizeof b);
      if (b >= l->blocks || (l->file[b] != 0 && l->study->stats)) {
        sweep_say("%s: block %llu does not belong there", l->files[i], (unsigned long long)b);
        wrong = -1;
        break;
      }
      l->file[b] = (uint32_t)(i + 1);
      l->place[b] = at + (int64_t)(sizeof head + ids);
    }
    if (all != NULL && !wrong && sweep_stats_merge(all, data + ids, (size_t)head[2]) != 0) {
      sweep_say("%s: statistics that are not those of this sweep", l->files[i]);
      wrong = -1;
    }
    at += (int64_t)(sizeof head + whole);
  }
  free(data);
  *end = at;
  return wrong;
}

uint64_t sweep_log_scan(sweep_log *l, sweep_stats *all)
{
  uint64_t b, missing = 0;
  int i;

  if (list(l) != 0) return UINT64_MAX;
  memset(l->file, 0, (size_t)l->blocks*sizeof *l->file);
  l->end = 0;
  for (i = 0; i < l->file_count; i++) {
    int64_t end;

    if (scan(l, i, all, &end) != 0) return UINT64_MAX;
    if (strcmp(l->files[i], l->own) == 0) l->end = end;
  }
  for (b = 0; b < l->blocks; b++) missing += l->file[b] == 0;
  return missing;
}

int sweep_log_has(const sweep_log *l, uint64_t block) { return l->file[block] != 0; }

int sweep_log_read(sweep_log *l, uint64_t block, double rows[], int32_t status[])
{
  uint64_t first;
  const uint64_t n = sweep_block(&l->layout, block, &first);
  const size_t numbers = (size_t)n*(size_t)l->study->width*sizeof *rows, states = (size_t)n*sizeof *status;
  const int fd = l->open[l->file[block] - 1];

  if (read_all(fd, rows, numbers, l->place[block]) == 0 &&
      read_all(fd, status, states, l->place[block] + (int64_t)numbers) == 0) {
    return 0;
  }
  sweep_say("%s: block %llu cannot be read", l->files[l->file[block] - 1], (unsigned long long)block);
  return -1;
}

/* ---- writing ---- */

int sweep_log_begin(sweep_log *l)
{
  l->fd = open(l->own, O_RDWR | O_CREAT, 0666);
  if (l->fd < 0 || ftruncate(l->fd, (off_t)l->end) != 0) return failed(l->own);
  l->synced = time(NULL);
  return 0;
}

int sweep_log_append(sweep_log *l, const uint64_t blocks[], uint64_t n, const void *data, size_t size)
{
  const size_t ids = (size_t)n*sizeof *blocks;
  uint64_t head[HEAD] = {MAGIC, n, size, 0};
  int wrong;

  if (ids + size > 0) { /* in one piece, as the checksum reads it */
    unsigned char *whole = malloc(sizeof head + ids + size);

    if (whole == NULL) return failed(l->own);
    memcpy(whole + sizeof head, blocks, ids);
    memcpy(whole + sizeof head + ids, data, size);
    head[3] = sweep_checksum(n ^ (uint64_t)size << 32, whole + sizeof head, ids + size);
    memcpy(whole, head, sizeof head);
    wrong = write_all(l->fd, whole, sizeof head + ids + size, l->end);
    free(whole);
    if (wrong == 0 && time(NULL) != l->synced) { /* against a machine that stops: at most once a second */
      if (fdatasync(l->fd) != 0 && errno != EINVAL && errno != EROFS) wrong = errno;
      l->synced = time(NULL);
    }
    if (wrong != 0) {
      if (ftruncate(l->fd, (off_t)l->end) != 0) { /* its checksum tells, too */ }
      errno = wrong;
      failed(l->own);
      sweep_say("what is in %s is whole: with room --resume goes on from there", l->folder);
      return -1;
    }
    l->end += (int64_t)(sizeof head + ids + size);
  }
  return 0;
}

void sweep_log_close(sweep_log *l, int finished)
{
  static const char *const names[] = {"settings", "settings.new", "lock"};
  char path[NAME];
  int i;

  if (l->fd >= 0) close(l->fd);
  for (i = 0; i < l->file_count; i++) {
    close(l->open[i]);
    if (finished) remove(l->files[i]);
  }
  for (i = 0; finished && i < 3; i++) {
    if (path_of(path, l->folder, names[i]) == 0) remove(path);
  }
  if (l->lock >= 0) close(l->lock);
  if (finished) rmdir(l->folder);
  free(l->files);
  free(l->open);
  free(l->file);
  free(l->place);
  free(l);
}
