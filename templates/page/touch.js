// touch.js -- where a body on a plane touches it, from the emitted NAME_contact.  SPDX-License-Identifier: MIT-0
//
// NAME_contact gives the reaction N, the centre of mass and its velocity.  r goes from the centre of mass to the
// contact point.  The velocity along the normal n is -n.(w x r): with the three unit rates for w it has the components
// of n x r.  And n.r is the height of the centre of mass with the other sign.

// A function of a slot and the time: {N, com, point, n}, vectors in inertial axes.  contact: slot, time -> {N, com, v}
function touchOf(code, facts, contact) {
  const q = [], w = [], n = facts.plane.normal;
  facts.states.forEach((s, i) => {
    if (s.kind === "attitude") q.push(i);
    if (s.kind === "rates") w.push(i);
  });
  const x = code.states[SLOT.touch];
  return (slot, t) => {
    const now = contact(slot, t), a = q.map((i) => code.states[slot][i]);
    const g = turned([a[0], -a[1], -a[2], -a[3]], n);
    const across = w.map((_, k) => { // r x g
      x.set(code.states[slot]);
      w.forEach((i, j) => { x[i] = j === k ? 1 : 0; });
      return -dot(n, contact(SLOT.touch, t).v);
    });
    const r = added(scaled(-dot(now.com, n), g), cross(g, across));
    return { N: now.N, com: now.com, point: added(now.com, turned(a, r)), n };
  };
}

// A motion on a plane ends where N is not positive: cuts its samples there and notes the time as `lost`.  Returns false
// where no motion is left.
function keepContact(motion, plane) {
  if (plane && plane.flies) return true;
  const i = motion.samples.findIndex((s) => s.touch && !(s.touch.N > 0));
  if (i < 0) return true;
  motion.lost = motion.samples[i].t;
  motion.samples.length = i;
  if (i > 0) motion.end = motion.samples[i - 1].t;
  return i > 1;
}

// A disc's motion ends where it lies flat, by the laws of generator/dynamics/flat.lua: cuts the samples there and
// says so in `flat`.  The numbers of plane.disc are those of the scene's own parameters.
function keepUpright(motion, places, facts) {
  const { disc, normal } = facts.plane, near = Math.sqrt(facts.real === "float" ? 2**-23 : 2**-52);
  const settled = (g, w, on) => {
    const k = disc.pull - (disc.rolls ? dot(g, w)**2*disc.off : 0);
    const top = Math.hypot(g[0], g[1])*disc.ratio + (w[0]*w[0] + w[1]*w[1])/(2*k);
    return on && k > 0 && 2*top < k*disc.step**2;
  };
  const fallen = (g, w, on, within) => {
    const [x, y] = cross(g, w), speed = Math.hypot(x, y), left = -(g[0]*x + g[1]*y)/speed**2;
    return on && left > 0 && left <= within && Math.abs(g[0]*y - g[1]*x) <= near*speed;
  };
  let before = false;
  for (let i = 0; i < motion.samples.length; i++) {
    const { x, t, touch } = motion.samples[i], q = places.q.map((k) => x[k]), w = places.w.map((k) => x[k]);
    const g = turned([q[0], -q[1], -q[2], -q[3]], normal), on = touch.N > 0, next = motion.samples[i + 1];
    const now = settled(g, w, on), falls = next && fallen(g, w, on, 1.25*(next.t - t));
    const settledAtFirst = i === 0 && now;
    if (settledAtFirst || i > 1 && (now && before || falls)) {
      motion.flat = falls ? "The disc falls flat, and touches the plane in a line," : "The disc has settled flat";
      motion.samples.length = i + 1;
      if (settledAtFirst) motion.samples.push(motion.samples[0]); // curves have two points
      motion.end = t;
      return;
    }
    before = now;
  }
}
