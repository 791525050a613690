import { describe, expect, it } from "vitest";
import { type Contact, type Page, parsePage, type Primitive, type Query } from "../src/page";
import { answerOf, facts } from "../src/panel/details";
import { takes } from "../src/keys";
import { contactIds, momentText, primitiveText, short, timeText, vertexName } from "../src/text";
import { pageOf } from "./examples";

const contact: Contact = {
  frame: 1,
  time: 0.123456789012345,
  primitives: [
    { kind: "vertex", id: 7, vertices: [4], labels: [7] },
    { kind: "face", id: 3, vertices: [1, 2, 5], labels: [1, 2, 9] },
  ],
  closest: [
    [1, 2, 3],
    [1, 2, 3],
  ],
  distance: 0,
  normal: null,
  parameters: [0.25, 0.5],
};

const page = (numbers: number[]): Page => ({ ...pageOf(numbers), contacts: [contact], contactCount: 1 });

describe("texts", () => {
  it("of primitives have their vertices", () => {
    const texts = (of: Page): string[] => contact.primitives.map((primitive) => primitiveText(primitive, of));
    expect(texts(page([0, 1]))).toEqual(["vertex 7", "face 3 (vertices 1, 2, 9)"]);
    const edge: Primitive = { kind: "edge", id: null, vertices: [0, 1], labels: [0, 1] };
    expect(primitiveText(edge, page([0, 1]))).toBe("edge (vertices 0, 1)");
    const bodies = [
      { name: "ground", kind: "obstacle", vertices: { start: 0, end: 4 } },
      { name: "cloth", kind: "", vertices: { start: 4, end: 9 } },
    ];
    expect(texts({ ...page([0, 1]), bodies })).toEqual(["vertex 7 of cloth", "face 3 (vertices 1, 2, 9) of ground"]);
  });
  it("of half spaces have their numbers and names", () => {
    const halfSpace: Primitive = { kind: "half-space", id: 0, vertices: [], labels: [] };
    const halfSpaces = [{ name: "", point: [0, 0, 0] as const, normal: [0, 0, 1] as const }];
    expect(primitiveText(halfSpace, { ...page([0]), halfSpaces })).toBe("half space 0");
    expect(primitiveText(halfSpace, { ...page([0]), halfSpaces: [{ ...halfSpaces[0], name: "floor" }] })).toBe("half space 0 of floor");
  });
  it("of a contact at rest name its frame", () => {
    const rest: Contact = { ...contact, frame: 2, time: 0, parameters: null };
    expect(timeText(page([0, 4, 5]), rest)).toBe("frame 5: 5 s");
    expect(timeText(page([0, 1]), { ...rest, frame: 0 })).toBe("t = 0");
  });
  it("of a frame do not repeat its number", () => {
    const rest: Contact = { ...contact, frame: 0, time: 0, parameters: null };
    const one = page([3]);
    const numbered = { ...one, frames: one.frames.map((frame) => ({ ...frame, label: "frame 3" })) };
    expect(timeText(numbered, rest)).toBe("frame 3");
    const two = page([3, 4, 5]);
    const frames = two.frames.map((frame) => ({ ...frame, label: `frame ${frame.number}` }));
    expect(momentText({ ...two, frames }, { frame: 1, t: 0 })).toBe("frame 4");
  });
  it("in the scene are the ids of the file, as in the list", () => {
    const [vertex, face] = contact.primitives;
    expect(vertexName(page([0, 1]), vertex, 0)).toBe("7");
    expect([0, 1, 2].map((i) => vertexName(page([0, 1]), face, i))).toEqual(["1", "2", "9"]);
  });
  it("of a query have the names of its points, in the list and in the scene", () => {
    const of = (kind: Query["kind"], ...all: number[][]): string[][] => {
      const primitives = all.map((vertices): Primitive => {
        return { kind: vertices.length === 1 ? "vertex" : vertices.length === 2 ? "edge" : "face", id: null, vertices, labels: vertices };
      }) as Query["primitives"];
      const query: Query = { kind, points: [[], []], primitives, stage: "", separation: 0, times: [], distances: [] };
      const shown = { ...page([0, 1]), query };
      return primitives.map((primitive) => [
        primitiveText(primitive, shown),
        ...primitive.vertices.map((_, i) => vertexName(shown, primitive, i)),
      ]);
    };
    expect(of("vertex-face", [0], [1, 2, 3])).toEqual([["vertex", "p"], ["face (vertices v₁, v₂, v₃)", "v₁", "v₂", "v₃"]]);
    expect(of("edge-edge", [0, 1], [2, 3])).toEqual([["edge (vertices a₀, a₁)", "a₀", "a₁"], ["edge (vertices b₀, b₁)", "b₀", "b₁"]]);
    // A vertex in place of an edge occurs twice among the points.
    expect(of("vertex-edge", [0], [2, 3])).toEqual([["vertex", "p"], ["edge (vertices a, b)", "a", "b"]]);
    expect(of("vertex-vertex", [0], [2])).toEqual([["vertex", "p"], ["vertex", "q"]]);
  });
  it("of contact times have all digits, and the frames if there are more than two", () => {
    expect(timeText(page([0, 1]), { ...contact, frame: 0 })).toBe("t = 0.123456789012345");
    expect(timeText(page([0, 1]), { ...contact, frame: 1, time: 0 })).toBe("t = 1");
    expect(timeText(page([0, 4, 5]), contact)).toBe("frame 4 to 5, t = 0.123456789012345");
  });
  it("of moments are short", () => {
    expect(momentText(page([0, 1]), { frame: 0, t: 1 / 3 })).toBe("t = 0.3333333");
    expect(momentText(page([0, 1]), { frame: 1, t: 0 })).toBe("t = 1");
    expect(momentText(page([0, 4, 5]), { frame: 1, t: 0.5 })).toBe("frame 4 to 5, t = 0.5");
    expect(momentText(page([0, 4, 5]), { frame: 1, t: 1 })).toBe("frame 5: 5 s");
    expect(momentText(page([3]), { frame: 0, t: 0 })).toBe("3 s");
    expect([0, 1e-9, 1e300].map(short)).toEqual(["0", "1e-9", "1e+300"]);
  });
  it("of contacts are found by ids of primitives and vertices", () => {
    expect(contactIds(contact)).toEqual([7, 3, 1, 2, 9]);
  });
  it("name a contact without a normal", () => {
    const terms = facts(page([0, 1]), contact).map(([term, text]) => `${term}: ${text}`);
    expect(terms).toContain("normal: none: they rest on each other, or slide");
    expect(terms.some((term) => term.startsWith("distance"))).toBe(false);
    expect(facts(page([0, 1]), { ...contact, distance: 0.5 })).toContainEqual(["distance", "0.5", ""]);
    expect(terms).toContain("u, v: 0.25, 0.5");
  });
});

describe("the data of a page", () => {
  it("has contacts by the index of their frame, although others were left out", () => {
    const read = parsePage(JSON.stringify({ ...page([0, 4, 5]), contacts: [{ ...contact, frame: 4 }] }));
    expect(read.contacts[0].frame).toBe(1);
  });
  it("must have the format of this program", () => {
    expect(() => parsePage('{"format": 1}')).toThrow("format 1, expected 2");
  });
  it("has the verdict as its headline, or else the first line", () => {
    const summary = ["a note", "another one"];
    expect(answerOf({ ...page([0]), summary, verdict: "free of contact" })).toEqual(["free of contact", summary]);
    expect(answerOf({ ...page([0]), summary })).toEqual(["a note", ["another one"]]);
  });
});

describe("keys", () => {
  const slider = (id: string) => ({ tagName: "INPUT", type: "range", id });
  it("that move a slider are its own", () => {
    for (const key of ["ArrowLeft", "ArrowDown", "Home", "PageUp"]) expect(takes(slider("opacity"), key)).toBe(true);
    for (const key of ["a", " ", "?"]) expect(takes(slider("opacity"), key)).toBe(false);
    expect(takes(slider("slider"), "ArrowLeft")).toBe(false);
    expect(takes(slider("slider"), "Home")).toBe(true);
  });
  it("belong to the page elsewhere, but not in a field for text", () => {
    expect(takes({ tagName: "CANVAS", id: "scene" }, "ArrowLeft")).toBe(false);
    expect(takes({ tagName: "INPUT", type: "search" }, "a")).toBe(true);
    expect(takes({ tagName: "BUTTON" }, " ")).toBe(true);
    expect(takes({ tagName: "BUTTON" }, "a")).toBe(false);
    expect(takes({ tagName: "INPUT", type: "checkbox" }, " ")).toBe(true);
  });
});
