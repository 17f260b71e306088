// motion.js -- a motion by one method: samples over the horizon, and the state at any time.
// SPDX-License-Identifier: MIT-0
//
// A stepper has a fixed h, never the time of a frame, so its states have the bits of a native program; a time between
// two steps shows the step before.  Samples are the places from which the rest is marched.

const SAMPLES = 600, MOST_SAMPLES = 3000, MOST_STEPS = 4e6;

// How many samples a motion wants that begins with the rates w: 8 degrees from one to the next, where so many may be.
const samplesOf = (w, until) => Math.round(Math.max(SAMPLES, Math.min(MOST_SAMPLES, length(w)*until/0.14))) || SAMPLES;

// choice: {method: "exact" | number of a stepper, h}; returns null if the code refuses the state.
function motionOf(code, slot, start, choice, until, count = SAMPLES) {
  const exact = choice.method === "exact", x = code.states[slot], h = choice.h;
  const last = exact ? 0 : Math.min(Math.floor(until/h + 1e-9), MOST_STEPS);
  const end = exact ? until : last*h, samples = [];
  x.set(start);
  if (exact && !code.solve(slot)) return null;
  if (code.begin && !code.begin(slot)) return null;
  code.events = [];
  let done = 0;
  for (let i = 0; i <= count; i++) {
    if (exact) {
      code.at(slot, end*i/count);
    } else {
      const n = Math.round(last*i/count);
      code.march(slot, choice.method, h, done, n);
      done = n;
    }
    const state = Array.from(x), t = exact ? end*i/count : done*h;
    samples.push({ t, n: done, x: state, energy: code.energy(slot), momentum: code.momentum(slot),
      touch: code.touch ? code.touch(slot, t) : null, sound: state.every(Number.isFinite) });
  }
  return { exact, choice, slot, samples, end, start: Array.from(start), events: code.events, cut: !exact && until/h > MOST_STEPS + 1 };
}

// The state at time t, in the motion's slot.
function stateAt(code, motion, t) {
  const x = code.states[motion.slot], reach = Math.max(0, Math.min(t, motion.end));
  if (motion.exact) {
    x.set(motion.start);
    code.solve(motion.slot);
    code.at(motion.slot, reach);
  } else {
    const h = motion.choice.h, n = Math.floor(reach/h + 1e-9);
    const last = motion.samples.length - 1;
    let i = Math.min(last, Math.floor(last*reach/(motion.end || 1)));
    while (i > 0 && motion.samples[i].n > n) i--;
    x.set(motion.samples[i].x);
    code.events = [];
    code.march(motion.slot, motion.choice.method, h, motion.samples[i].n, n);
  }
  return Array.from(x);
}

// Nanoseconds per step or per state, the best of five batches; clocks of browsers are coarse, so each lasts 15 ms.
function nanoseconds(code, start, choice) {
  const x = code.states[SLOT.spare];
  let best = Infinity, n = 256;
  for (let k = 0; k < 5;) {
    x.set(start);
    const began = performance.now();
    if (choice.method === "exact") for (let i = 0; i < n; i++) code.at(SLOT.spare, i*choice.h);
    else code.march(SLOT.spare, choice.method, choice.h, 0, n);
    const took = performance.now() - began;
    if (took < 15 && n < 1e8) {
      n *= 2;
    } else {
      best = Math.min(best, 1e6*took/n);
      k++;
    }
  }
  return best;
}
