%% -- taylor_terms.c -- the recurrences of several bodies: part of scene.c.  SPDX-License-Identifier: MIT-0
%% for _, level in ipairs(levels) do
%%   if level.has_lanes then
/* term n of the products of level ${level.number}, the newest factors last */
static void ${name}_${way}_products${level.number}(int n, ${name}_wide a[][${places}], ${name}_wide p[])
{
  const ${name}_wide none = {${zero}};
%%     for _, lane in ipairs(level.lanes) do
  ${name}_wide s${lane.index} = none; /* ${lane.about} */
%%     end

  for (int j = 1; j < n; j++) {
    const ${name}_wide *A = a[j], *B = a[n - j];
%%     if level.weighted then
    const ${name}_real order = (${name}_real)j;
%%     end

%%     for _, lane in ipairs(level.lanes) do
    s${lane.index} += ${lane.weight}A[${lane.a}]*B[${lane.b}];
%%     end
  }
%%     for _, lane in ipairs(level.lanes) do
  p[${lane.index}] = s${lane.index};
%%     end
}

%%   end
%% end
/* the coefficients up to c[top] */
static void ${name}_${way}_terms(${owner}, ${name}_wide *time, ${name}_wide x[], ${u}int top, ${name}_wide c[][${upper}_ROW])
{
  const ${name}_wide none = {${zero}}, t = *time;
  ${name}_wide y[${places}];
%% if has_lanes then
  ${name}_wide a[${upper}_ORDER + 1][${places}], p[${lanes}];
%% end
%% for _, line in ipairs(outer) do
  ${line}
%% end

  (void)none;
  (void)t;
%% for _, line in ipairs(voids) do
  ${line}
%% end
%% for _, line in ipairs(start) do
  ${line}
%% end
%% for _, s in ipairs(states) do
  c[0][${s.index}] = y[${s.index}];
%% end
%% for _, i in ipairs(history) do
  a[0][${i}] = y[${i}];
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
    const ${name}_wide after = ${one}/(${name}_real)(n + 1) - none;
%% if uses_order then
    const ${name}_wide order = (${name}_real)n - none;
%% end
%% for _, line in ipairs(loads) do
    ${line}
%% end

%% for _, level in ipairs(levels) do
%%   if level.has_lanes then
%%     for _, z in ipairs(level.unknown) do
    y[${z}] = none;
%%     end
    ${name}_${way}_products${level.number}(n, a, p);
%%     for _, lane in ipairs(level.lanes) do
    p[${lane.index}] += ${lane.head}*${lane.right} + ${lane.left}*a[0][${lane.b}];
%%     end
%%   end
%%   for _, line in ipairs(level.lines) do
    ${line}
%%   end
%% end
%% for _, i in ipairs(history) do
    a[n][${i}] = y[${i}];
%% end
%% for _, line in ipairs(after) do
    ${line}
%% end
%% for _, s in ipairs(states) do
    c[n + 1][${s.index}] = y[${s.index}];
%% end
  }
}
