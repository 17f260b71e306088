/* rational.h - exact rational numbers as Lua userdata: what the files of this folder share.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A number is one immutable userdata that carries its GMP limbs behind a small head: numerator
 * first, denominator (positive) after it, in lowest terms.  Operands are looked at in place with
 * mpz_roinit_n; results are computed in the scratch numbers of the module (upvalue 1 of every
 * function) and copied. So a Lua error thrown anywhere leaks nothing, Lua's allocator counts every
 * limb that lives on, and no number needs a __gc.  Scratch numbers may be clobbered by any later
 * call: never keep a pointer.
 */
#ifndef POLHODE_RATIONAL_H
#define POLHODE_RATIONAL_H

#include <gmp.h>
#include <lua.h>
#include <stddef.h>

/* No numerator or denominator is larger: a scene such as 2^2^2^2^2^2 ends in an error, not in a
 * swap storm. */
#define RATIONAL_MAX_BITS 1000000

#define RATIONAL_TYPE "rational"

/* What every function of the module has: the scratch numbers, the metatable of rationals, and the
   whole numbers up to RATIONAL_SMALL, of which there is one each: most exponents and coefficients
   are among them. */
enum { RATIONAL_SCRATCH = 1, RATIONAL_META, RATIONAL_KEPT, RATIONAL_UPVALUES = RATIONAL_KEPT };
enum { RATIONAL_SMALL = 32 };

struct rational_scratch {
  mpq_t q, r;
  mpz_t a, b, c, d;
};

/* An operand: a view of a userdata's limbs, or of a Lua integer kept in `limb`. Lives on the C
 * stack. */
struct rational_view {
  mpq_t q;
  mp_limb_t limb;
};

/* Where set, told of work beyond what an instruction of Lua usually takes, in such instructions: an
   estimate from sizes, the same on every machine. */
extern void (*rational_charge)(double instructions);
/* One more use of `limbs` limbs, `times` products of them. */
void rational_work(size_t limbs, double times);

struct rational_scratch *rational_scratch(lua_State *L);

/* Is the value at `arg` a rational? */
int rational_is(lua_State *L, int arg);

/* The operand at `arg` as a view, or 0 when it is neither a rational nor a Lua integer. */
int rational_view_of(lua_State *L, int arg, struct rational_view *view);

/* Argument `arg` as a rational; a Lua integer is lifted; anything else is an argument error. */
mpq_srcptr rational_arg(lua_State *L, int arg, struct rational_view *view);

/* Push a copy of q (canonical); raises "number too large" beyond RATIONAL_MAX_BITS. Returns 1. */
int rational_push(lua_State *L, mpq_srcptr q);

/* Is q one of the whole numbers of which there is one object each? */
int rational_is_small(mpq_srcptr q);

/* Push the table of the small whole numbers; `meta`: where their metatable is. */
void rational_make_small(lua_State *L, int meta);

/* floor(log2 |q|), q not 0. */
long rational_log2(struct rational_scratch *s, mpq_srcptr q);

/* Parse text into q (canonical); NULL when it went well, else why not. */
const char *rational_parse(struct rational_scratch *s, mpq_ptr q, const char *text, size_t len);

/* The functions of the module, a file each. */
int rational_lua_parse(lua_State *L);
int rational_lua_decimal(lua_State *L);
int rational_lua_tostring(lua_State *L);
int rational_lua_todouble(lua_State *L);
int rational_lua_tofloat(lua_State *L);
int rational_lua_fromdouble(lua_State *L);
int rational_lua_round(lua_State *L);
int rational_lua_log2(lua_State *L);
int rational_lua_apply(lua_State *L);

int luaopen_polhode_rational(lua_State *L);

#endif
