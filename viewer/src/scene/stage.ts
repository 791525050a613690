/** The mesh with its contacts, at the moment and with the selection of the state. */

import { BufferAttribute, BufferGeometry, Points, PointsMaterial } from "three";
import { MARKS, viridis } from "../colours";
import { type Frames, type Moment, vertexAt } from "../frames";
import { type Page, type Point, type Primitive } from "../page";
import { facesAround, type Parts } from "../parts";
import { type Change, type State } from "../state";
import { mix } from "../vector";
import { disc } from "./disc";
import { type Label, type Labels } from "./labels";
import { type Marked, type Moving, Marks } from "./marks";
import { type Elements, MovingMesh } from "./mesh";
import { contactPose, overview } from "./pose";
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

export class Stage {
  private readonly view: View;
  private readonly mesh: MovingMesh;
  private readonly marks = new Marks();
  private readonly middle: Point;
  private readonly radius: number;
  private readonly places: Points | null;
  private ends: Ends;
  private frame = -1;

  constructor(
    canvas: HTMLCanvasElement,
    private readonly labels: Labels,
    private readonly page: Page,
    private readonly frames: Frames,
    private readonly elements: Elements,
    parts: Parts,
    colour: (contact: number) => number,
  ) {
    [this.middle, this.radius] = ballAround(frames.first);
    const reach = Math.hypot(...this.middle) + 2 * this.radius;
    this.view = new View(canvas, page.up, reach, (width, height) => labels.place(this.view.camera, width, height));
    this.mesh = new MovingMesh(elements, parts, frames.first);
    this.ends = [frames.first, frames.first];
    this.view.add(this.mesh.group);
    this.places = page.contacts.length > 1 ? this.placesOf(colour) : null;
    if (this.places !== null) this.view.addMark(this.places);
    this.view.addMark(this.marks.group);
    this.fit(true);
  }

  /** The camera on everything. */
  fit(atOnce = false): void {
    this.view.go(overview(this.middle, this.radius, this.page.up), atOnce);
  }

  /** The camera on the selected contact. */
  async near({ contact }: State, atOnce = false): Promise<void> {
    if (contact === null) return this.fit(atOnce);
    const { time, frame } = this.page.contacts[contact];
    const ends = await this.frames.ends({ frame, t: time });
    const { primitives, closest, normal } = this.marked(this.page.contacts[contact], ends);
    const at = primitives.flatMap(({ start, end }) => start.map((vertex, i) => mix(vertex, end[i], time)));
    const place = closest === null ? this.middle : mix(closest[0], closest[1], 0.5);
    const { up, query } = this.page;
    const fraction = query === null ? AMONG_OTHERS : ALONE;
    this.view.go(contactPose(place, normal, at, this.middle, this.radius, up, fraction), atOnce);
  }

  /** Draws a changed state. */
  async update(state: State, change: Change): Promise<void> {
    const { moment, theme } = state;
    if (moment.frame !== this.frame) {
      const ends = await this.frames.ends(moment);
      // A later change overtakes this one.
      this.ends = ends;
      this.frame = moment.frame;
      this.mesh.setEnds(ends);
    }
    this.mesh.setTime(moment.t);
    this.places?.geometry.setDrawRange(0, this.countUntil(moment));
    if (change.opacity !== undefined) this.mesh.setOpacity(state.opacity);
    if (change.theme !== undefined) this.view.setBackground(MARKS[theme].background);
    if (change.wireframe !== undefined || change.theme !== undefined) {
      this.mesh.setWires(state.wireframe, MARKS[theme].wire);
    }
    this.drawMarks(state);
    this.view.request();
  }

  private drawMarks({ contact, moment, theme, paths, labels }: State): void {
    const pair = contact === null ? this.page.query : this.page.contacts[contact];
    if (pair === null) {
      this.marks.clear();
      this.labels.set([], null);
      return;
    }
    const marked = this.marked(pair, this.ends);
    this.marks.draw(marked, moment.t, paths, MARKS[theme]);
    this.labels.set(labels ? this.labelsOf(pair, marked, moment.t) : [], marked.closest?.[0] ?? null);
  }

  private marked(pair: Pair, ends: Ends): Marked {
    const at = (vertices: number[], t: number): Point[] => vertices.map((vertex) => vertexAt(vertex, ends, t));
    const moving = (vertices: number[]): Moving => ({ start: at(vertices, 0), end: at(vertices, 1) });
    const around = ({ vertices }: Primitive): number[] => facesAround(this.elements.faces, vertices);
    return {
      primitives: pair.primitives.map((primitive) => ({
        ...moving(primitive.vertices),
        around: moving(around(primitive)),
      })),
      closest: pair.closest === undefined ? null : [this.frames.toPage(pair.closest[0]), this.frames.toPage(pair.closest[1])],
      normal: pair.normal ?? null,
    };
  }

  private labelsOf({ primitives }: Pair, marked: Marked, t: number): Label[] {
    return primitives.flatMap(({ vertices }, side) => {
      const { start, end } = marked.primitives[side];
      return vertices.map((vertex, i): Label => {
        const at = mix(start[i], end[i], t);
        return { at, text: vertexName(this.page, vertex), kind: side === 0 ? "first" : "second" };
      });
    });
  }

  /** The number of contacts up to a moment. */
  private countUntil({ frame, t }: Moment): number {
    const { contacts } = this.page;
    const later = contacts.findIndex((contact) => contact.frame > frame || (contact.frame === frame && contact.time > t));
    return later < 0 ? contacts.length : later;
  }

  /** All contact points, in the order and the colours of their times. */
  private placesOf(colour: (contact: number) => number): Points {
    const { contacts } = this.page;
    const geometry = new BufferGeometry();
    const places = contacts.flatMap(({ closest }) => this.frames.toPage(closest[0]));
    geometry.setAttribute("position", new BufferAttribute(Float32Array.from(places), 3));
    const colours = contacts.flatMap((_, i) => viridis(colour(i)).map((x) => (x / 255) ** 2.2));
    geometry.setAttribute("color", new BufferAttribute(Float32Array.from(colours), 3));
    const material = new PointsMaterial({ vertexColors: true, size: 7, sizeAttenuation: false, map: disc(), alphaTest: 0.4 });
    return new Points(geometry, material);
  }
}

/** The name of a vertex in the scene. */
function vertexName(page: Page, vertex: number): string {
  if (page.query === null) return String(vertex);
  const names = {
    "vertex-face": ["p", "v₁", "v₂", "v₃"],
    "edge-edge": ["a₀", "a₁", "b₀", "b₁"],
    "vertex-edge": ["p", "p", "a", "b"],
    "vertex-vertex": ["p", "p", "q", "q"],
  };
  return names[page.query.kind][vertex];
}

/** The middle of the box around positions, and the radius of a ball around them. */
function ballAround(positions: Float32Array): [Point, number] {
  const lower = [Infinity, Infinity, Infinity];
  const upper = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < positions.length; i++) {
    const axis = i % 3;
    lower[axis] = Math.min(lower[axis], positions[i]);
    upper[axis] = Math.max(upper[axis], positions[i]);
  }
  if (positions.length === 0) return [[0, 0, 0], 1];
  const along = (axis: number): number => (lower[axis] + upper[axis]) / 2;
  const radius = Math.hypot(...lower.map((low, axis) => (upper[axis] - low) / 2));
  return [[along(0), along(1), along(2)], radius > 0 ? radius : 1];
}
