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
import { Plot } from "./plot";

/** A root of the cubic this near to a contact time is the same one. */
const SAME = 1e-6;

const SAMPLES = 240;

export class QueryPanel {
  private readonly plots: Plot[];
  private readonly image: DomainImage;
  private readonly view: View;
  private readonly slice: BufferAttribute;
  private readonly area = new MeshBasicMaterial({ side: DoubleSide, transparent: true, opacity: 0.75 });
  private readonly outline = new LineBasicMaterial();

  constructor(query: Query, plots: HTMLElement, canvas: HTMLCanvasElement, choose: (t: number) => void) {
    const cubic = cubicOf(query);
    const accepted = [...new Set(query.times.flat())].map((t) => ({ t, accepted: true }));
    const meets = query.separation === 0;
    const isIn = (root: number, [start, end]: [number, number]): boolean => root > start - SAME && root < end + SAME;
    const others = rootsOf(cubic).filter((root) => !meets || !query.times.some((interval) => isIn(root, interval)));
    const values = Array.from({ length: SAMPLES + 1 }, (_, i) => bernstein(cubic, i / SAMPLES));
    this.plots = [
      new Plot({
        title: "Coplanarity cubic",
        unit: "relative",
        values,
        level: 0,
        marks: [...others.map((t) => ({ t, accepted: false })), ...(meets ? accepted : [])],
        intervals: meets ? query.times : [],
        choose,
      }),
      new Plot({
        title: "Distance of the primitives",
        unit: "length",
        values: query.distances,
        level: query.separation,
        marks: accepted,
        intervals: query.times,
        choose,
      }),
    ];
    plots.append(...this.plots.map((plot) => plot.svg));

    this.image = new DomainImage(query);
    this.view = new View(canvas, [0, 0, 1], 4);
    const sides = new MeshBasicMaterial({ color: "#888888", side: DoubleSide, transparent: true, opacity: 0.22, depthWrite: false });
    this.view.add(new Mesh(shape(this.image.sides(16)), sides));
    this.view.add(new LineSegments(shape(this.image.outline()), this.outline));
    const slice = shape(this.image.slice(0));
    this.slice = slice.getAttribute("position") as BufferAttribute;
    const area = new Mesh(slice, this.area);
    area.frustumCulled = false;
    this.view.add(area);
    const origin = new PointsMaterial({ color: MARKS.light.contact, size: 14, sizeAttenuation: false, map: disc(), alphaTest: 0.4 });
    this.view.addMark(new Points(shape([0, 0, 0]), origin));
    const radius = Math.max(...[...this.image.at(0), ...this.image.at(1)].map(length));
    this.view.go(overview([0, 0, 0], 0.6 * radius, [0, 0, 1]), true);
  }

  update({ moment, theme }: State): void {
    this.slice.set(this.image.slice(moment.t));
    this.slice.needsUpdate = true;
    this.area.color.set(MARKS[theme].second);
    this.outline.color.set(MARKS[theme].path);
    this.view.setBackground(MARKS[theme].background);
    for (const plot of this.plots) plot.show(moment.t);
  }
}

function shape(coordinates: number[]): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(Float32Array.from(coordinates), 3));
  return geometry;
}
