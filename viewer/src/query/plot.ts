/** A curve over t in [0, 1], as SVG. */

const NAMESPACE = "http://www.w3.org/2000/svg";
const [WIDTH, HEIGHT] = [340, 170];
const [LEFT, RIGHT, TOP, BOTTOM] = [52, 12, 26, 34];

export interface PlotOptions {
  title: string;
  unit: string;
  /** Values at equidistant times from 0 to 1; null where there is none. */
  values: (number | null)[];
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

/** The least and the largest value and zero, with a margin, so that the curve is not on the frame. */
export function rangeOf(values: (number | null)[]): [number, number] {
  const finite = values.filter((value) => value !== null);
  const [least, most] = [Math.min(0, ...finite), Math.max(0, ...finite)];
  if (least === most) return [-1, 1];
  const margin = 0.08 * (most - least);
  return [least - margin, most + margin];
}

/** Zero, and the extrema that are far enough from it for a text. */
export function ticksOf(values: (number | null)[]): number[] {
  const finite = values.filter((value) => value !== null);
  const [least, most] = [Math.min(0, ...finite), Math.max(0, ...finite)];
  return [0, ...[least, most].filter((value) => Math.abs(value) > 0.12 * (most - least))];
}

export function tickText(value: number): string {
  if (value === 0) return "0";
  const size = Math.abs(value);
  return size >= 1e4 || size < 1e-3 ? value.toExponential(1) : String(Number(value.toPrecision(3)));
}

export class Plot {
  readonly svg: SVGElement;
  private readonly cursor: SVGElement;

  constructor({ title, unit, values, level, marks, intervals, choose }: PlotOptions) {
    const [low, high] = rangeOf(values);
    const x = (t: number): number => LEFT + t * (WIDTH - LEFT - RIGHT);
    const y = (value: number): number => HEIGHT - BOTTOM - ((value - low) / (high - low)) * (HEIGHT - TOP - BOTTOM);
    const svg = element("svg", { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, class: "plot", role: "img", "aria-label": title });
    svg.append(element("text", { x: LEFT, y: 15, class: "title" }, title));
    for (const t of [0, 0.25, 0.5, 0.75, 1]) {
      svg.append(element("line", { x1: x(t), x2: x(t), y1: TOP, y2: HEIGHT - BOTTOM, class: "grid" }));
      svg.append(element("text", { x: x(t), y: HEIGHT - BOTTOM + 14, class: "tick middle" }, String(t)));
    }
    svg.append(element("text", { x: x(0.5), y: HEIGHT - 4, class: "tick middle" }, "time t"));
    for (const value of ticksOf(values)) {
      svg.append(element("line", { x1: x(0), x2: x(1), y1: y(value), y2: y(value), class: value === 0 ? "zero" : "grid" }));
      svg.append(element("text", { x: LEFT - 5, y: y(value) + 4, class: "tick end" }, tickText(value)));
    }
    svg.append(element("text", { x: 12, y: (TOP + HEIGHT - BOTTOM) / 2, class: "tick middle", transform: `rotate(-90 12 ${(TOP + HEIGHT - BOTTOM) / 2})` }, unit));
    for (const [start, end] of intervals) {
      svg.append(element("line", { x1: x(start), x2: x(end), y1: y(level), y2: y(level), class: "interval" }));
    }
    svg.append(element("path", { d: path(values, x, y), class: "curve" }));
    this.cursor = element("line", { y1: TOP, y2: HEIGHT - BOTTOM, class: "cursor" });
    svg.append(this.cursor);
    for (const { t, accepted } of marks) {
      const mark = element("circle", { cx: x(t), cy: y(level), r: 4.5, class: accepted ? "accepted" : "rejected" });
      mark.append(element("title", {}, `${accepted ? "accepted" : "root of the cubic, no contact"}: t = ${t}`));
      svg.append(mark);
    }
    const point = (event: PointerEvent): void => {
      const { left, width } = svg.getBoundingClientRect();
      const at = ((event.clientX - left) / width) * WIDTH;
      choose(Math.min(Math.max((at - LEFT) / (WIDTH - LEFT - RIGHT), 0), 1));
    };
    svg.addEventListener("pointerdown", point);
    svg.addEventListener("pointermove", (event) => {
      if (event.buttons & 1) point(event);
    });
    this.svg = svg;
    this.show(0);
  }

  /** Moves the cursor. */
  show(t: number): void {
    const x = String(LEFT + t * (WIDTH - LEFT - RIGHT));
    this.cursor.setAttribute("x1", x);
    this.cursor.setAttribute("x2", x);
  }
}

function path(values: (number | null)[], x: (t: number) => number, y: (value: number) => number): string {
  let pen = "M";
  const parts: string[] = [];
  values.forEach((value, i) => {
    if (value === null) {
      pen = "M";
      return;
    }
    parts.push(`${pen}${x(i / (values.length - 1)).toFixed(2)} ${y(value).toFixed(2)}`);
    pen = "L";
  });
  return parts.join("");
}
