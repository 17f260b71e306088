-- exercise.lua - C text that calls every emitted function of a scene at the edges of what is valid.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
-- Rest, pure spins, steps of length zero and of both signs, long times, zero and NaN states, parameters of every kind:
-- for valid input every result must be finite, for invalid input the answer must be a status and the output untouched.
-- Built with sanitizers, so that a division by zero or an uninitialised read ends the program.

local exercise = {}

local template = [[
#include "NAME.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

static int failures;

static void expect(int ok, const char *what, int line)
{
  if (ok) return;
  failures++;
  printf("line %d: %s\n", line, what);
}
#define EXPECT(condition) expect((condition) != 0, #condition, __LINE__)

static int finite_all(int n, const NAME_real *v)
{
  int i;

  for (i = 0; i < n; i++) {
    if (!(v[i] - v[i] == 0)) return 0;
  }
  return 1;
}

static int unit(const NAME_real *x)
{
  const double n = (double)x[0]*(double)x[0] + (double)x[1]*(double)x[1] + (double)x[2]*(double)x[2]
    + (double)x[3]*(double)x[3];

  return n > 0.999 && n < 1.001;
}

static void at_state(const NAME_model *m, const NAME_real *x0, NAME_real scale)
{
  static const double steps[] = {0.0, 1.0/64, -1.0/64, 1e-30, -1e-30, 1e-300};
  NAME_real x[UPPER_NX], dx[UPPER_NX], J[UPPER_NX*UPPER_NX], v[3], w[3], y[3];
  const NAME_real u[UPPER_NU + 1] = {0};
  unsigned i;

  NAME_rhs(m, 0, x0, UPPER_NU > 0 ? u : 0, dx);
  EXPECT(finite_all(UPPER_NX, dx));
  NAME_jacobian(m, 0, x0, u, J);
  EXPECT(finite_all(UPPER_NX*UPPER_NX, J));
  v[0] = NAME_energy(m, x0);
  EXPECT(finite_all(1, v));
  NAME_momentum(m, x0, v);
  EXPECT(finite_all(3, v));
  NAME_momentum_body(m, x0, v);
  EXPECT(finite_all(3, v));
  for (i = 0; i < 3; i++) w[i] = x0[4 + i];
  NAME_torque(m, w, dx + 4, v);
  EXPECT(finite_all(3, v));
  NAME_rate(w, v, dx + 4, y);
  EXPECT(finite_all(3, y));
  for (i = 0; i < sizeof steps/sizeof steps[0]; i++) {
    const NAME_real h = (NAME_real)steps[i]/scale;

    memcpy(x, x0, sizeof x);
    NAME_step(m, 0, x, u, h);
    EXPECT(finite_all(UPPER_NX, x) && unit(x));
    if (steps[i] == 0.0) EXPECT(memcmp(x + 4, x0 + 4, 3*sizeof x[0]) == 0);
  }
#ifdef CLOSED
  {
    NAME_orbit o;
#ifdef DAMPED
    const double times[] = {0.0, 1.0, -1.0, 1e6}; /* far back its rates were beyond the range */
#else
    const double times[] = {0.0, 1.0, -1.0, 1e6, -1e6};
#endif

    EXPECT(NAME_solve(&o, m, x0) == 0);
    for (i = 0; i < sizeof times/sizeof times[0]; i++) {
      NAME_at(&o, (NAME_real)times[i]/scale, x);
      EXPECT(finite_all(UPPER_NX, x) && unit(x));
    }
  }
#endif
}

int main(void)
{
  NAME_model m, before;
  NAME_real x[UPPER_NX], p[UPPER_NP + 1], moments[3], axes[9], I[6], a[3] = {1, -2, 3}, com[3], w[3], Omega[2], rate;
  NAME_real scale = 1;
  const NAME_real zero = 0;
  const NAME_real bad[4] = {(NAME_real)NAN, (NAME_real)INFINITY, -(NAME_real)INFINITY, -1};
  int i, k;

  EXPECT(NAME_init(&m, 0) == 0);
  NAME_defaults(p);
  EXPECT(NAME_init(&m, p) == 0);

  /* parameters that cannot be: refused with a status and the model untouched, or accepted and finite */
  for (i = 0; i < UPPER_NP; i++) {
    for (k = 0; k < 5; k++) {
      NAME_defaults(p);
      p[i] = k < 4 ? bad[k] : zero;
      before = m;
      if (NAME_init(&m, p) != 0) {
        EXPECT(memcmp(&before, &m, sizeof m) == 0);
      } else {
        EXPECT(k >= 3);
        NAME_inertia(&m, I);
        EXPECT(finite_all(6, I));
      }
    }
    EXPECT(NAME_init(&m, 0) == 0);
  }

  NAME_inertia(&m, I);
  EXPECT(finite_all(6, I));
  com[0] = NAME_mass(&m, com);
  EXPECT(finite_all(3, com));
  NAME_inertia_at(&m, a, I);
  EXPECT(finite_all(6, I));
  NAME_principal(&m, moments, axes);
  EXPECT(finite_all(3, moments) && finite_all(9, axes));
  EXPECT(moments[0] <= moments[1] && moments[1] <= moments[2]);
  for (i = 0; i < 3; i++) {
    for (k = 0; k < 3; k++) {
      const double d = (double)axes[3*i]*(double)axes[3*k] + (double)axes[3*i + 1]*(double)axes[3*k + 1]
        + (double)axes[3*i + 2]*(double)axes[3*k + 2];

      EXPECT(d - (i == k) < 1e-5 && d - (i == k) > -1e-5);
    }
  }

  NAME_initial(&m, x);
  for (i = 4; i < 7; i++) {
    if (x[i] > scale || scale == 1) scale = x[i] > 0 ? x[i] : -x[i] > 0 ? -x[i] : scale;
  }
  for (k = 0; k < 3; k++) {
    for (i = 0; i < 3; i++) w[i] = i == k ? scale : zero;
    EXPECT(NAME_stability(moments, k, scale, Omega, &rate) >= -1);
    EXPECT(finite_all(2, Omega) && finite_all(1, &rate));
    EXPECT(NAME_stability(moments, k, 0, Omega, &rate) == 0 && rate == 0);
    for (i = 0; i < 2; i++) EXPECT(NAME_spin_stable(&m, k, i) >= -1 && NAME_spin_stable(&m, k, i) <= 1);
    NAME_linearised(moments, k, w, 1/scale, a);
    EXPECT(finite_all(3, a) && a[k] == scale);
    NAME_linearised(moments, k, w, 0, a);
    EXPECT(finite_all(3, a));
  }

  at_state(&m, x, scale);
  for (k = 0; k < 4; k++) { /* at rest, and pure spins */
    x[0] = 0;
    x[1] = (NAME_real)0.6;
    x[2] = (NAME_real)-0.8;
    x[3] = 0;
    for (i = 0; i < 3; i++) x[4 + i] = i == k ? scale : zero;
    at_state(&m, x, scale);
  }
  for (k = 0; k < 3; k++) { /* rates that are almost nothing */
    x[4 + k] = scale*(NAME_real)1e-30;
    at_state(&m, x, scale);
  }
#ifdef CLOSED
  {
    NAME_orbit o, kept;

    memset(&o, 0, sizeof o);
    kept = o;
    x[0] = x[1] = x[2] = x[3] = 0;
    EXPECT(NAME_solve(&o, &m, x) != 0);
    x[0] = (NAME_real)NAN;
    EXPECT(NAME_solve(&o, &m, x) != 0);
    x[0] = 1;
    x[5] = (NAME_real)INFINITY;
    EXPECT(NAME_solve(&o, &m, x) != 0);
    EXPECT(memcmp(&o, &kept, sizeof o) == 0);
  }
#endif
  if (failures == 0) printf("fine\n");
  return failures != 0;
}
]]

-- What is left of it for a point: its own states, at rest and not, steps of both signs, the closed form.
local point = [[
#include "NAME.h"
#include <math.h>
#include <stdio.h>

int main(void)
{
  static const double steps[] = {0.0, 1.0/64, -1.0/64, 1e-30, 1e6, -1e6};
  NAME_model m;
  NAME_real x0[UPPER_NX], x[UPPER_NX], J[UPPER_NX*UPPER_NX], E;
  int failures = NAME_init(&m, 0) != 0, n, k, rest;
  unsigned i;

  for (rest = 0; rest < 2; rest++) {
    NAME_initial(&m, x0);
    for (k = 0; k < UPPER_NX && rest; k++) x0[k] = 0;
    NAME_rhs(&m, 0, x0, 0, x);
    NAME_jacobian(&m, 0, x0, 0, J);
    E = NAME_energy(&m, x0);
    failures += !(E - E == 0);
    for (n = 0; n < UPPER_NX; n++) failures += !(x[n] - x[n] == 0);
    for (n = 0; n < UPPER_NX*UPPER_NX; n++) failures += !(J[n] - J[n] == 0);
    for (i = 0; i < sizeof steps/sizeof steps[0]; i++) {
#ifdef CLOSED
      NAME_orbit o;

      failures += NAME_solve(&o, &m, x0) != 0;
      NAME_at(&o, (NAME_real)steps[i], x);
#else
      for (n = 0; n < UPPER_NX; n++) x[n] = x0[n];
      NAME_step(&m, 0, x, 0, (NAME_real)(i < 4 ? steps[i] : 0.25));
#endif
      for (n = 0; n < UPPER_NX; n++) failures += !(x[n] - x[n] == 0);
    }
  }
  printf("%d\n", failures);
  return failures != 0;
}
]]

-- The program for scene `name`, whose header is given.
function exercise.text(name, header)
  local turns = header:find(name .. "_momentum(", 1, true)
  local text = (turns and template or point):gsub("NAME", name):gsub("UPPER", name:upper())
  local full = header:find(name .. "_at(const", 1, true)
  local damped = full and not header:find(name .. "_at_tick(", 1, true)
  return (full and "#define CLOSED\n" or "") .. (damped and "#define DAMPED\n" or "") .. text
end

return exercise
