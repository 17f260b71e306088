// start.js -- the page: reads what the generator put in, computes the motion anew after each change, and plays it.
// SPDX-License-Identifier: MIT-0
//
// Time that passes is time of the motion: a frame shows the state of its moment, however late it comes.

const TEXT_EVERY = 100; // ms: numbers that change faster cannot be read, and each change costs a layout
const TOUCHING = 1e-12; // of the body's size: what is so near to 0 is a rounding of the contact point's place
const TOLD = 6, WORDS = { impact: "impact", landing: "comes to stay on the plane", lift_off: "leaves the plane" };

async function start() {
  const facts = JSON.parse($("facts").textContent), drawing = JSON.parse($("shape").textContent);
  const live = !facts.recorded;
  const bytes = (id) => bytesOf($(id).textContent.trim());
  let code = live ? await codeOf(bytes("code"), facts) : recordedOf(facts);
  if (facts.ground) code = phasesOf(code, await codeOf(bytes("ground"), { ...facts, states: facts.ground.states }), facts);
  const own = Array.from(code.params.subarray(0, facts.params.length)), places = { q: [], w: [] };
  facts.states.forEach((s, i) => {
    if (s.kind === "attitude") places.q.push(i);
    if (s.kind === "rates") places.w.push(i);
  });
  const page = { facts, code, places, t: 0, told: 0, playing: false, motion: null, other: null, until: facts.horizon };
  let space = null;
  try {
    space = spaceOf($("space"), facts);
  } catch (e) {
    $("note").textContent = e.message;
  }
  $("no-webgl").hidden = space !== null;
  $("space").hidden = space === null;

  code.init();
  code.initial(SLOT.spare);
  let scene = Array.from(code.states[SLOT.spare]); // the initial state that the parameters give
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
  const controls = live ? controlsOf(facts, places, own, scene, changed) : {};
  if (!live) $("how").textContent = "The motion was computed before, by polhode's general library.";
  $("pressed").hidden = !facts.plane;
  if (!facts.plane) $("what").querySelector("[value=path]").remove();
  for (const e of [$("controls"), $("accuracy"), $("drag").parentNode]) e.hidden = !live;
  const choose = (select, list) => list.forEach(([value, text]) => select.add(new Option(text, value)));
  const names = facts.methods.map((m, i) => [String(i), m.name]);
  if (facts.exact) names.unshift(["exact", live ? "closed form" : facts.recorded.method]);
  choose($("first"), names);
  choose($("second"), [["none", "nothing"], ...names]);
  const offered = presetsOf(facts, code.principal());
  choose($("preset"), offered);
  $("preset").parentNode.hidden = offered.length === 1;
  const step = live ? facts.step : facts.horizon/(facts.recorded.count - 1);
  $("step").value = step;
  const stepOf = () => Number($("step").value) > 0 ? Number($("step").value) : step;
  const choiceOf = (id) => {
    const v = $(id).value;
    return v === "none" ? null : { method: v === "exact" ? v : Number(v), h: stepOf() };
  };

  // ---- the motion ----

  const turnNow = () => ["x", "y", "z"].map((k) => controls["turn" + k].read());
  const ratesNow = () => ["wx", "wy", "wz"].map((k) => controls[k].read());

  function initial() {
    code.initial(SLOT.spare);
    const x = Array.from(code.states[SLOT.spare]);
    if (!live) return x;
    scene = x.slice();
    ["wx", "wy", "wz"].forEach((name, k) => controls[name].follow(x[places.w[k]]));
    const q = places.q.map((i) => x[i]), turn = turnNow();
    ratesNow().forEach((v, k) => { x[places.w[k]] = v; });
    if (length(turn) > 0) product(q, rotationOf(turn)).forEach((c, k) => { x[places.q[k]] = c; });
    return x;
  }

  function refuse(text) {
    $("refused").textContent = text;
  }

  function renew() {
    const values = live ? facts.params.map((p) => controls["p." + p.name].read()) : own;
    const before = Array.from(code.params);
    code.params.set(values);
    facts.inputs.forEach((u, i) => { code.inputs[i] = controls["u." + u.name].read(); });
    const status = code.init();
    if (status !== 0) {
      code.params.set(before);
      refuse("No such body: " + (facts.checks[status - 1] || "check " + status) + ". The last body stays.");
      return;
    }
    const x = initial(), count = samplesOf(pick(x, places.w), page.until);
    const made = motionOf(code, SLOT.first, x, choiceOf("first"), page.until, count);
    if (!made && facts.ground) return refuse("The body begins below the plane.");
    if (!made) return refuse("The closed form refuses this state: the attitude or a rate is out of range.");
    if (facts.plane && facts.plane.disc && live) keepUpright(made, places, facts);
    if (!keepContact(made, facts.plane))
      return refuse("The plane does not carry the body here: it pulls it, or they touch in more than one point.");
    const bad = made.samples.find((s) => !s.sound);
    refuse(bad ? "The numbers become infinite at t = " + shown(bad.t) + " s: a smaller step helps." : "");
    page.motion = made;
    const second = choiceOf("second");
    page.other = second && motionOf(code, SLOT.second, x, second, page.until);
    if (page.start && x.some((v, i) => v !== page.start[i])) page.t = 0; // it begins otherwise, so it begins anew
    page.start = x;
    constructions(made);
    page.body = bodyOf(drawing, values, own, code);
    if (space) {
      space.body(page.body);
      space.motion(made, places, page.poinsot, page.cones);
    }
    page.mark = plotsOf(made, places, facts.real);
    fillFormulas(code.inertia());
    $("time").max = made.end;
    $("note").textContent = noteOf(made);
    show();
    if (!page.playing) address();
  }

  // What is to be known of a motion that was made.
  function noteOf(made) {
    if (made.lost) {
      return "Contact is lost between t = " + shown(made.end) + " s and " + shown(made.lost) +
        " s, where the plane would have to pull: the motion ends there.";
    }
    if (made.events.length > 0) {
      const told = made.events.slice(0, TOLD).map((e) => WORDS[e.name] + " " + shown(e.t)).join(", ");
      const rest = made.events.length - TOLD, end = made.events[made.events.length - 1];
      return "At t / s: " + told + (rest > 0 ? ", .. " + WORDS[end.name] + " " + shown(end.t) + " (" +
        made.events.length + " in all)" : "") + ".";
    }
    if (made.cut) return "Only " + MOST_STEPS + " steps are computed: t ends early.";
    if (made.flat) return made.flat + " at t = " + shown(made.end) + " s: the motion ends there.";
    if (!live && facts.recorded.ended) return facts.recorded.ended + " at t = " + shown(made.end) + " s.";
    if (!live) return "A computed motion of " + facts.recorded.count + " rows: nothing can be changed in this page.";
    if (drawing.fixed) return "The picture keeps the shape of the scene's own parameters.";
    return facts.plane && page.body.ellipsoid ?
      "The picture has the ellipsoid of the same moments, not the surface that touches." : "";
  }

  // What rolls on what, or in the menu why it does not.
  function constructions(made) {
    const p = poinsotOf(code, made, places), cones = conesOf(code, made, places, facts.kind, p);
    page.poinsot = p.refused ? null : p;
    page.cones = cones.refused ? null : cones;
    [["Poinsot's ellipsoid", p], ["cones of a symmetric top", cones]].forEach(([name, c], k) => {
      const option = $("what").options[k + 1];
      option.disabled = Boolean(c.refused);
      option.textContent = name + (c.refused ? " (not here: " + c.refused + ")" : "");
      if (c.refused && $("what").value === option.value) $("what").value = "body";
    });
  }

  // ---- one moment ----

  const pick = (x, list) => list.map((i) => x[i]);

  function show() {
    const m = page.motion;
    if (!m) return;
    page.t = Math.max(0, Math.min(page.t, m.end));
    const x = stateAt(code, m, page.t), L = code.momentum(m.slot), E = code.energy(m.slot);
    const y = page.other && stateAt(code, page.other, page.t);
    const touch = code.touch ? code.touch(m.slot, m.exact || !live ? page.t : Math.floor(page.t/m.choice.h + 1e-9)*
      m.choice.h) : null;
    page.touch = touch;
    page.state = x;
    page.mark(page.t);
    const now = performance.now();
    if (!page.playing || now - page.told > TEXT_EVERY) {
      page.told = now;
      tell(x, E, length(L), y, touch);
    }
    if (space && !space.lost()) space.draw($("what").value, { q: pick(x, places.q), w: pick(x, places.w), L,
      index: Math.floor((m.samples.length - 1)*page.t/(m.end || 1)), second: y && pick(y, places.q), touch,
      other: y && touch ? code.touch(page.other.slot, page.t) : null }, dark.matches);
  }

  // The same in words and numbers.
  function tell(x, E, size, y, touch) {
    $("time").value = page.t;
    $("now").textContent = page.t.toFixed(3).replace("-", "−") + "\u00a0s";
    $("time").setAttribute("aria-valuetext", page.t.toFixed(2) + " s");
    const rows = facts.states.map((s, i) => [s.name, x[i]]).concat([["E / J", E], ["|L| / (N m s)", size]],
      touch ? [["N / N", touch.N], ...touch.point.map((v, k) => ["contact " + "xyz"[k] + " / m",
        Math.abs(v) < TOUCHING*page.body.size ? 0 : v])] : []);
    const body = $("values").tBodies[0];
    rows.forEach(([name, v], i) => {
      const row = body.rows[i] || body.insertRow();
      if (!row.cells.length) {
        row.append(document.createElement("th"), document.createElement("td"));
        row.cells[0].scope = "row";
        row.cells[0].textContent = name;
      }
      row.cells[1].textContent = tenDigits(v);
    });
    const apart = y && sayError(between(pick(x, places.q), pick(y, places.q)));
    $("difference").textContent = y ? "Difference of the two at this time: " + apart +
      " rad; the second body is drawn through the first." : "";
    $("space").setAttribute("aria-label", "The body in space at t = " + page.t.toFixed(1) + " s");
  }

  function address() {
    const out = {};
    for (const [name, c] of Object.entries(controls)) if (c.read() !== c.first) out[name] = c.read();
    if ($("first").selectedIndex > 0) out.first = $("first").value;
    if ($("second").selectedIndex > 0) out.second = $("second").value;
    if (stepOf() !== step) out.h = stepOf();
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

  const writeRates = (w) => ["wx", "wy", "wz"].forEach((name, k) => controls[name].write(w[k]));
  const writeTurn = (v) => ["x", "y", "z"].forEach((k, i) => controls["turn" + k].write(v[i]));

  function preset(kind) {
    if (!kind) return;
    const size = Math.max(length(pick(page.start, places.w)), 1);
    if (facts.weight) { // its numbers are those of the scene's own parameters
      for (const p of facts.params) controls["p." + p.name].write(controls["p." + p.name].first);
      renew();
    }
    const to = presetOf(kind, facts, code.principal(), pick(scene, places.q), size, code.mass().com);
    writeRates(to.w);
    writeTurn(to.turn);
    page.t = 0;
    renew();
  }

  // A drag acts on the beginning of the motion, so the time goes back there.
  function dragged(way, dx, dy) {
    play(false);
    page.t = 0;
    if (way === "attitude") writeTurn(draggedTurn(space, pick(scene, places.q), turnNow(), dx, dy));
    else writeRates(draggedRates(space, pick(page.start, places.q), ratesNow(), rateStep, dx, dy));
    changed();
  }
  const rateStep = Math.max(1, length(pick(scene, places.w)))/150;

  // ---- begin ----

  const given = readAddress();
  for (const [name, c] of Object.entries(controls))
    if (Number.isFinite(Number(given[name] ?? NaN))) c.write(Number(given[name]));
  for (const id of ["first", "second", "what"]) if (given[id]) $(id).value = given[id];
  if (Number(given.h) > 0) $("step").value = given.h;
  if (Number(given.t) > 0) page.t = Number(given.t);
  const acts = facts.effects.map((e) => e.replace("effect.", "")).join(", ") || "free";
  $("about").textContent = acts + "; " + (!live ?
    "computed before, by " + facts.recorded.method : facts.exact ? "closed form: " + facts.closed :
      "no closed form: " + facts.closed) + "; " + facts.real + ".";
  for (const [css, text] of [["x", "x "], ["y", "y "], ["z", "z "]]) {
    const b = document.createElement("b");
    b.className = css;
    b.textContent = text;
    $("legend").append(b);
  }
  $("legend").append("axes of the body and their trails; red: ω; black or white: L" + (facts.plane ?
    "; purple: path of the contact point" : "") + ". Keys: arrows, + and −, 0.");
  if (space) orbit($("space"), space, show, () => live ? $("drag").value : "camera", dragged);
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
