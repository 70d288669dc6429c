// Stress fields as a results folder holds them (schema cleave.stress_field/1), and what is drawn of them.

export interface Packed {
  scale: number;
  data: string; ///< base64 of little-endian 16-bit whole numbers
}
export interface FieldMeasure {
  name: string;
  fem_rms: number;
  difference_rms: number;
  difference_max: number;
  at: [number, number, number];
}
export interface StressField {
  note?: string;
  particles: string;
  fem: string;
  total: number;
  shown: number;
  measures: FieldMeasure[];
  position: Packed;
  radius: Packed;
  stress: Packed; ///< of the particles: xx, yy, zz, yz, xz, xy
  difference: Packed; ///< particles - FEM
}

export interface Points {
  position: Float32Array; ///< m, three per point
  radius: Float32Array; ///< m
  volume: Float64Array; ///< that a point stands for, up to a factor
}
/// One measure at each point, Pa.
export interface Colouring {
  particles: Float64Array;
  fem: Float64Array;
  difference: Float64Array;
}

export function unpack({ scale, data }: Packed): Float64Array {
  const text = atob(data);
  const values = new Float64Array(text.length / 2);
  for (let i = 0; i < values.length; ++i) {
    const whole = text.charCodeAt(2 * i) | (text.charCodeAt(2 * i + 1) << 8);
    values[i] = scale * (whole < 0x8000 ? whole : whole - 0x10000);
  }
  return values;
}

export function points_of(field: StressField): Points {
  const radius = unpack(field.radius);
  return { position: Float32Array.from(unpack(field.position)), radius: Float32Array.from(radius), volume: radius.map((r) => r ** 3) };
}

/// Largest eigenvalue of the symmetric tensor xx, yy, zz, yz, xz, xy, by Jacobi's rotations: exact where two of them meet.
export function largest_principal(s: ArrayLike<number>): number {
  const a = [
    [s[0], s[5], s[4]],
    [s[5], s[1], s[3]],
    [s[4], s[3], s[2]],
  ];
  for (let sweep = 0; sweep < 12; ++sweep) {
    for (const [p, q] of [[0, 1], [0, 2], [1, 2]]) {
      if (a[p][q] === 0) continue;
      const theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
      const t = (theta < 0 ? -1 : 1) / (Math.abs(theta) + Math.hypot(theta, 1));
      const c = 1 / Math.hypot(t, 1);
      const r = 3 - p - q;
      const [arp, arq] = [a[r][p], a[r][q]];
      a[p][p] -= t * a[p][q];
      a[q][q] += t * a[p][q];
      a[p][q] = a[q][p] = 0;
      a[r][p] = a[p][r] = c * (arp - t * arq);
      a[r][q] = a[q][r] = c * (arq + t * arp);
    }
  }
  return Math.max(a[0][0], a[1][1], a[2][2]);
}

const components = ["xx", "yy", "zz", "yz", "xz", "xy"];

export function colouring_of(field: StressField, measure: string): Colouring {
  const stress = unpack(field.stress);
  const apart = unpack(field.difference);
  const component = components.indexOf(measure);
  const of = component < 0 ? largest_principal : (s: ArrayLike<number>) => s[component];
  const [particles, fem, difference] = [0, 1, 2].map(() => new Float64Array(field.shown));
  for (let i = 0; i < field.shown; ++i) {
    const one = stress.subarray(6 * i, 6 * i + 6);
    const off = apart.subarray(6 * i, 6 * i + 6);
    const other = one.map((value, k) => value - off[k]);
    particles[i] = of(one);
    fem[i] = of(other);
    difference[i] = component < 0 ? particles[i] - fem[i] : off[component];
  }
  return { particles, fem, difference };
}

/// The value that `share` of the weight lies at or below.
export function quantile(values: Float64Array, weights: Float64Array, share: number): number {
  const order = Array.from(values.keys()).sort((a, b) => values[a] - values[b]);
  let rest = share * weights.reduce((a, b) => a + b, 0);
  return values[order.find((i) => (rest -= weights[i]) <= 0) ?? order[order.length - 1]];
}

export interface Range {
  low: number;
  high: number;
  beyond: number; ///< share of the volume outside, which takes the colour of the end
}

function beyond(values: Float64Array, weights: Float64Array, low: number, high: number): number {
  const sum = (of: (i: number) => boolean): number => weights.reduce((total, weight, i) => total + (of(i) ? weight : 0), 0);
  return sum((i) => values[i] < low || values[i] > high) / sum(() => true);
}

const outer_share = 0.005;

/// All but the outermost hundredth of the volume, half of it at either end, of both fields together: one crack tip must not take all
/// colours for itself.
export function shared_range({ particles, fem }: Colouring, volume: Float64Array): Range {
  const both = Float64Array.of(...particles, ...fem);
  const weights = Float64Array.of(...volume, ...volume);
  let [low, high] = [quantile(both, weights, outer_share), quantile(both, weights, 1 - outer_share)];
  const least = 1e-3 * Math.max(Math.abs(low), Math.abs(high)) || 1;
  if (high - low < least) [low, high] = [(low + high - least) / 2, (low + high + least) / 2]; // a uniform field is one colour
  return { low, high, beyond: beyond(both, weights, low, high) };
}

/// About zero, to the difference that all but the outermost hundredth of the volume stays below.
export function difference_range({ difference }: Colouring, volume: Float64Array): Range {
  const sizes = difference.map(Math.abs);
  const high = quantile(sizes, volume, 1 - 2 * outer_share) || Math.max(...sizes) || 1;
  return { low: -high, high, beyond: beyond(difference, volume, -high, high) };
}

type Stops = [number, number, number][];

/// Viridis (van der Walt and Smith 2015), and blue over grey to red after Moreland 2009: both are even to the eye and safe for the colour-blind.
export const sequential: Stops = [
  [68, 1, 84],
  [72, 40, 120],
  [62, 74, 137],
  [49, 104, 142],
  [38, 130, 142],
  [31, 158, 137],
  [53, 183, 121],
  [109, 205, 89],
  [180, 222, 44],
  [253, 231, 37],
];
export const diverging: Stops = [
  [59, 76, 192],
  [104, 138, 239],
  [153, 186, 255],
  [201, 216, 240],
  [221, 221, 221],
  [242, 203, 183],
  [247, 168, 137],
  [226, 105, 82],
  [180, 4, 38],
];

export function colour_at(stops: Stops, share: number): [number, number, number] {
  const at = Math.min(1, Math.max(0, share)) * (stops.length - 1);
  const i = Math.min(Math.floor(at), stops.length - 2);
  return [0, 1, 2].map((k) => stops[i][k] + (at - i) * (stops[i + 1][k] - stops[i][k])) as [number, number, number];
}

export function gradient_of(stops: Stops): string {
  return `linear-gradient(to right, ${stops.map((stop) => `rgb(${stop.join(",")})`).join(", ")})`;
}

/// Three bytes per point.
export function colours_of(values: Float64Array, { low, high }: Range, stops: Stops): Uint8Array {
  const bytes = new Uint8Array(3 * values.length);
  values.forEach((value, i) => bytes.set(colour_at(stops, (value - low) / (high - low)), 3 * i));
  return bytes;
}
