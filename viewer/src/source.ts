/** The data of a page from its texts, which are elements of the page or come from the kernel. */

import { decodeElements, decodeFloats } from "./binary";
import { Frames } from "./frames";
import { type Page, parsePage } from "./page";
import { Incidence } from "./incidence";
import { groupsOf, looseVertices, type Parts, partsOf } from "./parts";
import { type Elements } from "./scene/mesh";

/** The text of an id. */
export type Source = (id: string) => string;

/** All that a page shows. */
export interface Shown {
  page: Page;
  frames: Frames;
  elements: Elements;
  parts: Parts;
  /** The parts with a colour of their own. */
  groups: Parts;
  incidence: Incidence;
  /** The place of a contact on the scale of times, from 0 for the earliest to 1 for the latest. */
  place: (contact: number) => number;
}

export async function read(source: Source): Promise<Shown> {
  const page = parsePage(source("page"));
  const [faces, edges, radii, first] = await Promise.all([
    decodeElements(source("faces"), 3),
    decodeElements(source("edges"), 2),
    decodeFloats(source("radii")),
    decodeFloats(source("frame-0")),
  ]);
  const frames = new Frames(page, first, (frame) => decodeFloats(source(`frame-${frame}`)));
  const points = looseVertices(page.vertices, faces, edges) as Uint32Array<ArrayBuffer>;
  const parts = partsOf(page.vertices, faces, edges);
  const groups = groupsOf(parts, page.bodies, points);
  const incidence = new Incidence(page.vertices, faces);
  return { page, frames, elements: { faces, edges, points, radii }, parts, groups, incidence, place: placesOf(page) };
}

function placesOf({ contacts }: Page): (contact: number) => number {
  const places = contacts.map(({ frame, time }) => frame + time);
  const least = places.reduce((a, b) => Math.min(a, b), Infinity);
  const most = places.reduce((a, b) => Math.max(a, b), -Infinity);
  return (contact) => (most > least ? (places[contact] - least) / (most - least) : 0);
}
