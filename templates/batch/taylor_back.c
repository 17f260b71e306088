%% -- taylor_back.c -- several bodies back from their turning frames: part of scene.c.  SPDX-License-Identifier: MIT-0
%% if shift then
/* q = exp(g s/2) of the quaternion in the frame that turns in space with g, as for one body. */
static void ${name}_${way}_back(${owner}, const ${name}_wide x[], ${name}_wide c[][${upper}_ROW], const ${name}_wide *time, ${name}_wide d[])
{
  const ${name}_wide none = {${zero}};
%% for _, line in ipairs(frame.loads) do
  ${line}
%% end
%% for _, line in ipairs(frame.lines) do
  ${line}
%% end
  const ${name}_wide *q = c[0];
  /* q g, then times the conjugate of q: g in space */
  const ${name}_wide aw = -q[1]*gx - q[2]*gy - q[3]*gz, ax = q[0]*gx + q[2]*gz - q[3]*gy;
  const ${name}_wide ay = q[0]*gy - q[1]*gz + q[3]*gx, az = q[0]*gz + q[1]*gy - q[2]*gx;
  const ${name}_wide hx = ax*q[0] - aw*q[1] - ay*q[3] + az*q[2], hy = ay*q[0] - aw*q[2] + ax*q[3] - az*q[1];
  const ${name}_wide hz = az*q[0] - aw*q[3] - ax*q[2] + ay*q[1];
  const ${name}_wide w = q[0] + d[0], i = q[1] + d[1], j = q[2] + d[2], l = q[3] + d[3];
  ${name}_wide S, C, D, f;
  ${name}_bodies size, sine, cosine, part;

  (void)none;
  (void)${model};
  (void)x;
  size.v = hx*hx + hy*hy + hz*hz;
  for (int n = 0; n < ${upper}_WIDE; n++) size.e[n] = ${sqrt}(size.e[n]);
  part.v = ${quarter}**time*size.v; /* a quarter of the turn */
  for (int n = 0; n < ${upper}_WIDE; n++) {
    sine.e[n] = ${sin}(part.e[n]);
    cosine.e[n] = ${cos}(part.e[n]);
  }
  S = sine.v;
  C = cosine.v;
  D = -${two}*S*S;
  part.v = ${two}*S*C;
  for (int n = 0; n < ${upper}_WIDE; n++) part.e[n] = size.e[n] > ${zero} ? part.e[n]/size.e[n] : ${zero};
  f = part.v;
  d[0] += D*w - f*(hx*i + hy*j + hz*l);
  d[1] += D*i + f*(hx*w + hy*l - hz*j);
  d[2] += D*j + f*(hy*w + hz*i - hx*l);
  d[3] += D*l + f*(hz*w + hx*j - hy*i);
}
%% end
