%% -- test_estimator.c -- the self-test of the tensor from a gyro.  Part of test.c.  SPDX-License-Identifier: MIT-0
/* Rates a + b t + c t^2 with the torque that a body needs whose tensor is twice the model's. */
static void estimator(const ${name}_model *m)
{
  const ${name}_real dt = ${one}/${n[32]}, sigma[3] = {${n[0.0009765625]}, ${n[0.0009765625]}, ${n[0.0009765625]}};
  ${name}_real I[6], error[6], unit, a[9];
  ${name}_estimator e;
  unsigned long noise = 1;
  int i, k, n, bad = 0;

  ${name}_inertia(m, I);
  unit = (I[0] + I[1] + I[2])/${three};
  for (i = 0; i < 6; i++) {
    I[i] /= unit;
    error[i] = ${two}*unit;
  }
  bad = ${name}_estimator_open(&e, m, dt, 32, sigma, error);
  for (n = 0; n < 40; n++) {
    for (i = 0; i < 9; i++) {
      noise = (noise*1103515245UL + 12345UL) & 0x7fffffffUL;
      a[i] = (${name}_real)((long)(noise/65536UL) - 16384L)/${n[16384]};
    }
    for (k = 0; k < 32; k++) {
      const ${name}_real t = dt*((${name}_real)k + ${half});
      ${name}_real w[3], r[3], L[3], N[3];

      for (i = 0; i < 3; i++) {
        w[i] = a[i] + t*(a[i + 3] + t*a[i + 6]);
        r[i] = a[i + 3] + ${two}*t*a[i + 6];
      }
      for (i = 0; i < 3; i++) {
        const ${name}_real row[3] = {i == 0 ? I[0] : I[i + 2], i == 1 ? I[1] : i == 0 ? I[3] : I[5], i == 2 ? I[2] : I[i + 4]};

        L[i] = ${two}*(row[0]*w[0] + row[1]*w[1] + row[2]*w[2]);
        N[i] = ${two}*(row[0]*r[0] + row[1]*r[1] + row[2]*r[2]);
      }
      N[0] += w[1]*L[2] - w[2]*L[1];
      N[1] += w[2]*L[0] - w[0]*L[2];
      N[2] += w[0]*L[1] - w[1]*L[0];
      for (i = 0; i < 3; i++) N[i] *= unit;
      bad += ${name}_estimator_add(&e, w, N, 0) > 1;
    }
    bad += ${name}_estimator_solve(&e);
  }
  ${name}_estimator_inertia(&e, a, error);
  for (i = 0; i < 6; i++) bad += !(${fabs}(a[i]/unit - ${two}*I[i]) <= ${n[0.001953125]});
  report(bad == 0, "the estimator finds the tensor from rates and torques");
}
