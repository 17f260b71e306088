%% -- lagrange_at.c -- the heavy top's values at its phases: part of scene.c.  SPDX-License-Identifier: MIT-0
/* X of a, b and W, see lagrange_theta.c, after turns of a and b; flip: the sign of both */
${inline} ${name}_values ${name}_turned(const ${name}_real re[3], const ${name}_real im[3], ${name}_real flip,
                                              ${name}_real turn_a, ${name}_real turn_b)
{
  ${name}_values v;
  ${name}_real sa, ca, sb, cb, re_, im_;

  ${name}_circle(turn_a, &sa, &ca);
  ${name}_circle(turn_b, &sb, &cb);
  v.w = flip*(ca*re[0] - sa*im[0]);
  v.z = flip*(sa*re[0] + ca*im[0]);
  v.x = flip*(cb*re[1] - sb*im[1]);
  v.y = flip*(sb*re[1] + cb*im[1]);
  re_ = ca*cb + sa*sb;
  im_ = ca*sb - sa*cb;
  v.f = re_*re[2] - im_*im[2];
  v.g = im_*re[2] + re_*im[2];
  return v;
}

/* the series as polynomials in cos 2z */
${inline} ${name}_values ${name}_circular_values(const ${name}_orbit *o, ${name}_instant p)
{
  ${name}_real s, c, x, x2, re[3], im[3], cw, sw, f;

  ${name}_circle(${half}*p.high, &s, &c);
  x = (c - s)*(c + s);
  x2 = x*x;
  re[0] = s*((o->re[0][0] + x*o->re[0][1]) + x2*(o->re[0][2] + x*o->re[0][3]));
  im[0] = c*((o->im[0][0] + x*o->im[0][1]) + x2*(o->im[0][2] + x*o->im[0][3]));
  re[1] = c*((o->re[1][0] + x*o->re[1][1]) + x2*(o->re[1][2] + x*o->re[1][3]));
  im[1] = s*((o->im[1][0] + x*o->im[1][1]) + x2*(o->im[1][2] + x*o->im[1][3]));
  cw = c*((o->re[2][0] + x*o->re[2][1]) + x2*(o->re[2][2] + x*o->re[2][3]));
  sw = s*((o->im[2][0] + x*o->im[2][1]) + x2*(o->im[2][2] + x*o->im[2][3]));
  f = o->winding*s;
  re[2] = c*cw - f*sw;
  im[2] = c*sw + f*cw;
  return ${name}_turned(re, im, p.flip, p.a, p.b);
}

/* in e = exp(-|phase|) and g = q' e^-2 <= 1 */
static ${name}_values ${name}_hyperbolic_values(const ${name}_orbit *o, ${name}_instant p)
{
  const ${name}_real sign = p.high < ${zero} ? -${one} : ${one}, first = ${exp}(-${fabs}(p.high));
  const ${name}_real e = (first - first*(sign*p.low)) + ${least}, root = o->nome/e, g = root*root, E = e*e, f = E*E*g;
  const ${name}_real h = (o->nome*e)*(o->nome*e);
  ${name}_real re[3], im[3];

  re[0] = sign*((o->re[0][0] + g*(o->re[0][1] + g*(o->re[0][2] + g*o->re[0][3])))
                - E*(o->re[0][0] + f*(o->re[0][1] + f*(o->re[0][2] + f*o->re[0][3]))));
  im[0] = (o->im[0][0] + g*(o->im[0][1] + g*(o->im[0][2] + g*o->im[0][3])))
          + E*(o->im[0][0] + f*(o->im[0][1] + f*(o->im[0][2] + f*o->im[0][3])));
  for (int i = 1; i < 3; i++) {
    re[i] = e*(o->re[i][0] + o->re[i][1]*(g + h) + o->re[i][2]*(g*g + h*h) + o->re[i][3]*(g*g*g + h*h*h));
    im[i] = sign*e*(o->im[i][1]*(g - h) + o->im[i][2]*(g*g - h*h) + o->im[i][3]*(g*g*g - h*h*h));
  }
  return ${name}_turned(re, im, p.flip, p.a, p.b);
}

/* attitude and rates from the values and 1/length of their quaternion */
${inline} void ${name}_put(const ${name}_orbit *o, const ${name}_values *v, ${name}_real n, ${name}_real q[4], ${name}_real w[3])
{
  ${name}_real r[4], g;

  w[0] = o->along[0] + n*(v->f*o->across[0][0] + v->g*o->across[1][0]);
  w[1] = o->along[1] + n*(v->f*o->across[0][1] + v->g*o->across[1][1]);
  w[2] = o->along[2] + n*(v->f*o->across[0][2] + v->g*o->across[1][2]);
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

${name}_real ${name}_nutation_period(const ${name}_orbit *o)
{
  if (!(o->rate[0] > ${zero})) return ${zero};
  return o->inverse > ${zero} ? o->period[0]/o->rate[0] : ${huge};
}

${name}_real ${name}_precession_rate(const ${name}_orbit *o)
{
  return o->mean;
}

void ${name}_nutation_range(const ${name}_orbit *o, ${name}_real tilt[2])
{
  tilt[0] = o->tilt[0];
  tilt[1] = o->tilt[1];
}
