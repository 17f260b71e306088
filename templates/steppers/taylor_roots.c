%% -- taylor_roots.c -- where a square root vanishes and has no series: part of scene.c.  SPDX-License-Identifier: MIT-0
/* Is there no series, or none over h?  A speed at rest has a root without one, and near rest its series does not reach far: then
 * its last term is larger than all that moves. */
static int ${name}_taylor_lost(${name}_real c[][${upper}_ROW], int top, ${name}_real h)
{
  ${name}_real sum = ${zero}, head = ${zero}, tail = ${zero}, term;

  for (int k = 0; k < ${upper}_ROW; k++) {
    term = ${fabs}(c[top][k]);
    for (int n = 0; n < top; n++) term *= ${fabs}(h);
    tail += term;
    head += ${fabs}(c[0][k]) + ${fabs}(c[1][k]*h);
    for (int n = 0; n <= top; n++) sum += ${zero}*c[n][k];
  }
  return !(sum - sum < ${one} && tail <= head);
}

/* Over h, or as much of it as steps of the series' own choice take. */
static void ${name}_taylor_part(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h)
{
  ${name}_real left = h;

  for (int n = 0; n < ${parts}; n++) {
    if (!(left > ${zero} || left < ${zero})) break;
    left -= ${name}_taylor_adapt(m, t + (h - left), x, u, left, ${finest});
  }
}
