/** The coplanarity cubic of a query in floating point, for its plot. The answers of the page do not depend on it. */

import { KINDS } from "../kinds";
import { type Point, type Query } from "../page";
import { cross, dot, subtract, times } from "../vector";

/** The Bernstein coefficients on [0, 1], divided by the cube of the largest difference of coordinates. */
export function cubicOf({ kind, points }: Query): number[] {
  const differences = points.map((at) => KINDS[kind].span.map(([i, j]) => halfDifference(at[i], at[j])));
  const size = Math.max(...differences.flat(2).map(Math.abs));
  const unit = size > 0 ? size : 1;
  const scaled = differences.map((all) => all.map((difference) => divide(difference, unit)));
  const det = (w: number, e1: number, e2: number): number =>
    dot(scaled[w][0], cross(scaled[e1][1], scaled[e2][2]));
  return [
    det(0, 0, 0),
    (det(1, 0, 0) + det(0, 1, 0) + det(0, 0, 1)) / 3,
    (det(1, 1, 0) + det(1, 0, 1) + det(0, 1, 1)) / 3,
    det(1, 1, 1),
  ];
}

/** Half of a − b, which is finite. */
function halfDifference(a: Point, b: Point): Point {
  return subtract(times(0.5, a), times(0.5, b));
}

/** Not a product with 1 / unit, which may overflow. */
function divide(a: Point, unit: number): Point {
  return [a[0] / unit, a[1] / unit, a[2] / unit];
}

/** The value of a polynomial with these Bernstein coefficients, by de Casteljau's algorithm. */
export function bernstein(coefficients: number[], t: number): number {
  let row = coefficients;
  while (row.length > 1) row = row.slice(1).map((next, i) => (1 - t) * row[i] + t * next);
  return row[0];
}

/** A value below this fraction of the largest coefficient counts as zero where the cubic has an extremum. */
const NOISE = 1e-12;

/** The roots in [0, 1] of the cubic with these Bernstein coefficients; none if it vanishes. */
export function rootsOf(coefficients: number[]): number[] {
  const size = Math.max(...coefficients.map(Math.abs));
  if (size === 0) return [];
  const value = (t: number): number => bernstein(coefficients, t);
  const vanishes = (t: number): boolean => Math.abs(value(t)) <= NOISE * size;
  const places = [0, ...extrema(coefficients), 1];
  const roots = places.filter(vanishes);
  for (let i = 0; i + 1 < places.length; i++) {
    const [a, b] = [places[i], places[i + 1]];
    if (!vanishes(a) && !vanishes(b) && value(a) > 0 !== value(b) > 0) roots.push(bisect(value, a, b));
  }
  return roots.sort((a, b) => a - b).filter((root, i, all) => i === 0 || root - all[i - 1] > 1e-9);
}

/** The zeros of the derivative inside (0, 1), in increasing order. */
function extrema([a, b, c, d]: number[]): number[] {
  const [p, q, r] = [b - a, c - b, d - c]; // Bernstein coefficients of a third of the derivative
  const [square, half, constant] = [p - 2 * q + r, q - p, p]; // square t² + 2 half t + constant
  const discriminant = half * half - square * constant;
  if (discriminant < 0) return [];
  const sum = -(half + (half < 0 ? -1 : 1) * Math.sqrt(discriminant));
  return [sum / square, constant / sum].filter((t) => t > 0 && t < 1).sort((s, t) => s - t);
}

function bisect(value: (t: number) => number, a: number, b: number): number {
  const rises = value(b) > 0;
  for (let i = 0; i < 60; i++) {
    const middle = 0.5 * (a + b);
    if (value(middle) > 0 === rises) b = middle;
    else a = middle;
  }
  return 0.5 * (a + b);
}
