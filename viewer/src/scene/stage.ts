/** The mesh with its contacts, at the moment and with the selection of the state. */

import { BufferAttribute, BufferGeometry, Points, PointsMaterial } from "three";
import { MARKS, viridis } from "../colours";
import { type Frames, type Moment, vertexAt } from "../frames";
import { type Page, type Point, type Primitive } from "../page";
import { type Shown } from "../source";
import { type Change, type State } from "../state";
import { vertexName } from "../text";
import { mix, subtract } from "../vector";
import { disc } from "./disc";
import { type Label, type Labels } from "./labels";
import { type Marked, type Moving, Marks } from "./marks";
import { MovingMesh } from "./mesh";
import { namesOf } from "./names";
import { geometryOf, type Plane, Planes } from "./planes";
import { commonLine, contactPose, overview } from "./pose";
import { View } from "./view";

type Ends = [Float32Array<ArrayBuffer>, Float32Array<ArrayBuffer>];

/** Two primitives, and where they touch. */
interface Pair {
  primitives: [Primitive, Primitive];
  closest?: [Point, Point];
  normal?: Point | null;
}

/** The fraction of the height that the primitives of a contact fill, among others or alone. */
const [AMONG_OTHERS, ALONE] = [0.4, 0.75];

/** The size of the dots at contacts in pixels, and the number of contacts that have it. */
const [DOT, FEW] = [7, 200];

/** The size of the dots at so many contacts: many are smaller, so that the surface is visible between them. */
export const dotSize = (count: number): number => Math.max(2.5, DOT * Math.min(1, Math.sqrt(FEW / count)));

export class Stage {
  readonly view: View;
  /** Whole paths are in view with the contact of a query, not only its primitives. */
  showsPaths = false;
  private readonly mesh = new MovingMesh();
  private readonly marks = new Marks();
  private readonly planes = new Planes();
  private readonly places: Points<BufferGeometry, PointsMaterial>;
  private shown: Shown | null = null;
  private middle: Point = [0, 0, 0];
  private radius = 1;
  /** The direction upwards: the first data determine it, until a key changes it. */
  private up: Point = [0, 0, 1];
  private ends: Ends = [new Float32Array(), new Float32Array()];
  private frame = -1;
  /** The number of changes, and the number of the last one that is drawn. */
  private changes = 0;
  private drawn = 0;
  /** The number of times that the camera was aimed. */
  private aims = 0;

  constructor(
    canvas: HTMLCanvasElement,
    private readonly labels: Labels,
  ) {
    this.view = new View(canvas, (width, height) => labels.place(this.view.camera, width, height), this.mesh.uniforms);
    this.view.add(this.mesh.group);
    this.view.add(this.planes.group);
    const material = new PointsMaterial({ vertexColors: true, size: DOT, sizeAttenuation: false, map: disc(), alphaTest: 0.4 });
    this.places = new Points(new BufferGeometry(), material);
    this.places.frustumCulled = false;
    this.view.addMark(this.places);
    this.view.addMark(this.marks.group);
  }

  /** The frames that are shown. */
  get frames(): Frames | null {
    return this.shown?.frames ?? null;
  }

  /** Shows other data. The camera stays where it is in the world. */
  show(shown: Shown): void {
    const { page, frames, elements, groups } = shown;
    const before = this.shown?.frames;
    this.shown = shown;
    if (before === undefined) this.up = page.up;
    this.setEnds([frames.first, frames.first], page);
    if (before !== undefined) {
      const moved = (point: Point): Point => frames.toPage(before.toWorld(point));
      const { target, position } = this.view.pose;
      this.view.go({ target: moved(target), position: moved(position) }, true);
    }
    this.mesh.show(elements, groups, frames.first);
    this.frame = -1;
    // A single contact has marks of its own.
    this.places.visible = page.contacts.length > 1;
    this.places.geometry.dispose();
    this.places.geometry = placesOf(shown);
    this.places.material.size = dotSize(page.contacts.length);
  }

  /** Positions at both ends of the step, which are the space of the view. */
  private setEnds(ends: Ends, page: Page): void {
    this.ends = ends;
    [this.middle, this.radius] = ballAround(...ends);
    this.view.setSpace(this.up, Math.hypot(...this.middle) + 2 * this.radius, this.radius);
    const frames = this.shown?.frames;
    const planes = page.halfSpaces.map(({ point, normal }): Plane => ({ point: frames?.toPage(point) ?? point, normal }));
    this.planes.draw(planes, this.middle, this.radius);
  }

  /** The camera on everything. */
  fit(atOnce = false): void {
    if (this.shown === null) return;
    this.aims++;
    this.view.go(overview(this.middle, this.radius, this.up), atOnce);
  }

  /** Makes the next axis the direction upwards, and moves the camera to see everything: z, y, x, then z again. */
  turnUp(): void {
    if (this.shown === null) return;
    const most = [0, 1, 2].reduce((a, b) => (Math.abs(this.up[b]) > Math.abs(this.up[a]) ? b : a));
    const axes: Point[] = [[0, 0, 1], [1, 0, 0], [0, 1, 0]];
    this.up = axes[most];
    this.setEnds(this.ends, this.shown.page);
    this.fit(true);
  }

  /** The camera on a body. */
  fitBody({ moment }: State, body: number): void {
    if (this.shown === null) return;
    const { page } = this.shown;
    const { start, end } = page.bodies[body].vertices;
    const own = Float32Array.from({ length: 3 * (end - start) }, (_, i) => {
      const [from, to] = this.ends.map((positions) => positions[3 * start + i]);
      return (1 - moment.t) * from + moment.t * to;
    });
    const [middle, radius] = ballAround(own);
    this.aims++;
    this.view.go(overview(middle, Math.max(radius, 0.02 * this.radius), this.up), false);
  }

  /** The camera on the selected contact. */
  async near({ contact }: State, atOnce = false): Promise<void> {
    const { shown } = this;
    if (shown === null || contact === null) return this.fit(atOnce);
    const { page, frames } = shown;
    const { time, frame } = page.contacts[contact];
    const aim = ++this.aims;
    const ends = await frames.ends({ frame, t: time });
    // A later choice moves the camera.
    if (shown !== this.shown || aim !== this.aims) return;
    const { primitives, closest, normal } = marked(shown, page.contacts[contact], ends);
    const isHalfSpace = page.contacts[contact].primitives[1].kind === "half-space";
    const at = primitives.flatMap(({ start, end, around }) => {
      const now = ({ start, end }: Moving): Point[] => start.map((vertex, i) => mix(vertex, end[i], time));
      if (isHalfSpace) return [...now({ start, end }), ...now(around), ...(closest ?? [])];
      return page.query !== null && this.showsPaths ? [...now({ start, end }), ...start, ...end] : now({ start, end });
    });
    const line = commonLine(primitives.flatMap(({ start, end }) => start.map((vertex, i) => mix(vertex, end[i], time))));
    const place = closest === null ? this.middle : mix(closest[0], closest[1], 0.5);
    const fraction = page.query === null && !isHalfSpace ? AMONG_OTHERS : ALONE;
    // A half space is seen from its outer side, and a mesh from outside.
    const inside = isHalfSpace && normal !== null ? subtract(place, normal) : this.middle;
    this.view.go(contactPose(place, normal, at, inside, this.radius, this.up, fraction, line), atOnce);
  }

  /** Draws a changed state. */
  async update(state: State, change: Change): Promise<void> {
    const { shown } = this;
    if (shown === null) return;
    const { moment, theme } = state;
    if (change.hidden !== undefined) this.mesh.hide(state.hidden);
    if (change.opacity !== undefined) this.mesh.setOpacity(state.opacity);
    if (change.theme !== undefined) this.view.setBackground(MARKS[theme].background);
    if (change.wireframe !== undefined || change.theme !== undefined) {
      this.mesh.setWires(state.wireframe, MARKS[theme].wire);
    }
    this.view.request();
    const number = ++this.changes;
    if (moment.frame !== this.frame) {
      const ends = await shown.frames.ends(moment);
      // A later change may be drawn already.
      if (shown !== this.shown || number < this.drawn) return;
      this.setEnds(ends, shown.page);
      this.frame = moment.frame;
      this.mesh.setEnds(ends);
    }
    this.drawn = number;
    this.mesh.setTime(moment.t);
    this.places.geometry.setDrawRange(0, countUntil(shown.page, moment));
    this.drawMarks(shown, state);
    this.view.request();
  }

  private drawMarks(shown: Shown, { contact, moment, theme, paths, labels, names, hidden }: State): void {
    const { page } = shown;
    const pair = (contact === null ? null : page.contacts[contact]) ?? page.query;
    const bodies = names ? namesOf(page, this.ends, moment.t, hidden) : [];
    if (pair === null) {
      this.marks.clear();
      this.labels.set(bodies, null);
      return;
    }
    const of = marked(shown, pair, this.ends);
    this.marks.draw(of, moment.t, paths, MARKS[theme], 0.1 * this.radius);
    const own = labels ? labelsOf(page, pair, of, moment.t) : [];
    this.labels.set([...own, ...bodies], of.closest?.[0] ?? null);
  }
}

function marked({ frames, incidence }: Shown, pair: Pair, ends: Ends): Marked {
  const at = (vertices: number[], t: number): Point[] => vertices.map((vertex) => vertexAt(vertex, ends, t));
  const moving = (vertices: number[]): Moving => ({ start: at(vertices, 0), end: at(vertices, 1) });
  return {
    primitives: pair.primitives.map(({ vertices }) => ({
      ...moving(vertices),
      around: moving(incidence.around(vertices)),
    })),
    closest: pair.closest === undefined ? null : [frames.toPage(pair.closest[0]), frames.toPage(pair.closest[1])],
    normal: pair.normal ?? null,
  };
}

function labelsOf(page: Page, { primitives }: Pair, of: Marked, t: number): Label[] {
  return primitives.flatMap((primitive, side) => {
    const { start, end } = of.primitives[side];
    return primitive.vertices.map((_, i): Label => {
      const at = mix(start[i], end[i], t);
      return { at, text: vertexName(page, primitive, i), kind: side === 0 ? "first" : "second" };
    });
  });
}

/** The number of contacts up to a moment. */
function countUntil({ contacts }: Page, { frame, t }: Moment): number {
  const later = contacts.findIndex((contact) => contact.frame > frame || (contact.frame === frame && contact.time > t));
  return later < 0 ? contacts.length : later;
}

/** All contact points, in the order and the colours of their times. */
function placesOf({ page: { contacts }, frames, place }: Shown): BufferGeometry {
  const geometry = geometryOf(contacts.map(({ closest }) => frames.toPage(closest[0])));
  const colours = contacts.flatMap((_, i) => viridis(place(i)).map((x) => (x / 255) ** 2.2));
  geometry.setAttribute("color", new BufferAttribute(Float32Array.from(colours), 3));
  return geometry;
}

/** The middle of the box around positions, and the radius of a ball around them. */
function ballAround(...all: Float32Array[]): [Point, number] {
  const lower = [Infinity, Infinity, Infinity];
  const upper = [-Infinity, -Infinity, -Infinity];
  for (const positions of all) {
    for (let i = 0; i < positions.length; i++) {
      const [axis, x] = [i % 3, positions[i]];
      if (x < lower[axis]) lower[axis] = x;
      if (x > upper[axis]) upper[axis] = x;
    }
  }
  if (lower[0] > upper[0]) return [[0, 0, 0], 1];
  const along = (axis: number): number => (lower[axis] + upper[axis]) / 2;
  const radius = Math.hypot(...lower.map((low, axis) => (upper[axis] - low) / 2));
  return [[along(0), along(1), along(2)], radius > 0 ? radius : 1];
}
