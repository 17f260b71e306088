%% -- taylor_advance.c -- equal steps of several bodies: part of scene.c.  SPDX-License-Identifier: MIT-0
/* rows of body k of n, as number `body` of the bodies at once */
static void ${name}_wide_take(${name}_bodies to[], const ${name}_real from[], int rows, int n, int k, int body)
{
  for (int i = 0; i < rows; i++) to[i].e[body] = from[(size_t)i*(size_t)n + (size_t)k];
}
%% for _, w in ipairs(ways) do

void ${name}_${advance}_${w.way}(${w.public}, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h, int steps, int n)
{
  const ${name}_wide none = {${zero}}, length = h - none;
  ${name}_wide c[${upper}_ORDER + 1][${upper}_ROW], d[${upper}_ROW], time;
  ${name}_bodies y[${upper}_NX];
%% if has_inputs then
  ${name}_bodies v[${upper}_NU];
%% end
%% if w.each then
  ${name}_bodies own[${upper}_NC];
%% end

%% if not has_inputs then
  (void)u;
%% end
  for (int first = 0; first < n; first += ${upper}_WIDE) {
    for (int body = 0; body < ${upper}_WIDE; body++) { /* the last one stands in for those that are missing */
      const int k = first + body < n ? first + body : n - 1;

      ${name}_wide_take(y, x, ${upper}_NX, n, k, body);
%% if has_inputs then
      ${name}_wide_take(v, u, ${upper}_NU, n, k, body);
%% end
%% if w.each then
      ${name}_wide_take(own, constants, ${upper}_NC, n, k, body);
%% end
    }
    for (int j = 0; j < steps; j++) {
      time = t + (${name}_real)j*h - none;
      ${name}_${w.tail}_terms(${w.call}, &time, &y[0].v, ${w.u}${upper}_ORDER, c);
      ${name}_${w.tail}_step_by(${w.call}, c, ${upper}_ORDER, &length, &y[0].v, d);
%% for _, s in ipairs(states) do
      y[${s.name}].v += d[${s.index}];
%% end
    }
    for (int body = 0; body < ${upper}_WIDE && first + body < n; body++) {
      for (int i = 0; i < ${upper}_NX; i++) x[(size_t)i*(size_t)n + (size_t)(first + body)] = y[i].e[body];
    }
  }
}

void ${name}_${step}_${w.way}(${w.public}, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h, int n)
{
  ${name}_${advance}_${w.way}(${w.argument}, t, x, u, h, 1, n);
}
%% end
