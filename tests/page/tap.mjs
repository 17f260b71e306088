// tap.mjs -- results in TAP.  SPDX-License-Identifier: GPL-3.0-or-later

let count = 0, failed = 0;

export function ok(good, name, why = "") {
  count++;
  if (!good) failed++;
  console.log(`${good ? "ok" : "not ok"} ${count} - ${name}`);
  if (!good && why !== "") console.log(String(why).replace(/^/gm, "# "));
}

export function done() {
  console.log(`1..${count}`);
  process.exitCode = failed > 0 ? 1 : 0;
}
