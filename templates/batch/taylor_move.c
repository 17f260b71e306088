%% -- taylor_move.c -- steps of several bodies from their coefficients: part of scene.c.  SPDX-License-Identifier: MIT-0
/* what the states move by in the times h, and one Newton step for 1/|q|, as for one body */
static void ${name}_${way}_step_by(${owner}, ${name}_wide c[][${upper}_ROW], int top, const ${name}_wide *time, const ${name}_wide x[],
                            ${name}_wide d[])
{
  const ${name}_wide s = *time, square = s*s;
%% if attitude then
  const ${name}_wide n = ${half} - ${half}*(c[0][0]*c[0][0] + c[0][1]*c[0][1] + c[0][2]*c[0][2] + c[0][3]*c[0][3]);
%% end
  ${name}_wide a[${upper}_MOVING], b[${upper}_MOVING];
  int i;

  for (int k = 0; k < ${upper}_MOVING; k++) {
    a[k] = c[top][k];
    b[k] = c[top - 1][k];
  }
  for (i = top - 2; i > 1; i -= 2) {
    for (int k = 0; k < ${upper}_MOVING; k++) {
      a[k] = c[i][k] + square*a[k];
      b[k] = c[i - 1][k] + square*b[k];
    }
  }
  for (int k = 0; k < ${upper}_MOVING; k++) {
    if (i == 1) d[k] = s*(c[1][k] + square*a[k]) + square*b[k];
    else d[k] = s*b[k] + square*a[k];
  }
%% if shift then
  ${name}_${way}_back(${model}, x, c, time, d);
%% else
  (void)${model};
  (void)x;
%% end
%% if attitude then
  for (i = 0; i < 4; i++) d[i] += n*(c[0][i] + d[i]);
%% end
}
