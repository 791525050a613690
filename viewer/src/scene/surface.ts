/** The faces of a mesh. Front sides are distinct from back sides, and what is in front from what is behind. */

import { type BufferGeometry, DoubleSide, Group, Mesh, MeshLambertMaterial } from "three";
import { BETWEEN, patched, type Uniforms } from "./moving";

/** Back sides have 0.42 of the light of front sides, and half of their colour. */
const BACK_SIDES = `#include <color_fragment>
  if (!gl_FrontFacing) {
    float grey = dot(diffuseColor.rgb, vec3(0.2126, 0.7152, 0.0722));
    diffuseColor.rgb = 0.42 * mix(diffuseColor.rgb, vec3(grey), 0.5);
  }`;

/** The opacity of faces behind others, as a part of the opacity of the nearest faces. */
const BEHIND = 0.5;

/**
 * If faces are transparent, they are drawn three times: all faint; then their depths only; then the nearest ones. So
 * the nearest layer is distinct, whatever the order of the faces, and layers behind it shine through.
 */
export class Surface {
  readonly group = new Group();
  private readonly behind: Mesh<BufferGeometry, MeshLambertMaterial>;
  private readonly depth: Mesh<BufferGeometry, MeshLambertMaterial>;
  private readonly nearest: Mesh<BufferGeometry, MeshLambertMaterial>;

  constructor(geometry: BufferGeometry, shared: Uniforms) {
    const pass = (order: number, offset: number): Mesh<BufferGeometry, MeshLambertMaterial> => {
      const material = new MeshLambertMaterial({
        vertexColors: true,
        flatShading: true,
        side: DoubleSide,
        forceSinglePass: true,
        transparent: true,
        depthWrite: false,
        polygonOffset: true,
        // Not by the slope: a steep surface would be shifted behind another one that it is close to.
        polygonOffsetFactor: 0,
        polygonOffsetUnits: offset,
      });
      const patch = { ...BETWEEN, fragment: { "#include <color_fragment>": BACK_SIDES } };
      const mesh = new Mesh(geometry, patched(material, shared, patch));
      mesh.renderOrder = order;
      this.group.add(mesh);
      return mesh;
    };
    this.behind = pass(1, 1);
    this.depth = pass(2, 2);
    this.nearest = pass(3, 1);
    this.depth.material.colorWrite = false;
    this.depth.material.depthWrite = true;
  }

  show(geometry: BufferGeometry): void {
    this.nearest.geometry.dispose();
    for (const mesh of [this.behind, this.depth, this.nearest]) mesh.geometry = geometry;
  }

  setOpacity(opacity: number): void {
    const isClear = opacity < 1;
    this.behind.visible = this.depth.visible = isClear && opacity > 0;
    this.behind.material.opacity = BEHIND * opacity;
    this.nearest.material.opacity = opacity;
    this.nearest.material.transparent = isClear;
    this.nearest.material.depthWrite = !isClear;
    this.nearest.visible = opacity > 0;
  }
}
