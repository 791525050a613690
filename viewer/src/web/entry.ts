/** A query that is edited. */

import { type Kind } from "./protocol";

export interface Entry {
  kind: Kind;
  /** The points at t = 0, then at t = 1, in the order of the kind. */
  coordinates: Float64Array;
  /** The distance at which primitives count as touching. */
  distance: number;
  /** The distance that the root finder adds to it. */
  tolerance: number;
}

/** The names of the points of a kind, by primitive. */
export const POINTS: Record<Kind, { first: string[]; second: string[] }> = {
  "vertex-face": { first: ["p"], second: ["v₁", "v₂", "v₃"] },
  "edge-edge": { first: ["a₀", "a₁"], second: ["b₀", "b₁"] },
  "vertex-edge": { first: ["p"], second: ["a", "b"] },
  "vertex-vertex": { first: ["p"], second: ["q"] },
};

/** The number of points of a kind at one time. */
export function pointCount(kind: Kind): number {
  return POINTS[kind].first.length + POINTS[kind].second.length;
}

/** A copy of coordinates in which some are replaced. */
export function replaced(coordinates: Float64Array, values: Iterable<[index: number, value: number]>): Float64Array {
  const copy = coordinates.slice();
  for (const [index, value] of values) copy[index] = value;
  return copy;
}
