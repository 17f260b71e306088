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
function keepContact(motion, flies) {
  if (flies) return true;
  const i = motion.samples.findIndex((s) => s.touch && !(s.touch.N > 0));
  if (i < 0) return true;
  motion.lost = motion.samples[i].t;
  motion.samples.length = i;
  if (i > 0) motion.end = motion.samples[i - 1].t;
  return i > 1;
}
