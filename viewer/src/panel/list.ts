/** The list of contacts: only the rows in view are elements. */

import { css, viridis } from "../colours";
import { type Contact, type Page } from "../page";
import { contactIds, primitiveText, timeText } from "../text";

const ROW = 58;

export class ContactList {
  private page: Page | null = null;
  private place: (contact: number) => number = () => 0;
  /** The contacts that the filter leaves. */
  private shown: number[] = [];
  private selected: number | null = null;

  constructor(
    private readonly scroller: HTMLElement,
    private readonly rows: HTMLElement,
    private readonly choose: (contact: number) => void,
  ) {
    scroller.addEventListener("scroll", () => this.draw());
    new ResizeObserver(() => this.draw()).observe(scroller);
  }

  show(page: Page, place: (contact: number) => number): void {
    [this.page, this.place, this.selected] = [page, place, null];
    this.filter("");
  }

  /** Lists the contacts with this id of a primitive or a vertex, or all of them for an empty text. */
  filter(text: string): void {
    const ids = text.match(/\d+/g)?.map(Number) ?? [];
    const matches = (contact: Contact): boolean => {
      const own = contactIds(contact);
      return ids.every((id) => own.includes(id));
    };
    const contacts = this.page?.contacts ?? [];
    this.shown = contacts.map((_, i) => i).filter((i) => matches(contacts[i]));
    this.scroller.scrollTop = 0;
    this.draw();
  }

  select(contact: number | null): void {
    this.selected = contact;
    const row = contact === null ? -1 : this.shown.indexOf(contact);
    if (row >= 0) {
      const { scrollTop, clientHeight } = this.scroller;
      if (row * ROW < scrollTop) this.scroller.scrollTop = row * ROW;
      if ((row + 1) * ROW > scrollTop + clientHeight) this.scroller.scrollTop = (row + 1) * ROW - clientHeight;
    }
    this.draw();
  }

  /** The listed contact `by` rows after the selected one, or the first one. */
  neighbour(by: number): number | null {
    const row = this.selected === null ? -1 : this.shown.indexOf(this.selected);
    const to = row < 0 ? 0 : Math.min(Math.max(row + by, 0), this.shown.length - 1);
    return this.shown[to] ?? null;
  }

  private draw(): void {
    const { page } = this;
    if (page === null) return;
    const { scrollTop, clientHeight } = this.scroller;
    const begin = Math.max(Math.floor(scrollTop / ROW) - 2, 0);
    const end = Math.min(begin + Math.ceil(clientHeight / ROW) + 4, this.shown.length);
    this.rows.style.height = `${this.shown.length * ROW}px`;
    this.rows.replaceChildren(...this.shown.slice(begin, end).map((contact, i) => this.row(page, contact, begin + i)));
  }

  private row(page: Page, index: number, row: number): HTMLElement {
    const contact = page.contacts[index];
    const element = document.createElement("div");
    element.className = "contact";
    element.role = "option";
    element.id = `contact-${index}`;
    element.ariaSelected = String(index === this.selected);
    element.ariaPosInSet = String(row + 1);
    element.ariaSetSize = String(this.shown.length);
    element.style.transform = `translateY(${row * ROW}px)`;
    const line = (kind: string, text: string): HTMLElement => {
      const made = document.createElement("span");
      made.className = kind;
      made.textContent = text;
      return made;
    };
    const time = line("time", timeText(page, contact));
    time.style.setProperty("--colour", css(viridis(this.place(index))));
    const [first, second] = contact.primitives.map((primitive) => primitiveText(primitive, page));
    element.append(time, line("first", first), line("second", second));
    element.title = `${timeText(page, contact)}: ${first} and ${second}`;
    element.addEventListener("click", () => this.choose(index));
    return element;
  }
}
