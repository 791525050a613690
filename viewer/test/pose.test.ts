import { describe, expect, it } from "vitest";
import { edgesOf } from "../src/scene/mesh";
import { ANGLE, contactPose, overview } from "../src/scene/pose";
import { type Point } from "../src/page";
import { dot, length, subtract, unit } from "../src/vector";

const UP: Point = [0, 0, 1];

describe("the camera on a contact", () => {
  const point: Point = [1, 2, 3];
  const corners: Point[] = [[1, 2, 4], [0, 2, 3], [2, 2, 3], [1, 3, 3]];
  const normals: (Point | null)[] = [[0, 0, 1], [0, 0, -1], [1, 0, 0], [0, 1, 0], unit([1, 1, 1], UP), null];

  it.each(normals.map((normal) => ({ normal })))("sees it from outside and above the plane: $normal", ({ normal }) => {
    const { target, position } = contactPose(point, normal, corners, [0, 0, 0], 5, UP, 0.5);
    expect(target).toEqual(point);
    const towards = unit(subtract(position, target), UP);
    if (normal !== null) {
      const above = Math.abs(dot(towards, normal));
      expect(above).toBeGreaterThan(0.3);
      expect(above).toBeLessThan(0.95);
    }
    // Not along the axis around which the camera turns.
    expect(Math.abs(dot(towards, UP))).toBeLessThan(0.98);
    // The corners, at most 1 away, fill half of the height.
    const height = length(subtract(position, target)) * Math.sin((ANGLE / 2) * (Math.PI / 180));
    expect(height).toBeCloseTo(2, 10);
  });

  it("has a distance for primitives without extent", () => {
    const { position } = contactPose(point, [0, 0, 1], [point], [0, 0, 0], 5, UP, 0.5);
    expect(length(subtract(position, point))).toBeGreaterThan(0);
  });
});

describe("the camera on everything", () => {
  const directions: Point[] = [[0, 0, 1], [0, 1, 0], [-1, 0, 0]];
  it.each(directions.map((up) => ({ up })))("is above: up $up", ({ up }) => {
    expect(dot(overview([0, 0, 0], 1, up).position, up)).toBeGreaterThan(0);
  });
});

describe("edges of faces", () => {
  it("occur once", () => {
    expect([...edgesOf(Uint32Array.of(0, 1, 2, 2, 1, 3))]).toEqual([0, 1, 0, 2, 1, 2, 1, 3, 2, 3]);
  });
});
