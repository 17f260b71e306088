%% -- principal.c -- principal axes of a tensor: part of scene.c.  SPDX-License-Identifier: MIT-0
/* ---- principal axes: Jacobi's method in pairs ----
 * Jacobi's rotations keep small moments beside large ones: Demmel, Veselic 1992, SIAM J. Matrix Anal. Appl. 13, 1204.
 * In pairs the rotations are orthogonal to twice the precision, so rounding their product once is all that the axes
 * suffer. */

/* (x, y) turned: (c x - s y, s x + c y) */
static void ${name}_pair_turn(${name}_pair c, ${name}_pair s, ${name}_pair *x, ${name}_pair *y)
{
  const ${name}_pair cx = ${name}_mul(c, *x), sx = ${name}_mul(s, *x);
  const ${name}_pair cy = ${name}_mul(c, *y), sy = ${name}_mul(s, *y);

  *x = ${name}_add(cx, ${name}_minus(sy));
  *y = ${name}_add(sx, cy);
}

/* Turn the axes p, q so that the entry I_pq = off[r] vanishes ({p, q, r} = {0, 1, 2}; I_kk = diagonal[k]).
 * The tangent t solves (1 - t^2) I_pq = t (I_qq - I_pp), |t| <= 1 (Golub, Van Loan, 8.5), but only to the type's
 * precision; the rotation by this t is exact, and what is left of I_pq = cos^2 ((1 - t^2) I_pq - t (I_qq - I_pp))
 * stays for the next one. */
static void ${name}_jacobi(${name}_pair diagonal[3], ${name}_pair off[3], ${name}_pair axis[3][3], int r)
{
  const int p = (r + 1) % 3, q = (r + 2) % 3;
  const ${name}_pair difference = ${name}_add(diagonal[q], ${name}_minus(diagonal[p]));
  const ${name}_real d = ${half}*difference.hi, b = off[r].hi;
  ${name}_pair t, t2, c, s, left, change;
  ${name}_real slope, root;

  /* the quotient that is at most 1: no overflow, whatever the sizes */
  if (${fabs}(b) < ${fabs}(d)) {
    slope = b/d;
    slope = slope/(${one} + ${sqrt}(${one} + slope*slope));
  } else {
    slope = d/b;
    root = ${sqrt}(${one} + slope*slope);
    slope = slope < ${zero} ? ${one}/(slope - root) : ${one}/(slope + root);
  }
  t = ${name}_pair_of(slope);
  t2 = ${name}_pair_product(slope, slope);

  /* c = 1/sqrt(1 + t^2), a Newton step from its leading half; s = t c */
  c = ${name}_add(${name}_pair_of(${one}), t2);
  root = ${one}/${sqrt}(c.hi);
  s = ${name}_mul(c, ${name}_pair_product(root, root));
  c = ${name}_pair_sum(root, ${half}*root*((${one} - s.hi) - s.lo));
  s = ${name}_mul(t, c);

  left = ${name}_mul(${name}_add(${name}_pair_of(${one}), ${name}_minus(t2)), off[r]);
  left = ${name}_add(left, ${name}_minus(${name}_mul(t, difference)));
  left = ${name}_mul(${name}_mul(c, c), left);
  change = ${name}_mul(t, ${name}_add(off[r], left));
  diagonal[p] = ${name}_add(diagonal[p], ${name}_minus(change));
  diagonal[q] = ${name}_add(diagonal[q], change);
  off[r] = slope == ${zero} ? ${name}_pair_of(${zero}) : left; /* too small to turn by: too small to matter */
  ${name}_pair_turn(c, s, &off[q], &off[p]); /* I_rp, I_rq */
  for (int k = 0; k < 3; k++) ${name}_pair_turn(c, s, &axis[p][k], &axis[q][k]);
}

static int ${name}_pair_less(${name}_pair a, ${name}_pair b)
{
  return a.hi < b.hi || (!(b.hi < a.hi) && a.lo < b.lo);
}

/* The unrounded result: I_kk 2^scale and the vector of each axis, which come in no order; `order` sorts them, ascending.
 * 1 if an entry is not finite. */
static int ${name}_principal_pairs(const ${name}_real I[6], ${name}_pair diagonal[3], ${name}_pair axis[3][3],
                                   int order[3], int *scale)
{
  ${name}_pair off[3];
  ${name}_real largest = ${zero}, products = ${zero};
  int settled = 0, i, j, k;

  for (i = 0; i < 6; i++) {
    if (!(I[i] - I[i] == ${zero})) return 1;
    if (${fabs}(I[i]) > largest) largest = ${fabs}(I[i]);
    if (i > 2) products += ${fabs}(I[i]) > ${zero} ? ${one} : ${zero};
  }
  /* by a power of two to where the halves of the products neither over- nor underflow */
  (void)${frexp}(largest, scale);
  *scale = products > ${zero} ? ${pair_top} - *scale : 0;
  for (i = 0; i < 3; i++) {
    diagonal[i] = ${name}_pair_of(${ldexp}(I[i], *scale));
    off[i] = ${name}_pair_of(${ldexp}(I[5 - i], *scale)); /* yz, xz, xy: the one opposite to axis i */
    for (k = 0; k < 3; k++) axis[i][k] = ${name}_pair_of(i == k ? ${one} : ${zero});
  }

  /* The planes xy, xz, yz in turn, until each is negligible beside BOTH its diagonal entries.  With I_pq = 0 a
   * rotation in the plane (r, p) splits I_rq = y into I_rq = y cos, I_pq = y sin; |sin| <= sqrt(1/2), and the next
   * plane is that of the larger one.  So from the second rotation on the smaller of the two products left shrinks by
   * sqrt(1/2) or more each time, for ANY tensor: after 240 both are below 2^-118 of the largest entry, beyond the
   * pairs.  For a positive definite one a rotation with I_pq^2 >= I_pp I_qq/4 takes a quarter or more off the product
   * of the diagonal, which stays above the determinant: the condition alone bounds their number.  Then what is left is
   * squared; some ten rotations are made in all. */
  for (int count = 0; settled < 3 && count < 240; count++) { /* some 10 times */
    i = 2 - count % 3;
    j = (i + 1) % 3;
    k = (i + 2) % 3;
    if (${fabs}(off[i].hi) <= ${negligible}*(${sqrt}(${fabs}(diagonal[j].hi))*${sqrt}(${fabs}(diagonal[k].hi)))) {
      off[i] = ${name}_pair_of(${zero});
      settled++;
    } else {
      ${name}_jacobi(diagonal, off, axis, i);
      settled = 0;
    }
  }

  for (i = 0; i < 3; i++) order[i] = i;
  for (i = 1; i < 3; i++) { /* insertion sort: equal moments keep their order */
    for (j = i; j > 0 && ${name}_pair_less(diagonal[order[j]], diagonal[order[j - 1]]); j--) {
      k = order[j];
      order[j] = order[j - 1];
      order[j - 1] = k;
    }
  }
  return 0;
}

int ${name}_principal_of(const ${name}_real I[6], ${name}_real moments[3], ${name}_real axes[9])
{
  ${name}_pair diagonal[3], axis[3][3];
  ${name}_real own[3];
  int order[3], odd, scale, k;

  if (${name}_principal_pairs(I, diagonal, axis, order, &scale)) return 1;
  odd = order[1] != (order[0] + 1) % 3;
  for (int i = 0; i < 3; i++) {
    own[i] = ${ldexp}(diagonal[order[i]].hi, -scale);
    if (!(own[i] - own[i] == ${zero})) return 1;
  }
  for (int i = 0; i < 3; i++) {
    const ${name}_pair *v = axis[order[i]];
    ${name}_real sign, largest;

    moments[i] = own[i];
    largest = ${zero};
    for (k = 0; k < 3; k++) {
      if (${fabs}(v[k].hi) > largest) largest = ${fabs}(v[k].hi);
    }
    for (k = 0; ${fabs}(v[k].hi) < ${sign_margin}*largest;) k++;
    /* the rotations have determinant 1: two signs and the order settle the third */
    sign = (i < 2 ? v[k].hi < ${zero} : odd) ? -${one} : ${one};
    if (sign < ${zero}) odd = !odd;
    for (k = 0; k < 3; k++) axes[3*i + k] = sign*v[k].hi + ${zero}; /* no negative zero */
  }
  return 0;
}

int ${name}_principal(const ${name}_model *m, ${name}_real moments[3], ${name}_real axes[9])
{
  ${name}_real I[6];

  ${name}_inertia(m, I);
%% if oblique then
  if (${name}_principal_of(I, moments, axes)) return 1;
  /* two moments are equal by the body's symmetry: they are given as equal, not as what rounding left of them */
  moments[0] = ${least};
  moments[1] = ${I1};
  moments[2] = ${most};
  return 0;
%% else
  return ${name}_principal_of(I, moments, axes);
%% end
}
