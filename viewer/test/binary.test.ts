import { deflateRawSync } from "node:zlib";
import { describe, expect, it } from "vitest";
import { decodeElements, decodeFloats, decodeWords, fromBase64 } from "../src/binary";

/** The block of words, independently of the decoder. */
function block(words: Uint32Array): string {
  const bytes = new Uint8Array(words.buffer);
  const planes = [0, 1, 2, 3].flatMap((plane) => [...words.keys()].map((i) => bytes[4 * i + plane]));
  return deflateRawSync(Uint8Array.from(planes)).toString("base64");
}

describe("blocks", () => {
  it("keep every bit of a word", async () => {
    const words = Uint32Array.of(0, 1, 0x01020304, 0xffffffff, 0x80000000);
    expect(await decodeWords(block(words))).toEqual(words);
  });

  it("keep floats", async () => {
    const floats = Float32Array.of(0, -0, 1.5, -3.4028234663852886e38, 1e-45);
    expect(await decodeFloats(block(new Uint32Array(floats.buffer)))).toEqual(floats);
  });

  it("sum the differences of elements, modulo 2^32", async () => {
    const differences = Uint32Array.of(7, 8, 9, 0xfffffffe, 1, 0);
    expect(await decodeElements(block(differences), 3)).toEqual(Uint32Array.of(7, 8, 9, 5, 9, 9));
  });

  it("may be empty", async () => {
    expect(await decodeElements(block(new Uint32Array(0)), 2)).toHaveLength(0);
  });

  it("are base64 with padding", () => {
    expect([...fromBase64("/wA=")]).toEqual([255, 0]);
  });
});
