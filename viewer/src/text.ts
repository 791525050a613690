/** The texts of contacts and moments. */

import { KINDS, pointNames } from "./kinds";
import { type Body, type Contact, type Page, type Primitive } from "./page";
import { type Moment } from "./frames";

/** Seven significant digits. */
export function short(number: number): string {
  if (number === 0) return "0";
  return Number(number.toPrecision(7)).toString();
}

/** The name of a vertex of a primitive: its id in the file, or the name of a point of a query. */
export function vertexName({ query }: Page, { vertices, labels }: Primitive, i: number): string {
  if (query === null) return String(labels[i]);
  return pointNames(query.kind)[KINDS[query.kind].layout[vertices[i]]];
}

/** The name of a primitive with its vertices, and the body or the half space that it is of, if that has a name. */
export function primitiveText(primitive: Primitive, page: Page): string {
  const { kind, id, vertices } = primitive;
  const what = kind.replace("-", " ");
  const name = id === null ? what : `${what} ${id}`;
  const names = vertices.map((_, i) => vertexName(page, primitive, i));
  const text = names.length > 1 ? `${name} (vertices ${names.join(", ")})` : name;
  const owner = kind === "half-space" ? page.halfSpaces[id ?? 0]?.name : bodyOf(page, vertices[0])?.name;
  return owner ? `${text} of ${owner}` : text;
}

/** The body of a vertex. */
export function bodyOf({ bodies }: Page, vertex: number): Body | undefined {
  return bodies.find(({ vertices: { start, end } }) => start <= vertex && vertex < end);
}

/** The time of a contact, with the frames between which it is if there are more than two, or the frame if it is at
 * rest in one. */
export function timeText(page: Page, { frame, time, parameters }: Contact): string {
  if (parameters === null && time === 0 && page.query === null && page.frames.length !== 2) return restText(page, frame);
  if (page.frames.length === 2) return `t = ${frame + time}`;
  return `${stepText(page, frame)}t = ${time}`;
}

function restText({ frames }: Page, frame: number): string {
  const { number, label } = frames[frame];
  return label === `frame ${number}` ? label : `frame ${number}: ${label}`;
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
  return at === undefined ? `${stepText(page, frame)}t = ${short(t)}` : restText(page, frame + t);
}

/** The ids of a contact, by which the list is searched: its primitives and vertices. */
export function contactIds({ primitives }: Contact): number[] {
  const ids = primitives.flatMap(({ id, labels }) => (id === null ? labels : [id, ...labels]));
  return [...new Set(ids)];
}
