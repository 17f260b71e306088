/* peers.c -- what ${name} is compared with, for the program polhode; not part of what is delivered.
 * template: templates/host/peers.c.  ${license}
 *
 * The right-hand side for other libraries' integrators, and the classical Runge-Kutta method of order 4 as a user would
 * write it around that right-hand side: arrays, four stages, loops; the attitude is not normalised.
 */
#include "${name}.h"
#include "plugin.h"

int plugin_peer_rhs(double t, const double x[], double dx[], void *place);
void plugin_hand_rk4(void *place, double t0, double x[], double h, long n);

int plugin_peer_rhs(double t, const double x[], double dx[], void *place)
{
  const struct polhode_place *at = (const struct polhode_place *)place;

  ${name}_rhs((const ${name}_model *)at->m, t, x, at->u, dx);
  return 0;
}

static void rk4(const ${name}_model *m, double t, double x[], const double u[], double h)
{
  double k1[${upper}_NX], k2[${upper}_NX], k3[${upper}_NX], k4[${upper}_NX], y[${upper}_NX];
  int i;

  ${name}_rhs(m, t, x, u, k1);
  for (i = 0; i < ${upper}_NX; i++) y[i] = x[i] + 0.5*h*k1[i];
  ${name}_rhs(m, t + 0.5*h, y, u, k2);
  for (i = 0; i < ${upper}_NX; i++) y[i] = x[i] + 0.5*h*k2[i];
  ${name}_rhs(m, t + 0.5*h, y, u, k3);
  for (i = 0; i < ${upper}_NX; i++) y[i] = x[i] + h*k3[i];
  ${name}_rhs(m, t + h, y, u, k4);
  for (i = 0; i < ${upper}_NX; i++) x[i] += h/6*(k1[i] + 2*k2[i] + 2*k3[i] + k4[i]);
}

void plugin_hand_rk4(void *place, double t0, double x[], double h, long n)
{
  const struct polhode_place *at = (const struct polhode_place *)place;
  long i;

  for (i = 0; i < n; i++) rk4((const ${name}_model *)at->m, t0 + (double)i*h, x, at->u, h);
}
