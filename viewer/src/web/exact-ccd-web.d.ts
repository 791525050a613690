/** The WebAssembly module, from the crate in bindings/web: JavaScript that wasm-bindgen writes. */
declare module "exact-ccd-web" {
  /** Compiles the module. It is called once, before all others. */
  export function initSync(options: { module: BufferSource }): void;

  /** The answer to a query, as JSON. */
  export function answerQuery(kind: string, coordinates: Float64Array, distance: number, tolerance: number): string;

  /** The motion of a mesh between two files. */
  export class Motion {
    constructor(startName: string, start: Uint8Array, endName: string, end: Uint8Array);
    /** The texts of the page of all contacts, as JSON. */
    contacts(distance: number): string;
    /** The earliest contact according to the root finder, as JSON. */
    rootFinder(distance: number): string;
    /** The coordinates of vertices at t = 0, then at t = 1. */
    coordinates(vertices: Uint32Array): Float64Array;
    free(): void;
  }
}
