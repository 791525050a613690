/** Texts at points of the scene. */

import { type Camera, Vector3 } from "three";
import { type Point } from "../page";

export interface Label {
  at: Point;
  text: string;
  /** The class of its element. */
  kind: "first" | "second" | "contact";
}

/** The room for a label, in pixels. */
const [WIDTH, HEIGHT] = [52, 18];

export class Labels {
  private shown: { at: Vector3; element: HTMLElement }[] = [];

  constructor(private readonly parent: HTMLElement) {}

  set(labels: Label[]): void {
    this.parent.replaceChildren();
    this.shown = labels.map(({ at, text, kind }) => {
      const element = document.createElement("span");
      element.textContent = text;
      element.className = `label ${kind}`;
      this.parent.append(element);
      return { at: new Vector3(...at), element };
    });
  }

  /** Moves the labels to where the camera has their points, away from the middle of them. */
  place(camera: Camera, width: number, height: number): void {
    const places = this.shown.map(({ at }) => at.clone().project(camera));
    const middle = places.reduce((sum, place) => sum.add(place), new Vector3()).divideScalar(places.length || 1);
    const taken: [number, number][] = [];
    this.shown.forEach(({ element }, i) => {
      const place = places[i];
      const [dx, dy] = [(place.x - middle.x) * width, (middle.y - place.y) * height];
      const size = Math.hypot(dx, dy) || 1;
      const x = ((place.x + 1) / 2) * width + (20 * dx) / size;
      let y = ((1 - place.y) / 2) * height + (20 * dy) / size;
      while (taken.some(([x1, y1]) => Math.abs(x - x1) < WIDTH && Math.abs(y - y1) < HEIGHT)) y += HEIGHT / 2;
      element.hidden = place.z > 1;
      if (!element.hidden) taken.push([x, y]);
      element.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px) translate(-50%, -50%)`;
    });
  }
}
