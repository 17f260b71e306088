// lecture.mjs -- what a lecturer does with a page: sliders of what only `initial` reads, their ends, presets that suit
// the body and do what they say, and a picture with nothing cut off.  SPDX-License-Identifier: GPL-3.0-or-later
//
// The oracle of a state is `polhode run`; of a preset, what its words say, seen in the motion's samples.

import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { launch } from "./browser.mjs";
import { done, ok } from "./tap.mjs";

const dir = mkdtempSync(join(tmpdir(), "polhode-lecture-")), browser = await launch();
const polhode = (...words) => execFileSync("build/polhode", words, { stdio: ["ignore", "pipe", "ignore"] }).toString();
const scene = (name, text) => {
  const file = join(dir, name + ".lua");
  writeFileSync(file, text);
  return file;
};
const opened = (name, hash = "") => {
  const file = join(dir, name.replace(/^.*\/|\.lua$/g, "") + ".html");
  polhode("view", name, "-o", file);
  return browser.open("file://" + file + hash);
};
// A page behind another one draws no frames.
const front = (p) => p.send("Page.bringToFront");
const frames = "new Promise((r) => requestAnimationFrame(() => requestAnimationFrame(r)))";
const set = (id, value) => `(() => { const e = document.getElementById("${id}"); e.value = ${JSON.stringify(value)};
  e.dispatchEvent(new Event("input")); e.dispatchEvent(new Event("change")); return ${frames}; })()`;
const offered = `[...document.getElementById("preset").options].map((o) => o.value).filter(Boolean)`;
const refused = `document.getElementById("refused").textContent`;

const PLATE = `local a, b, c, M = param("a", 30, "cm"), param("b", 15, "cm"), param("c", 2, "cm"), param("M", 0.5, "kg")
local W, e = param("W", 10, "rad/s"), param("eps", 0.001, "rad/s")
return scene { name = "plate", body = solid.box { x = a, y = b, z = c, mass = M }, initial = { omega = { e, W, e } },
  time = { horizon = 4 } }`;
const TOP = `local r, h, s = param("r", 3, "cm"), param("h", 6, "cm"), param("s", 150, "rad/s")
local theta = param("theta", 1, "deg")
return scene { name = "top", origin = { 0, 0, 0 }, effects = { effect.gravity { g = 9.81 } }, time = { horizon = 3 },
  body = solid.cone { r = r, h = h, mass = 0.1 }:turned { axis = "x", angle = pi }:at { 0, 0, h },
  initial = { omega = { 0, 0, s }, attitude = { axis = "x", angle = theta } } }`;
const plate = scene("plate", PLATE), top = scene("top", TOP);
const DISC = scene("disc", `local R, w3 = param("R", 12, "cm"), param("w3", 20, "rad/s")
return scene { name = "disc", body = plate.disc { r = R, mass = 0.4 }, initial = { omega = { 0.5, 0, w3 } },
  time = { horizon = 2 } }`);
const BALL = scene("ball", `return scene { name = "ball", body = solid.sphere { r = 0.1, mass = 1 },
  initial = { omega = { 1, 2, 3 } } }`);

// ---- a parameter that only `initial` reads ----

const page = await opened(plate, "#t=2");
ok(await page.run("polhode.t") === 2, "the address says when");
await page.run(set("s-p-W", 14));
let start = await page.run("polhode.start");
ok(start[5] === 14 && start[4] === 0.001, "the slider of W changes the initial rate", start);
ok(await page.run("polhode.t") === 0, "and the motion begins anew");
const [w, hash] = await page.run(`[document.getElementById("s-wy").value, location.hash]`);
ok(Number(w) === 14 && /p\.W=14/.test(hash) && !/wy/.test(hash), "the slider of the rate goes with it", w + " " + hash);
await page.run(set("time", 1.5));
const row = polhode("run", plate, "--set", "W=14", "--at", "1.5").split("\n")[1].split(",").map(Number).slice(1, 8);
const state = await page.run("polhode.state");
ok(Math.max(...state.map((v, i) => Math.abs(v - row[i])/(i < 4 ? 1 : 14))) < 1e-10,
  "so is the motion that of `polhode run --set W=14`", state + "\n" + row);
await page.run(set("s-wx", 3));
await page.run(set("s-p-eps", 0.002));
start = await page.run("polhode.start");
ok(start[4] === 3 && start[6] === 0.002, "a rate that someone has set stays as it is", start);
await page.run(`document.getElementById("reset").click()`);
start = await page.run("polhode.start");
ok(start[4] === 0.001 && start[5] === 10, "and comes back with the scene's own", start);
const spinning = await opened(top);
await spinning.run(set("s-p-theta", 60));
const tilt = await spinning.run("polhode.start.slice(0, 2)");
ok(Math.abs(2*Math.atan2(tilt[1], tilt[0]) - Math.PI/3) < 1e-12, "a parameter of the attitude turns the body", tilt);

// ---- the ends of sliders ----

const TIGHT = scene("tight", `local a, b, d = param("a", 0.30, "m"), param("b", 0.25, "m"), param("d", 0.02, "m")
return scene { name = "tight", body = solid.box { x = a, y = b, z = a - b, mass = 1 } +
  solid.sphere { r = 0.01, mass = 0.1 }:at { d, 0, 0 }, initial = { omega = { 1, 2, 3 } },
  ranges = { d = { 0.01, 0.05 } } }`);
for (const [name, p] of [["plate", page], ["top", spinning], ["tight", await opened(TIGHT)],
  ["gyroscope", await opened("gyroscope")], ["egg", await opened("egg")]]) {
  const sliders = await p.run(`[...document.querySelectorAll("#parameters input")].map((e) =>
    [e.id, Number(e.min), Number(e.value), Number(e.max)])`);
  const wrong = [];
  await front(p);
  await p.run(`document.getElementById("reset").click()`);
  for (const [id, low, , high] of sliders)
    for (const end of [low, high]) {
      await p.run(set(id, end));
      const why = await p.run(refused);
      if (/No such body/.test(why) || !(low < high)) wrong.push(id + " " + end + ": " + why);
      await p.run(`document.getElementById("reset").click()`);
    }
  ok(sliders.length > 0 && wrong.length === 0, `${name}: there is a body at both ends of every slider`, wrong.join("\n"));
  if (name === "tight") {
    const [, b, d] = sliders;
    ok(b[1] > 0 && b[3] < 0.3 && b[3] > 0.29, "a slider ends just before the body does", b);
    ok(d[1] === 0.01 && d[3] === 0.05, "and where the scene's ranges say", d);
  }
}

// ---- presets ----

const lists = {};
for (const [name, p] of [["plate", page], ["top", spinning], ["disc", await opened(DISC)], ["ball", await opened(BALL)],
  ["rolling_coin", await opened("rolling_coin")], ["compass", await opened("compass")]]) {
  lists[name] = (await p.run(offered)).join(" ");
  if (name !== "ball") continue;
  ok(await p.run(`document.getElementById("preset").parentNode.hidden`), "an empty list is not shown");
}
const wanted = { plate: "1 2 2s 3", top: "sleep weak fall", disc: "axial across", ball: "", rolling_coin: "",
  compass: "compass" };
for (const [name, keys] of Object.entries(wanted))
  ok(lists[name] === keys, `${name}: the presets are those of such a body`, lists[name]);

// How often the rate along principal axis k changes its sign.
const turns = (k) => `(() => { const a = polhode.code.principal().axes[${k}];
  const s = polhode.motion.samples.map((m) => Math.sign(dot(a, polhode.places.w.map((i) => m.x[i]))));
  return s.filter((v, i) => i > 0 && v !== s[i - 1]).length; })()`;
await front(page);
for (const [key, k, flips] of [["1", 0, false], ["2", 1, true], ["2s", 1, true], ["3", 2, false]]) {
  await page.run(set("preset", key));
  const n = await page.run(turns(k));
  const text = await page.run(`document.getElementById("preset").selectedOptions[0].text`);
  ok(n > 0 === flips && /flips/.test(text) === flips, `"${text}" is what happens`, n);
}
// cosine of the tilt of the body's z, least and greatest
const heights = `(() => {
  const u = polhode.motion.samples.map((m) => turned(polhode.places.q.map((i) => m.x[i]), [0, 0, 1])[2]);
  return [Math.min(...u), Math.max(...u)]; })()`;
await front(spinning);
await spinning.run(set("s-p-h", 12)); // which asks for more spin: a preset is the scene's own body's
await spinning.run(set("preset", "sleep"));
// I1, I3 of a cone about its tip, 3 m (4 h² + r²)/20 and 3 m r²/10, and l = 3 h/4: 2 sqrt(I1 m g l)/I3
const least = 2*Math.sqrt(3*0.1*(4*0.06**2 + 0.03**2)/20*0.1*9.81*0.045)/(3*0.1*0.03**2/10);
start = await spinning.run("polhode.start");
ok(Math.abs(start[6]/least - 1.25) < 1e-9, "the sleeping top spins a quarter above the least spin", start + " " + least);
let [low, high] = await spinning.run(heights);
ok(low > 1 - 1e-9, "and sleeps", low);
await spinning.run(set("preset", "weak"));
[low, high] = await spinning.run(heights);
ok(Math.abs(high - Math.cos(0.2)) < 1e-3 && low < 0.5, "with half of it the top nods", low + " " + high);
await spinning.run(set("preset", "fall"));
[low, high] = await spinning.run(heights);
ok(high > 1 - 1e-5 && low < -0.99, "at rest it falls and swings", low + " " + high);

// ---- the picture and the plots ----

// Pixels of the outermost rows and columns that are not paper.
const EDGE = `(() => { const c = document.getElementById("space"), d = document.createElement("canvas");
  d.width = c.width; d.height = c.height; const x = d.getContext("2d"); x.drawImage(c, 0, 0);
  const p = new Uint32Array(x.getImageData(0, 0, c.width, c.height).data.buffer); let n = 0, all = 0;
  for (let i = 0; i < p.length; i++) { const u = i % c.width, v = Math.floor(i/c.width);
    if (p[i] !== p[0]) { all++; if (u === 0 || v === 0 || u === c.width - 1 || v === c.height - 1) n++; } }
  return [n, all]; })()`;
for (const [name, p, what] of [["plate", page, "body"], ["top", spinning, "body"],
  ["disc", await opened(DISC), "body"], ["disc", await opened(DISC), "cones"],
  ["racket", await opened("tennis_racket"), "body"]]) {
  await front(p);
  await p.run(`document.getElementById("reset").click()`);
  await p.run(set("what", what));
  let cut = 0, drawn = 0;
  for (const t of [0, 0.31, 0.77, 1.4]) {
    await p.run(set("time", t));
    const [n, all] = await p.run(EDGE);
    cut += n;
    drawn = Math.max(drawn, all);
  }
  ok(cut === 0 && drawn > 1000, `${name}, ${what}: nothing is cut off`, cut + " " + drawn);
}
await front(page);
const axis = await page.run(`document.querySelector("#energy text[transform]").textContent`);
ok(axis === "E / J", "an energy that changes by roundings alone is drawn as the constant that it is", axis);
await page.run(set("step", 0.02));
await page.run(set("first", "0"));
const drift = await page.run(`[document.getElementById("first").selectedOptions[0].text,
  document.querySelector("#energy text[transform]").textContent]`);
ok(drift[0] !== "closed form" && /E₀/.test(drift[1]), "that of a stepper shows its drift", drift.join());

await browser.close();
rmSync(dir, { recursive: true, force: true });
done();
