/** The parts of a mesh: its bodies, or what is connected. */

import { type Body } from "./page";

export interface Parts {
  count: number;
  /** The part of each vertex, in the order of their first vertices. */
  of: Uint32Array;
}

/** The parts of a mesh of faces and edges. A vertex of no element is a part. */
export function partsOf(vertexCount: number, faces: Uint32Array, edges: Uint32Array): Parts {
  const parent = new Uint32Array(vertexCount);
  for (let i = 0; i < vertexCount; i++) parent[i] = i;
  const root = (vertex: number): number => {
    while (parent[vertex] !== vertex) {
      parent[vertex] = parent[parent[vertex]];
      vertex = parent[vertex];
    }
    return vertex;
  };
  const join = (a: number, b: number): void => {
    const [i, j] = [root(a), root(b)];
    if (i < j) parent[j] = i;
    else parent[i] = j;
  };
  for (let i = 0; i < faces.length; i += 3) {
    join(faces[i], faces[i + 1]);
    join(faces[i], faces[i + 2]);
  }
  for (let i = 0; i < edges.length; i += 2) join(edges[i], edges[i + 1]);

  // A root is the least vertex of its part, so it comes before the others.
  const of = new Uint32Array(vertexCount);
  let count = 0;
  for (let vertex = 0; vertex < vertexCount; vertex++) {
    const least = root(vertex);
    of[vertex] = least === vertex ? count++ : of[least];
  }
  return { count, of };
}

/** The vertices of no face and no edge. */
export function looseVertices(vertexCount: number, faces: Uint32Array, edges: Uint32Array): Uint32Array {
  const used = new Uint8Array(vertexCount);
  for (const elements of [faces, edges]) for (const vertex of elements) used[vertex] = 1;
  return Uint32Array.from({ length: vertexCount }, (_, vertex) => vertex).filter((vertex) => used[vertex] === 0);
}

/** The parts with a colour of their own, and the colour of each vertex by its place in the palette: the bodies, or else
 * the connected parts. Loose vertices are one part: particles have no use for a colour each. */
export function groupsOf(parts: Parts, bodies: Body[], points: Uint32Array): Parts {
  const of = new Uint32Array(parts.of.length);
  if (bodies.length > 0) {
    bodies.forEach(({ vertices: { start, end } }, body) => of.fill(body, start, end));
    return { count: bodies.length, of };
  }
  const isLoose = new Uint8Array(of.length);
  for (const vertex of points) isLoose[vertex] = 1;
  const groups = new Map<number, number>();
  for (let vertex = 0; vertex < of.length; vertex++) {
    const part = isLoose[vertex] === 1 ? -1 : parts.of[vertex];
    const group = groups.get(part) ?? groups.size;
    groups.set(part, group);
    of[vertex] = group;
  }
  return { count: groups.size, of };
}
