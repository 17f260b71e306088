%% -- split.c -- splitting into free flow and kicks: part of scene.c.  SPDX-License-Identifier: MIT-0
%% if split_shared then
/* ---- Splitting: Dullweber, Leimkuhler, McLachlan 1997, J. Chem. Phys. 107, 5840; McLachlan, Quispel 2002 ---- */

%%   if split_turns then
/* c = cos(a), s = sin(a)/a of a = sqrt(z): their series up to a = 1/2 */
static void ${name}_split_half(${name}_real z, ${name}_real *c, ${name}_real *s)
{
  if (z <= ${quarter}) {
    const ${name}_real zz = z*z;

    *c = ${split_cos};
    *s = ${split_sin};
  } else {
    const ${name}_real a = ${sqrt}(z);

    *c = ${cos}(a);
    *s = ${sin}(a)/a;
  }
}

%%     if split_attitude then
/* q = q (c, e), of which c is c1 less than 1: what is added to q is rounded once, with it.  c q by itself would be rounded to
 * a whole step of the last place where c is next to 1, more of a small mantissa than of a large one: a turn, always the
 * same way. */
static void ${name}_split_turn(${name}_real x[], ${name}_real c1, const ${name}_real e[3])
{
  const ${name}_real w = x[${upper}_QW], a = x[${upper}_QX], b = x[${upper}_QY], d = x[${upper}_QZ];

  x[${upper}_QW] = w - (c1*w + e[0]*a + e[1]*b + e[2]*d);
  x[${upper}_QX] = a - (c1*a - e[0]*w - e[2]*b + e[1]*d);
  x[${upper}_QY] = b - (c1*b - e[1]*w - e[0]*d + e[2]*a);
  x[${upper}_QZ] = d - (c1*d - e[2]*w - e[1]*a + e[0]*b);
}

/* About L by the angle |p| tau, p = L/I: L stays.  over: what |q| is over 1, and is less by afterwards. */
static void ${name}_split_along(${name}_real x[], const ${name}_real p[3], ${name}_real tau, ${name}_real over)
{
  const ${name}_real half = ${half}*tau;
  ${name}_real e[3], c, s;

  e[0] = half*p[0];
  e[1] = half*p[1];
  e[2] = half*p[2];
  ${name}_split_half(e[0]*e[0] + e[1]*e[1] + e[2]*e[2], &c, &s);
  s *= ${one} - over;
  e[0] *= s;
  e[1] *= s;
  e[2] *= s;
  ${name}_split_turn(x, (${one} - c) + over*c, e);
}

%%     end
%%     if split_full or split_oblique then
/* About the axis k, a unit vector, by twice the angle a, in the sense of ${name}_split_along; 1 - cos is added apart, so
 * that the length of w does not creep. */
static void ${name}_split_about(${name}_real x[], const ${name}_real k[3], ${name}_real a)
{
  ${name}_real *w = x + ${upper}_WX;
  ${name}_real e[3], f[3], c, s;
  int i;

  for (i = 0; i < 3; i++) e[i] = a*k[i];
  ${name}_split_half(e[0]*e[0] + e[1]*e[1] + e[2]*e[2], &c, &s);
  for (i = 0; i < 3; i++) e[i] *= s;
%%       if split_attitude then
  ${name}_split_turn(x, ${one} - c, e);
%%       end
  /* w -= 2 e x (c w - e x w) */
  f[0] = c*w[0] - (e[1]*w[2] - e[2]*w[1]);
  f[1] = c*w[1] - (e[2]*w[0] - e[0]*w[2]);
  f[2] = c*w[2] - (e[0]*w[1] - e[1]*w[0]);
  w[0] -= ${two}*(e[1]*f[2] - e[2]*f[1]);
  w[1] -= ${two}*(e[2]*f[0] - e[0]*f[2]);
  w[2] -= ${two}*(e[0]*f[1] - e[1]*f[0]);
}

%%     end
%%     if split_full then
/* What the drift needs of the tensor, into the model; 1 if it is not finite. */
static int ${name}_split_setup(${name}_model *m)
{
  ${name}_real I[6], moments[3], axes[9], *u = m->split_u, *d = m->split_d;
  int i;

  ${name}_inertia(m, I);
  if (${name}_principal_of(I, moments, axes)) return 1;
  for (i = 0; i < 3; i++) {
    m->split_b[i] = axes[i];
    m->split_c[i] = axes[6 + i];
  }
  m->split_fb = (moments[1] - moments[0])/moments[0];
  m->split_fc = (moments[1] - moments[2])/moments[2];
  for (i = 0; i < 6; i++) I[i] /= moments[1];
  d[0] = I[0];
  u[0] = I[3]/d[0];
  u[1] = I[4]/d[0];
  d[1] = I[1] - u[0]*I[3];
  u[2] = (I[5] - u[0]*I[4])/d[1];
  d[2] = I[2] - u[1]*I[4] - u[2]*(u[2]*d[1]);
  return !(m->split_fb - m->split_fb == ${zero}) || !(u[2] - u[2] == ${zero}) || !(d[2] > ${zero});
}

%%     end
%%     if split_axis then
/* About the body's axis i by twice the angle a; j and k follow i in cyclic order.  1 - cos is added apart, so that the
 * length of (w[j], w[k]) does not creep. */
static void ${name}_split_about(${name}_real x[], int i, int j, int k, ${name}_real a)
{
  ${name}_real *w = x + ${upper}_WX;
  const ${name}_real y = w[j], z = w[k];
  ${name}_real c, s, v;
%%       if split_attitude then
  ${name}_real *q = x + ${upper}_QX;
  const ${name}_real qw = x[${upper}_QW], qi = q[i], qj = q[j], qk = q[k];
%%       end

  ${name}_split_half(a*a, &c, &s);
  s *= a;
%%       if split_attitude then
  x[${upper}_QW] = c*qw - s*qi;
  q[i] = c*qi + s*qw;
  q[j] = c*qj + s*qk;
  q[k] = c*qk - s*qj;
%%       else
  (void)i;
%%       end
  v = ${two}*s*s;
  s *= ${two}*c;
  w[j] = y + (s*z - v*y);
  w[k] = z - (s*y + v*z);
}

%%     end
%%   end
%%   if split_diagonal then
/* The free body over a time tau.  The map w' - w = K1 (w2 w3' + w3 w2'), and cyclic, with b = tau/2, ai = (Ij - Ik)/Ii,
 *     Ki = b ai ui/sqrt(u1 u2 u3),  ui = U - ei b^2,  ei = (m1 + m2 + m3)/3 - mi,  mi = aj ak wi^2
 * (the differences of the ei do not change) keeps energy and |L|, whatever U is.  It is exact for U = b^2 P(b), P Weierstrass'
 * function with the roots e1, e2, e3: 1 + g2 b^4/20 + g3 b^6/28 + g2^2 b^8/1200 + .., DLMF 23.9.  Hirota, Kimura 2000,
 * J. Phys. Soc. Japan 69, 627; coefficients that depend on the step: Hairer, Vilmart 2006, J. Phys. A 39, 13225.
%%     if split_attitude then
 * The body turns about L by the angle f, then such that L in the body comes by the least turn to where w' has it:
 *     f' = |L| (2T V - b^2 w'.L')/(L^2 V - b^2 L'^2),  V = U - b^2 (m1 + m2 + m3)/3,  integrated term by term.
%%     end
 * What is left out is of order tau^11.  Beyond b^4 g2 = 1/8 or b^2 (mean of m + L'^2/L^2) = 1/2, a turn of about 1.5 rad, nothing
 * would be left of that: a longer drift goes that far only, so that all stays finite. */
%%   elseif split_full then
/* The free body over a time tau, with p = L/Ia in the place of the rates: the rotation about L, and those about two axes
 * n times in turn */
%%   else
/* The free body over a time tau */
%%   end
%%   if split_full then
static void ${name}_split_drift(const ${name}_model *m, ${name}_real x[], ${name}_real tau, int n, const ${name}_real a[], const ${name}_real b[])
%%   else
static void ${name}_split_drift(const ${name}_model *m, ${name}_real x[], ${name}_real tau, ${name}_real over)
%%   end
{
%%   if split_turns then
  ${name}_real *w = x + ${upper}_WX;
%%   end
%%   if split_diagonal then
  const ${name}_real a1 = ${split_a1}, a2 = ${split_a2}, a3 = ${split_a3};
  ${name}_real b = ${half}*tau, y1 = b*w[0], y2 = b*w[1], y3 = b*w[2];
  const ${name}_real size = ${fabs}(y1) + ${fabs}(y2) + ${fabs}(y3);

  if (size > ${sixteen}) { /* far too long: fourth powers must not overflow */
    const ${name}_real part = ${sixteen}/size;

    b *= part;
    y1 *= part;
    y2 *= part;
    y3 *= part;
  }
  const ${name}_real m1 = a2*a3*y1*y1, m2 = a3*a1*y2*y2, m3 = a1*a2*y3*y3, mean = ${third}*(m1 + m2 + m3);
  ${name}_real e1 = mean - m1, e2 = mean - m2, e3 = mean - m3;
  ${name}_real g2 = ${two}*(e1*e1 + e2*e2 + e3*e3), c2, c3, U;
%%     if split_attitude then
  const ${name}_real j1 = ${split_j1}, j3 = ${split_j3}; /* I1/I2, I3/I2 */
  const ${name}_real d1 = a1*y2*y3, d2 = a2*y3*y1, d3 = a3*y1*y2, n1 = j1*d1, n3 = j3*d3;
  const ${name}_real LL = (j1*y1)*(j1*y1) + y2*y2 + (j3*y3)*(j3*y3), i = ${one}/(LL + ${split_tiny}); /* at rest: no turn */
  const ${name}_real f = (j1*y1*y1 + y2*y2 + j3*y3*y3)*i; /* 2T/L^2 */
  ${name}_real LN = (n1*n1 + d2*d2 + n3*n3)*i, wN = (d1*n1 + d2*d2 + d3*n3)*i, s = mean + LN;
  ${name}_real r, rr, ii = i, p[3];
%%     end
%%     if split_attitude then
  const ${name}_real near = ${eight}*g2, far = ${four}*s*s, reach = near > far ? near : far;
%%     else
  const ${name}_real reach = ${eight}*g2;
%%     end

  if (reach > ${one}) { /* too long a drift: as far as the real function goes */
    const ${name}_real square = ${one}/${sqrt}(reach), shrink = ${sqrt}(square);

    b *= shrink;
    e1 *= square;
    e2 *= square;
    e3 *= square;
    g2 *= square*square;
%%     if split_attitude then
    LN *= square;
    wN *= square;
    s *= square;
    ii /= square;
%%     end
  }
  c2 = ${split_20th}*g2;
  c3 = ${split_7th}*(e1*e2*e3);
  U = ${one} + (c2 + c3 + ${third}*(c2*c2));
  const ${name}_real u1 = U - e1, u2 = U - e2, u3 = U - e3, K = b/${sqrt}(u1*u2*u3);
  const ${name}_real K1 = a1*u1*K, K2 = a2*u2*K, K3 = a3*u3*K;
%%     if split_attitude then
  rr = s*s - c2;
  r = ${third} + ${split_5th}*s + ${split_7th}*rr + ${split_9th}*(s*(rr - c2) - c3);
  p[0] = j1*w[0];
  p[1] = w[1];
  p[2] = j3*w[2];
  ${name}_split_along(x, p, ${two}*b*(f + (f*LN - wN)*r), over);
%%     end
  const ${name}_real w1 = w[0], w2 = w[1], w3 = w[2];
  /* the matrix of w' less 1: (0 A B; C 0 D; E F 0); for the difference w' - w the right side is 2 Ki wj wk */
  const ${name}_real A = K1*w3, B = K1*w2, C = K2*w3, D = K2*w1, E = K3*w2, F = K3*w1;
  const ${name}_real h1 = ${two}*A*w2, h2 = ${two}*C*w1, h3 = ${two}*E*w1;
  const ${name}_real t1 = ${one} - D*F, t2 = C + D*E, t3 = E + C*F, t = ${one}/(t1 - A*t2 - B*t3);
  const ${name}_real v1 = (t1*h1 + (A + B*F)*h2 + (B + A*D)*h3)*t;
  const ${name}_real v2 = (t2*h1 + (${one} - B*E)*h2 + (D + B*C)*h3)*t;
  const ${name}_real v3 = (t3*h1 + (F + A*E)*h2 + (${one} - A*C)*h3)*t;
%%     if split_attitude then
  const ${name}_real L1 = b*j1*w1, L2 = b*w2, L3 = b*j3*w3, N1 = b*j1*v1, N2 = b*v2, N3 = b*j3*v3;
  const ${name}_real c = ${sqrt}(${one} - ${quarter}*ii*(N1*N1 + N2*N2 + N3*N3)), k = ${half}*ii/c;

  p[0] = k*(N2*L3 - N3*L2);
  p[1] = k*(N3*L1 - N1*L3);
  p[2] = k*(N1*L2 - N2*L1);
  ${name}_split_turn(x, ${one} - c, p);
%%     end
  w[0] = w1 + v1;
  w[1] = w2 + v2;
  w[2] = w3 + v3;
  (void)m; /* constants may be in the code */
%%   end
%%   if split_full then
  const ${name}_real *u = m->split_u, *d = m->split_d, *k = m->split_b, *l = m->split_c;
  const ${name}_real half = ${half}*tau;
%%     if split_attitude then
  /* one Newton step for 1/|q|, from the q that comes in, so |q| cannot drift */
  const ${name}_real over = ${half}*(x[${upper}_QW]*x[${upper}_QW] + x[${upper}_QX]*x[${upper}_QX] + x[${upper}_QY]*x[${upper}_QY] + x[${upper}_QZ]*x[${upper}_QZ]) - ${half};
%%     end
  ${name}_real w0[3], p0[3];
  int i;

  /* p = U^T D U w */
  for (i = 0; i < 3; i++) w0[i] = w[i];
  w[0] += u[0]*w[1] + u[1]*w[2];
  w[1] += u[2]*w[2];
  for (i = 0; i < 3; i++) w[i] *= d[i];
  w[2] += u[1]*w[0] + u[2]*w[1];
  w[1] += u[0]*w[0];
  for (i = 0; i < 3; i++) p0[i] = w[i];
%%     if split_attitude then
  ${name}_split_along(x, w, tau, over);
%%     end
  for (i = 0; i <= n; i++) {
    ${name}_split_about(x, k, a[i]*half*(m->split_fb*(k[0]*w[0] + k[1]*w[1] + k[2]*w[2])));
    if (i < n) ${name}_split_about(x, l, b[i]*half*(m->split_fc*(l[0]*w[0] + l[1]*w[1] + l[2]*w[2])));
  }
  /* the same steps back, for the change */
  for (i = 0; i < 3; i++) w[i] -= p0[i];
  w[1] -= u[0]*w[0];
  w[2] -= u[1]*w[0] + u[2]*w[1];
  for (i = 0; i < 3; i++) w[i] /= d[i];
  w[1] -= u[2]*w[2];
  w[0] -= u[0]*w[1] + u[1]*w[2];
  for (i = 0; i < 3; i++) w[i] += w0[i];
%%   end
%%   if split_axis then
  const ${name}_real spin = ${split_c}*w[${split_i}] + ${split_h}; /* |L|/I1 along the axis less the rate */
%%     if split_attitude then
  ${name}_real p[3];

  p[0] = w[0];
  p[1] = w[1];
  p[2] = w[2];
  p[${split_i}] += spin;
  ${name}_split_along(x, p, tau, over);
%%     end
  ${name}_split_about(x, ${split_i}, ${split_j}, ${split_k}, -${half}*tau*spin);
  (void)m;
%%   end
%%   if split_oblique then
  const ${name}_real k[3] = {${split_kx}, ${split_ky}, ${split_kz}};
  const ${name}_real spin = ${split_c}*(k[0]*w[0] + k[1]*w[1] + k[2]*w[2]) + ${split_h};
%%     if split_attitude then
  ${name}_real p[3];
  int i;

  for (i = 0; i < 3; i++) p[i] = w[i] + spin*k[i];
  ${name}_split_along(x, p, tau, over);
%%     end
  ${name}_split_about(x, k, -${half}*tau*spin);
  (void)m;
%%   end
%%   if not split_attitude and not split_full then
  (void)over;
%%   end
%%   if split_sphere then
  (void)m;
%%     if split_attitude then
  ${name}_split_along(x, w, tau, over);
%%     else
  (void)w; /* the rates stay */
  (void)tau;
%%     end
%%   end
%%   if split_moves then
%%     if not split_turns then
  (void)m;
%%     end
  x[${upper}_RX] += tau*x[${upper}_VX];
  x[${upper}_RY] += tau*x[${upper}_VY];
  x[${upper}_RZ] += tau*x[${upper}_VZ];
%%   end
}
%%   if split_kicks then

/* What changes the rates and the velocity beside the free motion */
static ${split_head}
{
%%     for _, line in ipairs(split_lines) do
%%       if line == "" then

%%       else
  ${line}
%%       end
%%     end
}

%%     if split_slowed then
/* The rates over a time tau, attitude and place held, by the midpoint rule */
%%     else
/* The rates over a time tau, attitude and place held */
%%     end
static void ${name}_split_kick(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real tau)
{
  ${name}_real dx[${upper}_NX];
%%     if split_slowed then
  ${name}_real y[${upper}_NX];
  int i;
%%     end

  ${name}_split_rates(m, t, x, u, dx);
%%     if split_slowed then
  for (i = 0; i < ${upper}_NX; i++) y[i] = x[i];
%%       for _, s in ipairs(split_states) do
  y[${s}] += ${half}*tau*dx[${s}];
%%       end
  ${name}_split_rates(m, t, y, u, dx);
%%     end
%%     for _, s in ipairs(split_states) do
  x[${s}] += tau*dx[${s}];
%%     end
}
%%   end

%% end
/* ${split_about} */
void ${name}_${split_method}_step(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h)
{
%% if split_kicks then
  static const ${name}_real drift[] = {
%%   for _, s in ipairs(split_outer.a) do
    ${s},
%%   end
  };
  static const ${name}_real kick[] = {
%%   for _, s in ipairs(split_outer.b) do
    ${s},
%%   end
  };
  static const ${name}_real at[] = { /* sums of the drifts */
%%   for _, s in ipairs(split_outer.c) do
    ${s},
%%   end
  };
%% end
%% if split_full then
  static const ${name}_real a[] = { /* the free body's own splitting */
%%   for _, s in ipairs(split_inner.a) do
    ${s},
%%   end
  };
  static const ${name}_real b[] = {
%%   for _, s in ipairs(split_inner.b) do
    ${s},
%%   end
  };
%% end
%% if split_kicks then
  int i;
%% end
%% if not split_full then
%%   if split_attitude then
  /* one Newton step for 1/|q|, from the q that comes in, so |q| cannot drift */
  const ${name}_real over = ${half}*(x[${upper}_QW]*x[${upper}_QW] + x[${upper}_QX]*x[${upper}_QX] + x[${upper}_QY]*x[${upper}_QY] + x[${upper}_QZ]*x[${upper}_QZ]) - ${half};
%%   else
  const ${name}_real over = ${zero}; /* there is no q */
%%   end
%% end

%% if split_kicks then
%%   if split_full then
  for (i = 0; i < ${split_outer.n}; i++) {
    ${name}_split_drift(m, x, drift[i]*h, ${split_inner.n}, a, b);
    ${name}_split_kick(m, t + at[i]*h, x, u, kick[i]*h);
  }
  ${name}_split_drift(m, x, drift[${split_outer.n}]*h, ${split_inner.n}, a, b);
%%   else
  for (i = 0; i < ${split_outer.n}; i++) {
    ${name}_split_drift(m, x, drift[i]*h, i > 0 ? ${zero} : over);
    ${name}_split_kick(m, t + at[i]*h, x, u, kick[i]*h);
  }
  ${name}_split_drift(m, x, drift[${split_outer.n}]*h, ${zero});
%%   end
%% else
  (void)t;
  (void)u;
%%   if split_full then
  ${name}_split_drift(m, x, h, ${split_inner.n}, a, b);
%%   else
  ${name}_split_drift(m, x, h, over);
%%   end
%% end
}
%% if first then

void ${name}_step(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h)
{
  ${name}_${split_method}_step(m, t, x, u, h);
}
%% end
