// presets.js -- motions that are hard to compute or to believe, for the body of the page.
// SPDX-License-Identifier: MIT-0

const PRESETS = [["", "choose"], ["1", "spin about axis 1, the least moment, disturbed"],
  ["2", "spin about the middle axis: it flips"], ["2s", "the same, very near the separatrix"],
  ["3", "spin about axis 3, the largest moment, disturbed"], ["needle", "needle: a fast spin about axis 1"],
  ["sleep", "sleeping top: upright, spinning about z"], ["weak", "the same with half the spin, leaning"],
  ["fall", "at rest, turned over by almost 180°: it falls and rattles"]];
const RATTLING = ["compass", "rattling compass: at rest, the magnet almost against the field"];

// Where z of the body is z of space: the further turn that takes the scene's own attitude there, as a rotation vector.
function uprightOf(q) {
  const back = [q[0], -q[1], -q[2], -q[3]], v = [back[1], back[2], back[3]];
  return scaled(2*Math.atan2(length(v), back[0]), unit(v));
}

// The further turn that takes the magnet to 0.002 rad from where it would rest against the field.
function againstOf(own, compass) {
  const from = turned(own, compass.moment), side = Math.abs(unit(compass.field)[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0];
  const off = scaled(0.002, unit(cross(compass.field, side))), to = turned(rotationOf(off), scaled(-1, compass.field));
  const back = [own[0], -own[1], -own[2], -own[3]];
  return vectorOf(product(product(back, towards(from, to)), own));
}

// {w, turn}: initial rates in body axes and the further turn; size: the rate that is in force;
// compass: {moment (body axes), field (inertial)} of a scene that has one.
function presetOf(kind, principal, own, size, compass) {
  const none = [0, 0, 0];
  if (kind === "sleep") return { w: [0, 0, size], turn: uprightOf(own) };
  if (kind === "weak") {
    const up = rotationOf(uprightOf(own)), lean = rotationOf([0.2, 0, 0]);
    return { w: [0, 0, size/2], turn: vectorOf(product(up, lean)) };
  }
  if (kind === "compass") return { w: none, turn: againstOf(own, compass) };
  if (kind === "fall") return { w: none, turn: [Math.PI - 0.002, 0, 0] };
  if (!principal) return { w: [0, 0, size], turn: none };
  const k = kind === "needle" ? 0 : Number(kind[0]) - 1;
  const [by, small] = { needle: [5, 0.001], "2s": [1, 1e-6] }[kind] || [1, 0.02];
  return { w: added(scaled(by*size, principal.axes[k]), scaled(small*size, principal.axes[(k + 1) % 3])), turn: none };
}
