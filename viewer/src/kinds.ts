/** The kinds of query, as tables. */

interface Tables {
  title: string;
  /** The names of the points of both primitives. */
  first: string[];
  second: string[];
  /** For each of the four points of a page, its index among these names. */
  layout: number[];
  /**
   * The corners of the domain in (u, v), each as the two points of a page whose difference is F there, in the order
   * around the image at one time. F is affine in u and v, so that image is a triangle, a parallelogram, an edge or a
   * point.
   */
  corners: [number, number][];
  /** The differences w, e1, e2 of four points, whose determinant is the coplanarity cubic. */
  span: [number, number][];
}

const SPAN_OF_EDGES: [number, number][] = [[2, 0], [1, 0], [3, 2]];

const ALL = {
  "vertex-face": {
    title: "vertex and face",
    first: ["p"],
    second: ["v₁", "v₂", "v₃"],
    layout: [0, 1, 2, 3],
    corners: [[0, 1], [0, 2], [0, 3]],
    span: [[0, 1], [2, 1], [3, 1]],
  },
  "edge-edge": {
    title: "two edges",
    first: ["a₀", "a₁"],
    second: ["b₀", "b₁"],
    layout: [0, 1, 2, 3],
    corners: [[0, 2], [1, 2], [1, 3], [0, 3]],
    span: SPAN_OF_EDGES,
  },
  "vertex-edge": {
    title: "vertex and edge",
    first: ["p"],
    second: ["a", "b"],
    layout: [0, 0, 1, 2],
    corners: [[0, 2], [0, 3]],
    span: SPAN_OF_EDGES,
  },
  "vertex-vertex": {
    title: "two vertices",
    first: ["p"],
    second: ["q"],
    layout: [0, 0, 1, 1],
    corners: [[0, 2]],
    span: SPAN_OF_EDGES,
  },
} satisfies Record<string, Tables>;

export type Kind = keyof typeof ALL;

export const KINDS: Record<Kind, Tables> = ALL;

/** The names of the points of a query, in their order. */
export function pointNames(kind: Kind): string[] {
  return [...KINDS[kind].first, ...KINDS[kind].second];
}
