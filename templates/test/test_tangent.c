%% -- test_tangent.c -- the self-test of the steps' derivatives: part of test.c.  SPDX-License-Identifier: MIT-0
%% if has_transition_case then
/* The step's transition matrix alone. */
static void transition(const ${name}_model *m, const ${name}_real x[], const ${name}_real u[], ${name}_real h, ${name}_real F[])
{
  ${name}_real y[${upper}_NX];
  int i;

  for (i = 0; i < ${upper}_NX; i++) y[i] = x[i];
  ${name}_step_transition(m, ${zero}, y, u, h, F);
}

%% end
%% if has_transition then
/* The step with its transition is that of ${name}_step; where the equations are smooth, entries against central differences
 * of that step, by d and by d/2: their error falls 4-fold, 2-fold where a second derivative jumps, so that of the second
 * is less than twice what the two differ by; rounding adds 32 units of each state, divided by the displacement. */
static void tangent(const ${name}_model *m, const ${name}_real x[], const ${name}_real u[], ${name}_real h)
{
  static const int kind[][2] = { /* states of one kind: first, last + 1 */
%%   for _, k in ipairs(state_kinds) do
    {${k.first}, ${k.last}}, /* ${k.about} */
%%   end
  };
  ${name}_real F[${upper}_NX*${upper}_NX], y[${upper}_NX], z[${upper}_NX], size[${upper}_NX];
%%   if has_differences then
  ${name}_real low[${upper}_NX], difference[2][${upper}_NX];
%%     if has_inputs then
  static const ${name}_real span[${upper}_NU] = {${input_spans}};
  ${name}_real G[${upper}_NX*${upper}_NU];
%%     end
  int s;
%%   end
  unsigned int g;
  int i, k, ok = 1;

  for (i = 0; i < ${upper}_NX; i++) y[i] = z[i] = x[i];
  ${name}_step(m, ${zero}, y, u, h);
  ${name}_step_transition(m, ${zero}, z, u, h, F);
  for (g = 0; g < sizeof kind/sizeof kind[0]; g++) {
    ${name}_real most = ${zero};

    for (k = kind[g][0]; k < kind[g][1]; k++) {
      most = ${fabs}(x[k]) > most ? ${fabs}(x[k]) : most;
      most = ${fabs}(y[k]) > most ? ${fabs}(y[k]) : most;
    }
    for (k = kind[g][0]; k < kind[g][1]; k++) size[k] = most;
  }
  for (i = 0; i < ${upper}_NX; i++) ok = ok && ${fabs}(y[i] - z[i]) <= ${roundings}*size[i];
  report(ok, "the step with its transition is the step");
%%   if has_differences then
  ok = 1;
  for (k = 0; k < ${upper}_NX; k++) {
    for (s = 0; s < 2; s++) {
      const ${name}_real d = ${displacement}*x[k]/(${name}_real)(s + 1);
      ${name}_real width;

      for (i = 0; i < ${upper}_NX; i++) y[i] = low[i] = x[i];
      y[k] += d;
      low[k] -= d;
      width = y[k] - low[k]; /* as it was rounded */
      ${name}_step(m, ${zero}, y, u, h);
      ${name}_step(m, ${zero}, low, u, h);
      for (i = 0; i < ${upper}_NX; i++) difference[s][i] = (y[i] - low[i])/width;
    }
    for (i = 0; i < ${upper}_NX; i++) {
      const ${name}_real error = ${fabs}(F[i*${upper}_NX + k] - difference[1][i]);

      if (!(error <= ${two}*${fabs}(difference[0][i] - difference[1][i]) + ${two}*${roundings}*size[i]/(${displacement}*${fabs}(x[k])))) {
        ok = 0;
        printf("# d x[%d]/d x[%d]: %.17g, differences %.17g %.17g\n", i, k, (double)F[i*${upper}_NX + k],
               (double)difference[0][i], (double)difference[1][i]);
      }
    }
  }
  report(ok, "the transition matrix agrees with differences of the step");
%%     if has_inputs then
  ok = 1;
  ${name}_step_transition_u(m, ${zero}, x, u, h, G);
  for (k = 0; k < ${upper}_NU; k++) {
    for (s = 0; s < 2; s++) {
      const ${name}_real d = ${displacement}*span[k]/(${name}_real)(s + 1);
      ${name}_real up[${upper}_NU], down[${upper}_NU], width;

      for (i = 0; i < ${upper}_NX; i++) y[i] = low[i] = x[i];
      for (i = 0; i < ${upper}_NU; i++) up[i] = down[i] = u[i];
      up[k] += d;
      down[k] -= d;
      width = up[k] - down[k];
      ${name}_step(m, ${zero}, y, up, h);
      ${name}_step(m, ${zero}, low, down, h);
      for (i = 0; i < ${upper}_NX; i++) difference[s][i] = (y[i] - low[i])/width;
    }
    for (i = 0; i < ${upper}_NX; i++) {
      const ${name}_real error = ${fabs}(G[i*${upper}_NU + k] - difference[1][i]);

      if (!(error <= ${two}*${fabs}(difference[0][i] - difference[1][i]) + ${two}*${roundings}*size[i]/(${displacement}*span[k]))) {
        ok = 0;
        printf("# d x[%d]/d u[%d]: %.17g, differences %.17g %.17g\n", i, k, (double)G[i*${upper}_NU + k],
               (double)difference[0][i], (double)difference[1][i]);
      }
    }
  }
  report(ok, "the step's derivative by the input agrees with differences of the step");
%%     end
%%   end
}

%% end
