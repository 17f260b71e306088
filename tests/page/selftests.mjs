// selftests.mjs -- the emitted self-test of scenes, compiled to WebAssembly as pages are, in node.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// All scenes of bodies/, in double and float by turns; in double where float has not the range for the constants.
// The expected numbers stand in NAME_test.c, computed with 200 bits.  Its report is one line for a check.

import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, readdirSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { done, ok } from "./tap.mjs";

// As view.lua has them; copies are instructions here, which a page has as functions of its own.
const FLAGS = ["--target=wasm32", "-std=c99", "-ffp-contract=off", "-fno-math-errno", "-ffreestanding", "-nostdlib",
  "-mbulk-memory", "-fvisibility=hidden"];
const LINK = ["-Wl,--no-entry", "-Wl,--export=self_test", "-Wl,--strip-all", "-Wl,--stack-first",
  "-Wl,-z,stack-size=262144"];
const dir = mkdtempSync(join(tmpdir(), "polhode-selftests-"));
const quiet = { stdio: ["ignore", "pipe", "pipe"] };

const scenes = readdirSync("bodies").filter((f) => f.endsWith(".lua")).map((f) => f.slice(0, -4)).sort();

const generate = (name, real) => execFileSync("build/polhode", ["gen", name, "--libm", "own", "--real", real,
  "--layout", "single", "-o", join(dir, name + real)], quiet);

function narrow(name) {
  try {
    generate(name, "float");
  } catch (e) {
    if (/must be within its range/.test(e.stderr)) return true;
    throw e;
  }
  return false;
}

async function tested(name, real) {
  const to = join(dir, name + real);
  generate(name, real);
  const clang = (...words) => execFileSync("clang", [...FLAGS, ...words], quiet);
  clang("-O2", "-c", "-o", to + ".o", join(to, name + ".c"));
  clang("-O0", "-Dmain=self_test", "-Itests/page/bare", "-I" + to, ...LINK, "-o", to + ".wasm",
    join(to, name + "_test.c"), to + ".o");
  const lines = [];
  let memory;
  const text = (at) => {
    const bytes = new Uint8Array(memory.buffer, at);
    return Buffer.from(bytes.subarray(0, bytes.indexOf(0))).toString();
  };
  const said = (format, word) => { lines.push(text(format).replace("%s", text(word)).trimEnd()); };
  const { instance } = await WebAssembly.instantiate(readFileSync(to + ".wasm"), { page: { said } });
  memory = instance.exports.memory;
  const status = instance.exports.self_test();
  const passed = lines.filter((l) => /^ok /.test(l)).length;
  ok(status === 0 && passed > 0 && !lines.some((l) => /^not ok|other bits/.test(l)),
    `${name}, ${real}: the self-test passes in WebAssembly, ${passed} checks`, lines.join("\n"));
}

for (const [i, name] of scenes.entries()) {
  const real = i % 2 === 0 || narrow(name) ? "double" : "float";
  await tested(name, real);
}
rmSync(dir, { recursive: true, force: true });
done();
