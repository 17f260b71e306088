%% -- taylor_axis.c -- the frame about a symmetry axis and back: part of scene.c.  SPDX-License-Identifier: MIT-0
/* The series run in a frame that turns at this rate about the symmetry axis, rad/s, relative to the body: the body and its
 * torque look alike from all sides of it, so the equations keep their form, and what is fixed in space moves slower. */
static ${name}_real ${name}_taylor_spin(const ${name}_model *m, const ${name}_real x[])
{
%% for _, line in ipairs(spin) do
  ${line}
%% end
}

/* From that frame after the angle f back to the body: what c[0] + d moves by then. */
static void ${name}_taylor_back(${name}_real c[][${upper}_ROW], ${name}_real f, ${name}_real d[${upper}_ROW])
{
  const ${name}_real a = ${sin}(${quarter}*f), b = ${cos}(${quarter}*f);
  const ${name}_real S = ${two}*a*b, D = -${two}*a*a, V = ${two}*S*(${one} + D), W = -${two}*S*S; /* sin, cos - 1 of f/2, f */
  ${name}_real r, s;

%% for _, r in ipairs(turns) do
  r = c[0][${r.a}] + d[${r.a}];
  s = c[0][${r.b}] + d[${r.b}];
  d[${r.a}] += ${r.one}*r + ${r.sine}*s;
  d[${r.b}] += ${r.one}*s - ${r.sine}*r;
%% end
}
