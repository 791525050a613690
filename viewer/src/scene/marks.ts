/** The marks of the selected contact: its two primitives, the paths of their vertices, the point and the normal. */

import { DoubleSide, Group, type Material, Mesh, MeshBasicMaterial, Points, PointsMaterial } from "three";
import { LineMaterial } from "three/examples/jsm/lines/LineMaterial.js";
import { LineSegments2 } from "three/examples/jsm/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/examples/jsm/lines/LineSegmentsGeometry.js";
import { type MarkColours } from "../colours";
import { type Point } from "../page";
import { add, cross, length, mix, subtract, times, unit } from "../vector";
import { disc } from "./disc";
import { geometryOf, squareOf } from "./planes";

/** Points at both ends of a step. */
export interface Moving {
  start: Point[];
  end: Point[];
}

/** Two primitives that are marked, in units of the page. */
export interface Marked {
  /** The vertices of both primitives, and the corners of the faces around them. A half space has none: it is marked by
   * a square of its boundary. */
  primitives: (Moving & { around: Moving })[];
  /** The points that touch, or are closest; none for primitives that do not touch. */
  closest: [Point, Point] | null;
  normal: Point | null;
}

/** Marks around an origin near them, so that single precision suffices at any magnification. */
export class Marks {
  readonly group = new Group();
  /** Materials are kept: a new one would be compiled again. */
  private readonly materials = new Map<string, Material>();

  /** Draws marks at time t, in place of the ones before. Marks of points alone have the size `alone`. */
  draw({ primitives, closest, normal }: Marked, t: number, paths: boolean, colours: MarkColours, alone: number): void {
    this.clear();
    const origin = closest?.[0] ?? primitives[0].start[0];
    this.group.position.set(...origin);
    const local = (p: Point): Point => subtract(p, origin);
    const sides = [colours.first, colours.second];
    const at = ({ start, end }: Moving): Point[] => start.map((vertex, i) => local(mix(vertex, end[i], t)));
    const corners = primitives.map(at);
    const size = sizeOf(corners) || sizeOf(primitives.map(({ around }) => at(around))) || alone;
    primitives.forEach(({ start, end, around }, side) => {
      const own = corners[side];
      if (paths) {
        this.lines(start.flatMap((vertex, i) => [local(vertex), local(end[i])]), colours.path, 2, size);
        this.points(start.map(local), colours.path, 5);
        this.points(end.map(local), colours.path, 9);
      }
      if (own.length === 0 && normal !== null && closest !== null) {
        const [a, b, c, d] = squareOf(local(closest[side]), normal, 0.35 * size);
        this.faces([a, b, c, a, c, d], sides[side], 0.3);
        this.lines([a, b, b, c, c, d, d, a], sides[side], 3);
      }
      this.faces(at(around), sides[side], 0.22);
      if (own.length === 3) this.faces(own, sides[side], 0.5);
      if (own.length > 1) this.lines(own.flatMap((vertex, i) => [vertex, own[(i + 1) % own.length]]), sides[side], 4);
      this.points(own, sides[side], 15);
    });
    // The normal of a half space begins at its boundary, and the normal of another contact at the contact point.
    const foot = corners[1].length === 0 && closest !== null ? local(closest[1]) : ([0, 0, 0] as const);
    if (normal !== null && size > 0) this.arrow(foot, times(0.45 * size, normal), colours.normal);
    if (closest !== null) {
      const [first, second] = closest.map(local);
      this.lines([first, second], colours.contact, 3);
      this.points([first, second], colours.contact, 10, 20);
    }
  }

  clear(): void {
    for (const child of [...this.group.children]) {
      this.group.remove(child);
      (child as Mesh).geometry.dispose();
    }
  }

  /** Triangles, three corners each. */
  private faces(corners: Point[], color: string, opacity: number): void {
    if (corners.length === 0) return;
    const material = this.material(`faces ${color} ${opacity}`, () => {
      return new MeshBasicMaterial({ color, side: DoubleSide, transparent: true, opacity, depthWrite: false });
    });
    this.group.add(new Mesh(geometryOf(corners), material));
  }

  /** Discs of a size in pixels. Discs of a higher order are in front of all others. */
  private points(at: Point[], color: string, size: number, order = size): void {
    const material = this.material(`points ${color} ${size}`, () => {
      const depthTest = order < 12;
      return new PointsMaterial({ color, size, depthTest, sizeAttenuation: false, map: disc(), alphaTest: 0.4, transparent: true });
    });
    const points = new Points(geometryOf(at), material);
    points.renderOrder = order;
    this.group.add(points);
  }

  /** Segments between consecutive pairs of points; dashed, if a length in proportion to the dashes is given. */
  private lines(ends: Point[], color: string, linewidth: number, dash = 0, depthTest = true): void {
    const geometry = new LineSegmentsGeometry();
    geometry.setPositions(ends.flat());
    const dashed = dash > 0;
    const material = this.material(`lines ${color} ${linewidth} ${dashed} ${depthTest}`, () => {
      return new LineMaterial({ color, linewidth, dashed, depthTest, transparent: !depthTest });
    });
    if (dashed) [material.dashSize, material.gapSize] = [0.05 * dash, 0.03 * dash];
    const lines = new LineSegments2(geometry, material);
    if (dash > 0) lines.computeLineDistances();
    lines.frustumCulled = false;
    // Lines that faces do not hide are drawn after them.
    lines.renderOrder = depthTest ? 0 : 1;
    this.group.add(lines);
  }

  private material<M extends Material>(key: string, make: () => M): M {
    const known = this.materials.get(key) ?? make();
    this.materials.set(key, known);
    return known as M;
  }

  private arrow(foot: Point, along: Point, color: string): void {
    const side = unit(cross(along, Math.abs(along[0]) < 0.7 * length(along) ? [1, 0, 0] : [0, 1, 0]), [1, 0, 0]);
    const [tip, back] = [add(foot, along), add(foot, times(0.82, along))];
    const wing = times(0.08 * length(along), side);
    this.lines([foot, tip, tip, add(back, wing), tip, subtract(back, wing)], color, 3, 0, false);
  }
}

/** The greatest distance of a corner from the first one of its primitive. */
function sizeOf(corners: Point[][]): number {
  return Math.max(...corners.flatMap((own) => own.map((vertex) => length(subtract(vertex, own[0])))), 0);
}
