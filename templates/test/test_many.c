%% -- test_many.c -- the self-test of many bodies at once: part of test.c.  SPDX-License-Identifier: MIT-0
/* Bodies about the scene's own, more than a block of them: the same numbers as one by one.  (gcc up to version 12 fuses sums
 * and differences side by side on processors that can, in spite of -ffp-contract=off: -fno-tree-slp-vectorize.) */
static void many(const ${name}_model *m)
{
  enum { n = ${upper}_LANES + 3 };
  static ${name}_real x[${upper}_NX*n], start[${upper}_NX*n];
%% if has_inputs then
  static ${name}_real u[${upper}_NU*n];
  const ${name}_real input[${upper}_NU] = {${zero}};
%% else
  const ${name}_real *u = 0, *input = 0;
%% end
  ${name}_real y[${upper}_NX];
  int i, k, ok = 1;

  ${name}_initial(m, y);
  for (k = 0; k < n; k++) {
    for (i = 0; i < ${upper}_NX; i++) start[i*n + k] = x[i*n + k] = y[i]*(${one} + (${name}_real)(k % 7)*${many_apart});
  }
  ${name}_step_many(m, ${zero}, x, u, ${step_literal}, n);
  for (k = 0; k < n; k++) {
    for (i = 0; i < ${upper}_NX; i++) y[i] = start[i*n + k];
    ${name}_step(m, ${zero}, y, input, ${step_literal});
    for (i = 0; i < ${upper}_NX; i++) ok = ok && x[i*n + k] == y[i];
  }
  report(ok, "a step of many bodies gives each the numbers that it has alone");
}

