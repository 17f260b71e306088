// controls.js -- sliders and numbers with labels and units, and the state of the page in its address.
// SPDX-License-Identifier: MIT-0

const $ = (id) => document.getElementById(id);

// A slider; returns {read, write, follow, first}.  value in SI; factor: SI units in one shown unit.
// follow: the scene's own value is another now, and so is the slider's unless someone has moved it.
function slider(box, name, text, unitText, low, high, value, factor, changed) {
  const label = document.createElement("label"), input = document.createElement("input");
  const output = document.createElement("output"), title = document.createElement("span");
  const show = () => {
    output.textContent = shown(Number(input.value)) + (unitText ? "\u00a0" + unitOf(unitText) : "");
    input.setAttribute("aria-valuetext", output.textContent);
  };
  const [stem, below] = text.split("_", 2); // m_b as people write it
  title.textContent = below && stem ? stem : text;
  if (below && stem) {
    const low = document.createElement("sub");
    low.textContent = text.slice(stem.length + 1);
    title.append(low);
  }
  input.type = "range";
  input.id = "s-" + name;
  input.min = low/factor;
  input.max = high/factor;
  input.step = "any";
  input.value = value/factor;
  let own = value;
  input.addEventListener("input", () => {
    own = Number(input.value)*factor;
    show();
    changed();
  });
  input.addEventListener("keydown", (e) => { // step "any" moves by too much or too little
    const way = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1 }[e.key];
    if (!way) return;
    e.preventDefault();
    input.value = Number(input.value) + way*(input.max - input.min)/200;
    input.dispatchEvent(new Event("input"));
  });
  label.append(title, input, output);
  box.append(label);
  show();
  const control = { first: value, read: () => own };
  control.write = (x) => {
    own = x;
    if (x/factor < input.min) input.min = x/factor;
    if (x/factor > input.max) input.max = x/factor;
    input.value = x/factor;
    show();
  };
  control.follow = (x) => {
    const moved = own !== control.first;
    control.first = x;
    if (!moved && x !== own) control.write(x);
  };
  return control;
}

// Names and values of the fragment: #a=0.2&t=1.5
function readAddress() {
  const out = {};
  for (const part of location.hash.slice(1).split("&")) {
    const [name, value] = part.split("=");
    if (value !== undefined) out[decodeURIComponent(name)] = decodeURIComponent(value);
  }
  return out;
}

function writeAddress(values) {
  const text = Object.entries(values).map(([k, v]) => encodeURIComponent(k) + "=" + encodeURIComponent(v)).join("&");
  history.replaceState(null, "", "#" + text);
}

// Sliders for all that can be changed: {name: {read, write, first}}.  own: parameters, SI; scene: the initial state.
function controlsOf(facts, places, own, scene, changed) {
  const controls = {}, most = 1.5*Math.max(1, length(places.w.map((i) => scene[i])));
  facts.params.forEach((p, i) => {
    controls["p." + p.name] = slider($("parameters"), "p-" + p.name, p.name, p.unit, p.low, p.high, own[i], p.factor,
      changed);
  });
  ["wx", "wy", "wz"].forEach((name, k) => {
    controls[name] = slider($("rates0"), name, "ω" + "xyz"[k], "rad/s", -most, most, scene[places.w[k]], 1, changed);
    controls["turn" + "xyz"[k]] = slider($("turn0"), "turn-" + "xyz"[k], "xyz"[k], "°", -Math.PI, Math.PI, 0,
      Math.PI/180, changed);
  });
  facts.inputs.forEach((u) => {
    controls["u." + u.name] = slider($("inputs"), "u-" + u.name, u.name, u.unit, u.low ?? -u.factor, u.high ?? u.factor,
      0, u.factor, changed);
  });
  return controls;
}
