/** The places of the camera. */

import { type Point } from "../page";
import { add, cross, dot, length, subtract, times, unit } from "../vector";

export interface Pose {
  target: Point;
  position: Point;
}

/** The vertical angle of the camera, in degrees. */
export const ANGLE = 35;

/** The distance at which a ball of this radius fills this fraction of the height. */
function distanceFor(radius: number, fraction: number): number {
  return radius / fraction / Math.sin((ANGLE / 2) * (Math.PI / 180));
}

/** A view of everything: from the front, the right and above. */
export function overview(center: Point, radius: number, up: Point): Pose {
  const right = unit(cross(Math.abs(up[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0], up), [0, 0, 1]);
  const towards = unit(add(add(times(0.55, cross(right, up)), times(-1, right)), times(0.6, up)), [0, 0, 1]);
  return { target: center, position: add(center, times(distanceFor(radius, 0.8), towards)) };
}

/** The angle between the contact plane and the view of the camera. */
const ELEVATION = (40 / 180) * Math.PI;

/** The preference for a view from above over a view from outside. */
const ABOVE = 1.1;

/** The number of directions around the normal, on each side of the plane, among which the camera has the best. */
const DIRECTIONS = 12;

/**
 * A view of a contact, with the contact point in the middle.
 *
 * The camera looks along the contact plane, from somewhat above it, so that the gap between the primitives can be
 * seen as it closes. It is on the outer side of the mesh, and away from the axis around which it turns, as far as
 * this leaves a choice. A ball around `vertices` fills a fraction of the height. A `line` along which the primitives lie is
 * not seen end-on.
 */
export function contactPose(
  point: Point,
  normal: Point | null,
  vertices: Point[],
  center: Point,
  radius: number,
  up: Point,
  fraction: number,
  line: Point = [0, 0, 0],
): Pose {
  const outwards = unit(add(unit(subtract(point, center), up), times(ABOVE, up)), up);
  const n = unit(normal ?? outwards, up);
  const x = unit(cross(n, Math.abs(n[0]) < 0.7 ? [1, 0, 0] : [0, 1, 0]), [1, 0, 0]);
  const y = cross(n, x);
  const value = (towards: Point): number => dot(towards, outwards) - 8 * Math.max(Math.abs(dot(towards, up)) - 0.8, 0);
  const towards = [1, -1].flatMap((side) =>
    Array.from({ length: DIRECTIONS }, (_, i): Point => {
      const angle = ((i + 0.3) / DIRECTIONS) * 2 * Math.PI;
      const along = add(times(Math.cos(angle), x), times(Math.sin(angle), y));
      return add(times(Math.cos(ELEVATION), along), times(side * Math.sin(ELEVATION), n));
    }),
  );
  const seen = (towards: Point): number => value(towards) - 4 * Math.max(Math.abs(dot(towards, line)) - 0.4, 0);
  const best = towards.reduce((a, b) => (seen(b) > seen(a) ? b : a));
  const extent = Math.max(...vertices.map((vertex) => length(subtract(vertex, point))));
  // Points alone have no extent.
  const size = extent > 1e-9 * radius ? Math.max(extent, 1e-4 * radius) : 0.15 * radius;
  return { target: point, position: add(point, times(distanceFor(size, fraction), best)) };
}

/** The direction of a line that all points lie along, nearly; zero if there is none. */
export function commonLine(points: Point[]): Point {
  const [first] = points;
  if (first === undefined) return [0, 0, 0];
  const far = points.reduce((a, b) => (length(subtract(b, first)) > length(subtract(a, first)) ? b : a));
  const along = unit(subtract(far, first), [0, 0, 0]);
  const off = points.map((point) => length(cross(subtract(point, first), along)));
  return Math.max(...off) < 0.05 * length(subtract(far, first)) ? along : [0, 0, 0];
}

/** The least angle between the view and the direction upwards, in radians. */
const STEEPEST = 0.02;

/** The pose after a turn around its target: to the right around the axis upwards, and upwards, in radians. */
export function turned({ target, position }: Pose, up: Point, right: number, above: number): Pose {
  const away = subtract(position, target);
  const distance = length(away);
  const height = Math.asin(Math.min(Math.max(dot(away, up) / distance, -1), 1));
  const level = unit(subtract(away, times(dot(away, up), up)), unit(cross(up, [up[1], up[2], up[0]]), [1, 0, 0]));
  const side = cross(up, level);
  const most = Math.PI / 2 - STEEPEST;
  const angle = Math.min(Math.max(height + above, -most), most);
  const towards = add(times(Math.cos(right), level), times(Math.sin(right), side));
  const turnedAway = add(times(distance * Math.cos(angle), towards), times(distance * Math.sin(angle), up));
  return { target, position: add(target, turnedAway) };
}

/** The pose moved across the view, to the right and upwards, in units of the distance of its target. */
export function moved({ target, position }: Pose, up: Point, right: number, above: number): Pose {
  const away = subtract(position, target);
  const side = unit(cross(up, away), [1, 0, 0]);
  const head = unit(cross(away, side), up);
  const by = times(length(away), add(times(right, side), times(above, head)));
  return { target: add(target, by), position: add(position, by) };
}

/** The pose nearer to its target by a factor. */
export function magnified({ target, position }: Pose, factor: number): Pose {
  return { target, position: add(target, times(1 / factor, subtract(position, target))) };
}
