/** The camera, the lights and the drawing of a scene, when something has changed. */

import { AmbientLight, Color, DirectionalLight, Fog, type Object3D, PerspectiveCamera, Scene, Vector3, WebGLRenderer } from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { type Point } from "../page";
import { type Uniforms, uniforms } from "./moving";
import { ANGLE, type Pose } from "./pose";

/** The duration of a movement of the camera, in milliseconds. */
const TRAVEL = 350;

/** The length over which things fade into the background behind the middle of the view, in radii of the scene. What is
 * behind is paler so. */
const FADE = 3.3;

export class View {
  readonly camera = new PerspectiveCamera(ANGLE, 1, 0.01, 100);
  private readonly renderer: WebGLRenderer;
  private controls: OrbitControls;
  private readonly scene = new Scene();
  /** Drawn in front of the scene. */
  private readonly marks = new Scene();
  private readonly light = new DirectionalLight(0xffffff, 2.6);
  private readonly fade = new Fog(0xffffff, 1, 1000);
  private requested = false;
  private travel: { from: Pose; to: Pose; start: number } | null = null;
  private reach = 1;
  private radius = 1;

  /** `drawn` is called after each picture. */
  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly drawn: (width: number, height: number) => void = () => undefined,
    private readonly shared: Uniforms = uniforms(),
  ) {
    this.renderer = new WebGLRenderer({ canvas, antialias: true, alpha: false, powerPreference: "high-performance" });
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.renderer.autoClear = false;
    this.controls = this.control();
    this.scene.add(new AmbientLight(0xffffff, 1.1), this.light, this.light.target);
    this.scene.fog = this.fade;
    new ResizeObserver(() => this.resize()).observe(canvas);
    this.resize();
  }

  private control(): OrbitControls {
    const controls = new OrbitControls(this.camera, this.canvas);
    controls.zoomToCursor = true;
    controls.addEventListener("change", () => this.request());
    controls.addEventListener("start", () => (this.travel = null));
    return controls;
  }

  /** The direction upwards, the distance of the farthest object from the origin, and the radius of the scene. */
  setSpace(up: Point, reach: number, radius: number): void {
    [this.reach, this.radius] = [reach, radius];
    const [x, y, z] = up;
    if (!this.camera.up.equals({ x, y, z })) {
      this.camera.up.set(x, y, z);
      // The controls take the axis of turning when they are made.
      this.controls.dispose();
      this.controls = this.control();
    }
    this.request();
  }

  add(object: Object3D): void {
    this.scene.add(object);
  }

  addMark(object: Object3D): void {
    this.marks.add(object);
  }

  setBackground(colour: string): void {
    this.renderer.setClearColor(new Color(colour));
    this.fade.color.set(colour);
    this.request();
  }

  /** Draws a picture before the next repaint. */
  request(): void {
    if (this.requested) return;
    this.requested = true;
    requestAnimationFrame((now) => {
      this.requested = false;
      this.draw(now);
    });
  }

  /** The present place of the camera. */
  get pose(): Pose {
    return { target: this.controls.target.toArray(), position: this.camera.position.toArray() };
  }

  /** Moves the camera, at once or in a short time. */
  go(to: Pose, atOnce: boolean): void {
    const still = atOnce || window.matchMedia("(prefers-reduced-motion: reduce)").matches;
    this.travel = still ? null : { from: this.pose, to, start: performance.now() };
    if (still) this.set(to);
    this.request();
  }

  /** Moves the camera at once to a pose that depends on the present one, or on the last pose of a movement under way. */
  move(to: (pose: Pose, up: Point) => Pose): void {
    this.go(to(this.travel?.to ?? this.pose, this.camera.up.toArray()), true);
  }

  private set({ target, position }: Pose): void {
    this.controls.target.set(...target);
    this.camera.position.set(...position);
    this.controls.update();
  }

  private resize(): void {
    const { clientWidth, clientHeight } = this.canvas;
    if (clientWidth === 0 || clientHeight === 0) return;
    this.renderer.setSize(clientWidth, clientHeight, false);
    this.camera.aspect = clientWidth / clientHeight;
    this.shared.pixel.value = (2 * Math.tan((ANGLE / 2) * (Math.PI / 180))) / clientHeight;
    this.shared.ratio.value = this.renderer.getPixelRatio();
    this.request();
  }

  private draw(now: number): void {
    if (this.travel !== null) {
      const { from, to, start } = this.travel;
      const x = Math.min((now - start) / TRAVEL, 1);
      const s = x * x * (3 - 2 * x);
      const between = (a: Point, b: Point): Point =>
        new Vector3(...a).lerp(new Vector3(...b), s).toArray();
      this.set({ target: between(from.target, to.target), position: between(from.position, to.position) });
      if (x >= 1) this.travel = null;
      else this.request();
    }
    const distance = this.camera.position.distanceTo(this.controls.target);
    this.camera.near = distance / 50;
    this.camera.far = this.camera.position.length() + 2 * this.reach;
    this.camera.updateProjectionMatrix();
    this.fade.near = Math.max(distance - 0.5 * this.radius, 0.7 * distance);
    this.fade.far = this.fade.near + FADE * this.radius;
    // The light is at the left shoulder of the viewer.
    this.light.position.set(-0.7, 0.9, 0.9).applyQuaternion(this.camera.quaternion).add(this.controls.target);
    this.light.target.position.copy(this.controls.target);
    this.renderer.clear();
    this.renderer.render(this.scene, this.camera);
    this.renderer.clearDepth();
    this.renderer.render(this.marks, this.camera);
    const { clientWidth, clientHeight } = this.canvas;
    this.drawn(clientWidth, clientHeight);
  }
}
