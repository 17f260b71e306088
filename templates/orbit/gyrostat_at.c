%% -- gyrostat_at.c -- the asymmetric gyrostat's values at its phases: part of scene.c.  SPDX-License-Identifier: MIT-0
/* after turns of a and b; flip: the sign of both; f + i g = conj(a) b */
${inline} ${name}_values ${name}_turned(const ${name}_real re[2], const ${name}_real im[2], ${name}_instant p)
{
  ${name}_values v;
  ${name}_real sa, ca, sb, cb;

  ${name}_circle(p.a, &sa, &ca);
  ${name}_circle(p.b, &sb, &cb);
  v.w = p.flip*(ca*re[0] - sa*im[0]);
  v.z = p.flip*(sa*re[0] + ca*im[0]);
  v.x = p.flip*(cb*re[1] - sb*im[1]);
  v.y = p.flip*(sb*re[1] + cb*im[1]);
  v.f = v.w*v.x + v.z*v.y;
  v.g = v.w*v.y - v.z*v.x;
  return v;
}

/* the series as polynomials in cos 2z, times sin z and cos z or cos z and sin z */
${inline} ${name}_values ${name}_circular_values(const ${name}_orbit *o, ${name}_instant p)
{
  ${name}_real s, c, x, x2, re[2], im[2];

  ${name}_circle(${half}*p.high, &s, &c);
  x = (c - s)*(c + s);
  x2 = x*x;
  for (int i = 0; i < 2; i++) {
    const ${name}_real k = o->odd[i], first = k*s + (${one} - k)*c, second = k*c + (${one} - k)*s;

    re[i] = first*((o->re[i][0] + x*o->re[i][1]) + x2*((o->re[i][2] + x*o->re[i][3]) + x2*o->re[i][4]));
    im[i] = second*((o->im[i][0] + x*o->im[i][1]) + x2*((o->im[i][2] + x*o->im[i][3]) + x2*o->im[i][4]));
  }
  return ${name}_turned(re, im, p);
}

static ${name}_real ${name}_sum_of(const ${name}_real c[6], ${name}_real x)
{
  return c[0] + x*(c[1] + x*(c[2] + x*(c[3] + x*(c[4] + x*c[5]))));
}

/* in e = exp(-|phase|), up = exp(2 |phase| - P) <= 1 and down = exp(-2 |phase| - P) */
static ${name}_values ${name}_hyperbolic_values(const ${name}_orbit *o, ${name}_instant p)
{
  const ${name}_real sign = p.high < ${zero} ? -${one} : ${one}, low = sign*p.low, high = ${fabs}(p.high);
  const ${name}_real first = ${exp}(-high), e = first - first*low, period = o->period[0];
  ${name}_real up = ${zero}, down = ${zero}, re[2], im[2];

  if (o->inverse > ${zero}) {
    up = ${exp}(((high + high) - period) + ((low + low) - o->period[1]));
    down = ${exp}(-period - (high + high));
  }
  for (int i = 0; i < 2; i++) {
    const int odd = o->odd[i] > ${half}, even = o->hyperbolic == 1 && !odd;
    const ${name}_real size = o->hyperbolic == 1 && odd ? o->nome : ${one}, part = even ? ${one} : e*e, all = even ? e : ${one};
    const ${name}_real U = size*up, V = size*down;
    const ${name}_real c = ${name}_sum_of(o->re[i], U), d = part*${name}_sum_of(o->re[i], V);
    const ${name}_real f = ${name}_sum_of(o->im[i], U), g = part*${name}_sum_of(o->im[i], V);

    re[i] = all*(odd ? sign*(c - d) : c + d);
    im[i] = all*(odd ? f + g : sign*(f - g));
  }
  return ${name}_turned(re, im, p);
}

static ${name}_values ${name}_untwisted(const ${name}_orbit *o, ${name}_instant p)
{
  return o->hyperbolic ? ${name}_hyperbolic_values(o, p) : ${name}_circular_values(o, p);
}

/* attitude and rates from the values and 1/length of their quaternion */
${inline} void ${name}_put(const ${name}_orbit *o, const ${name}_values *v, ${name}_real n, ${name}_real q[4], ${name}_real w[3])
{
  const ${name}_real square = n*n, a2 = square*(v->w*v->w + v->z*v->z), b2 = square*(v->x*v->x + v->y*v->y);
  const ${name}_real f = square*v->f, h = square*v->g;
  ${name}_real r[4], g;

  w[0] = (a2*o->along[0][0] + b2*o->along[1][0]) + (f*o->across[0][0] + h*o->across[1][0]);
  w[1] = (a2*o->along[0][1] + b2*o->along[1][1]) + (f*o->across[0][1] + h*o->across[1][1]);
  w[2] = (a2*o->along[0][2] + b2*o->along[1][2]) + (f*o->across[0][2] + h*o->across[1][2]);
  r[0] = n*((v->w*o->q[0][0] + v->x*o->q[1][0]) + (v->y*o->q[2][0] + v->z*o->q[3][0]));
  r[1] = n*((v->w*o->q[0][1] + v->x*o->q[1][1]) + (v->y*o->q[2][1] + v->z*o->q[3][1]));
  r[2] = n*((v->w*o->q[0][2] + v->x*o->q[1][2]) + (v->y*o->q[2][2] + v->z*o->q[3][2]));
  r[3] = n*((v->w*o->q[0][3] + v->x*o->q[1][3]) + (v->y*o->q[2][3] + v->z*o->q[3][3]));
  /* rounding only: one Newton step for 1/|q| */
  g = ${threehalves} - ${half}*((r[0]*r[0] + r[1]*r[1]) + (r[2]*r[2] + r[3]*r[3]));
  q[0] = g*r[0];
  q[1] = g*r[1];
  q[2] = g*r[2];
  q[3] = g*r[3];
}

${name}_real ${name}_polhode_period(const ${name}_orbit *o)
{
  if (!(o->rate[0] > ${zero})) return ${zero};
  return o->inverse > ${zero} ? o->period[0]/o->rate[0] : ${huge};
}

${name}_real ${name}_precession_rate(const ${name}_orbit *o)
{
  return o->mean;
}
