import { describe, expect, it } from "vitest";
import { edgesOf } from "../src/scene/mesh";
import { ANGLE, commonLine, contactPose, magnified, moved, overview, turned } from "../src/scene/pose";
import { type Point } from "../src/page";
import { axesOf, foot, squareOf } from "../src/scene/planes";
import { cross, dot, length, subtract, unit } from "../src/vector";

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

  it("sees primitives on one line from the side", () => {
    // Two edges along the x axis, that fall onto each other.
    const edges: Point[] = [[-1, 0, 0], [1, 0, 0], [-0.5, 0, 0], [1.5, 0, 0]];
    const line = commonLine(edges);
    expect(line.map(Math.abs)).toEqual([1, 0, 0]);
    expect(commonLine(corners)).toEqual([0, 0, 0]);
    expect(commonLine([point])).toEqual([0, 0, 0]);
    for (const center of [[-9, 0, -9], [9, 0, -9], [0, 9, 0]] as Point[]) {
      const { position } = contactPose([0, 0, 0], [0, 0, 1], edges, center, 2, UP, 0.75, line);
      expect(Math.abs(dot(unit(position, UP), line))).toBeLessThan(0.75);
    }
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

describe("the camera by keys", () => {
  const pose = { target: [1, 2, 3] as Point, position: [4, 6, 3] as Point };
  const away = (of: typeof pose | ReturnType<typeof turned>): Point => subtract(of.position, of.target);

  it("turns around its target at the same distance", () => {
    for (const [right, above] of [[0.3, 0], [0, 0.4], [-1, -0.2], [0, 9]]) {
      const next = turned(pose, UP, right, above);
      expect(next.target).toEqual(pose.target);
      expect(length(away(next))).toBeCloseTo(5, 12);
      // Not beyond the axis upwards.
      expect(Math.abs(dot(away(next), UP))).toBeLessThan(5);
    }
    expect(turned(pose, UP, 0.3, 0).position[2]).toBeCloseTo(3, 12);
    expect(turned(pose, UP, 0, 0.4).position[2]).toBeCloseTo(3 + 5 * Math.sin(0.4), 12);
    const right = cross(UP, away(pose));
    expect(dot(subtract(turned(pose, UP, 0.1, 0).position, pose.position), right)).toBeGreaterThan(0);
  });

  it("comes back by the opposite turn", () => {
    const back = turned(turned(pose, UP, 0.7, 0.3), UP, -0.7, -0.3);
    back.position.forEach((x, axis) => expect(x).toBeCloseTo(pose.position[axis], 12));
  });

  it("moves across the view with its target", () => {
    const next = moved(pose, UP, 0.1, 0.2);
    const by = subtract(next.target, pose.target);
    subtract(next.position, pose.position).forEach((x, axis) => expect(x).toBeCloseTo(by[axis], 12));
    expect(dot(by, away(pose))).toBeCloseTo(0, 12);
    expect(by[2]).toBeCloseTo(1, 12);
  });

  it("comes nearer", () => {
    expect(length(away(magnified(pose, 2)))).toBeCloseTo(2.5, 12);
  });
});

describe("the boundary of a half space", () => {
  const normals: Point[] = [[0, 0, 1], [0, -1, 0], unit([1, 2, -3], UP)];
  it.each(normals.map((normal) => ({ normal })))("is a square in the plane: normal $normal", ({ normal }) => {
    const plane = { point: [1, 1, 1] as Point, normal };
    const middle = foot(plane, [4, -2, 7]);
    const corners = squareOf(middle, normal, 2);
    for (const corner of corners) {
      expect(dot(normal, subtract(corner, plane.point))).toBeCloseTo(0, 12);
      expect(length(subtract(corner, middle))).toBeCloseTo(Math.sqrt(8), 12);
    }
    // Counterclockwise for a viewer at whom the normal points.
    const turn = cross(subtract(corners[1], corners[0]), subtract(corners[2], corners[1]));
    expect(dot(turn, normal)).toBeCloseTo(16, 12);
    const [a, b] = axesOf(normal);
    expect(dot(cross(a, b), normal)).toBeCloseTo(1, 12);
  });
});
