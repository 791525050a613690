import { describe, expect, it } from "vitest";
import { NumberField } from "../src/web/editor";
import { KINDS } from "../src/kinds";
import { pointCount, replaced } from "../src/web/entry";
import { rounded } from "../src/web/handles";
import { Latest } from "../src/web/kernel";
import { decode, hexadecimal, neighbour, parseNumber } from "../src/web/numbers";
import { PRESETS } from "../src/web/presets";
import { compare, VerdictPanel } from "../src/web/verdict";

const EXTREMES = [0, -0, 1, -1, 0.1, -1 / 3, 1e300, Number.MAX_VALUE, Number.MIN_VALUE, -(2 ** -1022), 2 ** -1022 - 2 ** -1074, 5e-310, 2 ** 53 + 2];

describe("numbers", () => {
  it.each(EXTREMES)("are the same as decimals and as hexadecimal floats: %s", (x) => {
    expect(parseNumber(String(x) === "0" && Object.is(x, -0) ? "-0" : String(x))).toBe(x);
    expect(parseNumber(hexadecimal(x))).toBe(x);
  });
  it.each(EXTREMES.filter((x) => x !== 0))("are an integer times a power of two: %s", (x) => {
    const [mantissa, exponent] = decode(x);
    expect(mantissa * 2n ** BigInt(exponent + 1074)).toBe(decode(x)[0] << BigInt(exponent + 1074));
    expect(Number(mantissa) * 2 ** Math.trunc(exponent / 2) * 2 ** (exponent - Math.trunc(exponent / 2))).toBe(x);
  });
  it("are written as in C", () => {
    expect([1, -1.5, 0.1, 2 ** -1074].map(hexadecimal)).toEqual(["0x1p+0", "-0x1.8p+0", "0x1.999999999999ap-4", "0x1p-1074"]);
  });
  it("may have any number of digits", () => {
    expect(parseNumber("0x.8")).toBe(0.5);
    expect(parseNumber("0xFF.p0")).toBe(255);
    expect(parseNumber(" +1.5e-3 ")).toBe(0.0015);
    expect(parseNumber(".5")).toBe(0.5);
    expect(parseNumber("0x1.00000000000000000p0")).toBe(1);
  });
  it.each(["", "x", "1,5", "1e999", "0x", "0x1p", "0x1.00000000000001p0", "0x1p-1075", "0x1p1024", "Infinity", "NaN"])(
    "are refused with a reason: %s",
    (text) => expect(typeof parseNumber(text)).toBe("string"),
  );
  it.each(EXTREMES.slice(2))("have neighbours: %s", (x) => {
    for (const direction of [1, -1] as const) {
      const next = neighbour(x, direction);
      expect(Math.sign(next - x)).toBe(direction);
      if (Number.isFinite(next)) expect(neighbour(next, direction === 1 ? -1 : 1)).toBe(x);
    }
  });
});

describe("a field for a number", () => {
  /** The part of an element that a field uses. */
  class Input extends EventTarget {
    value = "";
    title = "";
    ariaInvalid = "";
    validationMessage = "";
    setCustomValidity(message: string): void {
      this.validationMessage = message;
    }
    enter(text: string): void {
      this.value = text;
      this.dispatchEvent(new Event("input"));
    }
    press(key: string, shiftKey = false): void {
      this.dispatchEvent(Object.assign(new Event("keydown"), { key, shiftKey }));
    }
  }
  const fieldOf = (value: number): { input: Input; field: NumberField; entered: number[] } => {
    const [input, entered] = [new Input(), [] as number[]];
    const field = new NumberField(input as unknown as HTMLInputElement, (x) => entered.push(x));
    field.show(value);
    return { input, field, entered };
  };

  it("shows a number that came from elsewhere", () => {
    expect([0, -0, 0.1].map((x) => fieldOf(x).input.value)).toEqual(["0", "-0", "0.1"]);
  });
  it.each([["ArrowUp", Number.MAX_VALUE], ["ArrowDown", -Number.MAX_VALUE]])("has a largest number: %s at %s", (key, most) => {
    const { input, entered } = fieldOf(most);
    for (const shift of [false, true]) input.press(key, shift);
    expect(entered).toEqual([]);
    expect(input.value).toBe(String(most));
    input.press(key === "ArrowUp" ? "ArrowDown" : "ArrowUp", true);
    expect(entered).toEqual([Math.sign(most) * (Number.MAX_VALUE - 2 ** 971)]);
  });
  it.each(["x", ""])("does not keep a text that is no number: '%s'", (text) => {
    const { input, field, entered } = fieldOf(0);
    input.enter(text);
    expect([input.ariaInvalid, entered]).toEqual(["true", []]);
    field.show(0);
    expect([input.value, input.ariaInvalid, input.validationMessage]).toEqual(["0", "false", ""]);
  });
  it("keeps the notation of a number", () => {
    const { input, field, entered } = fieldOf(0);
    input.enter("0x1.8p0");
    field.show(1.5);
    expect([input.value, entered]).toEqual(["0x1.8p0", [1.5]]);
  });
});

describe("the judgement of the root finder", () => {
  it.each([
    [null, false, null, "same"],
    [null, true, 0.5, "wrong"],
    [0.5, false, null, "wrong"],
    [0.5, true, 0.5, "same"],
    [0.5, true, 0.5000000000000002, "same"],
    [0.5, true, 0.25, "early"],
    [0.5, true, 0.75, "wrong"],
    [0.5, true, null, "wrong"],
  ])("exact %s, contact %s at %s: %s", (exact, contact, time, level) => {
    expect(compare(exact, { contact, time }).level).toBe(level);
  });
  it("is beside its time", () => {
    const elements = [0, 1, 2].map(() => ({ dataset: {} }) as HTMLElement);
    const panel = new VerdictPanel(elements[0], elements[1], elements[2]);
    const texts = [{ contact: true, time: 0.5 }, { contact: true, time: null }, { contact: false, time: null }, null, undefined].map((finder) => {
      panel.show(0.5, finder);
      return elements[1].textContent;
    });
    expect(texts).toEqual(["t = 0.5", "t = not a number", "no contact", "has no such kind", "…"]);
  });
});

describe("the examples", () => {
  it("have the coordinates of their kinds, and are different", () => {
    for (const { entry } of PRESETS) expect(entry.coordinates).toHaveLength(6 * pointCount(entry.kind));
    expect(new Set(PRESETS.map(({ name }) => name)).size).toBe(PRESETS.length);
    expect(new Set(PRESETS.map(({ entry }) => entry.kind))).toEqual(new Set(Object.keys(KINDS)));
  });
});

describe("a dragged coordinate", () => {
  it("is a short decimal", () => {
    expect(rounded(0.25, 0.123456, 1.5)).toBe(0.37);
    expect(rounded(1e60, 1.2345e60, 1e60)).toBe(2.23e60);
  });
  it("stays as it is if it is hardly moved", () => {
    expect(rounded(1 / 3, 1e-4, 1)).toBe(1 / 3);
  });
  it("replaces the coordinate of the query alone", () => {
    const before = Float64Array.of(1, 2, 3);
    expect([...replaced(before, [[1, 5]])]).toEqual([1, 5, 3]);
    expect([...before]).toEqual([1, 2, 3]);
  });
});

describe("tasks", () => {
  it("replace each other while one runs", async () => {
    const [latest, done] = [new Latest(), [] as number[]];
    const task = (n: number) => async (): Promise<void> => {
      await Promise.resolve();
      done.push(n);
    };
    for (const n of [1, 2, 3]) latest.run(task(n));
    await new Promise((resolve) => setTimeout(resolve, 10));
    expect(done).toEqual([1, 3]);
  });
});
