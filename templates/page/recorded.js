// recorded.js -- a motion that was computed before the page was made, in the place of the code.
// SPDX-License-Identifier: MIT-0
//
// It answers as code.js does: the state at a time is the row at that time or the last one before it.

function recordedOf(facts) {
  const r = facts.recorded, nx = facts.states.length, width = nx + 5 + (facts.plane ? 7 : 0);
  const all = new Float64Array(bytesOf(r.rows).buffer), last = r.count - 1, end = all[last*width], rows = [0, 0, 0, 0];
  const states = rows.map(() => new Float64Array(nx));
  const put = (slot, row) => {
    rows[slot] = row;
    states[slot].set(all.subarray(row*width + 1, row*width + 1 + nx));
  };
  const touch = (slot) => {
    const at = rows[slot]*width + 5 + nx, three = (k) => Array.from(all.subarray(at + k, at + k + 3));
    return { N: all[at], com: three(1), point: three(4), n: facts.plane.normal };
  };
  const frame = { moments: r.moments, axes: r.axes };
  return { nx, states, params: Float64Array.from(facts.params.map((p) => p.value)), inputs: [],
    touch: facts.plane && touch, defaults() {}, init: () => 0, solve: () => true,
    initial: (slot) => put(slot, 0),
    at: (slot, t) => put(slot, Math.max(0, Math.min(last, Math.floor(t/end*last + 1e-9)))),
    energy: (slot) => all[rows[slot]*width + 1 + nx],
    momentum: (slot) => Array.from(all.subarray(rows[slot]*width + 2 + nx, rows[slot]*width + 5 + nx)),
    mass: () => ({ mass: r.mass, com: r.com }), inertia: () => r.inertia, principal: () => frame };
}
