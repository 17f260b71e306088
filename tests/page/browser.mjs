// browser.mjs -- Chromium, headless, driven over a pipe by its own protocol.  SPDX-License-Identifier: GPL-3.0-or-later
//
//     const b = await launch(); const page = await b.open("file:///..."); await page.run("1 + 1"); await b.close();
// page.said: what the page wrote to the console, errors among it; page.asked: the addresses it requested.

import { spawn } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

const FLAGS = ["--headless=new", "--no-sandbox", "--enable-unsafe-swiftshader", "--hide-scrollbars",
  "--remote-debugging-pipe", "--no-first-run", "--disable-component-update", "--window-size=1200,900"];

export async function launch(...more) {
  const home = mkdtempSync(join(tmpdir(), "polhode-page-"));
  const child = spawn("chromium", [...FLAGS, ...more, "--user-data-dir=" + home],
    { stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"] });
  const waiting = new Map(), listeners = [];
  let next = 1, rest = Buffer.alloc(0);
  const ended = new Promise((resolve) => child.on("exit", resolve));
  child.on("error", (e) => { for (const w of waiting.values()) w.no(e); });
  child.stdio[4].on("data", (data) => {
    rest = Buffer.concat([rest, data]);
    for (let at; (at = rest.indexOf(0)) >= 0; rest = rest.subarray(at + 1)) {
      const m = JSON.parse(rest.subarray(0, at).toString());
      const w = waiting.get(m.id);
      waiting.delete(m.id);
      if (w) m.error ? w.no(new Error(m.error.message)) : w.yes(m.result);
      else for (const f of listeners) f(m);
    }
  });
  const send = (method, params = {}, sessionId = undefined) => new Promise((yes, no) => {
    waiting.set(next, { yes, no });
    child.stdio[3].write(JSON.stringify({ id: next++, method, params, sessionId }) + "\0");
  });

  async function open(url, { width = 1200, height = 900, dark = false, still = true } = {}) {
    const { targetId } = await send("Target.createTarget", { url: "about:blank" });
    const { sessionId } = await send("Target.attachToTarget", { targetId, flatten: true });
    const page = { said: [], asked: [], send: (m, p) => send(m, p, sessionId) };
    let loaded;
    const load = new Promise((resolve) => { loaded = resolve; });
    listeners.push((m) => {
      if (m.sessionId !== sessionId) return;
      if (m.method === "Page.loadEventFired") loaded();
      if (m.method === "Runtime.consoleAPICalled") page.said.push(m.params.args.map((a) => a.value).join(" "));
      if (m.method === "Runtime.exceptionThrown") page.said.push(m.params.exceptionDetails.exception?.description);
      if (m.method === "Log.entryAdded") page.said.push(m.params.entry.text);
      if (m.method === "Network.requestWillBeSent") page.asked.push(m.params.request.url);
    });
    for (const d of ["Page", "Runtime", "Log", "Network"]) await page.send(d + ".enable");
    await page.send("Emulation.setDeviceMetricsOverride", { width, height, deviceScaleFactor: 1, mobile: false });
    await page.send("Emulation.setEmulatedMedia", { features: [
      { name: "prefers-color-scheme", value: dark ? "dark" : "light" },
      { name: "prefers-reduced-motion", value: still ? "reduce" : "no-preference" }] });
    page.run = async (expression) => {
      const r = await page.send("Runtime.evaluate", { expression, awaitPromise: true, returnByValue: true });
      if (r.exceptionDetails) throw new Error(r.exceptionDetails.exception?.description || r.exceptionDetails.text);
      return r.result.value;
    };
    page.shot = async () => Buffer.from((await page.send("Page.captureScreenshot",
      { captureBeyondViewport: true, format: "png" })).data, "base64");
    await page.send("Page.navigate", { url });
    await load;
    for (let i = 0; i < 200 && !(await page.run("Boolean(globalThis.polhode && polhode.ready)")); i++) {
      if (await page.run("document.getElementById('refused')?.textContent.startsWith('The page cannot')")) break;
      await new Promise((r) => { setTimeout(r, 25); });
    }
    return page;
  }

  async function close() {
    await send("Browser.close").catch(() => 0);
    await ended;
    rmSync(home, { recursive: true, force: true });
  }
  return { open, close };
}
