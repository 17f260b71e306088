%% -- taylor_series.c -- the coefficients of the highest order: part of scene.c.  SPDX-License-Identifier: MIT-0
void ${name}_taylor_series(const ${name}_model *m, ${name}_real t, const ${name}_real x[], const ${name}_real u[],
                  ${name}_real c[][${upper}_ROW])
{
%% if has_sides then
  ${name}_corners o;

  ${name}_corners_at_start(m, t, x, u, ${zero}, &o);
%% end
  ${name}_taylor_terms(m, t, x, u, ${upper}_ORDER, c${after_t}${series_sides});
}
