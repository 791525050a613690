// One HTML file from the sources: its scripts and its style are in it, and it loads nothing.

import { readFile } from "node:fs/promises";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const root = new URL(".", import.meta.url);

/** @param {string} path */
export const read = (path) => readFile(new URL(path, root), "utf8");

/**
 * The text of a bundle, which begins with the module at `entry`.
 * @param {string} entry
 * @param {Record<string, string>} [alias] paths in place of the names of modules
 */
export async function bundle(entry, alias = {}) {
  const { outputFiles } = await build({
    absWorkingDir: fileURLToPath(root),
    entryPoints: [entry],
    bundle: true,
    minify: true,
    format: "iife",
    target: "es2022",
    charset: "utf8",
    legalComments: "none",
    alias,
    // The address of a module is the default of an argument that is always given.
    logOverride: { "empty-import-meta": "silent" },
    write: false,
  });
  return outputFiles[0].text.trim();
}

/**
 * @param {object} parts
 * @param {string[]} parts.styles the paths of the style sheets
 * @param {string} parts.script
 * @param {string} parts.security further directives of the content security policy
 * @param {string} parts.scripts further allowed sources of scripts
 * @param {Record<string, string>} parts.insertions texts by the names of the comments that they replace
 * @param {string} parts.data
 */
export async function page({ styles, script, security, scripts, insertions, data }) {
  const style = await build({
    stdin: { contents: (await Promise.all(styles.map(read))).join("\n"), loader: "css" },
    minify: true,
    write: false,
  });
  const body = (await read("src/body.html")).trim().replace(/^ *<!-- (\w+) -->\n/gm, (_, name) => insertions[name] ?? "");
  const licence = (await read("node_modules/three/LICENSE")).trim();
  return `<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; script-src 'unsafe-inline'${scripts}; style-src 'unsafe-inline'; img-src data: blob:${security}">
<title>exact-ccd</title>
<!--
This page contains three.js, under this licence:

${licence}
-->
<style>${style.outputFiles[0].text.trim()}</style>
</head>
<body>
${body}
${data}
${element(script)}
</body>
</html>
`;
}

/**
 * The element of a script, which ends at the first closing tag in its text.
 * @param {string} text
 * @param {string} [attributes]
 */
export function element(text, attributes = "") {
  return `<script${attributes}>${text.replaceAll("</script", "<\\/script")}</script>`;
}
