/* sweep_stats.c -- mean, covariance, quantiles, histograms of members that are not kept.
 * template: templates/sweep/sweep_stats.c.  SPDX-License-Identifier: MIT-0
 *
 * Everything that is gathered is a whole number (exact sums, counts) or a least or greatest value, so members may come in
 * any order and states may be merged in any order: the result has the same bits.
 *
 * Quantiles and histograms go by counts of buckets: a value minus that of member 0 is put into one of 2^20 by the first
 * 20 bits of its double, in the order of the numbers.  A bucket is 2^-8 of that distance wide. */
#include "sweep.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { PAGES = 1024, PAGE = 1024 };

typedef struct number {
  uint64_t count, missing;
  double least, most, about; /* about: the value of member 0, from which buckets are counted */
  sweep_sum sum, square;
  uint64_t *page[PAGES];
} number;

struct sweep_stats {
  const sweep_study *study;
  int width, statuses;
  uint64_t *status, complete; /* complete: members of which every number is one */
  number *number;
  sweep_sum *sum, *product; /* of complete members: sums, and products of i and j <= i at i (i + 1)/2 + j */
};

const double sweep_quantile[SWEEP_QUANTILES] = {0.001, 0.01, 0.05, 0.25, 0.5, 0.75, 0.95, 0.99, 0.999};

static int finite_number(double x) { return x - x == 0.0; }

static int bucket(double x)
{
  uint64_t u;

  memcpy(&u, &x, sizeof u);
  u ^= u >> 63 ? UINT64_MAX : (uint64_t)1 << 63; /* ascending with x */
  return (int)(u >> 44);
}

/* The middle of a bucket. */
static double middle(int b)
{
  uint64_t u = (uint64_t)b << 44 | (uint64_t)1 << 43;
  double x;

  u ^= u >> 63 ? (uint64_t)1 << 63 : UINT64_MAX;
  memcpy(&x, &u, sizeof x);
  return x;
}

static void *need(size_t n, size_t size)
{
  void *p = calloc(n > 0 ? n : 1, size);

  if (p == NULL) {
    sweep_say("there is no memory for the statistics");
    exit(2);
  }
  return p;
}

sweep_stats *sweep_stats_new(const sweep_study *s)
{
  sweep_stats *all = need(1, sizeof *all);
  const size_t w = (size_t)s->width;
  double *row = need(w*(size_t)s->lanes, sizeof *row);
  int32_t *status = need((size_t)s->lanes, sizeof *status);
  int i;

  all->study = s;
  all->width = s->width;
  all->statuses = s->reason_count;
  all->status = need((size_t)s->reason_count, sizeof *all->status);
  all->number = need(w, sizeof *all->number);
  all->sum = need(w, sizeof *all->sum);
  all->product = need(w*(w + 1)/2, sizeof *all->product);
  s->compute(0, 1, row, status);
  for (i = 0; i < s->width; i++) {
    number *n = &all->number[i];

    n->least = HUGE_VAL;
    n->most = -HUGE_VAL;
    n->about = finite_number(row[i]) ? row[i] : 0.0;
  }
  free(row);
  free(status);
  return all;
}

void sweep_stats_free(sweep_stats *all)
{
  int i, k;

  for (i = 0; i < all->width; i++) {
    for (k = 0; k < PAGES; k++) free(all->number[i].page[k]);
  }
  free(all->status);
  free(all->number);
  free(all->sum);
  free(all->product);
  free(all);
}

static uint64_t *page_of(number *n, int p)
{
  if (n->page[p] == NULL) n->page[p] = need(PAGE, sizeof *n->page[p]);
  return n->page[p];
}

static void add_number(number *n, double x)
{
  int b;

  if (!finite_number(x)) {
    n->missing++;
    return;
  }
  n->count++;
  n->least = x < n->least ? x : n->least;
  n->most = x > n->most ? x : n->most;
  sweep_sum_add(&n->sum, x);
  sweep_sum_product(&n->square, x, x);
  b = bucket(x - n->about);
  page_of(n, b/PAGE)[b%PAGE]++;
}

void sweep_stats_add(sweep_stats *all, int count, const double rows[], const int32_t status[])
{
  int k, i, j;

  for (k = 0; k < count; k++) {
    const double *row = rows + (size_t)k*(size_t)all->width;
    int whole = 1;

    all->status[status[k]]++;
    if (status[k] != SWEEP_FINE && status[k] != SWEEP_MISSED) continue;
    for (i = 0; i < all->width; i++) {
      add_number(&all->number[i], row[i]);
      whole = whole && finite_number(row[i]);
    }
    if (!whole) continue;
    all->complete++;
    for (i = 0; i < all->width; i++) {
      sweep_sum_add(&all->sum[i], row[i]);
      for (j = 0; j <= i; j++) sweep_sum_product(&all->product[i*(i + 1)/2 + j], row[i], row[j]);
    }
  }
}

/* ---- a state as bytes ---- */

typedef struct writer {
  unsigned char *bytes;
  size_t size, room;
} writer;

static void put(writer *w, const void *data, size_t size)
{
  if (w->size + size > w->room) {
    unsigned char *more = realloc(w->bytes, w->room = 2*(w->size + size));

    if (more == NULL) {
      sweep_say("there is no memory for the statistics");
      exit(2);
    }
    w->bytes = more;
  }
  memcpy(w->bytes + w->size, data, size);
  w->size += size;
}

static void put_sum(writer *w, sweep_sum *s)
{
  sweep_sum_settle(s);
  put(w, s->word, sizeof s->word);
}

unsigned char *sweep_stats_pack(sweep_stats *all, size_t *size)
{
  writer w = {NULL, 0, 0};
  uint64_t n;
  int i, k;

  n = (uint64_t)all->width;
  put(&w, &n, sizeof n);
  put(&w, all->status, (size_t)all->statuses*sizeof *all->status);
  put(&w, &all->complete, sizeof all->complete);
  for (i = 0; i < all->width; i++) {
    number *m = &all->number[i];

    put(&w, &m->count, sizeof m->count);
    put(&w, &m->missing, sizeof m->missing);
    put(&w, &m->least, sizeof m->least);
    put(&w, &m->most, sizeof m->most);
    put_sum(&w, &m->sum);
    put_sum(&w, &m->square);
    for (n = 0, k = 0; k < PAGES; k++) n += m->page[k] != NULL;
    put(&w, &n, sizeof n);
    for (k = 0; k < PAGES; k++) {
      if (m->page[k] == NULL) continue;
      n = (uint64_t)k;
      put(&w, &n, sizeof n);
      put(&w, m->page[k], PAGE*sizeof *m->page[k]);
    }
    put_sum(&w, &all->sum[i]);
  }
  for (i = 0; i < all->width*(all->width + 1)/2; i++) put_sum(&w, &all->product[i]);
  *size = w.size;
  return w.bytes;
}

typedef struct reader {
  const unsigned char *bytes;
  size_t left;
  int short_of;
} reader;

static void get(reader *r, void *data, size_t size)
{
  if (r->left < size) {
    r->short_of = 1;
    memset(data, 0, size);
    return;
  }
  memcpy(data, r->bytes, size);
  r->bytes += size;
  r->left -= size;
}

static uint64_t get_count(reader *r)
{
  uint64_t n;

  get(r, &n, sizeof n);
  return n;
}

static void get_sum(reader *r, sweep_sum *s)
{
  sweep_sum more;

  get(r, more.word, sizeof more.word);
  more.pending = 0;
  sweep_sum_merge(s, &more);
}

int sweep_stats_merge(sweep_stats *all, const unsigned char *bytes, size_t size)
{
  reader r = {bytes, size, 0};
  int i, k;

  if (get_count(&r) != (uint64_t)all->width) return -1;
  for (i = 0; i < all->statuses; i++) all->status[i] += get_count(&r);
  all->complete += get_count(&r);
  for (i = 0; i < all->width && !r.short_of; i++) {
    number *m = &all->number[i];
    double least, most;
    uint64_t pages;

    m->count += get_count(&r);
    m->missing += get_count(&r);
    get(&r, &least, sizeof least);
    get(&r, &most, sizeof most);
    m->least = least < m->least ? least : m->least;
    m->most = most > m->most ? most : m->most;
    get_sum(&r, &m->sum);
    get_sum(&r, &m->square);
    for (pages = get_count(&r); pages > 0 && !r.short_of; pages--) {
      const uint64_t p = get_count(&r);
      uint64_t *to;

      if (p >= PAGES) return -1;
      to = page_of(m, (int)p);
      for (k = 0; k < PAGE; k++) to[k] += get_count(&r);
    }
    get_sum(&r, &all->sum[i]);
  }
  for (i = 0; i < all->width*(all->width + 1)/2; i++) get_sum(&r, &all->product[i]);
  return r.short_of || r.left > 0 ? -1 : 0;
}

/* ---- what there is to tell ---- */

/* s += f x y */
static void add_times(sweep_sum *s, double f, double x, double y)
{
  sweep_sum product = {{0}, 0};

  sweep_sum_product(&product, x, y);
  sweep_sum_times(s, f, &product);
}

/* The sum of (x - mean x)(y - mean y) over n - 1.  With the rounded means X and Y it is
 * S_xy - X S_y - Y S_x + n X Y - (S_x - n X)(S_y - n Y)/n, of which the first four are added exactly. */
static double centred(uint64_t count, const sweep_sum *x, const sweep_sum *y, const sweep_sum *xy)
{
  const double n = (double)count, mx = sweep_sum_value(x)/n, my = sweep_sum_value(y)/n;
  sweep_sum s = *xy, rest_x = *x, rest_y = *y;

  if (count < 2) return (double)NAN;
  sweep_sum_times(&s, -mx, y);
  sweep_sum_times(&s, -my, x);
  add_times(&s, n, mx, my);
  sweep_sum_product(&rest_x, -n, mx);
  sweep_sum_product(&rest_y, -n, my);
  return (sweep_sum_value(&s) - sweep_sum_value(&rest_x)*sweep_sum_value(&rest_y)/n)/(n - 1.0);
}

/* The value of the given rank, counted from 0, by its bucket. */
static double ranked(const number *n, uint64_t rank)
{
  uint64_t seen = 0;
  int p, k;

  for (p = 0; p < PAGES; p++) {
    for (k = 0; n->page[p] != NULL && k < PAGE; k++) {
      seen += n->page[p][k];
      if (seen > rank) {
        const double x = n->about + middle(p*PAGE + k);

        return x < n->least ? n->least : x > n->most ? n->most : x;
      }
    }
  }
  return n->most;
}

void sweep_stats_summary(const sweep_stats *all, int i, sweep_summary *out)
{
  const number *n = &all->number[i];
  const double none = (double)NAN;
  int k;

  out->count = n->count;
  out->missing = n->missing;
  out->mean = n->count > 0 ? sweep_sum_value(&n->sum)/(double)n->count : none;
  out->deviation = n->count > 1 ? sqrt(fmax(centred(n->count, &n->sum, &n->sum, &n->square), 0.0)) : none;
  out->least = n->count > 0 ? n->least : none;
  out->most = n->count > 0 ? n->most : none;
  for (k = 0; k < SWEEP_QUANTILES; k++) {
    const uint64_t rank = (uint64_t)(sweep_quantile[k]*(double)n->count);

    out->quantile[k] = n->count > 0 ? ranked(n, rank < n->count ? rank : n->count - 1) : none;
  }
}

double sweep_stats_covariance(const sweep_stats *all, int i, int j)
{
  const int a = i > j ? i : j, b = i > j ? j : i;

  return centred(all->complete, &all->sum[a], &all->sum[b], &all->product[a*(a + 1)/2 + b]);
}

void sweep_stats_histogram(const sweep_stats *all, int i, double *low, double *high, uint64_t bins[])
{
  const number *n = &all->number[i];
  int p, k;

  *low = n->count > 0 ? n->least : 0.0;
  *high = n->count > 0 ? n->most : 0.0;
  for (k = 0; k < SWEEP_BINS; k++) bins[k] = 0;
  for (p = 0; p < PAGES; p++) {
    for (k = 0; n->page[p] != NULL && k < PAGE; k++) {
      if (n->page[p][k] > 0) {
        const double at = (n->about + middle(p*PAGE + k) - *low)/(*high - *low)*SWEEP_BINS;
        const int bin = at > 0.0 ? at < SWEEP_BINS ? (int)at : SWEEP_BINS - 1 : 0;

        bins[bin] += n->page[p][k];
      }
    }
  }
}

const uint64_t *sweep_stats_statuses(const sweep_stats *all) { return all->status; }
