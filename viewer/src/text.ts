/** The texts of contacts and moments. */

import { type Contact, type Page, type Primitive } from "./page";
import { type Moment } from "./frames";

/** Seven significant digits. */
export function short(number: number): string {
  if (number === 0) return "0";
  return Number(number.toPrecision(7)).toString();
}

export function primitiveText({ kind, id, labels }: Primitive): string {
  const name = id === null ? kind : `${kind} ${id}`;
  return kind === "vertex" ? name : `${name} (vertices ${labels.join(", ")})`;
}

/** The time of a contact, with the frames between which it is if there are more than two. */
export function timeText(page: Page, { frame, time }: Contact): string {
  if (page.frames.length === 2) return `t = ${frame + time}`;
  return `${stepText(page, frame)}t = ${time}`;
}

function stepText(page: Page, frame: number): string {
  const [start, end] = [page.frames[frame], page.frames[frame + 1]];
  if (page.frames.length === 1) return "";
  return end === undefined ? `frame ${start.number}, ` : `frame ${start.number} to ${end.number}, `;
}

export function momentText(page: Page, { frame, t }: Moment): string {
  if (page.frames.length === 1) return page.frames[0].label;
  if (page.frames.length === 2) return `t = ${short(frame + t)}`;
  const at = page.frames[frame + t];
  return at === undefined ? `${stepText(page, frame)}t = ${short(t)}` : `frame ${at.number}: ${at.label}`;
}

/** The ids of a contact, by which the list is searched: its primitives and vertices. */
export function contactIds({ primitives }: Contact): number[] {
  const ids = primitives.flatMap(({ id, labels }) => (id === null ? labels : [id, ...labels]));
  return [...new Set(ids)];
}
