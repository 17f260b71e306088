%% -- attitude.c -- the attitude in other numbers.  Part of scene.c.  SPDX-License-Identifier: MIT-0
/* ---- the attitude in other numbers ---- */

void ${name}_matrix(const ${name}_real x[], ${name}_real R[9])
{
  const ${name}_real w = x[${upper}_QW], a = x[${upper}_QX], b = x[${upper}_QY], c = x[${upper}_QZ];
  const ${name}_real ww = w*w, aa = a*a, bb = b*b, cc = c*c;

  /* R = (w^2 - v.v) 1 + 2 v v^T + 2 w [v x], v the vector part of q */
  R[0] = (ww + aa) - (bb + cc);
  R[4] = (ww + bb) - (aa + cc);
  R[8] = (ww + cc) - (aa + bb);
  R[1] = ${two}*(a*b - w*c);
  R[3] = ${two}*(a*b + w*c);
  R[2] = ${two}*(a*c + w*b);
  R[6] = ${two}*(a*c - w*b);
  R[5] = ${two}*(b*c - w*a);
  R[7] = ${two}*(b*c + w*a);
}

/* v + 2 w (u x v) + 2 u x (u x v), u the vector part of q */
static void ${name}_sandwich(${name}_real w, const ${name}_real u[3], const ${name}_real v[3], ${name}_real out[3])
{
  const ${name}_real v0 = v[0], v1 = v[1], v2 = v[2];
  const ${name}_real c0 = ${two}*(u[1]*v2 - u[2]*v1), c1 = ${two}*(u[2]*v0 - u[0]*v2), c2 = ${two}*(u[0]*v1 - u[1]*v0);

  out[0] = v0 + (w*c0 + (u[1]*c2 - u[2]*c1));
  out[1] = v1 + (w*c1 + (u[2]*c0 - u[0]*c2));
  out[2] = v2 + (w*c2 + (u[0]*c1 - u[1]*c0));
}

void ${name}_rotate(const ${name}_real x[], const ${name}_real body[3], ${name}_real inertial[3])
{
  ${name}_sandwich(x[${upper}_QW], x + ${upper}_QX, body, inertial);
}

void ${name}_unrotate(const ${name}_real x[], const ${name}_real inertial[3], ${name}_real body[3])
{
  ${name}_sandwich(-x[${upper}_QW], x + ${upper}_QX, inertial, body); /* -q* turns as q* does */
}

void ${name}_rotation_vector(const ${name}_real x[], ${name}_real v[3])
{
  const ${name}_real *u = x + ${upper}_QX, w = ${fabs}(x[${upper}_QW]);
  ${name}_real unit[3], length, largest = ${zero};

  for (int i = 0; i < 3; i++) {
    v[i] = ${zero};
    if (${fabs}(u[i]) > largest) largest = ${fabs}(u[i]);
  }
  if (!(largest > ${zero})) return;
  for (int i = 0; i < 3; i++) unit[i] = u[i]/largest; /* so that no square underflows */
  length = ${sqrt}(unit[0]*unit[0] + unit[1]*unit[1] + unit[2]*unit[2]);
  length = (x[${upper}_QW] < ${zero} ? -${two} : ${two})*${atan2}(largest*length, w)/length;
  for (int i = 0; i < 3; i++) v[i] = length*unit[i];
}

/* The axes 0, 1, 2 of a sequence: axis[0] and axis[1] its first two, axis[2] the one that is neither.  Returns the sign
 * of this order of axes; 0 if it is no sequence.  *proper: is its last letter the first one? */
static int ${name}_axes(const char sequence[], int axis[3], int *proper)
{
  int last;

  for (int i = 0; i < 3; i++) {
    if (sequence[i] < 'x' || sequence[i] > 'z') return 0;
    axis[i] = sequence[i] - 'x';
  }
  last = axis[2];
  if (sequence[3] != 0 || axis[0] == axis[1] || last == axis[1]) return 0;
  *proper = last == axis[0];
  axis[2] = 3 - axis[0] - axis[1];
  return (axis[1] - axis[0] + 3)%3 == 1 ? 1 : -1;
}

static ${name}_real ${name}_wrapped(${name}_real angle)
{
  const ${name}_real pi = ${pi};

  return angle > pi ? angle - ${two}*pi : angle <= -pi ? angle + ${two}*pi : angle;
}

int ${name}_euler(const ${name}_real x[], const char sequence[], ${name}_real angles[3])
{
  const ${name}_real w = x[${upper}_QW], *u = x + ${upper}_QX;
  ${name}_real a, b, c, d, low, high, mid, sum, difference, sign;
  int axis[3], proper;
  const int order = ${name}_axes(sequence, axis, &proper);

  if (order == 0) return 2;
  sign = (${name}_real)order;
  /* Half the sum and half the difference of first and third are the arguments of (a, b) and (c, d): in
   *   q = cos(second/2) (cos(sum), e_1 sin(sum)) + sin(second/2) (e_2 cos(difference), e_3 sin(difference))
   * where the last letter is the first one.  Else a quarter turn about the second axis, times the root of 2, makes the
   * third axis the first one (Bernardes and Viollet 2022). */
  a = w, b = u[axis[0]], c = u[axis[1]], d = sign*u[axis[2]];
  if (!proper) {
    const ${name}_real shift = c;

    mid = ${two}*(a*c + b*d); /* sin(second) */
    c += a, a -= shift;
    b -= d, d += u[axis[0]];
  } else {
    mid = ${zero};
  }
  low = ${sqrt}(a*a + b*b), high = ${sqrt}(c*c + d*d);
  sum = ${atan2}(b, a), difference = ${atan2}(d, c);
  /* tan(second/2) = high/low, and with the quarter turn (high - low)/(high + low) */
  angles[1] = proper ? ${two}*${atan2}(high, low) : ${two}*${atan2}(${two}*mid, (high + low)*(high + low));
  if (low < ${singular} || high < ${singular}) {
    const ${name}_real half_pi = ${half}*${pi};

    angles[0] = ${name}_wrapped(${two}*(high < ${singular} ? sum : difference));
    angles[1] = proper ? (high < ${singular} ? ${zero} : ${two}*half_pi) : high < ${singular} ? -half_pi : half_pi;
    angles[2] = ${zero};
    return 1;
  }
  angles[0] = ${name}_wrapped(sum + difference);
  angles[2] = ${name}_wrapped(proper ? sum - difference : sign*(difference - sum));
  return 0;
}

int ${name}_set_euler(${name}_real x[], const char sequence[], const ${name}_real angles[3])
{
  ${name}_real s[3], c[3], *u = x + ${upper}_QX, sign;
  int axis[3], proper;
  const int order = ${name}_axes(sequence, axis, &proper);

  if (order == 0) return 2;
  sign = (${name}_real)order;
  for (int i = 0; i < 3; i++) {
    if (!(${fabs}(angles[i]) < ${huge})) return 3;
  }
  for (int i = 0; i < 3; i++) s[i] = ${sin}(${half}*angles[i]), c[i] = ${cos}(${half}*angles[i]);
  if (proper) { /* the formula above, sums and differences multiplied out */
    x[${upper}_QW] = c[1]*(c[0]*c[2] - s[0]*s[2]);
    u[axis[0]] = c[1]*(s[0]*c[2] + c[0]*s[2]);
    u[axis[1]] = s[1]*(c[0]*c[2] + s[0]*s[2]);
    u[axis[2]] = sign*(s[1]*(s[0]*c[2] - c[0]*s[2]));
  } else { /* the product of the three turns */
    x[${upper}_QW] = c[0]*c[1]*c[2] - sign*(s[0]*s[1]*s[2]);
    u[axis[0]] = s[0]*c[1]*c[2] + sign*(c[0]*s[1]*s[2]);
    u[axis[1]] = c[0]*s[1]*c[2] - sign*(s[0]*c[1]*s[2]);
    u[axis[2]] = c[0]*c[1]*s[2] + sign*(s[0]*s[1]*c[2]);
  }
  return 0;
}
