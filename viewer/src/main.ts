/** The page: reads its data, makes its parts, and connects them by the state. */

import { decodeElements, decodeFloats } from "./binary";
import { type Theme } from "./colours";
import { block, byId } from "./elements";
import { Frames, momentAt } from "./frames";
import { listen } from "./keys";
import { type Page, parsePage } from "./page";
import { showFacts, showLegend, showSummary } from "./panel/details";
import { ContactList } from "./panel/list";
import { Slider } from "./panel/slider";
import { looseVertices, partsOf } from "./parts";
import { play } from "./player";
import { QueryPanel } from "./query/panel";
import { Labels } from "./scene/labels";
import { Stage } from "./scene/stage";
import { Store } from "./state";

/** Meshes up to this number of faces open with the edges of their faces. */
const FEW_FACES = 60_000;

/** The place of each contact on the scale of times, from 0 for the earliest to 1 for the latest. */
function scaleOf({ contacts }: Page): (contact: number) => number {
  const places = contacts.map(({ frame, time }) => frame + time);
  const least = places.reduce((a, b) => Math.min(a, b), Infinity);
  const most = places.reduce((a, b) => Math.max(a, b), -Infinity);
  return (contact) => (most > least ? (places[contact] - least) / (most - least) : 0);
}

async function open(): Promise<void> {
  const page = parsePage(block("page"));
  document.title = page.title;
  const [faces, edges, first] = await Promise.all([
    decodeElements(block("faces"), 3),
    decodeElements(block("edges"), 2),
    decodeFloats(block("frame-0")),
  ]);
  const frames = new Frames(page, first, (frame) => decodeFloats(block(`frame-${frame}`)));
  const points = looseVertices(page.vertices, faces, edges) as Uint32Array<ArrayBuffer>;
  const parts = partsOf(page.vertices, faces, edges);
  const colour = scaleOf(page);

  const earliest = page.contacts[0];
  const dark = window.matchMedia("(prefers-color-scheme: dark)").matches;
  const store = new Store({
    moment: { frame: 0, t: 0 },
    contact: null,
    playing: false,
    theme: dark ? "dark" : "light",
    opacity: earliest === undefined ? 1 : 0.4,
    wireframe: page.faces <= FEW_FACES,
    paths: true,
    labels: true,
  });
  const stage = new Stage(byId("scene", HTMLCanvasElement), new Labels(byId("labels", HTMLElement)), page, frames, { faces, edges, points }, parts, colour);
  const slider = new Slider(page, byId("slider", HTMLInputElement), byId("ticks", HTMLCanvasElement), byId("moment", HTMLElement), colour, (moment) => store.set({ moment, playing: false }));

  const select = (contact: number | null): void => {
    if (contact === null) return;
    const { frame, time } = page.contacts[contact];
    store.set({ contact, moment: { frame, t: time }, playing: false });
    void stage.near(store.state);
  };
  const scroller = byId("scroller", HTMLElement);
  const list = new ContactList(page, scroller, byId("rows", HTMLElement), select, colour);
  const filter = byId("filter", HTMLInputElement);
  filter.addEventListener("input", () => list.filter(filter.value));

  showSummary(byId("summary", HTMLElement), page, parts.count);
  showLegend(byId("legend", HTMLElement), page);
  byId("title", HTMLElement).textContent = page.title;
  const listed = page.contacts.length;
  byId("contacts", HTMLElement).hidden = listed === 0 || page.query !== null;
  const total = page.contactCount;
  byId("count", HTMLElement).textContent =
    listed < total ? `The earliest ${listed} of ${total} contacts` : `${total} contact${total === 1 ? "" : "s"}`;

  const queryPanel =
    page.query === null
      ? null
      : (() => {
          byId("query", HTMLElement).hidden = false;
          const choose = (t: number): void => store.set({ moment: { frame: 0, t }, playing: false });
          return new QueryPanel(page.query, byId("plots", HTMLElement), byId("image", HTMLCanvasElement), choose);
        })();

  const press = (id: string, pressed: boolean): void => {
    byId(id, HTMLButtonElement).setAttribute("aria-pressed", String(pressed));
  };
  store.observe((state, change) => {
    void stage.update(state, change);
    slider.show(state.moment);
    queryPanel?.update(state);
    document.documentElement.dataset["theme"] = state.theme;
    byId("opacity", HTMLInputElement).value = String(state.opacity);
    byId("play", HTMLButtonElement).textContent = state.playing ? "❚❚" : "▶";
    press("wires", state.wireframe);
    press("paths", state.paths);
    if (change.contact === undefined) return;
    list.select(state.contact);
    const chosen = state.contact === null ? undefined : page.contacts[state.contact];
    byId("selected", HTMLElement).hidden = chosen === undefined;
    if (chosen !== undefined) showFacts(byId("details", HTMLElement), page, chosen);
    scroller.setAttribute("aria-activedescendant", `contact-${String(state.contact)}`);
  });
  play(store, page.frames.length);

  const move = (by: number): void => {
    const { frame, t } = store.state.moment;
    store.set({ moment: momentAt(frame + t + by, page.frames.length), playing: false });
  };
  const toggle = (name: "playing" | "wireframe" | "paths" | "labels") => (): void =>
    store.set({ [name]: !store.state[name] });
  const theme = (): void => {
    const other: Theme = store.state.theme === "dark" ? "light" : "dark";
    store.set({ theme: other });
  };
  const opacity = (): void => store.set({ opacity: store.state.opacity >= 1 ? 0.15 : Math.min(store.state.opacity + 0.25, 1) });
  const near = (): void => void stage.near(store.state);
  const fit = (): void => stage.fit();
  const keys = byId("keys", HTMLDialogElement);
  const help = (): void => keys.showModal();
  const next = (): void => select(list.neighbour(1));
  const previous = (): void => select(list.neighbour(-1));
  listen({
    " ": toggle("playing"),
    ArrowLeft: ({ shiftKey }) => move(shiftKey ? -1 : -0.01),
    ArrowRight: ({ shiftKey }) => move(shiftKey ? 1 : 0.01),
    ArrowDown: next,
    ArrowUp: previous,
    j: next,
    k: previous,
    Home: () => select(list.neighbour(-Infinity)),
    End: () => select(list.neighbour(Infinity)),
    i: () => select(store.state.contact),
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

  // The page opens at the earliest contact.
  const contact = earliest === undefined ? null : 0;
  const moment = earliest === undefined ? store.state.moment : { frame: earliest.frame, t: earliest.time };
  store.set({ ...store.state, contact, moment });
  await stage.near(store.state, true);
  byId("message", HTMLElement).hidden = true;
  document.documentElement.dataset["ready"] = "true";
}

open().catch((error: unknown) => {
  document.documentElement.dataset["ready"] = "false";
  const message = byId("message", HTMLElement);
  message.hidden = false;
  message.textContent = `This page cannot be shown: ${error instanceof Error ? error.message : String(error)}`;
});
