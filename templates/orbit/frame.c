%% -- frame.c -- frames in wide numbers, complex numbers: part of scene.c.  SPDX-License-Identifier: MIT-0
/* p q, of wide numbers */
static void ${name}_wide_product(const ${name}_wide p[4], const ${name}_wide q[4], ${name}_wide out[4])
{
  static const int at[4][4] = {{0, 1, 2, 3}, {1, 0, 3, 2}, {2, 3, 0, 1}, {3, 2, 1, 0}};
  static const int sign[4][4] = {{1, -1, -1, -1}, {1, 1, 1, -1}, {1, -1, 1, 1}, {1, 1, -1, 1}};

  for (int i = 0; i < 4; i++) {
    out[i] = ${name}_wide_real(${zero});
    for (int k = 0; k < 4; k++) {
      const ${name}_wide term = ${name}_wide_mul(p[k], q[at[i][k]]);

      out[i] = sign[i][k] > 0 ? ${name}_wide_add(out[i], term) : ${name}_wide_sub(out[i], term);
    }
  }
}

/* q to length 1, which it had before; 0 stays */
static ${name}_wide ${name}_wide_unit(int n, ${name}_wide q[])
{
  ${name}_wide sum = ${name}_wide_real(${zero});

  for (int i = 0; i < n; i++) sum = ${name}_wide_add(sum, ${name}_wide_square(q[i]));
  sum = ${name}_wide_root(sum);
  for (int i = 0; i < n && ${name}_wide_sign(sum); i++) q[i] = ${name}_wide_ratio(q[i], sum);
  return sum;
}

/* A unit quaternion that turns z to v: about their bisector's normal, or from -z and half a turn about x. */
static void ${name}_upright(const ${name}_wide v[3], ${name}_wide q[4])
{
  ${name}_wide n[3] = {v[0], v[1], v[2]};
  const ${name}_wide length = ${name}_wide_unit(3, n), zero = ${name}_wide_real(${zero}), one = ${name}_wide_real(${one});

  q[1] = q[2] = q[3] = zero;
  q[0] = one;
  if (!${name}_wide_sign(length)) return;
  if (${name}_wide_sign(n[2]) >= 0) {
    q[0] = ${name}_wide_add(one, n[2]);
    q[1] = ${name}_wide_minus(n[1]);
    q[2] = n[0];
  } else {
    q[0] = ${name}_wide_minus(n[1]);
    q[1] = ${name}_wide_sub(one, n[2]);
    q[3] = n[0];
  }
  (void)${name}_wide_unit(4, q);
}

static ${name}_real ${name}_wide_round(${name}_wide a)
{
  return ${name}_wide_pair(a, 0).hi;
}

/* c = p conj(q)/|p q|; 1 if either is 0 */
static void ${name}_between(const ${name}_real p[2], const ${name}_real q[2], ${name}_real c[2])
{
  const ${name}_real x = p[0]*q[0] + p[1]*q[1], y = p[1]*q[0] - p[0]*q[1];
  const ${name}_real big = ${fabs}(x) > ${fabs}(y) ? ${fabs}(x) : ${fabs}(y);
  ${name}_real n;
  int e;

  c[0] = ${one};
  c[1] = ${zero};
  if (!(big > ${zero})) return;
  (void)${frexp}(big, &e);
  c[0] = ${ldexp}(x, -e);
  c[1] = ${ldexp}(y, -e);
  n = ${one}/${sqrt}(c[0]*c[0] + c[1]*c[1]);
  c[0] *= n;
  c[1] *= n;
}
