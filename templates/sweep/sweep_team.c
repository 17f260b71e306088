/* sweep_team.c -- the threads of a rank: the main one fetches numbers of blocks, the others compute them.
 * template: templates/sweep/sweep_team.c.  SPDX-License-Identifier: MIT-0 */
#define _XOPEN_SOURCE 700
#include "sweep.h"

#include <pthread.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { MOST_THREADS = 1024 };

typedef struct team {
  const sweep_work *w;
  pthread_mutex_t lock;
  pthread_cond_t filled, taken;
  uint64_t queue[MOST_THREADS];       /* blocks that were fetched and not begun */
  int waiting, over, failed, working; /* over: nothing will be put into the queue any more */
  int idle, late;                     /* idle: threads that wait for a block; late: the blocks become smaller */
  uint64_t done;                      /* members */
  sweep_stats *stats;                 /* of a study with statistics: of the blocks since the last record */
  uint64_t *gathered, gathered_count, gathered_room;
  double started, recorded;
} team;

static volatile sig_atomic_t stopped;

static void stop(int signal) { stopped = signal; }

static double now(void)
{
  struct timespec t;

  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9*(double)t.tv_nsec;
}

/* ---- a thread ---- */

/* What was gathered since the last record goes to the log: every two seconds, later every twentieth of the time. */
static int record(team *t, int last)
{
  const double age = now() - t->recorded, past = 0.05*(t->recorded - t->started);
  unsigned char *bytes;
  size_t size;
  int wrong;

  if (t->gathered_count == 0 || (!last && age < (past > 2.0 ? past : 2.0))) return 0;
  bytes = sweep_stats_pack(t->stats, &size);
  wrong = sweep_log_append(t->w->log, t->gathered, t->gathered_count, bytes, size);
  free(bytes);
  sweep_stats_free(t->stats);
  t->stats = sweep_stats_new(t->w->study);
  t->gathered_count = 0;
  t->recorded = now();
  return wrong;
}

static int gather(team *t, uint64_t block, int count, const double rows[], const int32_t status[])
{
  if (t->gathered_count == t->gathered_room) {
    const uint64_t room = 2*t->gathered_room + 64;
    uint64_t *more = realloc(t->gathered, (size_t)room*sizeof *more);

    if (more == NULL) return -1;
    t->gathered = more;
    t->gathered_room = room;
  }
  sweep_stats_add(t->stats, count, rows, status);
  t->gathered[t->gathered_count++] = block;
  return record(t, 0);
}

static void *work(void *given)
{
  team *t = given;
  const sweep_study *s = t->w->study;
  const sweep_layout *d = sweep_log_layout(t->w->log);
  const size_t width = (size_t)s->width, room = (size_t)d->most*(width*sizeof(double) + sizeof(int32_t));
  double *rows = malloc(room); /* and behind them the statuses */

  pthread_mutex_lock(&t->lock);
  if (rows == NULL) {
    sweep_say("there is no memory for a block of %llu members", (unsigned long long)d->most);
    t->failed = 1;
  }
  while (!t->failed) {
    uint64_t block, first, k;
    size_t count;
    int32_t *status;

    t->idle++;
    if (t->waiting == 0) pthread_cond_signal(&t->taken);
    while (t->waiting == 0 && !t->over) pthread_cond_wait(&t->filled, &t->lock);
    t->idle--;
    if (t->waiting == 0) break;
    block = t->queue[0];
    t->waiting--;
    memmove(t->queue, t->queue + 1, (size_t)t->waiting*sizeof t->queue[0]);
    t->working++;
    pthread_cond_signal(&t->taken);
    pthread_mutex_unlock(&t->lock);

    count = (size_t)sweep_block(d, block, &first);
    status = (int32_t *)(void *)(rows + count*width);
    for (k = 0; k < count; k += (uint64_t)s->lanes) {
      const uint64_t left = count - k;

      s->compute(first + k, left < (uint64_t)s->lanes ? (int)left : s->lanes, rows + k*width, status + k);
    }

    pthread_mutex_lock(&t->lock);
    t->working--;
    if (!t->failed && (s->stats ? gather(t, block, (int)count, rows, status) :
        sweep_log_append(t->w->log, &block, 1, rows, count*(width*sizeof *rows + sizeof *status))) != 0) {
      t->failed = 1;
    }
    t->done += count;
  }
  pthread_cond_signal(&t->taken);
  pthread_mutex_unlock(&t->lock);
  free(rows);
  return NULL;
}

/* ---- the main thread ---- */

/* "12.3 %   1.25e+06 bodies/s   1:05 left" */
static void show(const team *t, uint64_t all)
{
  const double age = now() - t->started, rate = age > 0.0 ? (double)t->done/age : 0.0;
  const double left = rate > 0.0 ? ((double)all - (double)t->done)/rate : 0.0;
  const long s = left < 1e8 ? (long)(left + 0.5) : 100000000L;

  fprintf(stderr, "\r%5.1f %%   %.3g bodies/s   %ld:%02ld:%02ld left ", 100.0*(double)t->done/(double)all, rate, s/3600,
    s/60%60, s%60);
  fflush(stderr);
}

/* The next block to compute, or UINT64_MAX.  The counter numbers the blocks that were missing in the beginning. */
static uint64_t next_block(const uint64_t todo[], uint64_t n)
{
  const uint64_t i = sweep_ranks_next();

  return i < n ? todo[i] : UINT64_MAX;
}

/* Blocks are fetched while those before are computed.  Late in the sweep a block is fetched only for a thread that has
 * none: one that waited behind a slow block could be computed elsewhere. */
static int hungry(const team *t) { return !t->over && t->waiting < (t->late ? t->idle : t->w->threads); }

static void direct(team *t, const uint64_t todo[], uint64_t n, uint64_t members)
{
  const sweep_layout *d = sweep_log_layout(t->w->log);
  double shown = t->started;

  pthread_mutex_lock(&t->lock);
  while (!t->failed && !stopped && !t->over) {
    while (hungry(t)) {
      uint64_t block, first;

      pthread_mutex_unlock(&t->lock);
      block = next_block(todo, n);
      pthread_mutex_lock(&t->lock);
      if (block == UINT64_MAX) {
        t->over = 1;
      } else {
        t->queue[t->waiting++] = block;
        t->late = sweep_block(d, block, &first) < d->most;
        pthread_cond_signal(&t->filled);
      }
    }
    if (!t->over) {
      struct timespec until;

      clock_gettime(CLOCK_REALTIME, &until);
      until.tv_nsec += 1000000;
      if (until.tv_nsec >= 1000000000) until.tv_sec++, until.tv_nsec -= 1000000000;
      pthread_cond_timedwait(&t->taken, &t->lock, &until);
      pthread_mutex_unlock(&t->lock);
      sweep_ranks_attend();
      pthread_mutex_lock(&t->lock);
    }
    if (t->w->progress && now() - shown > 0.5) {
      show(t, members);
      shown = now();
    }
  }
  if (stopped || t->failed) t->waiting = 0;
  t->over = 1;
  pthread_cond_broadcast(&t->filled);
  while (t->working > 0 || t->waiting > 0) { /* the last blocks */
    struct timespec rest = {0, 1000000};

    pthread_mutex_unlock(&t->lock);
    nanosleep(&rest, NULL);
    sweep_ranks_attend();
    pthread_mutex_lock(&t->lock);
    if (stopped || t->failed) t->waiting = 0;
    if (t->w->progress && now() - shown > 0.5) {
      show(t, members);
      shown = now();
    }
  }
  pthread_mutex_unlock(&t->lock);
}

int sweep_team_run(sweep_work *w)
{
  static const int signals[] = {SIGINT, SIGTERM, SIGUSR1};
  const sweep_layout *d = sweep_log_layout(w->log);
  const uint64_t blocks = d->blocks;
  pthread_t thread[MOST_THREADS];
  struct sigaction action;
  uint64_t *todo = malloc((size_t)blocks*sizeof *todo), n = 0, members = 0, b;
  team t;
  int i, made;

  if (todo == NULL) {
    sweep_say("there is no memory for a list of %llu blocks", (unsigned long long)blocks);
    return -1;
  }
  for (b = 0; b < blocks; b++) {
    uint64_t first;

    if (sweep_log_has(w->log, b)) continue;
    todo[n++] = b;
    members += sweep_block(d, b, &first);
  }
  memset(&t, 0, sizeof t);
  t.w = w;
  t.started = t.recorded = now();
  t.stats = w->study->stats ? sweep_stats_new(w->study) : NULL;
  pthread_mutex_init(&t.lock, NULL);
  pthread_cond_init(&t.filled, NULL);
  pthread_cond_init(&t.taken, NULL);
  memset(&action, 0, sizeof action);
  action.sa_handler = stop;
  for (i = 0; i < 3; i++) sigaction(signals[i], &action, NULL);
  w->threads = w->threads < 1 ? 1 : w->threads > MOST_THREADS ? MOST_THREADS : w->threads;
  for (made = 0; made < w->threads; made++) {
    if (pthread_create(&thread[made], NULL, work, &t) != 0) break;
  }
  if (made == 0) {
    sweep_say("no thread can be started");
    t.failed = 1;
  }
  direct(&t, todo, n, members);
  for (i = 0; i < made; i++) pthread_join(thread[i], NULL);
  if (w->study->stats && !t.failed) t.failed = record(&t, 1) != 0;
  if (t.stats != NULL) sweep_stats_free(t.stats);
  if (w->progress) fprintf(stderr, "\r%60s\r", "");
  free(t.gathered);
  free(todo);
  pthread_cond_destroy(&t.taken);
  pthread_cond_destroy(&t.filled);
  pthread_mutex_destroy(&t.lock);
  return t.failed ? -1 : (int)stopped;
}
