%% -- taylor_size.c -- the Taylor stepper's choice of a step: part of scene.c.  SPDX-License-Identifier: MIT-0
/* An IEEE 754 number's bits, read as an integer, are its logarithm but for a straight line between powers of two: log2 |x|
 * to 0.09, and the inverse function. */
typedef union ${name}_taylor_bits {
  ${name}_real x;
  ${int} n;
} ${name}_taylor_bits;

static ${name}_real ${name}_taylor_log2(${name}_real x)
{
  ${name}_taylor_bits b;

  b.x = ${fabs}(x);
  return (${name}_real)b.n*${bit} - ${bias};
}

static ${name}_real ${name}_taylor_exp2(${name}_real x) /* x within the range of exponents */
{
  ${name}_taylor_bits b;

  b.n = (${int})((x + ${bias})*${scale});
  return b.x;
}

/* The largest step h at which the last two terms are below a part of the first ones of their kind of state, |c[n]| h^n <=
 * part |c[i]| h^i for some i < 3; the part is `local`, or `rate` h if that is larger. */
static ${name}_real ${name}_taylor_size(${name}_real c[][${upper}_ROW], int top, ${name}_real local, ${name}_real rate)
{
  const ${name}_real log_local = ${name}_taylor_log2(local), log_rate = ${name}_taylor_log2(rate);
  ${name}_real log_h = ${n[64]}, head[3], tail, at, best, part[5];
  int n;

  for (int i = 0; i < 5; i++) part[i] = ${one}/(${name}_real)(top - i > 0 ? top - i : 1);

%% for _, k in ipairs(kinds) do
  /* ${k.about} */
  for (int i = 0; i < 3; i++) {
    head[i] = ${zero};
    for (int k = ${k.first}; k < ${k.last}; k++) head[i] = ${fabs}(c[i][k]) > head[i] ? ${fabs}(c[i][k]) : head[i];
    head[i] = ${name}_taylor_log2(head[i]);
  }
  for (n = top - 1; n <= top; n++) {
    tail = ${zero};
    for (int k = ${k.first}; k < ${k.last}; k++) tail = ${fabs}(c[n][k]) > tail ? ${fabs}(c[n][k]) : tail;
    if (!(tail > ${zero})) continue; /* nothing moves */
    tail = ${name}_taylor_log2(tail);
    best = ${one} - ${bias};
    for (int i = 0; i < 3 && i + 1 < n; i++) {
      at = (log_local + head[i] - tail)*part[top - n + i];
      best = at > best ? at : best;
      at = (log_rate + head[i] - tail)*part[top - n + i + 1];
      best = at > best ? at : best;
    }
    log_h = best < log_h ? best : log_h;
  }
%% end
  return ${name}_taylor_exp2(log_h);
}

static ${name}_real ${name}_taylor_limit(${name}_real size, ${name}_real h)
{
  return size < ${fabs}(h) ? h < ${zero} ? -size : size : h;
}

