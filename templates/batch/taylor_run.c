%% -- taylor_run.c -- several bodies, each at its own pace: part of scene.c.  SPDX-License-Identifier: MIT-0
/* ${name}_taylor_size of each body: the largest numbers first, then their logarithms */
static void ${name}_wide_size(${name}_wide c[][${upper}_ROW], int top, ${name}_real local, ${name}_real rate, ${name}_real h[${upper}_WIDE])
{
  const ${name}_real log_local = ${name}_taylor_log2(local), log_rate = ${name}_taylor_log2(rate);
  ${name}_real part[5], log_h[${upper}_WIDE], best[${upper}_WIDE];
  ${name}_bodies term[5]; /* the first three, the last two */
  int n;

  for (int i = 0; i < 5; i++) part[i] = ${one}/(${name}_real)(top - i > 0 ? top - i : 1);
  for (int body = 0; body < ${upper}_WIDE; body++) log_h[body] = ${n[64]};
%% for _, k in ipairs(kinds) do
  /* ${k.about} */
  for (int i = 0; i < 5; i++) {
    n = i < 3 ? i : top + i - 4;
    for (int body = 0; body < ${upper}_WIDE; body++) term[i].e[body] = ${zero};
    for (int k = ${k.first}; k < ${k.last}; k++) {
      ${name}_bodies now;

      now.v = c[n][k];
      for (int body = 0; body < ${upper}_WIDE; body++) {
        term[i].e[body] = ${fabs}(now.e[body]) > term[i].e[body] ? ${fabs}(now.e[body]) : term[i].e[body];
      }
    }
  }
  for (n = top - 1; n <= top; n++) {
    const ${name}_real *last = term[n - top + 4].e;

    for (int body = 0; body < ${upper}_WIDE; body++) best[body] = ${one} - ${bias};
    for (int i = 0; i < 3 && i + 1 < n; i++) {
      for (int body = 0; body < ${upper}_WIDE; body++) {
        const ${name}_real head = ${name}_taylor_log2(term[i].e[body]), tail = ${name}_taylor_log2(last[body]);
        const ${name}_real near = (log_local + head - tail)*part[top - n + i];
        const ${name}_real far = (log_rate + head - tail)*part[top - n + i + 1];

        best[body] = near > best[body] ? near : best[body];
        best[body] = far > best[body] ? far : best[body];
      }
    }
    for (int body = 0; body < ${upper}_WIDE; body++) { /* where the term is 0, nothing moves */
      log_h[body] = last[body] > ${zero} && best[body] < log_h[body] ? best[body] : log_h[body];
    }
  }
%% end
  for (int body = 0; body < ${upper}_WIDE; body++) h[body] = ${name}_taylor_exp2(log_h[body]);
}
%% for _, w in ipairs(ways) do

void ${name}_taylor_run_${w.way}(${w.public}, ${name}_real t0, ${name}_real x[], const ${name}_real u[], ${name}_real t1, ${name}_real tolerance, int most, int steps[], int n)
{
  static const int moving[${upper}_MOVING] = {
%% for _, s in ipairs(states) do
    ${s.name},
%% end
  };
  const ${name}_real finest = ${finest}, local = tolerance < finest ? tolerance : finest, rate = tolerance/(t1 - t0);
  const int top = ${name}_taylor_top(tolerance);
  ${name}_wide c[${upper}_ORDER + 1][${upper}_ROW], d[${upper}_ROW];
  ${name}_bodies y[${upper}_NX], lost[${upper}_MOVING + 1], time, left, h;
%% if has_inputs then
  ${name}_bodies v[${upper}_NU];
%% end
%% if w.each then
  ${name}_bodies own[${upper}_NC];
%% end
  ${name}_real size[${upper}_WIDE];
  int who[${upper}_WIDE], idle = 0, next = 0, body, i, k;

%% if not has_inputs then
  (void)u;
%% end
  for (k = 0; k < n && most <= 0; k++) steps[k] = -1;
  if (n <= 0 || most <= 0) return;
  for (body = 0; body < ${upper}_WIDE; body++) { /* no body yet */
    who[body] = -1;
    left.e[body] = ${zero};
  }
  while (idle < ${upper}_WIDE) {
    idle = 0;
    for (body = 0; body < ${upper}_WIDE; body++) {
      /* who has arrived makes room for the next body; where there is none, a copy of the last one stands by */
      while (who[body] < 0 || !(left.e[body] > ${zero} || left.e[body] < ${zero})) {
        if (who[body] >= 0 && who[body] < n) {
          for (i = 0; i < ${upper}_NX; i++) x[(size_t)i*(size_t)n + (size_t)who[body]] = y[i].e[body];
        }
        who[body] = next < n ? next++ : n;
        k = who[body] < n ? who[body] : n - 1;
        if (who[body] < n) steps[k] = 0;
        ${name}_wide_take(y, x, ${upper}_NX, n, k, body);
%% if has_inputs then
        ${name}_wide_take(v, u, ${upper}_NU, n, k, body);
%% end
%% if w.each then
        ${name}_wide_take(own, constants, ${upper}_NC, n, k, body);
%% end
        for (i = 0; i <= ${upper}_MOVING; i++) lost[i].e[body] = ${zero};
        time.e[body] = t0;
        left.e[body] = t1 - t0;
        if (who[body] == n) break;
      }
      idle += who[body] == n;
    }
    if (idle == ${upper}_WIDE) break;
    ${name}_${w.tail}_terms(${w.call}, &time.v, &y[0].v, ${w.u}top, c);
    ${name}_wide_size(c, top, local, rate, size);
    for (body = 0; body < ${upper}_WIDE; body++) h.e[body] = ${name}_taylor_limit(size[body], left.e[body]);
    ${name}_${w.tail}_step_by(${w.call}, c, top, &h.v, &y[0].v, d);
    for (k = 0; k < ${upper}_MOVING; k++) {
      const ${name}_wide add = d[k] + lost[k].v, sum = c[0][k] + add;

      lost[k].v = add - (sum - c[0][k]);
      y[moving[k]].v = sum;
    }
    for (body = 0; body < ${upper}_WIDE; body++) {
      const ${name}_real step = h.e[body] + lost[${upper}_MOVING].e[body], then = time.e[body] + step;

      if (who[body] == n) continue;
      k = h.e[body] > ${zero} || h.e[body] < ${zero} ? 0 : ${upper}_MOVING + 1;
      while (k < ${upper}_MOVING && y[moving[k]].e[body] - y[moving[k]].e[body] == ${zero}) k++;
      if (k == ${upper}_MOVING) {
        lost[${upper}_MOVING].e[body] = step - (then - time.e[body]);
        time.e[body] = then;
        left.e[body] = (t1 - then) - lost[${upper}_MOVING].e[body];
        steps[who[body]]++;
        if (steps[who[body]] < most) continue;
      }
      for (k = k > ${upper}_MOVING ? 0 : k; k < ${upper}_MOVING; k++) { /* where it stopped */
        ${name}_bodies start;

        start.v = c[0][k];
        y[moving[k]].e[body] = start.e[body];
      }
      steps[who[body]] = -1;
      left.e[body] = ${zero};
    }
  }
}
%% end
