/** The mesh of a step: its vertices move on the graphics card. */

import { BufferAttribute, BufferGeometry, Color, Group, LineBasicMaterial, LineSegments, Sphere, Vector3 } from "three";
import { PARTS } from "../colours";
import { type Parts } from "../parts";
import { Balls } from "./balls";
import { IN_FRONT, patched, uniforms } from "./moving";
import { Rods, THIN } from "./rods";
import { Surface } from "./surface";

export interface Elements {
  faces: Uint32Array<ArrayBuffer>;
  edges: Uint32Array<ArrayBuffer>;
  points: Uint32Array<ArrayBuffer>;
  /** The radius of rods and points at each vertex; empty for the least ones that are visible. */
  radii: Float32Array<ArrayBuffer>;
}

type Positions = Float32Array<ArrayBuffer>;

/** The least radius of a particle, in pixels. */
const SMALL = 4;

/** The radius of a joint of rods, as a part of the rods' radius: it fills the gap in a bend, and is hidden in a straight rod. */
const JOINT = 0.85;

const NONE = { faces: new Uint32Array(), edges: new Uint32Array(), points: new Uint32Array(), radii: new Float32Array() };

export class MovingMesh {
  readonly group = new Group();
  /** Shared by all materials of the mesh. */
  readonly uniforms = uniforms();
  private elements: Elements = NONE;
  private groups: Parts = { count: 0, of: new Uint32Array() };
  private colours = new Uint8Array();
  private position = new BufferAttribute(new Float32Array(), 3);
  private next = this.position;
  private ends: [Positions, Positions] = [new Float32Array(), new Float32Array()];
  // Materials are kept: a new one would be compiled again.
  private readonly surface = new Surface(new BufferGeometry(), this.uniforms);
  private readonly rods = new Rods(this.uniforms);
  private readonly joints = new Balls(JOINT * THIN, JOINT, this.uniforms);
  private readonly points = new Balls(SMALL, 1, this.uniforms);
  private readonly wires = new LineSegments(
    new BufferGeometry(),
    patched(new LineBasicMaterial({ transparent: true, depthWrite: false }), this.uniforms, IN_FRONT),
  );
  private hidden: ReadonlySet<number> = new Set();
  private isShown = false;
  /** The faces that are shown, and the state of their edges. */
  private faces: Uint32Array<ArrayBuffer> = NONE.faces;
  private hasWires = false;
  private showsWires = false;

  constructor() {
    this.wires.renderOrder = 4;
  }

  /** Shows another mesh, at rest. */
  show(elements: Elements, groups: Parts, first: Positions): void {
    [this.elements, this.groups] = [elements, groups];
    this.position = new BufferAttribute(first.slice(), 3);
    this.next = new BufferAttribute(first.slice(), 3);
    this.ends = [first, first];
    this.colours = coloursOf(groups);
    this.isShown = false;
    this.hide(new Set());
  }

  /** Leaves out the elements of these groups. */
  hide(hidden: ReadonlySet<number>): void {
    if (hidden.size === 0 && this.hidden.size === 0 && this.isShown) return;
    [this.hidden, this.isShown] = [hidden, true];
    const { of } = this.groups;
    const shown = (elements: Uint32Array<ArrayBuffer>, size: number): Uint32Array<ArrayBuffer> =>
      hidden.size === 0 ? elements : elements.filter((_, i) => !hidden.has(of[elements[i - (i % size)]]));
    const { radii } = this.elements;
    const [faces, edges, points] = [shown(this.elements.faces, 3), shown(this.elements.edges, 2), shown(this.elements.points, 1)];
    this.faces = faces;
    this.group.clear();
    // Nothing is compiled for what is not there.
    if (faces.length > 0) {
      this.surface.show(this.geometry(faces, true));
      this.group.add(this.surface.group);
    }
    if (edges.length > 0) {
      this.rods.show(edges, this.colours, radii);
      this.rods.setEnds(this.ends);
      this.group.add(this.rods.mesh);
    }
    const joints = Uint32Array.from(new Set(edges));
    for (const [balls, vertices] of [[this.joints, joints], [this.points, points]] as const) {
      if (vertices.length === 0) continue;
      balls.points.geometry.dispose();
      balls.points.geometry = this.geometry(vertices, true);
      const radius = radii.length > 0 ? radii : new Float32Array(of.length);
      balls.points.geometry.setAttribute("radius", new BufferAttribute(radius, 1));
      this.group.add(balls.points);
    }
    this.wires.geometry.dispose();
    this.hasWires = false;
    this.setWires(this.showsWires, null);
  }

  /** Positions at both ends of the step. */
  setEnds(ends: [Positions, Positions]): void {
    this.ends = ends;
    for (const [attribute, positions] of [[this.position, ends[0]], [this.next, ends[1]]] as const) {
      if (sameStart(attribute.array as Positions, positions)) continue;
      (attribute.array as Positions).set(positions);
      attribute.needsUpdate = true;
    }
    this.rods.setEnds(ends);
  }

  setTime(t: number): void {
    this.uniforms.stepTime.value = t;
  }

  setOpacity(opacity: number): void {
    this.surface.setOpacity(opacity);
    for (const { material } of [this.rods.mesh, this.joints.points, this.points.points]) {
      material.transparent = opacity < 1;
      material.opacity = Math.sqrt(opacity);
    }
    this.wires.material.opacity = 0.35 * Math.max(opacity, 0.5);
  }

  /** Draws the edges of the faces in this colour, or in the one before, or does not. Their list is made on first
   * use. */
  setWires(visible: boolean, colour: string | null): void {
    this.showsWires = visible;
    if (visible && !this.hasWires && this.faces.length > 0) {
      this.wires.geometry = this.geometry(edgesOf(this.faces), false);
      this.group.add(this.wires);
      this.hasWires = true;
    }
    this.wires.visible = visible && this.hasWires;
    if (colour !== null) this.wires.material.color.set(colour);
  }

  private geometry(indices: Uint32Array<ArrayBuffer>, hasColour: boolean): BufferGeometry {
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", this.position);
    geometry.setAttribute("next", this.next);
    if (hasColour) geometry.setAttribute("color", new BufferAttribute(this.colours, 3, true));
    geometry.setIndex(new BufferAttribute(indices, 1));
    // Nothing is left out for being outside the view, which depends on the time.
    geometry.boundingSphere = new Sphere(new Vector3(), Infinity);
    return geometry;
  }
}

function sameStart(a: Positions, b: Positions): boolean {
  for (let i = 0; i < a.length; i++) if (a[i] !== b[i]) return false;
  return true;
}

/** A colour for each vertex, the same for a group. */
function coloursOf({ of }: Parts): Uint8Array<ArrayBuffer> {
  // Vertex colours are in linear light.
  const palette = PARTS.map((name) => new Color(name).toArray().map((x) => Math.round(255 * x)));
  const colours = new Uint8Array(3 * of.length);
  of.forEach((group, vertex) => colours.set(palette[group % palette.length], 3 * vertex));
  return colours;
}

/** The edges of faces, each once. */
export function edgesOf(faces: Uint32Array): Uint32Array<ArrayBuffer> {
  // Products below 2^53: exact for 2^26 vertices, and else some edges are drawn twice or left out.
  const keys = new Float64Array(faces.length);
  const base = 2 ** 26;
  for (let i = 0; i < faces.length; i += 3) {
    for (let k = 0; k < 3; k++) {
      const [a, b] = [faces[i + k], faces[i + ((k + 1) % 3)]];
      keys[i + k] = Math.min(a, b) * base + Math.max(a, b);
    }
  }
  keys.sort();
  const edges = new Uint32Array(2 * keys.length);
  let count = 0;
  for (let i = 0; i < keys.length; i++) {
    if (i > 0 && keys[i] === keys[i - 1]) continue;
    edges[count++] = Math.floor(keys[i] / base);
    edges[count++] = keys[i] % base;
  }
  return edges.slice(0, count);
}
