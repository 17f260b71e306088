%% -- taylor_rows.c -- the recurrences of one level as rows of vectors: part of scene.c.  SPDX-License-Identifier: MIT-0
/* the coefficients up to c[top]; a and b are the factors of the products, plane by plane */
static void ${name}_taylor_terms(const ${name}_model *m, ${name}_real t, const ${name}_real x[], const ${name}_real u[], int top,
                   ${name}_real c[][${upper}_ROW]${side}${sides_arg})
{
%% for _, p in ipairs(planes) do
  ${name}_pack a${p.index}[${upper}_ORDER + 1], b${p.index}[${upper}_ORDER + 1];
%% end
  ${name}_real y[${upper}_ROW];
  ${name}_pack Y;
  int j;
%% for _, line in ipairs(outer) do
  ${line}
%% end
%% for _, line in ipairs(voids) do
  ${line}
%% end
  for (int i = 0; i < ${upper}_ROW; i++) y[i] = ${zero}; /* also those beyond the states */
%% for _, line in ipairs(start_packed) do
  ${line}
%% end
%% for _, line in ipairs(factors) do
  ${line}
%% end
%% for _, p in ipairs(planes) do
  const ${name}_pack C${p.index} = {${p.factors}};
%% end
%% for _, p in ipairs(linear) do
  const ${name}_pack D${p.index} = {${p.factors}};
%% end
%% for _, p in ipairs(rest) do
  const ${name}_pack E = {${p.factors}};
%% end

  Y = (${name}_pack){y[0], y[1], y[2], y[3], y[4], y[5], y[6], y[7]};
  *(${name}_row *)c[0] = Y;
%% for _, p in ipairs(planes) do
  a${p.index}[0] = __builtin_shufflevector(Y, Y, ${p.a});
  b${p.index}[0] = __builtin_shufflevector(Y, Y, ${p.b});
  const ${name}_pack A${p.index} = C${p.index}*a${p.index}[0], B${p.index} = C${p.index}*b${p.index}[0];
%% end
  Y = ${first_row};
  *(${name}_row *)c[1] = Y;
  for (int n = 1; n < top; n++) {
    const ${name}_real after = ${one}/(${name}_real)(n + 1);
%% for _, p in ipairs(planes) do
    ${name}_pack p${p.index} = {${zero}}, r${p.index} = {${zero}};
%% end

%% for _, p in ipairs(planes) do
    a${p.index}[n] = __builtin_shufflevector(Y, Y, ${p.a});
    b${p.index}[n] = __builtin_shufflevector(Y, Y, ${p.b});
%% end
    j = n/2; /* outwards from the middle: the newest rows last */
    if (n - j == j) {
%% for _, p in ipairs(planes) do
      p${p.index} = a${p.index}[j]*b${p.index}[j];
%% end
      j--;
    }
    for (; j > 0; j--) {
%% for _, p in ipairs(planes) do
      p${p.index} += a${p.index}[j]*b${p.index}[n - j];
      r${p.index} += a${p.index}[n - j]*b${p.index}[j];
%% end
    }
    Y = ${next_row};
    *(${name}_row *)c[n + 1] = Y;
  }
}
