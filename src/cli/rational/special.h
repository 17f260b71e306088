/* special.h - functions of rationals that MPFR lacks, rounded to the precision of y.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Not proven to be rounded correctly: the error before the last rounding is below 2^-25 units of
 * the last bit.  y is NaN outside the domain, which for the ellipsoid is that all arguments are
 * positive; the others take every number.
 */
#ifndef POLHODE_RATIONAL_SPECIAL_H
#define POLHODE_RATIONAL_SPECIAL_H

#include <gmp.h>
#include <mpfr.h>

/* Area of the ellipsoid of semi-axes arg[0..2], divided by 4 pi. */
void rational_ellipsoid_area(mpfr_ptr y, mpq_srcptr const arg[3]);

/* Mean over its surface of the square of the unit normal's component along arg[0]'s axis. */
void rational_ellipsoid_normal(mpfr_ptr y, mpq_srcptr const arg[3]);

/* Means over t in [-h, h], h = arg[0]: of sin^2 t, of (cos t)^2 about its mean, of t sin t. */
void rational_arc_across(mpfr_ptr y, mpq_srcptr const arg[1]);
void rational_arc_along(mpfr_ptr y, mpq_srcptr const arg[1]);
void rational_arc_lever(mpfr_ptr y, mpq_srcptr const arg[1]);

/* Catenary cosh x, -u <= x <= u, u = arg[0], of half length s = sinh u: mean height over the vertex
 * divided by s; variance of x divided by u^2; variance of the height divided by s^2. */
void rational_catenary_rise(mpfr_ptr y, mpq_srcptr const arg[1]);
void rational_catenary_width(mpfr_ptr y, mpq_srcptr const arg[1]);
void rational_catenary_height(mpfr_ptr y, mpq_srcptr const arg[1]);

#endif
