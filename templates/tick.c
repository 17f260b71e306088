%% -- tick.c -- the free top at equal steps, its phases counted in integers: part of scene.c.  SPDX-License-Identifier: MIT-0
int ${name}_set_tick(${name}_orbit *o, ${name}_real h)
{
  const ${name}_pair rate = {o->rate[0], o->rate[1]}, start = {o->start[0], o->start[1]};
  const ${name}_pair turn = {o->turn[0], o->turn[1]}, jump = {o->jump[0], o->jump[1]};
  const ${name}_pair period = {o->period[0], o->period[1]};
  ${name}_pair per = ${name}_pair_of(${zero}), first = ${name}_pair_of(${zero}), mean;

  if (o->inverse > ${zero}) {
    per = ${name}_pair_divide(rate, period);
    first = ${name}_pair_divide(start, period);
  }
  mean = ${name}_pair_times(h, ${name}_pair_subtract(turn, ${name}_pair_multiply(jump, per)));
  per = ${name}_pair_times(h, per);
  if (!(per.hi - per.hi == ${zero}) || !(mean.hi - mean.hi == ${zero})) return 1;
  o->tick = h;
  ${name}_fraction(${name}_pair_scale(per, -1), o->rate_tick); /* of two periods: the last bit is the sign */
  ${name}_fraction(${name}_pair_scale(first, -1), o->rate_start);
  ${name}_fraction(mean, o->turn_tick);
  ${name}_fraction(${name}_pair_minus(${name}_pair_multiply(jump, first)), o->turn_start);
  return 0;
}

void ${name}_at_tick(const ${name}_orbit *o, int64_t n, ${name}_real x[])
{
  const uint64_t two = ${name}_counted(o->rate_start, o->rate_tick, n);
  ${name}_real r = ${name}_turns(two << 1), turn = ${name}_turns(${name}_counted(o->turn_start, o->turn_tick, n));
  const int odd = (int)((two + ((uint64_t)1 << 62)) >> 63);

  if (o->hyperbolic) {
    turn += o->jump[0]*r;
    turn -= ${name}_nearest(turn);
    r *= o->period[0];
    if (!(o->inverse > ${zero})) { /* the separatrix has no period */
      ${name}_pair t = ${name}_pair_product((${name}_real)n, o->tick), p = ${name}_pair_of(o->start[0]);

      p.lo = o->start[1] + o->rate[0]*t.lo;
      p = ${name}_phase(p, o->rate, t.hi);
      r = p.hi + p.lo;
    }
  }
  ${name}_state(o, r, odd ? -${one} : ${one}, turn, x);
}

void ${name}_at_rates(const ${name}_orbit *o, ${name}_real t, ${name}_real w[])
{
  ${name}_real r, turn, flip, y[4], f[3], n;
  int i;

  ${name}_reduce(o, t, &r, &turn, &flip);
  ${name}_functions(o, r, flip, ${zero}, y, f);
  n = ${one}/(y[0]*y[0] + y[1]*y[1] + y[2]*y[2] + y[3]*y[3]);
  for (i = 0; i < 3; i++) w[i] = n*(f[0]*o->w[0][i] + f[1]*o->w[1][i] + f[2]*o->w[2][i]);
}

void ${name}_at_attitude(const ${name}_orbit *o, ${name}_real t, ${name}_real q[])
{
  ${name}_real r, turn, flip, y[4], f[3];

  ${name}_reduce(o, t, &r, &turn, &flip);
  ${name}_functions(o, r, flip, turn, y, f);
  ${name}_attitude(o, y, q);
}

${name}_real ${name}_polhode_period(const ${name}_orbit *o)
{
  if (!(o->rate[0] > ${zero})) return ${zero};
  return o->inverse > ${zero} ? ${two}*o->period[0]/o->rate[0] : ${huge};
}

/* 2 mu + s z': b winds once more than a in each period of z */
${name}_real ${name}_precession_rate(const ${name}_orbit *o)
{
  const ${name}_real per = o->rate[0]*o->inverse;

  return ${pi_high}*(${two}*${two}*(o->turn[0] - o->jump[0]*per) + o->s*per);
}
