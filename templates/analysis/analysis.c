%% -- analysis.c -- stability, small oscillations: part of scene.c.  SPDX-License-Identifier: MIT-0
/* ---- stability, small oscillations ---- */

int ${name}_stability(const ${name}_real I[3], int k, ${name}_real s,
    ${name}_real Omega[2], ${name}_real *rate)
{
  const int i = (k + 1) % 3, j = (k + 2) % 3;

  /* about the line of a rod, which has no moment, the rate stays what it is */
  Omega[0] = I[i] > ${zero} ? (I[k] - I[j])/I[i]*s : ${zero};
  Omega[1] = I[j] > ${zero} ? (I[k] - I[i])/I[j]*s : ${zero};
  *rate = ${sqrt}(${fabs}(Omega[0]))*${sqrt}(${fabs}(Omega[1]));
  if (Omega[0] == ${zero} || Omega[1] == ${zero}) return 0;
  return (Omega[0] > ${zero}) == (Omega[1] > ${zero}) ? 1 : -1;
}

void ${name}_linearised(const ${name}_real I[3], int k, const ${name}_real w0[3],
    ${name}_real t, ${name}_real w[3])
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
