%% -- tick.c -- the free top at equal steps, its phases counted in integers: part of scene.c.  SPDX-License-Identifier: MIT-0
/* ---- time in ticks: phases as fractions of a turn, 128 bits, in which whole turns vanish by overflow ---- */

/* a less whole turns, in units of 2^-128: {high, low}; sixteen bits at a time, each step exact */
static void ${name}_fraction(${name}_pair a, uint64_t out[2])
{
  int i;

  a = ${name}_pair_add(${name}_pair_sum(a.hi, -${floor}(a.hi)), ${name}_pair_of(a.lo));
  if (a.hi < ${zero}) a = ${name}_pair_add(a, ${name}_pair_of(${one}));
  out[0] = out[1] = 0;
  for (i = 0; i < 8; i++) {
    ${name}_real whole;

    a.hi *= (${name}_real)65536;
    a.lo *= (${name}_real)65536;
    whole = ${floor}(a.hi);
    if (!(a.hi > whole) && a.lo < ${zero}) whole -= ${one};
    a = ${name}_pair_sum(a.hi - whole, a.lo);
    out[i/4] = out[i/4] << 16 | ((uint32_t)(int32_t)whole & 0xFFFFU);
  }
}

/* the upper half of start + n rate, modulo a turn */
static uint64_t ${name}_counted(const uint64_t start[2], const uint64_t rate[2], int64_t n)
{
  const uint64_t m = n < 0 ? 0 - (uint64_t)n : (uint64_t)n, a = m >> 32, b = m & 0xFFFFFFFFU;
  const uint64_t c = rate[1] >> 32, d = rate[1] & 0xFFFFFFFFU;
  const uint64_t middle = a*d + (b*d >> 32), cross = b*c + (middle & 0xFFFFFFFFU); /* m rate[1], its upper half */
  uint64_t high = m*rate[0] + a*c + (middle >> 32) + (cross >> 32), low = m*rate[1], sum;

  if (n < 0) {
    high = 0 - high - (low > 0 ? 1U : 0U);
    low = 0 - low;
  }
  sum = start[1] + low;
  return start[0] + high + (sum < low ? 1U : 0U);
}

/* a fraction as a signed number of turns, |turns| <= 1/2 */
static ${name}_real ${name}_turns(uint64_t f)
{
%% if single then
  const uint32_t high = (uint32_t)(f >> 32); /* float has no more digits, and small processors no wider conversion */

  return high >> 31 ? -((${name}_real)(0 - high)*${two32}) : (${name}_real)high*${two32};
%% else
  return f >> 63 ? -((${name}_real)(0 - f)*${two64}) : (${name}_real)f*${two64};
%% end
}

int ${name}_set_tick(${name}_orbit *o, ${name}_real h)
{
  const ${name}_pair rate = {o->rate[0], o->rate[1]}, start = {o->start[0], o->start[1]}, turn = {o->turn[0], o->turn[1]};
  const ${name}_pair per = ${name}_pair_times(h, rate), mean = ${name}_pair_times(h, turn);

  if (!(per.hi - per.hi == ${zero}) || !(mean.hi - mean.hi == ${zero})) return 1;
  o->tick = h;
  ${name}_fraction(per, o->rate_tick);
  ${name}_fraction(start, o->rate_start);
  ${name}_fraction(mean, o->turn_tick);
  o->turn_start[0] = o->turn_start[1] = 0;
  return 0;
}

void ${name}_at_tick(const ${name}_orbit *o, int64_t n, ${name}_real x[])
{
  const uint64_t phase = ${name}_counted(o->rate_start, o->rate_tick, n);
  const uint64_t turn = ${name}_counted(o->turn_start, o->turn_tick, n), last = 0xFFFFFFFFFFFFU; /* 48 bits */
  const ${name}_real low = ${half}*${name}_turns(phase << 1); /* without the half period that is nearest */
  ${name}_phases p;

  p.high = (phase + ((uint64_t)1 << 62)) >> 63 ? (low > ${zero} ? -${half} : ${half}) : ${zero};
  p.low = low;
  if (!(o->half < ${no_period})) { /* the separatrix has no period */
    const ${name}_pair t = ${name}_pair_product((${name}_real)n, o->tick);

    p = ${name}_reduce(o, t.hi);
    p.low += o->rate[0]*t.lo;
  }
  p.turn = ${name}_turns(turn & ~last);
  p.turn_low = ${name}_turns(turn & last);
  ${name}_state(o, p, x);
}
