/** A query that is edited. */

import { type Kind, pointNames } from "../kinds";

export interface Entry {
  kind: Kind;
  /** The points at t = 0, then at t = 1, in the order of the kind. */
  coordinates: Float64Array;
  /** The distance at which primitives count as touching. */
  distance: number;
  /** The distance that the root finder adds to it. */
  tolerance: number;
}

/** The number of points of a kind at one time. */
export function pointCount(kind: Kind): number {
  return pointNames(kind).length;
}

/** A copy of coordinates in which some are replaced. */
export function replaced(coordinates: Float64Array, values: Iterable<[index: number, value: number]>): Float64Array {
  const copy = coordinates.slice();
  for (const [index, value] of values) copy[index] = value;
  return copy;
}
