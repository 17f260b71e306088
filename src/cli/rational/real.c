/* real.c - rational numbers and the reals: correct roundings, exact values, MPFR
 * functions.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * One rounding for all formats: with ulp = 2^k the weight of the last kept bit, floor(|q| / ulp) is
 * an integer quotient whose remainder decides, ties to even (IEEE 754-2019, 4.3.1).  Subnormals are
 * the same with k held at its least; overflow is what ldexp makes of it.  No intermediate rounding
 * exists, so there is no double rounding.
 *
 * Functions of a rational (apply) are rounded correctly too, by Ziv's strategy: the argument is
 * enclosed at a working precision, the function taken at the ends, and the precision doubled until
 * all ends round to the same number.  Every function here is monotone over so small an enclosure,
 * except next to an extremum of sin or cos, whose value 1 is then the rounding of both ends.
 */
#include "rational.h"
#include "special.h"

#include <lauxlib.h>
#include <math.h>
#include <mpfr.h>
#include <stdlib.h>
#include <string.h>

/* Precision that apply accepts; MPFR's cost at the upper end is below a second. */
#define MAX_PRECISION 65536

/* Enclosures are refined this often; reaching the end means a tie, which any rounding may break. */
#define MAX_REFINEMENTS 6

long rational_log2(struct rational_scratch *s, mpq_srcptr q) {
  const mpz_srcptr num = mpq_numref(q), den = mpq_denref(q);
  /* 2^(k-1) < |q| < 2^(k+1) with k the difference of the sizes: one comparison decides */
  const long k = (long)mpz_sizeinbase(num, 2) - (long)mpz_sizeinbase(den, 2);
  if (k >= 0) {
    mpz_mul_2exp(s->a, den, (mp_bitcnt_t)k);
    return mpz_cmpabs(num, s->a) >= 0 ? k : k - 1;
  }
  mpz_mul_2exp(s->a, num, (mp_bitcnt_t)-k);
  return mpz_cmpabs(s->a, den) >= 0 ? k : k - 1;
}

/* s->c = |q| / 2^k rounded to the nearest integer, ties to even. */
static void round_at(struct rational_scratch *s, mpq_srcptr q, long k) {
  mpz_abs(s->a, mpq_numref(q));
  mpz_set(s->b, mpq_denref(q));
  if (k >= 0)
    mpz_mul_2exp(s->b, s->b, (mp_bitcnt_t)k);
  else
    mpz_mul_2exp(s->a, s->a, (mp_bitcnt_t)-k);
  mpz_fdiv_qr(s->c, s->d, s->a, s->b);
  mpz_mul_2exp(s->d, s->d, 1);
  const int half = mpz_cmp(s->d, s->b);
  if (half > 0 || (half == 0 && mpz_odd_p(s->c)))
    mpz_add_ui(s->c, s->c, 1);
}

/* A binary format: digits of the significand, exponents of its smallest ulp and of its overflow. */
struct format {
  int digits, least_ulp, overflow;
};

static double to_format(struct rational_scratch *s, mpq_srcptr q, const struct format *f) {
  if (mpq_sgn(q) == 0)
    return 0.0;
  const long top = rational_log2(s, q);
  const long ulp = top - f->digits + 1 > f->least_ulp ? top - f->digits + 1 : f->least_ulp;
  double x = HUGE_VAL;
  if (top < f->least_ulp - 1) {
    x = 0.0; /* below half the smallest subnormal; spares shifting far */
  } else if (top < f->overflow) {
    round_at(s, q, ulp);
    x = ldexp(mpz_get_d(s->c), (int)ulp); /* exact: at most `digits` bits, or 2^digits */
    if (x >= ldexp(1.0, f->overflow - 1) * 2.0)
      x = HUGE_VAL;
  }
  return mpq_sgn(q) < 0 ? -x : x;
}

static int push_format(lua_State *L, const struct format *f) {
  struct rational_view a;
  rational_arg(L, 1, &a);
  lua_pushnumber(L, to_format(rational_scratch(L), a.q, f));
  return 1;
}

int rational_lua_todouble(lua_State *L) {
  static const struct format binary64 = {53, -1074, 1024};
  return push_format(L, &binary64);
}

int rational_lua_tofloat(lua_State *L) {
  static const struct format binary32 = {24, -149, 128};
  return push_format(L, &binary32);
}

int rational_lua_fromdouble(lua_State *L) {
  struct rational_scratch *s = rational_scratch(L);
  luaL_checktype(L, 1, LUA_TNUMBER);
  if (lua_isinteger(L, 1)) {
    struct rational_view a;
    return rational_push(L, rational_arg(L, 1, &a));
  }
  const double x = lua_tonumber(L, 1);
  luaL_argcheck(L, isfinite(x), 1, "finite number expected");
  mpq_set_d(s->q, x); /* exact */
  return rational_push(L, s->q);
}

/* q = sign * s->c * 2^k */
static void set_dyadic(struct rational_scratch *s, mpq_ptr q, int sign, long k) {
  mpz_set(mpq_numref(q), s->c);
  mpz_set_ui(mpq_denref(q), 1);
  if (sign < 0)
    mpq_neg(q, q);
  if (k >= 0)
    mpq_mul_2exp(q, q, (mp_bitcnt_t)k);
  else
    mpq_div_2exp(q, q, (mp_bitcnt_t)-k);
}

static lua_Integer check_precision(lua_State *L, int arg) {
  const lua_Integer bits = luaL_checkinteger(L, arg);
  luaL_argcheck(L, bits >= 1 && bits <= MAX_PRECISION, arg, "precision out of range");
  return bits;
}

int rational_lua_round(lua_State *L) {
  struct rational_view a;
  struct rational_scratch *s = rational_scratch(L);
  rational_arg(L, 1, &a);
  const long bits = (long)check_precision(L, 2);
  if (mpq_sgn(a.q) == 0)
    return rational_push(L, a.q);
  const long ulp = rational_log2(s, a.q) - bits + 1;
  round_at(s, a.q, ulp);
  set_dyadic(s, s->q, mpq_sgn(a.q), ulp);
  return rational_push(L, s->q);
}

int rational_lua_log2(lua_State *L) {
  struct rational_view a;
  rational_arg(L, 1, &a);
  luaL_argcheck(L, mpq_sgn(a.q) != 0, 1, "logarithm of zero");
  lua_pushinteger(L, rational_log2(rational_scratch(L), a.q));
  return 1;
}

/* ---- apply ---- */

typedef int unary(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);
typedef int binary(mpfr_ptr, mpfr_srcptr, mpfr_srcptr, mpfr_rnd_t);
typedef void special(mpfr_ptr, mpq_srcptr const *); /* rounds by itself, see special.h */

static int constant_pi(mpfr_ptr y, mpfr_srcptr x, mpfr_rnd_t mode) {
  (void)x;
  return mpfr_const_pi(y, mode);
}

static const struct function {
  const char *name;
  int arity;
  unary *f1;
  binary *f2;
  special *f3;
} functions[] = {
    {"pi", 0, constant_pi, NULL, NULL},
    {"sqrt", 1, mpfr_sqrt, NULL, NULL},
    {"cbrt", 1, mpfr_cbrt, NULL, NULL},
    {"sin", 1, mpfr_sin, NULL, NULL},
    {"cos", 1, mpfr_cos, NULL, NULL},
    {"tan", 1, mpfr_tan, NULL, NULL},
    {"asin", 1, mpfr_asin, NULL, NULL},
    {"acos", 1, mpfr_acos, NULL, NULL},
    {"atan", 1, mpfr_atan, NULL, NULL},
    {"exp", 1, mpfr_exp, NULL, NULL},
    {"log", 1, mpfr_log, NULL, NULL},
    {"sinh", 1, mpfr_sinh, NULL, NULL},
    {"cosh", 1, mpfr_cosh, NULL, NULL},
    {"tanh", 1, mpfr_tanh, NULL, NULL},
    {"asinh", 1, mpfr_asinh, NULL, NULL},
    {"atan2", 2, NULL, mpfr_atan2, NULL},
    {"pow", 2, NULL, mpfr_pow, NULL},
    {"agm", 2, NULL, mpfr_agm, NULL},
    {"ellipsoid_area", 3, NULL, NULL, rational_ellipsoid_area},
    {"ellipsoid_normal", 3, NULL, NULL, rational_ellipsoid_normal},
    {"arc_across", 1, NULL, NULL, rational_arc_across},
    {"arc_along", 1, NULL, NULL, rational_arc_along},
    {"arc_lever", 1, NULL, NULL, rational_arc_lever},
    {"catenary_rise", 1, NULL, NULL, rational_catenary_rise},
    {"catenary_width", 1, NULL, NULL, rational_catenary_width},
    {"catenary_height", 1, NULL, NULL, rational_catenary_height},
};

static const struct function *find_function(const char *name) {
  for (size_t i = 0; i < sizeof functions / sizeof functions[0]; i++)
    if (strcmp(functions[i].name, name) == 0)
      return &functions[i];
  return NULL;
}

/* y = f at the enclosure's corner `corner`: bit i chooses the lower or upper end of argument i. */
static void at_corner(mpfr_ptr y, const struct function *f, mpq_srcptr const arg[2],
                      mpfr_prec_t work, unsigned corner) {
  mpfr_t x[2];
  mpfr_inits2(work, x[0], x[1], (mpfr_ptr)NULL);
  for (int i = 0; i < f->arity; i++)
    mpfr_set_q(x[i], arg[i], corner >> i & 1 ? MPFR_RNDU : MPFR_RNDD);
  if (f->arity == 2)
    f->f2(y, x[0], x[1], MPFR_RNDN);
  else
    f->f1(y, x[0], MPFR_RNDN);
  mpfr_clears(x[0], x[1], (mpfr_ptr)NULL);
}

/* y = f(arg...) correctly rounded to y's precision. */
static void evaluate(mpfr_ptr y, const struct function *f, mpq_srcptr const arg[2]) {
  const unsigned corners = 1U << f->arity;
  mpfr_prec_t work = mpfr_get_prec(y) + 64;
  mpfr_t other;
  mpfr_init2(other, mpfr_get_prec(y));
  for (int i = 0, agreed = 0; i < MAX_REFINEMENTS && !agreed; i++, work *= 2) {
    at_corner(y, f, arg, work, 0);
    agreed = 1;
    for (unsigned corner = 1; corner < corners && agreed; corner++) {
      at_corner(other, f, arg, work, corner);
      agreed = mpfr_equal_p(y, other) || (mpfr_nan_p(y) && mpfr_nan_p(other));
    }
  }
  mpfr_clear(other);
}

int rational_lua_apply(lua_State *L) {
  struct rational_scratch *s = rational_scratch(L);
  struct rational_view view[3];
  mpq_srcptr arg[3] = {NULL, NULL, NULL};
  const struct function *f = find_function(luaL_checkstring(L, 1));
  if (f == NULL)
    return luaL_argerror(L, 1, "unknown function");
  const mpfr_prec_t bits = (mpfr_prec_t)check_precision(L, 2);
  for (int i = 0; i < f->arity; i++)
    arg[i] = rational_arg(L, 3 + i, &view[i]);
  for (int i = 0; i < f->arity; i++) /* a series, after a reduction by as many digits */
    rational_work((size_t)bits / 32 + mpz_size(mpq_numref(arg[i])) + mpz_size(mpq_denref(arg[i])),
                  20);
  mpfr_t y;
  mpfr_init2(y, bits);
  mpfr_clear_underflow();
  if (f->f3)
    f->f3(y, arg);
  else
    evaluate(y, f, arg);
  int sign = 0;
  long exponent = 0;
  /* beyond the bound a result is out of range: nil, as for log(-1) */
  const int good = mpfr_number_p(y) && !mpfr_underflow_p() &&
                   (mpfr_zero_p(y) || labs(mpfr_get_exp(y)) < RATIONAL_MAX_BITS / 2);
  if (good && !mpfr_zero_p(y)) {
    sign = mpfr_sgn(y);
    exponent = mpfr_get_z_2exp(s->c, y);
    mpz_abs(s->c, s->c);
  }
  mpfr_clear(y);
  if (!good) {
    lua_pushnil(L);
    return 1;
  }
  if (sign == 0)
    mpz_set_ui(s->c, 0);
  set_dyadic(s, s->q, sign, exponent);
  return rational_push(L, s->q);
}
