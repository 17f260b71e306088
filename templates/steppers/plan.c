%% -- plan.c -- the planned method over a span of time: part of scene.c.  SPDX-License-Identifier: MIT-0
/* ---- planned for an accuracy of ${accuracy}: ${method} ---- */

int ${name}_advance(const ${name}_model *m, ${name}_real t0, ${name}_real x[], const ${name}_real u[], ${name}_real t1)
{
%% if kind_step then
  const ${name}_real span = t1 - t0; /* into equal steps; a quotient just above a whole number is that number */
  const ${name}_real whole = ${fabs}(span)/${upper}_PLANNED_STEP*(${one} - ${slack});
  const ${name}_real n = ${floor}(whole) < whole ? ${floor}(whole) + ${one} : ${floor}(whole);
  int steps;

  if (!(n < (${name}_real)(~0U >> 1))) return -1;
  steps = (int)n;
  for (int i = 0; i < steps; i++) ${name}_step(m, t0 + span*((${name}_real)i/n), x, u, span/n);
  for (int i = 0; i < ${upper}_NX; i++) {
    if (!(x[i] - x[i] == ${zero})) return -1;
  }
  return steps;
%% end
%% if kind_run then
  const ${name}_real span = t1 - t0;
%%   if share then
  const ${name}_real part = ${fabs}(span)/${horizon_literal}; /* of the span for which the tolerance was found */

  if (!(span - span == ${zero})) return -1;
  return ${name}_${run}_run(m, t0, x, u, t1, ${upper}_PLANNED_TOLERANCE*part, (int)(~0U >> 1));
%%   else

  if (!(span - span == ${zero})) return -1;
  return ${name}_${run}_run(m, t0, x, u, t1, ${upper}_PLANNED_TOLERANCE, (int)(~0U >> 1));
%%   end
%% end
%% if kind_closed then
  ${name}_orbit o;

  (void)u;
  if (!(t1 < t0 || t1 > t0)) return t1 == t0 ? 0 : -1;
  if (${name}_solve(&o, m, x)) return -1;
  ${name}_at(&o, t1 - t0, x);
  for (int k = 0; k < ${upper}_NX; k++) {
    if (!(x[k] - x[k] == ${zero})) return -1;
  }
  return 1;
%% end
}
