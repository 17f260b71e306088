/* sweep.h -- many members of one study: what the parts of the program share.
 * template: templates/sweep/sweep.h.  SPDX-License-Identifier: MIT-0
 *
 * NAME_members.c describes the study and computes a block of its members; everything else here knows no scene.  Member
 * k is a pure function of the study and of k: threads, ranks, blocks and restarts do not change a bit of it. */
#ifndef SWEEP_HEADER
#define SWEEP_HEADER

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

/* ---- the study: constants that the generator wrote ---- */

typedef double sweep_real;

/* A grid's axis: `count` values from low to high, both exactly; log: in equal ratios. */
typedef struct sweep_axis {
  double low, high;
  uint64_t count;
  int log;
} sweep_axis;

/* A random value.  dimension: which number of the point it takes, the first of three for an attitude. */
enum sweep_kind {
  SWEEP_UNIFORM,    /* between a and b */
  SWEEP_LOGUNIFORM, /* its logarithm uniform, between a and b */
  SWEEP_NORMAL,     /* mean a, standard deviation b */
  SWEEP_JOINT,      /* mean a, plus a row of the factor of the covariance times normal deviates */
  SWEEP_ATTITUDE    /* component `part` of a quaternion, all attitudes equally likely */
};
typedef struct sweep_draw {
  enum sweep_kind kind;
  double a, b;
  int dimension, part; /* part: of an attitude, or the length of the factor's row */
  const double *row;
} sweep_draw;

enum sweep_points { SWEEP_RANDOM, SWEEP_SOBOL, SWEEP_LHS };

/* One or more numbers of a row; times > 1: one for each of the study's times. */
typedef struct sweep_column {
  const char *name, *unit, *about;
  int times;
} sweep_column;

/* What became of a member, with words in the study's reasons; SWEEP_REFUSED + n: NAME_init's check n failed. */
enum sweep_status {
  SWEEP_FINE, SWEEP_MISSED, SWEEP_INFINITE, SWEEP_LONG, SWEEP_LOST, SWEEP_SETTLED, SWEEP_FALLEN, SWEEP_NO_BODY, SWEEP_REFUSED
};

typedef struct sweep_study {
  const char *scene, *version, *command, *fingerprint; /* the fingerprint: of all that decides a bit of the result */
  const char *const *text;                             /* the scene's own, in pieces; the last is NULL */
  uint64_t members, samples, seed;                     /* samples: points at each point of the grid, at least 1 */
  enum sweep_points points;
  const sweep_axis *axes;
  const sweep_draw *draws;
  int axis_count, draw_count;
  const sweep_column *columns; /* the varied values, in the order of axes and draws, then what is kept */
  int column_count, varied, width; /* width: numbers in a row */
  const double *times;
  int time_count;
  const char *const *reasons; /* of the status numbers */
  int reason_count;
  int stats; /* no rows are kept, but sums and counts of the columns */
  /* Members first .. first + count - 1, count at most `lanes`: rows of `width` numbers, and a status each. */
  void (*compute)(uint64_t first, int count, double rows[], int32_t status[]);
  int lanes;
} sweep_study;

extern const sweep_study sweep_this;

/* ---- sweep_draw.c: the values of a member ---- */

void sweep_philox(const uint32_t counter[4], const uint32_t key[2], uint32_t out[4]);
double sweep_uniform(uint64_t seed, uint64_t member, uint32_t draw, uint32_t purpose);
double sweep_normal(double u);
uint64_t sweep_permuted(uint64_t seed, uint32_t which, uint64_t i, uint64_t n);
void sweep_values(const sweep_study *s, uint64_t member, double v[]);
/* The attitude q turned by the rotation vector (a, b, c), rad, about body axes or about those of space. */
void sweep_turn(double q[4], double a, double b, double c, int body);
void sweep_unit(double q[4]); /* to length 1; no number where it has none */

/* ---- sweep_sobol.c ---- */

enum { SWEEP_SOBOL_MOST = 21 };
uint32_t sweep_sobol(uint64_t i, int dimension);

/* ---- sweep_math.c: the same bits on every machine ---- */

double sweep_math_log(double x);
double sweep_math_exp(double x);
double sweep_math_sin(double x);
double sweep_math_cos(double x);

/* ---- sweep_exact.c: sums whose bits do not depend on the order ---- */

/* A sum of doubles without rounding: words of 32 bits, the first counting 2^-1074, and what carries beyond. */
enum { SWEEP_WORDS = 70 };
typedef struct sweep_sum {
  int64_t word[SWEEP_WORDS];
  int32_t pending; /* additions since the carries were settled */
} sweep_sum;
void sweep_sum_add(sweep_sum *s, double x);
void sweep_sum_product(sweep_sum *s, double x, double y); /* x y, exactly while |x y| is within 2^-960 .. 2^1020 */
void sweep_sum_times(sweep_sum *s, double f, const sweep_sum *more); /* s += f more, as exactly */
void sweep_sum_merge(sweep_sum *s, const sweep_sum *more);
void sweep_sum_settle(sweep_sum *s);
double sweep_sum_value(const sweep_sum *s); /* rounded once */

/* ---- sweep_stats.c ---- */

typedef struct sweep_stats sweep_stats;
sweep_stats *sweep_stats_new(const sweep_study *s);
void sweep_stats_free(sweep_stats *all);
void sweep_stats_add(sweep_stats *all, int count, const double rows[], const int32_t status[]);
/* A state as bytes: the same for the same members, in whatever order they came.  malloc'ed. */
unsigned char *sweep_stats_pack(sweep_stats *all, size_t *size);
int sweep_stats_merge(sweep_stats *all, const unsigned char *bytes, size_t size); /* 0, or -1: no such state */

/* What there is to tell of a column. */
enum { SWEEP_QUANTILES = 9, SWEEP_BINS = 64 };
extern const double sweep_quantile[SWEEP_QUANTILES];
typedef struct sweep_summary {
  uint64_t count, missing; /* missing: not a number, as of a passage that never came */
  double mean, deviation, least, most, quantile[SWEEP_QUANTILES];
} sweep_summary;
void sweep_stats_summary(const sweep_stats *all, int number, sweep_summary *out);
/* Of the members in which all numbers are some; NaN with fewer than two. */
double sweep_stats_covariance(const sweep_stats *all, int i, int j);
/* Counts in SWEEP_BINS equal bins from low to high. */
void sweep_stats_histogram(const sweep_stats *all, int number, double *low, double *high, uint64_t bins[]);
const uint64_t *sweep_stats_statuses(const sweep_stats *all);

/* ---- sweep_blocks.c: members in blocks ---- */

/* Blocks of one size after blocks of another, smaller at the end; level: where each size begins. */
enum { SWEEP_LEVELS = 6 };
typedef struct sweep_layout {
  uint64_t members, blocks, most; /* most: members in the largest block */
  int levels;
  struct {
    uint64_t block, member, size;
  } level[SWEEP_LEVELS];
} sweep_layout;
/* workers: threads of all ranks.  lanes: members that are computed at a time. */
void sweep_divide(sweep_layout *d, uint64_t members, uint64_t block, uint64_t workers, int lanes);
uint64_t sweep_block(const sweep_layout *d, uint64_t b, uint64_t *first); /* how many are in block b, from which on */

/* ---- sweep_log.c: what is computed goes to a log at once ---- */

typedef struct sweep_log sweep_log;
/* The folder of the logs, made if it is not there.  resume: its blocks count.  block: members in a block as asked for,
 * 0: any.  With resume the folder's own blocks are taken, whatever the number of workers is now.  NULL after a message. */
sweep_log *sweep_log_open(const sweep_study *s, const char *folder, int rank, int resume, uint64_t block,
  uint64_t workers);
/* Of words, after h: every bit of each counts, and their order. */
uint64_t sweep_checksum(uint64_t h, const void *data, size_t size);
const sweep_layout *sweep_log_layout(const sweep_log *l);
/* Looks at all logs of the folder; how many blocks are missing, UINT64_MAX after a message.  all: NULL, or the
 * statistics in them are merged into it. */
uint64_t sweep_log_scan(sweep_log *l, sweep_stats *all);
int sweep_log_has(const sweep_log *l, uint64_t block);
/* Begins this rank's own log behind its last whole record; 0, or -1 after a message. */
int sweep_log_begin(sweep_log *l);
/* A record of n blocks; 0, or -1 after a message. */
int sweep_log_append(sweep_log *l, const uint64_t blocks[], uint64_t n, const void *data, size_t size);
/* The block's rows and statuses; 0, or -1 after a message. */
int sweep_log_read(sweep_log *l, uint64_t block, double rows[], int32_t status[]);
void sweep_log_close(sweep_log *l, int finished); /* finished: the folder goes */

/* ---- sweep_seal.c: whose result a finished file is ---- */

int sweep_seal_write(const sweep_study *s, const char *file); /* FILE.study; 0, or -1 after a message */
int sweep_seal_check(const sweep_study *s, const char *file); /* 0: the file is this study's, whole; or -1 after a message */
/* Says that `where` is of another study, by the settings in f. */
void sweep_another(const sweep_study *s, const char *where, FILE *f);

/* ---- sweep_team.c: threads, ranks ---- */

typedef struct sweep_work {
  const sweep_study *study;
  sweep_log *log;
  int threads, progress;
} sweep_work;
/* Computes all blocks that the log has not; 0, the number of the signal that stopped it, or -1 after a message. */
int sweep_team_run(sweep_work *w);

/* ---- sweep_mpi.c: MPI where it is compiled in, else one rank ---- */

void sweep_ranks_open(int *argc, char ***argv, int *rank, int *ranks);
uint64_t sweep_ranks_next(void); /* the next number nobody has had */
void sweep_ranks_attend(void);   /* lets the others' requests through */
void sweep_ranks_wait(void);     /* for all */
int sweep_ranks_tell(int value); /* rank 0's, to all */
void sweep_ranks_close(void);
void sweep_ranks_abort(int status);
const char *sweep_ranks_about(void);

/* ---- sweep_csv.c, sweep_hdf5.c: the result; 0, or -1 after a message ---- */

int sweep_csv_write(const sweep_study *s, sweep_log *l, const char *path);
int sweep_csv_stats(const sweep_study *s, const sweep_stats *all, const char *path);
int sweep_hdf5_there(void);
int sweep_hdf5_write(const sweep_study *s, sweep_log *l, const char *path);
int sweep_hdf5_stats(const sweep_study *s, const sweep_stats *all, const char *path);

void sweep_say(const char *format, ...); /* a line on standard error, after the program's name */

#endif
