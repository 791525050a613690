import { afterEach, describe, expect, it, vi } from "vitest";
import { Frames, momentAt, vertexAt } from "../src/frames";
import { type Page } from "../src/page";
import { Incidence } from "../src/incidence";
import { momentOf, timeOf } from "../src/panel/history";
import { groupsOf, looseVertices, partsOf } from "../src/parts";
import { play } from "../src/player";
import { INITIAL, Store } from "../src/state";
import { pageOf } from "./examples";

const page = (count: number): Page => ({ ...pageOf([...Array(count).keys()]), center: [10, 20, 30], scale: 2 });

describe("moments", () => {
  it("are a frame and a time of its step", () => {
    expect(momentAt(2.25, 5)).toEqual({ frame: 2, t: 0.25 });
  });
  it("end in the last step", () => {
    expect(momentAt(4, 5)).toEqual({ frame: 3, t: 1 });
    expect(momentAt(9, 5)).toEqual({ frame: 3, t: 1 });
    expect(momentAt(-1, 5)).toEqual({ frame: 0, t: 0 });
  });
  it("are all the same in a single frame", () => {
    expect(momentAt(0.5, 1)).toEqual({ frame: 0, t: 0 });
  });
});

describe("playing", () => {
  afterEach(() => vi.unstubAllGlobals());
  it.each([[0, false], [1, false], [2, true], [9, true]])("of %s frames lasts: %s", (count, lasts) => {
    vi.stubGlobal("requestAnimationFrame", () => 0);
    const store = new Store(INITIAL);
    play(store, () => count);
    store.set({ playing: true });
    expect(store.state.playing).toBe(lasts);
  });
});

describe("frames", () => {
  const first = Float32Array.of(1, 2, 3);
  const decoded: number[] = [];
  const frames = new Frames(page(20), first, async (frame) => {
    decoded.push(frame);
    return Float32Array.of(frame, 0, -frame);
  });

  it("are displaced from the first", async () => {
    expect(await frames.at(0)).toEqual(first);
    expect(await frames.at(7)).toEqual(Float32Array.of(8, 2, -4));
  });
  it("are decoded once while they are in use, and again later", async () => {
    decoded.length = 0;
    await frames.at(1);
    await frames.at(1);
    expect(decoded).toEqual([1]);
    for (let frame = 2; frame < 10; frame++) await frames.at(frame);
    await frames.at(1);
    expect(decoded.filter((frame) => frame === 1)).toHaveLength(2);
  });
  it("give the position between two of them", async () => {
    const ends = await frames.ends({ frame: 18, t: 0.5 });
    expect(vertexAt(0, ends, 0.5)).toEqual([19.5, 2, -15.5]);
  });
  it("convert points of the world", () => {
    expect(frames.toPage([12, 20, 29])).toEqual([1, 0, -0.5]);
  });
});

describe("parts", () => {
  it("are connected by faces and edges", () => {
    // Two faces with a common vertex, an edge to another vertex, and a vertex alone.
    const parts = partsOf(9, Uint32Array.of(5, 6, 1, 1, 2, 3), Uint32Array.of(7, 8));
    expect(parts.count).toBe(4);
    expect([...parts.of]).toEqual([0, 1, 1, 1, 2, 1, 1, 3, 3]);
  });
  it("may be loose vertices", () => {
    expect([...looseVertices(6, Uint32Array.of(0, 1, 2), Uint32Array.of(4, 1))]).toEqual([3, 5]);
  });
  it("have a colour each, but loose vertices one for all", () => {
    const [faces, edges] = [Uint32Array.of(1, 2, 3), Uint32Array.of(4, 5)];
    const parts = partsOf(9, faces, edges);
    const points = looseVertices(9, faces, edges);
    expect([...groupsOf(parts, [], points).of]).toEqual([0, 1, 1, 1, 2, 2, 0, 0, 0]);
    const body = (name: string, start: number, end: number) => ({ name, kind: "", vertices: { start, end } });
    const bodies = groupsOf(parts, [body("a", 0, 4), body("b", 4, 9)], points);
    expect(bodies.count).toBe(2);
    expect([...bodies.of]).toEqual([0, 0, 0, 0, 1, 1, 1, 1, 1]);
  });
});

describe("the faces around primitives", () => {
  const faces = Uint32Array.of(0, 1, 2, 2, 1, 3, 3, 4, 5);
  it("have all vertices of them and one more", () => {
    const incidence = new Incidence(7, faces);
    expect(incidence.around([1])).toEqual([0, 1, 2, 2, 1, 3]);
    expect(incidence.around([2, 1])).toEqual([0, 1, 2, 2, 1, 3]);
    expect(incidence.around([0, 3])).toEqual([]);
    expect(incidence.around([0, 1, 2])).toEqual([]);
    expect(incidence.around([6])).toEqual([]);
    expect(incidence.around([])).toEqual([]);
  });

  it("are found in one scan of all faces, whatever the number of pictures", () => {
    // A strip of faces, whose corners are counted when they are read.
    const count = 1000;
    const strip = Uint32Array.from({ length: 3 * count }, (_, i) => Math.floor(i / 3) + (i % 3));
    let reads = 0;
    const counted = new Proxy(strip, {
      get(target, key) {
        if (typeof key === "string" && /^\d+$/.test(key)) reads++;
        const value: unknown = Reflect.get(target, key, target);
        if (typeof value !== "function") return value;
        // A method reads as many corners as it returns.
        return (...values: number[]): unknown => {
          const result: unknown = (value as (...values: number[]) => unknown).apply(target, values);
          reads += result instanceof Uint32Array ? result.length : strip.length;
          return result;
        };
      },
    });
    const incidence = new Incidence(count + 2, counted);
    const pictures = 200;
    for (let i = 0; i < pictures; i++) {
      expect(incidence.around([500])).toHaveLength(9);
      expect(incidence.around([500, 501])).toHaveLength(6);
    }
    expect(reads).toBeLessThanOrEqual(strip.length + 2 * 9 * pictures);
  });
});

describe("the time of a simulation", () => {
  // Frames were left out: the remaining ones have the numbers 0, 2 and 3.
  const motion: Page = {
    ...page(3),
    frames: [0, 2, 3].map((number) => ({ number, label: "" })),
    history: { times: [1, 1.5, 2, 4], charts: [] },
  };
  it("is between the times of the frames", () => {
    expect(timeOf(motion, { frame: 0, t: 0 })).toBe(1);
    expect(timeOf(motion, { frame: 0, t: 0.5 })).toBe(1.5);
    expect(timeOf(motion, { frame: 1, t: 0.25 })).toBe(2.5);
    expect(timeOf(motion, { frame: 1, t: 1 })).toBe(4);
  });
  it("is the time of a moment", () => {
    for (const time of [1, 1.25, 2, 3, 4]) expect(timeOf(motion, momentOf(motion, time))).toBeCloseTo(time, 12);
    expect(momentOf(motion, 0)).toEqual({ frame: 0, t: 0 });
    expect(momentOf(motion, 9)).toEqual({ frame: 1, t: 1 });
  });
});
