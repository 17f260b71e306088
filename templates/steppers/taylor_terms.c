%% -- taylor_terms.c -- the recurrences level by level: part of scene.c.  SPDX-License-Identifier: MIT-0
%% if has_lanes then
/* Not inlined, the loops of products are put into vector registers as a whole. */
#if defined __GNUC__
#define ${upper}_APART static __attribute__((noinline))
#else
#define ${upper}_APART static
#endif

%% end
%% for _, level in ipairs(levels) do
%%   if level.has_lanes then
/* term n of the products of level ${level.number}; the newest factors come last, so that the sum need not wait for them */
${upper}_APART void ${name}_products${level.number}(int n, const ${name}_real a[][${lanes}], const ${name}_real b[][${lanes}], ${name}_real p[])
{
%%     for _, lane in ipairs(level.lanes) do
  ${name}_real s${lane.index} = ${zero}; /* ${lane.about} */
%%     end

  for (int j = 1; j < n; j++) {
    const ${name}_real *A = a[j], *B = b[n - j];

%%     for _, lane in ipairs(level.lanes) do
    s${lane.index} += A[${lane.index}]*B[${lane.index}];
%%     end
  }
%%     for _, lane in ipairs(level.lanes) do
  p[${lane.index}] = s${lane.index};
%%     end
}

%%   end
%% end
/* the coefficients up to c[top]${side_about} */
static void ${name}_taylor_terms(const ${name}_model *m, ${name}_real t, const ${name}_real x[], const ${name}_real u[], int top,
                   ${name}_real c[][${upper}_ROW]${side}${sides_arg})
{
%% if has_lanes then
  ${name}_real a[${upper}_ORDER + 1][${lanes}], b[${upper}_ORDER + 1][${lanes}], p[${lanes}];
%% end
  ${name}_real y[${places}];
%% for _, line in ipairs(outer) do
  ${line}
%% end

%% for _, line in ipairs(voids) do
  ${line}
%% end
%% for _, line in ipairs(start) do
  ${line}
%% end
%% for _, s in ipairs(states) do
  c[0][${s.index}] = y[${s.index}];
%% end
%% for _, r in ipairs(roots) do
  c[0][${r.index}] = y[${r.place}];
%% end
%% for _, level in ipairs(levels) do
%%   for _, lane in ipairs(level.lanes) do
  a[0][${lane.index}] = ${lane.first};
  b[0][${lane.index}] = ${lane.right};
%%   end
%% end
  {
%% for _, line in ipairs(next) do
    ${line}
%% end
  }
%% for _, s in ipairs(states) do
  c[1][${s.index}] = y[${s.index}];
%% end

  for (int n = 1; n < top; n++) {
    const ${name}_real after = ${one}/(${name}_real)(n + 1);
%% if uses_order then
    const ${name}_real order = (${name}_real)n;
%% end
%% for _, line in ipairs(loads) do
    ${line}
%% end

%% for _, level in ipairs(levels) do
%%   if level.has_lanes then
%%     for _, z in ipairs(level.unknown) do
    y[${z}] = ${zero};
%%     end
%%     for _, lane in ipairs(level.lanes) do
    a[n][${lane.index}] = ${lane.left};
    b[n][${lane.index}] = ${lane.right};
%%     end
    ${name}_products${level.number}(n, (const ${name}_real(*)[${lanes}])a, (const ${name}_real(*)[${lanes}])b, p);
%%     for _, lane in ipairs(level.lanes) do
    p[${lane.index}] += a[0][${lane.index}]*${lane.right} + ${lane.left}*b[0][${lane.index}];
%%     end
%%   end
%%   for _, line in ipairs(level.lines) do
    ${line}
%%   end
%%   for _, line in ipairs(level.known) do
    ${line}
%%   end
%% end
%% for _, line in ipairs(after) do
    ${line}
%% end
%% for _, s in ipairs(states) do
    c[n + 1][${s.index}] = y[${s.index}];
%% end
%% for _, r in ipairs(roots) do
    c[n][${r.index}] = y[${r.place}];
    c[n + 1][${r.index}] = ${zero};
%% end
  }
}
