/** Round points with a dark rim, in place of the squares of WebGL. */

import { CanvasTexture, type Texture } from "three";

const made = new Map<string, Texture>();

/** A white disc with a dark rim, multiplied by the colour of a point. */
export function disc(): Texture {
  return drawn("disc", (context) => {
    context.beginPath();
    context.arc(32, 32, 27, 0, 2 * Math.PI);
    context.fillStyle = "#fff";
    context.fill();
    context.lineWidth = 9;
    context.strokeStyle = "#111";
    context.stroke();
  });
}

/** A ball with light from the upper left, multiplied by the colour of a point. */
export function ball(): Texture {
  return drawn("ball", (context) => {
    const light = context.createRadialGradient(23, 21, 2, 32, 32, 31);
    for (const [place, colour] of [[0, "#fff"], [0.45, "#dcdcdc"], [0.85, "#8a8a8a"], [1, "#3c3c3c"]] as const) {
      light.addColorStop(place, colour);
    }
    context.beginPath();
    context.arc(32, 32, 31, 0, 2 * Math.PI);
    context.fillStyle = light;
    context.fill();
  });
}

/** A white ring with dark rims. */
export function ring(): Texture {
  return drawn("ring", (context) => {
    for (const [width, colour] of [[24, "#111"], [13, "#fff"]] as const) {
      context.beginPath();
      context.arc(32, 32, 20, 0, 2 * Math.PI);
      context.lineWidth = width;
      context.strokeStyle = colour;
      context.stroke();
    }
  });
}

function drawn(name: string, draw: (context: CanvasRenderingContext2D) => void): Texture {
  let texture = made.get(name);
  if (texture === undefined) {
    const canvas = document.createElement("canvas");
    canvas.width = canvas.height = 64;
    const context = canvas.getContext("2d");
    if (context !== null) draw(context);
    texture = new CanvasTexture(canvas);
    made.set(name, texture);
  }
  return texture;
}
