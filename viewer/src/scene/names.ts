/** The names of bodies in the scene. */

import { vertexAt } from "../frames";
import { type Page, type Point } from "../page";
import { add, times } from "../vector";
import { type Label } from "./labels";

/** The number of vertices whose mean is the place of a name, at most, and the number of names. */
const [SAMPLES, MOST] = [64, 24];

/** The names of the bodies that are not hidden, each in the middle of its body. */
export function namesOf({ bodies }: Page, ends: [Float32Array, Float32Array], t: number, hidden: ReadonlySet<number>): Label[] {
  if (bodies.length > MOST) return [];
  return bodies.flatMap(({ name, vertices: { start, end } }, body): Label[] => {
    if (hidden.has(body) || end <= start) return [];
    const count = Math.min(SAMPLES, end - start);
    const samples = Array.from({ length: count }, (_, i) => vertexAt(start + Math.floor((i * (end - start)) / count), ends, t));
    const sum = samples.reduce<Point>((a, b) => add(a, b), [0, 0, 0]);
    return [{ at: times(1 / count, sum), text: name, kind: "name" }];
  });
}
