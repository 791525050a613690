/** The positions of the vertices in each frame, decoded when they are needed. */

import { type Page, type Point } from "./page";

/** A time of the motion: t from 0 to 1 between a frame and the next. */
export interface Moment {
  frame: number;
  t: number;
}

/** The moment `frame + t` frames after the start, for a motion of `count` frames. */
export function momentAt(position: number, count: number): Moment {
  const last = Math.max(count - 2, 0);
  const clamped = Math.min(Math.max(position, 0), Math.max(count - 1, 0));
  const frame = Math.min(Math.floor(clamped), last);
  return { frame, t: clamped - frame };
}

/** The number of frames kept decoded, beside the first. */
const KEPT = 6;

export class Frames {
  readonly count: number;
  private readonly decoded = new Map<number, Promise<Float32Array<ArrayBuffer>>>();

  /** `displacements` decodes the displacements from the first frame, or the positions for frame 0. */
  constructor(
    readonly page: Page,
    readonly first: Float32Array<ArrayBuffer>,
    private readonly displacements: (frame: number) => Promise<Float32Array<ArrayBuffer>>,
  ) {
    this.count = page.frames.length;
  }

  /** The positions in a frame, in units of the page. */
  at(frame: number): Promise<Float32Array<ArrayBuffer>> {
    if (frame === 0) return Promise.resolve(this.first);
    const known = this.decoded.get(frame);
    const positions = known ?? this.displacements(frame).then((moved) => this.displaced(moved));
    // The most recently used one is the last.
    this.decoded.delete(frame);
    this.decoded.set(frame, positions);
    for (const old of this.decoded.keys()) {
      if (this.decoded.size <= KEPT) break;
      this.decoded.delete(old);
    }
    return positions;
  }

  private displaced(moved: Float32Array<ArrayBuffer>): Float32Array<ArrayBuffer> {
    for (let i = 0; i < moved.length; i++) moved[i] += this.first[i];
    return moved;
  }

  /** The positions at both ends of the step that contains a moment; the same for a single frame. */
  async ends(moment: Moment): Promise<[Float32Array<ArrayBuffer>, Float32Array<ArrayBuffer>]> {
    const next = Math.min(moment.frame + 1, this.count - 1);
    return Promise.all([this.at(moment.frame), this.at(next)]);
  }

  /** A point of the world, in units of the page. */
  toPage(point: Point): Point {
    const { center, scale } = this.page;
    const along = (axis: 0 | 1 | 2): number => (point[axis] - center[axis]) / scale;
    return [along(0), along(1), along(2)];
  }

  /** The point of the world of a point in units of the page. */
  toWorld(point: Point): Point {
    const { center, scale } = this.page;
    const along = (axis: 0 | 1 | 2): number => center[axis] + scale * point[axis];
    return [along(0), along(1), along(2)];
  }
}

/** The position of a vertex at time t of a step. */
export function vertexAt(vertex: number, [start, end]: [Float32Array, Float32Array], t: number): Point {
  const along = (axis: number): number => {
    const i = 3 * vertex + axis;
    return (1 - t) * start[i] + t * end[i];
  };
  return [along(0), along(1), along(2)];
}
