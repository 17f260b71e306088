%% -- phases.c -- phases of theta functions at a time: part of scene.c.  SPDX-License-Identifier: MIT-0
/* w, x, y, z of a = w + i z, b = x + i y, and the rates across the axis, all but for one factor */
typedef struct ${name}_values { ${name}_real w, x, y, z, f, g; } ${name}_values;

/* high + low: the phase of the nutation, less whole periods, and the sign of their number; the turns of a and b, less
 * whole ones */
typedef struct ${name}_instant { ${name}_real high, low, flip, a, b; } ${name}_instant;

/* p less whole turns; where nothing is left of a phase, beyond some 2^50 of them, it is put to 0 */
${inline} ${name}_real ${name}_fraction_of(${name}_pair p)
{
  const ${name}_real x = (p.hi - ${name}_nearest(p.hi)) + p.lo;

  return ${fabs}(x) <= ${one} ? x : ${zero};
}

/* (-1)^n; where the nearest whole number is none any more, beyond 2^51 (float: 2^22) and below 0, any sign will do */
${inline} ${name}_real ${name}_parity(${name}_real n)
{
  return ${fabs}(n - ${two}*${name}_nearest(${half}*n)) > ${half} ? -${one} : ${one};
}

/* away from the separatrix: in half turns of z */
${inline} ${name}_instant ${name}_circular_phases(const ${name}_orbit *o, ${name}_real t)
{
  const ${name}_pair start = {o->start[0], o->start[1]}, none = {${zero}, ${zero}};
  const ${name}_pair p = ${name}_phase(start, o->rate, t);
  ${name}_instant f;

  f.flip = ${name}_parity(${name}_nearest(p.hi));
  f.high = ${name}_fraction_of(p);
  f.low = ${zero};
  f.a = ${name}_fraction_of(${name}_phase(none, o->turn[0], t));
  f.b = ${name}_fraction_of(${name}_phase(none, o->turn[1], t));
  return f;
}

/* near it: the phase has the period P, or none, and the turns jump with each */
static ${name}_instant ${name}_hyperbolic_phases(const ${name}_orbit *o, ${name}_real t)
{
  ${name}_pair p = {o->start[0], o->start[1]}, whole, jump;
  ${name}_instant f;
  ${name}_real n = ${zero};

  p = ${name}_phase(p, o->rate, t);
  for (int i = 0; i < 2; i++) { /* of very many periods the first count may be off by one */
    const ${name}_real more = ${name}_nearest(p.hi*o->inverse);

    whole = ${name}_pair_product(more, o->period[0]);
    p = ${name}_pair_sum(p.hi - whole.hi, p.lo - whole.lo - more*o->period[1]);
    n += more;
  }
  if (!(${fabs}(p.hi)*o->inverse <= ${n[513/1024]})) p = ${name}_pair_of(${zero}); /* nothing is left of it */
  f.flip = ${name}_parity(n);
  f.high = p.hi;
  f.low = p.lo;
  jump = ${name}_pair_product(n, o->jump[0][0]);
  jump.lo += n*o->jump[0][1];
  f.a = ${name}_fraction_of(${name}_phase(jump, o->turn[0], t));
  jump = ${name}_pair_product(n, o->jump[1][0]);
  jump.lo += n*o->jump[1][1];
  f.b = ${name}_fraction_of(${name}_phase(jump, o->turn[1], t));
  return f;
}

${inline} ${name}_real ${name}_length2(const ${name}_values *v)
{
  return (v->w*v->w + v->z*v->z) + (v->x*v->x + v->y*v->y);
}

/* The mean rate at which b/a goes round, rad/s: the turns of a and b, what goes off them with each period of the phase,
 * and half a turn for each sign.  In pairs: of a fast spin nearly all of the turns cancels. */
static ${name}_real ${name}_mean_of(const ${name}_orbit *o, const int sign[2])
{
  ${name}_pair mean = ${name}_pair_of(${zero}), n = mean;

  if (o->inverse > ${zero}) n = ${name}_ratio(${name}_parts(o->rate[0], o->rate[1]), ${name}_parts(o->period[0], o->period[1]));
  for (int i = 0; i < 2; i++) {
    mean = ${name}_add(mean, ${name}_parts(o->turn[i][0], o->turn[i][1]));
    mean = ${name}_add(mean, ${name}_mul(${name}_parts(o->jump[i][0], o->jump[i][1]), n));
    mean = ${name}_add(mean, ${name}_scaled((${name}_real)sign[i]*${half}, n));
  }
  return ${name}_pair_scale(${name}_mul(mean, ${name}_pair_pi), 1).hi;
}
