import { describe, expect, it } from "vitest";
import { Frames, momentAt, vertexAt } from "../src/frames";
import { type Page } from "../src/page";
import { facesAround, looseVertices, partsOf } from "../src/parts";

const page = (count: number): Page => ({
  format: 1,
  title: "",
  summary: [],
  up: [0, 0, 1],
  vertices: 1,
  faces: 0,
  edges: 0,
  centre: [10, 20, 30],
  scale: 2,
  frames: Array.from({ length: count }, (_, number) => ({ number, label: "" })),
  contacts: [],
  contactCount: 0,
  query: null,
});

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
  it("have faces around a vertex and around an edge", () => {
    const faces = Uint32Array.of(0, 1, 2, 2, 1, 3, 3, 4, 5);
    expect(facesAround(faces, [1])).toEqual([0, 1, 2, 2, 1, 3]);
    expect(facesAround(faces, [2, 1])).toEqual([0, 1, 2, 2, 1, 3]);
    expect(facesAround(faces, [0, 3])).toEqual([]);
    expect(facesAround(faces, [0, 1, 2])).toEqual([]);
  });
});
