// typst.mjs - compiles Typst documents and prints what the compiler finds, one line a document.
// SPDX-License-Identifier: GPL-3.0-or-later
//
//     node typst.mjs COMPILER FILE...      COMPILER: the folder with the node module (tests/report/handout_typst.t)
//
// Typst says nothing of a formula that is wider than its page, so a rule at the head of each document measures them.
// With PDF=1 each document is written beside its source.

import { readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { resolve } from "node:path";

const [folder, ...files] = process.argv.slice(2);
const require = createRequire(resolve(folder, "package.json"));
const { NodeCompiler } = require("@myriaddreamin/typst-ts-node-compiler");

const measured = "#show math.equation.where(block: true): it => layout(size => { let w = measure(it).width; " +
  'if w > size.width { panic("a formula of " + repr(w) + " in a line of " + repr(size.width)) }; it })\n';

const compiler = NodeCompiler.create();
for (const file of files) {
  const source = readFileSync(file, "utf8");
  // after the document's own rules, which say how wide its page is
  const at = Math.max(source.search(/^= /m), 0);
  const result = compiler.compile({ mainFileContent: source.slice(0, at) + measured + source.slice(at) });
  const document = result.result;
  const found = [result.takeError(), result.takeWarnings()].filter((e) => e);
  const list = found.flatMap((e) => compiler.fetchDiagnostics(e)).map((d) => d.message);
  if (!document && list.length === 0) list.push("no document");
  console.log(`${document?.numOfPages ?? 0} ${list.join("; ") || "nothing"}`);
  if (document && process.env.PDF) writeFileSync(file.replace(/typ$/, "pdf"), compiler.pdf(document));
  compiler.evictCache(5);
}
