%% -- split_sphere.c -- free flow, all moments equal: part of scene.c.  SPDX-License-Identifier: MIT-0
/* The free body over a time tau */
static void ${name}_split_drift(const ${name}_model *m, ${name}_real x[], ${name}_real tau, ${name}_real over)
{
  ${name}_real *w = x + ${upper}_WX;
%% if has_attitude then
  (void)m;
  ${name}_split_along(x, w, tau, over);
%% else
  (void)over;
  (void)m;
  (void)w; /* the rates stay */
  (void)tau;
%% end
%% for _, line in ipairs(place) do
  ${line}
%% end
}
