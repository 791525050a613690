/** The viewer: makes its parts, connects them by the state, and shows what it is given. */

import { byId } from "./elements";
import { type Moment, momentAt } from "./frames";
import { listen } from "./keys";
import { type Page } from "./page";
import { showFacts, showLegend, showSummary } from "./panel/details";
import { BodyList } from "./panel/bodies";
import { HistoryPanel } from "./panel/history";
import { ContactList } from "./panel/list";
import { Slider } from "./panel/slider";
import { play } from "./player";
import { QueryPanel } from "./query/panel";
import { Labels } from "./scene/labels";
import { magnified, moved, turned } from "./scene/pose";
import { Stage } from "./scene/stage";
import { type Shown } from "./source";
import { type Change, INITIAL, type State, Store } from "./state";

/** Meshes up to this number of faces open with the edges of their faces. */
const FEW_FACES = 60_000;

/** The names of bodies to which the scene gives none. They are in the scene on demand only. */
const NUMBERED = /^body-\d+$/;

/** The opacity of a mesh with contacts, so that they are visible inside of it. */
const CLEAR = 0.7;

/** The steps of the camera by keys: an angle in radians, a fraction of the distance, a factor. */
const [TURN, SHIFT, NEARER] = [Math.PI / 24, 0.06, 1.15];

export class Viewer {
  readonly stage: Stage;
  readonly store: Store;
  private shown: Shown | null = null;
  private readonly list: ContactList;
  private readonly slider: Slider;
  private readonly query: QueryPanel;
  private readonly bodies: BodyList;
  private readonly history: HistoryPanel;

  constructor() {
    const dark = window.matchMedia("(prefers-color-scheme: dark)").matches;
    this.store = new Store({ ...INITIAL, theme: dark ? "dark" : "light" });
    const choose = (moment: Moment): void => this.store.set({ moment, playing: false });
    this.stage = new Stage(byId("scene", HTMLCanvasElement), new Labels(byId("labels", HTMLElement)));
    this.slider = new Slider(byId("slider", HTMLInputElement), byId("ticks", HTMLCanvasElement), byId("moment", HTMLElement), choose);
    this.list = new ContactList(byId("scroller", HTMLElement), byId("rows", HTMLElement), (contact) => this.select(contact));
    this.query = new QueryPanel(byId("plots", HTMLElement), byId("image", HTMLCanvasElement), (t) => choose({ frame: 0, t }));
    const fit = (body: number): void => this.stage.fitBody(this.store.state, body);
    this.bodies = new BodyList(byId("bodies", HTMLElement), fit, (hidden) => this.store.set({ hidden }));
    this.history = new HistoryPanel(byId("history", HTMLElement), choose);
    const filter = byId("filter", HTMLInputElement);
    filter.addEventListener("input", () => this.list.filter(filter.value));
    this.store.observe((state, change) => this.draw(state, change));
    play(this.store, () => this.page?.frames.length ?? 0);
    this.connect();
  }

  get page(): Page | null {
    return this.shown?.page ?? null;
  }

  /** Shows data from the start, at the earliest contact, and marks the page as ready. */
  async open(shown: Shown): Promise<void> {
    const { page } = shown;
    const earliest = page.contacts[0];
    this.set(shown);
    this.store.set({
      ...this.store.state,
      contact: earliest === undefined ? null : 0,
      moment: earliest === undefined ? { frame: 0, t: 0 } : { frame: earliest.frame, t: earliest.time },
      playing: false,
      opacity: page.faces === 0 || (earliest === undefined && page.query === null) ? 1 : CLEAR,
      wireframe: page.faces <= FEW_FACES,
      hidden: new Set(),
      names: page.bodies.length > 1 && page.bodies.some(({ name }) => !NUMBERED.test(name)),
    });
    await this.stage.near(this.store.state, true);
    byId("message", HTMLElement).hidden = true;
    document.documentElement.dataset["ready"] = "true";
  }

  /** Shows other data of the same kind: the camera stays where it is, and so does the time, unless it was the time of
   * the contact. */
  replace(shown: Shown): void {
    const { state } = this.store;
    const before = state.contact === null ? undefined : this.page?.contacts[state.contact];
    const follows = before === undefined || (before.frame === state.moment.frame && before.time === state.moment.t);
    const earliest = shown.page.contacts[0];
    this.set(shown);
    const moment = follows && earliest !== undefined ? { frame: earliest.frame, t: earliest.time } : state.moment;
    this.store.set({ ...state, contact: earliest === undefined ? null : 0, moment });
  }

  private set(shown: Shown): void {
    const { page, parts, place } = shown;
    this.shown = shown;
    document.title = page.title;
    this.stage.show(shown);
    this.slider.show(page, place);
    this.list.show(page, place);
    this.query.show(page.query);
    this.bodies.show(page);
    this.history.show(page);
    byId("filter", HTMLInputElement).value = "";
    byId("query", HTMLElement).hidden = page.query === null;
    const isAlone = page.contacts.length === 0 && page.query === null;
    byId("parts", HTMLDetailsElement).hidden = page.bodies.length + page.halfSpaces.length === 0;
    byId("parts", HTMLDetailsElement).open = isAlone;
    byId("parts-title", HTMLElement).textContent = page.bodies.length > 0 ? "Bodies" : "Half spaces";
    byId("near", HTMLElement).hidden = byId("paths", HTMLElement).hidden = isAlone;
    byId("names", HTMLElement).hidden = page.bodies.length === 0;
    showSummary(byId("verdict", HTMLElement), byId("summary", HTMLElement), page, parts.count);
    showLegend(byId("legend", HTMLElement), page);
    byId("title", HTMLElement).textContent = page.title;
    const [listed, total] = [page.contacts.length, page.contactCount];
    byId("contacts", HTMLElement).hidden = listed === 0 || page.query !== null;
    byId("count", HTMLElement).textContent =
      listed < total ? `The earliest ${listed} of ${total} contacts` : `${total} contact${total === 1 ? "" : "s"}`;
  }

  private draw(state: State, change: Change): void {
    if (this.shown === null) return;
    const { page } = this.shown;
    void this.stage.update(state, change);
    this.slider.move(state.moment);
    this.query.update(state);
    this.history.move(state.moment);
    document.documentElement.dataset["theme"] = state.theme;
    byId("opacity", HTMLInputElement).value = String(state.opacity);
    byId("play", HTMLButtonElement).textContent = state.playing ? "❚❚" : "▶";
    byId("play", HTMLButtonElement).setAttribute("aria-label", state.playing ? "Stop" : "Play");
    const press = (id: string, pressed: boolean): void => {
      byId(id, HTMLButtonElement).setAttribute("aria-pressed", String(pressed));
    };
    press("wires", state.wireframe);
    press("paths", state.paths);
    press("names", state.names);
    if (change.contact === undefined) return;
    this.list.select(state.contact);
    const chosen = state.contact === null ? undefined : page.contacts[state.contact];
    byId("selected", HTMLElement).hidden = chosen === undefined;
    if (chosen !== undefined) showFacts(byId("details", HTMLElement), page, chosen);
    byId("scroller", HTMLElement).setAttribute("aria-activedescendant", state.contact === null ? "" : `contact-${state.contact}`);
  }

  private select(contact: number | null): void {
    if (contact === null || this.shown === null) return;
    const { frame, time } = this.shown.page.contacts[contact];
    this.store.set({ contact, moment: { frame, t: time }, playing: false });
    void this.stage.near(this.store.state);
  }

  /** Connects the keys and the buttons. */
  private connect(): void {
    const { store } = this;
    const move = (by: number): void => {
      const { frame, t } = store.state.moment;
      store.set({ moment: momentAt(frame + t + by, this.page?.frames.length ?? 0), playing: false });
    };
    const toggle = (name: "playing" | "wireframe" | "paths" | "labels" | "names") => (): void =>
      store.set({ [name]: !store.state[name] });
    const theme = (): void => store.set({ theme: store.state.theme === "dark" ? "light" : "dark" });
    const opacity = (): void => store.set({ opacity: store.state.opacity >= 1 ? 0.15 : Math.min(store.state.opacity + 0.25, 1) });
    const near = (): void => void this.stage.near(store.state);
    const fit = (): void => this.stage.fit();
    const keys = byId("keys", HTMLDialogElement);
    const help = (): void => keys.showModal();
    const turn = (right: number, above: number) => (): void => {
      this.stage.view.move((pose, up) => turned(pose, up, right * TURN, above * TURN));
    };
    const shift = (right: number, above: number) => (): void => {
      this.stage.view.move((pose, up) => moved(pose, up, right * SHIFT, above * SHIFT));
    };
    const magnify = (factor: number) => (): void => this.stage.view.move((pose) => magnified(pose, factor));
    const next = (): void => this.select(this.list.neighbour(1));
    const previous = (): void => this.select(this.list.neighbour(-1));
    listen({
      " ": toggle("playing"),
      ArrowLeft: ({ shiftKey }) => move(shiftKey ? -1 : -0.01),
      ArrowRight: ({ shiftKey }) => move(shiftKey ? 1 : 0.01),
      ArrowDown: next,
      ArrowUp: previous,
      j: next,
      k: previous,
      Home: () => this.select(this.list.neighbour(-Infinity)),
      End: () => this.select(this.list.neighbour(Infinity)),
      i: () => this.select(store.state.contact),
      c: near,
      f: fit,
      a: turn(-1, 0),
      d: turn(1, 0),
      w: turn(0, 1),
      s: turn(0, -1),
      A: shift(-1, 0),
      D: shift(1, 0),
      W: shift(0, 1),
      S: shift(0, -1),
      "+": magnify(NEARER),
      "=": magnify(NEARER),
      "-": magnify(1 / NEARER),
      u: () => this.stage.turnUp(),
      o: opacity,
      e: toggle("wireframe"),
      n: toggle("names"),
      p: toggle("paths"),
      l: toggle("labels"),
      t: theme,
      "?": help,
    });
    const click = (id: string, action: () => void): void =>
      byId(id, HTMLButtonElement).addEventListener("click", action);
    click("play", toggle("playing"));
    click("fit", fit);
    click("near", near);
    click("wires", toggle("wireframe"));
    click("paths", toggle("paths"));
    click("names", toggle("names"));
    click("up", () => this.stage.turnUp());
    click("theme", theme);
    click("help", help);
    const level = byId("opacity", HTMLInputElement);
    level.addEventListener("input", () => store.set({ opacity: Number(level.value) }));
  }
}

/** Says why the page cannot be shown. */
export function fail(error: unknown): void {
  document.documentElement.dataset["ready"] = "false";
  const message = byId("message", HTMLElement);
  message.hidden = false;
  message.textContent = `This page cannot be shown: ${error instanceof Error ? error.message : String(error)}`;
}
