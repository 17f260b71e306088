%% -- closed.c -- the closed form of the free sphere and symmetric top: part of scene.c.  SPDX-License-Identifier: MIT-0
/* ---- closed form: ${theorem} ---- */

%% if symmetric then
/* a/b for b not 0: the remainder a - q b is exact, so one correction doubles the digits */
static ${name}_pair ${name}_pair_divide(${name}_pair a, ${name}_real b)
{
  const ${name}_real q = a.hi/b;
  ${name}_pair p = ${name}_pair_product(q, b);

  return ${name}_pair_sum(q, ((a.hi - p.hi) - p.lo + a.lo)/b);
}

%% end
/* sine and cosine of (rate t), rate a pair: sin(h + l) = sin h + l cos h to the working precision */
static void ${name}_turn(const ${name}_real rate[2], ${name}_real t, ${name}_real *s, ${name}_real *c)
{
  ${name}_pair p = ${name}_pair_product(rate[0], t);
  const ${name}_real low = p.lo + rate[1]*t;
  const ${name}_real sh = ${sin}(p.hi), ch = ${cos}(p.hi);

  *s = sh + low*ch;
  *c = ch - low*sh;
}

static void ${name}_quaternion_product(const ${name}_real a[4], const ${name}_real b[4], ${name}_real out[4])
{
  out[0] = a[0]*b[0] - a[1]*b[1] - a[2]*b[2] - a[3]*b[3];
  out[1] = a[0]*b[1] + a[1]*b[0] + a[2]*b[3] - a[3]*b[2];
  out[2] = a[0]*b[2] - a[1]*b[3] + a[2]*b[0] + a[3]*b[1];
  out[3] = a[0]*b[3] + a[1]*b[2] - a[2]*b[1] + a[3]*b[0];
}

/* v = s u with |u| = 1, s >= 0; u = 0 if v = 0.  Scaled by a power of two, so nothing over- or underflows.
 * The length comes as a pair. */
static ${name}_pair ${name}_unit_vector(const ${name}_pair v[3], ${name}_real u[3])
{
  ${name}_real big = ${fabs}(v[0].hi), root;
  ${name}_pair n, square = ${name}_pair_of(${zero});
  int i, e;

  if (${fabs}(v[1].hi) > big) big = ${fabs}(v[1].hi);
  if (${fabs}(v[2].hi) > big) big = ${fabs}(v[2].hi);
  u[0] = u[1] = u[2] = ${zero};
  if (big == ${zero}) return square;
  (void)${frexp}(big, &e);
  for (i = 0; i < 3; i++) {
    n.hi = ${ldexp}(v[i].hi, -e);
    n.lo = ${ldexp}(v[i].lo, -e);
    u[i] = n.hi;
    square = ${name}_pair_add(square, ${name}_pair_multiply(n, n));
  }
  root = ${sqrt}(square.hi);
  for (i = 0; i < 3; i++) u[i] /= root;
  n = ${name}_pair_product(root, root); /* one Newton step: sqrt(s) = r + (s - r^2)/(2 r) */
  n = ${name}_pair_sum(root, ((square.hi - n.hi) - n.lo + square.lo)/(${two}*root));
  n.hi = ${ldexp}(n.hi, e);
  n.lo = ${ldexp}(n.lo, e);
  return n;
}

int ${name}_solve(${name}_orbit *o, const ${name}_model *m, const ${name}_real x0[])
{
  const ${name}_real *w = x0 + ${upper}_WX;
%% if symmetric then
  const ${name}_real k[3] = {${kx}, ${ky}, ${kz}}; /* symmetry axis, body; its square is k2 */
  const ${name}_real k2 = ${k2}, I1 = ${I1}, I3 = ${I3};
  const ${name}_real ku = ${sqrt}(k2);
  ${name}_pair s, ratio, along;
%% end
  ${name}_pair v[3], q[3], length;
  ${name}_real u[3], left[4], right[4];
  ${name}_orbit p;
  int i;

%% if uses_model then
%% else
  (void)m; /* every constant is in the code */
%% end
  for (i = 0; i < ${upper}_NX; i++) {
    if (!(x0[i] - x0[i] == ${zero})) return 1;
  }
%% if symmetric then
  /* L/I1 = w + (I3/I1 - 1) (k.w) k/k^2, the rate of the precession, body axes */
  s = ${name}_pair_product(k[0], w[0]);
  s = ${name}_pair_add(s, ${name}_pair_product(k[1], w[1]));
  s = ${name}_pair_divide(${name}_pair_add(s, ${name}_pair_product(k[2], w[2])), k2);
  (void)${frexp}(I1, &i); /* by a power of two: huge moments must not overflow in a split */
  ratio = ${name}_pair_divide(${name}_pair_sum(${ldexp}(I3, -i), -${ldexp}(I1, -i)), ${ldexp}(I1, -i));
  along = ${name}_pair_multiply(ratio, s);
  for (i = 0; i < 3; i++) v[i] = ${name}_pair_add(${name}_pair_of(w[i]), ${name}_pair_multiply(along, ${name}_pair_of(k[i])));
%% else
  /* L/I1 = w */
  for (i = 0; i < 3; i++) v[i] = ${name}_pair_of(w[i]);
%% end
  length = ${name}_unit_vector(v, u);
  p.precession[0] = ${half}*length.hi;
  p.precession[1] = ${half}*length.lo;

  /* q0, normalised as a vector of four: first the vector part, then with the scalar */
  for (i = 0; i < 3; i++) q[i] = ${name}_pair_of(x0[${upper}_QX + i]);
  length = ${name}_unit_vector(q, right);
  q[0] = ${name}_pair_of(x0[${upper}_QW]);
  q[1] = length;
  q[2] = ${name}_pair_of(${zero});
  if (${name}_unit_vector(q, left).hi == ${zero}) return 1;
  p.q[0][0] = left[0];
  for (i = 0; i < 3; i++) p.q[0][i + 1] = left[1]*right[i];

  /* turning about L on the left is turning about its body direction on the right of q0 */
  left[0] = ${zero};
  for (i = 0; i < 3; i++) left[i + 1] = u[i];
  ${name}_quaternion_product(p.q[0], left, p.q[1]);
%% if symmetric then
  length = ${name}_pair_product(ku, ku); /* ku is rounded: |k| = ku + (k2 - ku^2)/(2 ku) */
  length = ${name}_pair_sum(ku, ((k2 - length.hi) - length.lo)/(${two}*ku));
  length = ${name}_pair_multiply(along, length);
  p.spin[0] = -${half}*length.hi;
  p.spin[1] = -${half}*length.lo;
  right[0] = ${zero};
  for (i = 0; i < 3; i++) right[i + 1] = k[i]/ku;
  ${name}_quaternion_product(p.q[0], right, p.q[2]);
  ${name}_quaternion_product(p.q[1], right, p.q[3]);

  /* w along and across k; k x across, turned backwards, is where w goes next */
  for (i = 0; i < 3; i++) {
    p.along[i] = s.hi*k[i];
    p.across[i] = ${name}_pair_add(${name}_pair_of(w[i]), ${name}_pair_multiply(${name}_pair_of(-k[i]), s)).hi;
  }
  p.turned[0] = (k[2]*p.across[1] - k[1]*p.across[2])/ku;
  p.turned[1] = (k[0]*p.across[2] - k[2]*p.across[0])/ku;
  p.turned[2] = (k[1]*p.across[0] - k[0]*p.across[1])/ku;
%% else
  for (i = 0; i < 4; i++) p.q[2][i] = p.q[3][i] = ${zero};
  for (i = 0; i < 3; i++) {
    p.along[i] = w[i];
    p.across[i] = p.turned[i] = ${zero};
  }
%% end
  if (!(p.precession[0] - p.precession[0] == ${zero})) return 1; /* |L|/I1 is beyond the range of the type */
%% if symmetric then
  if (!(p.spin[0] - p.spin[0] == ${zero})) return 1;
%% end
  *o = p;
  return 0;
}

void ${name}_at(const ${name}_orbit *o, ${name}_real t, ${name}_real x[])
{
  ${name}_real s, c, n;
%% if symmetric then
  ${name}_real sk, ck, sine, cosine;
%% end
  ${name}_real *q = x + ${upper}_QW, *w = x + ${upper}_WX;
  int i;

  ${name}_turn(o->precession, t, &s, &c);
%% if symmetric then
  ${name}_turn(o->spin, t, &sk, &ck);
  sine = ${two}*(sk*ck);
  cosine = (ck - sk)*(ck + sk);
  for (i = 0; i < 4; i++) {
    q[i] = ck*(c*o->q[0][i] + s*o->q[1][i]) + sk*(c*o->q[2][i] + s*o->q[3][i]);
  }
  for (i = 0; i < 3; i++) w[i] = o->along[i] + (cosine*o->across[i] + sine*o->turned[i]);
%% else
  for (i = 0; i < 4; i++) q[i] = c*o->q[0][i] + s*o->q[1][i];
  for (i = 0; i < 3; i++) w[i] = o->along[i];
%% end

  /* rounding only: one Newton step for 1/|q| */
  n = ${threehalves} - ${half}*(q[0]*q[0] + q[1]*q[1] + q[2]*q[2] + q[3]*q[3]);
  for (i = 0; i < 4; i++) q[i] *= n;
}
