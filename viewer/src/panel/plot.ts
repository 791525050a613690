/** Curves over time, as SVG, with a cursor. */

import { decadesOf, linearTicks, powerTicks, rangeOf, ticksOf, tickText } from "./scale";

const NAMESPACE = "http://www.w3.org/2000/svg";
const [WIDTH, HEIGHT] = [340, 170];
const [LEFT, RIGHT, TOP, BOTTOM] = [52, 12, 26, 34];

export interface PlotCurve {
  name: string;
  /** Values at `times`; null where there is none. */
  values: (number | null)[];
}

export interface PlotOptions {
  title: string;
  unit: string;
  /** The name of the time, and the times of the values, increasing. */
  time: string;
  times: number[];
  curves: PlotCurve[];
  logarithmic: boolean;
  /** The value that is marked: zero, or a distance. */
  level: number;
  /** Times marked at that value: accepted ones filled, others hollow. */
  marks: { t: number; accepted: boolean }[];
  /** Intervals of time that are marked at that value. */
  intervals: [number, number][];
  /** Called with a time that the reader points at. */
  choose: (t: number) => void;
}

function element(name: string, attributes: Record<string, string | number>, text?: string): SVGElement {
  const made = document.createElementNS(NAMESPACE, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, String(value));
  if (text !== undefined) made.textContent = text;
  return made;
}

/** The place of the last time that is not after t, or −1. */
export function lastBefore(times: number[], t: number): number {
  const after = times.findIndex((time) => time > t);
  return (after < 0 ? times.length : after) - 1;
}

export class Plot {
  readonly element: HTMLElement;
  private readonly cursor: SVGElement;
  private readonly x: (t: number) => number;
  private readonly readings: HTMLElement[];

  constructor(private readonly options: PlotOptions) {
    const { title, unit, time, times, curves, logarithmic, level, marks, intervals, choose } = options;
    const all = curves.flatMap(({ values }) => values);
    const [low, high] = logarithmic ? decadesOf(all) : rangeOf(all);
    const height = (value: number): number => (logarithmic ? Math.log10(value) : value);
    const [first, last] = [times[0] ?? 0, times.at(-1) ?? 1];
    const span = last > first ? last - first : 1;
    const x = (t: number): number => LEFT + ((t - first) / span) * (WIDTH - LEFT - RIGHT);
    const y = (value: number): number => HEIGHT - BOTTOM - ((height(value) - low) / (high - low)) * (HEIGHT - TOP - BOTTOM);
    const svg = element("svg", { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, class: "plot", role: "img", "aria-label": title });
    const heading = element("text", { x: LEFT, y: 15, class: "title" }, title);
    if (unit !== "") heading.append(element("tspan", { class: "tick", dx: 6 }, `/ ${unit}`));
    svg.append(heading);
    for (const t of linearTicks(first, first + span)) {
      svg.append(element("line", { x1: x(t), x2: x(t), y1: TOP, y2: HEIGHT - BOTTOM, class: "grid" }));
      svg.append(element("text", { x: x(t), y: HEIGHT - BOTTOM + 14, class: "tick middle" }, tickText(t)));
    }
    svg.append(element("text", { x: (LEFT + WIDTH - RIGHT) / 2, y: HEIGHT - 4, class: "tick middle" }, time));
    for (const value of logarithmic ? powerTicks(low, high) : ticksOf(all)) {
      svg.append(element("line", { x1: x(first), x2: x(first + span), y1: y(value), y2: y(value), class: value === 0 ? "zero" : "grid" }));
      svg.append(element("text", { x: LEFT - 5, y: y(value) + 4, class: "tick end" }, tickText(value)));
    }
    for (const [start, end] of intervals) {
      svg.append(element("line", { x1: x(start), x2: x(end), y1: y(level), y2: y(level), class: "interval" }));
    }
    curves.forEach(({ values }, i) => {
      const drawn = values.map((value) => (value === null || (logarithmic && value <= 0) ? null : value));
      svg.append(element("path", { d: path(times, drawn, x, y), class: `curve curve-${i}` }));
    });
    this.cursor = element("line", { y1: TOP, y2: HEIGHT - BOTTOM, class: "cursor" });
    svg.append(this.cursor);
    for (const { t, accepted } of marks) {
      const mark = element("circle", { cx: x(t), cy: y(level), r: 4.5, class: accepted ? "accepted" : "rejected" });
      mark.append(element("title", {}, `${accepted ? "accepted" : "root of the cubic, no contact"}: t = ${t}`));
      svg.append(mark);
    }
    const point = (event: PointerEvent): void => {
      const { left, width } = svg.getBoundingClientRect();
      const at = (((event.clientX - left) / width) * WIDTH - LEFT) / (WIDTH - LEFT - RIGHT);
      choose(first + Math.min(Math.max(at, 0), 1) * (last - first));
    };
    svg.addEventListener("pointerdown", point);
    svg.addEventListener("pointermove", (event) => {
      if (event.buttons & 1) point(event);
    });
    this.x = x;
    this.element = document.createElement("div");
    this.element.append(svg);
    this.readings = this.legend();
    this.show(first);
  }

  /** A row for each curve, if there are several: its line, its name and its value. */
  private legend(): HTMLElement[] {
    const { curves } = this.options;
    if (curves.every(({ name }) => name === "")) return [];
    const rows = document.createElement("div");
    rows.className = "readings";
    const readings = curves.map(({ name }, i) => {
      const [row, line, value] = [document.createElement("div"), document.createElement("i"), document.createElement("b")];
      line.className = `curve-${i}`;
      row.append(line, `${name} `, value);
      rows.append(row);
      return value;
    });
    this.element.append(rows);
    return readings;
  }

  /** Moves the cursor, and shows the values of the last time that is not after it. */
  show(t: number): void {
    const x = String(this.x(t));
    this.cursor.setAttribute("x1", x);
    this.cursor.setAttribute("x2", x);
    const { curves, times, unit } = this.options;
    const at = lastBefore(times, t);
    this.readings.forEach((reading, i) => {
      const value = curves[i].values[at] ?? null;
      reading.textContent = value === null ? "–" : `${tickText(value)} ${unit}`.trim();
    });
  }
}

/** The curve through values. A value without neighbours is a dot. */
function path(times: number[], values: (number | null)[], x: (t: number) => number, y: (value: number) => number): string {
  return values
    .map((value, i) => {
      if (value === null) return "";
      const isStart = (values[i - 1] ?? null) === null;
      const isAlone = isStart && (values[i + 1] ?? null) === null;
      return `${isStart ? "M" : "L"}${x(times[i]).toFixed(2)} ${y(value).toFixed(2)}${isAlone ? "h0.01" : ""}`;
    })
    .join("");
}
