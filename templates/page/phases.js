// phases.js -- a body that flies and lands: the codes of its two phases as one, with the states in the air.
// SPDX-License-Identifier: MIT-0
//
// It is the sequence of generator/commands/run/bounce.lua, by steps of h that end where the phase does.  A state has one
// number more than the code's: 1 on the plane, 0 in the air.

const LOST = 64; // roundings of the height: a rise of less is none
const AT_ONCE = 1000; // phases within one step

// air, plane: codeOf; facts: those of the page, with ground = those of the phase on the plane.
function phasesOf(air, plane, facts) {
  const { normal: n, e1, e2, weight } = facts.plane, nx = air.nx, rounding = facts.real === "float" ? 2**-23 : 2**-52;
  const at = {}, code = { ...air, nx: nx + 1, events: [], states: air.states.map(() => new Float64Array(nx + 1)) };
  facts.states.forEach((s, i) => { at[s.name] = i; });
  const three = (x, name) => ["x", "y", "z"].map((k) => x[at[name + k]]);
  const fly = (slot) => air.states[slot].set(code.states[slot].subarray(0, nx));

  // The state on the plane of the one in a slot: its attitude and rates, and its place and velocity along e1 and e2.
  function land(slot) {
    const x = code.states[slot], r = three(x, "r"), v = three(x, "v");
    const own = { p1: dot(e1, r), p2: dot(e2, r), v1: dot(e1, v), v2: dot(e2, v) };
    facts.ground.states.forEach((s, i) => { plane.states[slot][i] = s.own ? own[s.own] : x[at[s.name]]; });
  }
  // And back: what the plane makes of place and velocity.  Returns N.
  function lift(slot, t) {
    const x = code.states[slot], c = plane.contact(slot, t);
    facts.ground.states.forEach((s, i) => { if (!s.own) x[at[s.name]] = plane.states[slot][i]; });
    ["x", "y", "z"].forEach((k, i) => {
      x[at["r" + k]] = c.com[i];
      x[at["v" + k]] = c.v[i];
    });
    return c.N;
  }
  // How far the lowest point is from the plane, and how fast it goes away.
  function low(slot, t) {
    land(slot);
    fly(slot);
    const x = code.states[slot], c = plane.contact(slot, t);
    return { gap: air.gap(slot), rate: dot(n, three(x, "v")) - dot(n, c.v), height: dot(n, three(x, "r")), N: c.N };
  }

  // Which phase begins in a slot.  down: the point cannot rise.  Returns false below the plane.
  function begin(slot, t, down) {
    const now = low(slot, t), least = LOST*rounding*Math.abs(now.height);
    const still = down || now.gap <= least && now.rate <= Math.sqrt(2*weight*least);
    const on = still && now.N > 0;
    code.states[slot][nx] = on ? 1 : 0;
    if (on) lift(slot, t);
    return now.gap >= -least;
  }

  // From the state `from` at t by d: what may not become negative, the gap or N.  whole: number of the step, or null.
  function go(slot, method, from, t, d, whole) {
    code.states[slot].set(from);
    const on = from[nx] === 1, phase = on ? plane : air;
    if (on) land(slot); else fly(slot);
    if (whole === null) phase.march(slot, method, d, t/d, t/d + 0.5); // one step
    else phase.march(slot, method, d, whole, whole + 1);
    if (on) return lift(slot, t + d);
    code.states[slot].set(air.states[slot]);
    return air.gap(slot);
  }

  // The longest step with a positive value, and the state there; 0 where there is none.
  function last(slot, method, from, t, d, start) {
    let a = start, b = d;
    for (let k = 0; k < 60 && !(a > 0); k++) { // the value may be 0 where the phase begins
      const c = b/4;
      if (t + c === t) return 0;
      if (go(slot, method, from, t, c, null) > 0) a = c; else b = c;
    }
    for (let k = 0; k < 100 && t + a < t + b; k++) {
      const c = a + (b - a)/2;
      if (c === a || c === b) break;
      if (go(slot, method, from, t, c, null) > 0) a = c; else b = c;
    }
    go(slot, method, from, t, a, null);
    return a;
  }

  // One step, number i, with all that happens in it.
  function advance(slot, method, h, i) {
    const end = (i + 1)*h;
    let t = i*h;
    for (let k = 0; k < AT_ONCE && t < end; k++) {
      const from = Array.from(code.states[slot]), d = end - t, on = from[nx] === 1;
      const value = go(slot, method, from, t, t === i*h ? h : d, t === i*h ? i : null);
      if (value > 0 || !Number.isFinite(value)) return;
      code.states[slot].set(from);
      const now = low(slot, t), top = on ? 0 : Math.min(d, now.rate/weight);
      const start = !on && top > 0 && go(slot, method, from, t, top, null) > 0 ? top : 0;
      const part = last(slot, method, from, t, d, start);
      if (part === 0) code.states[slot].set(from);
      t += part;
      if (on) {
        code.states[slot][nx] = 0;
        code.events.push({ name: "lift_off", t });
      } else {
        if (part > 0) {
          fly(slot);
          air.impact(slot);
          code.states[slot].set(air.states[slot]);
        }
        begin(slot, t, part === 0);
        code.events.push({ name: code.states[slot][nx] === 1 ? "landing" : "impact", t });
      }
    }
  }

  code.begin = (slot) => begin(slot, 0, false);
  code.march = (slot, method, h, from, to) => { for (let i = from; i < to; i++) advance(slot, method, h, i); };
  code.init = () => {
    plane.params.set(air.params);
    plane.inputs.set(air.inputs);
    const status = air.init(), more = plane.init();
    return status || more && facts.checks.length - facts.ground.checks + more;
  };
  code.initial = (slot) => {
    air.initial(slot);
    code.states[slot].set(air.states[slot]);
    code.states[slot][nx] = 0;
  };
  for (const name of ["energy", "momentum"]) {
    code[name] = (slot) => {
      fly(slot);
      return air[name](slot);
    };
  }
  code.touch = (slot, t) => {
    const x = code.states[slot], r = three(x, "r");
    land(slot);
    const c = plane.touch(slot, t);
    return { N: x[nx] === 1 ? c.N : 0, com: r, point: added(c.point, added(r, scaled(-1, c.com))), n };
  };
  return code;
}
