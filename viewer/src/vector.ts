/** Vectors of three numbers. */

import { type Point } from "./page";

export const add = (a: Point, b: Point): Point => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const subtract = (a: Point, b: Point): Point => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const times = (s: number, a: Point): Point => [s * a[0], s * a[1], s * a[2]];
export const dot = (a: Point, b: Point): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const length = (a: Point): number => Math.hypot(a[0], a[1], a[2]);
export const cross = (a: Point, b: Point): Point => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
/** (1 − t) a + t b. */
export const mix = (a: Point, b: Point, t: number): Point => add(times(1 - t, a), times(t, b));
/** The unit vector in the direction of `a`, or `otherwise` if `a` has no direction. */
export const unit = (a: Point, otherwise: Point): Point => {
  const size = length(a);
  return size > 0 && Number.isFinite(1 / size) && Number.isFinite(size) ? times(1 / size, a) : otherwise;
};
