%% -- split_point.c -- free flow of a point: part of scene.c.  SPDX-License-Identifier: MIT-0
/* The free body over a time tau */
static void ${name}_split_drift(const ${name}_model *m, ${name}_real x[], ${name}_real tau, ${name}_real over)
{
  (void)over;
  (void)m;
%% for _, line in ipairs(place) do
  ${line}
%% end
}
