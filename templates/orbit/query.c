%% -- query.c -- periods, rotation number and flips of the free top: part of scene.c.  SPDX-License-Identifier: MIT-0
/* ---- inverse questions ---- */

/* are the rates periodic? */
static int ${name}_has_period(const ${name}_orbit *o)
{
  return o->half < ${no_period};
}

/* Periods of the rates (0 if they have none) and turns about L in a second, both times 2^-e; the result is e.  b winds
 * once more than a in each period of z, of which the rates' has two: the phase of a is 2 mu, of both 2 mu + s z'. */
static int ${name}_means(const ${name}_orbit *o, ${name}_pair *periods, ${name}_pair *turns)
{
  const ${name}_pair rate = {o->rate[0], o->rate[1]}, turn = {o->turn[0], o->turn[1]};
  int e;

  (void)${frexp}(${fabs}(turn.hi) > rate.hi ? turn.hi : rate.hi, &e);
  *periods = ${name}_has_period(o) ? ${name}_pair_scale(rate, -e) : ${name}_pair_of(${zero});
  *turns = ${name}_add(${name}_pair_scale(turn, 1 - e), ${name}_scaled(o->s, *periods));
  return e;
}

${name}_real ${name}_polhode_period(const ${name}_orbit *o)
{
  if (!(o->rate[0] > ${zero})) return ${zero};
  return ${name}_has_period(o) ? ${one}/o->rate[0] : ${huge};
}

${name}_real ${name}_precession_rate(const ${name}_orbit *o)
{
  ${name}_pair periods, turns;
  const int e = ${name}_means(o, &periods, &turns);

  return ${ldexp}(${name}_mul(${name}_pair_pi, turns).hi, e + 1);
}

${name}_real ${name}_precession_period(const ${name}_orbit *o)
{
  ${name}_pair periods, turns;
  const int e = ${name}_means(o, &periods, &turns);

  return turns.hi > ${zero} ? ${ldexp}(${name}_ratio(${name}_pair_of(${one}), turns).hi, -e) : ${huge};
}

${name}_real ${name}_rotation_number(const ${name}_orbit *o)
{
  ${name}_pair periods, turns;

  if (!(o->rate[0] > ${zero})) return ${zero};
  (void)${name}_means(o, &periods, &turns);
  return ${name}_has_period(o) ? ${name}_ratio(turns, periods).hi : ${huge};
}

/* start + rate t = n/2, n the first integer whose t is later after rounding; on the separatrix n = 0 alone */
${name}_real ${name}_next_flip(const ${name}_orbit *o, ${name}_real t)
{
  const ${name}_pair start = {o->start[0], o->start[1]};
  ${name}_pair rate = {o->rate[0], o->rate[1]}, n = ${name}_pair_of(${zero});
  ${name}_real next;
  int e;

  if (!(rate.hi > ${zero})) return ${huge};
  (void)${frexp}(rate.hi, &e); /* time in units of 2^-e, so that nothing leaves the range before t has no digits left */
  rate = ${name}_pair_scale(rate, -e);
  if (!${name}_has_period(o)) {
    next = ${ldexp}(${name}_ratio(${name}_minus(start), rate).hi, -e);
    return next > t ? next : ${huge};
  }
  n = ${name}_pair_scale(${name}_add(start, ${name}_scaled(${ldexp}(t, e), rate)), 1);
  next = ${floor}(n.hi);
  n = ${name}_pair_sum(next, next < n.hi ? ${zero} : ${floor}(n.lo));
  for (int i = 0; i < 2; i++) {
    n = ${name}_add(n, ${name}_pair_of(${one}));
    next = ${ldexp}(${name}_ratio(${name}_sub(${name}_pair_scale(n, -1), start), rate).hi, -e);
    if (next > t) return next;
  }
  return t + ${fabs}(t)*${epsilon}; /* a period is less than t's last place: every t is near a flip */
}
