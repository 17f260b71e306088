/* shape.h - from a geometry to a body: the checks and the mass, for all files that make shapes.
   SPDX-License-Identifier: GPL-3.0-or-later

   Private to the library. */
#ifndef SHAPE_H
#define SHAPE_H

#include "body.h"
#include "geometry/geometry.h"

/* The rules that come first: PH_EFINITE, PH_EMASS. */
int shape_amount(int n, const double number[], ph_amount a);
/* The body of that amount. */
int shape_store(ph_body *b, ph_amount a, geometry *g);

#endif
