/** The fields of a query: its kind, its coordinates and the distances. */

import { byId } from "../elements";
import { type Kind, KINDS } from "../kinds";
import { type Entry, pointCount, replaced } from "./entry";
import { hexadecimal, neighbour, parseNumber } from "./numbers";
import { PRESETS } from "./presets";

/** A field for a number. It accepts decimals and hexadecimal floats. */
export class NumberField {
  private value = Number.NaN;

  /** `change` is called with numbers that are entered; `least` is the least one allowed. */
  constructor(
    private readonly input: HTMLInputElement,
    change: (value: number) => void,
    private readonly least = -Infinity,
  ) {
    input.addEventListener("input", () => {
      const parsed = this.parse();
      input.setCustomValidity(typeof parsed === "string" ? parsed : "");
      input.title = typeof parsed === "string" ? parsed : hexadecimal(parsed);
      input.ariaInvalid = String(typeof parsed === "string");
      if (typeof parsed === "number") change((this.value = parsed));
    });
    input.addEventListener("keydown", (event) => {
      if (event.key !== "ArrowUp" && event.key !== "ArrowDown") return;
      event.preventDefault();
      const direction = event.key === "ArrowUp" ? 1 : -1;
      const step = event.shiftKey ? neighbour(this.value, direction) : stepped(this.value, direction);
      if (!Number.isFinite(step)) return;
      this.set(Math.max(step, this.least));
      change(this.value);
    });
  }

  set(value: number): void {
    this.value = value;
    this.input.value = Object.is(value, -0) ? "-0" : String(value);
    this.input.title = hexadecimal(value);
    this.input.setCustomValidity("");
    this.input.ariaInvalid = "false";
  }

  /** Shows a number that came from elsewhere, unless it is the one in the field, in any notation. */
  show(value: number): void {
    if (!Object.is(value, this.value) || this.input.validationMessage !== "") this.set(value);
  }

  private parse(): number | string {
    const parsed = parseNumber(this.input.value);
    return typeof parsed === "number" && parsed < this.least ? `expected at least ${this.least}` : parsed;
  }
}

/** A number one hundredth of its power of ten further, as a short decimal. */
function stepped(x: number, direction: 1 | -1): number {
  const step = x === 0 ? 0.01 : 10 ** (Math.floor(Math.log10(Math.abs(x))) - 1);
  return Number((x + direction * Math.max(step, Number.MIN_VALUE)).toPrecision(12));
}

export class Editor {
  private fields: NumberField[] = [];
  private readonly distance: NumberField;
  private readonly tolerance: NumberField;
  private readonly kind = byId("kind", HTMLSelectElement);
  private readonly presets = byId("presets", HTMLSelectElement);
  private readonly points = byId("points", HTMLTableSectionElement);

  /** `change` is called after each change, and with `true` if it is another query. */
  constructor(
    private current: Entry,
    private readonly change: (entry: Entry, isOther: boolean) => void,
  ) {
    this.distance = new NumberField(byId("distance", HTMLInputElement), (distance) => this.edit({ distance }), 0);
    this.tolerance = new NumberField(byId("tolerance", HTMLInputElement), (tolerance) => this.edit({ tolerance }), 0);
    this.presets.append(...PRESETS.map(({ name }, i) => new Option(name, String(i))), new Option("your own", "own"));
    this.presets.addEventListener("change", () => {
      const preset = PRESETS[Number(this.presets.value)];
      if (preset !== undefined) this.open(preset.entry);
    });
    this.kind.append(...Object.entries(KINDS).map(([kind, { title }]) => new Option(title, kind)));
    this.kind.addEventListener("change", () => {
      const first = PRESETS.find(({ entry }) => entry.kind === this.kind.value);
      if (first !== undefined) this.open(first.entry);
    });
    this.show();
  }

  get entry(): Entry {
    return this.current;
  }

  /** Shows another query. */
  open(entry: Entry): void {
    this.current = entry;
    this.fields = [];
    this.show();
    this.change(entry, true);
  }

  /** Replaces some parts of the query. */
  edit(part: Partial<Entry>): void {
    this.current = { ...this.current, ...part };
    this.show();
    this.change(this.current, false);
  }

  private show(): void {
    const { kind, coordinates, distance, tolerance } = this.current;
    if (this.fields.length === 0) this.fields = this.rows(kind);
    this.fields.forEach((field, i) => field.show(coordinates[i]));
    this.distance.show(distance);
    this.tolerance.show(tolerance);
    this.kind.value = kind;
    const preset = PRESETS.findIndex(({ entry }) => same(entry, this.current));
    this.presets.value = preset < 0 ? "own" : String(preset);
  }

  /** Makes the rows of the points, and returns the fields in the order of the coordinates. */
  private rows(kind: Kind): NumberField[] {
    const fields: NumberField[] = [];
    const { first, second } = KINDS[kind];
    const rows = [...first, ...second].flatMap((name, point) =>
      [0, 1].map((time) => {
        const row = document.createElement("tr");
        const label = document.createElement("th");
        label.scope = "row";
        label.className = point < first.length ? "first" : "second";
        label.textContent = `${name}, t = ${time}`;
        row.append(label);
        for (const [axis, letter] of ["x", "y", "z"].entries()) {
          const index = 3 * (time * pointCount(kind) + point) + axis;
          const input = document.createElement("input");
          [input.type, input.spellcheck, input.autocomplete] = ["text", false, "off"];
          input.ariaLabel = `${letter} of ${name} at t = ${time}`;
          fields[index] = new NumberField(input, (value) => {
            this.edit({ coordinates: replaced(this.current.coordinates, [[index, value]]) });
          });
          const cell = document.createElement("td");
          cell.append(input);
          row.append(cell);
        }
        return row;
      }),
    );
    this.points.replaceChildren(...rows);
    return fields;
  }
}

function same(a: Entry, b: Entry): boolean {
  const coordinates = a.coordinates.length === b.coordinates.length && a.coordinates.every((x, i) => Object.is(x, b.coordinates[i]));
  return coordinates && a.kind === b.kind && a.distance === b.distance && a.tolerance === b.tolerance;
}
