// controls.js -- sliders and numbers with labels and units, and the state of the page in its address.
// SPDX-License-Identifier: MIT-0

const $ = (id) => document.getElementById(id);

// A slider; returns {read, write}.  value in SI; factor: SI units in one shown unit.
function slider(box, name, text, unitText, low, high, value, factor, changed) {
  const label = document.createElement("label"), input = document.createElement("input");
  const output = document.createElement("output"), title = document.createElement("span");
  const show = () => {
    output.textContent = shown(Number(input.value)) + (unitText ? "\u00a0" + unitText : "");
    input.setAttribute("aria-valuetext", output.textContent);
  };
  title.textContent = text;
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
  return { read: () => own, first: value, write: (x) => {
    own = x;
    if (x/factor < input.min) input.min = x/factor;
    if (x/factor > input.max) input.max = x/factor;
    input.value = x/factor;
    show();
  } };
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

// The camera: dragging, and arrows, + and - when the canvas has the focus.
function orbit(canvas, space, draw) {
  let from = null;
  const limit = () => {
    space.height = Math.max(-1.5, Math.min(1.5, space.height));
    space.far = Math.max(1.5, Math.min(12, space.far));
    draw();
  };
  canvas.addEventListener("pointerdown", (e) => {
    from = [e.clientX, e.clientY];
    canvas.setPointerCapture(e.pointerId);
  });
  canvas.addEventListener("pointermove", (e) => {
    if (!from) return;
    space.turn -= (e.clientX - from[0])*0.008;
    space.height += (e.clientY - from[1])*0.008;
    from = [e.clientX, e.clientY];
    limit();
  });
  canvas.addEventListener("pointerup", () => { from = null; });
  canvas.addEventListener("keydown", (e) => {
    const turn = { ArrowLeft: -0.1, ArrowRight: 0.1 }[e.key], up = { ArrowUp: 0.1, ArrowDown: -0.1 }[e.key];
    if (turn) space.turn += turn;
    else if (up) space.height += up;
    else if (e.key === "+") space.far /= 1.1;
    else if (e.key === "-") space.far *= 1.1;
    else if (e.key === "0") Object.assign(space, { turn: 0.6, height: 0.35, far: 3.6 });
    else return;
    e.preventDefault();
    limit();
  });
}
