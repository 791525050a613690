/** The page with the kernel in it: shows the answers about what is edited or dropped on it. */

import { block, byId } from "../elements";
import { type Contact } from "../page";
import { read, type Source } from "../source";
import { fail, Viewer } from "../viewer";
import { Editor } from "./editor";
import { type Entry } from "./entry";
import { bytesOf, Files } from "./files";
import { Handles } from "./handles";
import { Kernel, Latest } from "./kernel";
import { PRESETS } from "./presets";
import { type Kind } from "../kinds";
import { VerdictPanel } from "./verdict";

type Mode = "query" | "meshes";

declare global {
  interface Window {
    /** The kernel, for the console and for tests. */
    exactCcd: Kernel;
    /** The places of the handles in the window, first the handles at t = 0. */
    exactCcdHandles: () => [x: number, y: number][];
  }
}

const texts = (page: Record<string, string>): Source => (id) => page[id] ?? "";

const timeOf = (contact: Contact | undefined): number | null => contact?.time ?? null;

class App {
  private readonly viewer = new Viewer();
  private readonly latest = new Latest();
  private readonly verdict = new VerdictPanel(byId("exact", HTMLElement), byId("finder", HTMLElement), byId("difference", HTMLElement));
  private readonly handles: Handles;
  private readonly editor: Editor;
  private mode: Mode = "query";
  /** The next answer is shown from the start. */
  private isOther = true;

  constructor(private readonly kernel: Kernel) {
    const { stage, store } = this.viewer;
    stage.showsPaths = true;
    this.editor = new Editor(PRESETS[0].entry, (entry, isOther) => this.edited(entry, isOther));
    this.handles = new Handles(byId("scene", HTMLElement), stage.view, (coordinates) => this.editor.edit({ coordinates }));
    window.exactCcdHandles = () => this.handles.places();
    new Files((start, end) => this.opened(start, end));
    store.observe((_, change) => {
      if (change.theme !== undefined) this.showHandles();
    });
    for (const mode of ["query", "meshes"] as const) {
      byId(`mode-${mode}`, HTMLButtonElement).addEventListener("click", () => this.setMode(mode));
    }
    byId("edit", HTMLButtonElement).addEventListener("click", () => this.editContact());
    this.setMode("query");
  }

  /** Shows the first answer. */
  async open(): Promise<void> {
    this.isOther = true;
    await this.answerQuery(this.editor.entry);
  }

  private setMode(mode: Mode): void {
    this.mode = mode;
    for (const other of ["query", "meshes"] as const) {
      byId(`mode-${other}`, HTMLButtonElement).setAttribute("aria-pressed", String(other === mode));
      byId(`input-${other}`, HTMLElement).hidden = other !== mode;
    }
  }

  /** Runs a task, and shows its error. */
  private run(task: () => Promise<void>): void {
    const problem = byId("problem", HTMLElement);
    this.latest.run(async () => {
      try {
        await task();
        problem.hidden = true;
      } catch (error) {
        problem.hidden = false;
        problem.textContent = error instanceof Error ? error.message : String(error);
      }
    });
  }

  private edited(entry: Entry, isOther: boolean): void {
    this.isOther ||= isOther;
    const { distance, tolerance } = entry;
    this.run(() => (this.mode === "query" ? this.answerQuery(entry) : this.answerMeshes(distance, tolerance)));
  }

  private async answerQuery({ kind, coordinates, distance, tolerance }: Entry): Promise<void> {
    const { page, rootFinder } = await this.kernel.call("query", kind, coordinates, distance, tolerance);
    await this.show(texts(page));
    this.verdict.show(timeOf(this.viewer.page?.contacts[0]), rootFinder);
  }

  private opened(start: File, end: File): void {
    // A distance that suits a query may have millions of contacts on a mesh.
    if (this.mode === "query") this.editor.edit({ distance: 0, tolerance: 0 });
    this.setMode("meshes");
    const { distance, tolerance } = this.editor.entry;
    this.run(async () => {
      this.isOther = true;
      await this.kernel.call("read", await bytesOf(start), await bytesOf(end));
      await this.answerMeshes(distance, tolerance);
    });
  }

  private async answerMeshes(distance: number, tolerance: number): Promise<void> {
    await this.show(texts(await this.kernel.call("contacts", distance)));
    const exact = timeOf(this.viewer.page?.contacts[0]);
    this.verdict.show(exact, undefined);
    this.verdict.show(exact, await this.kernel.call("rootFinder", distance + tolerance));
  }

  private async show(source: Source): Promise<void> {
    const shown = await read(source);
    const isOther = this.isOther;
    this.isOther = false;
    if (isOther) await this.viewer.open(shown);
    else this.viewer.replace(shown);
    byId("edit", HTMLElement).hidden = shown.page.query !== null;
    this.showHandles();
  }

  private showHandles(): void {
    const { page, stage, store } = this.viewer;
    const frames = stage.frames;
    if (page === null || frames === null) return;
    this.handles.show(page.query === null ? null : this.editor.entry, frames, store.state.theme);
  }

  /** Opens the selected contact of a mesh as a query. */
  private editContact(): void {
    const { page, store } = this.viewer;
    const contact = store.state.contact === null ? undefined : page?.contacts[store.state.contact];
    if (contact === undefined) return;
    const [first, second] = contact.primitives;
    this.run(async () => {
      const vertices = Uint32Array.from([...first.vertices, ...second.vertices]);
      const coordinates = await this.kernel.call("coordinates", vertices);
      this.setMode("query");
      const kind: Kind = `${first.kind}-${second.kind}` as Kind;
      this.editor.open({ ...this.editor.entry, kind, coordinates });
    });
  }
}

async function open(): Promise<void> {
  const kernel = new Kernel(block("worker"));
  window.exactCcd = kernel;
  await kernel.start(block("module"));
  await new App(kernel).open();
}

open().catch(fail);
