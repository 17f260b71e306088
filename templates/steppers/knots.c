%% -- knots.c -- the corners of tables over time: part of scene.c.  SPDX-License-Identifier: MIT-0
/* The first corner of the tables on the way from time t to `end`, else `end`.  Between two corners the equations are smooth. */
static ${name}_real ${name}_knot(const ${name}_model *m, ${name}_real t, ${name}_real end)
{
%% if static then
  static const ${name}_real at[${count}] = {
%% else
  const ${name}_real at[${count}] = {
%% end
%% for _, k in ipairs(knots) do
    ${k},
%% end
  };

%% if static then
  (void)m;
%% end
  for (int i = 0; i < ${count}; i++) {
    if ((t < at[i] && at[i] < end) || (t > at[i] && at[i] > end)) end = at[i];
  }
  return end;
}
