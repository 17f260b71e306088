%% -- sweep_math.c -- logarithm, exponential, sine and cosine of a sweep's values.  SPDX-License-Identifier: MIT-0
/* sweep_math.c -- functions that have the same bits on every machine, whatever its C library.
 * template: templates/sweep/sweep_math.c.  SPDX-License-Identifier: MIT-0 */
#include "sweep.h"

#include <math.h>
#include <string.h>

typedef double own_real;

${functions_source}

double sweep_math_log(double x) { return own_log(x); }
double sweep_math_exp(double x) { return own_exp(x); }
double sweep_math_sin(double x) { return own_sin(x); }
double sweep_math_cos(double x) { return own_cos(x); }
