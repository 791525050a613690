/** The viewer: makes its parts, connects them by the state, and shows what it is given. */

import { byId } from "./elements";
import { type Moment, momentAt } from "./frames";
import { listen } from "./keys";
import { type Page } from "./page";
import { showFacts, showLegend, showSummary } from "./panel/details";
import { ContactList } from "./panel/list";
import { Slider } from "./panel/slider";
import { play } from "./player";
import { QueryPanel } from "./query/panel";
import { Labels } from "./scene/labels";
import { Stage } from "./scene/stage";
import { type Shown } from "./source";
import { type Change, type State, Store } from "./state";

/** Meshes up to this number of faces open with the edges of their faces. */
const FEW_FACES = 60_000;

/** The opacity of a mesh with contacts, so that they are visible inside of it. */
const CLEAR = 0.4;

export class Viewer {
  readonly stage: Stage;
  readonly store: Store;
  private shown: Shown | null = null;
  private readonly list: ContactList;
  private readonly slider: Slider;
  private readonly query: QueryPanel;

  constructor() {
    const dark = window.matchMedia("(prefers-color-scheme: dark)").matches;
    this.store = new Store({
      moment: { frame: 0, t: 0 },
      contact: null,
      playing: false,
      theme: dark ? "dark" : "light",
      opacity: 1,
      wireframe: true,
      paths: true,
      labels: true,
    });
    const choose = (moment: Moment): void => this.store.set({ moment, playing: false });
    this.stage = new Stage(byId("scene", HTMLCanvasElement), new Labels(byId("labels", HTMLElement)));
    this.slider = new Slider(byId("slider", HTMLInputElement), byId("ticks", HTMLCanvasElement), byId("moment", HTMLElement), choose);
    this.list = new ContactList(byId("scroller", HTMLElement), byId("rows", HTMLElement), (contact) => this.select(contact));
    this.query = new QueryPanel(byId("plots", HTMLElement), byId("image", HTMLCanvasElement), (t) => choose({ frame: 0, t }));
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
      opacity: earliest === undefined && page.query === null ? 1 : CLEAR,
      wireframe: page.faces <= FEW_FACES,
    });
    await this.stage.near(this.store.state, true);
    byId("message", HTMLElement).hidden = true;
    document.documentElement.dataset["ready"] = "true";
  }

  /** Shows other data of the same kind: the camera stays where it is, and so does the time, unless it was that of
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
    byId("filter", HTMLInputElement).value = "";
    byId("query", HTMLElement).hidden = page.query === null;
    showSummary(byId("summary", HTMLElement), page, parts.count);
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
    document.documentElement.dataset["theme"] = state.theme;
    byId("opacity", HTMLInputElement).value = String(state.opacity);
    byId("play", HTMLButtonElement).textContent = state.playing ? "❚❚" : "▶";
    const press = (id: string, pressed: boolean): void => {
      byId(id, HTMLButtonElement).setAttribute("aria-pressed", String(pressed));
    };
    press("wires", state.wireframe);
    press("paths", state.paths);
    if (change.contact === undefined) return;
    this.list.select(state.contact);
    const chosen = state.contact === null ? undefined : page.contacts[state.contact];
    byId("selected", HTMLElement).hidden = chosen === undefined;
    if (chosen !== undefined) showFacts(byId("details", HTMLElement), page, chosen);
    byId("scroller", HTMLElement).setAttribute("aria-activedescendant", `contact-${String(state.contact)}`);
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
    const toggle = (name: "playing" | "wireframe" | "paths" | "labels") => (): void =>
      store.set({ [name]: !store.state[name] });
    const theme = (): void => store.set({ theme: store.state.theme === "dark" ? "light" : "dark" });
    const opacity = (): void => store.set({ opacity: store.state.opacity >= 1 ? 0.15 : Math.min(store.state.opacity + 0.25, 1) });
    const near = (): void => void this.stage.near(store.state);
    const fit = (): void => this.stage.fit();
    const keys = byId("keys", HTMLDialogElement);
    const help = (): void => keys.showModal();
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
      o: opacity,
      w: toggle("wireframe"),
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
