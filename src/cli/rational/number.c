/* number.c - how a rational number is kept in a userdata of Lua's, read and made.
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "rational.h"

#include <lauxlib.h>
#include <math.h>
#include <string.h>

/* |num| and |den| count limbs; the sign of `num` is the number's. Limbs follow: num's, then
   den's. */
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
  return lua_touserdata(L, lua_upvalueindex(RATIONAL_SCRATCH));
}

/* As luaL_testudata, which looks the metatable up by its name. */
static const struct rational *at(lua_State *L, int arg) {
  const struct rational *x = lua_touserdata(L, arg);
  if (x == NULL || !lua_getmetatable(L, arg))
    return NULL;
  if (!lua_rawequal(L, -1, lua_upvalueindex(RATIONAL_META)))
    x = NULL;
  lua_pop(L, 1);
  return x;
}

int rational_is(lua_State *L, int arg) {
  return at(L, arg) != NULL;
}

int rational_view_of(lua_State *L, int arg, struct rational_view *view) {
  if (lua_isinteger(L, arg)) {
    const lua_Integer n = lua_tointeger(L, arg);
    view->limb = n < 0 ? (mp_limb_t)0 - (mp_limb_t)n : (mp_limb_t)n;
    mpz_roinit_n(mpq_numref(view->q), &view->limb, n < 0 ? -1 : n > 0);
    mpz_roinit_n(mpq_denref(view->q), one_limb, 1);
    return 1;
  }
  const struct rational *x = at(L, arg);
  if (x == NULL)
    return 0;
  mpz_roinit_n(mpq_numref(view->q), x->limb, x->num);
  mpz_roinit_n(mpq_denref(view->q), x->limb + size_of(x->num), x->den);
  rational_work((size_t)(size_of(x->num) + x->den), 1);
  return 1;
}

mpq_srcptr rational_arg(lua_State *L, int arg, struct rational_view *view) {
  if (!rational_view_of(L, arg, view))
    luaL_typeerror(L, arg, "rational or integer");
  return view->q;
}

/* A new userdata with a copy of q, without its metatable. */
static void make(lua_State *L, mpq_srcptr q) {
  const mpz_srcptr num = mpq_numref(q), den = mpq_denref(q);
  const size_t n = mpz_size(num), d = mpz_size(den);
  struct rational *x = lua_newuserdatauv(L, sizeof *x + (n + d) * sizeof(mp_limb_t), 0);
  x->num = mpz_sgn(num) < 0 ? -(int)n : (int)n;
  x->den = (int)d;
  if (n > 0)
    memcpy(x->limb, mpz_limbs_read(num), n * sizeof(mp_limb_t));
  memcpy(x->limb + n, mpz_limbs_read(den), d * sizeof(mp_limb_t));
}

void rational_make_small(lua_State *L, int meta) {
  mpq_t q;
  mpq_init(q);
  lua_createtable(L, RATIONAL_SMALL, RATIONAL_SMALL + 1);
  for (long n = -RATIONAL_SMALL; n <= RATIONAL_SMALL; n++) {
    mpq_set_si(q, n, 1);
    make(L, q);
    lua_pushvalue(L, meta);
    lua_setmetatable(L, -2);
    lua_rawseti(L, -2, n);
  }
  mpq_clear(q);
}

int rational_is_small(mpq_srcptr q) {
  return mpz_cmp_ui(mpq_denref(q), 1) == 0 && mpz_cmpabs_ui(mpq_numref(q), RATIONAL_SMALL) <= 0;
}

int rational_push(lua_State *L, mpq_srcptr q) {
  const mpz_srcptr num = mpq_numref(q), den = mpq_denref(q);
  if (rational_is_small(q)) {
    lua_rawgeti(L, lua_upvalueindex(RATIONAL_KEPT), mpz_get_si(num));
    return 1;
  }
  if (mpz_sizeinbase(num, 2) > RATIONAL_MAX_BITS || mpz_sizeinbase(den, 2) > RATIONAL_MAX_BITS)
    return luaL_error(L, "number too large");
  make(L, q);
  lua_pushvalue(L, lua_upvalueindex(RATIONAL_META));
  lua_setmetatable(L, -2);
  return 1;
}
