/** The messages between the page and the worker in which the kernel runs. */

import { type Kind } from "../kinds";

/** The answer of a floating-point root finder. */
export interface Verdict {
  contact: boolean;
  /** None without contact, or if it is not finite. */
  time: number | null;
}

export interface QueryAnswer {
  /** The texts of the page, by their ids. */
  page: Record<string, string>;
  /** None for kinds without a root finder. */
  rootFinder: Verdict | null;
}

export interface NamedFile {
  name: string;
  bytes: Uint8Array;
}

/** The functions of the kernel: their arguments and results. */
export interface Functions {
  /** Compiles the module. */
  start: [[module: ArrayBuffer], null];
  query: [[kind: Kind, coordinates: Float64Array, distance: number, tolerance: number], QueryAnswer];
  /** Reads two mesh files, which all later calls are about. */
  read: [[start: NamedFile, end: NamedFile], null];
  /** All contacts of the two files, as the texts of the page. */
  contacts: [[distance: number], Record<string, string>];
  /** The earliest contact according to the root finder. */
  rootFinder: [[distance: number], Verdict];
  /** The coordinates of vertices at t = 0, then at t = 1. */
  coordinates: [[vertices: Uint32Array], Float64Array];
}

export type Name = keyof Functions;
export type Arguments<N extends Name> = Functions[N][0];
export type Result<N extends Name> = Functions[N][1];

export interface Request {
  id: number;
  name: Name;
  arguments: unknown[];
}

export type Response = { id: number; result: unknown } | { id: number; error: string };
