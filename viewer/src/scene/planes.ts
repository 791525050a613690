/** Half spaces, as squares of their boundaries with lines at equal distances. */

import { BufferAttribute, BufferGeometry, Color, DoubleSide, Group, LineBasicMaterial, LineSegments, Mesh, MeshBasicMaterial } from "three";
import { type Point } from "../page";
import { add, cross, dot, subtract, times, unit } from "../vector";

/** A point of a plane, and its unit normal, in units of the page. */
export interface Plane {
  point: Point;
  normal: Point;
}

/** The half side of a square, in radii of the scene, and the number of lines on each side of the middle. */
const [HALF, LINES] = [1.6, 8];

const COLOUR = "#8c96a0";

/** The point of a plane nearest to a point. */
export function foot({ point, normal }: Plane, x: Point): Point {
  return subtract(x, times(dot(normal, subtract(x, point)), normal));
}

/** Two unit vectors in a plane: the three are a right-handed system. */
export function axesOf(normal: Point): [Point, Point] {
  const least = [0, 1, 2].reduce((a, b) => (Math.abs(normal[b]) < Math.abs(normal[a]) ? b : a));
  const axis: Point = [least === 0 ? 1 : 0, least === 1 ? 1 : 0, least === 2 ? 1 : 0];
  const side = unit(cross(axis, normal), [1, 0, 0]);
  return [side, cross(normal, side)];
}

/** The corners of a square around a point of a plane, counterclockwise for a viewer at whom the normal points. */
export function squareOf(middle: Point, normal: Point, half: number): Point[] {
  const [a, b] = axesOf(normal);
  const at = (x: number, y: number): Point => add(middle, add(times(x * half, a), times(y * half, b)));
  return [at(-1, -1), at(1, -1), at(1, 1), at(-1, 1)];
}

export class Planes {
  readonly group = new Group();
  private readonly area = new MeshBasicMaterial({ color: new Color(COLOUR), side: DoubleSide, transparent: true, opacity: 0.16, depthWrite: false });
  private readonly lines = new LineBasicMaterial({ color: new Color(COLOUR), transparent: true, opacity: 0.55 });

  /** Draws the boundaries beneath a ball. */
  draw(planes: Plane[], middle: Point, radius: number): void {
    for (const child of this.group.children) (child as Mesh).geometry.dispose();
    this.group.clear();
    const half = HALF * radius;
    for (const plane of planes) {
      const { normal } = plane;
      const center = foot(plane, middle);
      const corners = squareOf(center, normal, half);
      const area = new Mesh(geometryOf([0, 1, 2, 0, 2, 3].map((i) => corners[i])), this.area);
      const [a, b] = axesOf(normal);
      const ends = Array.from({ length: 2 * LINES + 1 }, (_, i) => (half * (i - LINES)) / LINES).flatMap((x) =>
        [a, b].flatMap((axis, i) => {
          const from = add(center, times(x, axis));
          const along = times(half, [b, a][i]);
          return [subtract(from, along), add(from, along)];
        }),
      );
      this.group.add(area, new LineSegments(geometryOf(ends), this.lines));
    }
    for (const child of this.group.children) child.frustumCulled = false;
  }
}

/** Points in one array. */
export function geometryOf(points: Point[]): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(Float32Array.from(points.flat()), 3));
  return geometry;
}
