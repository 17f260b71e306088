%% -- test_attitude.c -- the self-test of the attitude in other numbers.  Part of test.c.  SPDX-License-Identifier: MIT-0
/* The same turn in several ways. */
static const ${name}_real turn[4] = {${n[0.2]}, -${n[0.4]}, ${n[0.4]}, ${n[0.8]}};

%% if offers.rotate and offers.matrix then
static void matrix_turns(void)
{
  static const ${name}_real v[3] = {${one}, -${two}, ${three}};
  ${name}_real x[${upper}_NX] = {${zero}}, R[9], out[3];
  int i, good = 1;

  for (i = 0; i < 4; i++) x[${upper}_QW + i] = turn[i];
  ${name}_matrix(x, R);
  ${name}_rotate(x, v, out);
  for (i = 0; i < 3; i++) {
    out[i] -= R[3*i]*v[0] + R[3*i + 1]*v[1] + R[3*i + 2]*v[2];
    good = good && ${fabs}(out[i]) <= ${n[128]}*${epsilon};
  }
  report(good, "the matrix turns a vector as the quaternion does");
}

%% end
%% if offers.rotate and offers.unrotate then
static void turned_back(void)
{
  static const ${name}_real v[3] = {${one}, -${two}, ${three}};
  ${name}_real x[${upper}_NX] = {${zero}}, out[3];
  int i, good = 1;

  for (i = 0; i < 4; i++) x[${upper}_QW + i] = turn[i];
  ${name}_rotate(x, v, out);
  ${name}_unrotate(x, out, out);
  for (i = 0; i < 3; i++) good = good && ${fabs}(out[i] - v[i]) <= ${n[128]}*${epsilon};
  report(good, "a vector turned and turned back is what it was");
}

%% end
%% if offers.euler and offers.set_euler then
static void euler_angles(void)
{
  static const char *const sequences[12] = {"xyx", "xzx", "yxy", "yzy", "zxz", "zyz", "xyz", "xzy", "yxz", "yzx", "zxy", "zyx"};
  ${name}_real x[${upper}_NX] = {${zero}}, angles[3];
  int i, k, good = 1;

  for (k = 0; k < 12; k++) {
    ${name}_real sum = ${zero}, difference = ${zero};

    for (i = 0; i < 4; i++) x[${upper}_QW + i] = turn[i];
    good = good && ${name}_euler(x, sequences[k], angles) == 0 && ${name}_set_euler(x, sequences[k], angles) == 0;
    for (i = 0; i < 4; i++) {
      sum += ${fabs}(x[${upper}_QW + i] + turn[i]);
      difference += ${fabs}(x[${upper}_QW + i] - turn[i]);
    }
    good = good && (sum <= ${n[64]}*${epsilon} || difference <= ${n[64]}*${epsilon});
  }
  report(good, "Euler angles of all twelve sequences give the attitude back");
}

%% end
%% if offers.rotation_vector then
static void rotation_vector(void)
{
  ${name}_real x[${upper}_NX] = {${zero}}, v[3], square = ${zero}, along = ${zero};
  int i;

  for (i = 0; i < 4; i++) x[${upper}_QW + i] = turn[i];
  ${name}_rotation_vector(x, v);
  for (i = 0; i < 3; i++) {
    square += v[i]*v[i];
    along += v[i]*turn[i + 1];
  }
  /* |v| = 2 acos 0.2, along the vector part of the quaternion, whose square is 0.96 */
  report(${fabs}(square - ${angle_square}) <= ${n[64]}*${epsilon} && ${fabs}(along*along - ${n[0.96]}*square) <= ${n[64]}*${epsilon},
    "the rotation vector has the angle and the axis of the quaternion");
}

%% end
