// Numbers as a careful typesetter writes them: minus signs, thin spaces, SI prefixes, powers of ten.

const narrow = "\u202f";
const hard = "\u00a0"; // a space that no line break takes
const superscripts: Record<string, string> = {
  "-": "⁻",
  "0": "⁰",
  "1": "¹",
  "2": "²",
  "3": "³",
  "4": "⁴",
  "5": "⁵",
  "6": "⁶",
  "7": "⁷",
  "8": "⁸",
  "9": "⁹",
};

export const dash = "–";

export function superscript(power: number): string {
  return String(power)
    .split("")
    .map((digit) => superscripts[digit] ?? digit)
    .join("");
}

function grouped(digits: string): string {
  const [whole, rest] = digits.split(".");
  const text = whole.replace("-", "").length > 4 ? whole.replace(/\B(?=(\d{3})+$)/g, narrow) : whole;
  return rest === undefined ? text : `${text}.${rest}`;
}

function plain(value: number, digits: number): string {
  const text = value.toPrecision(digits);
  return grouped(text.includes("e") ? String(Number(text)) : text).replace("-", "−");
}

function is_plain_size(value: number): boolean {
  return Math.abs(value) >= 1e-3 && Math.abs(value) < 1e5;
}

/// At most `digits` significant digits, without trailing zeros where they say nothing.
export function number(value: number | null | undefined, digits = 4): string {
  if (value === null || value === undefined || !Number.isFinite(value)) return dash;
  if (value === 0) return "0";
  if (Number.isInteger(value) && Math.abs(value) < 1e7) return grouped(String(value)).replace("-", "−");
  if (is_plain_size(value)) return trim_zeros(plain(Number(value.toPrecision(digits)), digits));
  const [mantissa, power] = value.toExponential(digits - 1).split("e");
  const short = trim_zeros(mantissa).replace("-", "−");
  return `${short}${hard}×${hard}10${superscript(Number(power))}`;
}

function trim_zeros(text: string): string {
  return text.includes(".") && !text.includes("e") ? text.replace(/\.?0+$/, "") : text;
}

/// "Pa m^0.5" -> "Pa √m", "J/m^2" -> "J/m²".
export function unit_text(unit: string): string {
  if (unit === "1") return "";
  return unit
    .replace(/ /g, hard)
    .replace(/\bm\^0\.5\b/g, "√m")
    .replace(/\^(-?\d+)/g, (_, power: string) => superscript(Number(power)))
    .replace(/\s*\*\s*/g, "·");
}

const prefixes: [number, string][] = [
  [1e12, "T"],
  [1e9, "G"],
  [1e6, "M"],
  [1e3, "k"],
  [1, ""],
  [1e-3, "m"],
  [1e-6, "µ"],
  [1e-9, "n"],
];

/// The leading unit takes a prefix only where it stands to the first power: mm² is not a thousandth of m².
function takes_prefix(unit: string): boolean {
  return /^(Pa|J|N|m|s|Hz)(?!\^|\w)/.test(unit);
}

/// "6.65 MPa". Prefixes are chosen so that the number lies between 1 and 1000 where possible.
export function quantity(value: number | null | undefined, unit: string | null | undefined, digits = 4): string {
  if (value === null || value === undefined || !Number.isFinite(value)) return dash;
  if (!unit || unit === "1") return number(value, digits);
  if (value !== 0 && takes_prefix(unit)) {
    const found = prefixes.find(([factor]) => Math.abs(value) >= factor * 0.9995);
    if (found && Math.abs(value) < 1e15) return `${number(value / found[0], digits)}${hard}${found[1]}${unit_text(unit)}`;
  }
  return `${number(value, digits)}${hard}${unit_text(unit)}`;
}

export function percent(share: number | null | undefined): string {
  if (share === null || share === undefined || !Number.isFinite(share)) return dash;
  if (share !== 0 && Math.abs(share) < 1e-5) return number(share, 2);
  return `${number(share * 100, Math.abs(share) < 0.1 ? 2 : 3)}${hard}%`;
}

export function words(name: string): string {
  return name.replace(/_/g, " ");
}

function as_text(value: unknown): string {
  return typeof value === "number" ? number(value) : typeof value === "string" ? value : JSON.stringify(value);
}

/// The acceptance interval in words. `unit` belongs to absolute bands.
export function band_text(band: Record<string, unknown> | null | undefined, unit: string | null | undefined): string {
  if (!band) return dash;
  return Object.entries(band)
    .map(([key, value]) => {
      const amount = typeof value === "number" ? value : null;
      if (key === "relative" && amount !== null) return `≤${hard}${percent(amount)}`;
      if (key === "absolute" && amount !== null) return `≤${hard}${quantity(amount, unit)}`;
      if (key === "order_at_least") return `order ≥${hard}${as_text(value)}`;
      if (key === "angle") return `≤${hard}${amount === null ? as_text(value) : quantity(amount, "rad")}`;
      if (key === "side") return `${as_text(value)} the reference`;
      if (key === "where") return `where ${as_text(value)}`;
      return `${words(key)} ${as_text(value)}`;
    })
    .join(", ");
}

export function error_text(error: number | null | undefined, kind: string | null | undefined, unit: string | null | undefined): string {
  if (kind === "order") return dash;
  if (kind === "relative") return percent(error);
  return quantity(error, unit, 2);
}
