/** Queries to begin with. In some of them the root finder is wrong, as in the first, with which the page opens. */

import { type Entry } from "./entry";
import { type Kind } from "../kinds";

export interface Preset {
  name: string;
  entry: Entry;
}

type Row = [x: number, y: number, z: number];

const FACE: Row[] = [[0, 0, 0], [1, 0, 0], [0, 1, 0]];
const EDGE: Row[] = [[0, -1, 0], [0, 1, 0]];

function preset(name: string, kind: Kind, start: Row[], end: Row[], distance = 0, scale = 1): Preset {
  const coordinates = Float64Array.from([...start, ...end].flat().map((x) => scale * x));
  return { name, entry: { kind, coordinates, distance, tolerance: 0 } };
}

export const PRESETS: Preset[] = [
  preset(
    "A face turns: the contact is missed",
    "vertex-face",
    [[1, -1, -1.5], [0.5, -2, 1], [0, 0, -2], [1, 0, 0]],
    [[-1, 0, 2], [-2, -1.5, 1], [0, 0, 0], [-0.5, -2, 2]],
  ),
  preset("A vertex falls through a face", "vertex-face", [[0.25, 0.25, 1], ...FACE], [[0.25, 0.25, -1.5], ...FACE]),
  preset(
    "Parallel edges: the contact is missed",
    "edge-edge",
    [[-1, 0, 1], [1, 0, 1], [-0.5, 0, 0], [1.5, 0, 0]],
    [[-1, 0, -1], [1, 0, -1], [-0.5, 0, 0], [1.5, 0, 0]],
  ),
  preset(
    "A contact that is none",
    "vertex-face",
    [[-0.5, -2, -1.5], [0, 2, -1], [-2, 0, 1], [-1, 1, 0]],
    [[0, 1, -2], [-0.5, 1, 0.5], [0, -1, 0], [-0.5, 0, 1]],
  ),
  preset(
    "A face turns over: the contact comes too early",
    "vertex-face",
    [[0.5, 0.25, 0.25], [0, 0, -1], [1, 0, -1], [0, 1, -1]],
    [[0.5, 0.25, 0.25], [1, 0, 1], [0, 0, 1], [1, 1, 1]],
  ),
  preset("A vertex slides on a face", "vertex-face", [[-1, 0.25, 0], ...FACE], [[1, 0.25, 0], ...FACE]),
  preset("Large numbers: the contact is missed", "vertex-face", [[0.25, 0.25, 1], ...FACE], [[0.25, 0.25, -1.5], ...FACE], 0, 1e60),
  preset("Small numbers: the contact comes at once", "vertex-face", [[0.25, 0.25, 1], ...FACE], [[0.25, 0.25, -1.5], ...FACE], 0, 2 ** -200),
  preset("Edges within a distance", "edge-edge", [[-1, 0.25, 1], [1, 0, 1.5], ...EDGE], [[-1, 0, 0.25], [1, 0.25, 0.125], ...EDGE], 0.25),
  preset("A vertex and an edge, within a distance", "vertex-edge", [[1, 0.5, 1], ...EDGE], [[-1, 0.75, -0.5], ...EDGE], 0.25),
  preset("Two vertices, within a distance", "vertex-vertex", [[-1, 0, 0.25], [1, 0, 0]], [[1, 0, 0], [-1, 0.25, 0]], 0.5),
];
