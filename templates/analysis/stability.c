%% -- stability.c -- which spins persist: part of scene.c.  SPDX-License-Identifier: MIT-0
int ${name}_spin_stable(const ${name}_model *m, int axis, int dissipation)
{
%% if numeric then
  ${name}_real I[3], axes[9];
  int order[3];
%% else
  ${order}
%% end
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  int above_i, above_j; /* the signs of I_axis - I_i and I_axis - I_j */

%% if numeric then
  ${name}_principal(m, I, axes);
  order[0] = (I[1] > I[2]) - (I[1] < I[2]);
  order[1] = (I[2] > I[0]) - (I[2] < I[0]);
  order[2] = (I[0] > I[1]) - (I[0] < I[1]);
%% end
%% if void then
  (void)m;
%% end
  above_i = order[j];
  above_j = -order[i];
  if (!dissipation) return above_i*above_j;
  if (above_i < 0 || above_j < 0) return -1;
  return above_i*above_j;
}
