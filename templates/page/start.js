// start.js -- the page: reads what the generator put in, computes the motion anew after each change, and plays it.
// SPDX-License-Identifier: MIT-0
//
// Time that passes is time of the motion: a frame shows the state of its moment, however late it comes.

async function start() {
  const facts = JSON.parse($("facts").textContent), drawing = JSON.parse($("shape").textContent);
  const code = await codeOf(bytesOf($("code").textContent.trim()), facts);
  const own = Array.from(code.params.subarray(0, facts.params.length)), places = { q: [], w: [] };
  facts.states.forEach((s, i) => {
    if (s.kind === "attitude") places.q.push(i);
    if (s.kind === "rates") places.w.push(i);
  });
  const page = { facts, code, places, t: 0, playing: false, motion: null, other: null, until: facts.horizon };
  let space = null;
  try {
    space = spaceOf($("space"));
  } catch (e) {
    $("note").textContent = e.message;
  }
  $("no-webgl").hidden = space !== null;
  $("space").hidden = space === null;

  code.init();
  code.initial(SLOT.spare);
  const scene = Array.from(code.states[SLOT.spare]);
  const most = 1.5*Math.max(1, length(places.w.map((i) => scene[i])));

  // ---- controls ----

  let due = false;
  const changed = () => {
    if (due) return;
    due = true;
    requestAnimationFrame(() => {
      due = false;
      renew();
    });
  };
  const controls = {};
  facts.params.forEach((p, i) => {
    const v = own[i], low = v === 0 ? -p.factor : Math.min(-0.2*v, 3*v), high = v === 0 ? p.factor : Math.max(-0.2*v, 3*v);
    controls["p." + p.name] = slider($("parameters"), "p-" + p.name, p.name, p.unit, low, high, v, p.factor, changed);
  });
  ["wx", "wy", "wz"].forEach((name, k) => {
    controls[name] = slider($("rates0"), name, "ω" + "xyz"[k], "rad/s", -most, most, scene[places.w[k]], 1, changed);
    controls["turn" + "xyz"[k]] = slider($("turn0"), "turn-" + "xyz"[k], "xyz"[k], "°", -Math.PI, Math.PI, 0,
      Math.PI/180, changed);
  });
  facts.inputs.forEach((u) => {
    controls["u." + u.name] = slider($("inputs"), "u-" + u.name, u.name, u.unit, -1, 1, 0, 1, changed);
  });
  const choose = (select, list) => list.forEach(([value, text]) => select.add(new Option(text, value)));
  const names = facts.methods.map((m, i) => [String(i), m.name]);
  if (facts.exact) names.unshift(["exact", "closed form"]);
  choose($("first"), names);
  choose($("second"), [["none", "nothing"], ...names]);
  choose($("preset"), [["", "choose"], ["1", "spin about axis 1, disturbed"], ["2", "spin about the middle axis: the flip"],
    ["2s", "very near the separatrix"], ["3", "spin about axis 3, disturbed"], ["sleep", "upright, along z: a sleeping top"]]);
  $("step").value = facts.step;
  const stepOf = () => Number($("step").value) > 0 ? Number($("step").value) : facts.step;
  const choiceOf = (id) => {
    const v = $(id).value;
    return v === "none" ? null : { method: v === "exact" ? v : Number(v), h: stepOf() };
  };

  // ---- the motion ----

  function initial() {
    code.initial(SLOT.spare);
    const x = Array.from(code.states[SLOT.spare]), v = ["x", "y", "z"].map((k) => controls["turn" + k].read());
    ["wx", "wy", "wz"].forEach((name, k) => { x[places.w[k]] = controls[name].read(); });
    const a = length(v), s = a > 0 ? Math.sin(a/2)/a : 0;
    if (a > 0) product(places.q.map((i) => x[i]), [Math.cos(a/2), s*v[0], s*v[1], s*v[2]])
      .forEach((c, k) => { x[places.q[k]] = c; });
    return x;
  }

  function refuse(text) {
    $("refused").textContent = text;
  }

  function renew() {
    const values = facts.params.map((p) => controls["p." + p.name].read()), before = Array.from(code.params);
    code.params.set(values);
    facts.inputs.forEach((u, i) => { code.inputs[i] = controls["u." + u.name].read(); });
    const status = code.init();
    if (status !== 0) {
      code.params.set(before);
      refuse("No such body: " + (facts.checks[status - 1] || "check " + status) + ". The last body stays.");
      return;
    }
    const x = initial(), made = motionOf(code, SLOT.first, x, choiceOf("first"), page.until);
    if (!made) return refuse("The closed form refuses this state: the attitude or a rate is out of range.");
    const bad = made.samples.find((s) => !s.sound);
    refuse(bad ? "The numbers become infinite at t = " + shown(bad.t) + " s: a smaller step helps." : "");
    page.motion = made;
    const second = choiceOf("second");
    page.other = second && motionOf(code, SLOT.second, x, second, page.until);
    page.start = x;
    const p = poinsotOf(code, made, places);
    page.poinsot = p.refused ? null : p;
    $("what").options[1].disabled = !page.poinsot;
    $("what").options[1].textContent = "Poinsot's ellipsoid" + (p.refused ? " (not here: " + p.refused + ")" : "");
    if (!page.poinsot) $("what").value = "body";
    if (space) {
      space.body(bodyOf(drawing, values, own, code));
      space.motion(made, places, page.poinsot);
    }
    plots(made);
    tensor();
    $("time").max = made.end;
    $("note").textContent = made.cut ? "Only " + MOST_STEPS + " steps are computed: t ends early." :
      drawing.fixed ? "The picture keeps the shape of the scene's own parameters." : "";
    show();
    if (!page.playing) address();
  }

  function plots(m) {
    const t = m.samples.map((s) => s.t), first = m.samples[0].energy;
    const rate = (k) => m.samples.map((s) => s.x[places.w[k]]);
    page.markRates = drawCurves($("rates"), t, [0, 1, 2].map((k) => ({ name: "ω" + "xyz"[k], css: "xyz"[k],
      values: rate(k) })), "ω / (rad/s)", "Angular velocity in body axes over time");
    const spread = Math.max(...m.samples.map((s) => Math.abs(s.energy - first))), size = Math.abs(first);
    const drift = size > 0 && spread < 1e-3*size, ten = spread > 0 ? Math.floor(Math.log10(spread/size)) : 0;
    page.markEnergy = drawCurves($("energy"), t, [{ name: "E", css: "e", values: m.samples.map((s) =>
      drift ? (s.energy - first)/size/Math.pow(10, ten) : s.energy) }],
    drift ? "(E − E₀)/E₀" + (ten ? " · 10^" + (-ten) : "") : "E / J",
      drift ? "Relative drift of the energy over time" : "Energy over time");
  }

  function tensor() {
    const I = code.inertia(), list = [];
    facts.formulas.forEach((f, k) => {
      if (f.text === "0" || f.text === "") return;
      const dt = document.createElement("dt"), dd = document.createElement("dd");
      dt.textContent = "I" + f.name;
      dd.textContent = (f.text.length < 60 ? f.text + " = " : "") + I[k].toPrecision(6).replace("-", "−") + " kg m²";
      list.push(dt, dd);
    });
    $("tensor").replaceChildren(...list);
  }

  // ---- one moment ----

  const pick = (x, list) => list.map((i) => x[i]);

  function show() {
    const m = page.motion;
    if (!m) return;
    page.t = Math.max(0, Math.min(page.t, m.end));
    const x = stateAt(code, m, page.t), L = code.momentum(m.slot), E = code.energy(m.slot);
    const y = page.other && stateAt(code, page.other, page.t);
    page.state = x;
    $("time").value = page.t;
    $("now").textContent = page.t.toFixed(3).replace("-", "−") + "\u00a0s";
    $("time").setAttribute("aria-valuetext", page.t.toFixed(2) + " s");
    page.markRates(page.t);
    page.markEnergy(page.t);
    const rows = facts.states.map((s, i) => [s.name, x[i]]).concat([["E / J", E], ["|L| / (N m s)", length(L)]]);
    const body = $("values").tBodies[0];
    rows.forEach(([name, v], i) => {
      const row = body.rows[i] || body.insertRow();
      if (!row.cells.length) {
        row.append(document.createElement("th"), document.createElement("td"));
        row.cells[0].scope = "row";
        row.cells[0].textContent = name;
      }
      row.cells[1].textContent = v.toPrecision(10).replace("-", "−");
    });
    $("difference").textContent = y ? "Difference of the two at this time: " +
      sayError(between(pick(x, places.q), pick(y, places.q))) + " rad; the second body is drawn through the first." : "";
    if (space && !space.lost()) space.draw($("what").value, { q: pick(x, places.q), w: pick(x, places.w), L,
      index: Math.floor(SAMPLES*page.t/(m.end || 1)), second: y && pick(y, places.q) }, dark.matches);
    $("space").setAttribute("aria-label", "The body in space at t = " + page.t.toFixed(1) + " s");
  }

  function address() {
    const out = {};
    for (const [name, c] of Object.entries(controls)) if (c.read() !== c.first) out[name] = c.read();
    if ($("first").selectedIndex > 0) out.first = $("first").value;
    if ($("second").selectedIndex > 0) out.second = $("second").value;
    if (stepOf() !== facts.step) out.h = stepOf();
    if ($("what").value !== "body") out.what = $("what").value;
    if (page.t > 0) out.t = page.t;
    writeAddress(out);
  }

  // ---- playing ----

  let before = 0;
  function frame(now) {
    if (!page.playing) return;
    const speed = $("speed").value === "fit" ? page.motion.end/10 : Number($("speed").value);
    page.t += (now - before)/1000*speed;
    before = now;
    page.clock = now;
    page.frames = (page.frames || 0) + 1;
    if (page.t >= page.motion.end) page.t = page.motion.end;
    show();
    if (page.t >= page.motion.end) return play(false);
    requestAnimationFrame(frame);
  }
  function play(on) {
    page.playing = on;
    $("play").textContent = on ? "Pause" : "Play";
    if (!on) return address();
    if (page.t >= page.motion.end) page.t = 0;
    before = performance.now();
    requestAnimationFrame(frame);
  }
  function go(t) {
    play(false);
    page.t = t;
    show();
    address();
  }

  const dark = matchMedia("(prefers-color-scheme: dark)");
  dark.addEventListener("change", show);
  addEventListener("resize", show);
  $("play").addEventListener("click", () => play(!page.playing));
  $("back").addEventListener("click", () => go(page.t - stepOf()*(1 - 1e-6)));
  $("forth").addEventListener("click", () => go(page.t + stepOf()*(1 + 1e-6)));
  $("time").addEventListener("input", () => go(Number($("time").value)));
  $("what").addEventListener("change", () => go(page.t));
  for (const id of ["first", "second", "step"]) $(id).addEventListener("change", changed);
  $("reset").addEventListener("click", () => {
    for (const c of Object.values(controls)) c.write(c.first);
    renew();
  });
  $("preset").addEventListener("change", () => preset($("preset").value));
  $("measure").addEventListener("click", () => {
    const { rows, reference } = accuracyRows(code, facts, places, page.start, [choiceOf("first"), choiceOf("second")],
      page.motion.end);
    $("costs").tBodies[0].replaceChildren(...rows.map((row) => {
      const tr = document.createElement("tr");
      row.forEach((text) => { tr.insertCell().textContent = text; });
      return tr;
    }));
    $("reference").textContent = "Errors are the largest over the horizon, against " + reference +
      "; times are measured here, the best of five.";
    show();
  });
  addEventListener("keydown", (e) => {
    if (e.key !== " " || /^(BUTTON|SELECT|INPUT)$/.test(e.target.tagName)) return;
    e.preventDefault();
    play(!page.playing);
  });

  function preset(kind) {
    if (!kind) return;
    const p = code.principal(), size = Math.max(length(pick(page.start, places.w)), 1);
    let w = [0, 0, size];
    if (kind === "sleep") {
      const q = pick(scene, places.q), back = product([q[0], -q[1], -q[2], -q[3]], [1, 0, 0, 0]);
      const angle = 2*Math.atan2(Math.hypot(back[1], back[2], back[3]), back[0]);
      const axis = unit([back[1], back[2], back[3]]);
      ["x", "y", "z"].forEach((k, i) => controls["turn" + k].write(angle*axis[i]));
    } else if (p) {
      const k = Number(kind[0]) - 1, small = kind === "2s" ? 1e-6 : 0.02;
      w = added(scaled(size, p.axes[k]), scaled(small*size, p.axes[(k + 1) % 3]));
    }
    ["wx", "wy", "wz"].forEach((name, i) => controls[name].write(w[i]));
    page.t = 0;
    renew();
  }

  // ---- begin ----

  const given = readAddress();
  for (const [name, c] of Object.entries(controls)) if (Number.isFinite(Number(given[name] ?? NaN))) c.write(Number(given[name]));
  for (const id of ["first", "second", "what"]) if (given[id]) $(id).value = given[id];
  if (Number(given.h) > 0) $("step").value = given.h;
  if (Number(given.t) > 0) page.t = Number(given.t);
  $("about").textContent = (facts.effects.length ? facts.effects.join(", ") : "free") + "; " + (facts.exact ?
    "closed form: " + facts.closed : "no closed form: " + facts.closed) + "; " + facts.real + ".";
  for (const [css, text] of [["x", "x "], ["y", "y "], ["z", "z "]]) {
    const b = document.createElement("b");
    b.className = css;
    b.textContent = text;
    $("legend").append(b);
  }
  $("legend").append("axes of the body and their trails; red: ω; black or white: L. Drag to look around; arrows, + and −, 0.");
  if (space) orbit($("space"), space, show);
  $("space").addEventListener("webglcontextlost", (e) => {
    e.preventDefault();
    $("no-webgl").hidden = false;
  });
  $("space").addEventListener("webglcontextrestored", () => location.reload());
  renew();
  page.ready = performance.now();
  page.go = go;
  globalThis.polhode = page;
  if (!matchMedia("(prefers-reduced-motion: reduce)").matches && !("t" in given)) play(true);
}

start().catch((e) => { $("refused").textContent = "The page cannot start: " + e.message; });
