%% -- tick.c -- the free top at equal steps, its phases counted in integers: part of scene.c.  SPDX-License-Identifier: MIT-0
int ${name}_set_tick(${name}_orbit *o, ${name}_real h)
{
  const ${name}_pair rate = {o->rate[0], o->rate[1]}, start = {o->start[0], o->start[1]}, turn = {o->turn[0], o->turn[1]};
  const ${name}_pair per = ${name}_scaled(h, rate), mean = ${name}_scaled(h, turn);

  if (!(per.hi - per.hi == ${zero}) || !(mean.hi - mean.hi == ${zero})) return 1;
  o->tick = h;
  ${name}_fraction_bits(per, o->rate_tick);
  ${name}_fraction_bits(start, o->rate_start);
  ${name}_fraction_bits(mean, o->turn_tick);
  o->turn_start[0] = o->turn_start[1] = 0;
  return 0;
}

void ${name}_at_tick(const ${name}_orbit *o, int64_t n, ${name}_real x[])
{
  const uint64_t phase = ${name}_counted(o->rate_start, o->rate_tick, n);
  const uint64_t turn = ${name}_counted(o->turn_start, o->turn_tick, n), last = 0xFFFFFFFFFFFFU; /* 48 bits */
  const ${name}_real low = ${half}*${name}_as_turns(phase << 1); /* without the half period that is nearest */
  ${name}_instant p;

  p.high = (phase + ((uint64_t)1 << 62)) >> 63 ? (low > ${zero} ? -${half} : ${half}) : ${zero};
  p.low = low;
  if (!(o->half < ${no_period})) { /* rare: the separatrix has no period */
    const uint64_t size = n < 0 ? 0 - (uint64_t)n : (uint64_t)n; /* in halves: small processors convert no more */
    const ${name}_real ticks = (${name}_real)(uint32_t)(size >> 32)*${two32_up} + (${name}_real)(uint32_t)size;
    const ${name}_pair t = ${name}_pair_product(n < 0 ? -ticks : ticks, o->tick);

    p = ${name}_reduce(o, t.hi);
    p.low += o->rate[0]*t.lo;
  }
  p.turn = ${name}_as_turns(turn & ~last);
  p.turn_low = ${name}_as_turns(turn & last);
  ${name}_state(o, p, x);
}
