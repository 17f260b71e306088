// space.js -- what is seen in space: the body with its arrows and trails, or Poinsot's rolling ellipsoid.
// SPDX-License-Identifier: MIT-0

const LIGHT = { paper: [1, 1, 1], ink: [0.13, 0.13, 0.13], body: [0.62, 0.68, 0.74], second: [0.55, 0.13, 0.33],
  x: [0, 0.35, 0.56], y: [0.84, 0.37, 0], z: [0, 0.62, 0.45], plane: [0.66, 0.82, 0.94], rate: [0.72, 0, 0.3] };
const DARK = { paper: [0.082, 0.094, 0.114], ink: [0.96, 0.96, 0.96], body: [0.5, 0.56, 0.63],
  second: [0.8, 0.47, 0.65], x: [0.34, 0.71, 0.91], y: [0.9, 0.62, 0], z: [0, 0.62, 0.45],
  plane: [0.11, 0.29, 0.45], rate: [1, 0.45, 0.6] };

const ONE = [1, 0, 0, 0], HERE = [0, 0, 0], EQUAL = [1, 1, 1];

const LONGEST = 120; // points of a trail

// Lengths in sizes of the body; the longest ends within the picture from where the camera is at first.
const AXIS = 1.15, RATE = 1.3, MOMENTUM = 1.45, FAR = 3.8;
const ALONG = 0.97; // cosine of what is along an axis
// Radii of a shaft and a head, and the head's length: a rod, drawn five pixels wide, is seen beside a shaft along it.
const SHAFT = 0.009, HEAD = 0.034, TIP = 0.11;

// How many points of a path on the sphere make a trail: a turn or so; none where they lie too far apart for a curve.
function trailOf(list) {
  let most = 0;
  for (let i = 3; i < list.length; i++) most = Math.max(most, Math.abs(list[i] - list[i - 3]));
  return most < 0.7 ? Math.round(Math.max(12, Math.min(LONGEST, 10/most))) : 0;
}

// facts: of the scene.
function spaceOf(canvas, facts) {
  const r = rendererOf(canvas);
  if (!r) return null;
  const space = { turn: 0.6, height: 0.35, far: FAR, renderer: r };
  const shaft = r.mesh(shaftOf()), head = r.mesh(headOf()), round = r.mesh(ball(24)), funnel = r.mesh(cone());
  const things = {}, trails = [0, 0, 0], ground = facts.plane ? groundOf(r, facts) : null;
  let body = null, poinsot = null, cones = null;

  function renew(name, thing) {
    r.drop(things[name]);
    things[name] = thing;
  }

  space.body = (drawn) => {
    body = drawn;
    renew("faces", r.mesh(drawn.faces));
    renew("holes", r.mesh(drawn.holes));
    renew("wires", r.line(drawn.lines));
  };

  // places: what is where in a state; p, rolled: what poinsotOf and conesOf give, or null.
  space.motion = (m, places, p, rolled) => {
    poinsot = p;
    cones = rolled;
    if (cones) renew("mark", r.line(rim(cones.body, 1.2)));
    const axis = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
    for (let k = 0; k < 3; k++) {
      const list = [];
      for (const s of m.samples) list.push(...scaled(AXIS, turned(places.q.map((i) => s.x[i]), axis[k])));
      renew("trail" + k, r.line(list));
      trails[k] = trailOf(list);
    }
    if (ground) ground.motion(m, body.size);
    if (!p) return;
    renew("polhode", r.line(p.polhode.flat()));
    renew("herpolhode", r.line(p.herpolhode.flat()));
    const n = p.reach, z = p.depth, square = [[-n, -n, z], [n, -n, z], [n, n, z], [-n, -n, z], [n, n, z], [-n, n, z]];
    renew("plane", r.mesh(new Float32Array(square.flatMap((v) => [...v, 0, 0, 1]))));
  };

  // An arrow from `begin` to `size` along a direction; k: how much smaller than alone.
  function pointer(way, size, colour, from = HERE, k = 1, begin = 0) {
    if (!(length(way) > 0)) return;
    const q = towards([0, 0, 1], way), along = unit(way), neck = Math.max(begin, size - TIP*k);
    const put = (mesh, wide, at, long) => {
      const s = [wide, wide, Math.max(long, 1e-6)];
      r.surface(mesh, placed(q, s, added(from, scaled(at, along))), s, [...colour, 1]);
    };
    if (neck > begin) put(shaft, SHAFT*k, begin, neck - begin);
    put(head, HEAD*k, neck, size - neck);
  }

  // Where an arrow along v, in body axes, begins: at the end of what lies along it, as a rod does.
  function beginning(v) {
    const u = unit(v), k = u.findIndex((c) => Math.abs(c) > ALONG);
    return k < 0 ? 0 : Math.min(body.reach[k][u[k] > 0 ? 1 : 0], AXIS - TIP);
  }

  // k: how much smaller than alone.
  function drawBody(q, at, alpha, colour, size, k) {
    const s = k/body.size, scale = [s, s, s];
    if (body.ellipsoid) {
      const own = body.ellipsoid.frame ? product(q, attitudeOf(body.ellipsoid.frame.axes)) : q;
      const e = body.ellipsoid.axes.map((x) => x*s);
      r.surface(round, placed(own, e, at), e, [...colour, alpha]);
    } else {
      r.surface(things.faces, placed(q, scale, at), EQUAL, [...colour, alpha]);
      r.lines(things.wires, placed(q, scale, at), [...colour, alpha], 5, true);
      for (let i = 0; i < body.points.length; i += 3) {
        const p = added(at, turned(q, scaled(s, Array.from(body.points.subarray(i, i + 3)))));
        r.surface(round, placed(q, scaled(0.07*k, EQUAL), p), EQUAL, [...colour, alpha]);
      }
      r.surface(things.holes, placed(q, scale, at), EQUAL, [...colour, 0.45*alpha]);
    }
    if (!size) return;
    // an axis begins where what lies along it ends, so that a rod is not hidden in its own axis
    [[1, 0, 0], [0, 1, 0], [0, 0, 1]].forEach((v, i) =>
      pointer(turned(q, v), AXIS*k, size["xyz"[i]], at, k, Math.min(body.reach[i][1], AXIS - TIP)*k));
  }

  function drawPoinsot(now, c) {
    const q = product(poinsot.turn, now.q), own = product(q, poinsot.frame);
    const up = placed(ONE, EQUAL, HERE);
    r.surface(things.plane, up, EQUAL, [...c.plane, 1]);
    r.lines(things.herpolhode, placed(ONE, EQUAL, [0, 0, 0.002]), [...c.ink, 1], 2.5, false, 0, now.index + 1);
    r.lines(things.polhode, placed(q, EQUAL, HERE), [...c.y, 1], 2.5, false, 0, now.index + 1);
    const w = turned(q, scaled(poinsot.size, now.w));
    pointer(w, length(w), c.rate);
    r.surface(round, placed(own, poinsot.axes, HERE), poinsot.axes, [...c.body, 0.5]);
  }

  function drawCones(now, c) {
    const up = [0, 0, 1], axis = turned(now.q, cones.axis);
    const around = (q, angle, reach) => {
      const s = [reach*Math.sin(angle), reach*Math.sin(angle), reach*Math.max(Math.cos(angle), 1e-3)];
      return [placed(q, s, HERE), s];
    };
    r.surface(funnel, ...around(towards(up, cones.L), cones.space, 1.2), [...c.x, 1]);
    pointer(cones.L, MOMENTUM, c.ink);
    pointer(turned(now.q, now.w), RATE, c.rate);
    pointer(axis, RATE, c.z);
    r.surface(funnel, ...around(product(now.q, towards(up, cones.axis)), cones.body, 1.2), [...c.y, 0.6]);
    r.lines(things.mark, placed(product(now.q, towards(up, cones.axis)), EQUAL, HERE), [...c.y, 1], 2.5, false);
  }

  function drawTrails(now, c) {
    for (let k = 0; k < 3; k++) {
      const from = Math.max(0, now.index - trails[k]), count = now.index - from + 1;
      r.lines(things["trail" + k], placed(ONE, EQUAL, HERE), [...c["xyz"[k]], 1], 2, false, from, count);
    }
  }

  // The body with its arrows; on a plane either its centre of mass is the middle of the picture, or that of its path.
  function drawAlone(now, c, whole) {
    const touch = now.touch, scale = whole ? ground.scale : 1/body.size, k = scale*body.size;
    const centre = whole ? ground.centre : touch && touch.com;
    const place = (t) => t ? scaled(scale, added(t.com, scaled(-1, centre))) : HERE;
    if (!whole) drawTrails(now, c);
    const back = [now.q[0], -now.q[1], -now.q[2], -now.q[3]];
    pointer(turned(now.q, now.w), RATE*k, c.rate, place(touch), k, beginning(now.w)*k);
    pointer(now.L, MOMENTUM*k, c.ink, place(touch), k, beginning(turned(back, now.L))*k);
    drawBody(now.q, place(touch), 1, c.body, c, k);
    if (now.second) drawBody(now.second, place(now.other), 0.45, c.second, null, k);
    if (touch) ground.draw(touch, centre, scale, now.index + 1, c);
  }

  // now: {q, w, L, index, touch: with a plane, second: q of the other method or null, other: its touch}; what: "body" |
  // "poinsot" | "cones" | "path".
  space.draw = (what, now, dark) => {
    const c = dark ? DARK : LIGHT, e = space.height, ratio = canvas.clientWidth/Math.max(1, canvas.clientHeight);
    const way = [Math.cos(e)*Math.cos(space.turn), Math.cos(e)*Math.sin(space.turn), Math.sin(e)];
    const eye = scaled(space.far*Math.max(1, 1.15/ratio), way);
    r.begin(times(perspective(0.8, ratio, 0.1, 40), looking(eye)), c.paper);
    if (what === "poinsot" && poinsot) return drawPoinsot(now, c);
    if (what === "cones" && cones) return drawCones(now, c);
    drawAlone(now, c, what === "path" && ground !== null);
  };

  space.lost = () => r.gl.isContextLost();
  return space;
}
