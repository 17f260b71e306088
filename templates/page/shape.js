// shape.js -- the body's triangles and lines for the parameters that hold.  SPDX-License-Identifier: MIT-0

function cornersOf(member, values, own) {
  const out = floatsOf(member.at);
  for (const d of member.by) {
    const rate = floatsOf(d.rate), step = values[d.parameter] - own[d.parameter];
    for (let i = 0; i < out.length; i++) out[i] += rate[i]*step;
  }
  return out;
}

// Position and normal, six numbers a corner; normals of neighbours are joined where the surface is smooth.
function surfaceOf(corners, size) {
  const out = new Float32Array(2*corners.length), around = new Map(), normals = [];
  const key = (i) => [0, 1, 2].map((d) => Math.round(corners[i + d]/size*1e5)).join(",");
  for (let i = 0; i < corners.length; i += 9) {
    const p = (k) => [corners[i + k], corners[i + k + 1], corners[i + k + 2]];
    const a = p(0), n = cross(added(p(3), scaled(-1, a)), added(p(6), scaled(-1, a)));
    normals.push(n);
    for (let k = 0; k < 9; k += 3) {
      const name = key(i + k);
      if (!around.has(name)) around.set(name, []);
      around.get(name).push(n);
    }
  }
  for (let i = 0; i < corners.length; i += 3) {
    const own = unit(normals[Math.floor(i/9)]);
    let sum = [0, 0, 0];
    for (const n of around.get(key(i))) if (dot(unit(n), own) > 0.75) sum = added(sum, n);
    out.set(corners.subarray(i, i + 3), 2*i);
    out.set(length(sum) > 0 ? unit(sum) : own, 2*i + 3);
  }
  return out;
}

function ball(n) {
  const list = [], p = (i, k) => {
    const a = Math.PI*i/n, b = 2*Math.PI*k/(2*n);
    return [Math.sin(a)*Math.cos(b), Math.sin(a)*Math.sin(b), Math.cos(a)];
  };
  for (let i = 0; i < n; i++)
    for (let k = 0; k < 2*n; k++) {
      const a = p(i, k), b = p(i + 1, k), c = p(i + 1, k + 1), d = p(i, k + 1);
      for (const v of [a, b, c, a, c, d]) list.push(...v, ...v);
    }
  return new Float32Array(list);
}

// The mantle of a cone that opens along z from the origin, as wide as high.
function cone() {
  const list = [], n = 48, p = (k) => [Math.cos(2*Math.PI*k/n), Math.sin(2*Math.PI*k/n)];
  for (let k = 0; k < n; k++) {
    const a = p(k), b = p(k + 1), mid = p(k + 0.5);
    for (const [v, m] of [[[0, 0, 0], mid], [[...b, 1], b], [[...a, 1], a]]) list.push(...v, ...m, -1);
  }
  return new Float32Array(list);
}

// The rim of a cone and two of its lines, which show that it turns.
function rim(angle, reach) {
  const list = [], at = (k) => [Math.cos(2*Math.PI*k/48)*Math.sin(angle), Math.sin(2*Math.PI*k/48)*Math.sin(angle),
    Math.cos(angle)].map((x) => reach*x);
  for (let k = 0; k <= 48; k++) list.push(...at(k));
  return [...list, 0, 0, 0, ...at(24)];
}

// Between two rings [radius, height] about z, with a flat end below where `closed`: an arrow's shaft, and its head.
function turnedOf(low, high, closed) {
  const list = [], n = 20;
  const at = ([r, z], m) => [r*Math.cos(2*Math.PI*m/n), r*Math.sin(2*Math.PI*m/n), z];
  for (let k = 0; k < n; k++) {
    const a = at(low, k), b = at(low, k + 1), c = at(high, k + 1), d = at(high, k), e = 2*Math.PI*(k + 0.5)/n;
    const normal = unit([Math.cos(e), Math.sin(e), low[0] - high[0]]);
    for (const v of [a, b, c, a, c, d]) list.push(...v, ...normal);
    if (closed) for (const v of [a, [0, 0, low[1]], b]) list.push(...v, 0, 0, -1);
  }
  return new Float32Array(list);
}

const shaftOf = () => turnedOf([1, 0], [1, 1], false);
const headOf = () => turnedOf([1, 0], [0, 1], true);

const BESIDE = 0.03; // of the body's size: what is so near to an axis would be hidden by an arrow along it

// How far a body lies along its axis k, to both sides, near to that axis.
function reachOf(body, k) {
  let low = 0, high = 0;
  for (const list of [body.faces, body.lines, body.points])
    for (let i = 0; i < list.length; i += 3)
      if (Math.hypot(list[i + (k + 1) % 3], list[i + (k + 2) % 3]) < BESIDE*body.size) {
        low = Math.max(low, -list[i + k]);
        high = Math.max(high, list[i + k]);
      }
  return [low/body.size, high/body.size];
}

// What is drawn of a body: {faces, holes, lines, points, size = the farthest of it from the origin, reach = how far it
// lies along its axes, in sizes, ellipsoid}.
function bodyOf(drawing, values, own, code) {
  const body = {};
  const half = (list) => {
    let most = 0;
    for (let i = 0; i < list.length; i += 3) most = Math.max(most, Math.hypot(list[i], list[i + 1], list[i + 2]));
    return most;
  };
  for (const kind of ["faces", "holes", "lines", "points"]) body[kind] = cornersOf(drawing[kind], values, own);
  body.size = Math.max(half(body.faces), half(body.lines), half(body.points));
  if (!(body.size > 0) || body.faces.length + body.lines.length === 0 && body.points.length <= 3) {
    const principal = code.principal(), m = code.mass();
    const s = principal ? principal.moments.map((x, i, I) => (I[0] + I[1] + I[2])/2 - x) : [1, 1, 1];
    body.ellipsoid = { axes: s.map((x) => Math.sqrt(Math.max(5*x/m.mass, 1e-12))), frame: principal };
    body.size = Math.max(...body.ellipsoid.axes);
  }
  body.reach = [0, 1, 2].map((k) => reachOf(body, k));
  body.faces = surfaceOf(body.faces, body.size);
  body.holes = surfaceOf(body.holes, body.size);
  return body;
}
