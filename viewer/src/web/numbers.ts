/** Numbers as texts: decimals, and hexadecimal floats, which are exact. */

/** A finite f64 as an integer times a power of two. */
export function decode(x: number): [mantissa: bigint, exponent: number] {
  const bits = new DataView(new ArrayBuffer(8));
  bits.setFloat64(0, x);
  const word = bits.getBigUint64(0);
  const biased = Number((word >> 52n) & 0x7ffn);
  const fraction = word & 0xfffffffffffffn;
  const mantissa = biased === 0 ? fraction : fraction | (1n << 52n);
  return [word >> 63n === 1n ? -mantissa : mantissa, Math.max(biased, 1) - 1075];
}

const HEXADECIMAL = /^([+-]?)0x([0-9a-f]*)(?:\.([0-9a-f]*))?(?:p([+-]?\d{1,5}))?$/i;
const DECIMAL = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i;

/** The number of a text, or the reason why it is not a finite f64. A decimal is rounded to the nearest f64. */
export function parseNumber(text: string): number | string {
  const trimmed = text.trim();
  if (DECIMAL.test(trimmed)) {
    const x = Number(trimmed);
    return Number.isFinite(x) ? x : "larger than all f64";
  }
  const match = HEXADECIMAL.exec(trimmed);
  const digits = match === null ? "" : match[2] + (match[3] ?? "");
  if (match === null || digits === "") return "not a number, expected a decimal such as -1.5e-3, or 0x1.8p-10";
  const exponent = Number(match[4] ?? 0) - 4 * (match[3] ?? "").length;
  const size = exactly(BigInt(`0x${digits}`), exponent);
  if (size === null) return "not exactly an f64";
  return match[1] === "-" ? -size : size;
}

/** The f64 that is an integer times a power of two, if there is one. */
function exactly(mantissa: bigint, exponent: number): number | null {
  if (mantissa === 0n) return 0;
  while (mantissa % 2n === 0n) [mantissa, exponent] = [mantissa / 2n, exponent + 1];
  const bits = mantissa.toString(2).length;
  // No bit is below the lowest one of an f64, and none above the highest one.
  if (bits > 53 || exponent < -1074 || bits + exponent > 1024) return null;
  // Both factors are f64, and so are both products.
  const half = Math.trunc(exponent / 2);
  return Number(mantissa) * 2 ** half * 2 ** (exponent - half);
}

/** The hexadecimal float of a number, as C's `%a` writes it. */
export function hexadecimal(x: number): string {
  const [signed, exponent] = decode(x);
  const sign = Object.is(Math.sign(x), -0) || x < 0 ? "-" : "";
  const mantissa = signed < 0n ? -signed : signed;
  if (mantissa === 0n) return `${sign}0x0p+0`;
  const bits = mantissa.toString(2).length;
  // One bit before the point, and full digits after it.
  const digits = (mantissa << BigInt(53 - bits)).toString(16);
  const rest = digits.slice(1).replace(/0+$/, "");
  const power = exponent + bits - 1;
  return `${sign}0x1${rest === "" ? "" : `.${rest}`}p${power < 0 ? "" : "+"}${power}`;
}

/** The next f64 above a finite number, or the next one below. */
export function neighbour(x: number, direction: 1 | -1): number {
  const bits = new DataView(new ArrayBuffer(8));
  if (x === 0) return direction * Number.MIN_VALUE;
  bits.setFloat64(0, x);
  const away = x > 0 === direction > 0;
  bits.setBigInt64(0, bits.getBigInt64(0) + (away ? 1n : -1n));
  return bits.getFloat64(0);
}
