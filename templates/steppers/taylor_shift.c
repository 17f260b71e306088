%% -- taylor_shift.c -- back from the frame that turns in space: part of scene.c.  SPDX-License-Identifier: MIT-0
/* The series give q in a frame that turns in space with g = L/I2, constant; q itself is exp(g s/2) times that.  What c[0] + d
 * moves by: the exponential less 1 is (cos - 1, sin h/|h|), h = g in space, of modulus 1 also when |q| is not quite. */
static void ${name}_taylor_back(const ${name}_model *m, const ${name}_real x[], ${name}_real c[][${upper}_ROW], ${name}_real s, ${name}_real d[${upper}_ROW])
{
%% for _, line in ipairs(frame.loads) do
  ${line}
%% end
%% for _, line in ipairs(frame.lines) do
  ${line}
%% end
  const ${name}_real *q = c[0];

  (void)m; /* constants may be in the code */
  (void)x;
  /* q g, then times the conjugate of q: g in space */
  const ${name}_real aw = -q[1]*gx - q[2]*gy - q[3]*gz, ax = q[0]*gx + q[2]*gz - q[3]*gy;
  const ${name}_real ay = q[0]*gy - q[1]*gz + q[3]*gx, az = q[0]*gz + q[1]*gy - q[2]*gx;
  const ${name}_real hx = ax*q[0] - aw*q[1] - ay*q[3] + az*q[2], hy = ay*q[0] - aw*q[2] + ax*q[3] - az*q[1];
  const ${name}_real hz = az*q[0] - aw*q[3] - ax*q[2] + ay*q[1];
  const ${name}_real size = ${sqrt}(hx*hx + hy*hy + hz*hz), angle = ${quarter}*s*size; /* a quarter of the turn */
  const ${name}_real S = ${sin}(angle), C = ${cos}(angle), D = -${two}*S*S, k = size > ${zero} ? ${two}*S*C/size : ${zero};
  const ${name}_real w = q[0] + d[0], i = q[1] + d[1], j = q[2] + d[2], l = q[3] + d[3];

  d[0] += D*w - k*(hx*i + hy*j + hz*l);
  d[1] += D*i + k*(hx*w + hy*l - hz*j);
  d[2] += D*j + k*(hy*w + hz*i - hx*l);
  d[3] += D*l + k*(hz*w + hx*j - hy*i);
}
