/* rational.c - exact rational numbers for Lua: arithmetic, and the module's table.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Everything above the line (generator/) computes with these: a literal 0.1 in a scene is 1/10 and
 * stays so.  There is no silent overflow and no rounding here: a result is exact, or an error says
 * "number too large" or "division by zero".  Lua integers mix freely; floats are refused, because a
 * float that slips into exact algebra is a bug of the caller.
 * Not here: storage (number.c), text (text.c), roundings to binary and real functions (real.c).
 */
#include "rational.h"

#include <lauxlib.h>
#include <limits.h>
#include <mpfr.h>
#include <stdint.h>

/* ---- arithmetic ---- */

/* q + e with an object e that knows this operation (an expression, say): e's metamethod answers.
   Lua asks the left operand first, so this matters for the right one only.  1: its result is on
   top. */
static int deferred(lua_State *L, const char *event) {
  if (!lua_istable(L, 2) || luaL_getmetafield(L, 2, event) == LUA_TNIL)
    return 0;
  lua_insert(L, 1);
  lua_call(L, 2, 1);
  return 1;
}

/* Are both whole, and so small that their product is a long? Most are. */
static int short_whole(mpq_srcptr a, mpq_srcptr b) {
  const unsigned long limit = 1UL << (sizeof(long) * CHAR_BIT / 2 - 1);
  return mpz_cmp_ui(mpq_denref(a), 1) == 0 && mpz_cmp_ui(mpq_denref(b), 1) == 0 &&
         mpz_cmpabs_ui(mpq_numref(a), limit) < 0 && mpz_cmpabs_ui(mpq_numref(b), limit) < 0;
}

static long whole_of(mpq_srcptr q) {
  return mpz_get_si(mpq_numref(q));
}

static int add(lua_State *L) {
  struct rational_view a, b;
  struct rational_scratch *s = rational_scratch(L);
  if (deferred(L, "__add"))
    return 1;
  rational_arg(L, 1, &a);
  rational_arg(L, 2, &b);
  if (short_whole(a.q, b.q))
    mpq_set_si(s->q, whole_of(a.q) + whole_of(b.q), 1);
  else
    mpq_add(s->q, a.q, b.q);
  return rational_push(L, s->q);
}

static int subtract(lua_State *L) {
  struct rational_view a, b;
  struct rational_scratch *s = rational_scratch(L);
  if (deferred(L, "__sub"))
    return 1;
  mpq_sub(s->q, rational_arg(L, 1, &a), rational_arg(L, 2, &b));
  return rational_push(L, s->q);
}

static int multiply(lua_State *L) {
  struct rational_view a, b;
  struct rational_scratch *s = rational_scratch(L);
  if (deferred(L, "__mul"))
    return 1;
  rational_arg(L, 1, &a);
  rational_arg(L, 2, &b);
  if (short_whole(a.q, b.q))
    mpq_set_si(s->q, whole_of(a.q) * whole_of(b.q), 1);
  else
    mpq_mul(s->q, a.q, b.q);
  return rational_push(L, s->q);
}

static int divide(lua_State *L) {
  struct rational_view a, b;
  struct rational_scratch *s = rational_scratch(L);
  if (deferred(L, "__div"))
    return 1;
  rational_arg(L, 1, &a);
  if (mpq_sgn(rational_arg(L, 2, &b)) == 0)
    return luaL_error(L, "division by zero");
  mpq_div(s->q, a.q, b.q);
  return rational_push(L, s->q);
}

static int negate(lua_State *L) {
  struct rational_view a;
  struct rational_scratch *s = rational_scratch(L);
  mpq_neg(s->q, rational_arg(L, 1, &a));
  return rational_push(L, s->q);
}

/* z^n would have more than (bits - 1) * n bits: refuse before GMP allocates them. */
static void check_power(lua_State *L, mpz_srcptr z, unsigned long n) {
  const size_t bits = mpz_sizeinbase(z, 2) - 1;
  if (bits > 0 && n > RATIONAL_MAX_BITS / bits)
    luaL_error(L, "number too large");
}

static int power(lua_State *L) {
  struct rational_view a;
  struct rational_scratch *s = rational_scratch(L);
  if (deferred(L, "__pow"))
    return 1;
  rational_arg(L, 1, &a);
  if (!lua_isinteger(L, 2))
    return luaL_argerror(L, 2, "integer exponent expected");
  const lua_Integer e = lua_tointeger(L, 2);
  const unsigned long n = e < 0 ? 0UL - (unsigned long)e : (unsigned long)e;
  check_power(L, mpq_numref(a.q), n);
  check_power(L, mpq_denref(a.q), n);
  /* num and den stay coprime under a power, so no gcd is needed */
  mpz_pow_ui(mpq_numref(s->q), mpq_numref(a.q), n);
  mpz_pow_ui(mpq_denref(s->q), mpq_denref(a.q), n);
  if (e < 0) {
    if (mpq_sgn(a.q) == 0)
      return luaL_error(L, "division by zero");
    mpq_inv(s->q, s->q);
  }
  return rational_push(L, s->q);
}

/* ---- comparison ---- */

static int equal(lua_State *L) {
  struct rational_view a, b;
  lua_pushboolean(L,
                  rational_view_of(L, 1, &a) && rational_view_of(L, 2, &b) && mpq_equal(a.q, b.q));
  return 1;
}

static int less(lua_State *L) {
  struct rational_view a, b;
  lua_pushboolean(L, mpq_cmp(rational_arg(L, 1, &a), rational_arg(L, 2, &b)) < 0);
  return 1;
}

static int less_equal(lua_State *L) {
  struct rational_view a, b;
  lua_pushboolean(L, mpq_cmp(rational_arg(L, 1, &a), rational_arg(L, 2, &b)) <= 0);
  return 1;
}

/* ---- parts and roots ---- */

static int new (lua_State *L) {
  struct rational_view n, d;
  struct rational_scratch *s = rational_scratch(L);
  luaL_argexpected(L, lua_isinteger(L, 1), 1, "integer");
  rational_arg(L, 1, &n);
  if (lua_isnoneornil(L, 2))
    return rational_push(L, n.q);
  luaL_argexpected(L, lua_isinteger(L, 2), 2, "integer");
  if (mpq_sgn(rational_arg(L, 2, &d)) == 0)
    return luaL_error(L, "division by zero");
  mpq_div(s->q, n.q, d.q);
  return rational_push(L, s->q);
}

static int is(lua_State *L) {
  lua_pushboolean(L, rational_is(L, 1));
  return 1;
}

static int numerator(lua_State *L) {
  static const mp_limb_t one = 1;
  struct rational_view a;
  rational_arg(L, 1, &a);
  mpz_roinit_n(mpq_denref(a.q), &one, 1);
  return rational_push(L, a.q);
}

static int denominator(lua_State *L) {
  struct rational_view a;
  struct rational_scratch *s = rational_scratch(L);
  mpq_set_z(s->q, mpq_denref(rational_arg(L, 1, &a)));
  return rational_push(L, s->q);
}

static int sign(lua_State *L) {
  struct rational_view a;
  lua_pushinteger(L, mpq_sgn(rational_arg(L, 1, &a)));
  return 1;
}

static int isint(lua_State *L) {
  struct rational_view a;
  lua_pushboolean(L, mpz_cmp_ui(mpq_denref(rational_arg(L, 1, &a)), 1) == 0);
  return 1;
}

static int small(lua_State *L) {
  struct rational_view a;
  lua_pushboolean(L, rational_is_small(rational_arg(L, 1, &a)));
  return 1;
}

static int toint(lua_State *L) {
  struct rational_view a;
  rational_arg(L, 1, &a);
  const mpz_srcptr num = mpq_numref(a.q);
  const mp_limb_t low = mpz_getlimbn(num, 0);
  const mp_limb_t most = (mp_limb_t)INT64_MAX + (mpz_sgn(num) < 0); /* |math.mininteger| = 2^63 */
  if (mpz_cmp_ui(mpq_denref(a.q), 1) != 0 || mpz_size(num) > 1 || low > most)
    lua_pushnil(L);
  else
    lua_pushinteger(L, (lua_Integer)(mpz_sgn(num) < 0 ? (mp_limb_t)0 - low : low));
  return 1;
}

static int whole(lua_State *L) {
  struct rational_view a;
  struct rational_scratch *s = rational_scratch(L);
  rational_arg(L, 1, &a);
  mpz_fdiv_q(s->a, mpq_numref(a.q), mpq_denref(a.q));
  mpq_set_z(s->q, s->a);
  return rational_push(L, s->q);
}

static int absolute(lua_State *L) {
  struct rational_view a;
  struct rational_scratch *s = rational_scratch(L);
  mpq_abs(s->q, rational_arg(L, 1, &a));
  return rational_push(L, s->q);
}

/* In lowest terms p/r is an n-th power iff p and r both are. */
static int root(lua_State *L) {
  struct rational_view a;
  struct rational_scratch *s = rational_scratch(L);
  rational_arg(L, 1, &a);
  const lua_Integer n = luaL_checkinteger(L, 2);
  luaL_argcheck(L, n >= 2, 2, "degree of a root must be at least 2");
  if ((mpq_sgn(a.q) < 0 && n % 2 == 0) ||
      !mpz_root(mpq_numref(s->q), mpq_numref(a.q), (unsigned long)n) ||
      !mpz_root(mpq_denref(s->q), mpq_denref(a.q), (unsigned long)n)) {
    lua_pushnil(L);
    return 1;
  }
  return rational_push(L, s->q);
}

/* gcd(a/b, c/d) = gcd(a, c) / lcm(b, d): the largest g such that both are whole multiples of it. */
static int gcd(lua_State *L) {
  struct rational_view a, b;
  struct rational_scratch *s = rational_scratch(L);
  rational_arg(L, 1, &a);
  rational_arg(L, 2, &b);
  mpz_gcd(mpq_numref(s->q), mpq_numref(a.q), mpq_numref(b.q));
  mpz_lcm(mpq_denref(s->q), mpq_denref(a.q), mpq_denref(b.q));
  mpq_canonicalize(s->q);
  return rational_push(L, s->q);
}

/* ---- module ---- */

static int scratch_free(lua_State *L) {
  struct rational_scratch *s = lua_touserdata(L, 1);
  mpq_clears(s->q, s->r, (mpq_ptr)NULL);
  mpz_clears(s->a, s->b, s->c, s->d, (mpz_ptr)NULL);
  mpfr_free_cache();
  return 0;
}

static void scratch_new(lua_State *L) {
  struct rational_scratch *s = lua_newuserdatauv(L, sizeof *s, 0);
  mpq_inits(s->q, s->r, (mpq_ptr)NULL);
  mpz_inits(s->a, s->b, s->c, s->d, (mpz_ptr)NULL);
  lua_newtable(L);
  lua_pushcfunction(L, scratch_free);
  lua_setfield(L, -2, "__gc");
  lua_setmetatable(L, -2);
}

static const luaL_Reg metamethods[] = {
    {"__add", add},       {"__sub", subtract},
    {"__mul", multiply},  {"__div", divide},
    {"__unm", negate},    {"__pow", power},
    {"__eq", equal},      {"__lt", less},
    {"__le", less_equal}, {"__tostring", rational_lua_tostring},
    {NULL, NULL},
};

static const luaL_Reg functions[] = {
    {"new", new},
    {"is", is},
    {"num", numerator},
    {"den", denominator},
    {"sign", sign},
    {"isint", isint},
    {"small", small},
    {"toint", toint},
    {"floor", whole},
    {"abs", absolute},
    {"root", root},
    {"gcd", gcd},
    {"parse", rational_lua_parse},
    {"decimal", rational_lua_decimal},
    {"todouble", rational_lua_todouble},
    {"tofloat", rational_lua_tofloat},
    {"fromdouble", rational_lua_fromdouble},
    {"round", rational_lua_round},
    {"log2", rational_lua_log2},
    {"apply", rational_lua_apply},
    {NULL, NULL},
};

int luaopen_polhode_rational(lua_State *L) {
  luaL_checkversion(L);
  lua_settop(L, 0);
  luaL_newlibtable(L, functions);
  scratch_new(L);
  luaL_newmetatable(L, RATIONAL_TYPE);
  rational_make_small(L, 3);
  lua_pushvalue(L, 3);
  for (int i = 2; i <= 4; i++)
    lua_pushvalue(L, i);
  luaL_setfuncs(L, metamethods, RATIONAL_UPVALUES);
  lua_pop(L, 1);
  luaL_setfuncs(L, functions, RATIONAL_UPVALUES);
  return 1;
}
