// The browser and the program, for tests and screenshots.

import { spawnSync } from "node:child_process";
import { existsSync } from "node:fs";
import { fileURLToPath, pathToFileURL } from "node:url";
import { chromium } from "playwright-core";

/** The folder of the repository. */
export const ROOT = fileURLToPath(new URL("../..", import.meta.url));

const BROWSER = process.env["CHROMIUM"] ?? "/usr/bin/chromium";
const TARGET = process.env["CARGO_TARGET_DIR"] ?? `${ROOT}target`;
const PROGRAM = process.env["EXACT_CCD"] ?? `${TARGET}/release/exact-ccd`;

/** The page that scripts/build-web makes. */
export const WEB_PAGE = process.env["WEB_PAGE"] ?? `${TARGET}/web/exact-ccd.html`;

/** Software in place of a graphics card, and no traffic of its own. */
const OPTIONS = [
  "--no-sandbox",
  "--use-gl=angle",
  "--use-angle=swiftshader",
  "--enable-unsafe-swiftshader",
  "--disable-quic",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
];

export function launch() {
  if (!existsSync(BROWSER)) throw new Error(`${BROWSER} is missing: install chromium, or set CHROMIUM`);
  return chromium.launch({ executablePath: BROWSER, args: OPTIONS });
}

/**
 * The standard output of `exact-ccd`, which may find contact.
 * @param {string[]} options
 * @param {string} [input] the standard input
 * @param {string} [cwd] the folder in which it runs
 */
export function run(options, input = "", cwd = ROOT) {
  if (!existsSync(PROGRAM)) throw new Error(`${PROGRAM} is missing: run \`cargo build --release --features full\`, or set EXACT_CCD`);
  const { status, stdout, stderr } = spawnSync(PROGRAM, options, { cwd, encoding: "utf8", input });
  if (status !== 0 && status !== 1) throw new Error(`exact-ccd ${options.join(" ")}: ${stderr}`);
  return stdout;
}

/**
 * Opens a page from disk and waits until it is drawn.
 * @param {import("playwright-core").Browser} browser
 * @param {string} file
 * @param {"light" | "dark"} colorScheme
 */
export async function open(browser, file, colorScheme = "light") {
  const page = await browser.newPage({ viewport: { width: 1200, height: 760 }, colorScheme, reducedMotion: "reduce" });
  /** @type {string[]} */
  const problems = [];
  page.on("pageerror", (error) => problems.push(error.message));
  page.on("console", (message) => {
    if (message.type() === "error") problems.push(message.text());
  });
  page.on("request", (request) => {
    if (!/^(file|data|blob):/.test(request.url())) problems.push(`loads ${request.url()}`);
  });
  await page.goto(pathToFileURL(file).href);
  await page.waitForFunction(() => document.documentElement.dataset["ready"] !== undefined, null, { timeout: 60_000 });
  await drawn(page);
  return { page, problems };
}

/**
 * Waits until all pictures that were requested are drawn.
 * @param {import("playwright-core").Page} page
 */
export async function drawn(page) {
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
}
