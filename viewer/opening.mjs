// Measures how long a large page takes to open in Chromium: `node opening.mjs`, with nothing else to do for the
// machine. The mesh is a sheet of 180,000 faces, through which 100 points fall.

import { mkdtemp, rm, stat, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { launch, open, run } from "./chromium/browser.mjs";

const SIDE = 300;
const POINTS = 100;
const RUNS = 5;

/** The sheet, with waves of this phase, and the points at a height, as an OBJ file. */
function sheet(/** @type {number} */ phase, /** @type {number} */ height) {
  const lines = [];
  for (let i = 0; i <= SIDE; i++) {
    for (let j = 0; j <= SIDE; j++) lines.push(`v ${i} ${j} ${Math.sin(0.05 * i + 0.03 * j + phase)}`);
  }
  for (let k = 0; k < POINTS; k++) lines.push(`v ${30 * (k % 10) + 15.3} ${30 * Math.floor(k / 10) + 15.6} ${height + k / POINTS}`);
  for (let i = 0; i < SIDE; i++) {
    for (let j = 1; j <= SIDE; j++) {
      const a = i * (SIDE + 1) + j;
      lines.push(`f ${a} ${a + SIDE + 1} ${a + 1}`, `f ${a + 1} ${a + SIDE + 1} ${a + SIDE + 2}`);
    }
  }
  return `${lines.join("\n")}\n`;
}

const folder = await mkdtemp(join(tmpdir(), "exact-ccd-opening-"));
const [start, end, file] = ["start.obj", "end.obj", "page.html"].map((name) => join(folder, name));
await writeFile(start, sheet(0, 3));
await writeFile(end, sheet(0.2, -5));
process.stdout.write(run(["step", start, end, "--view", file]));

const faces = 2 * SIDE * SIDE;
const vertices = (SIDE + 1) ** 2 + POINTS;
// Indices, and coordinates at both ends of the step, of 4 bytes each.
const binary = 12 * faces + 24 * vertices;
const { size } = await stat(file);
console.log(`${faces} faces; page: ${size} bytes, ${(size / binary).toFixed(3)} of the binary data (${binary})`);

const browser = await launch();
const seconds = [];
for (let run = 0; run < RUNS; run++) {
  const begin = performance.now();
  const { page, problems } = await open(browser, file);
  seconds.push((performance.now() - begin) / 1000);
  if (problems.length > 0) throw new Error(problems.join("; "));
  if (run === 0) console.log(`in the list: ${await page.locator("#count").textContent()}`);
  if (process.argv[2] !== undefined && run === 0) await page.screenshot({ path: process.argv[2] });
  await page.close();
}
await browser.close();
await rm(folder, { recursive: true });
seconds.sort((a, b) => a - b);
console.log(`seconds to open: ${seconds.map((s) => s.toFixed(2)).join(", ")}; median ${seconds[RUNS >> 1]?.toFixed(2)}`);
