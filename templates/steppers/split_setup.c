%% -- split_setup.c -- what the splitting of any body needs of the tensor: part of scene.c.  SPDX-License-Identifier: MIT-0
/* What the drift needs of the tensor, into the model; 1 if it is not finite. */
static int ${name}_split_setup(${name}_model *m)
{
  ${name}_real I[6], moments[3], axes[9], *u = m->split_u, *d = m->split_d;

  ${name}_inertia(m, I);
  if (${name}_principal_of(I, moments, axes)) return 1;
  for (int i = 0; i < 3; i++) {
    m->split_b[i] = axes[i];
    m->split_c[i] = axes[6 + i];
  }
  m->split_fb = (moments[1] - moments[0])/moments[0];
  m->split_fc = (moments[1] - moments[2])/moments[2];
  for (int i = 0; i < 6; i++) I[i] /= moments[1];
  d[0] = I[0];
  u[0] = I[3]/d[0];
  u[1] = I[4]/d[0];
  d[1] = I[1] - u[0]*I[3];
  u[2] = (I[5] - u[0]*I[4])/d[1];
  d[2] = I[2] - u[1]*I[4] - u[2]*(u[2]*d[1]);
  return !(m->split_fb - m->split_fb == ${zero}) || !(u[2] - u[2] == ${zero}) || !(d[2] > ${zero});
}
