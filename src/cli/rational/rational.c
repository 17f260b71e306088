/* rational.c - exact rational numbers for Lua: storage, arithmetic, and the module's table.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Everything above the line (generator/) computes with these: a literal 0.1 in a scene is 1/10 and
 * stays so.  There is no silent overflow and no rounding here: a result is exact, or an error says
 * "number too large" or "division by zero".  Lua integers mix freely; floats are refused, because a
 * float that slips into exact algebra is a bug of the caller.
 * Not here: text (text.c), roundings to binary and real functions (real.c).
 */
#include "rational.h"

#include <lauxlib.h>
#include <math.h>
#include <mpfr.h>
#include <stdint.h>
#include <string.h>

#define TYPE_NAME "rational"

/* |num| and |den| count limbs; the sign of `num` is the number's. Limbs follow: num's, then den's.
 */
struct rational {
  int num, den;
  mp_limb_t limb[];
};

_Static_assert(sizeof(mp_limb_t) >= sizeof(lua_Integer), "a Lua integer fits one limb");

static const mp_limb_t one_limb[1] = {1};

static int size_of(int signed_size) {
  return signed_size < 0 ? -signed_size : signed_size;
}

void (*rational_charge)(double instructions);

/* Products and common divisors of n limbs take about n^1.6 (GMP's manual, Algorithms); fewer than
   SMALL are lost in what the call takes. */
void rational_work(size_t limbs, double times) {
  enum { SMALL = 32 };
  if (rational_charge != NULL && limbs > SMALL)
    rational_charge(times * 0.25 * pow((double)limbs, 1.6));
}

struct rational_scratch *rational_scratch(lua_State *L) {
  return lua_touserdata(L, lua_upvalueindex(1));
}

/* The operand at `arg` as a view, or 0 when it is neither a rational nor a Lua integer. */
static int view_of(lua_State *L, int arg, struct rational_view *view) {
  if (lua_isinteger(L, arg)) {
    const lua_Integer n = lua_tointeger(L, arg);
    view->limb = n < 0 ? (mp_limb_t)0 - (mp_limb_t)n : (mp_limb_t)n;
    mpz_roinit_n(mpq_numref(view->q), &view->limb, n < 0 ? -1 : n > 0);
    mpz_roinit_n(mpq_denref(view->q), one_limb, 1);
    return 1;
  }
  const struct rational *x = luaL_testudata(L, arg, TYPE_NAME);
  if (x == NULL)
    return 0;
  mpz_roinit_n(mpq_numref(view->q), x->limb, x->num);
  mpz_roinit_n(mpq_denref(view->q), x->limb + size_of(x->num), x->den);
  rational_work((size_t)(size_of(x->num) + x->den), 1);
  return 1;
}

mpq_srcptr rational_arg(lua_State *L, int arg, struct rational_view *view) {
  if (!view_of(L, arg, view))
    luaL_typeerror(L, arg, "rational or integer");
  return view->q;
}

int rational_push(lua_State *L, mpq_srcptr q) {
  const mpz_srcptr num = mpq_numref(q), den = mpq_denref(q);
  if (mpz_sizeinbase(num, 2) > RATIONAL_MAX_BITS || mpz_sizeinbase(den, 2) > RATIONAL_MAX_BITS)
    return luaL_error(L, "number too large");
  const size_t n = mpz_size(num), d = mpz_size(den);
  struct rational *x = lua_newuserdatauv(L, sizeof *x + (n + d) * sizeof(mp_limb_t), 0);
  x->num = mpz_sgn(num) < 0 ? -(int)n : (int)n;
  x->den = (int)d;
  if (n > 0)
    memcpy(x->limb, mpz_limbs_read(num), n * sizeof(mp_limb_t));
  memcpy(x->limb + n, mpz_limbs_read(den), d * sizeof(mp_limb_t));
  luaL_setmetatable(L, TYPE_NAME);
  return 1;
}

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

static int add(lua_State *L) {
  struct rational_view a, b;
  struct rational_scratch *s = rational_scratch(L);
  if (deferred(L, "__add"))
    return 1;
  mpq_add(s->q, rational_arg(L, 1, &a), rational_arg(L, 2, &b));
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
  mpq_mul(s->q, rational_arg(L, 1, &a), rational_arg(L, 2, &b));
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
  lua_pushboolean(L, view_of(L, 1, &a) && view_of(L, 2, &b) && mpq_equal(a.q, b.q));
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
  lua_pushboolean(L, luaL_testudata(L, 1, TYPE_NAME) != NULL);
  return 1;
}

static int numerator(lua_State *L) {
  struct rational_view a;
  rational_arg(L, 1, &a);
  mpz_roinit_n(mpq_denref(a.q), one_limb, 1);
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
  scratch_new(L);
  luaL_newmetatable(L, TYPE_NAME);
  lua_pushvalue(L, -2);
  luaL_setfuncs(L, metamethods, 1);
  lua_pop(L, 1);
  luaL_newlibtable(L, functions);
  lua_insert(L, -2);
  luaL_setfuncs(L, functions, 1);
  return 1;
}
