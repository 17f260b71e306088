%% -- taylor_move.c -- states from coefficients: part of scene.c.  SPDX-License-Identifier: MIT-0
/* what the states move by in the time s: s (c[1] + s (c[2] + ...)), the even and the odd terms apart */
static void ${name}_taylor_move(const ${name}_model *m, ${name}_real c[][${upper}_ROW], int top, ${name}_real s, const ${name}_real x[],
                       ${name}_real d[${upper}_ROW])
{
  const ${name}_real square = s*s;
  int n = top - 2;
%% if packed then
#if defined ${upper}_PACKED
  ${name}_pack a = *(const ${name}_row *)c[top], b = *(const ${name}_row *)c[top - 1];

  for (; n > 1; n -= 2) {
    a = *(const ${name}_row *)c[n] + square*a;
    b = *(const ${name}_row *)c[n - 1] + square*b;
  }
  if (n == 1) a = *(const ${name}_row *)c[1] + square*a;
  *(${name}_row *)d = n == 1 ? s*a + square*b : s*b + square*a;
#else
%% end
%% for _, s in ipairs(columns) do
  ${name}_real a${s.index} = c[top][${s.index}], b${s.index} = c[top - 1][${s.index}];
%% end

  for (; n > 1; n -= 2) {
%% for _, s in ipairs(columns) do
    a${s.index} = c[n][${s.index}] + square*a${s.index};
    b${s.index} = c[n - 1][${s.index}] + square*b${s.index};
%% end
  }
  if (n == 1) {
%% for _, s in ipairs(columns) do
    d[${s.index}] = s*(c[1][${s.index}] + square*a${s.index}) + square*b${s.index};
%% end
  } else {
%% for _, s in ipairs(columns) do
    d[${s.index}] = s*b${s.index} + square*a${s.index};
%% end
  }
%% if packed then
#endif
%% end
%% if axis then
  ${name}_taylor_back(c, ${name}_taylor_spin(m, x)*s, d);
%% else
%%   if shift or top then
  ${name}_taylor_back(m, x, c, s, d);
%%   else
  (void)m;
  (void)x;
%%   end
%% end
}

void ${name}_taylor_at(const ${name}_model *m, ${name}_real c[][${upper}_ROW], ${name}_real s, ${name}_real x[])
{
  ${name}_real d[${upper}_ROW];

  ${name}_taylor_move(m, c, ${upper}_ORDER, s, x, d);
%% for _, s in ipairs(states) do
  x[${s.name}] = c[0][${s.index}] + d[${s.index}];
%% end
}

/* The move over the step h; one Newton step for 1/|q| from the q that comes in, so that |q| cannot drift. */
static void ${name}_taylor_step_by(const ${name}_model *m, ${name}_real c[][${upper}_ROW], int top, ${name}_real h, const ${name}_real x[],
                          ${name}_real d[${upper}_ROW])
{
%% if attitude then
  const ${name}_real n = ${half} - ${half}*(c[0][0]*c[0][0] + c[0][1]*c[0][1] + c[0][2]*c[0][2] + c[0][3]*c[0][3]);

%% end
  ${name}_taylor_move(m, c, top, h, x, d);
%% if attitude then
  for (int i = 0; i < 4; i++) d[i] += n*(c[0][i] + d[i]);
%% end
}
