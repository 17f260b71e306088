%% -- count.c -- phases that are counted in integers: part of scene.c.  SPDX-License-Identifier: MIT-0
/* ---- time in ticks: phases as fractions of a turn, 128 bits, in which whole turns vanish by overflow ---- */

/* a less whole turns, in units of 2^-128: {high, low}; sixteen bits at a time, each step exact */
static void ${name}_fraction_bits(${name}_pair a, uint64_t out[2])
{
  const int negative = a.hi < ${zero}; /* its size keeps the digits that 1 - |a| has not */

  if (negative) {
    a.hi = -a.hi;
    a.lo = -a.lo;
  }
  if (!(${fabs}(a.lo) < ${one})) a.lo -= ${floor}(a.lo); /* so many turns that the rest has whole ones, too */
  a = ${name}_add(${name}_pair_sum(a.hi, -${floor}(a.hi)), ${name}_pair_of(a.lo));
  if (a.hi < ${zero}) a = ${name}_add(a, ${name}_pair_of(${one}));
  out[0] = out[1] = 0;
  for (int i = 0; i < 8; i++) {
    ${name}_real whole;

    a.hi *= ${n[65536]};
    a.lo *= ${n[65536]};
    whole = ${floor}(a.hi);
    if (!(a.hi > whole) && a.lo < ${zero}) whole -= ${one};
    a = ${name}_pair_sum(a.hi - whole, a.lo);
    out[i/4] = out[i/4] << 16 | ((uint32_t)(int32_t)whole & 0xFFFFU);
  }
  if (negative) {
    out[0] = 0 - out[0] - (out[1] > 0 ? 1U : 0U);
    out[1] = 0 - out[1];
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
static ${name}_real ${name}_as_turns(uint64_t f)
{
%% if single then
  const uint32_t high = (uint32_t)(f >> 32); /* float has no more digits, and small processors no wider conversion */

  return high >> 31 ? -((${name}_real)(0 - high)*${two32}) : (${name}_real)high*${two32};
%% else
  return f >> 63 ? -((${name}_real)(0 - f)*${two64}) : (${name}_real)f*${two64};
%% end
}
