// Ticks for linear and logarithmic axes.

function nice_step(span: number, wanted: number): number {
  const raw = span / wanted;
  const power = 10 ** Math.floor(Math.log10(raw));
  const factor = [1, 2, 5, 10].find((candidate) => candidate * power >= raw) ?? 10;
  return factor * power;
}

/// Round values that cover [low, high].
export function linear_ticks(low: number, high: number, wanted = 5): number[] {
  const span = high > low ? high - low : Math.abs(low) || 1;
  const step = nice_step(span, wanted);
  const first = Math.floor(low / step + 1e-9);
  const last = Math.max(Math.ceil(high / step - 1e-9), first + 1);
  return Array.from({ length: last - first + 1 }, (_, i) => Number(((first + i) * step).toPrecision(12)));
}

/// log10 of round values inside [low, high] (themselves log10): decades, and 2 and 5 between them where there are few.
export function log_ticks(low: number, high: number): number[] {
  const factors = high - low > 2.5 ? [1] : high - low > 0.9 ? [1, 2, 5] : [1, 1.5, 2, 3, 4, 5, 6, 8];
  const every = Math.max(1, Math.ceil((high - low) / 7));
  const ticks: number[] = [];
  for (let decade = Math.floor(low); decade <= Math.ceil(high); ++decade) {
    if (decade % every !== 0) continue;
    for (const factor of factors) ticks.push(decade + Math.log10(factor));
  }
  return ticks.filter((tick) => tick >= low && tick <= high);
}

/// Sorted values with those left out that would print over their neighbour.
export function spread(values: number[], least: number): number[] {
  const kept: number[] = [];
  for (const value of [...new Set(values)].sort((a, b) => a - b)) {
    if (kept.length === 0 || value - kept[kept.length - 1] >= least) kept.push(value);
  }
  return kept;
}
