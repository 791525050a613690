/** The page with the kernel in it, against the program. */

import { readFileSync } from "node:fs";
import { type Browser, type Page } from "playwright-core";
import { afterAll, beforeAll, describe, expect, it } from "vitest";
import { pointCount } from "../src/web/entry";
import { type Kind } from "../src/kinds";
import { type QueryAnswer } from "../src/web/protocol";
import { PRESETS } from "../src/web/presets";
import { decode } from "../src/web/numbers";
import { type Page as Data } from "../src/page";
import { drawn, launch, open, ROOT, run, WEB_PAGE } from "./browser.mjs";

const KINDS: [Kind, string][] = [
  ["vertex-face", "vf"],
  ["edge-edge", "ee"],
  ["vertex-edge", "ve"],
  ["vertex-vertex", "vv"],
];

/** Equidistributed numbers below 1, the same in each run (Lehmer's generator). */
function generator(seed: number): () => number {
  let state = seed;
  return () => {
    state = (state * 48271) % 2147483647;
    return state / 2147483647;
  };
}

/** Coordinates of every kind of trouble: grids, flat motion, points in one place, huge and tiny numbers. */
function queries(kind: Kind, count: number): number[][] {
  const random = generator(1 + kind.length);
  const size = 6 * pointCount(kind);
  const grid = (): number => Math.floor(5 * random()) - 2;
  const some = (): number => 2 * random() - 1;
  const styles: ((i: number) => number)[] = [
    some,
    grid,
    () => grid() / 3,
    // In a plane, and on a line.
    (i) => (i % 3 === 2 ? 0.1 : some()),
    (i) => (i % 3 === 0 ? grid() : 1),
    () => grid() * 1e150,
    () => some() * 1e-160,
    () => 1e6 + some() * 1e-6,
    () => (some() < 0 ? -0 : Number.MIN_VALUE * Math.floor(9 * random())),
    () => some() * 2 ** Math.floor(60 * some()),
  ];
  return Array.from({ length: count }, (_, n) => {
    const style = styles[n % styles.length];
    const coordinates = Array.from({ length: size }, (_, i) => style(i));
    // A resting primitive, or two points in one place.
    if (n % 3 === 0) for (let i = size / 2; i < size; i++) if (random() < 0.5) coordinates[i] = coordinates[i - size / 2];
    if (n % 4 === 0) for (let i = 0; i < 3; i++) coordinates[i + 3] = coordinates[i];
    return coordinates;
  });
}

/** The rows of a query file: each coordinate as a fraction of integers, exactly. */
function rows(all: number[][]): string {
  const fraction = (x: number): string => {
    const [mantissa, exponent] = decode(x);
    return exponent < 0 ? `${mantissa},${2n ** BigInt(-exponent)}` : `${mantissa << BigInt(exponent)},1`;
  };
  const row = (point: number[]): string => `${point.map(fraction).join(",")}\n`;
  return all.flatMap((coordinates) => coordinates.flatMap((_, i) => (i % 3 === 0 ? row(coordinates.slice(i, i + 3)) : []))).join("");
}

/** The answers of the program: contact, count and time. */
function program(kind: string, all: number[][], options: string[]): string[][] {
  const lines = run(["queries", "--kind", kind, ...options, "-"], rows(all)).trim().split("\n").slice(1);
  return lines.map((line) => line.split(",").slice(1));
}

describe(`the page with the kernel in it (scripts/build-web makes ${WEB_PAGE})`, () => {
  let browser: Browser;
  let page: Page;
  let problems: string[];
  const text = (selector: string): Promise<string> => page.locator(selector).innerText();
  /** Waits until an element has a text. */
  const shows = async (selector: string, expected: string | RegExp): Promise<void> => {
    await expect.poll(() => text(selector), { timeout: 30_000 }).toMatch(expected);
  };
  const field = (name: string) => page.getByLabel(name, { exact: true });

  beforeAll(async () => {
    browser = await launch();
    ({ page, problems } = await open(browser, WEB_PAGE));
  });
  afterAll(() => browser.close());

  it("opens with an answer", async () => {
    expect(await text("#verdict")).toContain("contact at t = 0.43522422863384475");
    expect(await text("#exact")).toBe("t = 0.43522422863384475");
    expect(await text("#difference")).toContain("Missed contact");
    expect(await page.locator(".plot .accepted").count()).toBeGreaterThan(0);
  });

  const distances: [string, number][] = [["contact", 0], ["a distance of 0.1", 0.1]];
  describe.each(KINDS)("%s", (kind, name) => {
    it.each(distances)("has the answers of the program: %s", async (_, distance) => {
      const all = queries(kind, distance === 0 ? 120 : 40);
      const answers = await page.evaluate(
        async ({ kind, all, distance }) => {
          const ask = (one: number[]) => window.exactCcd.call("query", kind, Float64Array.from(one), distance, 0);
          return Promise.all(all.map(ask));
        },
        { kind, all, distance },
      ) as QueryAnswer[];
      const exact = program(name, all, ["--min-distance", String(distance)]);
      const found = answers.map(({ page }) => {
        const { query, contacts } = JSON.parse(page["page"]) as Data;
        const moments = (query?.times ?? []).every(([start, end]) => start === end);
        const count = distance > 0 || moments ? (query?.times.length ?? 0) : -1;
        const time = contacts[0]?.time;
        return [contacts.length, count, time];
      });
      const expected = exact.map(([contact, count, time]) => [Number(contact), Number(count), time === "" ? undefined : Number(time)]);
      expect(found).toEqual(expected);
      const touching = expected.filter(([contact]) => contact === 1).length;
      expect(touching).toBeGreaterThan(0);
      expect(touching).toBeLessThan(all.length);
      const finder = answers.map(({ rootFinder }) => rootFinder);
      if (name === "ve" || name === "vv") expect(finder.every((verdict) => verdict === null)).toBe(true);
      else if (distance === 0) {
        const known = program(name, all, ["--method", "FPRF"]).map(([contact, , time]) => ({
          contact: contact === "1",
          time: time === "" || !Number.isFinite(Number(time)) ? null : Number(time),
        }));
        expect(finder).toEqual(known);
      }
    });
  });

  it("answers at once to a number", async () => {
    await page.locator("#presets").selectOption("1");
    await shows("#difference", "agrees, up to rounding");
    await shows("#difference", "The exact time is rounded down");
    await field("z of p at t = 1").fill("0x1.8p-1");
    await shows("#exact", "no contact");
    await shows("#difference", "✓");
    expect(await page.locator("#presets").inputValue()).toBe("own");
    await field("z of p at t = 1").fill("one");
    expect(await field("z of p at t = 1").getAttribute("aria-invalid")).toBe("true");
    await field("z of p at t = 1").fill("-1");
    await shows("#exact", /^t = 0\.5$/);
    expect(Number(await page.locator("#slider").inputValue())).toBeCloseTo(0.5, 12);
    await field("z of p at t = 1").press("Shift+ArrowDown");
    await shows("#exact", "t = 0.49999999999999994");
    await field("distance").fill("0.5");
    await shows("#verdict", "within 0.5 at t = 0.2");
    await field("distance").fill("0");
    await shows("#exact", "t = 0.49999999999999994");
  });

  it("follows the mouse", async () => {
    await page.locator("#presets").selectOption("1");
    await shows("#exact", "t = 0.39999999999999997");
    await drawn(page);
    const handles = await page.evaluate(() => window.exactCcdHandles());
    // The end of the path of p, upwards: it stops before the face.
    const [x, y] = handles[4];
    await page.mouse.move(x, y);
    await page.mouse.down();
    for (let i = 1; i <= 10; i++) await page.mouse.move(x, y - 28 * i);
    await page.mouse.up();
    await expect.poll(async () => Number(await field("z of p at t = 1").inputValue())).toBeGreaterThan(-1);
    const coordinates = await page.locator("#points input").evaluateAll((inputs) => inputs.map((input) => (input as HTMLInputElement).value));
    // In rows of p at t = 0, p at t = 1, and so on.
    const values = coordinates.map(Number);
    const at = (time: number): number[] => [0, 1, 2, 3].flatMap((point) => values.slice(3 * (2 * point + time), 3 * (2 * point + time) + 3));
    const [[contact, , time]] = program("vf", [[...at(0), ...at(1)]], []);
    await shows("#exact", contact === "1" ? `t = ${time}` : "no contact");
    for (const value of coordinates) expect(value.length).toBeLessThan(8);
  });

  it.each(PRESETS.map(({ name, entry }, i) => [name, i, entry] as const))("has an example: %s", async (name, i, { kind, coordinates, distance }) => {
    await page.locator("#presets").selectOption("0");
    await shows("#difference", "Missed");
    await page.locator("#presets").selectOption(String(i));
    const file = KINDS.find(([known]) => known === kind)?.[1] ?? "";
    const [[contact, , time]] = program(file, [[...coordinates]], ["--min-distance", String(distance)]);
    await shows("#title", /./);
    await shows("#exact", contact === "1" ? new RegExp(`^t = ${time.replaceAll(".", "\\.")}$`) : "no contact");
    if (name.includes("missed")) await shows("#difference", "✗ Missed contact");
    else if (name.includes("none")) await shows("#difference", "✗ False contact");
    else if (name.includes("early") || name.includes("at once")) await shows("#difference", /! .*early/);
  });

  it("has the contacts of two files, and their queries", async () => {
    const [start, end] = ["examples/drape_start.ply", "examples/drape_contact.ply"];
    const report = JSON.parse(run(["step", start, end, "--json"])) as { toi: number; contact: { ids: number[] } };
    const files = [end, start].map((path) => ({ name: path.split("/")[1], text: readFileSync(`${ROOT}${path}`).toString("base64") }));
    // In any order: by their names, "contact" comes before "start".
    await page.evaluate((files) => {
      const data = new DataTransfer();
      for (const { name, text } of files) {
        data.items.add(new File([Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0))], name));
      }
      document.body.dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true }));
    }, files);
    await shows("#title", "drape_contact.ply to drape_start.ply");
    await page.locator("#exchange").click();
    await shows("#title", "drape_start.ply to drape_contact.ply");
    await shows("#exact", `t = ${report.toi}`);
    await shows("#difference", /✓|!|✗/);
    const row = await text(".contact[aria-selected=true]");
    expect(row).toContain(`t = ${report.toi}`);
    expect(row).toContain(`vertex ${report.contact.ids[0]} `.trim());
    expect(row).toContain(`face ${report.contact.ids[1]}`);
    await page.locator("#edit").click();
    await shows("#title", "vertex and a face");
    await shows("#exact", `t = ${report.toi}`);
  });

  it("says what is wrong with a file", async () => {
    await page.locator("#mode-meshes").click();
    await page.locator("#start").setInputFiles({ name: "start.obj", mimeType: "", buffer: Buffer.from("v 0 0 0\nv 1 0\n") });
    await shows("#problem", /start\.obj.*line 2/);
  });

  it("loads nothing and reports no error", () => {
    expect(problems).toEqual([]);
  });
});
