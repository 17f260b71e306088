/* pass.c - one pass through the logs: the motion with its derivatives, and the residuals.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A residual is z = (measured - model)/sigma.  Of an attitude it is the rotation vector of
 * conj(q_model) q_measured in body axes, the shorter way round (q and -q are one attitude), by
 * atan2, which keeps all digits of a small turn; its derivative is that of the logarithm, not -1.
 */
#include "fit.h"
#include "host/host.h"

#include <math.h>
#include <string.h>

enum { STATES = 64, RING = 32 }; /* RING: a power of 2, more than FIT_LAGS */

/* What a pass has at hand for one log. */
struct track {
  struct fit_problem *f;
  const struct fit_log *log;
  int number, lanes, plain; /* plain: as residuals_plain has it */
  double t, x[STATES];
  double u[1 + 2 * COURSE_INPUTS], segment; /* the inputs, and the time until which u holds */
  double squares[2][FIT_MOST];              /* of derivatives at the log's two ends */
  long ends[2];
  double *s;     /* states x lanes */
  double *y, *J; /* measured, and derivatives: values x lanes */
  double row[FIT_MOST + 1];
};

/* Residuals of the last rows, for the test of whiteness. */
struct memory {
  double t[RING], z[RING][FIT_CHANNELS * 3];
  int next;
};

int fit_residuals(const struct fit_problem *f) {
  int n = 0;
  for (int c = 0; c < f->channels; c++)
    n += f->channel[c].attitude ? 3 : 1;
  return n;
}

/* The log's own initial state in place of the scene's. */
static void own_start(struct track *c, const double theta[]) {
  struct fit_problem *f = c->f;
  const double *own = theta + f->free + c->number * f->own;
  int at = 0;
  memset(c->s, 0, (size_t)(f->code->states * c->lanes) * sizeof *c->s);
  for (int i = 0; i < f->code->states; i++) {
    if (i == f->code->attitude) {
      double dq[3][4];
      fit_turned(f->reference + 4 * c->number, own + at, c->x + i, dq);
      for (int k = 0; k < 3; k++)
        for (int j = 0; j < 4; j++)
          c->s[(i + j) * c->lanes + f->free + at + k] = dq[k][j];
      at += 3;
      i += 3;
    } else {
      c->x[i] = own[at];
      c->s[i * c->lanes + f->free + at] = 1;
      at++;
    }
  }
}

/* On to time t in equal steps no longer than h; a step ends at every knot, and with u. */
static void go(struct track *c, double t, int *knot) {
  const struct fit_problem *f = c->f;
  while (c->t < t) {
    while (*knot < f->knot_count && f->knots[*knot] <= c->t)
      ++*knot;
    double to = *knot < f->knot_count && f->knots[*knot] < t ? f->knots[*knot] : t;
    if (c->segment <= c->t)
      c->segment = fit_inputs_at(f, c->number, c->t, c->u);
    to = fmin(to, c->segment);
    const double part = (to - c->t) / f->h * (1 - 1e-9), n = part <= 1 ? 1 : ceil(part);
    f->code->advance(f->model, f->k0, c->t, c->x, c->s, c->u, (to - c->t) / n, (long)n);
    c->t = to;
  }
}

/* The three residuals of an attitude and their rows, [3][FIT_MOST] by the log's own directions. */
static void attitude(const struct track *c, const double logged[4], const double sigma[3],
                     double z[3], double J[][FIT_MOST], int directions) {
  const double *q = c->x + c->f->code->attitude;
  const double back[4] = {q[0], -q[1], -q[2], -q[3]};
  double e[4], r[3], factor, slope[2];
  fit_product(back, logged, e);
  const double sign = e[0] < 0 ? -1 : 1;
  for (int i = 0; i < 4; i++)
    e[i] *= sign;
  fit_logarithm(e, r, &factor, slope);
  for (int i = 0; i < 3; i++)
    z[i] = r[i] / sigma[i];
  for (int k = 0; k < directions; k++) {
    const double *s = c->s + c->f->code->attitude * c->lanes + k;
    const double d[4] = {s[0], -s[c->lanes], -s[2 * c->lanes], -s[3 * c->lanes]};
    double de[4];
    fit_product(d, logged, de);
    const double vdv = sign * (e[1] * de[1] + e[2] * de[2] + e[3] * de[3]);
    const double da = slope[0] * vdv + slope[1] * sign * de[0];
    for (int i = 0; i < 3; i++)
      J[i][k] = (da * e[i + 1] + factor * sign * de[i + 1]) / sigma[i];
  }
}

/* A loss at z: the root of 2 rho, whose square the triangle sums; psi = rho' and rho''. */
struct loss {
  double root, psi, curve;
};

static struct loss loss_at(const struct fit_problem *f, double z) {
  const double k = f->corner, size = fabs(z);
  if (f->loss == FIT_HUBER && size > k) /* z^2/2, from k on k |z| - k^2/2 */
    return (struct loss){copysign(sqrt(k * (2 * size - k)), z), copysign(k, z), 0};
  if (f->loss == FIT_CAUCHY) { /* (k^2/2) log(1 + (z/k)^2) */
    const double u = z / k, w = 1 + u * u;
    return (struct loss){copysign(k * sqrt(log1p(u * u)), z), z / w, (1 - u * u) / (w * w)};
  }
  return (struct loss){z, z, 1};
}

/* The track's row times factor, and `last` for its residual. */
static void scaled(const struct track *c, double factor, double last, struct fit_triangle *to) {
  double row[FIT_MOST + 1];
  const int n = c->f->n;
  for (int i = 0; i < n; i++)
    row[i] = factor * c->row[i];
  row[n] = last;
  triangle_row(to, row);
}

/* A residual and its row into the sums.  `whole` takes (J psi/root, root): what it is asked for is
 * then J' psi and the sum of 2 rho. */
static void put(struct track *c, struct fit_sums *s, double z, const double J[], int directions) {
  const struct fit_problem *f = c->f;
  s->chi2 += z * z;
  s->n++;
  if (s->whole == NULL)
    return; /* chi-square alone */
  const struct loss l = loss_at(f, z);
  for (int i = 0; i < f->free; i++)
    c->row[i] = J[i];
  for (int i = f->free; i < directions; i++) /* what other logs own is 0 */
    c->row[i + c->number * f->own] = J[i];
  if (s->inner != NULL && l.curve > 0)
    scaled(c, sqrt(l.curve), 0, s->inner);
  if (s->lost != NULL && l.curve < 0)
    scaled(c, sqrt(-l.curve), 0, s->lost);
  if (s->outer != NULL)
    scaled(c, l.psi, 0, s->outer);
  if (l.psi == l.root) { /* as it stands */
    c->row[f->n] = z;
    triangle_row(s->whole, c->row);
  } else {
    scaled(c, l.psi / l.root, l.root, s->whole);
  }
}

/* Measured less model of what is no attitude, in *d; 0: it is beyond a limit of the sensor, as the
 * model says, too. */
static int difference(const struct fit_channel *o, double logged, double model, double *d) {
  *d = logged - model;
  if (o->wrapped)
    *d = remainder(*d, 2 * M_PI);
  return !((logged == o->high && model > logged) || (logged == o->low && model < logged));
}

/* The residuals of row i where only the triangle of the squares is asked for, and no attitude is
 * measured: straight into its block.  1: one is not finite. */
static int residuals_plain(struct track *c, size_t i, struct fit_sums *s) {
  const struct fit_problem *f = c->f;
  const double *data = c->log->y + i * (size_t)c->log->columns;
  int known = 0;
  for (int n = 0; n < f->channels; n++) {
    const struct fit_channel *o = &f->channel[c->number * f->channels + n];
    const double logged = data[o->column];
    if (logged != logged)
      continue;
    if (!known)
      f->code->measure(f->p, c->t, c->x, c->s, c->y, c->J);
    known = 1;
    double part = -1 / o->sigma[0], z;
    if (!difference(o, logged, c->y[o->value], &z))
      continue;
    z *= -part;
    const double *own = c->J + o->value * c->lanes;
    double *to = triangle_place(s->whole);
    if (!isfinite(z))
      return 1;
    for (int k = 0; k < f->free; k++)
      to[k * FIT_BLOCK] = part * own[k];
    for (int k = f->free; k < f->n && f->logs > 1; k++) /* other logs' */
      to[k * FIT_BLOCK] = 0;
    double *mine = to + (f->free + c->number * f->own) * FIT_BLOCK;
    for (int k = 0; k < f->own; k++)
      mine[k * FIT_BLOCK] = part * own[f->free + k];
    to[f->n * FIT_BLOCK] = z;
    triangle_next(s->whole);
    s->chi2 += z * z;
    s->n++;
  }
  return 0;
}

/* Keeps the largest of those beyond the limit. */
static void far_off(struct fit_outliers *a, struct fit_outlier now) {
  a->count++;
  int i = a->kept < FIT_OUTLIERS ? a->kept++ : FIT_OUTLIERS;
  for (; i > 0 && fabs(a->worst[i - 1].z) < fabs(now.z); i--)
    if (i < FIT_OUTLIERS)
      a->worst[i] = a->worst[i - 1];
  if (i < FIT_OUTLIERS)
    a->worst[i] = now;
}

/* The residuals z of a row (NaN: missing), n of them, into the counts; they are remembered. */
static void count(struct fit_count a[], struct memory *m, int n, double t, const double z[],
                  double spacing) {
  for (int c = 0; c < n; c++) {
    if (z[c] != z[c])
      continue;
    a[c].n++;
    a[c].chi2 += z[c] * z[c];
    if (fabs(z[c]) > a[c].worst) {
      a[c].worst = fabs(z[c]);
      a[c].worst_t = t;
    }
  }
  for (int k = 1; k <= FIT_LAGS; k++) {
    const int i = (m->next - k) & (RING - 1);
    if (!(fabs(t - m->t[i] - k * spacing) < 1e-3 * spacing))
      continue;
    for (int c = 0; c < n; c++) {
      const double pair = z[c] * m->z[i][c];
      a[c].sum[k - 1] += pair == pair ? pair : 0;
      a[c].pairs[k - 1] += pair == pair;
    }
  }
  m->t[m->next] = t;
  memcpy(m->z[m->next], z, (size_t)n * sizeof z[0]);
  m->next = (m->next + 1) & (RING - 1);
}

/* The derivative of a residual by the log's own directions. */
static void slope(const struct track *c, const struct fit_channel *o, double J[]) {
  const struct fit_problem *f = c->f;
  const int directions = f->free + f->own;
  const double *own = c->J + o->value * c->lanes, part = -1 / o->sigma[0];
  for (int k = 0; k < directions; k++)
    J[k] = part * own[k];
}

/* Squares of a residual's derivatives in the first and the last tenth of the log. */
static void grown(struct track *c, size_t row, const double J[], int directions) {
  const struct fit_log *l = c->log;
  const double span = l->t[l->rows - 1] - l->t[0], at = (l->t[row] - l->t[0]) / span;
  const int end = at > 0.9;
  if (at > 0.1 && !end)
    return;
  c->ends[end]++;
  for (int k = 0; k < directions; k++)
    c->squares[end][k] += J[k] * J[k];
}

/* How much larger the derivative that grows most is at the log's end. */
static double growth(const struct track *c, int directions) {
  double most = 0;
  for (int k = 0; k < directions && c->ends[0] > 0 && c->ends[1] > 0; k++) {
    const double first = c->squares[0][k] / (double)c->ends[0],
                 last = c->squares[1][k] / (double)c->ends[1];
    if (first > 0)
      most = fmax(most, sqrt(last / first));
  }
  return most;
}

/* Into a trace, of at most FIT_DRAWN rows that are spread evenly. */
static void drawn(const struct track *c, size_t row, const struct fit_channel *o, double z,
                  struct fit_trace *a) {
  if (row % (c->log->rows / FIT_DRAWN + 1) != 0 || a->n == FIT_DRAWN)
    return;
  a->t[a->n] = c->t;
  a->z[a->n] = z;
  a->y[a->n] = a->model[a->n] = (double)NAN;
  if (!o->attitude) {
    a->model[a->n] = c->y[o->value];
    a->y[a->n] = c->y[o->value] + z * o->sigma[0]; /* with the model's turns */
  }
  a->n++;
}

/* The residuals of row i; 1: one is not finite. */
static int residuals(struct track *c, size_t i, struct fit_sums *s, struct memory *m) {
  const struct fit_problem *f = c->f;
  const int directions = f->free + f->own;
  const double *data = c->log->y + i * (size_t)c->log->columns;
  double z[3], J[3][FIT_MOST], now[FIT_CHANNELS * 3];
  int at = 0, known = 0;
  for (int n = 0; n < f->channels; n++) {
    const struct fit_channel *o = &f->channel[c->number * f->channels + n];
    const int size = o->attitude ? 3 : 1;
    int there = 1;
    for (int k = 0; k < (o->attitude ? 4 : 1); k++)
      there = there && data[o->column + k] == data[o->column + k];
    for (int k = 0; k < size; k++)
      now[at + k] = (double)NAN;
    if (there && o->attitude) {
      attitude(c, data + o->column, o->sigma, z, J, directions);
    } else if (there) {
      if (!known)
        f->code->measure(f->p, c->t, c->x, c->s, c->y, c->J);
      known = 1;
      there = difference(o, data[o->column], c->y[o->value], z);
      z[0] /= o->sigma[0];
      if (s->whole != NULL) /* else chi-square alone is asked for */
        slope(c, o, J[0]);
    }
    for (int k = 0; there && k < size; k++) {
      if (!isfinite(z[k]))
        return 1;
      if (s->growth != NULL)
        grown(c, i, J[k], directions);
      if (s->traces != NULL)
        drawn(c, i, o, z[k], &s->traces[c->number * fit_residuals(f) + at + k]);
      now[at + k] = z[k];
      put(c, s, z[k], J[k], directions);
    }
    at += size;
  }
  if (s->counts != NULL) {
    for (int k = 0; s->outliers != NULL && k < at; k++)
      if (fabs(now[k]) > s->outliers->limit)
        far_off(s->outliers, (struct fit_outlier){c->number, k, i, now[k]});
    count(s->counts + c->number * at, m, at, c->t, now, c->log->spacing);
  }
  return 0;
}

/* The motion at t = 0. */
static void begin(struct track *c, const double theta[]) {
  const struct fit_problem *f = c->f;
  f->code->start(f->model, c->x, c->s, f->k0);
  if (f->own > 0)
    own_start(c, theta);
  for (int i = 0; f->fixed != NULL && i < f->code->states; i++)
    if (f->fixed[i] == f->fixed[i]) {
      c->x[i] = f->fixed[i];
      for (int k = 0; k < f->free; k++)
        c->s[i * c->lanes + k] = 0;
    }
  c->t = c->log->begin;
  c->segment = fit_inputs_at(f, c->number, c->t, c->u);
}

/* 1: a residual is not finite, or a signal came. */
static int one_log(struct track *c, const double theta[], struct fit_sums *s) {
  struct fit_problem *f = c->f;
  struct memory m = {.next = 0};
  int knot = 0;
  for (int i = 0; i < RING; i++)
    m.t[i] = (double)NAN;
  begin(c, theta);
  memset(c->row, 0, (size_t)(f->n + 1) * sizeof c->row[0]);
  c->plain = f->loss == FIT_SQUARES && s->whole != NULL && s->inner == NULL && s->lost == NULL &&
             s->outer == NULL && s->counts == NULL;
  for (int i = 0; i < f->channels; i++)
    c->plain = c->plain && !f->channel[c->number * f->channels + i].attitude;
  memset(c->squares, 0, sizeof c->squares);
  c->ends[0] = c->ends[1] = 0;
  for (size_t i = 0; i < c->log->rows && c->log->t[i] <= f->until; i++) {
    go(c, c->log->t[i], &knot);
    if ((c->plain ? residuals_plain(c, i, s) : residuals(c, i, s, &m)) ||
        (i % 4096 == 0 && interrupt_pending()))
      return 1;
  }
  if (s->growth != NULL)
    s->growth[c->number] = growth(c, f->free + f->own);
  return 0;
}

static struct track track; /* one fit at a time: large for a stack */

/* The parameters and the room of a track; 1: they are no body. */
static int open(struct track *c, struct fit_problem *f, const double theta[]) {
  static double room[STATES * FIT_MOST + FIT_CHANNELS * (1 + FIT_MOST)];
  for (int i = 0; i < f->free; i++)
    f->p[f->free_index[i]] = theta[i];
  f->refused = f->code->init(f->model, f->p);
  c->f = f;
  c->lanes = f->code->lanes;
  c->s = room;
  c->y = room + STATES * FIT_MOST;
  c->J = c->y + FIT_CHANNELS;
  return f->refused != 0;
}

int fit_state(struct fit_problem *f, const double theta[], int log, double t, double x[]) {
  struct track *c = &track;
  int knot = 0, bad = 0;
  if (open(c, f, theta))
    return 1;
  c->number = log;
  c->log = &f->log[log];
  begin(c, theta);
  go(c, t, &knot);
  for (int i = 0; i < f->code->states; i++) {
    x[i] = c->x[i];
    bad = bad || !isfinite(x[i]);
  }
  return bad;
}

int fit_simulate(struct fit_problem *f, const double theta[], int log) {
  struct track *c = &track;
  int knot = 0;
  if (open(c, f, theta))
    return 1;
  c->number = log;
  c->log = &f->log[log];
  begin(c, theta);
  for (size_t i = 0; i < c->log->rows; i++) {
    double *y = c->log->y + i * (size_t)c->log->columns;
    go(c, c->log->t[i], &knot);
    f->code->measure(f->p, c->t, c->x, c->s, c->y, c->J);
    for (int n = 0; n < f->channels; n++) {
      const struct fit_channel *o = &f->channel[log * f->channels + n];
      const double *from = o->attitude ? c->x + f->code->attitude : c->y + o->value;
      for (int k = 0; k < (o->attitude ? 4 : 1); k++) {
        if (!isfinite(from[k]))
          return 1;
        y[o->column + k] = from[k];
      }
    }
    if (i % 4096 == 0 && interrupt_pending())
      return 1;
  }
  return 0;
}

int fit_again(struct fit_problem *f, const double theta[], struct fit_sums *s) {
  const int same = s->of.there && s->of.active == f->active && s->of.loss == (int)f->loss &&
                   s->of.referred == f->referred && s->of.h == f->h && s->of.until == f->until &&
                   s->of.filled[0] == s->inner && s->of.filled[1] == s->lost &&
                   s->of.filled[2] == s->outer;
  if (!same || memcmp(s->of.theta, theta, (size_t)f->n * sizeof theta[0]) != 0)
    return fit_pass(f, theta, s);
  return 0;
}

int fit_pass(struct fit_problem *f, const double theta[], struct fit_sums *s) {
  struct track *c = &track;
  struct fit_triangle *all[] = {s->whole, s->inner, s->lost, s->outer};
  for (int i = 0; i < 4; i++)
    if (all[i] != NULL)
      triangle_open(all[i], f->n);
  if (s->counts != NULL)
    memset(s->counts, 0, (size_t)(f->logs * fit_residuals(f)) * sizeof *s->counts);
  for (int i = 0; s->traces != NULL && i < f->logs * fit_residuals(f); i++)
    s->traces[i].n = 0;
  if (s->outliers != NULL)
    s->outliers->count = s->outliers->kept = 0;
  s->chi2 = 0;
  s->n = 0;
  s->of.there = 0;
  f->passes++;
  if (open(c, f, theta)) {
    f->refusals++;
    return 1;
  }
  for (int i = 0; i < f->active; i++) {
    c->number = i;
    c->log = &f->log[i];
    if (one_log(c, theta, s))
      return 1;
  }
  for (int i = 0; i < 4; i++)
    if (all[i] != NULL)
      triangle_close(all[i]);
  s->of.there = s->whole != NULL;
  s->of.active = f->active;
  s->of.loss = (int)f->loss;
  s->of.referred = f->referred;
  s->of.h = f->h;
  s->of.until = f->until;
  memcpy(s->of.filled, all + 1, sizeof s->of.filled);
  memcpy(s->of.theta, theta, (size_t)f->n * sizeof theta[0]);
  return 0;
}
