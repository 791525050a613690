// Builds the page into one file, which the crate exact-ccd-view embeds: `node build.mjs`.
// With --check, compares that file with the sources, and fails if it is not current.

import { readFile, writeFile } from "node:fs/promises";
import { build } from "esbuild";

const root = new URL(".", import.meta.url);
const output = new URL("../crates/exact-ccd-view/assets/viewer.html", root);
/** @param {string} path */
const read = (path) => readFile(new URL(path, root), "utf8");

const { outputFiles } = await build({
  absWorkingDir: root.pathname,
  entryPoints: ["src/main.ts"],
  bundle: true,
  minify: true,
  format: "iife",
  target: "es2022",
  charset: "utf8",
  legalComments: "none",
  write: false,
});
const style = await build({
  stdin: { contents: await read("src/style.css"), loader: "css" },
  minify: true,
  write: false,
});
// A script ends at the first closing tag in its text.
const script = outputFiles[0].text.replaceAll("</script", "<\\/script");
const licence = (await read("node_modules/three/LICENSE")).trim();
const page = `<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data: blob:">
<title>exact-ccd</title>
<!--
This page contains three.js, under this licence:

${licence}
-->
<style>${style.outputFiles[0].text.trim()}</style>
</head>
<body>
${(await read("src/body.html")).trim()}
<!-- data -->
<script>${script.trim()}</script>
</body>
</html>
`;

if (process.argv.includes("--check")) {
  const current = await readFile(output, "utf8").catch(() => "");
  if (current !== page) {
    console.error("crates/exact-ccd-view/assets/viewer.html is not current: run `npm run build` in viewer");
    process.exit(1);
  }
} else {
  await writeFile(output, page);
  console.log(`crates/exact-ccd-view/assets/viewer.html: ${page.length} characters`);
}
