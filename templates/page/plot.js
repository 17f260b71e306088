// plot.js -- curves over time as SVG, with a mark at the time that is shown.  SPDX-License-Identifier: MIT-0

const SVG = "http://www.w3.org/2000/svg";

function element(name, attributes, text) {
  const e = document.createElementNS(SVG, name);
  for (const [k, v] of Object.entries(attributes)) e.setAttribute(k, v);
  if (text !== undefined) e.textContent = text;
  return e;
}

// Round numbers within the range, some n of them, three at least.
function ticks(low, high, n) {
  const raw = (high - low)/n, ten = Math.pow(10, Math.floor(Math.log10(raw)));
  const step = [1, 2, 5, 10].map((k) => k*ten).find((s) => s >= raw*0.999), out = [];
  for (let k = Math.ceil(low/step - 1e-9); k*step <= high + 1e-9*step; k++) out.push(k*step);
  return out.length < 3 && n < 16 ? ticks(low, high, 2*n) : out;
}

const shown = (x) => {
  const a = Math.abs(x);
  return (a !== 0 && (a < 1e-3 || a >= 1e5) ? x.toExponential(1).replace("e", "·10^") :
    String(Number(x.toPrecision(6)))).replace(/-/g, "−");
};

// A power of ten or of a unit as people write it: 1.5e-7, m/s^2.
const raised = (text) => [...String(Number(text))].map((c) => RAISED[c]).join("");
const times10 = (n) => " · 10" + raised(n);
const unitOf = (text) => text.replace(/\^(-?\d+)/g, (_, n) => raised(n));

// Ten digits, as many whatever the number, so that a column of them stands still.
function tenDigits(x) {
  const a = Math.abs(x), text = a !== 0 && a < 1e-3 ? x.toExponential(9) : x.toPrecision(10);
  return text.replace(/e([+-]\d+)$/, (_, n) => "·10" + raised(n)).replace("-", "−");
}

const NOISE = 1e-13; // of a value: what a closed form's roundings are; a curve of them has no scale of its own

const W = 420, H = 190, LEFT = 62, RIGHT = 34, TOP = 12, BOTTOM = 34;

// curves: [{name, css, values}] over the times; label: quantity over unit; noise: the part of a value that is rounding.
function drawCurves(svg, times, curves, label, title, noise = NOISE) {
  svg.replaceChildren(element("title", {}, title));
  svg.setAttribute("viewBox", "0 0 " + W + " " + H);
  let low = Infinity, high = -Infinity;
  for (const c of curves)
    for (const v of c.values) if (Number.isFinite(v)) {
      low = Math.min(low, v);
      high = Math.max(high, v);
    }
  if (!(low <= high)) [low, high] = [-1, 1];
  const size = Math.max(Math.abs(low), Math.abs(high)), flat = !(high - low > noise*size);
  const margin = flat ? size*0.1 || 1 : (high - low)*0.06;
  low -= margin;
  high += margin;
  const ten = size > 0 && (size < 1e-2 || size >= 1e5) ? Math.floor(Math.log10(size)) : 0; // for room at the axis
  const end = times[times.length - 1] || 1;
  const x = (t) => LEFT + (W - LEFT - RIGHT)*t/end, y = (v) => H - BOTTOM - (H - TOP - BOTTOM)*(v - low)/(high - low);
  for (const v of ticks(low, high, 4)) {
    svg.append(element("line", { class: "grid", x1: LEFT, x2: W - RIGHT, y1: y(v), y2: y(v) }));
    svg.append(element("text", { class: "end", x: LEFT - 5, y: y(v) + 4 }, shown(v/10**ten)));
  }
  for (const t of ticks(0, end, 5))
    svg.append(element("text", { class: "middle", x: x(t), y: H - BOTTOM + 16 }, shown(t)));
  svg.append(element("text", { class: "middle", x: (LEFT + W - RIGHT)/2, y: H - 4 }, "t / s"));
  const up = "translate(12 " + (TOP + H - BOTTOM)/2 + ") rotate(-90)";
  svg.append(element("text", { class: "middle", transform: up }, label + (ten ? times10(-ten) : "")));
  const ends = [];
  for (const c of curves) {
    let d = "", open = false;
    c.values.forEach((v, i) => {
      if (Number.isFinite(v)) d += (open ? "L" : "M") + x(times[i]).toFixed(2) + " " + y(v).toFixed(2);
      open = Number.isFinite(v);
    });
    svg.append(element("path", { class: "curve " + c.css, d }));
    const last = c.values[c.values.length - 1];
    if (Number.isFinite(last)) ends.push({ c, at: y(last) + 4 });
  }
  ends.sort((a, b) => a.at - b.at);
  for (let i = 1; i < ends.length; i++) ends[i].at = Math.max(ends[i].at, ends[i - 1].at + 12);
  for (const e of ends) svg.append(element("text", { class: "name " + e.c.css, x: W - RIGHT + 4, y: e.at }, e.c.name));
  // a layer of its own, as wide as the plot, with its line at the left: to move it paints nothing anew
  const mark = svg.nextElementSibling;
  return (t) => { mark.style.transform = "translateX(" + 100*x(Math.min(t, end))/W + "%)"; };
}

// The plots of a motion, with the reaction of a plane if there is one: returns what moves their marks to a time.
// real: the type of the code's numbers.  An energy that changes by roundings alone is drawn as the constant that it is.
function plotsOf(m, places, real) {
  const noise = real === "float" ? NOISE*2**29 : NOISE;
  const t = m.samples.map((s) => s.t), first = m.samples[0].energy;
  const curves = [0, 1, 2].map((k) => ({ name: "ω" + "xyz"[k], css: "xyz"[k],
    values: m.samples.map((s) => s.x[places.w[k]]) }));
  const rates = drawCurves($("rates"), t, curves, "ω / (rad/s)",
    "Angular velocity in body axes over time", noise);
  const spread = Math.max(...m.samples.map((s) => Math.abs(s.energy - first))), size = Math.abs(first);
  const drift = spread > noise*size && spread < 1e-3*size, ten = drift ? Math.floor(Math.log10(spread/size)) : 0;
  const energy = drawCurves($("energy"), t, [{ name: "E", css: "e", values: m.samples.map((s) =>
    drift ? (s.energy - first)/size/Math.pow(10, ten) : s.energy) }],
  drift ? "(E − E₀)/E₀" + (ten ? times10(-ten) : "") : "E / J",
  drift ? "Relative drift of the energy over time" : "Energy over time", noise);
  const touches = m.samples[0].touch, reaction = touches && drawCurves($("reaction"), t, [{ name: "N", css: "e",
    values: m.samples.map((s) => s.touch.N) }], "N / N", "Normal force of the plane over time");
  return (time) => {
    rates(time);
    energy(time);
    if (reaction) reaction(time);
  };
}
