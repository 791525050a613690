/** The worker: runs the kernel, so that the page answers to the mouse meanwhile. */

import { answerQuery, initSync, Motion } from "exact-ccd-web";
import { type Arguments, type Name, type QueryAnswer, type Request, type Response, type Result, type Verdict } from "./protocol";

let motion: Motion | null = null;

function present(): Motion {
  if (motion === null) throw new Error("no files have been read");
  return motion;
}

const functions: { [N in Name]: (...values: Arguments<N>) => Result<N> } = {
  start: (module) => {
    initSync({ module });
    return null;
  },
  query: (kind, coordinates, distance, tolerance) =>
    JSON.parse(answerQuery(kind, coordinates, distance, tolerance)) as QueryAnswer,
  read: (start, end) => {
    const read = new Motion(start.name, start.bytes, end.name, end.bytes);
    motion?.free();
    motion = read;
    return null;
  },
  contacts: (distance) => JSON.parse(present().contacts(distance)) as Record<string, string>,
  rootFinder: (distance) => JSON.parse(present().rootFinder(distance)) as Verdict,
  coordinates: (vertices) => present().coordinates(vertices),
};

function answer({ id, name, arguments: values }: Request): Response {
  try {
    const call = functions[name] as (...values: unknown[]) => unknown;
    return { id, result: call(...values) };
  } catch (error) {
    return { id, error: error instanceof Error ? error.message : String(error) };
  }
}

self.addEventListener("message", ({ data }: MessageEvent<Request>) => self.postMessage(answer(data)));
