%% -- taylor_top.c -- the terms of a heavy symmetric top's Taylor series: part of scene.c.  SPDX-License-Identifier: MIT-0
/* The heavy symmetric top.  With a = qw + i qz, b = qx + i qy, W = wx + i wy and z the cosine of the tilt, W' = i Omega W +
 * K conj(a) b.  Let M = wz + Omega, e = |W|^2 + K z and l = Re(W conj(gx + i gy)) + M z, which are constant, g the vertical in
 * the body.  In the frame that turns about the body's axis with 2 f = Omega - 2 s
 *     z'' = M l - K/2 - (e + M^2) z + 3 K z^2/2
 *     a'' = -2 i s a' + (K z/2 - k) a,   b'' = 2 i s b' + (K z/2 + K/2 - k) b,   k = (M^2 + e + K)/4 - s^2
 * and W = 2 (conj(a) b' - b conj(a')): Lame's equation (Whittaker, Analytical Dynamics, 4th ed., 71-75), in which no product
 * but those with z is left.  s = M/4 makes the fastest oscillation slow.  c[1] and so on are the coefficients of qw qx qy qz
 * in that frame and of their rates. */
static void ${name}_taylor_constants(const ${name}_model *m, const ${name}_real x[], ${name}_real o[4])
{
%% for _, line in ipairs(lame.loads) do
  ${line}
%% end
%% for _, line in ipairs(lame.lines) do
  ${line}
%% end
  (void)m; /* constants may be in the code */
}

/* the rates of qw qx qy qz in the frame */
static void ${name}_taylor_rates(const ${name}_real c[], ${name}_real s, ${name}_real y[4])
{
  y[0] = -${half}*(c[1]*c[4] + c[2]*c[5]) - s*c[3];
  y[1] = ${half}*(c[0]*c[4] - c[3]*c[5]) + s*c[2];
  y[2] = ${half}*(c[0]*c[5] + c[3]*c[4]) - s*c[1];
  y[3] = ${half}*(c[1]*c[5] - c[2]*c[4]) + s*c[0];
}

#ifndef ${upper}_PACKED
/* term n of the products of z with qw qx qy qz, z but for the first and the last; outwards from the middle, so that the sum need
 * not wait for the newest factors */
static void ${name}_products(int n, const ${name}_real z[], const ${name}_real c[][${upper}_ROW], ${name}_real p[5])
{
  ${name}_real s0 = ${zero}, s1 = ${zero}, s2 = ${zero}, s3 = ${zero}, r0 = ${zero}, r1 = ${zero}, r2 = ${zero}, r3 = ${zero}, t = ${zero};
  int j = n/2;

  if (n == 2*j && n > 0) {
    const ${name}_real a = z[j], *b = c[j];

    s0 = a*b[0];
    s1 = a*b[1];
    s2 = a*b[2];
    s3 = a*b[3];
    t = ${half}*(a*a);
    j--;
  }
  for (; j > 0; j--) {
    const ${name}_real a = z[j], e = z[n - j], *b = c[n - j], *d = c[j];

    s0 += a*b[0];
    s1 += a*b[1];
    s2 += a*b[2];
    s3 += a*b[3];
    r0 += e*d[0];
    r1 += e*d[1];
    r2 += e*d[2];
    r3 += e*d[3];
    t += a*e;
  }
  p[0] = s0 + r0;
  p[1] = s1 + r1;
  p[2] = s2 + r2;
  p[3] = s3 + r3;
  p[4] = ${two}*t;
}
#endif

/* the coefficients up to c[top] */
static void ${name}_taylor_terms(const ${name}_model *m, ${name}_real t, const ${name}_real x[], const ${name}_real u[], int top,
                   ${name}_real c[][${upper}_ROW])
{
  const ${name}_real qw = x[${upper}_QW], qx = x[${upper}_QX], qy = x[${upper}_QY], qz = x[${upper}_QZ], wx = x[${upper}_WX], wy = x[${upper}_WY];
  const ${name}_real size = ${two} - (qw*qw + qx*qx + qy*qy + qz*qz); /* 1/|q|^2 */
  const ${name}_real gx = ${two}*size*(qx*qz - qw*qy), gy = ${two}*size*(qy*qz + qw*qx), z0 = size*((qw*qw + qz*qz) - (qx*qx + qy*qy));
  ${name}_real o[4], z[${upper}_ORDER + 1], y[4], zn = z0, dz = gx*wy - gy*wx;
#if defined ${upper}_PACKED
  ${name}_pack r[${upper}_ORDER + 1], Y;
#endif

  (void)t;
  (void)u;
  ${name}_taylor_constants(m, x, o);
  const ${name}_real M = o[0], K = o[1], s = o[2], e = wx*wx + wy*wy + K*z0, S = ${two}*s, G = ${half}*K;
  const ${name}_real k = ${quarter}*(M*M + e + K) - s*s, kb = k - G, c1 = e + M*M, c2 = ${threehalves}*K;

  c[0][0] = qw;
  c[0][1] = qx;
  c[0][2] = qy;
  c[0][3] = qz;
  c[0][4] = wx;
  c[0][5] = wy;
  c[0][6] = c[0][7] = ${zero};
  ${name}_taylor_rates(c[0], s, y);
  z[0] = z0;
#if defined ${upper}_PACKED
  /* rows (q, q'); products with z in the lower half */
  const ${name}_pack A = {${one}, ${one}, ${one}, ${one}, S, -S, S, -S}, B = {${zero}, ${zero}, ${zero}, ${zero}, -k, -kb, -kb, -k};
  const ${name}_pack C = {${zero}, ${zero}, ${zero}, ${zero}, G, G, G, G};

  const ${name}_pack start = {qw, qx, qy, qz, y[0], y[1], y[2], y[3]};

  Y = start;
  for (int n = 0; n < top; n++) {
    const ${name}_real after = ${one}/(${name}_real)(n + 1);
    const ${name}_pack cosine = {zn};
    ${name}_pack P = {${zero}}, Q = {${zero}};
    int j = n/2; /* outwards from the middle: the newest rows last */

    z[n] = zn;
    r[n] = __builtin_shufflevector(Y, cosine, 0, 1, 2, 3, 8, 9, 10, 11);
    if (n - j == j) {
      P = z[j]*r[j];
      j--;
    }
    for (; j >= 0; j--) {
      P += z[j]*r[n - j];
      Q += z[n - j]*r[j];
    }
    P += Q;
    Y = (after*A)*__builtin_shufflevector(Y, Y, 4, 5, 6, 7, 7, 6, 5, 4) + (after*B)*__builtin_shufflevector(Y, Y, 0, 1, 2, 3, 0, 1, 2, 3)
      + (after*C)*__builtin_shufflevector(P, P, 0, 1, 2, 3, 0, 1, 2, 3);
    *(${name}_row *)c[n + 1] = Y;
    zn = after*dz;
    dz = after*(c2*P[4] - c1*z[n] + (n == 0 ? M*(wx*gx + wy*gy + M*z0) - G : ${zero}));
  }
#else
  {
    const ${name}_real S4[4] = {S, -S, S, -S}, k4[4] = {k, kb, kb, k}, q[4] = {qw, qx, qy, qz}, rest = M*(wx*gx + wy*gy + M*z0) - G;
    ${name}_real a[4] = {qw, qx, qy, qz}, b[4], p[5];

    for (int i = 0; i < 4; i++) b[i] = y[i];
    for (int n = 0; n < top; n++) {
      const ${name}_real after = ${one}/(${name}_real)(n + 1), last = n > 0 ? zn : ${zero};
      ${name}_real *next = c[n + 1];

      z[n] = zn;
      ${name}_products(n, z, (const ${name}_real(*)[${upper}_ROW])c, p);
      p[0] = G*(p[0] + (z0*a[0] + last*q[0])) - k4[0]*a[0] + S4[0]*b[3];
      p[1] = G*(p[1] + (z0*a[1] + last*q[1])) - k4[1]*a[1] + S4[1]*b[2];
      p[2] = G*(p[2] + (z0*a[2] + last*q[2])) - k4[2]*a[2] + S4[2]*b[1];
      p[3] = G*(p[3] + (z0*a[3] + last*q[3])) - k4[3]*a[3] + S4[3]*b[0];
      next[0] = a[0] = after*b[0];
      next[1] = a[1] = after*b[1];
      next[2] = a[2] = after*b[2];
      next[3] = a[3] = after*b[3];
      next[4] = b[0] = after*p[0];
      next[5] = b[1] = after*p[1];
      next[6] = b[2] = after*p[2];
      next[7] = b[3] = after*p[3];
      zn = after*dz;
      dz = after*(c2*(p[4] + (z0*z[n] + last*z0)) - c1*z[n] + (n == 0 ? rest : ${zero}));
    }
  }
#endif
}

/* From the frame after a time h back to the body: what c[0] + d moves by then; d comes with what the rows add up to. */
static void ${name}_taylor_back(const ${name}_model *m, const ${name}_real x[], ${name}_real c[][${upper}_ROW], ${name}_real h, ${name}_real d[${upper}_ROW])
{
  const ${name}_real *q = c[0], size = ${two} - (q[0]*q[0] + q[1]*q[1] + q[2]*q[2] + q[3]*q[3]); /* 1/|q|^2 */
  const ${name}_real a0 = q[0] + d[0], a1 = q[1] + d[1], a2 = q[2] + d[2], a3 = q[3] + d[3];
  ${name}_real o[4], y[4];

  ${name}_taylor_constants(m, x, o);
  ${name}_taylor_rates(q, o[2], y);
  const ${name}_real b0 = y[0] + d[4], b1 = y[1] + d[5], b2 = y[2] + d[6], b3 = y[3] + d[7];
  /* W at the end less W at the start, in the frame */
  const ${name}_real dx = ${two}*size*(((q[0]*d[5] + d[0]*b1) + (q[3]*d[6] + d[3]*b2)) - ((q[1]*d[4] + d[1]*b0) + (q[2]*d[7] + d[2]*b3)));
  const ${name}_real dy = ${two}*size*(((q[0]*d[6] + d[0]*b2) - (q[3]*d[5] + d[3]*b1)) - ((q[2]*d[4] + d[2]*b0) - (q[1]*d[7] + d[1]*b3)));
  const ${name}_real wx = q[4] + dx, wy = q[5] + dy;
  const ${name}_real a = ${sin}(${half}*o[3]*h), b = ${cos}(${half}*o[3]*h);
  const ${name}_real S = ${two}*a*b, D = -${two}*a*a, V = ${two}*S*(${one} + D), U = -${two}*S*S; /* sin, cos - 1 of f h, 2 f h */

  d[0] += D*a0 + S*a3;
  d[1] += D*a1 - S*a2;
  d[2] += D*a2 + S*a1;
  d[3] += D*a3 - S*a0;
  d[4] = dx + (U*wx - V*wy);
  d[5] = dy + (V*wx + U*wy);
}
