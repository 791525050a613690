/** Round points with a dark rim, in place of the squares of WebGL. */

import { CanvasTexture, type Texture } from "three";

let made: Texture | null = null;

/** A white disc with a dark rim, multiplied by the colour of a point. */
export function disc(): Texture {
  if (made === null) {
    const canvas = document.createElement("canvas");
    canvas.width = canvas.height = 64;
    const context = canvas.getContext("2d");
    if (context !== null) {
      context.beginPath();
      context.arc(32, 32, 27, 0, 2 * Math.PI);
      context.fillStyle = "#fff";
      context.fill();
      context.lineWidth = 9;
      context.strokeStyle = "#111";
      context.stroke();
    }
    made = new CanvasTexture(canvas);
  }
  return made;
}
