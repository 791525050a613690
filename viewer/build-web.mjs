// Builds the page with the kernel in it: `node build-web.mjs FOLDER OUTPUT.html`. scripts/build-web makes the folder: the
// WebAssembly module and its JavaScript, as wasm-bindgen writes them.

import { mkdir, readFile, writeFile } from "node:fs/promises";
import { dirname, join, resolve } from "node:path";
import { deflateRawSync } from "node:zlib";
import { bundle, element, page, read } from "./page.mjs";

const [folder, output] = process.argv.slice(2).map((path) => resolve(path));
if (output === undefined) throw new Error("expected two arguments: the folder of the module and the file of the page");

const module = deflateRawSync(await readFile(join(folder, "exact_ccd_web_bg.wasm")), { level: 9 });
const worker = await bundle("src/web/worker.ts", { "exact-ccd-web": join(folder, "exact_ccd_web.js") });
const text = await page({
  styles: ["src/style.css", "src/web/style.css"],
  script: await bundle("src/web/main.ts"),
  security: "; worker-src blob:",
  scripts: " 'wasm-unsafe-eval' blob:",
  insertions: { input: await read("src/web/input.html"), edit: '      <button id="edit" hidden>edit as a query</button>\n' },
  data: [
    element(worker, ' type="text/plain" id="worker"'),
    element(module.toString("base64"), ' type="application/octet-stream" id="module"'),
  ].join("\n"),
});
await mkdir(dirname(output), { recursive: true });
await writeFile(output, text);
console.log(`${output}: ${text.length} characters`);
