// code.js -- the emitted C, compiled to WebAssembly: arrays in its memory, and its functions by name.
// SPDX-License-Identifier: MIT-0
//
// A slot is one state in the memory of the code.

const SLOT = { first: 0, second: 1, reference: 2, spare: 3, touch: 4 };

function bytesOf(text) {
  const raw = atob(text), out = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; i++) out[i] = raw.charCodeAt(i);
  return out;
}

const floatsOf = (text) => new Float32Array(bytesOf(text).buffer);

async function codeOf(bytes, facts) {
  const made = await WebAssembly.instantiate(bytes, {});
  const f = made.instance.exports, Reals = facts.real === "float" ? Float32Array : Float64Array;
  const size = Reals.BYTES_PER_ELEMENT, nx = facts.states.length;
  const view = (at, n) => new Reals(f.memory.buffer, at, n);
  const code = { nx, out: view(f.out(), 16), params: view(f.params(), facts.params.length + 1),
    inputs: view(f.inputs(), facts.inputs.length + 1), states: [] };
  for (let i = 0; i < 5; i++) code.states[i] = view(f.states() + i*nx*size, nx);
  f.defaults();

  code.defaults = () => f.defaults();
  code.init = () => f.init();
  code.initial = (slot) => f.initial(slot);
  code.solve = (slot) => f.solve(slot) === 0;
  code.at = (slot, t) => f.at(slot, t);
  code.march = (slot, method, h, from, to) => f.march(slot, method, h, from, to);
  code.energy = (slot) => f.energy(slot);
  code.momentum = (slot) => {
    f.momentum(slot);
    return Array.from(code.out.subarray(0, 3));
  };
  code.mass = () => {
    f.mass();
    return { mass: code.out[0], com: Array.from(code.out.subarray(1, 4)) };
  };
  code.inertia = () => {
    f.inertia();
    return Array.from(code.out.subarray(0, 6));
  };
  code.principal = () => {
    if (f.principal() !== 0) return null;
    const o = Array.from(code.out);
    return { moments: o.slice(0, 3), axes: [o.slice(3, 6), o.slice(6, 9), o.slice(9, 12)] };
  };
  code.gap = (slot) => f.gap(slot);
  code.impact = (slot) => f.impact(slot);
  if (f.contact) {
    code.contact = (slot, t) => {
      f.contact(slot, t);
      return { N: code.out[0], com: Array.from(code.out.subarray(1, 4)), v: Array.from(code.out.subarray(4, 7)) };
    };
    code.touch = touchOf(code, facts, code.contact);
  }
  return code;
}
