/** Particles, and the joints of rods, as balls. */

import { BufferGeometry, Points, PointsMaterial } from "three";
import { ball } from "./disc";
import { BETWEEN, patched, type Uniforms } from "./moving";

/** Balls of the radius of their vertices times `scale`, or of at least `least` pixels. */
export class Balls {
  readonly points: Points<BufferGeometry, PointsMaterial>;

  constructor(least: number, scale: number, shared: Uniforms) {
    const material = new PointsMaterial({ vertexColors: true, size: 2 * least, sizeAttenuation: false, map: ball(), alphaTest: 0.5 });
    const size = `gl_PointSize = max(size, ${(2 * scale).toFixed(2)} * radius * ratio / (pixel * -mvPosition.z));`;
    this.points = new Points(
      new BufferGeometry(),
      patched(material, shared, {
        declarations: `${BETWEEN.declarations}attribute float radius;\n`,
        vertex: { ...BETWEEN.vertex, "gl_PointSize = size;": size },
      }),
    );
  }
}
