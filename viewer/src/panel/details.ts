/** The texts of the side panel. */

import { css, MARKS, viridis } from "../colours";
import { type Contact, type Page, type Point } from "../page";
import { primitiveText, short, timeText } from "../text";
import { dot, subtract } from "../vector";

/** The facts about a contact, as terms and descriptions. */
export function facts(page: Page, contact: Contact): [string, string, string][] {
  const [first, second] = contact.primitives;
  const list: [string, string, string][] = [
    ["time", timeText(page, contact), ""],
    ["first", primitiveText(first, page), "first"],
    ["second", primitiveText(second, page), "second"],
    ["point", pointText(contact.closest[0]), ""],
    ["normal", contact.normal === null ? "none: they rest on each other, or slide" : pointText(contact.normal), ""],
  ];
  if (second.kind === "half-space") {
    const height = dot(contact.normal ?? [0, 0, 0], subtract(...contact.closest));
    // At the first time in a step, it is a rounding error.
    if (Math.abs(height) > 1e-9 * page.scale) list.splice(4, 0, [height > 0 ? "height" : "depth", `about ${short(Math.abs(height))}`, ""]);
  }
  if (contact.distance > 0) list.splice(1, 0, ["distance", String(contact.distance), ""]);
  if (contact.parameters !== null) list.push(["u, v", contact.parameters.join(", "), ""]);
  return list;
}

function pointText(point: Point): string {
  return `(${point.join(", ")})`;
}

export function showFacts(list: HTMLElement, page: Page, contact: Contact): void {
  const elements = facts(page, contact).flatMap(([term, text, kind]) => {
    const [name, description] = [document.createElement("dt"), document.createElement("dd")];
    name.textContent = term;
    description.textContent = text;
    description.className = kind;
    return [name, description];
  });
  list.replaceChildren(...elements);
}

/** The headline of the answer, and the lines under it. */
export function answerOf({ verdict, summary }: Page): [string, string[]] {
  return verdict === "" ? [summary[0] ?? "", summary.slice(1)] : [verdict, summary];
}

export function showSummary(headline: HTMLElement, parent: HTMLElement, page: Page, componentCount: number): void {
  const count = (number: number, name: string): string => `${number} ${name}${number === 1 ? "" : "s"}`;
  const { vertices, faces, edges } = page;
  const mesh = [vertices === 1 ? "1 vertex" : `${vertices} vertices`, count(faces, "face")];
  if (edges > 0) mesh.push(count(edges, "loose edge"));
  mesh.push(count(componentCount, "component"));
  const [verdict, others] = answerOf(page);
  headline.textContent = verdict;
  headline.hidden = verdict === "";
  const lines = page.query === null ? [...others, mesh.join(", ")] : others;
  parent.replaceChildren(
    ...lines.map((text) => {
      const line = document.createElement("p");
      line.textContent = text;
      return line;
    }),
  );
}

/** The meaning of the marks. */
export function showLegend(parent: HTMLElement, page: Page): void {
  const row = (kind: string, background: string, text: string): HTMLElement => {
    const [line, sample] = [document.createElement("div"), document.createElement("i")];
    sample.className = kind;
    sample.style.background = background;
    line.append(sample, text);
    return line;
  };
  const marked = page.contacts[0] ?? page.query;
  parent.hidden = marked === null;
  parent.replaceChildren();
  if (marked === null) return;
  const stops = [0, 0.25, 0.5, 0.75, 1].map((x) => css(viridis(x))).join(", ");
  const [first, second] = marked.primitives.map(({ kind }) => kind.replace("-", " "));
  parent.append(
    row("", "var(--first)", first === second ? `first ${first}` : first),
    row("", "var(--second)", first === second ? `second ${second}` : second),
  );
  if (page.contacts.length > 0) {
    parent.append(row("", MARKS.light.contact, "contact point"), row("normal", "none", "normal"));
  }
  parent.append(row("path", "none", "path of a vertex, to the larger dot"));
  if (page.contacts.length > 1) parent.append(row("scale", `linear-gradient(90deg, ${stops})`, "contacts, first to last"));
}
