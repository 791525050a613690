/** Data for tests. */

import { type Page } from "../src/page";

/** A page without contacts, whose frames have these numbers. */
export const pageOf = (numbers: number[]): Page => ({
  format: 2,
  title: "",
  verdict: "",
  summary: [],
  up: [0, 0, 1],
  vertices: 1,
  faces: 0,
  edges: 0,
  center: [0, 0, 0],
  scale: 1,
  bodies: [],
  halfSpaces: [],
  history: null,
  frames: numbers.map((number) => ({ number, label: `${number} s` })),
  contacts: [],
  contactCount: 0,
  query: null,
});
