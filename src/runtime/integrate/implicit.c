/* implicit.c - one step by Radau's collocation (IIA), of many stages, in long double.
   SPDX-License-Identifier: GPL-3.0-or-later

   For stiff equations: what decays fast is damped at any step. The polynomial u of degree s through
   x satisfies u' = f(t, u) at the s nodes c_i h of Radau's quadrature, the last of which is the end
   of the step (Hairer, Wanner, Solving ODEs II, IV.5): order 2 s - 1, L-stable, and no less than s
   + 1 where friction is strong, on whatever curved set it holds the motion. Z_i = h sum_j A_ij f(t
   + c_j h, x + Z_j),   A_ij = int_0^c_i l_j is solved by Newton's method with Jacobians of
   differences: that at x, and those at the stages where that one is too far from them. Its matrix
   is in double, for its errors only slow the iteration, whose residual is in long double. The last
   Z is the increment, so that strong friction, whose f is a difference that has lost its digits,
   costs none. The step is measured by the defect at its start, u'(0) - f(x) = O(h^s), which (1 -
   c_1 h J)^-2 rids of what decays. Nodes, weights and matrix come from Legendre's polynomials when
   a run begins. */
#include <stdlib.h>

#include "acts/acts.h"
#include "implicit.h"

enum { NEWTON = 24 };

/* P_n(z) and P_(n-1)(z). */
static ph_wide legendre(int n, ph_wide z, ph_wide *before) {
  ph_wide p = 1, q = 0;
  for (int k = 1; k <= n; k++) {
    const ph_wide next = ((2 * k - 1) * z * p - (k - 1) * q) / k;
    q = p;
    p = next;
  }
  *before = q;
  return p;
}

/* l_j at z, of the polynomials that are 1 at one node and 0 at the others. */
static ph_wide lagrange(const implicit *m, int j, ph_wide z) {
  ph_wide p = 1;
  for (int k = 0; k < m->stages; k++)
    if (k != j)
      p *= (z - m->c[k]) / (m->c[j] - m->c[k]);
  return p;
}

/* The zeros of P_s - P_(s-1) by Newton's method; the weights by the usual formula. */
static void tableau(implicit *m, int stages) {
  const int s = m->stages = stages;
  const ph_wide pi = 3.14159265358979323846264338327950288L;
  ph_wide weight[IMPLICIT_MOST];
  for (int i = 0; i < s; i++) {
    ph_wide z = cosl(2 * pi * (s - 1 - i) / (2 * s - 1)), q;
    for (int k = 0; k < 20 && i < s - 1; k++) {
      const ph_wide p = legendre(s, z, &q);
      ph_wide r;
      const ph_wide two = legendre(s - 1, z, &r); /* = q, and P_(s-2) */
      const ph_wide dp = s * (z * p - q) / (z * z - 1);
      const ph_wide dq = (s - 1) * (z * two - r) / (z * z - 1);
      z -= (p - q) / (dp - dq);
    }
    legendre(s, z, &q);
    m->c[i] = (1 + z) / 2;
    weight[i] = (1 + z) / (2 * (ph_wide)(s * s) * q * q);
  }
  for (int i = 0; i < s; i++)
    for (int j = 0; j < s; j++) {
      ph_wide sum = 0;
      for (int k = 0; k < s; k++)
        sum += weight[k] * lagrange(m, j, m->c[i] * m->c[k]);
      m->A[i][j] = m->c[i] * sum;
    }
  for (int i = 0; i < s; i++) /* u'(0) h = sum of slope Z, for Z is 0 at 0 and at the node c_i 1 */
    m->slope[i] = lagrange(m, i, 0) / m->c[i];
}

int implicit_new(implicit **out, int states, double tolerance) {
  int stages = (int)ceill(-log10l((ph_wide)tolerance) / 2);
  stages = stages < 3 ? 3 : stages > IMPLICIT_MOST ? IMPLICIT_MOST : stages;
  const size_t n = (size_t)states, rows = n * (size_t)stages;
  implicit *m = malloc(sizeof *m + (rows * rows + n * n + n * rows) * sizeof(double));
  if (!m)
    return PH_EMEMORY;
  tableau(m, stages);
  m->J = (double *)(m + 1);
  m->small = m->J + n * rows;
  m->large = m->small + n * n;
  *out = m;
  return PH_OK;
}

/* ---- linear equations ---- */

/* A = P L U in its place, n rows; 0 if singular. */
static int split(int n, double A[], int pivot[]) {
  for (int k = 0; k < n; k++) {
    int p = k;
    for (int i = k + 1; i < n; i++)
      if (fabs(A[i * n + k]) > fabs(A[p * n + k]))
        p = i;
    pivot[k] = p;
    if (!(fabs(A[p * n + k]) > 0))
      return 0;
    for (int j = 0; j < n && p != k; j++) {
      const double swap = A[k * n + j];
      A[k * n + j] = A[p * n + j];
      A[p * n + j] = swap;
    }
    for (int i = k + 1; i < n; i++) {
      const double f = A[i * n + k] /= A[k * n + k];
      for (int j = k + 1; j < n && f != 0; j++)
        A[i * n + j] -= f * A[k * n + j];
    }
  }
  return 1;
}

static void solve(int n, const double A[], const int pivot[], double b[]) {
  for (int k = 0; k < n; k++) {
    const double swap = b[k];
    b[k] = b[pivot[k]];
    b[pivot[k]] = swap;
  }
  for (int i = 0; i < n; i++)
    for (int j = 0; j < i; j++)
      b[i] -= A[i * n + j] * b[j];
  for (int i = n - 1; i >= 0; i--) {
    for (int j = i + 1; j < n; j++)
      b[i] -= A[i * n + j] * b[j];
    b[i] /= A[i * n + i];
  }
}

/* ---- the Jacobian ---- */

static int rates(stepper *s, ph_wide t, const ph_wide x[], ph_wide f[]) {
  s->evaluations++;
  return motion_rates(s->top, &s->loads, t, x, f);
}

/* J of the states in parts of their sizes, by differences of 2^-40 of the size: half of the digits
   are the rounding's, and friction is smooth over less than that. */
static int jacobian(stepper *s, ph_wide t, const ph_wide x[], const ph_wide f[],
                    const ph_wide size[], double J[]) {
  const int n = ph_top_states(s->top);
  ph_wide y[PH_STATES], g[PH_STATES];
  for (int k = 0; k < n; k++) {
    for (int i = 0; i < n; i++)
      y[i] = i == k ? x[i] + size[i] * 0x1p-40L : x[i];
    const ph_wide d = y[k] - x[k];
    const int status = rates(s, t, y, g);
    if (status)
      return status;
    for (int i = 0; i < n; i++)
      J[i * n + k] = d != 0 ? (double)((g[i] - f[i]) / d * (size[k] / size[i])) : 0;
  }
  return PH_OK;
}

/* The sizes of the states for a step from x; 1 for what has none. */
static void sizes(const stepper *s, const step_scale *scale, const ph_wide x[], const ph_wide f[],
                  ph_wide h, ph_wide size[]) {
  ph_wide d[PH_STATES];
  for (int i = 0; i < ph_top_states(s->top); i++)
    d[i] = h * f[i];
  for (int i = 0, width; i < ph_top_states(s->top); i += width) {
    const ph_wide all = step_scale_of(s->top, scale, x, d, h, i, &width);
    for (int k = i; k < i + width; k++)
      size[k] = all > 0 ? all : 1;
  }
}

/* The mean growth of a vector under J - r 1 (Gelfand). */
static ph_wide radius(int n, const double J[], ph_wide r) {
  enum { POWERS = 40 };
  ph_wide v[PH_STATES], sum = 0;
  for (int i = 0; i < n; i++)
    v[i] = 1 + 0.37L * ((i * 7) % 5);
  for (int p = 0; p < POWERS; p++) {
    ph_wide w[PH_STATES], length = 0;
    for (int i = 0; i < n; i++) {
      w[i] = -r * v[i];
      for (int k = 0; k < n; k++)
        w[i] += (ph_wide)J[i * n + k] * v[k];
      length = fmaxl(length, fabsl(w[i]));
    }
    if (!(length > 0) || !isfinite(length))
      return 0;
    for (int i = 0; i < n; i++)
      v[i] = w[i] / length;
    sum += p < POWERS / 2 ? 0 : logl(length) / (POWERS - POWERS / 2);
  }
  return expl(sum);
}

/* At the start of a step: the scale of the motion and its rates. */
static int start(stepper *s, const ph_wide x[], step_scale *scale, ph_wide f[]) {
  const int status = step_scale_at(s, x, scale);
  return status ? status : rates(s, s->t, x, f);
}

int step_decay(stepper *s, const ph_wide x[], ph_wide h, ph_wide *rate) {
  const int n = ph_top_states(s->top);
  ph_wide f[PH_STATES], size[PH_STATES];
  double J[PH_STATES * PH_STATES];
  step_scale scale;
  int status = start(s, x, &scale, f);
  if (status)
    return status;
  sizes(s, &scale, x, f, h, size);
  status = jacobian(s, s->t, x, f, size, J);
  if (status)
    return status;
  const ph_wide r = radius(n, J, 0), apart = radius(n, J, r);
  /* J - r has the radius 2 r where the fastest decays, and 1.4 r at most where it oscillates */
  *rate = h > 0 && apart > 1.8L * r ? r : 0;
  return PH_OK;
}

/* ---- the step ---- */

/* What a step knows of itself. */
typedef struct attempt {
  stepper *s;
  implicit *m;
  const ph_wide *x, *f, *size;
  const step_scale *scale;
  ph_wide h;
  ph_wide Z[IMPLICIT_MOST][PH_STATES];
  int pivot[IMPLICIT_MOST * PH_STATES];
} attempt;

/* The matrix of Newton's equations in parts of the sizes: with the Jacobian at the start, or with
   each stage's own. */
static int prepare(attempt *a, int own) {
  implicit *m = a->m;
  const int n = ph_top_states(a->s->top), rows = n * m->stages;
  for (int j = 0; j < m->stages && own; j++) {
    ph_wide y[PH_STATES], f[PH_STATES];
    for (int i = 0; i < n; i++)
      y[i] = a->x[i] + a->Z[j][i];
    const ph_wide t = a->s->t + m->c[j] * a->h;
    int status = rates(a->s, t, y, f);
    if (!status)
      status = jacobian(a->s, t, y, f, a->size, m->J + j * n * n);
    if (status)
      return status;
  }
  for (int i = 0; i < m->stages; i++)
    for (int j = 0; j < m->stages; j++) {
      const double *J = m->J + (own ? j * n * n : 0), hA = (double)(a->h * m->A[i][j]);
      for (int k = 0; k < n; k++)
        for (int l = 0; l < n; l++)
          m->large[(i * n + k) * rows + j * n + l] = (i == j && k == l) - hA * J[k * n + l];
    }
  return split(rows, m->large, a->pivot) ? PH_OK : PH_ERANGE;
}

/* One iteration: Z is changed, by *change of the sizes. */
static int newton(attempt *a, ph_wide *change) {
  const implicit *m = a->m;
  const int n = ph_top_states(a->s->top);
  ph_wide f[IMPLICIT_MOST][PH_STATES], y[PH_STATES], d[PH_STATES];
  double b[IMPLICIT_MOST * PH_STATES] = {0};
  for (int j = 0; j < m->stages; j++) {
    for (int i = 0; i < n; i++)
      y[i] = a->x[i] + a->Z[j][i];
    const int status = rates(a->s, a->s->t + m->c[j] * a->h, y, f[j]);
    if (status)
      return status;
  }
  for (int i = 0; i < m->stages; i++)
    for (int k = 0; k < n; k++) {
      ph_wide sum = 0;
      for (int j = 0; j < m->stages; j++)
        sum += m->A[i][j] * f[j][k];
      b[i * n + k] = (double)((a->h * sum - a->Z[i][k]) / a->size[k]);
    }
  solve(n * m->stages, m->large, a->pivot, b);
  *change = 0;
  for (int i = 0; i < m->stages; i++) {
    for (int k = 0; k < n; k++) {
      d[k] = (ph_wide)b[i * n + k] * a->size[k];
      a->Z[i][k] += d[k];
    }
    *change = fmaxl(*change, step_relative(a->s->top, a->scale, a->x, a->Z[i], a->h, d));
  }
  return isfinite(*change) ? PH_OK : PH_ERANGE;
}

/* Z, to `enough` or to where rounding ends it; PH_ERANGE: the step is too long. */
static int converge(attempt *a, ph_wide enough) {
  const ph_wide noise = 64 * enough, slow = 0.01L, far = 1e-3L;
  ph_wide before = HUGE_VALL, change = 0;
  for (int i = 0; i < a->m->stages; i++)
    for (int k = 0; k < ph_top_states(a->s->top); k++)
      a->Z[i][k] = 0;
  int status = prepare(a, 0), fresh = 0;
  for (int i = 0; i < NEWTON && !status; i++) {
    status = newton(a, &change);
    if (status)
      break;
    if (change <= enough / 4 || (change <= noise && change > before / 4))
      return PH_OK;
    if (i > 2 && fresh > 1 && change > before)
      return PH_ERANGE;
    fresh++;
    if (i == 0 ? change > far : change > slow * before && fresh > 1) {
      status = prepare(a, 1);
      fresh = 0;
    }
    before = change;
  }
  /* a step that is too long may leave what the equations admit */
  return status && status != PH_EROD ? status : PH_ERANGE;
}

/* The defect at the start without what decays fast, as an error of the sizes. */
static int measured(attempt *a, ph_wide *error) {
  const implicit *m = a->m;
  const int n = ph_top_states(a->s->top);
  ph_wide e[PH_STATES];
  double b[PH_STATES];
  int pivot[PH_STATES];
  for (int i = 0; i < n * n; i++)
    m->small[i] = (i % n == i / n) - (double)(a->h * m->c[0]) * m->J[i];
  if (!split(n, m->small, pivot))
    return PH_ERANGE;
  for (int k = 0; k < n; k++) {
    ph_wide slope = 0;
    for (int i = 0; i < m->stages; i++)
      slope += m->slope[i] * a->Z[i][k];
    b[k] = (double)(m->c[0] * (a->h * a->f[k] - slope) / a->size[k]);
  }
  solve(n, m->small, pivot, b);
  solve(n, m->small, pivot, b);
  for (int k = 0; k < n; k++)
    e[k] = (ph_wide)b[k] * a->size[k];
  *error = step_relative(a->s->top, a->scale, a->x, a->Z[m->stages - 1], a->h, e);
  return isfinite(*error) ? PH_OK : PH_ERANGE;
}

int step_implicit(stepper *s, implicit *m, const ph_wide x[], ph_wide tolerance, ph_wide *h,
                  ph_wide *next, ph_wide out[]) {
  const int n = ph_top_states(s->top);
  const ph_wide enough = fmaxl(tolerance, 32 * LDBL_EPSILON);
  ph_wide f[PH_STATES], size[PH_STATES];
  step_scale scale;
  int status = start(s, x, &scale, f);
  if (status)
    return status;
  attempt a = {.s = s, .m = m, .x = x, .f = f, .size = size, .scale = &scale};
  for (;;) {
    ph_wide error = 0;
    a.h = *h;
    sizes(s, &scale, x, f, *h, size);
    status = jacobian(s, s->t, x, f, size, m->J);
    if (!status)
      status = converge(&a, enough);
    if (!status)
      status = measured(&a, &error);
    if (status && status != PH_ERANGE)
      return status;
    const ph_wide factor = status      ? 0.25L
                           : error > 0 ? 0.9L * powl(error / enough, -1.0L / (m->stages + 1))
                                       : 5;
    if (!status && (error <= enough || tolerance == 0)) {
      for (int i = 0; i < n; i++)
        out[i] = x[i] + a.Z[m->stages - 1][i];
      *next = fabsl(*h) * fminl(5, factor);
      return wide_fits(n, out) ? PH_OK : PH_ERANGE;
    }
    if (tolerance == 0 || s->t + *h == s->t)
      return PH_ESTEP;
    *h *= fmaxl(0.1L, fminl(0.8L, factor));
  }
}
