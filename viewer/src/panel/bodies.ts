/** The list of bodies: a click moves the camera to one, a checkbox hides it. */

import { PARTS } from "../colours";
import { type Page } from "../page";

export class BodyList {
  constructor(
    private readonly parent: HTMLElement,
    private readonly choose: (body: number) => void,
    private readonly hide: (hidden: ReadonlySet<number>) => void,
  ) {}

  show({ bodies, halfSpaces }: Page): void {
    const hidden = new Set<number>();
    const rows = bodies.map(({ name, kind, vertices: { start, end } }, body) => {
      const row = document.createElement("div");
      row.className = "body";
      const box = document.createElement("input");
      box.type = "checkbox";
      box.checked = true;
      box.ariaLabel = `show ${name}`;
      box.style.accentColor = PARTS[body % PARTS.length];
      box.addEventListener("change", () => {
        if (box.checked) hidden.delete(body);
        else hidden.add(body);
        this.hide(new Set(hidden));
      });
      const button = document.createElement("button");
      button.title = `The camera on ${name}`;
      const sample = document.createElement("i");
      sample.style.background = PARTS[body % PARTS.length];
      const title = document.createElement("span");
      title.textContent = name;
      const facts = document.createElement("small");
      const count = end - start;
      facts.textContent = [kind, count === 1 ? "1 vertex" : `${count} vertices`].filter((text) => text !== "").join(", ");
      button.append(sample, title, facts);
      button.addEventListener("click", () => this.choose(body));
      row.append(box, button);
      return row;
    });
    const planes = halfSpaces.map(({ name, normal }, number) => {
      const row = document.createElement("div");
      row.className = "body plane";
      const title = document.createElement("span");
      title.textContent = name === "" ? `half space ${number}` : name;
      const facts = document.createElement("small");
      facts.textContent = `half space, normal (${normal.map((x) => Number(x.toPrecision(4))).join(", ")})`;
      row.append(title, facts);
      return row;
    });
    this.parent.replaceChildren(...rows, ...planes);
  }
}
