%% -- taylor_series.c -- the coefficients of the highest order: part of scene.c.  SPDX-License-Identifier: MIT-0
void ${name}_taylor_series(const ${name}_model *m, ${name}_real t, const ${name}_real x[], const ${name}_real u[],
                  ${name}_real c[][${upper}_ROW])
{
%% if has_switches then
  ${name}_real ${array}[${many}];
  ${name}_corners o;

  ${name}_sides(m, t, x, u, ${zero}, ${array}, &o);
%% end
  ${name}_taylor_terms(m, t, x, u, ${upper}_ORDER, c${after_t}${sides});
}
