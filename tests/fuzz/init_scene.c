/* init_scene.c - one emitted scene (-DNAME=, -DUPPER=) under arbitrary bits.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Numbers come as a tag and bits: raw ones, what breaks formulas, or the scene's own value times a
 * power of two.  The law that is tested: a status is one that the header lists (-DSTATUSES=);
 * another than 0 leaves the object as it was; after 0 the object, the state after reset and the
 * state after one step of the scene's own length (-DSTEP=) are finite numbers.  Whatever else is
 * called with whatever bits may give what it likes, but must not break: the sanitizers look on.
 */
#include "init.h"

#include <float.h>
#include <math.h>
#include <stddef.h>

#define QUOTED(x)    #x
#define TEXT(x)      QUOTED(x)
#define JOINED(a, b) a##b
#define JOIN(a, b)   JOINED(a, b)
#define FN(x)        JOIN(NAME, x)
#define ENUM(x)      JOIN(UPPER, x)

#include HEADER

typedef FN(_real) real;

enum { STATES = ENUM(_NX), INPUTS = ENUM(_NU), PARAMETERS = ENUM(_NP) };

static void take(struct bytes *b, void *out, size_t n) {
  for (size_t i = 0; i < n; i++)
    ((uint8_t *)out)[i] = bytes_take(b);
}

static real number(struct bytes *b, real own) {
  static const real odd[] = {(real)NAN,
                             (real)INFINITY,
                             (real)-INFINITY,
                             0,
                             (real)-0.0,
                             1,
                             -1,
                             sizeof(real) == 4 ? (real)FLT_MAX : (real)DBL_MAX,
                             sizeof(real) == 4 ? (real)FLT_MIN : (real)DBL_MIN,
                             sizeof(real) == 4 ? (real)FLT_EPSILON : (real)DBL_EPSILON,
                             sizeof(real) == 4 ? (real)1e-44 : (real)5e-324,
                             sizeof(real) == 4 ? (real)1.8e19 : (real)1.3e154,
                             sizeof(real) == 4 ? (real)1e-19 : (real)1e-154,
                             sizeof(real) == 4 ? (real)1e12 : (real)1e100,
                             sizeof(real) == 4 ? (real)1e-12 : (real)1e-100,
                             (real)0x1p-30};
  const uint8_t tag = bytes_take(b), more = tag & 3 ? bytes_take(b) : 0;
  real x = own;
  switch (tag & 3) {
  case 0: /* the scene's own */
    break;
  case 1:
    take(b, &x, sizeof x);
    break;
  case 2:
    x = odd[more % 16] * (tag & 4 ? -1 : 1);
    break;
  default:
    x = (real)ldexp((double)own, (int)more - 128) * (tag & 4 ? -1 : 1);
    break;
  }
  return x;
}

static int finite(int n, const real x[]) {
  for (int i = 0; i < n; i++)
    if (!isfinite(x[i]))
      return 0;
  return 1;
}

static const real
    *seen; /* the state that NAME_solve was given, and a time, for a finding's message */
static real seen_t;

static void expect(int n, const real x[], const char *what, const real p[]) {
  if (finite(n, x))
    return;
  for (int i = 0; i < PARAMETERS; i++)
    fprintf(stderr, "p[%d] = %.17g\n", i, (double)p[i]);
  if (seen != NULL)
    fprintf(stderr, "t = %.17g\n", (double)seen_t);
  for (int i = 0; seen != NULL && i < STATES; i++)
    fprintf(stderr, "x0[%d] = %.17g\n", i, (double)seen[i]);
  for (int i = 0; i < n; i++)
    fprintf(stderr, "x[%d] = %.17g\n", i, (double)x[i]);
  fuzz_finding(TEXT(NAME) ": %s is not finite, the status was 0", what);
}

static int unchanged(const void *object, size_t n) {
  for (size_t i = 0; i < n; i++)
    if (((const uint8_t *)object)[i] != 0xa5)
      return 0;
  return 1;
}

/* The model holds reals, and behind them the integers of spin_stable. */
#ifdef HAS_ORDER
enum { REALS = offsetof(FN(_model), order) / sizeof(real) };
#else
enum { REALS = sizeof(FN(_model)) / sizeof(real) };
#endif

#ifdef HAS_SOLVE
static void orbit(struct bytes *b, const FN(_model) * m, const real p[], const real reset[]) {
  FN(_orbit) o;
  real x[STATES], t = number(b, (real)STEP);
  memset(&o, 0xa5, sizeof o);
  for (int i = 0; i < STATES; i++)
    x[i] = number(b, reset[i]);
  real x0[STATES];
  memcpy(x0, x, sizeof x);
  const int status = FN(_solve)(&o, m, x);
  if (status != 0 && status != 1)
    fuzz_finding(TEXT(NAME) "_solve: status %d", status);
  if (status != 0 && !unchanged(&o, sizeof o))
    fuzz_finding(TEXT(NAME) "_solve: status %d, but the orbit was written", status);
  if (status != 0)
    return;
  seen = x0;
  seen_t = t;
  FN(_at)(&o, 0, x);
  expect(STATES, x, "the state at 0", p);
  FN(_at)(&o, t, x); /* a motion without ticks need not stay within the range of the type */
#ifdef HAS_TICK
  /* beyond these times the exact product of rate and time overflows */
  if (fabs((double)t) < (sizeof(real) == 4 ? 1e30 : 1e290) && FN(_set_tick)(&o, t) == 0)
    expect(STATES, x, "the state at t", p);
  const real h = number(b, (real)STEP);
  int64_t n;
  take(b, &n, sizeof n);
  if (FN(_set_tick)(&o, h) == 0) {
    FN(_at_tick)(&o, n, x);
    seen_t = h;
    expect(STATES, x, "the state at a tick", p);
  }
#endif
#ifdef HAS_NUTATION
  real tilt[2];
  FN(_nutation_range)(&o, tilt);
  (void)FN(_nutation_period)(&o), (void)FN(_precession_rate)(&o);
  expect(2, tilt, "the range of the nutation", p);
#endif
  seen = NULL;
}
#endif

/* Whatever bits, of whatever function: no report of a sanitizer. */
static void anything(struct bytes *b, const FN(_model) * m, const real reset[]) {
  real x[STATES], dx[STATES], u[INPUTS + 1], J[STATES * STATES], t = number(b, 0);
  for (int i = 0; i < STATES; i++)
    x[i] = number(b, reset[i]);
  for (int i = 0; i < INPUTS; i++)
    u[i] = number(b, 1);
  FN(_rhs)(m, t, x, u, dx);
  FN(_jacobian)(m, t, x, u, J);
  FN(_step)(m, t, x, u, number(b, (real)STEP));
#ifdef HAS_ENERGY
  (void)FN(_energy)(m, x);
#endif
#ifdef HAS_PRINCIPAL
  real I[6], moments[3], axes[9];
  for (int i = 0; i < 6; i++)
    I[i] = number(b, (real)(i < 3 ? i + 1 : 0));
  const int status = FN(_principal_of)(I, moments, axes);
  if (status == 0 && !(finite(3, moments) && finite(9, axes)))
    fuzz_finding(TEXT(NAME) "_principal_of: not finite, the status was 0");
  if (status != 0 && status != 1)
    fuzz_finding(TEXT(NAME) "_principal_of: status %d", status);
  real w[3], Omega[2], rate;
  const int verdict = FN(_stability)(I, bytes_take(b) % 3, number(b, 1), Omega, &rate);
  if (verdict < -1 || verdict > 1)
    fuzz_finding(TEXT(NAME) "_stability: %d", verdict);
  FN(_linearised)(I, bytes_take(b) % 3, I + 3, t, w);
#endif
#ifdef HAS_STABLE
  const int stable = FN(_spin_stable)(m, bytes_take(b) % 3, bytes_take(b) % 2);
  if (stable < -1 || stable > 1)
    fuzz_finding(TEXT(NAME) "_spin_stable: %d", stable);
#endif
}

init_case JOIN(fuzz_case_, NAME);
void JOIN(fuzz_case_, NAME)(struct bytes *b) {
  FN(_model) m;
  real p[PARAMETERS + 1], x[STATES], u[INPUTS + 1] = {0};
  memset(&m, 0xa5, sizeof m);
  FN(_defaults)(p);
  for (int i = 0; i < PARAMETERS; i++)
    p[i] = number(b, p[i]);
  const int status = FN(_init)(&m, p);
  if (status < 0 || status > STATUSES)
    fuzz_finding(TEXT(NAME) "_init: status %d is not listed", status);
  if (status != 0 && !unchanged(&m, sizeof m))
    fuzz_finding(TEXT(NAME) "_init: status %d, but the model was written", status);
  if (status != 0)
    return;
  real reals[REALS + 1];
  memcpy(reals, &m, REALS * sizeof(real));
  if (fuzz_planted("nan"))
    reals[0] = (real)NAN;
  expect(REALS, reals, "the model", p);
  FN(_initial)(&m, x);
  expect(STATES, x, "the state after reset", p);
  real reset[STATES];
  memcpy(reset, x, sizeof x);
  FN(_step)(&m, 0, x, u, (real)STEP);
  expect(STATES, x, "the state after a step", p);
#ifdef HAS_SOLVE
  orbit(b, &m, p, reset);
#endif
  anything(b, &m, reset);
}
