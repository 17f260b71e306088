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
  return lua_touserdata(L, lua_upvalueindex(1));
}

int rational_view_of(lua_State *L, int arg, struct rational_view *view) {
  if (lua_isinteger(L, arg)) {
    const lua_Integer n = lua_tointeger(L, arg);
    view->limb = n < 0 ? (mp_limb_t)0 - (mp_limb_t)n : (mp_limb_t)n;
    mpz_roinit_n(mpq_numref(view->q), &view->limb, n < 0 ? -1 : n > 0);
    mpz_roinit_n(mpq_denref(view->q), one_limb, 1);
    return 1;
  }
  const struct rational *x = luaL_testudata(L, arg, RATIONAL_TYPE);
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
  luaL_setmetatable(L, RATIONAL_TYPE);
  return 1;
}
