%% -- split_diagonal.c -- free flow, the axes principal, three different moments: part of scene.c.  SPDX-License-Identifier: MIT-0
/* The free body over a time tau.  The map w' - w = K1 (w2 w3' + w3 w2'), and cyclic, with b = tau/2, ai = (Ij - Ik)/Ii,
 *     Ki = b ai ui/sqrt(u1 u2 u3),  ui = U - ei b^2,  ei = (m1 + m2 + m3)/3 - mi,  mi = aj ak wi^2
 * (the differences of the ei do not change) keeps energy and |L|, whatever U is.  It is exact for U = b^2 P(b), P Weierstrass'
 * function with the roots e1, e2, e3: 1 + g2 b^4/20 + g3 b^6/28 + g2^2 b^8/1200 + .., DLMF 23.9.  Hirota, Kimura 2000,
 * J. Phys. Soc. Japan 69, 627; coefficients that depend on the step: Hairer, Vilmart 2006, J. Phys. A 39, 13225.
%% if has_attitude then
 * The body turns about L by the angle f, then such that L in the body comes by the least turn to where w' has it:
 *     f' = |L| (2T V - b^2 w'.L')/(L^2 V - b^2 L'^2),  V = U - b^2 (m1 + m2 + m3)/3,  integrated term by term.
%% end
 * What is left out is of order tau^11.  Beyond b^4 g2 = 1/8 or b^2 (mean of m + L'^2/L^2) = 1/2, a turn of about 1.5 rad, nothing
 * would be left of that: a longer drift goes that far only, so that all stays finite. */
static void ${name}_split_drift(const ${name}_model *m, ${name}_real x[], ${name}_real tau, ${name}_real over)
{
  ${name}_real *w = x + ${upper}_WX;
  const ${name}_real a1 = ${a1}, a2 = ${a2}, a3 = ${a3};
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
%% if has_attitude then
  const ${name}_real j1 = ${j1}, j3 = ${j3}; /* I1/I2, I3/I2 */
  const ${name}_real d1 = a1*y2*y3, d2 = a2*y3*y1, d3 = a3*y1*y2, n1 = j1*d1, n3 = j3*d3;
  const ${name}_real LL = (j1*y1)*(j1*y1) + y2*y2 + (j3*y3)*(j3*y3), i = ${one}/(LL + ${tiny}); /* at rest: no turn */
  const ${name}_real f = (j1*y1*y1 + y2*y2 + j3*y3*y3)*i; /* 2T/L^2 */
  ${name}_real LN = (n1*n1 + d2*d2 + n3*n3)*i, wN = (d1*n1 + d2*d2 + d3*n3)*i, s = mean + LN;
  ${name}_real r, rr, ii = i, p[3];
  const ${name}_real near = ${eight}*g2, far = ${four}*s*s, reach = near > far ? near : far;
%% else
  const ${name}_real reach = ${eight}*g2;
%% end

  if (reach > ${one}) { /* too long a drift: as far as the real function goes */
    const ${name}_real square = ${one}/${sqrt}(reach), shrink = ${sqrt}(square);

    b *= shrink;
    e1 *= square;
    e2 *= square;
    e3 *= square;
    g2 *= square*square;
%% if has_attitude then
    LN *= square;
    wN *= square;
    s *= square;
    ii /= square;
%% end
  }
  c2 = ${twentieth}*g2;
  c3 = ${seventh}*(e1*e2*e3);
  U = ${one} + (c2 + c3 + ${third}*(c2*c2));
  const ${name}_real u1 = U - e1, u2 = U - e2, u3 = U - e3, K = b/${sqrt}(u1*u2*u3);
  const ${name}_real K1 = a1*u1*K, K2 = a2*u2*K, K3 = a3*u3*K;
%% if has_attitude then
  rr = s*s - c2;
  r = ${third} + ${fifth}*s + ${seventh}*rr + ${ninth}*(s*(rr - c2) - c3);
  p[0] = j1*w[0];
  p[1] = w[1];
  p[2] = j3*w[2];
  ${name}_split_along(x, p, ${two}*b*(f + (f*LN - wN)*r), over);
%% end
  const ${name}_real w1 = w[0], w2 = w[1], w3 = w[2];
  /* the matrix of w' less 1: (0 A B; C 0 D; E F 0); for the difference w' - w the right side is 2 Ki wj wk */
  const ${name}_real A = K1*w3, B = K1*w2, C = K2*w3, D = K2*w1, E = K3*w2, F = K3*w1;
  const ${name}_real h1 = ${two}*A*w2, h2 = ${two}*C*w1, h3 = ${two}*E*w1;
  const ${name}_real t1 = ${one} - D*F, t2 = C + D*E, t3 = E + C*F, t = ${one}/(t1 - A*t2 - B*t3);
  const ${name}_real v1 = (t1*h1 + (A + B*F)*h2 + (B + A*D)*h3)*t;
  const ${name}_real v2 = (t2*h1 + (${one} - B*E)*h2 + (D + B*C)*h3)*t;
  const ${name}_real v3 = (t3*h1 + (F + A*E)*h2 + (${one} - A*C)*h3)*t;
%% if has_attitude then
  const ${name}_real L1 = b*j1*w1, L2 = b*w2, L3 = b*j3*w3, N1 = b*j1*v1, N2 = b*v2, N3 = b*j3*v3;
  const ${name}_real c = ${sqrt}(${one} - ${quarter}*ii*(N1*N1 + N2*N2 + N3*N3)), k = ${half}*ii/c;

  p[0] = k*(N2*L3 - N3*L2);
  p[1] = k*(N3*L1 - N1*L3);
  p[2] = k*(N1*L2 - N2*L1);
  ${name}_split_turn(x, ${one} - c, p);
%% end
  w[0] = w1 + v1;
  w[1] = w2 + v2;
  w[2] = w3 + v3;
  (void)m; /* constants may be in the code */
%% if not has_attitude then
  (void)over;
%% end
%% for _, line in ipairs(place) do
  ${line}
%% end
}
