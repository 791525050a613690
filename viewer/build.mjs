// Builds the page into one file, which the crate exact-ccd-view embeds: `node build.mjs`.
// With --check, compares that file with the sources, and fails if it is not current.

import { readFile, writeFile } from "node:fs/promises";
import { bundle, page } from "./page.mjs";

const output = new URL("../crates/exact-ccd-view/assets/viewer.html", import.meta.url);
const text = await page({
  styles: ["src/style.css"],
  script: await bundle("src/main.ts"),
  security: "",
  scripts: "",
  insertions: {},
  data: "<!-- data -->",
});

if (process.argv.includes("--check")) {
  const current = await readFile(output, "utf8").catch(() => "");
  if (current !== text) {
    console.error("crates/exact-ccd-view/assets/viewer.html is not current: run `npm run build` in viewer");
    process.exit(1);
  }
} else {
  await writeFile(output, text);
  console.log(`crates/exact-ccd-view/assets/viewer.html: ${text.length} characters`);
}
