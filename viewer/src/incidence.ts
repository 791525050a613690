/** The faces around vertices. */

/** The faces of each vertex: one pass over all faces finds them for every vertex. */
export class Incidence {
  /** The faces around vertex v are `list` from `start[v]` to `start[v + 1]`. */
  private readonly start: Uint32Array;
  private readonly list: Uint32Array;

  constructor(
    vertexCount: number,
    private readonly faces: Uint32Array,
  ) {
    const corners = faces.slice();
    const start = new Uint32Array(vertexCount + 1);
    for (const vertex of corners) start[vertex + 1]++;
    for (let vertex = 0; vertex < vertexCount; vertex++) start[vertex + 1] += start[vertex];
    const next = start.slice();
    this.list = new Uint32Array(corners.length);
    corners.forEach((vertex, corner) => (this.list[next[vertex]++] = Math.floor(corner / 3)));
    this.start = start;
  }

  /** The corners of the faces with all of these vertices and one more: those around a vertex or an edge. */
  around([first, ...others]: number[]): number[] {
    if (first === undefined || others.length > 1) return [];
    const own = this.list.subarray(this.start[first], this.start[first + 1]);
    const corners = Array.from(own, (face) => Array.from(this.faces.subarray(3 * face, 3 * face + 3)));
    return corners.filter((face) => others.every((vertex) => face.includes(vertex))).flat();
  }
}
