// vectors.js -- vectors, quaternions (scalar first) and 4 x 4 matrices (column by column).
// SPDX-License-Identifier: MIT-0

const dot = (a, b) => a[0]*b[0] + a[1]*b[1] + a[2]*b[2];
const cross = (a, b) => [a[1]*b[2] - a[2]*b[1], a[2]*b[0] - a[0]*b[2], a[0]*b[1] - a[1]*b[0]];
const scaled = (k, a) => [k*a[0], k*a[1], k*a[2]];
const added = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const length = (a) => Math.hypot(a[0], a[1], a[2]);
const unit = (a) => scaled(1/(length(a) || 1), a);

// v of the body in inertial axes: q v q*.
function turned(q, v) {
  const u = [q[1], q[2], q[3]], t = scaled(2, cross(u, v));
  return added(added(v, scaled(q[0], t)), cross(u, t));
}

function product(p, q) {
  return [p[0]*q[0] - p[1]*q[1] - p[2]*q[2] - p[3]*q[3],
    p[0]*q[1] + p[1]*q[0] + p[2]*q[3] - p[3]*q[2],
    p[0]*q[2] - p[1]*q[3] + p[2]*q[0] + p[3]*q[1],
    p[0]*q[3] + p[1]*q[2] - p[2]*q[1] + p[3]*q[0]];
}

// The quaternion of a rotation vector, and back; the angle is at most pi.
function rotationOf(v) {
  const a = length(v), s = a > 0 ? Math.sin(a/2)/a : 0;
  return [Math.cos(a/2), s*v[0], s*v[1], s*v[2]];
}

function vectorOf(q) {
  const side = q[0] < 0 ? -1 : 1, v = [side*q[1], side*q[2], side*q[3]];
  return scaled(2*Math.atan2(length(v), side*q[0]), unit(v));
}

// The shortest turn that takes the direction a to b.
function towards(a, b) {
  const u = unit(a), v = unit(b), c = dot(u, v);
  if (c < -0.999999) {
    const across = unit(Math.abs(u[0]) < 0.9 ? cross(u, [1, 0, 0]) : cross(u, [0, 1, 0]));
    return [0, across[0], across[1], across[2]];
  }
  const s = cross(u, v), n = Math.hypot(1 + c, s[0], s[1], s[2]);
  return [(1 + c)/n, s[0]/n, s[1]/n, s[2]/n];
}

// The angle between two attitudes, rad; q and -q are the same.
function between(p, q) {
  const c = product([p[0], -p[1], -p[2], -p[3]], q);
  return 2*Math.atan2(Math.hypot(c[1], c[2], c[3]), Math.abs(c[0]));
}

function times(a, b) {
  const out = new Float32Array(16);
  for (let c = 0; c < 4; c++)
    for (let r = 0; r < 4; r++) {
      let sum = 0;
      for (let k = 0; k < 4; k++) sum += a[4*k + r]*b[4*c + k];
      out[4*c + r] = sum;
    }
  return out;
}

function perspective(angle, ratio, near, far) {
  const f = 1/Math.tan(angle/2), out = new Float32Array(16);
  out[0] = f/ratio;
  out[5] = f;
  out[10] = (far + near)/(near - far);
  out[11] = -1;
  out[14] = 2*far*near/(near - far);
  return out;
}

// A camera at `eye` that looks at the origin, z up.
function looking(eye) {
  const back = unit(eye), right = unit(cross([0, 0, 1], back)), up = cross(back, right);
  return new Float32Array([right[0], up[0], back[0], 0, right[1], up[1], back[1], 0, right[2], up[2], back[2], 0,
    -dot(right, eye), -dot(up, eye), -dot(back, eye), 1]);
}

// Attitude, scale and place as one matrix.
function placed(q, s, at) {
  const x = turned(q, [s[0], 0, 0]), y = turned(q, [0, s[1], 0]), z = turned(q, [0, 0, s[2]]);
  return new Float32Array([x[0], x[1], x[2], 0, y[0], y[1], y[2], 0, z[0], z[1], z[2], 0, at[0], at[1], at[2], 1]);
}

// The quaternion of right-handed axes given as three unit vectors.
function attitudeOf(a) {
  const [x, y, z] = a, t = x[0] + y[1] + z[2];
  let q;
  if (t > 0) q = [1 + t, y[2] - z[1], z[0] - x[2], x[1] - y[0]];
  else if (x[0] > y[1] && x[0] > z[2]) q = [y[2] - z[1], 1 + x[0] - y[1] - z[2], y[0] + x[1], z[0] + x[2]];
  else if (y[1] > z[2]) q = [z[0] - x[2], y[0] + x[1], 1 + y[1] - x[0] - z[2], z[1] + y[2]];
  else q = [x[1] - y[0], z[0] + x[2], z[1] + y[2], 1 + z[2] - x[0] - y[1]];
  const n = Math.hypot(...q);
  return q.map((c) => c/n);
}
