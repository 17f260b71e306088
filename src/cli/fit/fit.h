/* fit.h - parameters from logs: what this folder's files share.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * The unknowns theta are the free parameters and, where they are asked for, the initial state of
 * each log (an attitude by a rotation vector about a reference).  A pass goes through all logs once
 * and leaves the residuals z and their derivatives J as a triangle: [J z] = Q [R c; 0 rho].  So no
 * array is as long as a log but the log itself, and R has the digits that J'J would lose.
 */
#ifndef POLHODE_FIT_H
#define POLHODE_FIT_H

#include "../../../templates/fit/fitted.h"
#include "host/course.h"

#include <lauxlib.h>
#include <lua.h>
#include <stddef.h>

enum {
  FIT_MOST = 192,    /* unknowns */
  FIT_CHANNELS = 64, /* residuals of a row */
  FIT_STARTS = 1000, /* points of --starts */
  FIT_OUTLIERS = 20, /* that are named */
  FIT_DRAWN = 1000,  /* rows of a log that a picture has */
  FIT_LAGS = 20,     /* of the test of whiteness */
  FIT_BLOCK = 128    /* rows that are taken into the triangle at a time */
};

/* The rows of a log, or of a piece of one: host/csv.h. */
struct fit_log {
  size_t rows;
  int columns;
  double *t, *y;
  const unsigned *line; /* of the file */
  double spacing;       /* the usual distance of two rows in time */
  double begin;         /* when its initial state is: 0, or where this piece of a log begins */
};

/* ---- odd.c ---- */

/* odd(csv) -> of each column {kind = nil, "constant", "limit" (value: at which it stays; low, high:
 * the limits that it has) or "wrapped" (value: by which it jumps), line, value, rows; turn = are
 * all values within a turn?} */
int host_odd(lua_State *L);

/* ---- triangle.c ---- */

/* n unknowns; r: rows of n + 1 numbers, upper triangular; the last column has c and rho. */
struct fit_triangle {
  int n, filled;
  double r[(FIT_MOST + 1) * (FIT_MOST + 1)];
  double block[(FIT_MOST + 1) * FIT_BLOCK]; /* a column after the other */
};

void triangle_open(struct fit_triangle *a, int n);
/* One row: n derivatives and the residual. */
void triangle_row(struct fit_triangle *a, const double row[]);
/* The same in place: number k goes to [k*FIT_BLOCK], then triangle_next. */
double *triangle_place(struct fit_triangle *a);
void triangle_next(struct fit_triangle *a);
/* Takes in what is left in the block. */
void triangle_close(struct fit_triangle *a);
double triangle_at(const struct fit_triangle *a, int i, int k);

/* ---- turn.c ---- */

struct fit_problem;

void fit_product(const double a[4], const double b[4], double out[4]);
/* Small turns of a log's initial attitude are about q/|q| from now on. */
void fit_refer(struct fit_problem *f, int log, const double q[4]);
/* q = reference exp(a/2), and its derivatives by a (NULL: not asked for). */
void fit_turned(const double reference[4], const double a[3], double q[4], double dq[3][4]);
/* r = 2 atan2(|v|, s) v/|v| of e = (s, v) = factor v, and of its derivatives: dr = factor dv +
 * (slope[0] (v dv) + slope[1] ds) v. */
void fit_logarithm(const double e[4], double r[3], double *factor, double slope[2]);

/* ---- pass.c ---- */

/* One residual of a row, or the three of an attitude. */
struct fit_channel {
  int attitude;      /* does it stand for three, of four columns? */
  int state;         /* the state that it is, if it is one as it stands, else -1 */
  int value, column; /* place in the measured values, first column of the log */
  double sigma[3];
  int wrapped;      /* is the angle without its turns? */
  double low, high; /* limits of the sensor: what stands there is beyond; or NaN */
};

/* For the linear start: what the gyro's columns of a log are of the rates, y = scale w + bias; the
 * tensor's entries as constant + slope p; unknowns: `place` of p, `initial` of the rates at t = 0
 * (-1: they are not free), `own` those of a log's own. */
struct fit_linear {
  int column[3], initial[3], own[3], count, place[FIT_MOST];
  double scale[3], bias[3], constant[6], slope[6][FIT_MOST];
};

/* What a pass counts in a residual's channel (three for an attitude), of one log. */
struct fit_count {
  long n;
  double chi2, sum[FIT_LAGS]; /* sums of z_i z_(i+k) over pairs of equal spacing */
  long pairs[FIT_LAGS];
  double worst, worst_t; /* the largest |z|, and when */
};

/* A border of the rules that a step would cross: normal step <= reach is before it; rule: which
 * one, 0: the step crosses none.  Of the free parameters. */
struct fit_wall {
  int rule;
  double normal[FIT_MOST], reach, behind[FIT_MOST]; /* behind: a body before it, a little away */
};

struct fit_problem {
  const struct polhode_fitted *code;
  void *model;
  double *k0;
  int free_index[FIT_MOST]; /* of the free parameters among all */
  double *p;
  int pieces, near;       /* of each log, all in f->log; is the start near the end? */
  int active;             /* logs that a pass takes, the first ones */
  int free, own, logs, n; /* unknowns: shared, of each log, all */
  struct fit_log *log;
  double *reference, *former;  /* of each log: a quaternion (fit_refer); those before a trial */
  long referred;               /* how often one of them was set */
  struct fit_channel *channel; /* of each log */
  int channels;
  const struct course **course; /* the inputs over time, of each log; NULL: all 0 */
  struct fit_linear *linear;    /* of each log; NULL: there is no such start */
  int starts;                   /* points of Sobol's sequence, in these ranges: */
  double low[FIT_MOST], high[FIT_MOST];
  double size[FIT_MOST]; /* of a free parameter: what is large of its kind */
  double *knots;         /* times at which a step ends */
  int knot_count;
  enum { FIT_SQUARES, FIT_HUBER, FIT_CAUCHY } loss;
  double corner;         /* of the loss, in sigmas */
  double h, until;       /* longest step; rows behind it are left out */
  int refused;           /* the check of the parameters that failed last, 0: none */
  const double *fixed;   /* NULL, or of each state the number with which it begins in place of the
                            scene's; NaN: none */
  long passes, refusals; /* refusals: those whose parameters were no body */
};

/* The values farthest from the model, beyond `limit` sigmas; how many there are. */
struct fit_outliers {
  double limit;
  long count;
  int kept;
  struct fit_outlier {
    int log, residual;
    size_t row;
    double z;
  } worst[FIT_OUTLIERS];
};

/* Of a residual at some rows: time, what was measured and what the model says (NaN: an attitude),
 * and z. */
struct fit_trace {
  int n;
  double t[FIT_DRAWN], y[FIT_DRAWN], model[FIT_DRAWN], z[FIT_DRAWN];
};

/* Triangles that a pass fills, NULL: not asked for.  whole: z and J, with a loss sqrt(2 rho(z)) and
 * its derivatives; inner: sqrt(rho'') J where rho'' > 0; lost: sqrt(-rho'') J where it is negative;
 * outer: psi J.  counts: logs x residuals.
 */
struct fit_sums {
  struct fit_triangle *whole, *inner, *lost, *outer;
  struct fit_count *counts;
  struct fit_outliers *outliers;
  struct fit_trace *traces; /* logs x residuals */
  double *growth; /* of each log: how much larger derivatives are at its end than at its begin */
  double chi2;    /* sum of z^2 */
  long n;
  struct { /* of which pass they are; fit_pass says it, fit_again asks */
    int there, active, loss;
    long referred;
    double h, until, theta[FIT_MOST];
    const void *filled[3];
  } of;
};

/* Residuals of a row. */
int fit_residuals(const struct fit_problem *f);
/* 0; 1: the parameters are no body, the motion is not finite, or the user has interrupted. */
int fit_pass(struct fit_problem *f, const double theta[], struct fit_sums *s);
/* The same; nothing is done where s is of these unknowns already. */
int fit_again(struct fit_problem *f, const double theta[], struct fit_sums *s);

/* The state x of a log's motion at time t; 1: it is not finite. */
int fit_state(struct fit_problem *f, const double theta[], int log, double t, double x[]);

/* What is measured of the motion from theta on, into the log's rows at its times.  As fit_pass. */
int fit_simulate(struct fit_problem *f, const double theta[], int log);

/* ---- input.c ---- */

/* u (templates/fit/fitted.h) from time t on; the time until which it holds: there a line ends, or
 * crosses a limit. */
double fit_inputs_at(const struct fit_problem *f, int log, double t, double u[]);

/* What a fit found. */
struct fit_result {
  double theta[FIT_MOST], chi2, loss;
  long n;
  int converged, iterations, rank;
  enum {
    FIT_BY_SCENE,
    FIT_BY_PIECES,
    FIT_BY_MOMENTUM,
    FIT_BY_SOBOL,
    FIT_BY_NODES
  } way;           /* that led to the estimate */
  int tried, same; /* points of --starts, and how many led to the same minimum */
  double left;     /* the same of the step that stops at the wall */
  struct fit_wall wall;
  double decrement;  /* length in standard errors of the step that is left */
  double step_shift; /* by how many standard errors the integration's step moves the estimate */
  double gradient[FIT_MOST];       /* of half the loss */
  const struct fit_triangle *lost; /* what the decomposed triangle has too much, or NULL */
  double singular[FIT_MOST];       /* of R with columns scaled, descending */
  double scale[FIT_MOST], size[FIT_MOST];
  double vectors[FIT_MOST * FIT_MOST]; /* n x n: right singular vectors, scaled, columns */
  double covariance[FIT_MOST * FIT_MOST];
};

/* ---- inside.c ---- */

/* 1/t, where from + t step breaks a rule of the parameters (which one), 0: nowhere near. */
double fit_border(struct fit_problem *f, const double from[], const double step[], int *rule);
/* to = from + part step, a body if `from` is one; part is 1 for steps that are short against the
 * way to the border, and of initial states always. */
double fit_inside(struct fit_problem *f, const double from[], const double step[], double to[]);
/* The wall before `from + step`. */
void fit_wall(struct fit_problem *f, const double from[], const double step[], struct fit_wall *w);
/* to = from + step, which is along the wall, drawn towards what is behind until it is a body: the
 * wall may be bent. */
void fit_to_wall(struct fit_problem *f, const double from[], const double step[],
                 const struct fit_wall *w, double to[]);
/* The derivatives of that part by the parameters' steps. */
void fit_inside_slope(struct fit_problem *f, const double from[], const double step[],
                      double slope[]);

/* ---- descend.c ---- */

/* Half the loss's minimum is looked for: the sum of squares of the triangle's last column. */
double fit_loss(const struct fit_sums *s);
/* From theta to a local minimum, about; the iterations that it took, -1: the start is no body. */
int fit_descend(struct fit_problem *f, double theta[], struct fit_sums *s, size_t most);

/* ---- linear.c ---- */

/* theta with what the log's rates say of moments and initial rates; 0: nothing. */
int fit_linear(struct fit_problem *f, double theta[]);

/* ---- begin.c ---- */

/* A step that is good enough for the search: half of it changes chi-square by less than a
 * thousandth.  One that is too long may leave the range of numbers, too, or make minima that the
 * motion does not have. */
void fit_first_step(struct fit_problem *f, const double theta[], struct fit_sums *s);
/* Of a log's initial state the better of theta's and what its first rows say. */
void fit_better_start(struct fit_problem *f, int log, double theta[]);

/* ---- pieces.c ---- */

/* Replaces each of the logs by its pieces. */
void fit_pieces_cut(struct fit_problem *f);
/* The states with which the pieces begin, one after the other; iterations, -1: the start is no
 * body. */
int fit_pieces_approach(struct fit_problem *f, double theta[], struct fit_sums *s);

/* ---- start.c ---- */

/* From theta near the least minimum that is found; says in r how. */
void fit_approach(struct fit_problem *f, double theta[], int has_sigma, struct fit_sums *s,
                  struct fit_result *r);

/* ---- newton.c ---- */

/* The model of the loss in s, which is that of theta, in r: gradient, decomposition, covariance,
 * decrement, wall, left, loss, chi2, n. */
void fit_model(struct fit_problem *f, const double theta[], const struct fit_sums *s,
               struct fit_result *r);
/* Its step, damped by mu, to the wall at most; the length of the step; s is as it was. */
double fit_model_step(const struct fit_problem *f, const struct fit_result *r, double mu,
                      double step[]);

/* Singular values and vectors of a triangle's R, its columns brought to length 1, which no unit
 * changes. A column of rounding errors stays short: all of the unknown's own size moves the
 * residuals by nothing. */
void fit_decompose(const struct fit_problem *f, const struct fit_triangle *a, const double theta[],
                   struct fit_result *r);
/* out[n*n] = (R'R)^-1 on what the data determine. */
void fit_inverse(const struct fit_result *r, int n, double out[]);

/* ---- solve.c ---- */

/* From theta on; sums: room for the triangles. has_sigma: is chi-square meaningful? */
void fit_solve(struct fit_problem *f, const double start[], int has_sigma, struct fit_result *r,
               struct fit_sums *s);

/* ---- fit.c ---- */

/* Memory of 0 that Lua frees, whatever happens. */
void *fit_room(lua_State *L, size_t size);
/* The table of a shared object, or NULL with nil and a message on the stack. */
const struct polhode_fitted *fit_load(lua_State *L, const char *path, void **library);
/* The problem of argument 2; f->code is known. */
void fit_read(lua_State *L, struct fit_problem *f);
/* Where the search begins: the parameters' values, and of each log the scene's initial state. */
void fit_begin(lua_State *L, struct fit_problem *f, double theta[]);

/* fit(path, problem) -> {result} | nil, message;  tail(chi2, dof) -> probability of more */
int host_fit(lua_State *L);
int host_tail(lua_State *L);

/* ---- design.c ---- */

/* design(path, problem) -> list of what a log of each candidate would tell */
int host_design(lua_State *L);

#endif
