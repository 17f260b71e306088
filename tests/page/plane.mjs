// plane.mjs -- pages of bodies on a plane, in Chromium: the contact point, the height, the normal force, the pictures.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The oracle of N and of the contact point is `polhode run`, whose engine is the general library: it differentiates the
// surface by the chain rule, and the page asks the emitted C for velocities.  The rest are textbook motions.

import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { launch } from "./browser.mjs";
import { done, ok } from "./tap.mjs";

// the library's default against the emitted Taylor series of order 20 at fixed steps: each is far better than this
const CLOSE = 1e-9;

const dir = mkdtempSync(join(tmpdir(), "polhode-plane-"));
const polhode = (...words) => execFileSync("build/polhode", words, { stdio: ["ignore", "pipe", "pipe"] }).toString();
const made = (name, ...words) => {
  const file = join(dir, [name.replace(/\W/g, ""), ...words].join("") + ".html");
  polhode("view", name, "-o", file, ...words);
  return "file://" + file;
};
const own = (said) => said.filter((s) => !/GPU stall due to ReadPixels/.test(s));
const frames = "new Promise((r) => requestAnimationFrame(() => requestAnimationFrame(r)))";
const set = (id, value) => `(() => { const e = document.getElementById("${id}"); e.value = ${value};
  e.dispatchEvent(new Event("input")); e.dispatchEvent(new Event("change")); return ${frames}; })()`;
// Shares of the canvas that have the plane's blue, as it is over white paper, and the path's purple, both for a body
// that is as grey as it is; a sum of all bytes.
const PICTURE = `(() => { const c = document.getElementById("space"), d = document.createElement("canvas");
  d.width = c.width; d.height = c.height; const x = d.getContext("2d"); x.drawImage(c, 0, 0);
  const p = x.getImageData(0, 0, c.width, c.height).data; let blue = 0, purple = 0, grey = 0, sum = 0;
  for (let i = 0; i < p.length; i += 4) {
    const [r, g, b] = [p[i], p[i + 1], p[i + 2]];
    sum = (31*sum + 65536*r + 256*g + b) >>> 0;
    if (b - r > 20 && r > 150) blue++;
    else if (r - g > 60 && b - g > 15) purple++;
    else if (Math.abs(r - b) < 40 && Math.abs(g - r) < 25 && r < 185) grey++;
  }
  const n = p.length/4;
  return { blue: blue/n, purple: purple/n, grey: grey/n, sum }; })()`;
// The least height of the drawn corners over the plane, in parts of the body's size.
const LOWEST = `(() => { const b = polhode.body, t = polhode.touch, q = polhode.places.q.map((i) => polhode.state[i]);
  let low = Infinity;
  for (let i = 0; i < b.faces.length; i += 6)
    low = Math.min(low, dot(t.n, added(t.com, turned(q, Array.from(b.faces.subarray(i, i + 3))))));
  return low/b.size; })()`;

const browser = await launch();
const near = (a, b, size) => a.every((v, i) => Math.abs(v - b[i]) <= CLOSE*size);

// name, time, size of a length, how far the drawn surface may be from the plane, in parts of the size: a sphere's and
// an ellipsoid's corners are on it, and of 40 segments a turn the sagitta is 1 - cos(pi/40) = 0.003; a coin's edge is
// round and drawn sharp, so that it is too low by (sqrt(2) - 1) thick/2, at most 0.04 of its radius
for (const [name, t, size, off, ...words] of [
  ["tippe_top", 1.2, 0.015, 0.0045, "--method", "taylor"], ["rattleback", 0.6, 0.2, 0.0045, "--method", "taylor"],
  ["rolling_coin", 1.2, 0.0122, 0.04, "--method", "taylor"], ["turntable_ball", 4, 0.6, 0.0045, "--trajectory"],
]) {
  const page = await browser.open(made(name, ...words) + "#t=" + t);
  ok(own(page.said).length === 0 && page.asked.length === 1, `${name}: it opens offline, without a word`,
    own(page.said).join("\n"));
  const touch = await page.run("polhode.touch"), at = await page.run(
    words[0] === "--trajectory" ? "polhode.motion.end*Math.floor(polhode.t/polhode.motion.end*" +
      "(polhode.facts.recorded.count - 1) + 1e-9)/(polhode.facts.recorded.count - 1)" : "polhode.t");
  const row = polhode("run", name, "--at", String(at), "--columns", "N,com,contact_point").split("\n")[1].split(",")
    .map(Number);
  ok(Math.abs(touch.N/row[0] - 1) < CLOSE && near(touch.com, row.slice(1, 4), size) &&
    near(touch.point, row.slice(4, 7), size), `${name}: N and the contact point are those of polhode run`,
  JSON.stringify(touch) + "\n" + row);
  const low = await page.run(LOWEST);
  ok(Math.abs(low) < off, `${name}: the drawn body stands on the plane`, low);
  const shown = await page.run(`[...document.querySelectorAll("#values tr")].map((r) => r.textContent).join(" ")`);
  ok(shown.includes("N / N" + touch.N.toPrecision(10)), `${name}: N is among the numbers`, shown);
  const plot = await page.run(`[document.getElementById("pressed").hidden,
    document.querySelector("#reaction path.curve").getAttribute("d").length]`);
  ok(plot[0] === false && plot[1] > 3000, `${name}: and has a plot`, plot);
  const near_by = await page.run(PICTURE);
  ok(near_by.blue > 0.15 && near_by.purple > 0.00005 && near_by.grey > 0.012, `${name}: plane, path and body are drawn`,
    JSON.stringify(near_by));
  await page.run(set("what", "'path'"));
  const whole = await page.run(PICTURE);
  ok(whole.sum !== near_by.sum && whole.blue > 0.3 && whole.grey > 0.0002, `${name}: so is the whole path`,
    JSON.stringify(whole));
}

// ---- a homogeneous ball on a turntable: its circle has the radius |V0|/(2/7 Omega), and N is its weight ----
{
  const page = await browser.open(made("turntable_ball"));
  const about = await page.run(`document.getElementById("about").textContent`);
  ok(/no closed form: the one that there is gives the centre of mass and the spin only/.test(about), "it says why there is no closed form",
    about);
  const samples = await page.run("polhode.motion.samples.map((s) => [s.touch.N, ...s.touch.point])");
  const turn = 33*2*Math.PI/60, V = [0.02*5, turn*0.1], rate = 2/7*turn;
  const middle = [0.1 - V[1]/rate, V[0]/rate], radius = Math.hypot(...V)/rate;
  // rk4 with 5000 steps of 0.002 s at rates of up to 90 rad/s: 0.18 rad a step, errors of 1e-4 in the place
  const worst = Math.max(...samples.map((s) => Math.abs(Math.hypot(s[1] - middle[0], s[2] - middle[1])/radius - 1)));
  ok(worst < 2e-4, "turntable: the path is the textbook's circle", worst);
  const weight = Math.max(...samples.map((s) => Math.abs(s[0]/(0.26*9.80665) - 1)));
  // N is m times gravity along the normal in body axes, whose length is |q|^2: rk4 keeps it to 1e-7 at 0.18 rad a step
  ok(weight < 1e-7, "turntable: N is the weight", weight);
  await page.run(set("s-p-r", 0.03));
  ok(Math.abs(await page.run("polhode.touch.com[2]") - 0.03) < 1e-12 && Math.abs(await page.run(LOWEST)) < 0.0045,
    "turntable: a larger ball stands higher, on the plane");
}

// ---- contact is lost: a ball with its mass off the middle goes over the top; tests/plot/touch.t has the time ----
{
  const file = join(dir, "hop.lua");
  writeFileSync(file, `return scene { name = "hop",
    body = tensor { mass = 1, xx = 0.001, yy = 0.001, zz = 0.001 },
    effects = { effect.plane { surface = contact.sphere { r = 0.1, at = { 0, 0, 0.05 } }, law = "smooth",
      gravity = 9.81 } },
    initial = { omega = { 60, 0, 0 } }, time = { horizon = 2, step = 0.0005 } }`);
  const page = await browser.open(made(file));
  const note = await page.run(`document.getElementById("note").textContent`);
  const [from, to] = [...note.matchAll(/t = ([\d.]+) s|and ([\d.]+) s/g)].map((m) => Number(m[1] || m[2]));
  ok(/^Contact is lost between/.test(note) && from <= 0.0514558 && to >= 0.0514557 && to - from < 0.0035,
    "where contact is lost the motion ends, and the page says so", note);
  ok(await page.run("polhode.motion.samples.every((s) => s.touch.N > 0)"), "what is left has a positive N");
}
// ---- a tilted plane: Galilei's ball, 5/7 g sin(a) t^2/2 down, pressed on with m g cos(a), a = 45 degrees ----
{
  const file = join(dir, "slope.lua");
  writeFileSync(file, `return scene { name = "slope", body = solid.sphere { r = 0.1, mass = 1 },
    effects = { effect.plane { surface = contact.sphere { r = 0.1 }, normal = { 0, -1, 1 } } },
    initial = { omega = { 0, 0, 0 } }, time = { horizon = 1, step = 0.001 } }`);
  const page = await browser.open(made(file) + "#t=1");
  const touch = await page.run("polhode.touch"), far = 5/7*9.80665*Math.SQRT1_2/2;
  // rk4 turns the ball by 25 rad in steps of at most 0.05 rad; that changes its place by less than 1e-8 of it
  ok(Math.abs(Math.hypot(...touch.point)/far - 1) < 1e-8 && touch.point[1] < 0 && touch.point[2] < 0,
    "the contact point goes down a tilted plane as Galilei has it", JSON.stringify(touch) + " " + far);
  ok(Math.abs(touch.N/(9.80665*Math.SQRT1_2) - 1) < 1e-8, "pressed on by its share of the weight", touch.N);
  ok(Math.abs(await page.run(LOWEST)) < 0.0045, "and the body stands on it");
  const picture = await page.run(PICTURE);
  ok(picture.blue > 0.05 && picture.grey > 0.02, "which is drawn", JSON.stringify(picture));
}
await browser.close();
rmSync(dir, { recursive: true, force: true });
done();
