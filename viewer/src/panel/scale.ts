/** The ranges and ticks of axes. */

/** The least and the largest value and zero, with a margin, so that the curve is not on the frame. */
export function rangeOf(values: (number | null)[]): [number, number] {
  const [least, most] = extrema(values);
  if (least === most) return [-1, 1];
  const margin = 0.08 * (most - least);
  return [least - margin, most + margin];
}

/** Zero, and the extrema that are far enough from it for a text. */
export function ticksOf(values: (number | null)[]): number[] {
  const [least, most] = extrema(values);
  return [0, ...[least, most].filter((value) => Math.abs(value) > 0.12 * (most - least))];
}

/** The least and the largest value, and zero among them. */
function extrema(values: (number | null)[]): [number, number] {
  let [least, most] = [0, 0];
  for (const value of values) {
    if (value === null) continue;
    least = Math.min(least, value);
    most = Math.max(most, value);
  }
  return [least, most];
}

/** The exponents of the powers of ten around all positive values. */
export function decadesOf(values: (number | null)[]): [number, number] {
  let [least, most] = [Infinity, -Infinity];
  for (const value of values) {
    if (value === null || value <= 0) continue;
    least = Math.min(least, Math.floor(Math.log10(value)));
    most = Math.max(most, Math.ceil(Math.log10(value)));
  }
  if (least > most) return [-1, 1];
  return [least, Math.max(most, least + 1)];
}

/** At most six powers of ten between two exponents, at equal distances. */
export function powerTicks(low: number, high: number): number[] {
  const step = Math.ceil((high - low + 1) / 6);
  return Array.from({ length: Math.floor((high - low) / step) + 1 }, (_, i) => 10 ** (low + i * step));
}

/** About four multiples of 1, 2, 2.5 or 5 times a power of ten between two numbers. */
export function linearTicks(first: number, last: number): number[] {
  const rough = (last - first) / 4;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = power * ([1, 2, 2.5, 5].find((size) => size * power >= rough * (1 - 1e-9)) ?? 10);
  const [from, to] = [Math.ceil(first / step - 1e-9), Math.floor(last / step + 1e-9)];
  return Array.from({ length: Math.max(to - from + 1, 0) }, (_, i) => Number(((from + i) * step).toPrecision(12)));
}

/** Three significant digits. */
export function tickText(value: number): string {
  if (value === 0) return "0";
  const size = Math.abs(value);
  const rounded = Number(value.toPrecision(3));
  return size >= 1e4 || size < 1e-3 ? rounded.toExponential().replace("e+", "e") : String(rounded);
}
