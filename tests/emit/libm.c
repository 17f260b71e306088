/* libm.c - the emitted code's own mathematical functions against MPFR and the C library: prints
   TAP; see libm.t. SPDX-License-Identifier: GPL-3.0-or-later

   OWN is the emitted text of all functions for the real type own_real, SINGLE says that this is
   float.  With an argument it only prints a hash of the bits of many results.

   An error is |got - f(x)| in units of the last place of f(x), in the subnormal range of the
   smallest number.  1.5 is what is promised.  LIMIT is what the construction makes of it, so that a
   lost term shows: the last rounding 0.5; what it rounds is a head and a rest of at most 1/4 of it,
   and the rest's own roundings, each half a unit of the rest, come to another 0.4 at worst, where
   the result is just above a power of two. */
#include <mpfr.h>
#include <stdint.h>
#include <string.h>
#include "tap.h"

#include OWN

#define LIMIT 1.2

#ifdef SINGLE
#define DIGITS 24
#define LEAST  (-149)
typedef uint32_t word;
#define F(name)    name##f
#define NEAREST(z) mpfr_get_flt(z, MPFR_RNDN)
#else
#define DIGITS     53
#define LEAST      (-1074)
typedef uint64_t word;
#define F(name)    name
#define NEAREST(z) mpfr_get_d(z, MPFR_RNDN)
#endif

typedef own_real real;

static real number(word u) {
  real x;
  memcpy(&x, &u, sizeof x);
  return x;
}

static word bits(real x) {
  word u;
  memcpy(&u, &x, sizeof u);
  return u;
}

/* The same number, of zeros also the same sign; or neither is one. */
static int same(real a, real b) {
  return bits(a) == bits(b) || (a != a && b != b);
}

/* xorshift64, Marsaglia 2003 */
static uint64_t next(void) {
  static uint64_t s = 88172645463325252U;
  s ^= s << 13;
  s ^= s >> 7;
  s ^= s << 17;
  return s;
}

/* ---- errors ---- */

static double worst;
static real worst_at[2];

static void seen(real x, real y, double error) {
  if (error > worst || error != error) {
    worst = error == error ? error : HUGE_VAL;
    worst_at[0] = x;
    worst_at[1] = y;
  }
}

static int places(double want) {
  int e;
  frexp(want, &e);
  return e - DIGITS > LEAST ? e - DIGITS : LEAST;
}

typedef int (*oracle1)(mpfr_t, const mpfr_t, mpfr_rnd_t);
typedef int (*oracle2)(mpfr_t, const mpfr_t, const mpfr_t, mpfr_rnd_t);

static mpfr_t X, Y, Z, D;

/* Z has f(x, y) to 150 bits */
static void judge(real x, real y, real got) {
  const real want = NEAREST(Z);
  if (want != want || got != got || want - want != 0 || got - got != 0 || want == 0) {
    seen(x, y,
         same(got, want)
             ? 0
             : HUGE_VAL); /* at the edge of overflow too: no result is off by a unit there */
    return;
  }
  mpfr_set_d(D, (double)got, MPFR_RNDN);
  mpfr_sub(D, D, Z, MPFR_RNDN);
  seen(x, y, ldexp(fabs(mpfr_get_d(D, MPFR_RNDN)), -places((double)want)));
}

/* Arguments: bit patterns at random (all exponents alike), numbers of usual size, next to multiples
 * of pi/2, next to 1 */
static real argument(int i) {
  const double unit = (double)(int64_t)next() * 0x1p-63;
  switch (i % 5) {
  case 0:
    return number((word)next());
  case 1:
    return (real)(2 * unit);
  case 2:
    return (real)ldexp(unit, (int)(next() % 44) - 8);
  case 3:
    return (real)(1 + ldexp(unit, -(int)(next() % (DIGITS + 1))));
  default: {
    const double k = (double)(next() >> (11 + next() % 50)), near = k * 1.5707963267948966;
    return F(nextafter)((real)near, next() & 1 ? (real)1e30 : 0);
  }
  }
}

static void told(const char *name) {
  printf("# %-6s %s: %.3f ulp at %a, %a\n", name, sizeof(real) == 4 ? "float" : "double", worst,
         (double)worst_at[0], (double)worst_at[1]);
  ok(worst <= LIMIT, "%s in %s is within %.1f ulp", name, sizeof(real) == 4 ? "float" : "double",
     LIMIT);
}

static void against_mpfr(real (*f)(real), oracle1 g, int n) {
  int i;
  for (i = 0; i < n; i++) {
    const real x = argument(i);
    mpfr_set_d(X, (double)x, MPFR_RNDN);
    g(Z, X, MPFR_RNDN);
    judge(x, 0, f(x));
  }
}

/* Float only: 2^22 numbers spread evenly over all bit patterns, against the C library's double,
 * wrong by 2^-28 ulp */
static void against_double(real (*f)(real), double (*g)(double)) {
#ifdef SINGLE
  uint64_t u;
  for (u = 0; u < (uint64_t)1 << 32; u += 1021) {
    const real x = number((word)u), got = f(x);
    const double exact = g((double)x);
    const real want = (real)exact;
    if (want - want != 0 || want == 0 || got - got != 0)
      seen(x, 0, same(got, want) ? 0 : HUGE_VAL);
    else
      seen(x, 0, ldexp(fabs((double)got - exact), -places((double)want)));
  }
#else
  (void)f;
  (void)g;
#endif
}

#define ONE(name)                                                                                  \
  do {                                                                                             \
    worst = 0;                                                                                     \
    against_double(own_##name, name);                                                              \
    against_mpfr(own_##name, mpfr_##name, 30000);                                                  \
    told(#name);                                                                                   \
  } while (0)

static void two(const char *name, real (*f)(real, real), oracle2 g, int power) {
  int i;
  worst = 0;
  for (i = 0; i < 60000; i++) {
    real x = argument(i / 2), y = argument(i / 2 + i);
    if (power && i % 2) { /* where x^y does not over- or underflow */
      x = F(fabs)(x);
      y = (real)((double)(int64_t)next() * 0x1p-63 * 1.03 * (sizeof(real) == 4 ? 104 : 746) /
                 log((double)x));
      if (i % 8 == 1)
        y = F(floor)(y);
    } else if (i % 2) {
      y = x * (real)(1 + ldexp((double)(int64_t)next() * 0x1p-63, 2 - (int)(next() % 40)));
    }
    mpfr_set_d(X, (double)x, MPFR_RNDN);
    mpfr_set_d(Y, (double)y, MPFR_RNDN);
    g(Z, X, Y, MPFR_RNDN);
    judge(x, y, f(x, y));
  }
  told(name);
}

/* ---- exact ones, and special numbers ---- */

static void exact(void) {
  int bad_root = 0, bad_floor = 0, bad_parts = 0, bad_power = 0, bad_sign = 0, i;
  for (i = 0; i < 300000; i++) {
    const real x = argument(i), y = argument(i / 5),
               small = (real)((double)(int64_t)next() * 0x1p-63 * ldexp(1, i % 60));
    int a, b,
        n = (int)(next() % (sizeof(real) == 4 ? 600 : 4400)) - (sizeof(real) == 4 ? 300 : 2200);
    real p, q;
    bad_root += !same(own_sqrt(x), F(sqrt)(x)) || !same(own_sqrt(F(fabs)(x)), F(sqrt)(F(fabs)(x)));
    bad_floor += !same(own_floor(x), F(floor)(x)) || !same(own_floor(small), F(floor)(small));
    p = own_frexp(x, &a);
    q = F(frexp)(x, &b);
    bad_parts += !same(p, q) || (x - x == 0 && a != b);
    bad_power +=
        !same(own_ldexp(x, n), F(ldexp)(x, n)) || !same(own_ldexp(x, n % 30), F(ldexp)(x, n % 30));
    bad_sign += !same(own_fabs(x), F(fabs)(x)) || !same(own_copysign(x, y), F(copysign)(x, y));
  }
  ok(bad_root == 0, "sqrt is correctly rounded");
  ok(bad_floor == 0, "floor is exact");
  ok(bad_parts == 0, "frexp is exact");
  ok(bad_power == 0, "ldexp rounds once");
  ok(bad_sign == 0, "fabs and copysign are exact");
  ok(own_huge() == (real)HUGE_VAL, "huge is infinity");
}

#define UNARY(name)                                                                                \
  { #name, own_##name, F(name) }
static const struct {
  const char *name;
  real (*own)(real), (*system)(real);
} unary[] = {UNARY(sin),  UNARY(cos),  UNARY(tan),  UNARY(asin), UNARY(acos),
             UNARY(atan), UNARY(exp),  UNARY(log),  UNARY(sinh), UNARY(cosh),
             UNARY(tanh), UNARY(cbrt), UNARY(sqrt), UNARY(floor)};
enum { FUNCTIONS = sizeof unary / sizeof unary[0] };

/* Zeros, infinities and no numbers as the C library has them (C99, annex F); elsewhere near its
 * result. */
static int alike(real a, real b) {
  if (a != a || b != b || a - a != 0 || b - b != 0 || a == 0 || b == 0)
    return same(a, b);
  return F(fabs)(a - b) <= (real)ldexp(4, places((double)b));
}

static void special(void) {
  const real least = (real)ldexp(1, LEAST), normal = (real)ldexp(1, LEAST + DIGITS - 1),
             most = (real)ldexp(2 - ldexp(1, 1 - DIGITS), sizeof(real) == 4 ? 127 : 1023),
             none = F(nan)("");
  const real list[] = {0,
                       least,
                       normal - least,
                       normal,
                       (real)0.25,
                       (real)0.5,
                       (real)0.75,
                       1 - (real)ldexp(1, -DIGITS),
                       1,
                       1 + (real)ldexp(1, 1 - DIGITS),
                       (real)1.5,
                       2,
                       3,
                       5,
                       1001,
                       8388607,
                       16777215,
                       16777216,
                       most,
                       (real)HUGE_VAL,
                       none};
  enum { NUMBERS = sizeof list / sizeof list[0] };
  int i, j, k;
  for (k = 0; k < FUNCTIONS; k++) {
    int fine = 1;
    for (i = 0; i < 2 * NUMBERS; i++) {
      const real x = i % 2 ? -list[i / 2] : list[i / 2];
      if (!alike(unary[k].own(x), unary[k].system(x))) {
        printf("# %s(%a) = %a, want %a\n", unary[k].name, (double)x, (double)unary[k].own(x),
               (double)unary[k].system(x));
        fine = 0;
      }
    }
    ok(fine, "%s: special numbers", unary[k].name);
  }
  for (k = 0; k < 2; k++) {
    int fine = 1;
    for (i = 0; i < 2 * NUMBERS; i++) {
      for (j = 0; j < 2 * NUMBERS; j++) {
        const real x = i % 2 ? -list[i / 2] : list[i / 2], y = j % 2 ? -list[j / 2] : list[j / 2];
        const real got = k ? own_atan2(x, y) : own_pow(x, y),
                   want = k ? F(atan2)(x, y) : F(pow)(x, y);
        if (!alike(got, want)) {
          printf("# (%a, %a): %a, want %a\n", (double)x, (double)y, (double)got, (double)want);
          fine = 0;
        }
      }
    }
    ok(fine, "%s: special numbers", k ? "atan2" : "pow");
  }
}

/* ---- the same bits ---- */

static uint64_t mixed(uint64_t h, real x) {
  const word u = x == x ? bits(x) : 0; /* which no number it is, is not ours */
  return (h ^ u) * 1099511628211U;     /* FNV-1a */
}

static void hash(void) {
  uint64_t h = 14695981039346656037U;
  int i, k;
  for (i = 0; i < 40000; i++) {
    const real x = argument(i), y = argument(i / 5);
    int e;
    for (k = 0; k < FUNCTIONS; k++)
      h = mixed(h, unary[k].own(x));
    h = mixed(h, own_pow(x, y));
    h = mixed(h, own_atan2(x, y));
    h = mixed(h, own_ldexp(x, i % 300 - 150));
    h = mixed(h, own_frexp(x, &e));
    h = (h ^ (uint64_t)(e + 5000)) * 1099511628211U;
  }
  printf("%016llx\n", (unsigned long long)h);
}

int main(int argc, char **argv) {
  (void)argv;
  if (argc > 1) {
    hash();
    return 0;
  }
  mpfr_init2(X, 53);
  mpfr_init2(Y, 53);
  mpfr_init2(Z, 150);
  mpfr_init2(D, 150);
  exact();
  special();
  ONE(sin);
  ONE(cos);
  ONE(tan);
  ONE(asin);
  ONE(acos);
  ONE(atan);
  ONE(exp);
  ONE(log);
  ONE(sinh);
  ONE(cosh);
  ONE(tanh);
  ONE(cbrt);
  two("atan2", own_atan2, mpfr_atan2, 0);
  two("pow", own_pow, mpfr_pow, 1);
  return tap_done();
}
