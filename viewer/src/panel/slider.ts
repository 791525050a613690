/** The slider over the step or the frames, with a tick for each contact. */

import { css, viridis } from "../colours";
import { type Moment, momentAt } from "../frames";
import { type Page } from "../page";
import { momentText } from "../text";

export class Slider {
  private page: Page | null = null;
  private place: (contact: number) => number = () => 0;

  constructor(
    private readonly input: HTMLInputElement,
    private readonly ticks: HTMLCanvasElement,
    private readonly output: HTMLElement,
    choose: (moment: Moment) => void,
  ) {
    input.step = "any";
    input.addEventListener("input", () => choose(momentAt(Number(input.value), this.page?.frames.length ?? 0)));
    new ResizeObserver(() => this.drawTicks()).observe(ticks);
  }

  show(page: Page, place: (contact: number) => number): void {
    [this.page, this.place] = [page, place];
    const steps = Math.max(page.frames.length - 1, 0);
    this.input.max = String(steps);
    this.input.disabled = steps === 0;
    this.drawTicks();
  }

  move(moment: Moment): void {
    if (this.page === null) return;
    this.input.value = String(moment.frame + moment.t);
    this.output.textContent = momentText(this.page, moment);
    this.input.setAttribute("aria-valuetext", this.output.textContent);
  }

  private drawTicks(): void {
    if (this.page === null) return;
    const { contacts, frames } = this.page;
    const steps = Math.max(frames.length - 1, 1);
    const ratio = window.devicePixelRatio;
    const { clientWidth, clientHeight } = this.ticks;
    this.ticks.width = clientWidth * ratio;
    this.ticks.height = clientHeight * ratio;
    const context = this.ticks.getContext("2d");
    if (context === null) return;
    context.scale(ratio, ratio);
    // The middle of the thumb, 16 pixels wide, is the value.
    const x = (position: number): number => 8 + (position / steps) * (clientWidth - 16);
    // The rim is visible on any background.
    context.fillStyle = "#8a949e";
    for (const { frame, time } of contacts) context.fillRect(x(frame + time) - 2.5, 0, 5, clientHeight);
    // The earliest is drawn last.
    for (let i = contacts.length - 1; i >= 0; i--) {
      context.fillStyle = css(viridis(this.place(i)));
      context.fillRect(x(contacts[i].frame + contacts[i].time) - 1.5, 1, 3, clientHeight - 2);
    }
  }
}
