/* text.c - rational numbers as text: parse, print, and "the decimal that was typed".
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 *     number   = [sign] (digits "/" digits | decimal [("e" | "E") [sign] digits])
 *     decimal  = digits ["." [digits]] | "." digits
 *
 * No blanks, no hexadecimal, no "inf".  The text is exact: "1.5e-3" is 3/2000.  Lengths and
 * exponents are bounded by RATIONAL_MAX_BITS before anything is computed, so hostile text costs
 * nothing.
 */
#include "rational.h"

#include <lauxlib.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* 10^301030 < 2^1000000 < 10^301031: no number within the bound has more digits or a larger
 * exponent. */
#define MAX_DIGITS 301031

static const char too_large[] = "number too large";
static const char malformed[] = "malformed number";

static size_t count_digits(const char *p, const char *end) {
  const char *start = p;
  while (p < end && *p >= '0' && *p <= '9')
    p++;
  return (size_t)(p - start);
}

/* z = the decimal digits text[0..n); n > 0. Subquadratic in n through mpz_set_str. */
static const char *set_digits(mpz_ptr z, const char *text, size_t n) {
  if (n > MAX_DIGITS)
    return too_large;
  char small[64];
  char *copy = n < sizeof small ? small : malloc(n + 1);
  if (copy == NULL)
    return "not enough memory";
  memcpy(copy, text, n);
  copy[n] = '\0';
  mpz_set_str(z, copy, 10);
  if (copy != small)
    free(copy);
  return NULL;
}

/* z = z * 10^n + digits: appends the fraction's digits to the whole part's. */
static const char *append_digits(struct rational_scratch *s, mpz_ptr z, const char *text,
                                 size_t n) {
  if (n == 0)
    return NULL;
  const char *bad = set_digits(s->a, text, n);
  if (bad != NULL)
    return bad;
  mpz_ui_pow_ui(s->b, 10, n);
  mpz_mul(z, z, s->b);
  mpz_add(z, z, s->a);
  return NULL;
}

/* The exponent text p..end into *exponent, clamped where the answer is "too large" anyway. */
static const char *parse_exponent(const char *p, const char *end, long *exponent) {
  int negative = 0;
  if (p < end && (*p == '+' || *p == '-'))
    negative = *p++ == '-';
  const size_t n = count_digits(p, end);
  if (n == 0 || p + n != end)
    return malformed;
  long e = 0;
  for (; p < end; p++)
    e = e > 2 * MAX_DIGITS ? e : 10 * e + (*p - '0');
  *exponent = negative ? -e : e;
  return NULL;
}

static const char *parse_decimal(struct rational_scratch *s, mpq_ptr q, const char *p,
                                 const char *end) {
  const size_t whole = count_digits(p, end);
  const char *digits = p;
  const char *fraction_at = p + whole;
  size_t fraction = 0;
  long exponent = 0;
  p += whole;
  if (p < end && *p == '.') {
    fraction_at = ++p;
    fraction = count_digits(p, end);
    p += fraction;
  }
  if (whole + fraction == 0)
    return malformed;
  if (p < end && (*p == 'e' || *p == 'E')) {
    const char *bad = parse_exponent(p + 1, end, &exponent);
    if (bad != NULL)
      return bad;
  } else if (p != end) {
    return malformed;
  }
  mpz_set_ui(mpq_numref(q), 0);
  const char *bad = whole > 0 ? set_digits(mpq_numref(q), digits, whole) : NULL;
  if (bad == NULL && fraction > MAX_DIGITS)
    bad = too_large;
  if (bad == NULL)
    bad = append_digits(s, mpq_numref(q), fraction_at, fraction);
  if (bad != NULL)
    return bad;
  mpz_set_ui(mpq_denref(q), 1);
  exponent -= (long)fraction;
  if (mpz_sgn(mpq_numref(q)) == 0)
    return NULL; /* 0e999999999 is 0 */
  if (exponent > MAX_DIGITS || exponent < -2 * MAX_DIGITS)
    return too_large;
  mpz_ui_pow_ui(s->a, 10, (unsigned long)labs(exponent));
  if (exponent > 0)
    mpz_mul(mpq_numref(q), mpq_numref(q), s->a);
  else
    mpz_set(mpq_denref(q), s->a);
  mpq_canonicalize(q);
  return NULL;
}

static const char *parse_quotient(mpq_ptr q, const char *p, size_t num, const char *end) {
  const char *den_at = p + num + 1;
  const size_t den = count_digits(den_at, end);
  if (num == 0 || den == 0 || den_at + den != end)
    return malformed;
  const char *bad = set_digits(mpq_numref(q), p, num);
  if (bad == NULL)
    bad = set_digits(mpq_denref(q), den_at, den);
  if (bad != NULL)
    return bad;
  if (mpz_sgn(mpq_denref(q)) == 0) {
    mpz_set_ui(mpq_denref(q), 1);
    return "division by zero";
  }
  mpq_canonicalize(q);
  return NULL;
}

const char *rational_parse(struct rational_scratch *s, mpq_ptr q, const char *text, size_t len) {
  const char *p = text, *end = text + len;
  int negative = 0;
  if (p < end && (*p == '+' || *p == '-'))
    negative = *p++ == '-';
  const size_t whole = count_digits(p, end);
  const char *bad = p + whole < end && p[whole] == '/' ? parse_quotient(q, p, whole, end)
                                                       : parse_decimal(s, q, p, end);
  if (bad == NULL && (mpz_sizeinbase(mpq_numref(q), 2) > RATIONAL_MAX_BITS ||
                      mpz_sizeinbase(mpq_denref(q), 2) > RATIONAL_MAX_BITS))
    bad = too_large;
  if (bad == NULL && negative)
    mpq_neg(q, q);
  return bad;
}

int rational_lua_parse(lua_State *L) {
  struct rational_scratch *s = rational_scratch(L);
  size_t len;
  luaL_checktype(L, 1, LUA_TSTRING);
  const char *text = lua_tolstring(L, 1, &len);
  const char *bad = rational_parse(s, s->q, text, len);
  if (bad == NULL)
    return rational_push(L, s->q);
  lua_pushnil(L);
  lua_pushstring(L, bad);
  return 2;
}

/* ---- decimal(x): what the author of a literal meant ---- */

/* Raise the last place of the digits in "d.ddde+xx" by one; 0 when the carry leaves the first
 * digit. */
static int next_decimal(char *text) {
  char *p = strchr(text, 'e');
  while (--p >= text) {
    if (*p < '0' || *p > '9')
      continue; /* point or sign */
    if (*p < '9') {
      ++*p;
      return 1;
    }
    *p = '0';
  }
  return 0;
}

/* Shortest decimal that reads back to x.  With n digits the nearest decimal is tried, then its
 * neighbour away from zero: just above a power of two the interval that reads back is twice as wide
 * as below, so the nearest may miss where the next one hits (2^-44 = 5.684341886080802e-14 needs 16
 * digits only that way). */
static void shortest(double x, char text[32]) {
  for (int n = 0; n < 17; n++) {
    snprintf(text, 32, "%.*e", n, x);
    if (strtod(text, NULL) == x || (next_decimal(text) && strtod(text, NULL) == x))
      return;
  }
}

int rational_lua_decimal(lua_State *L) {
  struct rational_scratch *s = rational_scratch(L);
  struct rational_view a;
  if (lua_isinteger(L, 1))
    return rational_push(L, rational_arg(L, 1, &a));
  luaL_checktype(L, 1, LUA_TNUMBER);
  const double x = lua_tonumber(L, 1);
  luaL_argcheck(L, isfinite(x), 1, "finite number expected");
  char text[32];
  shortest(x, text);
  rational_parse(s, s->q, text, strlen(text));
  return rational_push(L, s->q);
}

/* ---- print ---- */

static size_t print_integer(char *out, mpz_srcptr z) {
  mpz_get_str(out, 10, z);
  return strlen(out);
}

int rational_lua_tostring(lua_State *L) {
  struct rational_view a;
  rational_arg(L, 1, &a);
  const mpz_srcptr num = mpq_numref(a.q), den = mpq_denref(a.q);
  luaL_Buffer buffer;
  char *out = luaL_buffinitsize(L, &buffer, mpz_sizeinbase(num, 10) + mpz_sizeinbase(den, 10) + 5);
  size_t n = print_integer(out, num);
  if (mpz_cmp_ui(den, 1) != 0) {
    out[n++] = '/';
    n += print_integer(out + n, den);
  }
  luaL_pushresultsize(&buffer, n);
  return 1;
}
