%% -- fitted.c -- a scene behind the table of fitted.h: steps with derivatives.  SPDX-License-Identifier: MIT-0
/* fitted.c -- ${name} behind the table of fitted.h, for the program polhode; not part of what is delivered.
 * template: templates/fit/fitted.c.  ${license} */
#include "${name}.h"
#include "fitted.h"

#include <math.h>
#include <stddef.h>

typedef ${name}_real real;

enum { STATES = ${state_count}, CONSTANTS = ${constant_count}, VALUES = ${value_count}, FREE = ${free_count}, LANES = ${lanes} };

${helpers}
/* One step, and its derivative along each direction; y: the new state, the same in every lane.
 * u: a time, what the inputs are then, and their slopes. */
static void along(const ${name}_model *m, real k0[][LANES], real t, const real x[], real s[][LANES], const real u[],
                  real y[][LANES], real h)
{
  int lane;
%% for _, line in ipairs(common) do
  ${line}
%% end

  (void)m;
  (void)k0;
  (void)t;
  (void)u;
  for (lane = 0; lane < LANES; lane++) {
%% for _, line in ipairs(loop) do
    ${line}
%% end
  }
}

static void advance(const void *model, const double *k0, double t, double *x, double *s, const double *u, double h,
                    long n)
{
  const ${name}_model *m = (const ${name}_model *)model;
  real c[${constant_room}][LANES], d[STATES][LANES], y[STATES][LANES];
  long j;
  int i, k;

  for (i = 0; i < CONSTANTS; i++) {
    for (k = 0; k < LANES; k++) c[i][k] = k0[i*LANES + k];
  }
  for (i = 0; i < STATES; i++) {
    for (k = 0; k < LANES; k++) d[i][k] = s[i*LANES + k];
  }
  for (j = 0; j < n; j++) {
    along(m, c, t + (double)j*h, x, d, u, y, h);
    for (i = 0; i < STATES; i++) x[i] = y[i][0];
  }
  for (i = 0; i < STATES; i++) {
    for (k = 0; k < LANES; k++) s[i*LANES + k] = d[i][k];
  }
}

static int init(void *m, const double *p) { return ${name}_init((${name}_model *)m, p); }

static void defaults(double *p) { ${name}_defaults(p); }

static void start(const void *model, double *x, double *s0, double *c0)
{
  const ${name}_model *m = (const ${name}_model *)model;
  real whole[${upper}_NX], k0[${constant_room}][LANES] = {{0}}, s[STATES][LANES] = {{0}};
  int i, k;

  ${name}_initial(m, whole);
%% for _, s in ipairs(states) do
  x[${s.row}] = whole[${s.place}];
%% end
%% for _, line in ipairs(constant_lines) do
  ${line}
%% end
%% for _, line in ipairs(start_lines) do
  ${line}
%% end
  for (i = 0; i < CONSTANTS; i++) {
    for (k = 0; k < LANES; k++) c0[i*LANES + k] = k0[i][k];
  }
  for (i = 0; i < STATES; i++) {
    for (k = 0; k < LANES; k++) s0[i*LANES + k] = s[i][k];
  }
}

static void measure(const double *p, double t, const double *x, const double *s, double *y, double *J)
{
  real G[${slope_room}];
  int lane;
%% for _, line in ipairs(measure_lines) do
  ${line}
%% end
  (void)G;
  for (lane = 0; lane < LANES; lane++) {
%% for _, line in ipairs(slope_loop) do
    ${line}
%% end
  }
%% for _, line in ipairs(slope_after) do
  ${line}
%% end
  (void)s;
  (void)J;
}

#if defined __GNUC__
__attribute__((visibility("default")))
#endif
const struct polhode_fitted *polhode_fitted(void);

const struct polhode_fitted *polhode_fitted(void)
{
  static const struct polhode_fitted table = {
    POLHODE_FITTED_ABI, ${upper}_NP, FREE, STATES, CONSTANTS, VALUES, LANES, ${attitude}, ${input_count},
    (unsigned long)sizeof(${name}_model), defaults, init, start, advance, measure,
  };

  return &table;
}
