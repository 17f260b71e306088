%% -- query.c -- periods, rotation number and flips of the free top: part of scene.c.  SPDX-License-Identifier: MIT-0
/* ---- inverse questions ---- */

/* are the rates periodic? */
static int ${name}_periodic(const ${name}_orbit *o)
{
  return o->inverse > ${zero};
}

/* half-periods of the rates (0 if they have none) and turns about L in a second, both times 2^-e; the result is e.
 * b winds once more than a in each period of the rates: the phase of a is 2 mu, that of both together 2 mu + s z'. */
static int ${name}_means(const ${name}_orbit *o, ${name}_pair *halves, ${name}_pair *turns)
{
  const ${name}_pair rate = {o->rate[0], o->rate[1]}, period = {o->period[0], o->period[1]};
  const ${name}_pair turn = {o->turn[0], o->turn[1]}, jump = {o->jump[0], o->jump[1]};
  int e;

  (void)${frexp}(${fabs}(turn.hi) > rate.hi ? turn.hi : rate.hi, &e);
  *halves = ${name}_pair_of(${zero});
  if (${name}_periodic(o)) *halves = ${name}_pair_divide(${name}_pair_scale(rate, -e), period);
  *turns = ${name}_pair_subtract(${name}_pair_scale(turn, -e), ${name}_pair_multiply(jump, *halves));
  *turns = ${name}_pair_add(${name}_pair_scale(*turns, 1), ${name}_pair_times(o->s*${half}, *halves));
  return e;
}

${name}_real ${name}_polhode_period(const ${name}_orbit *o)
{
  if (!(o->rate[0] > ${zero})) return ${zero};
  return ${name}_periodic(o) ? ${two}*(o->period[0]/o->rate[0]) : ${huge};
}

${name}_real ${name}_precession_rate(const ${name}_orbit *o)
{
  ${name}_pair halves, turns;
  const int e = ${name}_means(o, &halves, &turns);

  return ${ldexp}(${name}_pair_multiply(${name}_pi(), turns).hi, e + 1);
}

${name}_real ${name}_precession_period(const ${name}_orbit *o)
{
  ${name}_pair halves, turns;
  const int e = ${name}_means(o, &halves, &turns);

  return turns.hi > ${zero} ? ${ldexp}(${name}_pair_divide(${name}_pair_of(${one}), turns).hi, -e) : ${huge};
}

${name}_real ${name}_rotation_number(const ${name}_orbit *o)
{
  ${name}_pair halves, turns;

  if (!(o->rate[0] > ${zero})) return ${zero};
  (void)${name}_means(o, &halves, &turns);
  return ${name}_periodic(o) ? ${two}*${name}_pair_divide(turns, halves).hi : ${huge};
}

/* start + rate t = n period, n the first integer whose t is later after rounding */
${name}_real ${name}_next_flip(const ${name}_orbit *o, ${name}_real t)
{
  const ${name}_pair start = {o->start[0], o->start[1]}, period = {o->period[0], o->period[1]};
  ${name}_pair rate = {o->rate[0], o->rate[1]}, n = ${name}_pair_of(${zero});
  ${name}_real next;
  int e, i;

  if (!(rate.hi > ${zero})) return ${huge};
  (void)${frexp}(rate.hi, &e); /* time in units of 2^-e, so that nothing leaves the range before t has no digits left */
  rate = ${name}_pair_scale(rate, -e);
  if (!${name}_periodic(o)) {
    next = ${ldexp}(${name}_pair_divide(${name}_pair_minus(start), rate).hi, -e);
    return next > t ? next : ${huge};
  }
  n = ${name}_pair_divide(${name}_pair_add(start, ${name}_pair_times(${ldexp}(t, e), rate)), period);
  next = ${floor}(n.hi);
  n = ${name}_pair_sum(next, next < n.hi ? ${zero} : ${floor}(n.lo));
  for (i = 0; i < 2; i++) {
    n = ${name}_pair_add(n, ${name}_pair_of(${one}));
    next = ${ldexp}(${name}_pair_divide(${name}_pair_subtract(${name}_pair_multiply(n, period), start), rate).hi, -e);
    if (next > t) return next;
  }
  return t + ${fabs}(t)*${epsilon}; /* a period is less than t's last place: every t is near a flip */
}
