/** The charts over the time of a motion. */

import { type Moment, momentAt } from "../frames";
import { type Page } from "../page";
import { Plot } from "./plot";

/** The time of a moment. Frames may have been left out: their numbers count. */
export function timeOf({ frames, history }: Page, { frame, t }: Moment): number {
  const times = history?.times ?? [];
  const at = (index: number): number => times[frames[Math.min(index, frames.length - 1)].number] ?? 0;
  return (1 - t) * at(frame) + t * at(frame + 1);
}

/** The moment of a time. */
export function momentOf({ frames, history }: Page, time: number): Moment {
  const times = frames.map(({ number }) => history?.times[number] ?? 0);
  const next = times.findIndex((other) => other > time);
  if (next < 0) return momentAt(frames.length - 1, frames.length);
  if (next === 0) return momentAt(0, frames.length);
  const part = (time - times[next - 1]) / (times[next] - times[next - 1]);
  return momentAt(next - 1 + part, frames.length);
}

export class HistoryPanel {
  private page: Page | null = null;
  private plots: Plot[] = [];

  constructor(
    private readonly parent: HTMLElement,
    private readonly choose: (moment: Moment) => void,
  ) {}

  show(page: Page): void {
    const { history } = page;
    this.page = page;
    const charts = (history?.times.length ?? 0) > 1 ? (history?.charts ?? []) : [];
    this.plots = charts.map(({ title, unit, logarithmic, curves }) => {
      const options = { title, unit, logarithmic, curves, time: "time / s", times: history?.times ?? [] };
      const choose = (time: number): void => this.choose(momentOf(page, time));
      return new Plot({ ...options, level: 0, marks: [], intervals: [], choose });
    });
    this.parent.replaceChildren(...this.plots.map((plot) => plot.element));
    this.parent.hidden = this.plots.length === 0;
  }

  move(moment: Moment): void {
    if (this.page === null || this.plots.length === 0) return;
    const time = timeOf(this.page, moment);
    for (const plot of this.plots) plot.show(time);
  }
}
