/** Two mesh files: chosen by the fields, or dropped on the page. */

import { byId } from "../elements";
import { type NamedFile } from "./protocol";

export class Files {
  private chosen: [File | null, File | null] = [null, null];
  private readonly names = [byId("start-name", HTMLElement), byId("end-name", HTMLElement)];

  /** `change` is called when both files are there. */
  constructor(private readonly change: (start: File, end: File) => void) {
    for (const [i, id] of (["start", "end"] as const).entries()) {
      const input = byId(id, HTMLInputElement);
      input.addEventListener("change", () => {
        const file = input.files?.[0];
        if (file !== undefined) this.set(i === 0 ? [file, this.chosen[1]] : [this.chosen[0], file]);
        input.value = "";
      });
    }
    byId("exchange", HTMLButtonElement).addEventListener("click", () => this.set([this.chosen[1], this.chosen[0]]));
    document.addEventListener("dragover", (event) => event.preventDefault());
    document.addEventListener("drop", (event) => {
      event.preventDefault();
      this.add([...(event.dataTransfer?.files ?? [])]);
    });
  }

  /** Two files in the order of their names, or one, which takes the free place. */
  add(files: File[]): void {
    const [first, second] = files.sort((a, b) => a.name.localeCompare(b.name, "en", { numeric: true }));
    if (first === undefined) return;
    const [start, end] = this.chosen;
    if (second !== undefined) this.set([first, second]);
    else if (start !== null && end === null) this.set([start, first]);
    else this.set([first, null]);
  }

  private set(chosen: [File | null, File | null]): void {
    this.chosen = chosen;
    this.names.forEach((name, i) => (name.textContent = chosen[i]?.name ?? "no file yet"));
    const [start, end] = chosen;
    if (start !== null && end !== null) this.change(start, end);
  }
}

/** The contents of a file, decompressed if its name ends in .gz. */
export async function bytesOf(file: File): Promise<NamedFile> {
  const stream = /\.gz$/i.test(file.name) ? file.stream().pipeThrough(new DecompressionStream("gzip")) : file.stream();
  return { name: file.name, bytes: new Uint8Array(await new Response(stream).arrayBuffer()) };
}
