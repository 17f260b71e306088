// ground.js -- the plane that a body touches, with a grid at rest in space and the path of the contact point.
// SPDX-License-Identifier: MIT-0

const LINES = 6; // of the grid, to each side

function groundOf(r, facts) {
  const list = [], edge = [[-1, -1], [1, -1], [1, 1], [-1, -1], [1, 1], [-1, 1]];
  for (let k = -LINES; k <= LINES; k++) list.push(k, -LINES, 0, k, LINES, 0, -LINES, k, 0, LINES, k, 0);
  const grid = r.line(list), square = r.mesh(new Float32Array(edge.flatMap(([x, y]) => [x, y, 0, 0, 0, 1])));
  const ground = {};
  let path = null;

  // The middle of the path and the scale that shows it whole; size: the body's, of which there is always room for four.
  ground.motion = (m, size) => {
    const points = m.samples.map((s) => s.touch.point), all = m.samples.map((s) => s.touch.com);
    const low = [0, 1, 2].map((k) => Math.min(...points.map((p) => p[k]), ...all.map((p) => p[k])));
    const high = [0, 1, 2].map((k) => Math.max(...points.map((p) => p[k]), ...all.map((p) => p[k])));
    r.drop(path);
    path = r.line(points.flat());
    ground.centre = scaled(0.5, added(low, high));
    ground.scale = 1.4/Math.max(0.5*length(added(high, scaled(-1, low))), 2*size);
  };

  // Beneath what is seen at `scale` around `centre`.  touch: of this moment; count: points of the path that are drawn
  ground.draw = (touch, centre, scale, count, c) => {
    const n = touch.n, raw = 0.8/scale, ten = 10**Math.floor(Math.log10(raw));
    const space = [5, 2, 1].map((k) => k*ten).find((d) => d <= raw), s = space*scale, one = [s, s, s];
    const x = facts.plane.e1, y = facts.plane.e2;
    const foot = added(centre, scaled(-dot(centre, n), n));
    const under = scaled(scale, added(foot, scaled(-1, centre))), lift = scaled(0.004, n);
    const flat = attitudeOf([x, y, n]);
    const off = (e) => scaled(-scale*(dot(foot, e) - space*Math.round(dot(foot, e)/space)), e);
    const trace = placed(ONE, [scale, scale, scale], added(scaled(-scale, centre), lift));
    r.lines(path, trace, [...c.second, 1], 3, false, 0, count);
    r.lines(grid, placed(flat, one, added(under, added(off(x), off(y)))), [...c.ink, 0.3], 1, true);
    const wide = LINES*s;
    r.surface(square, placed(flat, [wide, wide, wide], under), EQUAL, [...c.plane, 0.5]);
  };
  return ground;
}
