/** Handles at both ends of the paths of points, which can be dragged. */

import { BufferAttribute, BufferGeometry, Color, Points, PointsMaterial, Raycaster, Vector2, Vector3 } from "three";
import { MARKS, type Theme } from "../colours";
import { type Frames } from "../frames";
import { KINDS } from "../kinds";
import { type Point } from "../page";
import { disc, ring } from "../scene/disc";
import { type View } from "../scene/view";
import { type Entry, pointCount, replaced } from "./entry";

/** The distance from a handle at which it is taken, in pixels. */
const NEAR = 16;

/** The sizes of the handles in pixels: rings at t = 0, discs at t = 1. */
const SIZES = [20, 20];

/** A handle that is dragged: its point, or both ends of its path. */
interface Drag {
  indices: number[];
  /** Where it was, in the world: the units of the page change with the query. */
  from: Point;
  before: Float64Array;
  scale: number;
}

export class Handles {
  private entry: Entry | null = null;
  private frames: Frames | null = null;
  private drag: Drag | null = null;
  private readonly points = SIZES.map((size, time) => {
    const material = new PointsMaterial({ size, vertexColors: true, sizeAttenuation: false, map: time === 0 ? ring() : disc(), alphaTest: 0.4, depthTest: false, transparent: true });
    const points = new Points(new BufferGeometry(), material);
    points.frustumCulled = false;
    // In front of the marks of the contact.
    points.renderOrder = 100;
    return points;
  });

  constructor(
    private readonly canvas: HTMLElement,
    private readonly view: View,
    private readonly change: (coordinates: Float64Array) => void,
  ) {
    for (const points of this.points) view.addMark(points);
    // Before the camera's controls, which listen on the canvas.
    const parent = canvas.parentElement ?? canvas;
    parent.addEventListener("pointerdown", (event) => this.take(event), { capture: true });
    parent.addEventListener("pointermove", (event) => this.move(event), { capture: true });
    for (const end of ["pointerup", "pointercancel"] as const) {
      parent.addEventListener(end, () => (this.drag = null), { capture: true });
    }
  }

  /** Shows the handles of a query; none for null. */
  show(entry: Entry | null, frames: Frames, theme: Theme): void {
    [this.entry, this.frames] = [entry, frames];
    const { first = [], second = [] } = entry === null ? {} : KINDS[entry.kind];
    const { first: one, second: other } = MARKS[theme];
    const colours = [...first.map(() => one), ...second.map(() => other)].flatMap((name) => new Color(name).toArray());
    this.points.forEach((points, time) => {
      points.visible = entry !== null;
      points.geometry.dispose();
      points.geometry = new BufferGeometry();
      const places = first.concat(second).flatMap((_, point, all) => this.place(time * all.length + point));
      points.geometry.setAttribute("position", new BufferAttribute(Float32Array.from(places), 3));
      points.geometry.setAttribute("color", new BufferAttribute(Float32Array.from(colours), 3));
    });
    this.view.request();
  }

  /** The place of a point in units of the page. */
  private place(point: number): Point {
    if (this.entry === null || this.frames === null) return [0, 0, 0];
    return this.frames.toPage(pointOf(this.entry, point));
  }

  /** The places of the handles in the window. */
  places(): [x: number, y: number][] {
    if (this.entry === null) return [];
    const { left, top, width, height } = this.canvas.getBoundingClientRect();
    return Array.from({ length: 2 * pointCount(this.entry.kind) }, (_, point) => {
      const { x, y } = new Vector3(...this.place(point)).project(this.view.camera);
      return [left + ((x + 1) / 2) * width, top + ((1 - y) / 2) * height];
    });
  }

  /** The handle at a place of the picture; the handle at t = 1 if both ends are there. */
  private at(event: PointerEvent): number | null {
    if (this.entry === null || event.target !== this.canvas) return null;
    let nearest: number | null = null;
    let least = NEAR;
    for (const [point, [x, y]] of this.places().entries()) {
      const distance = Math.hypot(x - event.clientX, y - event.clientY);
      if (distance <= least) [nearest, least] = [point, distance];
    }
    return nearest;
  }

  private take(event: PointerEvent): void {
    const point = event.button === 0 ? this.at(event) : null;
    if (point === null || this.entry === null || this.frames === null) return;
    event.stopPropagation();
    const { coordinates, kind } = this.entry;
    const other = (point + pointCount(kind)) % (2 * pointCount(kind));
    const indices = event.shiftKey ? [point, other] : [point];
    this.drag = { indices, from: pointOf(this.entry, point), before: coordinates, scale: this.frames.page.scale };
    this.canvas.setPointerCapture(event.pointerId);
  }

  private move(event: PointerEvent): void {
    if (this.drag === null) {
      this.canvas.style.cursor = this.at(event) === null ? "" : "grab";
      return;
    }
    event.stopPropagation();
    if (this.frames === null) return;
    const { indices, before, scale } = this.drag;
    const from = new Vector3(...this.frames.toPage(this.drag.from));
    const to = this.under(event, from);
    if (to === null) return;
    const unit = this.frames.page.scale;
    const moved = to.sub(from).toArray().map((difference) => difference * unit);
    const values = indices.flatMap((point) =>
      moved.map((by, axis): [number, number] => {
        const index = 3 * point + axis;
        return [index, rounded(before[index], by, scale)];
      }),
    );
    this.change(replaced(before, values));
  }

  /** The point under the mouse in the plane of the picture through `from`. */
  private under(event: PointerEvent, from: Vector3): Vector3 | null {
    const { left, top, width, height } = this.canvas.getBoundingClientRect();
    const place = new Vector2((2 * (event.clientX - left)) / width - 1, 1 - (2 * (event.clientY - top)) / height);
    const ray = new Raycaster();
    ray.setFromCamera(place, this.view.camera);
    const normal = this.view.camera.getWorldDirection(new Vector3());
    const slope = ray.ray.direction.dot(normal);
    const distance = from.clone().sub(ray.ray.origin).dot(normal) / slope;
    return Number.isFinite(distance) ? ray.ray.at(distance, new Vector3()) : null;
  }
}

function pointOf({ coordinates }: Entry, point: number): Point {
  return [coordinates[3 * point], coordinates[3 * point + 1], coordinates[3 * point + 2]];
}

/** A coordinate that is moved, as a decimal with a few digits; the same if it is hardly moved. */
export function rounded(x: number, by: number, scale: number): number {
  const unit = 10 ** Math.floor(Math.log10(scale)) / 100;
  if (Math.abs(by) < unit / 2) return x;
  const result = Number((Math.round((x + by) / unit) * unit).toPrecision(12));
  return Number.isFinite(result) ? result : x;
}
