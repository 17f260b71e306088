%% -- test_normalise.c -- the self-test of NAME_normalise.  Part of test.c.  SPDX-License-Identifier: MIT-0
static void normalise(void)
{
  ${name}_real x[${upper}_NX] = {${three}, -${four}, ${zero}, ${twelve}}, n = ${zero}; /* 3^2 + 4^2 + 12^2 = 13^2 */
  int i, bad = ${name}_normalise(x);

  for (i = 0; i < 4; i++) n += x[i]*x[i];
  report(bad == 0 && ${fabs}(n - ${one}) <= ${eight}*${epsilon} && x[1] < ${zero}, "a quaternion of length 13 is brought back to 1");
  for (i = 0; i < 4; i++) x[i] = ${zero};
  report(${name}_normalise(x) == 1, "and a zero quaternion is refused");
}

