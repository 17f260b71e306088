// presets.js -- motions that are hard to compute or to believe, for the body of the page.
// SPDX-License-Identifier: MIT-0

const PRESETS = [["", "choose"], ["1", "spin about axis 1, the least moment, disturbed"],
  ["2", "spin about the middle axis: it flips"], ["2s", "the same, very near the separatrix"],
  ["3", "spin about axis 3, the largest moment, disturbed"], ["needle", "needle: a fast spin about axis 1"],
  ["sleep", "sleeping top: upright, spinning about z"], ["weak", "the same with half the spin, leaning"],
  ["fall", "at rest, turned over by almost 180°: it falls and rattles"]];

// Where z of the body is z of space: the further turn that takes the scene's own attitude there, as a rotation vector.
function uprightOf(q) {
  const back = [q[0], -q[1], -q[2], -q[3]], v = [back[1], back[2], back[3]];
  return scaled(2*Math.atan2(length(v), back[0]), unit(v));
}

// {w, turn}: initial rates in body axes and the further turn; size: the rate that is in force.
function presetOf(kind, principal, own, size) {
  const none = [0, 0, 0];
  if (kind === "sleep") return { w: [0, 0, size], turn: uprightOf(own) };
  if (kind === "weak") {
    const up = rotationOf(uprightOf(own)), lean = rotationOf([0.2, 0, 0]);
    return { w: [0, 0, size/2], turn: vectorOf(product(up, lean)) };
  }
  if (kind === "fall") return { w: none, turn: [Math.PI - 0.002, 0, 0] };
  if (!principal) return { w: [0, 0, size], turn: none };
  const k = kind === "needle" ? 0 : Number(kind[0]) - 1;
  const [by, small] = { needle: [5, 0.001], "2s": [1, 1e-6] }[kind] || [1, 0.02];
  return { w: added(scaled(by*size, principal.axes[k]), scaled(small*size, principal.axes[(k + 1) % 3])), turn: none };
}
