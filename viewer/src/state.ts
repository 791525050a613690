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
