/** Materials whose vertices move in straight lines, on the graphics card. */

import { type Material } from "three";

/** Numbers that all materials of a scene share. */
export interface Uniforms {
  /** The time of the step, from 0 to 1. */
  stepTime: { value: number };
  /** The width of a pixel of the page at the distance 1 from the camera. */
  pixel: { value: number };
  /** The pixels of the screen in a pixel of the page. */
  ratio: { value: number };
}

export const uniforms = (): Uniforms => ({ stepTime: { value: 0 }, pixel: { value: 0 }, ratio: { value: 1 } });

const DECLARATIONS = "uniform float stepTime;\nuniform float pixel;\nuniform float ratio;\n";

/** Texts in place of others in the program of the vertices, and of the fragments. */
export interface Patch {
  declarations: string;
  vertex: Record<string, string>;
  fragment?: Record<string, string>;
}

/** A vertex between `position` and `next`. */
export const BETWEEN: Patch = {
  declarations: "attribute vec3 next;\n",
  vertex: { "#include <begin_vertex>": "vec3 transformed = mix(position, next, stepTime);" },
};

/** The same vertex, nearer to the camera by 0.3 of the width of a pixel there: an edge is in front of its own faces. */
export const IN_FRONT: Patch = {
  ...BETWEEN,
  vertex: {
    ...BETWEEN.vertex,
    "#include <project_vertex>":
      "#include <project_vertex>\n  gl_Position = projectionMatrix * vec4(mvPosition.xyz * (1.0 - 0.3 * pixel), 1.0);",
  },
};

/** The material with a patch of its program. */
export function patched<M extends Material>(material: M, shared: Uniforms, { declarations, vertex, fragment = {} }: Patch): M {
  material.onBeforeCompile = (shader) => {
    Object.assign(shader.uniforms, shared);
    const replace = (text: string, texts: Record<string, string>): string =>
      Object.entries(texts).reduce((whole, [before, after]) => whole.replace(before, after), text);
    shader.vertexShader = DECLARATIONS + declarations + replace(shader.vertexShader, vertex);
    shader.fragmentShader = replace(shader.fragmentShader, fragment);
  };
  // Materials of the same class with different patches are different programs.
  const key = JSON.stringify([vertex, fragment]);
  material.customProgramCacheKey = () => key;
  return material;
}
