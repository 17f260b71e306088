%% -- flight.c -- the centre of mass under constant forces: part of scene.c.  SPDX-License-Identifier: MIT-0
static void ${name}_launch(${name}_orbit *o, const ${name}_real x0[])
{
  for (int i = 0; i < 3; i++) {
    o->r[i] = x0[${upper}_RX + i];
    o->v[i] = x0[${upper}_VX + i];
  }
}

/* r = r0 + v0 t + g t^2/2 */
static void ${name}_carried(const ${name}_orbit *o, ${name}_real t, ${name}_real x[])
{
  for (int i = 0; i < 3; i++) {
    x[${upper}_RX + i] = o->r[i] + t*(o->v[i] + ${half}*t*o->g[i]);
    x[${upper}_VX + i] = o->v[i] + t*o->g[i];
  }
}
