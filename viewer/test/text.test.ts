import { describe, expect, it } from "vitest";
import { type Contact, type Page, parsePage } from "../src/page";
import { facts } from "../src/panel/details";
import { contactIds, momentText, primitiveText, short, timeText } from "../src/text";

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

const page = (numbers: number[]): Page => ({
  format: 1,
  title: "",
  summary: [],
  up: [0, 0, 1],
  vertices: 10,
  faces: 4,
  edges: 0,
  centre: [0, 0, 0],
  scale: 1,
  frames: numbers.map((number) => ({ number, label: `${number} s` })),
  contacts: [contact],
  contactCount: 1,
  query: null,
});

describe("texts", () => {
  it("of primitives have their vertices", () => {
    expect(contact.primitives.map(primitiveText)).toEqual(["vertex 7", "face 3 (vertices 1, 2, 9)"]);
    expect(primitiveText({ kind: "edge", id: null, vertices: [0, 1], labels: [0, 1] })).toBe("edge (vertices 0, 1)");
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
    expect(() => parsePage('{"format": 2}')).toThrow("format 2, expected 1");
  });
});
