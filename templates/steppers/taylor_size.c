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

/* log2 of the largest step h at which the last two terms of the states first to last - 1, one kind, are below a part of their
 * first ones, |c[n]| h^n <= part |c[i]| h^i for some i < 3; or log_h, if that is less.  The part is `local`, or `rate` h if that
 * is larger, given by their logarithms; over[k] = 1/(top - k). */
static ${name}_real ${name}_taylor_reach(${name}_real c[][${upper}_ROW], int top, int first, int last, ${name}_real log_local, ${name}_real log_rate, const ${name}_real over[], ${name}_real log_h)
{
  ${name}_real head[3];

  for (int i = 0; i < 3; i++) {
    head[i] = ${zero};
    for (int k = first; k < last; k++) head[i] = ${fabs}(c[i][k]) > head[i] ? ${fabs}(c[i][k]) : head[i];
    head[i] = ${name}_taylor_log2(head[i]);
  }
  for (int n = top - 1; n <= top; n++) {
    ${name}_real tail = ${zero}, best = ${one} - ${bias}, at;

    for (int k = first; k < last; k++) tail = ${fabs}(c[n][k]) > tail ? ${fabs}(c[n][k]) : tail;
    if (!(tail > ${zero})) continue; /* nothing moves */
    tail = ${name}_taylor_log2(tail);
    for (int i = 0; i < 3 && i + 1 < n; i++) {
      at = (log_local + head[i] - tail)*over[top - n + i];
      best = at > best ? at : best;
      at = (log_rate + head[i] - tail)*over[top - n + i + 1];
      best = at > best ? at : best;
    }
    log_h = best < log_h ? best : log_h;
  }
  return log_h;
}

/* The largest step of all kinds of state. */
static ${name}_real ${name}_taylor_size(${name}_real c[][${upper}_ROW], int top, ${name}_real local, ${name}_real rate)
{
  const ${name}_real log_local = ${name}_taylor_log2(local), log_rate = ${name}_taylor_log2(rate);
  ${name}_real log_h = ${n[64]}, over[5];

  for (int k = 0; k < 5; k++) over[k] = ${one}/(${name}_real)(top - k > 0 ? top - k : 1);
%% for _, k in ipairs(kinds) do
  log_h = ${name}_taylor_reach(c, top, ${k.first}, ${k.last}, log_local, log_rate, over, log_h); /* ${k.about} */
%% end
  return ${name}_taylor_exp2(log_h);
}

static ${name}_real ${name}_taylor_limit(${name}_real size, ${name}_real h)
{
  return size < ${fabs}(h) ? h < ${zero} ? -size : size : h;
}

