%% -- test_follows.c -- the self-test's two roads to the motion: part of test.c.  SPDX-License-Identifier: MIT-0
/* the state x0 after `steps` steps over the time T */
static void advance(const ${name}_model *m, const ${name}_real x0[], ${name}_real T, int steps, ${name}_real x[])
{
%% if has_inputs then
  const ${name}_real u[${upper}_NU] = {${zero}};
%% else
  const ${name}_real *u = 0;
%% end
  const ${name}_real h = T/(${name}_real)steps;
  int i;

  for (i = 0; i < ${upper}_NX; i++) x[i] = x0[i];
  for (i = 0; i < steps; i++) ${name}_step(m, (${name}_real)i*h, x, u, h);
}

%% if test_follows then
/* the same by the classical method of Runge and Kutta from the rates of change, which are compared with exact ones above */
static void integrate(const ${name}_model *m, const ${name}_real x0[], ${name}_real T, int steps, ${name}_real x[])
{
%% if has_inputs then
  const ${name}_real u[${upper}_NU] = {${zero}};
%% else
  const ${name}_real *u = 0;
%% end
  const ${name}_real h = T/(${name}_real)steps, half = h/${order_two};
  ${name}_real y[${upper}_NX], k[4][${upper}_NX];
  int i, n;

  for (i = 0; i < ${upper}_NX; i++) x[i] = x0[i];
  for (n = 0; n < steps; n++) {
    const ${name}_real t = (${name}_real)n*h;

    ${name}_rhs(m, t, x, u, k[0]);
    for (i = 0; i < ${upper}_NX; i++) y[i] = x[i] + half*k[0][i];
    ${name}_rhs(m, t + half, y, u, k[1]);
    for (i = 0; i < ${upper}_NX; i++) y[i] = x[i] + half*k[1][i];
    ${name}_rhs(m, t + half, y, u, k[2]);
    for (i = 0; i < ${upper}_NX; i++) y[i] = x[i] + h*k[2][i];
    ${name}_rhs(m, t + h, y, u, k[3]);
    for (i = 0; i < ${upper}_NX; i++) x[i] += h/${order_six}*(k[0][i] + ${order_two}*(k[1][i] + k[2][i]) + k[3][i]);
  }
}
%% end
