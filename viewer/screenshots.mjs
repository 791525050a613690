// Writes the pictures of docs/viewer.md and docs/web.md, from the examples of the repository: `node screenshots.mjs`.
// It needs chromium and the program, as the tests in chromium/ do, and the page of scripts/build-web.

import { existsSync, writeFileSync } from "node:fs";
import { mkdir, mkdtemp, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { ROOT, WEB_PAGE, drawn, launch, open, run } from "./chromium/browser.mjs";

const output = join(ROOT, "docs/viewer");
const folder = await mkdtemp(join(tmpdir(), "exact-ccd-viewer-"));
await mkdir(output, { recursive: true });
const browser = await launch();

/**
 * @param {string} name the name of the picture, and of the page
 * @param {string[]} options the command, without --view
 * @param {{ scheme?: "light" | "dark", input?: string, keys?: string[], slider?: string, cwd?: string }} [how]
 */
async function picture(name, options, { scheme = "light", input = "", keys = [], slider, cwd = ROOT } = {}) {
  const file = join(folder, `${name}.html`);
  run([...options, "--view", file], input, cwd);
  const { page, problems } = await open(browser, file, scheme);
  if (problems.length > 0) throw new Error(`${name}: ${problems.join("; ")}`);
  if (slider !== undefined) await page.locator("#slider").fill(slider);
  for (const key of keys) await page.locator("#scene").press(key);
  // Nothing has the focus.
  await page.evaluate(() => {
    if (document.activeElement instanceof HTMLElement) document.activeElement.blur();
  });
  await drawn(page);
  await page.screenshot({ path: join(output, `${name}.png`) });
  await page.close();
}

const [start, end] = ["examples/drape_start.ply", "examples/drape_contact.ply"];
await picture("step", ["step", start, end]);
await picture("step-all", ["step", start, end], { scheme: "dark", keys: ["f"], slider: "1" });
await picture("audit", ["audit", start, "examples/drape_free.ply", start, end]);

// A vertex and a face: the cubic has two roots; one of them is a contact.
const points = [
  [1.5, -1, 0.25], [1.5, 0.25, -1.5], [0.5, -1.5, 0], [-1, 0.25, 1.25],
  [0.375, 0.5, -0.875], [2.4375, -0.5, -0.375], [0.3125, -0.1875, 0.9375], [-1.1875, -0.5, 0.5],
];
const rows = points.map((point) => `${point.map((x) => `${10000 * x},10000`).join(",")}\n`).join("");
await picture("query", ["queries", "--kind", "vf", "-"], { input: rows });

const scene = "examples/scenes/cloth-knot-particles.toml";
await picture("simulation", ["simulate", scene, "--steps", "14"], { slider: "13.5", keys: ["+", "+"] });

// A ring that sinks into a floor: the vertices of its lowest part, frame by frame.
const frames = [0.45, 0.3, 0.15, 0].map((height, i) => {
  const file = `ring-${i}.obj`;
  const [count, sides] = [40, 16];
  const lines = [];
  for (let a = 0; a < count; a++) {
    for (let b = 0; b < sides; b++) {
      const [u, v] = [(2 * Math.PI * a) / count, (2 * Math.PI * b) / sides];
      const [out, up] = [1 + 0.3 * Math.cos(v), 0.3 * Math.sin(v)];
      const [x, y] = [out * Math.cos(u), out * Math.sin(u)];
      lines.push(`v ${x} ${y} ${up + 0.2 * x + height}`);
    }
  }
  const vertex = (/** @type {number} */ a, /** @type {number} */ b) => (a % count) * sides + (b % sides) + 1;
  for (let a = 0; a < count; a++) {
    for (let b = 0; b < sides; b++) {
      lines.push(`f ${vertex(a, b)} ${vertex(a + 1, b)} ${vertex(a + 1, b + 1)} ${vertex(a, b + 1)}`);
    }
  }
  writeFileSync(join(folder, file), `${lines.join("\n")}\n`);
  return file;
});
const audit = ["audit", ...frames, "--half-space", "0,0,-0.16,0,0,1", "--all", "all.csv"];
await picture("half-space", audit, { scheme: "dark", keys: ["f"], cwd: folder });

/**
 * @param {string} file the picture
 * @param {"light" | "dark"} scheme
 * @param {(page: import("playwright-core").Page) => Promise<void>} prepare
 */
async function web(file, scheme, prepare) {
  const { page, problems } = await open(browser, WEB_PAGE, scheme);
  await page.setViewportSize({ width: 1200, height: 860 });
  await prepare(page);
  if (problems.length > 0) throw new Error(`${file}: ${problems.join("; ")}`);
  await page.waitForTimeout(1000);
  await drawn(page);
  await mkdir(dirname(file), { recursive: true });
  await page.screenshot({ path: file });
  await page.close();
}

const example = (/** @type {string} */ number) => async (/** @type {import("playwright-core").Page} */ page) => {
  await page.locator("#presets").selectOption(number);
};
if (existsSync(WEB_PAGE)) await web(join(ROOT, "docs/web/query.png"), "light", example("0"));
else console.error(`${WEB_PAGE} is missing, see scripts/build-web: docs/web/query.png stays as it is`);

await browser.close();
await rm(folder, { recursive: true });
