/** Texts at points of the scene. */

import { type Camera, Vector3 } from "three";
import { type Point } from "../page";

export interface Label {
  at: Point;
  text: string;
  /** The class of its element. */
  kind: "first" | "second" | "contact";
}

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
    this.shown.forEach(({ element }, i) => {
      const place = places[i];
      const [x, y] = [((place.x + 1) / 2) * width, ((1 - place.y) / 2) * height];
      const [dx, dy] = [place.x - middle.x, middle.y - place.y];
      const size = Math.hypot(dx * width, dy * height) || 1;
      const away = [(18 * dx * width) / size, (18 * dy * height) / size];
      element.hidden = place.z > 1;
      element.style.transform = `translate(${(x + away[0]).toFixed(1)}px, ${(y + away[1]).toFixed(1)}px) translate(-50%, -50%)`;
    });
  }
}
