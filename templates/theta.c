%% -- theta.c -- the free top's state at any time, by theta functions: part of scene.c.  SPDX-License-Identifier: MIT-0
/* the nearest integer, to even; beyond 2^51 (float: 2^22) one of the nearest even ones, which serves as well */
static ${name}_real ${name}_nearest(${name}_real x)
{
  return (x + ${round_off}) - ${round_off};
}

/* sin and cos of pi x, |x| <= 1/2: their series at half of it, and one doubling; no call, so that loops are vectorised */
static void ${name}_sincos(${name}_real x, ${name}_real *s, ${name}_real *c)
{
  const ${name}_real y = ${half}*${pi_high}*x, u = y*y;
%% if single then
  const ${name}_real a = y*(${one} - u*(${one}/6.0F - u*(${one}/120.0F - u*(${one}/5040.0F - u*(${one}/362880.0F)))));
  const ${name}_real b = ${one} - u*(${half} - u*(${one}/24.0F - u*(${one}/720.0F - u*(${one}/40320.0F))));
%% else
  const double u2 = u*u, u4 = u2*u2; /* Horner's rule in two halves, which run side by side */
  const double a0 = 1.0 - u*(1.0/6.0) + u2*(1.0/120.0 - u*(1.0/5040.0));
  const double a1 = 1.0/362880.0 - u*(1.0/39916800.0) + u2*(1.0/6227020800.0 - u*(1.0/1307674368000.0) + u2*(1.0/355687428096000.0));
  const double b0 = 1.0 - u*0.5 + u2*(1.0/24.0 - u*(1.0/720.0));
  const double b1 = 1.0/40320.0 - u*(1.0/3628800.0) + u2*(1.0/479001600.0 - u*(1.0/87178291200.0) + u2*(1.0/20922789888000.0));
  const double a = y*(a0 + u4*a1), b = b0 + u4*b1;
%% end

  *s = ${two}*(a*b);
  *c = (b - a)*(b + a);
}

/* w, x, y, z of the quaternion and cn, sn, dn, all but for one factor each, at the phase r, whose period is passed an
 * even (flip = 1) or an odd number of times (-1), after a turn about L */
static void ${name}_functions(const ${name}_orbit *o, ${name}_real r, ${name}_real flip, ${name}_real turn,
                              ${name}_real y[4], ${name}_real f[3])
{
  ${name}_real st, ct;
  ${name}_real a, b, c, d;

  if (!o->hyperbolic) {
    ${name}_real sz, cz, X, s2;

    ${name}_sincos(r, &sz, &cz);
    X = (cz - sz)*(cz + sz);
    s2 = ${two}*(sz*cz);
    sz *= flip;
    cz *= flip;
    a = o->a_re[0] + X*(o->a_re[1] + X*(o->a_re[2] + X*o->a_re[3]));
    b = s2*(o->a_im[0] + X*(o->a_im[1] + X*o->a_im[2]));
    c = sz*(o->b_re[0] + X*(o->b_re[1] + X*(o->b_re[2] + X*o->b_re[3])));
    d = cz*(o->b_im[0] + X*(o->b_im[1] + X*(o->b_im[2] + X*o->b_im[3])));
    f[0] = cz*(o->f[0][0] + X*(o->f[0][1] + X*(o->f[0][2] + X*(o->f[0][3] + X*o->f[0][4]))));
    f[1] = sz*(o->f[1][0] + X*(o->f[1][1] + X*(o->f[1][2] + X*(o->f[1][3] + X*o->f[1][4]))));
    f[2] = o->f[2][0] + X*(o->f[2][1] + X*(o->f[2][2] + X*(o->f[2][3] + X*o->f[2][4])));
  } else {
    const ${name}_real e = ${exp}(-${two}*${fabs}(r)) + ${least}, g = o->nome/e, sign = r < ${zero} ? -${one} : ${one};
    const ${name}_real Q = o->nome*o->nome, Q4 = (Q*Q)*(Q*Q), e2 = e*e, g2 = g*g;
    const ${name}_real re = o->a_re[0] + g2*o->a_re[2], ro = g*(o->a_re[1] + g2*o->a_re[3]);
    const ${name}_real ie = o->a_im[0] + g2*o->a_im[2], io = g*(o->a_im[1] + g2*o->a_im[3]);
    const ${name}_real se = e*(o->b_re[0] + e2*o->b_re[2]), so = e2*(o->b_re[1] + e2*o->b_re[3]);
    const ${name}_real te = e*(o->b_im[0] + e2*o->b_im[2]), to = e2*(o->b_im[1] + e2*o->b_im[3]);

    a = (re + ro) + (se + so);
    b = -sign*((ie + io) - (te + to));
    c = flip*sign*o->s*((re - ro) - (se - so));
    d = -flip*o->s*((ie - io) + (te - to));
    f[0] = flip*e*(${one} - (g2 + Q*e2) + (Q*Q*g2*g2 + Q4*e2*e2));
    f[1] = flip*sign*(${one} - Q*g2 + Q4*g2*g2 - e2*(${one} - Q*Q*e2 + Q4*Q*Q*e2*e2));
    f[2] = e*(${one} + (g2 + Q*e2) + (Q*Q*g2*g2 + Q4*e2*e2));
  }
  ${name}_sincos(turn, &st, &ct); /* half of it */
  r = ct;
  ct = (ct - st)*(ct + st);
  st = ${two}*(st*r);
  y[0] = ct*a - st*b;
  y[3] = st*a + ct*b;
  y[1] = ct*c - st*d;
  y[2] = st*c + ct*d;
}

/* the quaternion from y, normalised */
static void ${name}_attitude(const ${name}_orbit *o, const ${name}_real y[4], ${name}_real q[])
{
  ${name}_real n = ${one}/${sqrt}(y[0]*y[0] + y[1]*y[1] + y[2]*y[2] + y[3]*y[3]);
  int i;

  for (i = 0; i < 4; i++) q[i] = n*(y[0]*o->q[0][i] + y[1]*o->q[1][i] + y[2]*o->q[2][i] + y[3]*o->q[3][i]);
  /* rounding only: one Newton step for 1/|q| */
  n = ${threehalves} - ${half}*(q[0]*q[0] + q[1]*q[1] + q[2]*q[2] + q[3]*q[3]);
  for (i = 0; i < 4; i++) q[i] *= n;
}

/* attitude and rates */
static void ${name}_state(const ${name}_orbit *o, ${name}_real r, ${name}_real flip, ${name}_real turn, ${name}_real x[])
{
  ${name}_real y[4], f[3], n;
  ${name}_real *w = x + ${upper}_WX;
  int i;

  ${name}_functions(o, r, flip, turn, y, f);
  ${name}_attitude(o, y, x + ${upper}_QW);
  n = ${one}/(y[0]*y[0] + y[1]*y[1] + y[2]*y[2] + y[3]*y[3]);
  for (i = 0; i < 3; i++) w[i] = n*(f[0]*o->w[0][i] + f[1]*o->w[1][i] + f[2]*o->w[2][i]);
}

/* a + b t in pairs */
static ${name}_pair ${name}_phase(${name}_pair a, const ${name}_real b[2], ${name}_real t)
{
  const ${name}_pair p = ${name}_pair_product(b[0], t), s = ${name}_pair_sum(p.hi, a.hi);
  ${name}_pair phase;

  phase.hi = s.hi;
  phase.lo = s.lo + (p.lo + b[1]*t + a.lo);
  return phase;
}

/* phases: of the rates, less the nearest multiple of its period; about L, less whole turns; and (-1) to the multiple */
static void ${name}_reduce(const ${name}_orbit *o, ${name}_real t, ${name}_real *r, ${name}_real *turn, ${name}_real *flip)
{
  ${name}_pair p, jump;
  ${name}_real n;

  p.hi = o->start[0];
  p.lo = o->start[1];
  p = ${name}_phase(p, o->rate, t);
  n = ${name}_nearest(p.hi*o->inverse);
  *flip = ${one} - ${two}*${fabs}(n - ${two}*${name}_nearest(${half}*n));
  jump = ${name}_pair_of(${zero});
  if (o->hyperbolic) {
    const ${name}_pair whole = ${name}_pair_product(n, o->period[0]);

    jump = ${name}_pair_product(-n, o->jump[0]);
    jump.lo -= n*o->jump[1];
    *r = (p.hi - whole.hi) + (p.lo - whole.lo - n*o->period[1]);
  } else {
    *r = (p.hi - n) + p.lo;
  }
  p = ${name}_phase(jump, o->turn, t);
  *turn = (p.hi - ${name}_nearest(p.hi)) + p.lo;
}

void ${name}_at(const ${name}_orbit *o, ${name}_real t, ${name}_real x[])
{
  ${name}_real r, turn, flip;

  ${name}_reduce(o, t, &r, &turn, &flip);
  ${name}_state(o, r, flip, turn, x);
}
