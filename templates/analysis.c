%% -- analysis.c -- principal axes, stability, small oscillations: part of scene.c.  SPDX-License-Identifier: MIT-0

/* ---- principal axes, stability, small oscillations ---- */

void ${name}_principal(const ${name}_model *m, ${name}_real moments[3], ${name}_real axes[9])
{
  ${name}_real I[6], a[3][3], v[3][3] = {{${one}, ${zero}, ${zero}}, {${zero}, ${one}, ${zero}}, {${zero}, ${zero}, ${one}}};
  int order[3] = {0, 1, 2}, sweep, i, j, k, busy = 1;

  ${name}_inertia(m, I);
  a[0][0] = I[0];
  a[1][1] = I[1];
  a[2][2] = I[2];
  a[0][1] = a[1][0] = I[3];
  a[0][2] = a[2][0] = I[4];
  a[1][2] = a[2][1] = I[5];

  /* cyclic Jacobi (Golub, Van Loan, 8.5): a rotation in the plane (i, j) removes a[i][j]; an entry is removed
   * already when it is negligible beside BOTH its diagonal entries, which keeps small moments accurate */
  for (sweep = 0; sweep < 12 && busy; sweep++) {
    busy = 0;
    for (i = 0; i < 2; i++) {
      for (j = i + 1; j < 3; j++) {
        const ${name}_real limit = ${epsilon}*(${sqrt}(${fabs}(a[i][i]))*${sqrt}(${fabs}(a[j][j])));
        ${name}_real theta, tangent, cosine, sine, p, q;

        if (${fabs}(a[i][j]) <= limit) {
          a[i][j] = a[j][i] = ${zero};
          continue;
        }
        busy = 1;
        theta = ${half}*(a[j][j] - a[i][i])/a[i][j];
        tangent = ${one}/(${fabs}(theta) + ${sqrt}(${one} + theta*theta));
        if (theta < ${zero}) tangent = -tangent;
        cosine = ${one}/${sqrt}(${one} + tangent*tangent);
        sine = tangent*cosine;
        a[i][i] -= tangent*a[i][j];
        a[j][j] += tangent*a[i][j];
        a[i][j] = a[j][i] = ${zero};
        k = 3 - i - j;
        p = a[k][i];
        q = a[k][j];
        a[k][i] = a[i][k] = cosine*p - sine*q;
        a[k][j] = a[j][k] = sine*p + cosine*q;
        for (k = 0; k < 3; k++) {
          p = v[k][i];
          q = v[k][j];
          v[k][i] = cosine*p - sine*q;
          v[k][j] = sine*p + cosine*q;
        }
      }
    }
  }

  for (i = 1; i < 3; i++) { /* insertion sort: equal moments keep their order */
    for (j = i; j > 0 && a[order[j]][order[j]] < a[order[j - 1]][order[j - 1]]; j--) {
      k = order[j];
      order[j] = order[j - 1];
      order[j - 1] = k;
    }
  }
  for (i = 0; i < 3; i++) {
    int largest = 0;

%% if oblique then
%% else
    moments[i] = a[order[i]][order[i]];
%% end
    for (k = 1; k < 3; k++) {
      if (${fabs}(v[k][order[i]]) > ${fabs}(v[largest][order[i]])) largest = k;
    }
    for (k = 0; k < 3; k++) {
      axes[3*i + k] = v[largest][order[i]] < ${zero} ? -v[k][order[i]] : v[k][order[i]];
    }
  }
%% if oblique then
  /* two moments are equal by the body's symmetry: they are given as equal, not as what rounding left of them */
  moments[0] = ${I3} < ${I1} ? ${I3} : ${I1};
  moments[1] = ${I1};
  moments[2] = ${I3} < ${I1} ? ${I1} : ${I3};
%% end
  /* the third axis is the vector product of the others: right-handed */
  axes[6] = axes[1]*axes[5] - axes[2]*axes[4];
  axes[7] = axes[2]*axes[3] - axes[0]*axes[5];
  axes[8] = axes[0]*axes[4] - axes[1]*axes[3];
}

int ${name}_stability(const ${name}_real I[3], int k, ${name}_real s, ${name}_real Omega[2], ${name}_real *rate)
{
  const int i = (k + 1) % 3, j = (k + 2) % 3;

  /* about the line of a rod, which has no moment, the rate stays what it is */
  Omega[0] = I[i] > ${zero} ? (I[k] - I[j])/I[i]*s : ${zero};
  Omega[1] = I[j] > ${zero} ? (I[k] - I[i])/I[j]*s : ${zero};
  *rate = ${sqrt}(${fabs}(Omega[0]))*${sqrt}(${fabs}(Omega[1]));
  if (Omega[0] == ${zero} || Omega[1] == ${zero}) return 0;
  return (Omega[0] > ${zero}) == (Omega[1] > ${zero}) ? 1 : -1;
}

void ${name}_linearised(const ${name}_real I[3], int k, const ${name}_real w0[3], ${name}_real t, ${name}_real w[3])
{
  const int i = (k + 1) % 3, j = (k + 2) % 3;
  const ${name}_real wi = w0[i], wj = w0[j], wk = w0[k];
  ${name}_real Omega[2], rate, c = ${one}, s = t; /* cos(rate t) and sin(rate t)/rate; neutral: 1 and t */
  const int verdict = ${name}_stability(I, k, wk, Omega, &rate);

  if (verdict > 0) {
    c = ${cos}(rate*t);
    s = ${sin}(rate*t)/rate;
  } else if (verdict < 0) {
    c = ${cosh}(rate*t);
    s = ${sinh}(rate*t)/rate;
  }
  w[i] = c*wi - Omega[0]*s*wj;
  w[j] = c*wj + Omega[1]*s*wi;
  w[k] = wk;
}
