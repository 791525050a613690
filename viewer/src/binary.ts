/**
 * Arrays of 32-bit numbers in the page: little-endian words, their bytes sorted by significance, deflated, base64.
 */

/** The bytes of base64 text. */
export function fromBase64(text: string): Uint8Array<ArrayBuffer> {
  const native = Uint8Array as unknown as { fromBase64?: (text: string) => Uint8Array<ArrayBuffer> };
  return native.fromBase64?.(text) ?? Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
}

/** Inflates deflated bytes. */
export async function inflate(bytes: Uint8Array<ArrayBuffer>): Promise<Uint8Array<ArrayBuffer>> {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** Words from their four planes of bytes, the least significant plane first. */
export function joinPlanes(planes: Uint8Array): Uint32Array<ArrayBuffer> {
  const count = planes.length >>> 2;
  const words = new Uint32Array(count);
  for (let i = 0; i < count; i++) {
    words[i] = planes[i] | (planes[count + i] << 8) | (planes[2 * count + i] << 16) | (planes[3 * count + i] << 24);
  }
  return words;
}

/** The words of a block; none, if the page has no such block. */
export async function decodeWords(text: string): Promise<Uint32Array<ArrayBuffer>> {
  if (text === "") return new Uint32Array();
  return joinPlanes(await inflate(fromBase64(text)));
}

/** The vertices of elements with `size` vertices each, which are stored as differences to the element before. */
export async function decodeElements(text: string, size: number): Promise<Uint32Array<ArrayBuffer>> {
  const words = await decodeWords(text);
  for (let i = size; i < words.length; i++) {
    words[i] += words[i - size]; // wraps around
  }
  return words;
}

/** Single-precision numbers. */
export async function decodeFloats(text: string): Promise<Float32Array<ArrayBuffer>> {
  return new Float32Array((await decodeWords(text)).buffer);
}
