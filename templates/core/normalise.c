%% -- normalise.c -- the attitude as a unit quaternion.  Part of scene.c.  SPDX-License-Identifier: MIT-0
int ${name}_normalise(${name}_real x[])
{
  ${name}_real q[4], n, largest = ${zero};

  for (int i = 0; i < 4; i++) {
    q[i] = ${fabs}(x[${upper}_QW + i]);
    if (q[i] > largest) largest = q[i];
  }
  if (!(largest > ${zero})) return 1;
  for (int i = 0; i < 4; i++) q[i] = x[${upper}_QW + i]/largest;
  n = (q[0]*q[0] + q[1]*q[1]) + (q[2]*q[2] + q[3]*q[3]); /* 1 to 4; three roundings of half an epsilon */
  if (!(n >= ${one})) return 1; /* an infinity, or not a number */
  n = ${sqrt}(n); /* with its own rounding five quarters of an epsilon */
  for (int i = 0; i < 4; i++) x[${upper}_QW + i] = q[i]/n;
  return 0;
}
