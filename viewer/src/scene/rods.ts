/** Rods, as tubes: a cylinder for each edge, whose ends move on the graphics card. */

import { CylinderGeometry, InstancedBufferAttribute, InstancedBufferGeometry, Mesh, MeshLambertMaterial, Sphere, Vector3 } from "three";
import { patched, type Uniforms } from "./moving";

/** The least radius of a rod, in pixels. */
export const THIN = 2;

const TUBE = {
  declarations: `attribute vec3 from; attribute vec3 fromNext; attribute vec3 to; attribute vec3 toNext;
attribute vec2 radii;
`,
  vertex: {
    "#include <beginnormal_vertex>": `vec3 first = mix(from, fromNext, stepTime);
  vec3 second = mix(to, toNext, stepTime);
  vec3 axis = second - first;
  float span = length(axis);
  axis = span > 0.0 ? axis / span : vec3(0.0, 0.0, 1.0);
  vec3 side = normalize(cross(axis, abs(axis.x) < 0.7 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0)));
  vec3 objectNormal = side * position.x + cross(side, axis) * position.z;`,
    "#include <begin_vertex>": `float along = position.y + 0.5;
  vec3 middle = mix(first, second, along);
  float away = -(modelViewMatrix * vec4(middle, 1.0)).z;
  vec3 transformed = middle + max(mix(radii.x, radii.y, along), ${THIN.toFixed(1)} * pixel * away) * objectNormal;`,
  },
};

type Positions = Float32Array;

export class Rods {
  readonly mesh: Mesh<InstancedBufferGeometry, MeshLambertMaterial>;
  private edges = new Uint32Array();
  private readonly ends: InstancedBufferAttribute[] = [];

  constructor(shared: Uniforms) {
    this.mesh = new Mesh(new InstancedBufferGeometry(), patched(new MeshLambertMaterial({ vertexColors: true }), shared, TUBE));
  }

  /** Shows these edges, with a colour and a radius for each vertex. */
  show(edges: Uint32Array<ArrayBuffer>, colours: Uint8Array, radii: Positions): void {
    this.edges = edges;
    const count = edges.length / 2;
    const tube = new CylinderGeometry(1, 1, 1, 10, 1, true);
    const geometry = new InstancedBufferGeometry();
    geometry.instanceCount = count;
    geometry.setIndex(tube.getIndex());
    geometry.setAttribute("position", tube.getAttribute("position"));
    const ofFirst = new Uint8Array(3 * count);
    for (let i = 0; i < count; i++) ofFirst.set(colours.subarray(3 * edges[2 * i], 3 * edges[2 * i] + 3), 3 * i);
    geometry.setAttribute("color", new InstancedBufferAttribute(ofFirst, 3, true));
    const both = Float32Array.from(edges, (vertex) => radii[vertex] ?? 0);
    geometry.setAttribute("radii", new InstancedBufferAttribute(both, 2));
    this.ends.length = 0;
    for (const name of ["from", "to", "fromNext", "toNext"]) {
      const attribute = new InstancedBufferAttribute(new Float32Array(3 * count), 3);
      this.ends.push(attribute);
      geometry.setAttribute(name, attribute);
    }
    // Nothing is left out for being outside the view, which depends on the time.
    geometry.boundingSphere = new Sphere(new Vector3(), Infinity);
    this.mesh.geometry.dispose();
    this.mesh.geometry = geometry;
  }

  /** Positions of all vertices at both ends of the step. */
  setEnds(ends: [Positions, Positions]): void {
    this.ends.forEach((attribute, i) => {
      const [side, positions] = [i % 2, ends[i >> 1]];
      const array = attribute.array as Float32Array;
      for (let edge = 0; 3 * edge < array.length; edge++) {
        const vertex = this.edges[2 * edge + side];
        for (let axis = 0; axis < 3; axis++) array[3 * edge + axis] = positions[3 * vertex + axis];
      }
      attribute.needsUpdate = true;
    });
  }
}
