/** The mesh of a step: its vertices move on the graphics card. */

import {
  BufferAttribute,
  BufferGeometry,
  Color,
  DoubleSide,
  Group,
  LineBasicMaterial,
  LineSegments,
  type Material,
  Mesh,
  MeshLambertMaterial,
  Points,
  PointsMaterial,
  Sphere,
  Vector3,
} from "three";
import { PARTS } from "../colours";
import { type Parts } from "../parts";
import { disc } from "./disc";

export interface Elements {
  faces: Uint32Array<ArrayBuffer>;
  edges: Uint32Array<ArrayBuffer>;
  points: Uint32Array<ArrayBuffer>;
}

type Positions = Float32Array<ArrayBuffer>;

const NONE = new Uint32Array();

export class MovingMesh {
  readonly group = new Group();
  private readonly time = { value: 0 };
  private elements: Elements = { faces: NONE, edges: NONE, points: NONE };
  private position = new BufferAttribute(new Float32Array(), 3);
  private next = this.position;
  // Materials are kept: a new one would be compiled again.
  private readonly surface = new Mesh(
    new BufferGeometry(),
    this.moving(new MeshLambertMaterial({ vertexColors: true, flatShading: true, side: DoubleSide })),
  );
  private readonly rods = new LineSegments(new BufferGeometry(), this.moving(new LineBasicMaterial({ vertexColors: true })));
  private readonly points = new Points(
    new BufferGeometry(),
    this.moving(
      new PointsMaterial({ vertexColors: true, size: 7, sizeAttenuation: false, map: disc(), alphaTest: 0.5 }),
    ),
  );
  private readonly wires = new LineSegments(
    new BufferGeometry(),
    this.moving(new LineBasicMaterial({ transparent: true, opacity: 0.18, depthWrite: false })),
  );
  private hasWires = false;

  /** Shows another mesh, at rest. */
  show(elements: Elements, parts: Parts, first: Positions): void {
    this.elements = elements;
    this.position = new BufferAttribute(first.slice(), 3);
    this.next = new BufferAttribute(first.slice(), 3);
    const colour = new BufferAttribute(coloursOf(parts), 3, true);
    this.group.clear();
    const all = [[this.surface, elements.faces], [this.rods, elements.edges], [this.points, elements.points]] as const;
    for (const [object, indices] of all) {
      object.geometry.dispose();
      object.geometry = this.geometry(indices);
      object.geometry.setAttribute("color", colour);
      // Nothing is compiled for what is not there.
      if (indices.length > 0) this.group.add(object);
    }
    this.hasWires = false;
  }

  /** Positions at both ends of the step. */
  setEnds([start, end]: [Positions, Positions]): void {
    for (const [attribute, positions] of [[this.position, start], [this.next, end]] as const) {
      if (sameStart(attribute.array as Positions, positions)) continue;
      (attribute.array as Positions).set(positions);
      attribute.needsUpdate = true;
    }
  }

  setTime(t: number): void {
    this.time.value = t;
  }

  setOpacity(opacity: number): void {
    const { material } = this.surface;
    material.transparent = opacity < 1;
    material.opacity = opacity;
    // Behind transparent faces, everything is visible.
    material.depthWrite = opacity >= 1;
    material.polygonOffset = true;
    material.polygonOffsetFactor = 1;
    material.polygonOffsetUnits = 1;
    for (const other of [this.rods.material, this.points.material]) {
      other.transparent = opacity < 1;
      other.opacity = Math.sqrt(opacity);
    }
    this.surface.visible = opacity > 0;
  }

  /** Draws the edges of the faces, or does not. Their list is made on first use. */
  setWires(visible: boolean, colour: string): void {
    if (visible && !this.hasWires) {
      this.wires.geometry.dispose();
      this.wires.geometry = this.geometry(edgesOf(this.elements.faces));
      this.group.add(this.wires);
      this.hasWires = true;
    }
    this.wires.visible = visible;
    this.wires.material.color.set(colour);
  }

  private geometry(indices: Uint32Array<ArrayBuffer>): BufferGeometry {
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", this.position);
    geometry.setAttribute("next", this.next);
    geometry.setIndex(new BufferAttribute(indices, 1));
    // Nothing is left out for being outside the view, which depends on the time.
    geometry.boundingSphere = new Sphere(new Vector3(), Infinity);
    return geometry;
  }

  /** A material whose vertices are between `position` and `next`. */
  private moving<M extends Material>(material: M): M {
    material.onBeforeCompile = (shader) => {
      shader.uniforms["stepTime"] = this.time;
      const begin = "vec3 transformed = mix(position, next, stepTime);";
      shader.vertexShader =
        "attribute vec3 next;\nuniform float stepTime;\n" +
        shader.vertexShader.replace("#include <begin_vertex>", begin);
    };
    return material;
  }
}

function sameStart(a: Positions, b: Positions): boolean {
  for (let i = 0; i < a.length; i++) if (a[i] !== b[i]) return false;
  return true;
}

/** A colour for each vertex, the same for a part. */
function coloursOf({ of }: Parts): Uint8Array {
  // Vertex colours are in linear light.
  const palette = PARTS.map((name) => new Color(name).toArray().map((x) => Math.round(255 * x)));
  const colours = new Uint8Array(3 * of.length);
  of.forEach((part, vertex) => colours.set(palette[part % palette.length], 3 * vertex));
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
