/** The exact answer beside the root finder's. */

import { type Verdict } from "./protocol";

export interface Difference {
  level: "same" | "early" | "wrong";
  text: string;
}

/** Times that differ by less than this count as the same, up to rounding. */
const ROUNDING = 1e-12;

/** The answer of the root finder, judged by the earliest exact contact time; null for no contact. */
export function compare(exact: number | null, { contact, time }: Verdict): Difference {
  if (exact === null && !contact) return { level: "same", text: "The root finder agrees: no contact." };
  if (exact === null) return { level: "wrong", text: "False contact: the root finder reports one, but there is none." };
  if (!contact) return { level: "wrong", text: "Missed contact: the root finder reports none." };
  if (time === null) return { level: "wrong", text: "The time of the root finder is not a number." };
  const late = time - exact;
  if (late === 0) return { level: "same", text: "The root finder agrees, to the last bit." };
  const size = Number(Math.abs(late).toPrecision(2));
  if (Math.abs(late) < ROUNDING) return { level: "same", text: roundingText(late, size) };
  if (late < 0) return { level: "early", text: `The root finder is early by ${size}: it stops motion that is free.` };
  return { level: "wrong", text: `The root finder is late by ${size}: the primitives have touched before.` };
}

function roundingText(late: number, size: number): string {
  const down = late > 0 ? " The exact time is rounded down, so that nothing touches before it." : "";
  return `The root finder agrees, up to rounding: ${late < 0 ? "−" : "+"}${size}.${down}`;
}

const MARKS: Record<Difference["level"], string> = { same: "✓", early: "!", wrong: "✗" };

export class VerdictPanel {
  constructor(
    private readonly exact: HTMLElement,
    private readonly finder: HTMLElement,
    private readonly difference: HTMLElement,
  ) {}

  /** Shows both answers; `finder` is null if the root finder has none for this kind, and undefined until it has one. */
  show(exact: number | null, finder: Verdict | null | undefined): void {
    this.exact.textContent = exact === null ? "no contact" : `t = ${exact}`;
    const unknown = finder === null ? "has no such kind" : "…";
    this.finder.textContent = !finder ? unknown : finder.contact ? `t = ${finder.time ?? "not a number"}` : "no contact";
    const { level, text } = finder ? compare(exact, finder) : { level: "none", text: "" };
    this.difference.dataset["level"] = level;
    this.difference.textContent = finder ? `${MARKS[level as Difference["level"]]} ${text}` : "";
    this.difference.hidden = !finder;
  }
}
