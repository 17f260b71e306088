/* rational_special.h - functions of rationals that MPFR lacks, rounded to the precision of y.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Not proven to be rounded correctly: the error before the last rounding is below 2^-30 units of
 * the last bit.  y is NaN outside the domain, which is that all arguments are positive.
 */
#ifndef POLHODE_RATIONAL_SPECIAL_H
#define POLHODE_RATIONAL_SPECIAL_H

#include <gmp.h>
#include <mpfr.h>

/* Area of the ellipsoid of semi-axes arg[0..2], divided by 4 pi. */
void rational_ellipsoid_area(mpfr_ptr y, mpq_srcptr const arg[3]);

/* Mean over its surface of the square of the unit normal's component along arg[0]'s axis. */
void rational_ellipsoid_normal(mpfr_ptr y, mpq_srcptr const arg[3]);

#endif
