// poinsot.js -- what rolls on what where L stays in space: Poinsot's ellipsoid, the cones of a symmetric top.
// SPDX-License-Identifier: MIT-0

// Poinsot's construction where L stays in space and is I w: the ellipsoid w.Iw = 2T rolls on the plane w.L = 2T.
// Returns null or why it does not hold, as {refused}.
function poinsotOf(code, motion, places) {
  const first = motion.samples[0], size = length(first.momentum), p = code.principal();
  if (!(size > 0) || !p || !(p.moments[0] > 0)) return { refused: "the body does not turn, or has no thickness" };
  const w0 = places.w.map((i) => first.x[i]), q0 = places.q.map((i) => first.x[i]);
  const own = p.axes.map((a, k) => scaled(p.moments[k]*dot(a, w0), a)).reduce(added, [0, 0, 0]);
  const off = (a, b) => length(added(a, scaled(-1, b)))/size;
  if (off(turned(q0, own), first.momentum) > 1e-5) return { refused: "wheels or rotors carry momentum, too" };
  for (const s of motion.samples)
    if (!(off(s.momentum, first.momentum) < 1e-4)) return { refused: "torques change L, so there is no fixed plane" };
  const twice = dot(own, w0), unitOf = 1/Math.sqrt(twice/p.moments[0]);
  const turn = towards(first.momentum, [0, 0, -1]), polhode = [], herpolhode = [];
  for (const s of motion.samples) {
    const w = scaled(unitOf, places.w.map((i) => s.x[i]));
    polhode.push(w);
    herpolhode.push(turned(product(turn, places.q.map((i) => s.x[i])), w));
  }
  return { turn, size: unitOf, polhode, herpolhode, frame: attitudeOf(p.axes), depth: -unitOf*twice/size, reach: 1.3,
    axes: p.moments.map((I) => unitOf*Math.sqrt(twice/I)) };
}

// The cones of a free symmetric top: the body cone, about its axis, rolls on the space cone, about L; they touch in w.
// p: what poinsotOf gives.  Returns {axis (in the body), body, space (half-angles), L} or why not, as {refused}.
function conesOf(code, motion, places, kind, p) {
  if (kind !== "symmetric") return { refused: "the body has not two equal moments" };
  if (p.refused) return p;
  const { moments: I, axes } = code.principal(), axis = I[1] - I[0] < I[2] - I[1] ? axes[2] : axes[0];
  const first = motion.samples[0], w = unit(places.w.map((i) => first.x[i])), L = unit(first.momentum);
  const angle = (a, b) => Math.atan2(length(cross(a, b)), dot(a, b));
  const body = angle(axis, w), space = angle(L, turned(places.q.map((i) => first.x[i]), w));
  if (!(space > 1e-9)) return { refused: "w lies along L, so both cones are lines" };
  return { axis: body > Math.PI/2 ? scaled(-1, axis) : axis, body: Math.min(body, Math.PI - body), space, L };
}
