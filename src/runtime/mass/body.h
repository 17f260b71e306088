/* body.h - how a body is stored: one rounding, one place for the two-part centre of mass.
   SPDX-License-Identifier: GPL-3.0-or-later

   Private to the library. */
#ifndef BODY_H
#define BODY_H

#include "numbers/wide.h"

/* Fill *b from long doubles; the centre is at + off, where off may be tiny against at. tensor NULL:
   it follows from the second moments. PH_ERANGE, PH_EMASS (mass not positive, also by
   underflow). */
int body_store(ph_body *b, ph_wide mass, const double at[3], const ph_wide off[3],
               const ph_wide second[6], const ph_wide tensor[6]);

/* The rules for n particles (particles.c): PH_ECOUNT, PH_EFINITE, PH_EMASS. */
int particles_check(int n, const double m[], const double r[]);

#endif
