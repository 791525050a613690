import { Texture } from "three";
import { describe, expect, it, vi } from "vitest";
import { MARKS } from "../src/colours";
import { Frames } from "../src/frames";
import { Incidence } from "../src/incidence";
import { type Point } from "../src/page";
import { type Label, type Labels } from "../src/scene/labels";
import { type Pose } from "../src/scene/pose";
import { dotSize, Stage } from "../src/scene/stage";
import { type Shown } from "../src/source";
import { INITIAL, type State } from "../src/state";
import { pageOf } from "./examples";

/** A view without WebGL, which keeps what it is told. */
const StillView = vi.hoisted(() => class {
  up: Point = [0, 1, 0];
  background = "";
  pose: Pose = { target: [0, 0, 0], position: [0, 0, 1] };
  add(): void {}
  addMark(): void {}
  request(): void {}
  setSpace(up: Point): void {
    // New controls turn around the origin.
    if (up.some((x, axis) => x !== this.up[axis])) this.pose = { ...this.pose, target: [0, 0, 0] };
    this.up = up;
  }
  setBackground(colour: string): void {
    this.background = colour;
  }
  go(to: Pose): void {
    this.pose = to;
  }
});
vi.mock("../src/scene/view", () => ({ View: StillView }));
vi.mock("../src/scene/disc", () => ({ disc: () => new Texture(), ball: () => new Texture() }));

/** A stage, its view, and the places at which it has drawn the only vertex. */
function stageOf(): { stage: Stage; view: InstanceType<typeof StillView>; drawn: number[] } {
  const drawn: number[] = [];
  const set = ([{ at }]: Label[]): void => void drawn.push(at[0]);
  const stage = new Stage({} as HTMLCanvasElement, { set } as unknown as Labels);
  return { stage, view: stage.view as unknown as InstanceType<typeof StillView>, drawn };
}

/** A vertex with a name, which is at x = 10 in frame 10. A frame arrives when it is called. */
function motion(count: number): { shown: Shown; arrive: (...frames: number[]) => Promise<void> } {
  const page = { ...pageOf([...Array(count).keys()]), bodies: [{ name: "a", kind: "", vertices: { start: 0, end: 1 } }] };
  const waiting = new Map<number, () => void>();
  const first = Float32Array.of(0, 0, 0);
  const frames = new Frames(page, first, (frame) => {
    return new Promise((resolve) => waiting.set(frame, () => resolve(Float32Array.of(frame, 0, 0))));
  });
  const groups = { count: 1, of: Uint32Array.of(0) };
  const elements = { faces: new Uint32Array(), edges: new Uint32Array(), points: Uint32Array.of(0), radii: new Float32Array() };
  const shown = { page, frames, elements, parts: groups, groups, incidence: new Incidence(1, elements.faces), place: () => 0 };
  const arrive = async (...frames: number[]): Promise<void> => {
    for (const frame of frames) waiting.get(frame)?.();
    await new Promise((resolve) => setTimeout(resolve));
  };
  return { shown, arrive };
}

const at = (frame: number): State => ({ ...INITIAL, moment: { frame, t: 0 } });

describe("frames that arrive late", () => {
  it("are not drawn over a later choice", async () => {
    const { stage, drawn } = stageOf();
    const { shown, arrive } = motion(100);
    stage.show(shown);
    void stage.update(at(0), INITIAL);
    await arrive(1);
    void stage.update(at(60), {});
    void stage.update(at(0), {});
    await arrive(60, 61);
    expect(drawn).toEqual([0, 0]);
    // The one that is drawn is known.
    void stage.update(at(60), {});
    await arrive();
    expect(drawn).toEqual([0, 0, 60]);
  });

  it("are drawn if nothing later is", async () => {
    const { stage, drawn } = stageOf();
    const { shown, arrive } = motion(100);
    stage.show(shown);
    for (const frame of [20, 30, 40]) void stage.update(at(frame), {});
    await arrive(20, 21);
    await arrive(40, 41);
    await arrive(30, 31);
    expect(drawn).toEqual([20, 40]);
  });

  it("do not delay the colours", () => {
    const { stage, view } = stageOf();
    stage.show(motion(100).shown);
    void stage.update(at(60), { theme: "light" });
    expect(view.background).toBe(MARKS.light.background);
  });
});

describe("the direction upwards", () => {
  it("comes from the data, until another axis is chosen, which other data do not change", () => {
    const { stage, view } = stageOf();
    stage.show(motion(1).shown);
    expect(view.up).toEqual([0, 0, 1]);
    stage.turnUp();
    expect(view.up).toEqual([0, 1, 0]);
    view.pose = { target: [1, 2, 3], position: [4, 5, 6] };
    stage.show(motion(1).shown);
    expect(view.up).toEqual([0, 1, 0]);
    expect(view.pose).toEqual({ target: [1, 2, 3], position: [4, 5, 6] });
    stage.turnUp();
    expect(view.up).toEqual([1, 0, 0]);
  });
});

describe("dots at contacts", () => {
  it("are smaller where there are many, and never vanish", () => {
    expect([1, 200].map(dotSize)).toEqual([7, 7]);
    expect(dotSize(800)).toBe(3.5);
    expect(dotSize(1e6)).toBe(2.5);
  });
});
