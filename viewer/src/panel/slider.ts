/** The slider over the step or the frames, with a tick for each contact. */

import { css, viridis } from "../colours";
import { type Moment, momentAt } from "../frames";
import { type Page } from "../page";
import { momentText } from "../text";

export class Slider {
  constructor(
    private readonly page: Page,
    private readonly input: HTMLInputElement,
    private readonly ticks: HTMLCanvasElement,
    private readonly output: HTMLElement,
    colour: (contact: number) => number,
    choose: (moment: Moment) => void,
  ) {
    const steps = Math.max(page.frames.length - 1, 0);
    input.max = String(steps);
    input.step = "any";
    input.disabled = steps === 0;
    input.addEventListener("input", () => choose(momentAt(Number(input.value), page.frames.length)));
    const draw = (): void => this.drawTicks(Math.max(steps, 1), colour);
    new ResizeObserver(draw).observe(ticks);
  }

  show(moment: Moment): void {
    this.input.value = String(moment.frame + moment.t);
    this.output.textContent = momentText(this.page, moment);
    this.input.setAttribute("aria-valuetext", this.output.textContent);
  }

  private drawTicks(steps: number, colour: (contact: number) => number): void {
    const ratio = window.devicePixelRatio;
    const { clientWidth, clientHeight } = this.ticks;
    this.ticks.width = clientWidth * ratio;
    this.ticks.height = clientHeight * ratio;
    const context = this.ticks.getContext("2d");
    if (context === null) return;
    context.scale(ratio, ratio);
    // The middle of the thumb, 16 pixels wide, is the value.
    const x = (position: number): number => 8 + (position / steps) * (clientWidth - 16);
    const { contacts } = this.page;
    // The rim is visible on any background.
    context.fillStyle = "#8a949e";
    for (const { frame, time } of contacts) context.fillRect(x(frame + time) - 2.5, 0, 5, clientHeight);
    // The earliest is drawn last.
    for (let i = contacts.length - 1; i >= 0; i--) {
      context.fillStyle = css(viridis(colour(i)));
      context.fillRect(x(contacts[i].frame + contacts[i].time) - 1.5, 1, 3, clientHeight - 2);
    }
  }
}
