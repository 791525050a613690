/** The image of the domain under F: the differences of all points of two primitives at all times. */

import { KINDS } from "../kinds";
import { type Point, type Query } from "../page";
import { mix, subtract } from "../vector";

/** The image, in units of its largest coordinate, so that no number overflows. */
export class DomainImage {
  private readonly ends: [Point[], Point[]];

  constructor({ kind, points }: Query) {
    const size = Math.max(...points.flat(2).map(Math.abs), Number.MIN_VALUE);
    const scaled = points.map((at) => at.map(([x, y, z]): Point => [x / size, y / size, z / size]));
    const corners = scaled.map((at) => KINDS[kind].corners.map(([i, j]) => subtract(at[i], at[j])));
    const largest = Math.max(...corners.flat(2).map(Math.abs));
    const unit = largest > 0 ? largest : 1;
    const [start, end] = corners.map((at) => at.map(([x, y, z]): Point => [x / unit, y / unit, z / unit]));
    this.ends = [start, end];
  }

  /** The corners of the image at time t. */
  at(t: number): Point[] {
    const [start, end] = this.ends;
    return start.map((corner, i) => mix(corner, end[i], t));
  }

  /** The triangles of the image at time t, as nine coordinates each. */
  slice(t: number): number[] {
    const [first, ...rest] = this.at(t);
    if (rest.length < 2) return rest.flatMap((corner) => [...first, ...corner, ...first]);
    return rest.slice(1).flatMap((corner, i) => [...first, ...rest[i], ...corner]);
  }

  /** The triangles of the surfaces that the sides of the image sweep: ruled, and bilinear. */
  sides(steps: number): number[] {
    const rows = Array.from({ length: steps + 1 }, (_, i) => this.at(i / steps));
    const across = (row: Point[], side: number, j: number): Point =>
      mix(row[side], row[(side + 1) % row.length], j / steps);
    const triangles: number[] = [];
    for (let side = 0; side < rows[0].length; side++) {
      for (let i = 0; i < steps; i++) {
        for (let j = 0; j < steps; j++) {
          const [a, b] = [across(rows[i], side, j), across(rows[i], side, j + 1)];
          const [c, d] = [across(rows[i + 1], side, j), across(rows[i + 1], side, j + 1)];
          triangles.push(...a, ...b, ...d, ...a, ...d, ...c);
        }
      }
    }
    return triangles;
  }

  /** The line segments of the outline: both ends in time, and the paths of the corners. */
  outline(): number[] {
    const [start, end] = this.ends;
    const around = (at: Point[]): number[] => at.flatMap((corner, i) => [...corner, ...at[(i + 1) % at.length]]);
    return [...around(start), ...around(end), ...start.flatMap((corner, i) => [...corner, ...end[i]])];
  }
}
