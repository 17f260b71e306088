%% -- lagrange_tick.c -- the heavy top at equal steps: part of scene.c.  SPDX-License-Identifier: MIT-0
int ${name}_set_tick(${name}_orbit *o, ${name}_real h)
{
  const ${name}_pair rate = {o->rate[0], o->rate[1]}, start = {o->start[0], o->start[1]}, period = {o->period[0], o->period[1]};
  ${name}_pair per = ${name}_pair_of(${zero}), first = per, mean[2];

  if (o->inverse > ${zero}) {
    per = ${name}_ratio(rate, period);
    first = ${name}_ratio(start, period);
  }
  for (int i = 0; i < 2; i++) { /* turns per tick, what goes off with each period evenly spread */
    const ${name}_pair turn = {o->turn[i][0], o->turn[i][1]}, jump = {o->jump[i][0], o->jump[i][1]};

    mean[i] = ${name}_scaled(h, ${name}_add(turn, ${name}_mul(jump, per)));
    if (!(mean[i].hi - mean[i].hi == ${zero})) return 1;
  }
  per = ${name}_scaled(h, per);
  if (!(per.hi - per.hi == ${zero})) return 1;
  o->tick = h;
  ${name}_fraction_bits(${name}_pair_scale(per, -1), o->counts[0].tick); /* of two periods: the last bit is the sign */
  ${name}_fraction_bits(${name}_pair_scale(first, -1), o->counts[0].start);
  for (int i = 0; i < 2; i++) {
    const ${name}_pair jump = {o->jump[i][0], o->jump[i][1]};

    ${name}_fraction_bits(mean[i], o->counts[i + 1].tick);
    ${name}_fraction_bits(${name}_mul(jump, first), o->counts[i + 1].start);
  }
  return 0;
}

void ${name}_at_tick(const ${name}_orbit *o, int64_t n, ${name}_real x[])
{
  const uint64_t two = ${name}_counted(o->counts[0].start, o->counts[0].tick, n);
  const ${name}_real r = ${name}_as_turns(two << 1), a = ${name}_as_turns(${name}_counted(o->counts[1].start, o->counts[1].tick, n));
  const ${name}_real b = ${name}_as_turns(${name}_counted(o->counts[2].start, o->counts[2].tick, n));
  const ${name}_pair p = ${name}_pair_product(r, o->period[0]);
  ${name}_instant f;
  ${name}_values v;

  f.flip = (two + ((uint64_t)1 << 62)) >> 63 ? -${one} : ${one};
  f.high = p.hi;
  f.low = p.lo + r*o->period[1];
  f.a = a - o->jump[0][0]*r;
  f.b = b - o->jump[1][0]*r;
  f.a -= ${name}_nearest(f.a);
  f.b -= ${name}_nearest(f.b);
  if (!(o->inverse > ${zero})) { /* rare: the separatrix has no period */
    const uint64_t size = n < 0 ? 0 - (uint64_t)n : (uint64_t)n; /* in halves: small processors convert no more */
    const ${name}_real ticks = (${name}_real)(uint32_t)(size >> 32)*${two32_up} + (${name}_real)(uint32_t)size;
    const ${name}_pair t = ${name}_pair_product(n < 0 ? -ticks : ticks, o->tick);
    ${name}_pair q = {o->start[0], o->start[1]};

    q = ${name}_phase(q, o->rate, t.hi);
    q.lo += o->rate[0]*t.lo;
    f.high = q.hi;
    f.low = q.lo;
  }
  v = o->hyperbolic ? ${name}_hyperbolic_values(o, f) : ${name}_circular_values(o, f);
  ${name}_put(o, &v, ${one}/${sqrt}(${name}_length2(&v)), x + ${upper}_QW, x + ${upper}_WX);
}
