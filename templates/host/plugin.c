/* plugin.c -- ${name} behind the table of plugin.h, for the program polhode; not part of what is delivered.
 * template: templates/host/plugin.c.  ${license} */
#include "${name}.h"
#include "plugin.h"

#include <stddef.h>

typedef ${name}_real real;

static void narrow(int n, const double *from, real *to)
{
  int i;

  for (i = 0; i < n; i++) to[i] = (real)from[i];
}

static void widen(int n, const real *from, double *to)
{
  int i;

  for (i = 0; i < n; i++) to[i] = (double)from[i];
}

static int plugin_init(void *m, const double *p)
{
  real q[${upper}_NP + 1] = {0};

  if (!p) return ${name}_init((${name}_model *)m, NULL);
  narrow(${upper}_NP, p, q);
  return ${name}_init((${name}_model *)m, q);
}

static void plugin_params(double *p)
{
  real q[${upper}_NP + 1] = {0};

  ${name}_defaults(q);
  widen(${upper}_NP, q, p);
}

%% if has_rates then
static void plugin_inertia(const void *m, double *I)
{
  real v[6];

  ${name}_inertia((const ${name}_model *)m, v);
  widen(6, v, I);
}

static int plugin_principal(const void *m, double *moments, double *axes)
{
  real v[3], a[9];

  if (${name}_principal((const ${name}_model *)m, v, a)) return 1;
  widen(3, v, moments);
  widen(9, a, axes);
  return 0;
}

%% end
static void plugin_rhs(const void *m, double t, const double *x, const double *u, double *dx)
{
  real y[${upper}_NX], v[${upper}_NU + 1] = {0}, d[${upper}_NX];

  narrow(${upper}_NX, x, y);
  if (u) narrow(${upper}_NU, u, v);
  ${name}_rhs((const ${name}_model *)m, (real)t, y, v, d);
  widen(${upper}_NX, d, dx);
}

%% for _, s in ipairs(steppers) do
static void plugin_${s.name}(const void *m, double t, double *x, const double *u, double h)
{
  real y[${upper}_NX], v[${upper}_NU + 1] = {0};

  narrow(${upper}_NX, x, y);
  if (u) narrow(${upper}_NU, u, v);
  ${name}_${s.step}((const ${name}_model *)m, (real)t, y, v, (real)h);
  widen(${upper}_NX, y, x);
}

static void plugin_${s.name}_march(const void *m, double t0, double *x, const double *u, double h, long n)
{
  const real start = (real)t0, size = (real)h;
  real y[${upper}_NX], v[${upper}_NU + 1] = {0};
  long i;

  narrow(${upper}_NX, x, y);
  if (u) narrow(${upper}_NU, u, v);
  for (i = 0; i < n; i++) ${name}_${s.step}((const ${name}_model *)m, start + (real)i*size, y, v, size);
  widen(${upper}_NX, y, x);
}

%%   if s.run then
static int plugin_${s.name}_run(const void *m, double t0, double *x, const double *u, double t1, double tolerance, int most)
{
  real y[${upper}_NX], v[${upper}_NU + 1] = {0};
  int steps;

  narrow(${upper}_NX, x, y);
  if (u) narrow(${upper}_NU, u, v);
  steps = ${name}_${s.name}_run((const ${name}_model *)m, (real)t0, y, v, (real)t1, (real)tolerance, most);
  widen(${upper}_NX, y, x);
  return steps;
}

%%   end
%% end
%% for _, order in ipairs(orders) do
void ${name}_taylor_step_of(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h, int top);

static void plugin_taylor${order}(const void *m, double t, double *x, const double *u, double h)
{
  real y[${upper}_NX], v[${upper}_NU + 1] = {0};

  narrow(${upper}_NX, x, y);
  if (u) narrow(${upper}_NU, u, v);
  ${name}_taylor_step_of((const ${name}_model *)m, (real)t, y, v, (real)h, ${order});
  widen(${upper}_NX, y, x);
}

static void plugin_taylor${order}_march(const void *m, double t0, double *x, const double *u, double h, long n)
{
  const real start = (real)t0, size = (real)h;
  real y[${upper}_NX], v[${upper}_NU + 1] = {0};
  long i;

  narrow(${upper}_NX, x, y);
  if (u) narrow(${upper}_NU, u, v);
  for (i = 0; i < n; i++) ${name}_taylor_step_of((const ${name}_model *)m, start + (real)i*size, y, v, size, ${order});
  widen(${upper}_NX, y, x);
}

%% end
static void plugin_jacobian(const void *m, double t, const double *x, const double *u, double *J)
{
  real y[${upper}_NX], v[${upper}_NU + 1] = {0}, j[${upper}_NX*${upper}_NX];

  narrow(${upper}_NX, x, y);
  if (u) narrow(${upper}_NU, u, v);
  ${name}_jacobian((const ${name}_model *)m, (real)t, y, v, j);
  widen(${upper}_NX*${upper}_NX, j, J);
}

static double plugin_energy(const void *m, const double *x)
{
  real y[${upper}_NX];

  narrow(${upper}_NX, x, y);
  return (double)${name}_energy((const ${name}_model *)m, y);
}

%% if has_integral then
static double plugin_integral(const void *m, double t, const double *x)
{
  real y[${upper}_NX];

  narrow(${upper}_NX, x, y);
  return (double)${name}_jacobi_integral((const ${name}_model *)m, (real)t, y);
}

%% end
%% if has_attitude then
static void plugin_momentum(const void *m, const double *x, double *L)
{
  real y[${upper}_NX], v[3];

  narrow(${upper}_NX, x, y);
  ${name}_momentum((const ${name}_model *)m, y, v);
  widen(3, v, L);
}
%% end
%% if has_closed then

static int plugin_solve(void *o, const void *m, const double *x0)
{
  real y[${upper}_NX];

  narrow(${upper}_NX, x0, y);
  return ${name}_solve((${name}_orbit *)o, (const ${name}_model *)m, y);
}

static void plugin_at(const void *o, double t, double *x)
{
%% if has_full then
  real y[${upper}_NX];

  ${name}_at((const ${name}_orbit *)o, (real)t, y);
%% elseif has_centre then
  real y[${upper}_NX] = {0}, v[2], W[3]; /* the closed form gives the centre of mass, and no attitude */

  ${name}_at_centre((const ${name}_orbit *)o, (real)t, y + ${upper}_P1, v, W);
%%   if has_speed then
  y[${upper}_V1] = v[0];
  y[${upper}_V2] = v[1];
%%   end
%% else
  real y[${upper}_NX] = {0}; /* the closed form gives the rates only */

  ${name}_at_rates((const ${name}_orbit *)o, (real)t, y + ${upper}_WX);
%% end
  widen(${upper}_NX, y, x);
}

static int plugin_solve_loop(void *o, const void *m, const double *x0, long n)
{
  real y[${upper}_NX];
  int refused = 0;
  long i;

  narrow(${upper}_NX, x0, y);
  for (i = 0; i < n; i++) {
    const int status = ${name}_solve((${name}_orbit *)o, (const ${name}_model *)m, y);

    if (status) refused = status;
  }
  return refused;
}

static void plugin_at_loop(const void *o, double t0, double h, double *x, long n)
{
  const real start = (real)t0, size = (real)h;
  real y[${upper}_NX] = {0};
  long i;

%% if has_full then
  for (i = 0; i < n; i++) ${name}_at((const ${name}_orbit *)o, start + (real)i*size, y);
%% elseif has_centre then
  for (i = 0; i < n; i++) {
    real v[2], W[3];

    ${name}_at_centre((const ${name}_orbit *)o, start + (real)i*size, y + ${upper}_P1, v, W);
  }
%% else
  for (i = 0; i < n; i++) ${name}_at_rates((const ${name}_orbit *)o, start + (real)i*size, y + ${upper}_WX);
%% end
  widen(${upper}_NX, y, x);
}
%%   if has_full then

static void plugin_many_loop(const void *o, double t0, double h, double *x, long n)
{
  enum { MANY = 64 };
  const real start = (real)t0, size = (real)h;
  real t[MANY], y[${upper}_NX*MANY];
  long i;

  for (i = 0; i < n; i += MANY) {
    const int count = n - i < MANY ? (int)(n - i) : (int)MANY;
    int k;

    for (k = 0; k < count; k++) t[k] = start + (real)(i + k)*size;
    ${name}_at_many((const ${name}_orbit *)o, count, t, y);
    if (i + count < n) continue;
    for (k = 0; k < ${upper}_NX; k++) x[k] = (double)y[(k + 1)*count - 1];
  }
}
%%   end
%% end
%% if has_peers then

int plugin_peer_rhs(double t, const double x[], double dx[], void *place); /* peers.c */
void plugin_hand_rk4(void *place, double t0, double x[], double h, long n);
%% end

/* the one name that is seen from outside: all others are hidden, so that calls need not go through a table */
#if defined __GNUC__
__attribute__((visibility("default")))
#endif
const struct polhode_plugin *polhode_plugin(void);

const struct polhode_plugin *polhode_plugin(void)
{
  static const struct polhode_stepper steppers[] = {
%% for _, s in ipairs(steppers) do
%%   if s.run then
    {"${s.name}", plugin_${s.name}, plugin_${s.name}_run, plugin_${s.name}_march, ${s.order}},
%%   else
    {"${s.name}", plugin_${s.name}, NULL, plugin_${s.name}_march, ${s.order}},
%%   end
%% end
%% for _, order in ipairs(orders) do
    {"taylor ${order}", plugin_taylor${order}, NULL, plugin_taylor${order}_march, ${order}},
%% end
    {NULL, NULL, NULL, NULL, 0},
  };
  static const struct polhode_plugin table = {
    POLHODE_PLUGIN_ABI, "${name}", "${real}", (double)${epsilon}, ${upper}_NX, ${upper}_NU, ${upper}_NP,
    (unsigned long)sizeof(${name}_model),
%% if has_closed then
    (unsigned long)sizeof(${name}_orbit),
%% else
    0,
%% end
    plugin_init, plugin_params,
%% if has_rates then
    plugin_inertia, plugin_principal,
%% else
    NULL, NULL,
%% end
    plugin_rhs, steppers, plugin_jacobian, plugin_energy,
%% if has_attitude then
    plugin_momentum,
%% else
    NULL,
%% end
%% if has_integral then
    plugin_integral,
%% else
    NULL,
%% end
%% if has_closed then
    plugin_solve, plugin_at, plugin_solve_loop, plugin_at_loop,
%%   if has_full then
    plugin_many_loop,
%%   else
    NULL,
%%   end
%% else
    NULL, NULL, NULL, NULL, NULL,
%% end
%% if has_peers then
    plugin_peer_rhs, plugin_hand_rk4
%% else
    NULL, NULL
%% end
  };

  return &table;
}
