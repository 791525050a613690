/** The answers to a query: the plots over time, and the image of the domain. */

import { BufferAttribute, BufferGeometry, DoubleSide, LineBasicMaterial, LineSegments, Mesh, MeshBasicMaterial, Points, PointsMaterial } from "three";
import { MARKS } from "../colours";
import { type Query } from "../page";
import { disc } from "../scene/disc";
import { overview } from "../scene/pose";
import { View } from "../scene/view";
import { type State } from "../state";
import { length } from "../vector";
import { bernstein, cubicOf, rootsOf } from "./cubic";
import { DomainImage } from "./image";
import { Plot } from "../panel/plot";

/** A root of the cubic this near to a contact time is the same one. */
const SAME = 1e-6;

const SAMPLES = 240;

export class QueryPanel {
  private plots: Plot[] = [];
  private image: DomainImage | null = null;
  private view: View | null = null;
  private readonly sides = shape([]);
  private readonly edges = shape([]);
  private readonly slice = shape([]);
  private readonly area = new MeshBasicMaterial({ side: DoubleSide, transparent: true, opacity: 0.75 });
  private readonly outline = new LineBasicMaterial();

  constructor(
    private readonly parent: HTMLElement,
    private readonly canvas: HTMLCanvasElement,
    private readonly choose: (t: number) => void,
  ) {}

  show(query: Query | null): void {
    this.plots = query === null ? [] : this.plotsOf(query);
    this.parent.replaceChildren(...this.plots.map((plot) => plot.element));
    this.image = query === null ? null : new DomainImage(query);
    if (this.image === null) return;
    put(this.sides, this.image.sides(16));
    put(this.edges, this.image.outline());
    const radius = Math.max(...[...this.image.at(0), ...this.image.at(1)].map(length));
    // Before the first query there is nothing to draw.
    this.view ??= this.open(radius);
    this.view.request();
  }

  private plotsOf(query: Query): Plot[] {
    const { choose } = this;
    const cubic = cubicOf(query);
    const accepted = [...new Set(query.times.flat())].map((t) => ({ t, accepted: true }));
    const meets = query.separation === 0;
    const isIn = (root: number, [start, end]: [number, number]): boolean => root > start - SAME && root < end + SAME;
    const others = rootsOf(cubic).filter((root) => !meets || !query.times.some((interval) => isIn(root, interval)));
    const timesOf = (count: number): number[] => Array.from({ length: count }, (_, i) => i / (count - 1));
    const times = timesOf(SAMPLES + 1);
    const axis = { time: "time t", logarithmic: false, choose };
    return [
      new Plot({
        title: "Coplanarity cubic",
        unit: "relative",
        times,
        curves: [{ name: "", values: times.map((t) => bernstein(cubic, t)) }],
        level: 0,
        marks: [...others.map((t) => ({ t, accepted: false })), ...(meets ? accepted : [])],
        intervals: meets ? query.times : [],
        ...axis,
      }),
      new Plot({
        title: "Distance of the primitives",
        unit: "length",
        times: timesOf(query.distances.length),
        curves: [{ name: "", values: query.distances }],
        level: query.separation,
        marks: accepted,
        intervals: query.times,
        ...axis,
      }),
    ];
  }

  private open(radius: number): View {
    const view = new View(this.canvas);
    view.setSpace([0, 0, 1], 4, 4);
    const sides = new MeshBasicMaterial({ color: "#888888", side: DoubleSide, transparent: true, opacity: 0.22, depthWrite: false });
    for (const object of [new Mesh(this.sides, sides), new LineSegments(this.edges, this.outline), new Mesh(this.slice, this.area)]) {
      object.frustumCulled = false;
      view.add(object);
    }
    const origin = new PointsMaterial({ color: MARKS.light.contact, size: 14, sizeAttenuation: false, map: disc(), alphaTest: 0.4 });
    view.addMark(new Points(shape([0, 0, 0]), origin));
    view.go(overview([0, 0, 0], 0.6 * radius, [0, 0, 1]), true);
    return view;
  }

  update({ moment, theme }: State): void {
    if (this.image === null || this.view === null) return;
    put(this.slice, this.image.slice(moment.t));
    this.area.color.set(MARKS[theme].second);
    this.outline.color.set(MARKS[theme].path);
    this.view.setBackground(MARKS[theme].background);
    for (const plot of this.plots) plot.show(moment.t);
  }
}

function shape(coordinates: number[]): BufferGeometry {
  const geometry = new BufferGeometry();
  put(geometry, coordinates);
  return geometry;
}

/** Replaces the positions of a geometry. */
function put(geometry: BufferGeometry, coordinates: number[]): void {
  const before = geometry.getAttribute("position") as BufferAttribute | undefined;
  if (before?.array.length === coordinates.length) {
    before.set(coordinates);
    before.needsUpdate = true;
    return;
  }
  geometry.dispose();
  geometry.setAttribute("position", new BufferAttribute(Float32Array.from(coordinates), 3));
}
