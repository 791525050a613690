/** The state of the page that its parts observe. */

import { type Moment } from "./frames";
import { type Theme } from "./colours";

export interface State {
  moment: Moment;
  /** The index of the selected contact. */
  contact: number | null;
  playing: boolean;
  theme: Theme;
  /** The opacity of the mesh, from 0 to 1. */
  opacity: number;
  wireframe: boolean;
  paths: boolean;
  labels: boolean;
  /** The names of bodies are in the scene. */
  names: boolean;
  /** The bodies that are not drawn. */
  hidden: ReadonlySet<number>;
}

export type Change = Partial<State>;

/** The state at the start. */
export const INITIAL: State = {
  moment: { frame: 0, t: 0 },
  contact: null,
  playing: false,
  theme: "light",
  opacity: 1,
  wireframe: true,
  paths: true,
  labels: true,
  names: true,
  hidden: new Set(),
};

export class Store {
  private readonly observers: ((state: State, change: Change) => void)[] = [];

  constructor(private current: State) {}

  get state(): Readonly<State> {
    return this.current;
  }

  /** Calls `observer` after each change. */
  observe(observer: (state: State, change: Change) => void): void {
    this.observers.push(observer);
  }

  set(change: Change): void {
    this.current = { ...this.current, ...change };
    for (const observer of this.observers) observer(this.current, change);
  }
}
