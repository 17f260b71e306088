%% -- uniform.c -- turning at a constant rate: phases in turns, lengths as pairs; part of scene.c.  SPDX-License-Identifier: MIT-0
/* rate t less whole turns; twice, for t so large that the first nearest number is not the nearest integer */
${inline} ${name}_real ${name}_phase(const ${name}_orbit *o, const ${name}_real rate[4], ${name}_real at)
{
  const ${name}_real before = at > o->last ? o->last : at, t = before < -o->last ? -o->last : before; /* no number stays none */
  const ${name}_real c = ${split}*t, head = c - (c - t);
  const ${name}_pair p = ${name}_passed(rate, t, head, t - head);
  const ${name}_real turns = (p.hi - ${name}_nearest(p.hi)) + p.lo;

  return turns - ${name}_nearest(turns);
}

/* half the angle of a rate in rad/s, in turns per second; the high part also in halves, see ${name}_passed */
static void ${name}_half_turns(${name}_pair rate, ${name}_real out[4])
{
  const ${name}_pair inverse = {${quarter_inverse_pi_high}, ${quarter_inverse_pi_low}};
  const ${name}_pair turns = ${name}_mul(rate, inverse);
  const ${name}_real c = ${split}*turns.hi;

  out[0] = turns.hi;
  out[1] = turns.lo;
  out[2] = c - (c - turns.hi);
  out[3] = turns.hi - out[2];
}

/* v = s u with |u| = 1, s >= 0; u = 0 if v = 0.  Scaled by a power of two, so nothing over- or underflows.
 * The length comes as a pair. */
static ${name}_pair ${name}_unit_vector(const ${name}_pair v[3], ${name}_real u[3])
{
  ${name}_real big = ${fabs}(v[0].hi), root;
  ${name}_pair n, square = ${name}_pair_of(${zero});
  int e;

  if (${fabs}(v[1].hi) > big) big = ${fabs}(v[1].hi);
  if (${fabs}(v[2].hi) > big) big = ${fabs}(v[2].hi);
  u[0] = u[1] = u[2] = ${zero};
  if (big == ${zero}) return square;
  (void)${frexp}(big, &e);
  for (int i = 0; i < 3; i++) {
    n.hi = ${ldexp}(v[i].hi, -e);
    n.lo = ${ldexp}(v[i].lo, -e);
    u[i] = n.hi;
    square = ${name}_add(square, ${name}_mul(n, n));
  }
  root = ${sqrt}(square.hi);
  for (int i = 0; i < 3; i++) u[i] /= root;
  n = ${name}_pair_product(root, root); /* one Newton step: sqrt(s) = r + (s - r^2)/(2 r) */
  n = ${name}_pair_sum(root, ((square.hi - n.hi) - n.lo + square.lo)/(${two}*root));
  n.hi = ${ldexp}(n.hi, e);
  n.lo = ${ldexp}(n.lo, e);
  return n;
}

/* q normalised as a vector of four: first the vector part, then with the scalar.  Returns |q|; out is 0 if that is. */
static ${name}_real ${name}_unit_quaternion(const ${name}_real q[4], ${name}_real out[4])
{
  ${name}_pair v[3], both[3];
  ${name}_real u[3], n[3], length;

  for (int i = 0; i < 3; i++) v[i] = ${name}_pair_of(q[i + 1]);
  both[0] = ${name}_pair_of(q[0]);
  both[1] = ${name}_unit_vector(v, u);
  both[2] = ${name}_pair_of(${zero});
  length = ${name}_unit_vector(both, n).hi;
  out[0] = n[0];
  for (int i = 0; i < 3; i++) out[i + 1] = n[1]*u[i];
  return length;
}
%% if rolls then

/* The unit quaternion q of x and the angular velocity q (0, w) q* along the rows of e, inertial axes.  Returns |q| of
 * x. */
static ${name}_real ${name}_spin(const ${name}_real x[], const ${name}_real e[3][3], ${name}_real q[4], ${name}_real along[3])
{
  const ${name}_real *w = x + ${upper}_WX, rate[4] = {${zero}, w[0], w[1], w[2]};
  const ${name}_real length = ${name}_unit_quaternion(x + ${upper}_QW, q);
  ${name}_real back[4], left[4], W[4];

  for (int i = 0; i < 4; i++) back[i] = i > 0 ? -q[i] : q[i];
  ${name}_quaternion_product(q, rate, left);
  ${name}_quaternion_product(left, back, W);
  for (int i = 0; i < 3; i++) along[i] = W[1]*e[i][0] + W[2]*e[i][1] + W[3]*e[i][2];
  return length;
}
%% end
