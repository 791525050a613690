/** Texts at points of the scene. */

import { type Camera, Vector3 } from "three";
import { type Point } from "../page";

export interface Label {
  at: Point;
  text: string;
  /** The class of its element. Names are at their points, others beside them. */
  kind: "first" | "second" | "name";
}

/** The room for a label, and its distance from its point, in pixels. */
const [WIDTH, HEIGHT, AWAY] = [52, 18, 24];

export class Labels {
  private shown: { at: Vector3; kind: Label["kind"]; element: HTMLElement }[] = [];
  private middle: Vector3 | null = null;

  constructor(private readonly parent: HTMLElement) {}

  /** Shows labels around a point, or around the middle of them. */
  set(labels: Label[], around: Point | null): void {
    this.middle = around === null ? null : new Vector3(...around);
    this.parent.replaceChildren();
    this.shown = labels.map(({ at, text, kind }) => {
      const element = document.createElement("span");
      element.textContent = text;
      element.className = `label ${kind}`;
      this.parent.append(element);
      return { at: new Vector3(...at), kind, element };
    });
  }

  /** Moves the labels to where the camera has their points, away from what they are around. */
  place(camera: Camera, width: number, height: number): void {
    const onScreen = (at: Vector3): Vector3 => {
      const { x, y, z } = at.clone().project(camera);
      return new Vector3(((x + 1) / 2) * width, ((1 - y) / 2) * height, z);
    };
    const places = this.shown.map(({ at }) => onScreen(at));
    const vertices = places.filter((_, i) => this.shown[i].kind !== "name");
    const mean = vertices.reduce((sum, place) => sum.add(place), new Vector3()).divideScalar(vertices.length || 1);
    const middle = this.middle === null ? mean : onScreen(this.middle);
    const taken: [number, number][] = [];
    this.shown.forEach(({ element, kind }, i) => {
      const place = places[i];
      const [dx, dy] = [place.x - middle.x, place.y - middle.y];
      const distance = Math.hypot(dx, dy);
      // A vertex at the middle has its label above, or below for the second primitive.
      const direction = distance < 12 ? [0, kind === "first" ? -1 : 1] : [dx / distance, dy / distance];
      const away = kind === "name" ? 0 : AWAY;
      const x = place.x + away * direction[0];
      let y = place.y + away * direction[1];
      while (taken.some(([x1, y1]) => Math.abs(x - x1) < WIDTH && Math.abs(y - y1) < HEIGHT)) {
        y += (direction[1] < 0 ? -0.5 : 0.5) * HEIGHT;
      }
      element.hidden = place.z > 1;
      if (!element.hidden) taken.push([x, y]);
      element.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px) translate(-50%, -50%)`;
    });
  }
}
