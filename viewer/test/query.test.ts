import { describe, expect, it } from "vitest";
import { type Point, type Query } from "../src/page";
import { bernstein, cubicOf, rootsOf } from "../src/query/cubic";
import { DomainImage } from "../src/query/image";
import { lastBefore } from "../src/panel/plot";
import { decadesOf, linearTicks, powerTicks, rangeOf, ticksOf, tickText } from "../src/panel/scale";

const query = (kind: Query["kind"], start: Point[], end: Point[]): Query => ({
  kind,
  points: [start, end],
  stage: "",
  separation: 0,
  times: [],
  primitives: [
    { kind: "vertex", id: null, vertices: [0], labels: [0] },
    { kind: "face", id: null, vertices: [1, 2, 3], labels: [1, 2, 3] },
  ],
  distances: [],
});

const FLOOR: Point[] = [[0, 0, 0], [1, 0, 0], [0, 1, 0]];

describe("the coplanarity cubic", () => {
  it("is linear for a vertex that falls onto a face at rest", () => {
    const falling = query("vertex-face", [[0.25, 0.25, 1], ...FLOOR], [[0.25, 0.25, -3], ...FLOOR]);
    const [root, ...others] = rootsOf(cubicOf(falling));
    expect(root).toBeCloseTo(0.25, 12);
    expect(others).toEqual([]);
  });
  it("vanishes at the crossing of two edges", () => {
    const crossing = query(
      "edge-edge",
      [[-1, 0, 2], [1, 0, 2], [0, -1, 0], [0, 1, 0]],
      [[-1, 0, -1], [1, 0, -1], [0, -1, 0], [0, 1, 0]],
    );
    expect(rootsOf(cubicOf(crossing)).map((root) => root.toFixed(9))).toEqual(["0.666666667"]);
  });
  it("has the roots of its factors", () => {
    // (t − 1/4)(t − 1/2)(t − 1) in Bernstein form.
    const value = (t: number): number => (t - 0.25) * (t - 0.5) * (t - 1);
    const coefficients = [-0.125, 0.16666666666666666 - 0.125 + 0.125 / 3, 0, 0];
    const power = [-0.125, 0.875, -1.75, 1];
    coefficients[1] = power[0] + power[1] / 3;
    coefficients[2] = power[0] + (2 * power[1]) / 3 + power[2] / 3;
    expect(bernstein(coefficients, 0.3)).toBeCloseTo(value(0.3), 12);
    expect(rootsOf(coefficients).map((root) => Number(root.toFixed(9)))).toEqual([0.25, 0.5, 1]);
  });
  it("has a double root where it touches zero", () => {
    // (t − 1/2)².
    expect(rootsOf([0.25, -1 / 12, -1 / 12, 0.25]).map((root) => Number(root.toFixed(6)))).toEqual([0.5]);
  });
  it("has no roots if it vanishes", () => {
    expect(rootsOf([0, 0, 0, 0])).toEqual([]);
  });
  it("does not overflow", () => {
    const huge = query("vertex-face", [[1e308, 0, 1e308], ...FLOOR], [[1e308, 0, -1e308], ...FLOOR]);
    expect(cubicOf(huge).every(Number.isFinite)).toBe(true);
  });
});

describe("the image of the domain", () => {
  it("contains the origin at the time of contact", () => {
    const falling = query("vertex-face", [[0, 0, 1], ...FLOOR], [[0, 0, -1], ...FLOOR]);
    expect(new DomainImage(falling).at(0.5)[0]).toEqual([0, 0, 0]);
  });
  it("is a triangle or a parallelogram at one time", () => {
    const points: Point[] = [[0, 0, 0], [1, 0, 0], [0, 0, 1], [0, 1, 1]];
    expect(new DomainImage(query("vertex-face", points, points)).slice(0)).toHaveLength(9);
    const [a, b, c, d] = new DomainImage(query("edge-edge", points, points)).at(0);
    for (const axis of [0, 1, 2]) expect(a[axis] + c[axis]).toBe(b[axis] + d[axis]);
  });
  it("is finite for any input", () => {
    const points: Point[] = [[1.7e308, 0, 0], [-1.7e308, 5e-324, 0], [0, 0, 1], [0, 1, 1]];
    expect(new DomainImage(query("edge-edge", points, points)).sides(2).every(Number.isFinite)).toBe(true);
    const same: Point[] = [[0, 0, 0], [0, 0, 0], [0, 0, 0], [0, 0, 0]];
    expect(new DomainImage(query("edge-edge", same, same)).sides(2).every(Number.isFinite)).toBe(true);
  });
});

describe("plots", () => {
  it("leave a margin around the curve and zero", () => {
    expect(rangeOf([1, null, 2])).toEqual([-0.16, 2.16]);
    expect(rangeOf([0, 0])).toEqual([-1, 1]);
  });
  it("have ticks that do not overlap", () => {
    expect(ticksOf([-0.13, 0.005])).toEqual([0, -0.13]);
    expect(ticksOf([3, null, -2])).toEqual([0, -2, 3]);
    expect(ticksOf([0, 0])).toEqual([0]);
  });
  it("have powers of ten around all positive values", () => {
    expect(decadesOf([null, 0, 2e-5, 3e-3])).toEqual([-5, -2]);
    expect(decadesOf([1e-3])).toEqual([-3, -2]);
    expect(decadesOf([null, 0])).toEqual([-1, 1]);
  });
  it("have at most six powers of ten", () => {
    expect(powerTicks(-3, -2)).toEqual([1e-3, 1e-2]);
    expect(powerTicks(0, 11)).toEqual([1, 1e2, 1e4, 1e6, 1e8, 1e10]);
    expect(powerTicks(0, 12)).toEqual([1, 1e3, 1e6, 1e9, 1e12]);
  });
  it("have round times", () => {
    expect(linearTicks(0, 1)).toEqual([0, 0.25, 0.5, 0.75, 1]);
    expect(linearTicks(0, 0.48)).toEqual([0, 0.2, 0.4]);
    expect(linearTicks(3, 12)).toEqual([5, 7.5, 10]);
  });
  it("have the value of the last time that has passed", () => {
    expect([-1, 0, 0.9, 1, 5].map((t) => lastBefore([0, 1, 2], t))).toEqual([-1, 0, 0, 1, 2]);
  });
  it("write small and large numbers with exponents", () => {
    expect([0, 0.25, 1e-5, -123456].map(tickText)).toEqual(["0", "0.25", "1e-5", "-1.23e5"]);
  });
});
