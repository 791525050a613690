/**
 * Colours that people with any kind of colour vision distinguish.
 *
 * Marks: M. Okabe and K. Ito, "Color Universal Design", 2008. Parts: P. Tol, "Colour schemes", 2021, scheme "light", without the
 * orange of marks.
 * Times: the scale viridis by S. van der Walt and N. Smith, 2015, at nine places.
 */

export type Theme = "light" | "dark";

/** The parts of a mesh, in turn. */
export const PARTS = ["#44bb99", "#eedd88", "#dddddd", "#bbcc33", "#ffaabb", "#99ddff", "#aaaa00", "#77aadd"];

/** The colours of the marks of a contact. */
export interface MarkColours {
  background: string;
  first: string;
  second: string;
  contact: string;
  normal: string;
  path: string;
  wire: string;
}

export const MARKS: Record<Theme, MarkColours> = {
  light: {
    background: "#ffffff",
    first: "#0072b2",
    second: "#d55e00",
    contact: "#f0e442",
    normal: "#000000",
    path: "#555555",
    wire: "#404850",
  },
  dark: {
    background: "#14171a",
    first: "#56b4e9",
    second: "#e69f00",
    contact: "#f0e442",
    normal: "#ffffff",
    path: "#b0b0b0",
    wire: "#c8d0d8",
  },
};

const VIRIDIS: [number, number, number][] = [
  [68, 1, 84],
  [71, 44, 122],
  [59, 81, 139],
  [44, 113, 142],
  [33, 144, 141],
  [39, 173, 129],
  [92, 200, 99],
  [170, 220, 50],
  [253, 231, 37],
];

/** The colour of a number from 0 (dark) to 1 (bright), each component from 0 to 255. */
export function viridis(x: number): [number, number, number] {
  const place = Math.min(Math.max(x, 0), 1) * (VIRIDIS.length - 1);
  const i = Math.min(Math.floor(place), VIRIDIS.length - 2);
  const along = (k: 0 | 1 | 2): number =>
    Math.round(VIRIDIS[i][k] + (place - i) * (VIRIDIS[i + 1][k] - VIRIDIS[i][k]));
  return [along(0), along(1), along(2)];
}

export function css([r, g, b]: [number, number, number]): string {
  return `rgb(${r} ${g} ${b})`;
}
