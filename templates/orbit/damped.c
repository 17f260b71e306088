%% -- damped.c -- parts of a damped motion: part of scene.c.  SPDX-License-Identifier: MIT-0
void ${name}_at_rates(const ${name}_orbit *o, ${name}_real t, ${name}_real w[])
{
  ${name}_real x[${upper}_NX];

  ${name}_at(o, t, x);
  for (int i = 0; i < 3; i++) w[i] = x[${upper}_WX + i];
}

void ${name}_at_attitude(const ${name}_orbit *o, ${name}_real t, ${name}_real q[])
{
  ${name}_real x[${upper}_NX];

  ${name}_at(o, t, x);
  for (int i = 0; i < 4; i++) q[i] = x[${upper}_QW + i];
}
