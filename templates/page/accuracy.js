// accuracy.js -- what accuracy costs: two methods against the reference, and measured times.
// SPDX-License-Identifier: MIT-0

// Largest error of a motion's samples: {angle, rate, energy}; reference: time -> state.
function errorsOf(motion, reference, places) {
  let angle = 0, rate = 0, size = 0, energy = 0;
  const pick = (x, list) => list.map((i) => x[i]), first = motion.samples[0].energy;
  for (let i = 0; i < motion.samples.length; i += SAMPLES/60) {
    const s = motion.samples[i], x = reference(s.t), w = pick(x, places.w);
    angle = Math.max(angle, between(pick(s.x, places.q), pick(x, places.q)));
    rate = Math.max(rate, length(added(pick(s.x, places.w), scaled(-1, w))));
    size = Math.max(size, length(w));
    energy = Math.max(energy, Math.abs(s.energy - first));
    if (!s.sound) return { angle: NaN, rate: NaN, energy: NaN };
  }
  return { angle, rate: rate/(size || 1), energy: energy/Math.max(Math.abs(first), 1e-300) };
}

// The reference: the closed form, else the first stepper at a quarter of the smaller step.
function referenceOf(code, facts, start, h, until) {
  if (facts.exact) {
    return { name: "the closed form", at: (t) => {
      const x = code.states[SLOT.reference];
      x.set(start);
      code.solve(SLOT.reference);
      code.at(SLOT.reference, t);
      return Array.from(x);
    } };
  }
  const fine = motionOf(code, SLOT.reference, start, { method: 0, h: h/4 }, until);
  return { name: facts.methods[0].name + " with a quarter of the smaller step",
    at: (t) => stateAt(code, fine, t*(1 + 1e-12)) };
}

const sayError = (x) => Number.isFinite(x) ? x.toExponential(1).replace("-", "−") : "not finite";

// Rows of the table: for each choice, errors at h and at 2 h, and the time of a step.
function accuracyRows(code, facts, places, start, choices, until) {
  const steppers = choices.filter((c) => c && c.method !== "exact");
  const h = steppers.length ? Math.min(...steppers.map((c) => c.h)) : facts.step;
  const reference = referenceOf(code, facts, start, h, until);
  const rows = [];
  for (const choice of choices) {
    if (!choice) continue;
    const name = choice.method === "exact" ? "closed form" : facts.methods[choice.method].name;
    for (const k of choice.method === "exact" ? [1] : [1, 2]) {
      const c = { method: choice.method, h: choice.h*k };
      const m = motionOf(code, SLOT.spare, start, c, until);
      if (!m) continue;
      const e = errorsOf(m, reference.at, places);
      rows.push([name, c.method === "exact" ? "any" : shown(c.h), sayError(e.angle), sayError(e.rate),
        sayError(e.energy), nanoseconds(code, start, c).toFixed(0)]);
    }
  }
  return { rows, reference: reference.name };
}
