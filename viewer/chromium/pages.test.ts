/** Each kind of page in a browser, against the output of the program. */

import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { type Browser, type Page } from "playwright-core";
import { afterAll, beforeAll, describe, expect, it } from "vitest";
import { drawn, launch, open, run } from "./browser.mjs";

let browser: Browser;
let folder: string;
const [START, END] = ["examples/drape_start.ply", "examples/drape_contact.ply"];

beforeAll(async () => {
  folder = mkdtempSync(join(tmpdir(), "exact-ccd-viewer-"));
  browser = await launch();
});

afterAll(async () => {
  await browser.close();
  rmSync(folder, { recursive: true });
});

/** The pixels of a part of the window: red, green, blue and opacity of each. */
async function pixels(page: Page, clip: { x: number; y: number; width: number; height: number }): Promise<number[][]> {
  const picture = await page.screenshot({ clip });
  const data = await page.evaluate(async (base64) => {
    const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
    const bitmap = await createImageBitmap(new Blob([bytes]));
    const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
    const context = canvas.getContext("2d");
    if (context === null) throw new Error("no canvas");
    context.drawImage(bitmap, 0, 0);
    return [...context.getImageData(0, 0, bitmap.width, bitmap.height).data];
  }, picture.toString("base64"));
  return Array.from({ length: data.length / 4 }, (_, i) => data.slice(4 * i, 4 * i + 4));
}

/** A rectangle in the middle of the scene. */
async function middle(page: Page, width: number, height: number): Promise<{ x: number; y: number; width: number; height: number }> {
  const box = await page.locator("#scene").boundingBox();
  if (box === null) throw new Error("the scene is not visible");
  return { x: box.x + (box.width - width) / 2, y: box.y + (box.height - height) / 2, width, height };
}

/** The number of pixels of the colour of contact points in the middle of the scene. */
async function yellowInTheMiddle(page: Page): Promise<number> {
  const found = await pixels(page, await middle(page, 20, 20));
  return found.filter(([r, g, b]) => r > 200 && g > 180 && b < 110).length;
}

const text = (page: Page, selector: string): Promise<string> => page.locator(selector).innerText();
/** The position of the slider, which has 15 digits in Chromium. */
const value = async (page: Page): Promise<number> => Number(await page.locator("#slider").inputValue());

describe("the page of a step", () => {
  let page: Page;
  let problems: string[];
  let report: { toi: number; contact: { kind: string; ids: number[] } };

  beforeAll(async () => {
    const file = join(folder, "step.html");
    report = JSON.parse(run(["step", START, END, "--json", "--view", file])) as typeof report;
    ({ page, problems } = await open(browser, file));
  });

  it("opens at the earliest contact, with the camera on it", async () => {
    expect(await value(page)).toBeCloseTo(report.toi, 12);
    const selected = page.locator(".contact[aria-selected=true]");
    expect(await selected.getAttribute("aria-posinset")).toBe("1");
    const row = await selected.innerText();
    expect(row).toContain(`t = ${report.toi}`);
    expect(report.contact.kind).toBe("vf");
    expect(row).toContain(`vertex ${report.contact.ids[0]}`);
    expect(row).toContain(`face ${report.contact.ids[1]} `);
    expect(await yellowInTheMiddle(page)).toBeGreaterThan(8);
  });

  it("lists all contacts in the order of time", async () => {
    const listed = Number(await page.locator(".contact").first().getAttribute("aria-setsize"));
    expect(await text(page, "#count")).toBe(`${listed} contacts`);
    expect(listed).toBeGreaterThan(1);
    const rows = await page.locator(".contact .time").allInnerTexts();
    const times = rows.map((row) => Number(row.split("= ")[1]));
    expect(times).toEqual([...times].sort((a, b) => a - b));
  });

  it("jumps to another contact", async () => {
    await page.locator("#scene").press("ArrowDown");
    await drawn(page);
    const selected = page.locator(".contact[aria-selected=true]");
    expect(await selected.getAttribute("aria-posinset")).toBe("2");
    const time = (await selected.locator(".time").innerText()).split("= ")[1];
    expect(await value(page)).toBeCloseTo(Number(time), 12);
    expect(await text(page, "#details")).toContain(time);
    expect(await yellowInTheMiddle(page)).toBeGreaterThan(8);
  });

  it("finds contacts by an id", async () => {
    await page.locator("#filter").fill(String(report.contact.ids[0]));
    const rows = await page.locator(".contact").allInnerTexts();
    expect(rows.length).toBeGreaterThan(0);
    for (const row of rows) expect(row).toMatch(new RegExp(`\\b${report.contact.ids[0]}\\b`));
    await page.locator("#filter").fill("");
  });

  it("follows the slider, the keys and the play button", async () => {
    await page.locator("#slider").fill("0.25");
    expect(await text(page, "#moment")).toBe("t = 0.25");
    await page.locator("#scene").press("ArrowRight");
    expect(await text(page, "#moment")).toBe("t = 0.26");
    await page.locator("#scene").press("Shift+ArrowRight");
    expect(await text(page, "#moment")).toBe("t = 1");
    // In the browser, so that the end of the step is not reached in between.
    const stopped = await page.evaluate(
      () =>
        new Promise<string>((done) => {
          const [button, moment] = [document.getElementById("play"), document.getElementById("moment")];
          const until = (): void => {
            const text = moment?.textContent ?? "";
            if (text === "t = 1" || text === "t = 0") requestAnimationFrame(until);
            else {
              button?.click();
              done(text);
            }
          };
          button?.click();
          until();
        }),
    );
    expect(Number(stopped.split("= ")[1])).toBeLessThan(1);
    await drawn(page);
    expect(await text(page, "#moment")).toBe(stopped);
  });

  it("has room for each part of the toolbar, in narrow windows too", async () => {
    for (const width of [400, 730, 1200]) {
      await page.setViewportSize({ width, height: 760 });
      const cut = await page.evaluate(() => {
        const parts = [...document.querySelectorAll("footer > *")];
        const isCut = (part: Element): boolean =>
          part.scrollWidth > part.clientWidth || part.getBoundingClientRect().right > window.innerWidth;
        return parts.filter(isCut).map((part) => part.id);
      });
      expect(cut, `${width} pixels`).toEqual([]);
    }
  });

  it("is light or dark", async () => {
    const background = (): Promise<string> => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
    expect(await background()).toBe("rgb(255, 255, 255)");
    await page.locator("#scene").press("t");
    expect(await background()).toBe("rgb(20, 23, 26)");
  });

  it("loads nothing and reports no error", () => {
    expect(problems).toEqual([]);
  });
});

describe("the page of an audit", () => {
  it("opens at the violation", async () => {
    const file = join(folder, "audit.html");
    const report = JSON.parse(run(["audit", START, START, END, "--json", "--view", file])) as {
      contact: { frame: number; ids: number[]; time: { lower: number } };
    };
    const { page, problems } = await open(browser, file, "dark");
    const { contact } = report;
    const { frame } = contact;
    const toi = contact.time.lower;
    expect(frame).toBe(1);
    expect(await value(page)).toBeCloseTo(frame + toi, 12);
    expect(await text(page, "#count")).toBe("1 contact");
    const row = await text(page, ".contact");
    expect(row).toContain(`frame 1 to 2, t = ${toi}`);
    for (const id of contact.ids) expect(row).toMatch(new RegExp(`\\b${id}\\b`));
    expect(await yellowInTheMiddle(page)).toBeGreaterThan(8);
    await page.locator("#slider").fill("0.5");
    expect(await text(page, "#moment")).toBe("frame 0 to 1, t = 0.5");
    expect(problems).toEqual([]);
  });
});

describe("the page of a query", () => {
  /** Rows of a query file: numerators and denominators, and the truth. */
  const rows = (points: number[][]): string =>
    points.map((point) => `${point.flatMap((x) => [Math.round(100 * x), 100]).join(",")},1\n`).join("");
  const still = [[0, -1, 0], [0, 1, 0]];
  /** An edge that slides along itself and tilts, through another edge at rest, twice. */
  const twice = rows([
    [-0.2, 0.1, 0.5], [1.8, -0.3, -0.75], ...still,
    [-1.8, -0.2, -0.75], [0.2, 0.4, 0.5], ...still,
  ]);
  const apart = rows([[0, 0, 1], [1, 0, 1], ...still, [0, 0, 2], [1, 0, 2], ...still]);

  it("has the answers of the program", async () => {
    const file = join(folder, "query.html");
    const answers = run(["queries", "--kind", "ee", "--round-input", "--view", file, "-"], apart + twice).split("\n");
    const [query, contact, count, toi] = answers[2].split(",");
    expect([query, contact, count]).toEqual(["1", "1", "2"]);
    const { page, problems } = await open(browser, file);
    expect(await text(page, "#title")).toContain("Query 1 in ");
    expect(await text(page, "#verdict")).toContain(`contact at 2 times: t = ${toi}, `);
    expect(await value(page)).toBeCloseTo(Number(toi), 12);
    expect(await page.locator(".plot").first().locator(".accepted").count()).toBe(2);
    expect(await page.locator(".plot").first().locator(".rejected").count()).toBe(0);
    expect(await yellowInTheMiddle(page)).toBeGreaterThan(8);
    // A plot chooses the time.
    const plot = page.locator(".plot").first();
    const box = await plot.boundingBox();
    if (box === null) throw new Error("the plot is not visible");
    await plot.click({ position: { x: box.width * 0.9, y: box.height / 2 } });
    expect(await value(page)).toBeGreaterThan(0.75);
    expect(problems).toEqual([]);
  });

  it("shows a query without contact", async () => {
    const file = join(folder, "free.html");
    run(["queries", "--kind", "ee", "--round-input", "--view", file, "--view-query", "0", "-"], apart + twice);
    const { page, problems } = await open(browser, file, "dark");
    expect(await text(page, "#verdict")).toContain("free of contact");
    expect(await page.locator(".plot .accepted").count()).toBe(0);
    expect(await page.locator(".label").allInnerTexts()).toEqual(["a₀", "a₁", "b₀", "b₁"]);
    expect(problems).toEqual([]);
  });
});

/** Writes a file into the folder of the tests. */
function write(name: string, contents: string): string {
  const file = join(folder, name);
  writeFileSync(file, contents);
  return file;
}

describe("ids", () => {
  /** An STL file: its triangles have no common vertices, so that ids of the file and of the welded mesh differ. */
  const stl = (height: number): string => {
    const faces = [[[0, 0, 0], [1, 0, 0], [1, 1, 0]], [[0, 0, 0], [1, 1, 0], [0, 1, 0]], [[0.6, 0.2, height], [0.6, 0.3, height + 5], [0.7, 0.2, height + 5]]];
    const vertex = (point: number[]): string => `vertex ${point.join(" ")}`;
    const facet = (corners: number[][]): string => `facet normal 0 0 1\nouter loop\n${corners.map(vertex).join("\n")}\nendloop\nendfacet\n`;
    return `solid a\n${faces.map(facet).join("")}endsolid a\n`;
  };

  it("in the scene are the same as in the list: the ids of the file", async () => {
    const [start, end, file] = [write("start.stl", stl(1)), write("end.stl", stl(-1)), join(folder, "stl.html")];
    const report = JSON.parse(run(["step", start, end, "--json", "--view", file])) as { contact: { vertices: number[][] } };
    expect(report.contact.vertices).toEqual([[6], [0, 1, 2]]);
    const { page, problems } = await open(browser, file);
    const labels = await page.locator(".label").allInnerTexts();
    expect(labels).toEqual(report.contact.vertices.flat().map(String));
    const row = await text(page, ".contact[aria-selected=true]");
    expect(row).toContain("vertex 6");
    expect(row).toContain("vertices 0, 1, 2");
    expect(problems).toEqual([]);
  });
});

describe("a half space", () => {
  it("is drawn, and its violations are in the list", async () => {
    const frames = [1, 0.5, -0.25, -0.5].map((height, i) => write(`half-${i}.obj`, `v 0 0 ${height}\nv 1 0 2\nv 0 1 2\nf 1 2 3\n`));
    const file = join(folder, "half-space.html");
    run(["audit", ...frames, "--half-space", "0,0,0,0,0,1", "--all", join(folder, "all.csv"), "--view", file]);
    const { page, problems } = await open(browser, file);
    expect(await value(page)).toBe(2);
    expect(await text(page, "#moment")).toBe("frame 2: half-2.obj");
    expect(await text(page, "#count")).toBe("2 contacts");
    const row = await text(page, ".contact[aria-selected=true]");
    expect(row).toContain("frame 2");
    expect(row).toContain("vertex 0");
    expect(row).toContain("half space 0");
    expect(await text(page, "#details")).toContain("depth\nabout 0.25");
    expect(await yellowInTheMiddle(page)).toBeGreaterThan(8);
    await page.locator("#parts summary").click();
    expect(await text(page, "#bodies")).toContain("half space 0");
    expect(problems).toEqual([]);
  });
});

describe("the scene", () => {
  const opened = async (name: string, contents: string): Promise<Page> => {
    const file = join(folder, `${name}.html`);
    run(["audit", write(`${name}.obj`, contents), "--view", file]);
    const { page, problems } = await open(browser, file);
    expect(problems).toEqual([]);
    // Without the edges of the faces.
    await page.keyboard.press("e");
    await drawn(page);
    return page;
  };
  const isDrawn = ([r, g, b]: number[]): boolean => Math.min(r, g, b) < 235;

  it("has rods that are wider than a line", async () => {
    const page = await opened("rods", "v 0 0 0\nv 1 0 0\nv 2 0 0\nl 1 2 3\n");
    const column = await pixels(page, await middle(page, 1, 300));
    expect(column.filter(isDrawn).length).toBeGreaterThanOrEqual(3);
  });

  it("has back sides that are darker than front sides", async () => {
    const brightness = async (name: string, face: string): Promise<number> => {
      const page = await opened(name, `v 0 0 0\nv 1 0 0\nv 0 1 0\n${face}\n`);
      const found = (await pixels(page, await middle(page, 40, 40))).filter(isDrawn);
      expect(found.length).toBeGreaterThan(100);
      return found.reduce((sum, [r, g, b]) => sum + r + g + b, 0) / found.length;
    };
    expect(await brightness("back", "f 1 3 2")).toBeLessThan(0.9 * (await brightness("front", "f 1 2 3")));
  });
});

describe("the keyboard", () => {
  it("moves the camera, and the slider that has the focus", async () => {
    const file = join(folder, "keys.html");
    run(["audit", START, START, START, "--view", file]);
    const { page, problems } = await open(browser, file);
    const picture = async (): Promise<string> => {
      await drawn(page);
      return (await page.locator("#scene").screenshot()).toString("base64");
    };
    const before = await picture();
    for (const [key, back] of [["a", "d"], ["w", "s"], ["Shift+A", "Shift+D"], ["+", "-"]]) {
      await page.keyboard.press(key);
      expect(await picture()).not.toBe(before);
      await page.keyboard.press(back);
    }
    await page.locator("#opacity").focus();
    await page.keyboard.press("ArrowLeft");
    expect(Number(await page.locator("#opacity").inputValue())).toBeLessThan(1);
    expect(await value(page)).toBe(0);
    await page.locator("#slider").focus();
    await page.keyboard.press("ArrowRight");
    expect(await value(page)).toBeCloseTo(0.01, 12);
    await page.keyboard.press("End");
    expect(await value(page)).toBe(2);
    expect(problems).toEqual([]);
  });
});

describe("the page of a simulation", () => {
  let page: Page;
  let problems: string[];
  let steps: { contacts: number; kinetic_J: number }[];

  beforeAll(async () => {
    const file = join(folder, "simulation.html");
    const lines = run(["simulate", "examples/scenes/small-mat-twist.toml", "--steps", "3", "--json", "--view", file]);
    steps = lines.trim().split("\n").slice(1).map((line) => JSON.parse(line) as (typeof steps)[0]);
    ({ page, problems } = await open(browser, file));
  });

  it("has a frame for each time step", async () => {
    expect(await page.locator("#slider").getAttribute("max")).toBe("3");
    await page.locator("#slider").fill("1.5");
    await drawn(page);
    expect(await text(page, "#moment")).toBe("frame 1 to 2, t = 0.5");
    expect(await page.locator("#contacts").isVisible()).toBe(false);
  });

  it("has bodies and a verdict, and plain numbers", async () => {
    expect(await text(page, "#verdict")).toBe("all 3 time steps converged");
    expect(await text(page, "#summary")).toContain("1.118 m across");
    expect(await page.locator(".body").count()).toBeGreaterThan(0);
    expect(await page.locator(".label.name").count()).toBe(0);
    await page.keyboard.press("n");
    expect(await page.locator(".label.name").allInnerTexts()).toEqual(await page.locator(".body span").allInnerTexts());
    await page.locator(".body input").first().press(" ");
    await drawn(page);
  });

  it("has charts with a cursor at the time of the picture", async () => {
    const plots = page.locator("#history .plot");
    expect(await plots.count()).toBeGreaterThanOrEqual(2);
    const cursor = async (): Promise<number> => Number(await plots.first().locator(".cursor").getAttribute("x1"));
    await page.locator("#slider").fill("0");
    const start = await cursor();
    await page.locator("#slider").fill("3");
    expect(await cursor()).toBeGreaterThan(start);
    const readings = page.locator("#history .readings div");
    const last = steps[2];
    expect(await readings.filter({ hasText: /^contacts/ }).locator("b").innerText()).toBe(String(last.contacts));
    const kinetic = await readings.filter({ hasText: /^kinetic/ }).locator("b").innerText();
    expect(Number(kinetic.replace(" J", "")) / last.kinetic_J).toBeCloseTo(1, 1);
    // A chart chooses the time.
    const box = await plots.first().boundingBox();
    if (box === null) throw new Error("the chart is not visible");
    await plots.first().click({ position: { x: (52 / 340) * box.width + 1, y: box.height / 2 } });
    expect(await value(page)).toBeLessThan(0.1);
  });

  it("loads nothing and reports no error", () => {
    expect(problems).toEqual([]);
  });
});
