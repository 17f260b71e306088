// presets.js -- motions that are worth a look, for the body of the page: those that its physics has.
// SPDX-License-Identifier: MIT-0
//
// facts.turning says what turns the body: nothing ("free"), its weight, or something for which nothing is offered.

const NEEDLE = 0.1; // a least moment that is less of the others: a needle
const EQUAL_MOMENTS = 1e-9; // of the largest: as equal as the roundings of a sum of pieces leave them
const ABOVE = 1.25, BELOW = 0.5; // of the least spin of a sleeping top

// Pairs of a key and what it is called.
function presetsOf(facts, principal) {
  const list = [["", "choose"]];
  if (facts.turning === "free" && principal) {
    const [a, b, c] = principal.moments, near = (x, y) => y - x <= EQUAL_MOMENTS*c;
    if (a > 0 && !near(a, b) && !near(b, c)) {
      list.push(["1", "spin about axis 1, the least moment, disturbed: stable"],
        ["2", "spin about axis 2, the middle moment, disturbed: it flips"],
        ["2s", "the same, very near the separatrix: it flips late"],
        ["3", "spin about axis 3, the largest moment, disturbed: stable"]);
    } else if (a > 0 && near(a, b) !== near(b, c)) {
      list.push(["axial", "spin about the symmetry axis, disturbed: it wobbles"],
        ["across", "spin across the symmetry axis: it tumbles"]);
    }
    if (a > 0 && a < NEEDLE*b) list.push(["needle", "needle: a fast spin about axis 1"]);
  }
  if (facts.weight) {
    if (facts.weight.rate) {
      list.push(["sleep", "sleeping top: upright, above its least spin"],
        ["weak", "leaning, with half of the least spin: it nods"]);
    }
    list.push(["fall", "at rest, almost upright: it falls and swings"]);
  }
  if (facts.compass) list.push(["compass", "rattling compass: at rest, the magnet almost against the field"]);
  return list;
}

// The further turn that takes a direction of the body from where the attitude `own` has it to one in space.
function turnTo(own, direction, to) {
  const back = [own[0], -own[1], -own[2], -own[3]];
  return vectorOf(product(product(back, towards(turned(own, direction), to)), own));
}

// A direction that is `angle` away from another one, for a small angle.
function beside(direction, angle) {
  const side = Math.abs(unit(direction)[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0];
  return turned(rotationOf(scaled(angle, unit(cross(direction, side)))), direction);
}

// {w, turn}: initial rates in body axes and the further turn.  own: the scene's initial attitude; size: the rate that
// is in force; arm: to the centre of mass, body axes; facts.compass: {moment (body axes), field (inertial)}.
function presetOf(kind, facts, principal, own, size, arm) {
  const none = [0, 0, 0], { weight, compass } = facts;
  if (kind === "sleep") return { w: scaled(ABOVE*weight.rate, unit(arm)), turn: turnTo(own, arm, weight.up) };
  if (kind === "weak")
    return { w: scaled(BELOW*weight.rate, unit(arm)), turn: turnTo(own, arm, beside(weight.up, 0.2)) };
  if (kind === "fall") return { w: none, turn: turnTo(own, arm, beside(weight.up, 0.002)) };
  if (kind === "compass")
    return { w: none, turn: turnTo(own, compass.moment, beside(scaled(-1, compass.field), 0.002)) };
  const [a, b, c] = principal.moments, third = b - a < c - b ? 2 : 0; // the symmetry axis of a symmetric body
  const k = { needle: 0, axial: third, across: 1 }[kind] ?? Number(kind[0]) - 1;
  const other = kind === "across" ? third : (k + 1) % 3;
  const [by, small] = { needle: [5, 0.001], "2s": [1, 1e-6], axial: [1, 0.1] }[kind] || [1, 0.02];
  return { w: added(scaled(by*size, principal.axes[k]), scaled(small*size, principal.axes[other])), turn: none };
}
