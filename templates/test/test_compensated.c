%% -- test_compensated.c -- the self-test's part on compensated sums: part of test.c.  SPDX-License-Identifier: MIT-0
/* The compensated step is the step, but for the roundings of one; and its sums lose nothing: 4096 steps of two epsilons times
 * h, most of which move x by less than its last place, move it by the rate of change times 4096 steps.  h is a 64th of a
 * radian, so second derivatives count for (128 epsilon)^2/2 of x; the increments' own roundings for as little; |q|, which
 * is brought back to 1 from x alone, for 2 epsilon of q. */
static void compensated(const ${name}_model *m, const ${name}_real x[], const ${name}_real u[], ${name}_real h)
{
  static const int kind[][2] = { /* states of one kind: first, last + 1 */
%%   for _, k in ipairs(state_kinds) do
    {${k.first}, ${k.last}}, /* ${k.about} */
%%   end
  };
  const ${name}_real tiny = ${two}*${epsilon}*h;
  ${name}_real size[${upper}_NX], y[${upper}_NX], z[${upper}_NX], low[${upper}_NX], dx[${upper}_NX];
  unsigned int g;
  int i, k, same = 1, moved = 1;

  for (i = 0; i < ${upper}_NX; i++) y[i] = z[i] = x[i];
  for (i = 0; i < ${upper}_NX; i++) low[i] = ${zero};
  ${name}_step(m, ${zero}, y, u, h);
  ${name}_step_compensated(m, ${zero}, z, u, h, low);
  for (g = 0; g < sizeof kind/sizeof kind[0]; g++) {
    ${name}_real most = ${zero};

    for (k = kind[g][0]; k < kind[g][1]; k++) {
      most = ${fabs}(x[k]) > most ? ${fabs}(x[k]) : most;
      most = ${fabs}(y[k]) > most ? ${fabs}(y[k]) : most;
    }
    for (k = kind[g][0]; k < kind[g][1]; k++) {
      size[k] = most;
      if (!(${fabs}(y[k] - z[k]) <= ${roundings}*most && ${fabs}(low[k]) <= ${epsilon}*most)) same = 0;
    }
  }
  report(same, "the compensated step is the step");

  for (i = 0; i < ${upper}_NX; i++) z[i] = x[i];
  for (i = 0; i < ${upper}_NX; i++) low[i] = ${zero};
  for (i = 0; i < 4096; i++) ${name}_step_compensated(m, ${zero}, z, u, tiny, low);
  ${name}_rhs(m, ${zero}, x, u, dx);
  for (i = 0; i < ${upper}_NX; i++) {
    const ${name}_real want = (${name}_real)4096*tiny*dx[i], got = (z[i] - x[i]) + low[i];

    if (!(${fabs}(got - want) <= ${eighth}*${fabs}(want) + ${four}*${epsilon}*size[i])) {
      moved = 0;
      printf("# [%d] moved by %.9g, not by %.9g\n", i, (double)got, (double)want);
    }
  }
  report(moved, "compensated sums of steps too short to be seen lose nothing");
}
