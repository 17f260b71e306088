/* means.c - means over arcs and catenaries to any number of bits.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Elementary closed forms: of an arc by half its angle h, of a catenary by half its span u in units
 * of its scale, where s = sinh(u) is half its length.  For a short curve their terms cancel, so
 * each is summed with the largest term noted, and what was lost is added to the working precision
 * of another try.
 */
#include "special.h"

#define GUARD 64

/* One try: the argument, the sum so far, the exponent of the largest term, room to work in. */
struct sum {
  mpfr_t x, total, a, b, c;
  mpfr_exp_t largest;
};

typedef void terms(struct sum *s);

static void add(struct sum *s, mpfr_srcptr term) {
  if (mpfr_regular_p(term) && mpfr_get_exp(term) > s->largest)
    s->largest = mpfr_get_exp(term);
  mpfr_add(s->total, s->total, term, MPFR_RNDN);
}

static void add_half(struct sum *s) {
  mpfr_set_ui_2exp(s->c, 1, -1, MPFR_RNDN);
  add(s, s->c);
}

/* term = sin(m x)/(m x) */
static void sinc(mpfr_ptr term, struct sum *s, unsigned long m) {
  mpfr_mul_ui(s->c, s->x, m, MPFR_RNDN);
  mpfr_sin(term, s->c, MPFR_RNDN);
  mpfr_div(term, term, s->c, MPFR_RNDN);
}

/* 1/2 - sin(2 h)/(4 h) */
static void arc_across(struct sum *s) {
  add_half(s);
  sinc(s->a, s, 2);
  mpfr_div_si(s->a, s->a, -2, MPFR_RNDN);
  add(s, s->a);
}

/* 1/2 + sin(2 h)/(4 h) - (sin(h)/h)^2 */
static void arc_along(struct sum *s) {
  add_half(s);
  sinc(s->a, s, 2);
  mpfr_div_ui(s->a, s->a, 2, MPFR_RNDN);
  add(s, s->a);
  sinc(s->a, s, 1);
  mpfr_sqr(s->a, s->a, MPFR_RNDN);
  mpfr_neg(s->a, s->a, MPFR_RNDN);
  add(s, s->a);
}

/* sin(h)/h - cos(h) */
static void arc_lever(struct sum *s) {
  sinc(s->a, s, 1);
  add(s, s->a);
  mpfr_cos(s->a, s->x, MPFR_RNDN);
  mpfr_neg(s->a, s->a, MPFR_RNDN);
  add(s, s->a);
}

/* coth(u)/2 + u/(2 s^2) - 1/s */
static void catenary_rise(struct sum *s) {
  mpfr_coth(s->a, s->x, MPFR_RNDN);
  mpfr_div_ui(s->a, s->a, 2, MPFR_RNDN);
  add(s, s->a);
  mpfr_csch(s->b, s->x, MPFR_RNDN);
  mpfr_sqr(s->a, s->b, MPFR_RNDN);
  mpfr_mul(s->a, s->a, s->x, MPFR_RNDN);
  mpfr_div_ui(s->a, s->a, 2, MPFR_RNDN);
  add(s, s->a);
  mpfr_neg(s->b, s->b, MPFR_RNDN);
  add(s, s->b);
}

/* 1 - 2 coth(u)/u + 2/u^2 */
static void catenary_width(struct sum *s) {
  mpfr_set_ui(s->a, 1, MPFR_RNDN);
  add(s, s->a);
  mpfr_coth(s->a, s->x, MPFR_RNDN);
  mpfr_div(s->a, s->a, s->x, MPFR_RNDN);
  mpfr_mul_si(s->a, s->a, -2, MPFR_RNDN);
  add(s, s->a);
  mpfr_sqr(s->a, s->x, MPFR_RNDN);
  mpfr_ui_div(s->a, 2, s->a, MPFR_RNDN);
  add(s, s->a);
}

/* 1/12 + 3/(4 s^2) - u coth(u)/(2 s^2) - u^2/(4 s^4) */
static void catenary_height(struct sum *s) {
  mpfr_set_ui(s->a, 1, MPFR_RNDN);
  mpfr_div_ui(s->a, s->a, 12, MPFR_RNDN);
  add(s, s->a);
  mpfr_csch(s->b, s->x, MPFR_RNDN);
  mpfr_sqr(s->b, s->b, MPFR_RNDN);
  mpfr_mul_ui(s->a, s->b, 3, MPFR_RNDN);
  mpfr_div_ui(s->a, s->a, 4, MPFR_RNDN);
  add(s, s->a);
  mpfr_coth(s->a, s->x, MPFR_RNDN);
  mpfr_mul(s->a, s->a, s->x, MPFR_RNDN);
  mpfr_mul(s->a, s->a, s->b, MPFR_RNDN);
  mpfr_div_si(s->a, s->a, -2, MPFR_RNDN);
  add(s, s->a);
  mpfr_mul(s->a, s->x, s->b, MPFR_RNDN);
  mpfr_sqr(s->a, s->a, MPFR_RNDN);
  mpfr_div_si(s->a, s->a, -4, MPFR_RNDN);
  add(s, s->a);
}

/* Bits that one try at the working precision `work` has lost; more than all if nothing is left. */
static mpfr_exp_t attempt(mpfr_ptr y, mpq_srcptr x, terms *f, mpfr_prec_t work) {
  struct sum s = {.largest = mpfr_get_emin()};
  mpfr_inits2(work, s.x, s.total, s.a, s.b, s.c, (mpfr_ptr)NULL);
  mpfr_set_q(s.x, x, MPFR_RNDN);
  mpfr_set_zero(s.total, 1);
  f(&s);
  const mpfr_exp_t lost = mpfr_regular_p(s.total) ? s.largest - mpfr_get_exp(s.total) : work;
  mpfr_set(y, s.total, MPFR_RNDN);
  mpfr_clears(s.x, s.total, s.a, s.b, s.c, (mpfr_ptr)NULL);
  return lost;
}

/* The error of a try is some 10 units of the largest term's last bit, and the argument's as much:
 * half of GUARD covers that and leaves less than 2^-25 of y's last bit, the other half is there for
 * the cancellation that every argument has. */
static void mean(mpfr_ptr y, mpq_srcptr x, terms *f) {
  if (mpq_sgn(x) == 0) { /* the limits: only the width has another than 0 */
    mpfr_set_ui(y, f == catenary_width, MPFR_RNDN);
    mpfr_div_ui(y, y, 3, MPFR_RNDN);
    return;
  }
  /* a large argument is rounded as a whole, and its sine depends on what is left of it */
  mpfr_t size;
  mpfr_init2(size, 2);
  mpfr_set_q(size, x, MPFR_RNDN);
  const mpfr_exp_t whole = mpfr_get_exp(size) > 0 ? mpfr_get_exp(size) : 0;
  mpfr_clear(size);
  const mpfr_prec_t enough = mpfr_get_prec(y) + whole + GUARD / 2;
  mpfr_prec_t work = enough + GUARD / 2;
  for (mpfr_exp_t lost; (lost = attempt(y, x, f, work)) > work - enough;)
    work += lost;
}

void rational_arc_across(mpfr_ptr y, mpq_srcptr const arg[1]) {
  mean(y, arg[0], arc_across);
}

void rational_arc_along(mpfr_ptr y, mpq_srcptr const arg[1]) {
  mean(y, arg[0], arc_along);
}

void rational_arc_lever(mpfr_ptr y, mpq_srcptr const arg[1]) {
  mean(y, arg[0], arc_lever);
}

void rational_catenary_rise(mpfr_ptr y, mpq_srcptr const arg[1]) {
  mean(y, arg[0], catenary_rise);
}

void rational_catenary_width(mpfr_ptr y, mpq_srcptr const arg[1]) {
  mean(y, arg[0], catenary_width);
}

void rational_catenary_height(mpfr_ptr y, mpq_srcptr const arg[1]) {
  mean(y, arg[0], catenary_height);
}
