/** The data of a page, as the crate exact-ccd-view writes it. */

import { type Kind } from "./kinds";

export type Point = readonly [number, number, number];

/** A vertex, an edge or a face of the mesh, or a half space, which has no vertices. */
export interface Primitive {
  kind: "vertex" | "edge" | "face" | "half-space";
  /** Its id in the file, or of an edge in the mesh, from 0; none in a query and for a side of a solid. Of a half
   * space, its place in the list of them. */
  id: number | null;
  /** Its vertices in the mesh of the page, from 0. */
  vertices: number[];
  /** The ids of these vertices in the file. */
  labels: number[];
}

/** Two primitives that touch. */
export interface Contact {
  /** The index among `frames` of the frame at which the step of the contact begins. */
  frame: number;
  /** The time in this step, rounded down: 0 at the frame, 1 at the next one. */
  time: number;
  primitives: [Primitive, Primitive];
  /** The points of both primitives that touch, or are closest. */
  closest: [Point, Point];
  /** Their distance, rounded down. */
  distance: number;
  /** The unit normal, from the second primitive towards the first. */
  normal: Point | null;
  /** None for contacts of a frame at rest. */
  parameters: [number, number] | null;
}

/** A part of the mesh with a name: the vertices from `start` to `end`, without the latter. */
export interface Body {
  name: string;
  kind: string;
  vertices: { start: number; end: number };
}

/** All points x with n · (x − p) ≤ 0, for a point p of the boundary and its unit normal n. */
export interface HalfSpace {
  name: string;
  point: Point;
  normal: Point;
}

/** A quantity over time: a value for each frame, or none. */
export interface Curve {
  name: string;
  values: (number | null)[];
}

/** Quantities with the same unit. */
export interface Chart {
  title: string;
  unit: string;
  logarithmic: boolean;
  curves: Curve[];
}

/** Charts over time; `times` has the time of each frame, in s. */
export interface History {
  times: number[];
  charts: Chart[];
}

/** Two primitives in motion, with the answers about them. */
export interface Query {
  kind: Kind;
  /** The four points at t = 0 and at t = 1. A vertex in place of an edge occurs twice. */
  points: [Point[], Point[]];
  primitives: [Primitive, Primitive];
  /** The stage that decided. */
  stage: string;
  /** The distance at which primitives count as touching. */
  separation: number;
  /** The intervals of contact, their ends rounded down; both ends are the same for a moment. */
  times: [number, number][];
  /** The distance of the primitives at equidistant times from 0 to 1; null above all f64. */
  distances: (number | null)[];
}

/** The frame of a motion. */
export interface Frame {
  /** Its number, from 0. Frames may have been left out. */
  number: number;
  label: string;
}

/** All of a page but the mesh and its positions. */
export interface Page {
  format: 2;
  title: string;
  /** The line of the answer; empty for the first line of the summary. */
  verdict: string;
  /** Lines about the answer. */
  summary: string[];
  up: Point;
  vertices: number;
  faces: number;
  /** The edges of no face. */
  edges: number;
  /** Positions of the mesh are center + scale · (x, y, z). */
  center: Point;
  scale: number;
  /** Empty, if the connected parts have no names. */
  bodies: Body[];
  halfSpaces: HalfSpace[];
  history: History | null;
  frames: Frame[];
  contacts: Contact[];
  /** The number of all contacts; `contacts` has the earliest. */
  contactCount: number;
  query: Query | null;
}

/** The page in the JSON text, or an error if another version of the program wrote it. */
export function parsePage(text: string): Page {
  const page = JSON.parse(text) as Page;
  if (page.format !== 2) {
    throw new Error(`the data of this page has format ${String(page.format)}, expected 2`);
  }
  // The program writes the number of a frame; its index is less if frames were left out.
  const indices = new Map(page.frames.map(({ number }, index) => [number, index]));
  for (const contact of page.contacts) contact.frame = indices.get(contact.frame) ?? 0;
  return page;
}
