// bits.mjs -- the state after 1e5 steps: a page's wasm, in node and in Chromium, against a native program, bit for bit.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The native program is `polhode gen --libm own`, compiled by gcc: another compiler, another processor.  Equal means
// equal bytes; there is no tolerance.

import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { launch } from "./browser.mjs";
import { done, ok } from "./tap.mjs";

const STEPS = 100000;
const CASES = [
  ["tennis_racket", ["rk4", "adaptive", "midpoint", "taylor"]],
  ["heavy_top", ["rk4", "split4", "semi", "taylor"]],
  ["compass", ["rk4", "adaptive"]],
  ["magnet_pendulum", ["rk4"]],
];

const program = (name, steps) => `#include "${name}.h"
#include <stdio.h>
typedef void step_of(const ${name}_model *m, ${name}_real t, ${name}_real x[], const ${name}_real u[], ${name}_real h);
int main(void) {
  static step_of *const steps[] = { ${steps.join(", ")} };
  ${name}_model m; ${name}_real u[64] = {0}; const double h = STEP; size_t k, n; long i;
  if (${name}_init(&m, NULL)) return 1;
  for (n = 0; n < sizeof steps/sizeof steps[0]; n++) {
    ${name}_real x[64] = {0}; unsigned char *p = (unsigned char *)x;
    ${name}_initial(&m, x);
    for (i = 0; i < COUNT; i++) steps[n](&m, (${name}_real)i*(${name}_real)h, x, u, (${name}_real)h);
    for (k = 0; k < NX*sizeof x[0]; k++) printf("%02x", p[k]);
    putchar('\\n');
  }
  return 0;
}
`;

const dir = mkdtempSync(join(tmpdir(), "polhode-bits-"));
const polhode = (...words) => execFileSync("build/polhode", words, { stdio: ["ignore", "pipe", "pipe"] });

// The same methods in the same order: what NAME_init computes, and so its last digit, depends on who needs it.
function native(name, methods, real, facts) {
  const to = join(dir, `${name}-${real}`), all = facts.exact ? ["exact", ...methods] : methods;
  polhode("gen", name, "--libm", "own", "--real", real, "--method", all.join(","), "--layout", "single", "-o", to);
  writeFileSync(join(to, "main.c"), program(name, methods.map((m, i) => i ? `${name}_${m}_step` : `${name}_step`)));
  execFileSync("gcc", ["-O2", "-std=c99", "-ffp-contract=off", `-DSTEP=${facts.step}`, `-DCOUNT=${STEPS}`,
    `-DNX=${facts.states.length}`, "-o", join(to, "bits"), join(to, "main.c"), join(to, name + ".c"), "-lm"]);
  return execFileSync(join(to, "bits")).toString().split("\n");
}

const block = (html, id) => new RegExp(`id="${id}">([^<]*)</script>`).exec(html)[1];
const hex = (bytes) => Buffer.from(bytes).toString("hex");

async function inNode(html, facts) {
  const made = await WebAssembly.instantiate(Buffer.from(block(html, "code"), "base64"), {});
  const f = made.instance.exports, size = facts.real === "float" ? 4 : 8, n = facts.states.length*size;
  return (method) => {
    f.defaults();
    if (f.init() !== 0) return "refused";
    f.initial(0);
    f.march(0, method, facts.step, 0, STEPS);
    return hex(new Uint8Array(f.memory.buffer, f.states(), n));
  };
}

const inBrowser = (page, method) => page.run(`(() => { const c = polhode.code; c.defaults(); c.init(); c.initial(0);
  c.march(0, ${method}, polhode.facts.step, 0, ${STEPS}); const x = c.states[0];
  return Array.from(new Uint8Array(x.buffer, x.byteOffset, x.byteLength),
    (b) => b.toString(16).padStart(2, "0")).join(""); })()`);

const browser = await launch();
for (const [name, methods] of CASES)
  for (const real of ["double", "float"]) {
    const file = join(dir, `${name}-${real}.html`);
    polhode("view", name, "--real", real, "--method", methods.join(","), "-o", file);
    const html = readFileSync(file, "utf8"), facts = JSON.parse(block(html, "facts"));
    const all = native(name, methods, real, facts), node = await inNode(html, facts);
    const page = await browser.open("file://" + file + "#t=0.001");
    for (const [i, method] of methods.entries()) {
      const expected = all[i], a = node(i), b = await inBrowser(page, i);
      ok(expected.length === facts.states.length*(real === "float" ? 8 : 16) && a === expected && b === expected,
        `${name}, ${real}, ${method}: 1e5 steps give the native program's bits in node and in Chromium`,
        `native   ${expected}\nnode     ${a}\nChromium ${b}`);
    }
  }
await browser.close();
rmSync(dir, { recursive: true, force: true });
done();
